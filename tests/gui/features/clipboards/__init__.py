"""Tests of `app/features/clipboards`."""
