"""Drastic changes proposed by a segmentation: evidence, the proposed region, and the curve fitted to its outline."""
