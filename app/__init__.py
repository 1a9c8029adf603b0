"""The window of ROAM: PySide6 in front of `roam_core`, and no mathematics."""
