"""How much outlines boil: what each does on a frame that neither the frame before nor the one after does with it."""

from __future__ import annotations

from collections import OrderedDict
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken, Progress
from roam_core.features import PreparedFrame
from roam_core.geometry.polyline import following
from roam_core.media.source import MissingFrame, ReadImage
from roam_core.params import scale_for
from roam_core.params.steadiness import ResidualParams
from roam_core.propagate.steadiness.residual import Flows, Places, residual
from roam_core.roto import BlendMode, RotoShape
from roam_core.translatable import sentence

Spot = tuple[str, int]
"""The id of a shape, and a frame."""


@dataclass(frozen=True, eq=False)
class Boil:
    """How much one outline boils on one frame.

    Attributes
    ----------
    pixels : the mean of `across` without its sign, along the outline: below a half a pixel nobody sees it.
    places : (N, 2) along the outline. across : (N,) how far each lies outside of where its neighbours in time have it.
    """

    pixels: float
    places: Array
    across: Array


def boil(
    read: ReadImage,
    shapes: Sequence[RotoShape],
    frames: range,
    params: ResidualParams,
    token: CancelToken | None = None,
    progress: Progress | None = None,
) -> dict[Spot, Boil]:
    """How much each of the shapes boils on each of the frames that has one before and one after it in `frames`.

    The outlines of both neighbours are carried to the frame by the motion of the picture beside them; what lies between
    the outline and the middle of the two is neither motion of the object nor a drift of the flow. Open shapes, shapes
    without area, frames where a shape is not there, and those beside a picture that `read` has not, are left out.

    Parameters
    ----------
    read : gives a frame's picture (h, w, 3) RGB, uint8, or floats in [0, 1]; each is asked for once, in order.
    shapes : in plate space. frames : in steps of one.

    Raises
    ------
    Cancelled
        between two frames after `token` was cancelled.
    """
    closed = [shape for shape in shapes if shape.closed and shape.point_count > 1]
    found: dict[Spot, Boil] = {}
    pictures: OrderedDict[int, PreparedFrame] = OrderedDict()
    arrived: dict[str, tuple[Places, Array]] = {}
    for done, frame in enumerate(frames):
        if token is not None:
            token.check()
        if progress is not None:
            progress(done / len(frames), sentence("Looking at frame {frame}", frame=frame))
        try:
            pictures[frame] = PreparedFrame(read(frame))
        except MissingFrame:
            pictures.clear()
        while len(pictures) > 2:
            pictures.popitem(last=False)
        if len(pictures) < 2:
            arrived.clear()
            continue
        arrived, before = _between(pictures, closed, arrived, params), arrived
        for shape in closed:
            if shape.id in before and shape.id in arrived:
                middle = frame - frames.step
                places, came = before[shape.id]
                found[shape.id, middle] = _boil(shape, middle, places, 0.5 * (came - arrived[shape.id][1]))
    return found


def _between(
    pictures: OrderedDict[int, PreparedFrame],
    shapes: Sequence[RotoShape],
    arrived: dict[str, tuple[Places, Array]],
    params: ResidualParams,
) -> dict[str, tuple[Places, Array]]:
    """By shape its places and what it does between two frames beyond the motion of the picture."""
    (first, before), (last, after) = pictures.items()
    there = [shape for shape in shapes if shape.exists_at(first) and shape.exists_at(last)]
    outlines = {shape.id: (shape.at(first).points, shape.at(last).points) for shape in there}
    scale = scale_for(before.size)
    flows = None
    if outlines and before.size == after.size:
        flows = Flows.of(before, after, [points for pair in outlines.values() for points in pair], params, scale)
    if flows is None:
        return {}
    found = {}
    for shape in there:
        places = arrived[shape.id][0] if shape.id in arrived else Places.of(outlines[shape.id][0], params, scale)
        subtracts = shape.blend is BlendMode.SUBTRACT
        found[shape.id] = places, residual(flows, *outlines[shape.id], places, params, scale, subtracts=subtracts)
    return found


def _boil(shape: RotoShape, frame: int, places: Places, across: Array) -> Boil:
    """Each place counts with its share of the outline."""
    positions, _ = places.on(shape.at(frame).points)
    lengths = np.hypot(*(following(positions) - positions).T)
    shares = lengths + np.roll(lengths, 1)
    pixels = float((np.abs(across) * shares).sum() / max(float(shares.sum()), np.finfo(np.float32).tiny))
    return Boil(pixels, positions, across)
