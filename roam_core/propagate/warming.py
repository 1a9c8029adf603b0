"""Compiling every kernel ahead of the first track, by tracking a tiny picture; called from the worker thread."""

from __future__ import annotations

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, RoamParams
from roam_core.propagate.run import track
from roam_core.roto import Keyframe, RotoShape


def warm_up(*configs: str | RoamParams) -> None:
    """Run the given configurations (all, if none) once on two small frames; fast when the code is cached on disk."""
    pictures = np.full((2, 48, 64, 3), 40, dtype=np.uint8)
    pictures[0, 12:36, 16:40], pictures[1, 13:37, 17:41] = 200, 200
    square = RotoShape("warm-up", "warm-up", (Keyframe(0, polygon_points([(16, 12), (40, 12), (40, 36), (16, 36)])),))
    for config in configs or CONFIGS:
        for _ in track(lambda frame: pictures[frame], [square], range(2), config):
            pass
