"""Blender: a script that makes masks, and a node group that joins them."""
