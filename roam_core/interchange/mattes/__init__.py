"""Mattes as pictures: files, styles, channels, time codes."""
