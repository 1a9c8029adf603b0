"""Sequences of masks as curves: parts, nodes that are followed, points for all frames, fits, few keys."""
