"""Tests of `app/tools/edit`."""
