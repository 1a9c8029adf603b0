"""What the colours of an artist's keys say about a frame between them, all keys asked at once.

Beyond the paper. Each cell looks for its own colour in every key, as it would look on the frame, near the place that
it came from. It is compared with the nearest colour inside of any key against the nearest outside of any: so what one
of the keys hides, or shows where the other hid it, is told by the key that knows it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.arrays import Bools, Float32, UInt8
from roam_core.kernels.local_match import log_ratio
from roam_core.params import KeyColoursParams
from roam_core.proposal.cues.key_view import KeyView, lab


def key_colours(
    picture: UInt8, views: Sequence[tuple[KeyView, float]], wanted: Bools, params: KeyColoursParams
) -> Float32:
    """ln p(inside) / p(outside) of the `wanted (rows, columns)` cells of a frame, from the nearest colours of all keys.

    `picture (rows, columns, 3)` is the frame's, RGB in the cells of the views; each comes with how far from the frame
    its key is, as a share of the span. Zero where no key has anything like it, and where none was asked.
    """
    distances, colours = [], lab(picture)
    for view, away in views:
        sides = view.nearest(picture, colours, wanted, params.radius, params.spread, "exact")
        distances.append([np.float32(1.0 + params.aged * away) * side for side in sides])
    inside, outside = np.min(distances, axis=0)
    return log_ratio(inside, outside, params.sigma, params.clip)
