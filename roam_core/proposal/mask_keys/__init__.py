"""Artist keys fitted to a mask: which shape became which part of it, and its points on the new outline."""
