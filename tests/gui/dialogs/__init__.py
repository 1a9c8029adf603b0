"""Tests of `app/dialogs`."""
