"""Painters of what is drawn on the plate: shapes, ghosts, confidence, joints, proposals."""
