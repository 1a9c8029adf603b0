"""Tests of `app/canvas/plate`."""
