"""Tests of `app/features`."""
