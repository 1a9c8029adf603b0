"""What the object and its surroundings look like: models learned on the key frame and adapted online."""
