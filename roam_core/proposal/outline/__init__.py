"""A shape's own points fitted to an outline, in correspondence."""
