"""Mattes of several shapes joined into one, layer by layer, by their blend modes."""

from __future__ import annotations

from collections.abc import Callable, Iterable

import numpy as np
from numpy.typing import NDArray

from roam_core.matte.rasterise import has_area, shape_matte
from roam_core.roto import BlendMode, Layer, Project, RotoShape

Matte = NDArray[np.float32]


def _add(under: Matte, matte: Matte) -> Matte:
    total: Matte = np.minimum(under + matte, np.float32(1.0))
    return total


def _subtract(under: Matte, matte: Matte) -> Matte:
    return under * (np.float32(1.0) - matte)


def _intersect(under: Matte, matte: Matte) -> Matte:
    return under * matte


def _difference(under: Matte, matte: Matte) -> Matte:
    apart: Matte = np.abs(under - matte)
    return apart


def _max(under: Matte, matte: Matte) -> Matte:
    greater: Matte = np.maximum(under, matte)
    return greater


BLENDS: dict[BlendMode, Callable[[Matte, Matte], Matte]] = {
    BlendMode.ADD: _add,
    BlendMode.SUBTRACT: _subtract,
    BlendMode.INTERSECT: _intersect,
    BlendMode.DIFFERENCE: _difference,
    BlendMode.MAX: _max,
}
"""What a matte makes of what lies under it in its layer: `blend(under, matte) -> (h, w)` in [0, 1]."""


def render_matte(shapes: Project | Layer | Iterable[RotoShape], frame: float, size: tuple[int, int]) -> Matte:
    """The joint matte of shapes at one frame.

    Shapes are joined bottom first. A layer is joined inside itself, then inverted, then scaled by its opacity, and
    added to what lies under it; a project is its root layer. What is invisible takes no part, and neither does a shape
    that is open or outside its lifetime: it does not count as an empty one, which under INTERSECT would wipe out what
    lies under it.

    Parameters
    ----------
    shapes : a project, a layer, or shapes in the order of compositing.
    frame : the plate's frame number.
    size : (h, w) of the image.

    Returns
    -------
    (h, w) float32 in [0, 1].
    """
    if isinstance(shapes, Project):
        shapes = shapes.root
    if isinstance(shapes, Layer):
        return _layer_matte(shapes, frame, size) if shapes.visible else np.zeros(size, dtype=np.float32)
    return _join(shapes, frame, size)


def _layer_matte(layer: Layer, frame: float, size: tuple[int, int]) -> Matte:
    matte = _join(layer.children, frame, size)
    if layer.invert:
        matte = np.float32(1.0) - matte
    return matte if layer.opacity == 1.0 else matte * np.float32(layer.opacity)


def _join(items: Iterable[Layer | RotoShape], frame: float, size: tuple[int, int]) -> Matte:
    matte: Matte = np.zeros(size, dtype=np.float32)
    for item in items:
        if not item.visible:
            continue
        if isinstance(item, Layer):
            matte = _add(matte, _layer_matte(item, frame, size))
        elif has_area(item, frame):
            matte = BLENDS[item.blend](matte, shape_matte(item, frame, size))
    return matte
