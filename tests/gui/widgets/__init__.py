"""Tests of `app/widgets`."""
