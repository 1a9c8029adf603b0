"""How steadily outlines stand: what they do from frame to frame beyond the motion of the picture beside them."""
