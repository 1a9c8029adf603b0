"""Whether a gap is filled: whether each of its frames has a key that filling would only make again, or is bridged."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RoamParams
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import RotoShape


def is_filled(
    stamps: Stamps,
    shape: RotoShape,
    gap: tuple[int, int],
    params: RoamParams,
    bridges: Callable[[int], bool],
    *,
    alone: bool = False,
) -> bool:
    """Whether filling the gap between two artist keys of a shape would change nothing.

    `bridges(frame)` tells whether a frame without a key is one that a fill passes over (`is_bridged`). It is asked only
    where there are keys of a fill around it: of a gap that is not filled no picture is looked at.
    """
    keys = {frame: shape.key_at(frame) for frame in range(gap[0] + 1, gap[1]) if shape.exists_at(frame)}
    made = [key for key in keys.values() if key is not None]
    if not keys or not made or not all(stamps.is_filled(shape, key, gap, params, alone) for key in made):
        return not keys
    return all(bridges(frame) for frame, key in keys.items() if key is None)


def is_bridged(read: ReadFrame, shape: RotoShape, params: RoamParams, frame: int) -> bool:
    """Whether the engine passes over a frame inside a gap: it has no picture, or one that shows nothing.

    It says so of the picture as it lies in the plate. Shots of little contrast are looked at with more: there the
    engine may see something where this sees nothing.
    """
    try:
        return is_blank(PreparedFrame(read(frame)), [shape.at(frame).points], params.blank)
    except MissingFrame:
        return True
