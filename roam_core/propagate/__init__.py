"""Carrying shapes through a shot: one frame (`step`), many frames (`run`), the public `Tracker`."""
