"""Finished keys steadied, and what that did to them: how many moved, and how much their outlines boil now."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.cancel import CancelToken, Progress, half
from roam_core.geometry import bezier
from roam_core.media.source import ReadImage
from roam_core.params.steadiness import ResidualParams, SteadinessParams
from roam_core.propagate.steadiness.boil import Spot, boil
from roam_core.propagate.steadiness.steadied import steadied
from roam_core.roto import RotoShape
from roam_core.translatable import sentence


@dataclass(frozen=True, eq=False)
class Steadied:
    """What the pass made.

    Attributes
    ----------
    shapes : all shapes, as they are now.
    moved : by shape and frame of each key that moved how far its points did, in the mean; pixels.
    boil : by shape and frame how much the outline boiled before, and does now; pixels. Moved keys between
        two others alone.
    """

    shapes: Sequence[RotoShape]
    moved: Mapping[Spot, float]
    boil: Mapping[Spot, tuple[float, float]]


def steadying(
    read: ReadImage,
    shapes: Sequence[RotoShape],
    frames: range,
    strength: float,
    params: SteadinessParams,
    measure: ResidualParams,
    token: CancelToken | None = None,
    progress: Progress | None = None,
) -> Steadied:
    """The shapes as `steadied` makes them, with the boil before and after as `measure` says.

    For the boil each picture is asked for once more. Parameters and errors are those of `steadied`.
    """
    made = steadied(read, shapes, frames, strength, params, token, progress and half(progress, 0.0))
    pairs = [(old, new) for old, new in zip(shapes, made, strict=True) if new is not old]
    moved = {
        (new.id, key.frame): float(np.hypot(*(key.points - was.points)[:, 0].T).mean())
        for old, new in pairs
        for key in new.keys
        if (was := old.key_at(key.frame)) is not None and key != was
    }
    keyed = {new.id: set(new.frames) for _, new in pairs}
    counted = [(shape, frame) for shape, frame in moved if {frame - 1, frame + 1} <= keyed[shape]]
    if not counted:
        return Steadied(made, moved, {})
    looked_at = range(min(frame for _, frame in counted) - 1, max(frame for _, frame in counted) + 2)
    # Both in one pass: the motion of the picture is then the same for both.
    renamed = [replace(old, id=f"{old.id} before") for old, _ in pairs]
    found = boil(
        read, [*renamed, *(new for _, new in pairs)], looked_at, measure, token, progress and half(progress, 0.5)
    )
    return Steadied(
        made,
        moved,
        {
            spot: (found[f"{spot[0]} before", spot[1]].pixels, found[spot].pixels)
            for spot in counted
            if spot in found and (f"{spot[0]} before", spot[1]) in found
        },
    )


def told(found: Steadied) -> str:
    """What was done, in a sentence."""
    if not found.moved:
        return sentence("No tracked key could be steadied; nothing was changed.")
    keys = _counted(len(found.moved))
    if not found.boil:
        return sentence("{keys} moved; their boil could not be measured.", keys=keys)
    # By what there is of each outline: of one that is a few pixels long the measure tells nothing.
    lengths = [_length(found.shapes, spot) for spot in found.boil]
    before, after = np.average(list(found.boil.values()), axis=0, weights=lengths)
    return sentence(
        "{keys} moved; boil by the picture {before:.2f} px before, {after:.2f} px now.",
        keys=keys,
        before=before,
        after=after,
    )


def _length(shapes: Sequence[RotoShape], spot: Spot) -> float:
    """Pixels along the outline of a shape, by its id, on a frame."""
    shape = next(each for each in shapes if each.id == spot[0])
    return max(float(bezier.segment_lengths(shape.at(spot[1]).points).sum()), 1e-6)


def _counted(count: int) -> str:
    return sentence("{count} key", count=count) if count == 1 else sentence("{count} keys", count=count)
