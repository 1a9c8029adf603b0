"""A light that lies over a part of the picture: a shadow, or what is out of one.

People walk under trees, cars under bridges: the line of a shadow crosses the object, and no factor tells of it. That
there is such a part, and how much darker it is, the background tells (`exposure.Light.shades`). Where it is, all tell
that know what the picture should look like: the key's background and its object, and the last frame.
"""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from roam_core.arrays import Bools, Float32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.params.evidence import ShadowParams
from roam_core.proposal.cues.exposure import Light


def relit(
    frame: PreparedFrame, light: Light, grid: Grid, expected: Sequence[tuple[UInt8, Bools]], params: ShadowParams
) -> PreparedFrame | None:
    """A frame, as it was given, with what lies in a shadow in the light of all else; None where nothing does.

    A cell lies in the light in which those around it, and it, are most like what is `expected` there: the nearest of
    several pictures `(rows, columns, 3)`, RGB in the light of the key, where they say anything `(rows, columns)`.
    """
    size = (params.window, params.window)
    apart = [
        cv2.blur(_apart(grid.colours_of(each.removed(frame)), expected, params), size)
        for each in (light, *light.in_parts)
    ]
    chosen = np.argmin(apart, axis=0)
    if not chosen.any():
        return None
    changes = np.log(np.array([1.0, *light.shades], np.float32))[chosen]
    return frame.divided(np.exp(cv2.GaussianBlur(changes, (0, 0), params.edge)), grid.region)


def _apart(picture: UInt8, expected: Sequence[tuple[UInt8, Bools]], params: ShadowParams) -> Float32:
    """How unlike what is expected each cell is `(rows, columns)`: the least of the differences, averaged over 3 x 3."""
    least = np.full(picture.shape[:2], params.unlike, np.float32)
    for other, says in expected:
        difference = cv2.blur(cv2.absdiff(picture, other).mean(axis=2, dtype=np.float32), (3, 3))
        least = np.where(says, np.minimum(least, difference), least)
    return least
