"""The planar peer: the planar tracker's own corners and RANSAC from frame to frame, accumulated."""

from __future__ import annotations

import cv2
import numpy as np

from benchmarks.methods.method import Array, MovingPoints
from benchmarks.shots import Shot
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion, ransac
from roam_core.motion.planar import corners_in, followed, inside
from roam_core.params import PLANAR

AGREE = 2.0
"""Pixels by which a corner may disagree: generous, for most of the objects are no planes."""


class Planar(MovingPoints):
    """All outlines move as one plane does, in the way of Mocha: `kind` is similarity, affine or homography."""

    def __init__(self, kind: str) -> None:
        self.kind = PlaneMotion(kind)
        self.name = f"planar, {kind}"

    def moved(self, shot: Shot, outlines: list[Array], before: int, after: int) -> list[Array]:
        """See `MovingPoints.moved`."""
        old, new = (
            np.asarray(cv2.cvtColor(shot.read(frame), cv2.COLOR_RGB2GRAY), dtype=np.uint8) for frame in (before, after)
        )
        source, target = followed(old, new, corners_in(old, inside(outlines, (), shot.size)))
        motion = None
        if len(source) >= PLANAR.enough * self.kind.pairs:
            motion, _ = ransac(self.kind, source, target, AGREE)
        if motion is None:
            return outlines  # with fewer corners the object is taken to stand still
        far = PLANAR.far * max(shot.size)
        moved = [projective.apply(motion, points) for points in outlines]
        # A homography can throw points through the horizon; an artist would not follow it there.
        return moved if all(np.abs(points).max() < far for points in moved) else outlines
