"""Judges of what leaves the program: readers and renderers that share no code with its writers."""
