"""Tests of `app/canvas/items`."""
