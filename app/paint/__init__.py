"""What canvas and tools both paint with: marks, the viewport, the paths of outlines."""
