"""The engines behind one face: the paper's curves one by one, regions of a whole object, an object in parts."""
