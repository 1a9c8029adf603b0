"""Between two keys: an object carried from either key to the other, and the two passes merged."""
