"""The feather curve of a key as programs take it that know one width a point."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry.bezier import ANCHOR
from roam_core.roto import Keyframe


def feather_radii(key: Keyframe, closed: bool) -> Array:
    """How far the feather curve lies from each anchor `(P,)`, pixels: outside of the outline positive.

    The outside is told by the polygon of the anchors; on an open path it is the right-hand side on the screen.
    """
    if key.feather is None:
        return np.zeros(len(key.points))
    anchor, offset = key.points[:, ANCHOR], key.feather[:, ANCHOR]
    ahead, behind = np.roll(anchor, -1, axis=0), np.roll(anchor, 1, axis=0)
    if not closed:
        ahead[-1], behind[0] = anchor[-1], anchor[0]
    along = ahead - behind
    area = float((anchor[:, 0] * ahead[:, 1] - ahead[:, 0] * anchor[:, 1]).sum())
    side = along[:, 1] * offset[:, 0] - along[:, 0] * offset[:, 1]
    if closed and area < 0.0:
        side = -side
    lengths: Array = np.hypot(offset[:, 0], offset[:, 1])
    return np.where(side < 0.0, -lengths, lengths)
