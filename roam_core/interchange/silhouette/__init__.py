"""Silhouette: shape files out, shape files and projects in."""
