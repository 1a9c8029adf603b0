"""Copying and pasting shapes, keys and the nodes of other programs."""
