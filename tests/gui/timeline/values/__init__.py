"""Tests of `app/timeline/keys`."""
