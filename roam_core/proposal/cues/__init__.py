"""What the picture, the last frame and the keys say of every pixel near the object."""
