"""What helps to draw: the object in a box or under a click, like colours grown, paths along edges."""
