"""Tests of `app/panels/bars`."""
