"""Landmarks: filters, detection, pool, star."""
