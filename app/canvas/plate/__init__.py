"""What lies below the shapes: the picture, the matte, the ground of a cut-out."""
