"""What lies below the shapes: the picture, the matte, the background of a cut-out."""
