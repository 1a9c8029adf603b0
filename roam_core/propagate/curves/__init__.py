"""The paper's curves, one by one: a frame's pre-warp, its landmarks, its inference, outlines proposed anew."""
