"""A walking figure in ten parts, rendered by code: the outline, the motion and the depth of every part are known."""

from .body import ORDER
from .shot import FIRST, LAST, SIZE, Walker, write_frames

__all__ = ["FIRST", "LAST", "ORDER", "SIZE", "Walker", "write_frames"]
