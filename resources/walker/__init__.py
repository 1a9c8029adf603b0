"""A walking figure in ten parts, rendered by code: the outline, the motion and the depth of every part are known."""

from resources.walker.body import ORDER
from resources.walker.shot import FIRST, LAST, SIZE, Walker, write_frames

__all__ = ["FIRST", "LAST", "ORDER", "SIZE", "Walker", "write_frames"]
