"""Tests of `app/features/verbs`."""
