"""A whole object carried by its region, as one rigid piece, or by its pose."""
