"""Nuke: scripts with Roto nodes out and in, a Python script, tracks and landmarks."""
