"""Tests of `app/paint`."""
