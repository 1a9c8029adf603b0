"""Tests of `app/model`."""
