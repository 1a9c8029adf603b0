"""The built-in demo shot: a manta ray over a reef, rendered by code, with its true outline known on every frame."""

from .frames import cache_name, missing_frames, write_frames
from .outline import true_points
from .shot import occlusion, render_frame, true_mask
from .timing import FIRST, LAST, SIZE

__all__ = [
    "FIRST",
    "LAST",
    "SIZE",
    "cache_name",
    "missing_frames",
    "occlusion",
    "render_frame",
    "true_mask",
    "true_points",
    "write_frames",
]
