"""One direction of a span: an object carried from one artist's key through all frames, on to the other key."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.media.source import MissingFrame
from roam_core.motion.klt import similarity_warp
from roam_core.params import RoamParams, scale_for
from roam_core.propagate import engine
from roam_core.propagate.engine import State
from roam_core.propagate.objects import Unit
from roam_core.propagate.result import Part
from roam_core.proposal.evidence import Field

Array = NDArray[np.float64]
ReadPicture = Callable[[int], PreparedFrame]


@dataclass(frozen=True, eq=False)
class Stop:
    """An object on one frame of a passage.

    Attributes
    ----------
    points : for each outline its control points `(P, 3, 2)`.
    confidence : for each outline, in [0, 1].
    carried : `(3, 3)` the similarity, image to image, of the object since the key.
    region : the object's region, where the engine works with regions. of_region : which outlines are laid along it.
    as_one_piece : the outlines are as they are on the key, only moved (`propagate.rigid`).
    pose_costs : for each outline what its pose costs; None where it was not laid by its pose alone.
    by_pose : of a lone shape the outlines by its pose, taken or not, and what that costs (`posed.is_believable`).
    """

    points: tuple[Array, ...]
    confidence: tuple[float, ...]
    carried: Array
    region: Field | None
    of_region: tuple[bool, ...]
    as_one_piece: bool = False
    pose_costs: tuple[float | None, ...] = ()
    by_pose: tuple[tuple[Array, ...], float] | None = None

    @property
    def posed(self) -> Stop | None:
        """The same, if the pose is believed all the way."""
        if self.by_pose is None:
            return None
        points, cost = self.by_pose
        count = len(points)
        return replace(self, points=points, region=None, of_region=(False,) * count, pose_costs=(cost,) * count)


@dataclass(frozen=True, eq=False)
class Passage:
    """All stops of one direction: `stops[frame]`, the key's own among them; frames without a picture are left out.

    `picture` is the key's.
    """

    stops: dict[int, Stop]
    picture: PreparedFrame

    @property
    def posed(self) -> Passage | None:
        """The same, if the pose of the lone shape is believed all the way; None where it has none."""
        stops = {frame: stop.posed for frame, stop in self.stops.items()}
        known = {frame: stop for frame, stop in stops.items() if stop is not None}
        return Passage(known, self.picture) if len(known) == len(stops) else None

    def at(self, frame: int) -> Stop | None:
        """The stop on a frame, or None where the picture is missing."""
        return self.stops.get(frame)


def passage(
    read: ReadPicture,
    parts: Sequence[Part],
    made: Sequence[Unit],
    orders: Callable[[int], Sequence[int]],
    frames: Sequence[int],
    params: RoamParams,
    token: CancelToken | None = None,
    passed: Callable[[], None] | None = None,
) -> Passage:
    """Carry `parts` from `frames[0]`, where they are given, through the other frames in their order.

    `made` tells what they are in their object, `orders` how they are stacked on a frame (`propagate.objects`). `passed`
    is called after each frame.
    """
    key = picture = read(frames[0])
    state = engine.begin(picture, tuple(parts), params, made, orders(frames[0]))
    carried = np.eye(3)
    points, sure = tuple(part.points for part in parts), (1.0,) * len(parts)
    stops = {frames[0]: _stop(state, points, sure, carried, params)}
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            following = read(frame)
        except MissingFrame:
            continue
        before, standing = picture, tuple(stops.values())[-1].points
        state, results = engine.step(state, following, params, token, orders(frame))
        region, _ = engine.as_region(state)
        if region is None:
            carried = _moved(before, following, standing, params) @ carried
        else:
            carried = region.key.to_now
        picture = following
        points = tuple(result.points for result in results)
        confidence = tuple(result.confidence for result in results)
        stops[frame] = _stop(state, points, confidence, carried, params)
        if passed is not None:
            passed()
    return Passage(stops, key)


def _stop(
    state: State, points: tuple[Array, ...], confidence: tuple[float, ...], carried: Array, params: RoamParams
) -> Stop:
    region, of_region = engine.as_region(state)
    return Stop(
        points,
        confidence,
        carried,
        None if region is None else region.region,
        of_region,
        region is not None and region.agreement_as_one_piece is not None,
        engine.pose_costs(state),
        engine.by_pose(state, params),
    )


def _moved(before: PreparedFrame, after: PreparedFrame, points: tuple[Array, ...], params: RoamParams) -> Array:
    """The similarity `(3, 3)` of the largest outline from one frame to the next."""
    lines = [bezier.flatten(each) for each in points]
    largest = max(lines, key=lambda line: float(np.prod(np.ptp(line, axis=0))))
    warp = similarity_warp(before, after, largest, params, scale_for(before.size))
    return np.vstack([warp.transform, [0.0, 0.0, 1.0]])
