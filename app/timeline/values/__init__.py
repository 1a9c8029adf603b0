"""Keys of values that vary with time: which are chosen, what is done to them, and a row for each such value."""
