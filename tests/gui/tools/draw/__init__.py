"""Tests of `app/tools/draw`."""
