"""Reviewing as jobs."""
