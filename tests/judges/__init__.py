"""Judges of files that ROAM writes: readers and renderers which share no code with its writers."""
