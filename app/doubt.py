"""Doubt: the confidence under which the window shows a frame or a vertex as worth fixing."""

DOUBTFUL = 0.5
