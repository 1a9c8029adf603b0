"""An object drawn in parts: each by a pose of its own, and what is free, a seam or hidden along its outline."""
