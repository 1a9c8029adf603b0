"""The proposed region: the cut, what belongs to the object, and to which shape each component belongs."""
