"""Where the object went between two frames: the pre-warp that inference starts from."""
