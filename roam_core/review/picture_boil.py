"""Boil by the picture: what outlines do beyond the motion of the plate beside them, as shapes bend that move."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken, Progress
from roam_core.media.source import ReadImage
from roam_core.params.steadiness import RESIDUAL
from roam_core.propagate.steadiness.boil import boil as boil_beside_picture
from roam_core.review.boil import triples
from roam_core.roto import RotoShape


def boil_by_picture(
    read: ReadImage,
    shapes: Sequence[RotoShape],
    token: CancelToken | None = None,
    progress: Progress | None = None,
) -> Mapping[str, Array]:
    """By id of each shape its boil as `roam_core.review.boil.boil` gives it, measured by the motion of the picture.

    The frames are those that count there; shapes without area, and frames beside one that the plate lacks, have none.
    The picture's motion is read by dense flow, which is itself a third of a pixel off where nothing hides the outline.

    Parameters
    ----------
    read : gives working pictures; raises `MissingFrame`. token, progress : asked before, and told of, every frame.
    """
    wanted = {shape.id: {keys[1].frame for keys in triples(shape)} for shape in shapes}
    frames = sorted(set().union(*wanted.values())) if wanted else []
    if not frames:
        return {shape.id: np.empty((0, 2)) for shape in shapes}
    asked = [shape for shape in shapes if wanted[shape.id]]
    found = boil_beside_picture(read, asked, range(frames[0] - 1, frames[-1] + 2), RESIDUAL, token, progress)
    return {
        shape.id: np.array(
            [(at, found[shape.id, at].pixels) for at in sorted(wanted[shape.id]) if (shape.id, at) in found]
        ).reshape(-1, 2)
        for shape in shapes
    }
