"""A shape's own points laid along an outline, in correspondence."""
