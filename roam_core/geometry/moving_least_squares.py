"""Places carried along with known ones about them: moving least squares.

Around each place one similarity is fitted to what is known, the nearer the more (Schaefer, McPhail and Warren, Image
deformation using moving least squares, SIGGRAPH 2006). So what lies on a known place goes with it, and what lies
between some goes smoothly with them.
"""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array


def carried(places: Array, sources: Array, targets: Array, weights: Array, near: float) -> Array:
    """`places (N, 2)`, carried as `sources (K, 2)` were to `targets (K, 2)`; all in pixels.

    `weights (K,)` tell how much each is heard. One that is `near` pixels away is heard a quarter of one that lies
    there, and from there on less with the fourth power of its distance. At least two sources lie apart.
    """
    away = ((places[:, None] - sources) ** 2).sum(axis=-1)
    heard = weights / (1.0 + away / near**2) ** 2
    heard /= heard.sum(axis=1, keepdims=True)
    middles, moved = heard @ sources, heard @ targets
    # As complex numbers a similarity is z -> alpha z + beta.
    from_middle = _complex(sources) - _complex(middles)[:, None]
    to_middle = _complex(targets) - _complex(moved)[:, None]
    turned = (heard * from_middle.conj() * to_middle).sum(axis=1)
    alpha = turned / (heard * np.abs(from_middle) ** 2).sum(axis=1)
    found = _complex(moved) + alpha * (_complex(places) - _complex(middles))
    return np.stack([found.real, found.imag], axis=1)


def _complex(places: Array) -> np.ndarray:
    return places[..., 0] + 1j * places[..., 1]
