"""Pure geometry on numpy arrays: polylines, cubic Bezier splines, similarity transforms.

Coordinates are `(x, y)` float64 in full-resolution pixels, the origin at the image's top-left corner, y down.
"""
