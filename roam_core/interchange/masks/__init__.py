"""Masks of other programs as curves: parts, nodes that are followed, points for all frames, fits, few keys."""
