"""One direction of a span: an object carried from one artist's key through all frames, on to the other key."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.features.blank import went_blank
from roam_core.geometry import bezier
from roam_core.media.source import MissingFrame
from roam_core.motion.klt import similarity_warp
from roam_core.params import RoamParams, scale_for
from roam_core.propagate.engines.protocol import Engine, Motion, UnionOfParts
from roam_core.propagate.frame.result import Part

ReadPicture = Callable[[int], PreparedFrame]


@dataclass(frozen=True, eq=False)
class Stop:
    """An object on one frame of a pass.

    Attributes
    ----------
    points : for each outline its control points `(P, 3, 2)`.
    confidence : for each outline, in [0, 1].
    carried : `(3, 3)` the similarity, image to image, of the object since the key.
    motion : how it lies otherwise.
    """

    points: tuple[Array, ...]
    confidence: tuple[float, ...]
    carried: Array
    motion: Motion

    @property
    def at_poses(self) -> tuple[Array | None, ...]:
        """For each outline its points by its pose alone; None where it is not carried by one."""
        return self.motion.at_poses or (None,) * len(self.points)

    def by_poses_alone(self, which: Sequence[bool]) -> Stop:
        """The same, those outlines `which` are true lie where their poses have them."""
        points = tuple(
            stiff if chosen and stiff is not None else drawn
            for drawn, stiff, chosen in zip(self.points, self.at_poses, which, strict=True)
        )
        return replace(self, points=points)

    @property
    def of_union(self) -> Stop | None:
        """That of the union of an object's parts; None where it has none."""
        union = self.union
        if union is None or union.motion.since_key is None:
            return None
        points = tuple(part.points for part in union.parts)
        return Stop(points, (union.trust,) * len(points), union.motion.since_key, union.motion)

    @property
    def union(self) -> UnionOfParts | None:
        """The parts of an object as one; None where it is in no parts."""
        return None if self.motion.in_parts is None else self.motion.in_parts.union

    @property
    def posed(self) -> Stop | None:
        """The same, if the pose is believed all the way; None without one."""
        by_pose = self.motion.by_pose
        if by_pose is None:
            return None
        count = len(by_pose.points)
        motion = replace(
            self.motion,
            region=None,
            of_region=(False,) * count,
            pose_costs=(by_pose.cost,) * count,
            gone=(by_pose.is_gone,) * count,
        )
        return replace(self, points=by_pose.points, confidence=(by_pose.confidence,) * count, motion=motion)


@dataclass(frozen=True, eq=False)
class DirectionalPass:
    """All stops of one direction: `stops[frame]`, the key's own among them; frames without a picture are left out.

    `picture` is the key's.
    """

    stops: dict[int, Stop]
    picture: PreparedFrame

    @property
    def posed(self) -> DirectionalPass | None:
        """The same, if the pose of the lone shape is believed all the way; None where it has none."""
        return self._all(lambda stop: stop.posed)

    @property
    def of_union(self) -> DirectionalPass | None:
        """That of the union of an object's parts; None where it has none."""
        return self._all(lambda stop: stop.of_union)

    def _all(self, of: Callable[[Stop], Stop | None]) -> DirectionalPass | None:
        """The same with what each stop gives; None where one gives nothing."""
        stops = {frame: of(stop) for frame, stop in self.stops.items()}
        known = {frame: stop for frame, stop in stops.items() if stop is not None}
        return DirectionalPass(known, self.picture) if len(known) == len(stops) else None

    @property
    def is_posed(self) -> bool:
        """Whether the pose of a lone shape is believed all the way."""
        motions = [stop.motion for stop in self.stops.values()]
        return all(motion.by_pose is not None and not any(motion.of_region) for motion in motions)

    def by_poses_alone(self, which: Sequence[bool]) -> DirectionalPass:
        """The same, those outlines `which` are true lie where their poses have them."""
        return replace(self, stops={frame: stop.by_poses_alone(which) for frame, stop in self.stops.items()})

    def at(self, frame: int) -> Stop | None:
        """The stop on a frame, or None where the picture is missing."""
        return self.stops.get(frame)


def directional_pass(
    engine: Engine,
    parts: Sequence[Part],
    read: ReadPicture,
    orders: Callable[[int], Sequence[int]],
    frames: Sequence[int],
    params: RoamParams,
    token: CancelToken | None = None,
    passed: Callable[[], None] | None = None,
) -> DirectionalPass:
    """Carry the `parts` of an object, begun on `frames[0]`, through the other frames in their order.

    Those that are missing, or show nothing, are passed over.

    `orders` tells how they are stacked on a frame (`propagate.shapes.objects`). `passed` is called after each frame,
    whether it was passed over or not.
    """
    key = picture = engine.frame
    carried = np.eye(3)
    points, sure = tuple(part.points for part in parts), (1.0,) * len(parts)
    stops = {frames[0]: Stop(points, sure, carried, engine.motion)}
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            following, step = read(frame), None
            if not went_blank(following, picture, points, params.blank):
                step = engine.step(following, orders(frame), token)
                since_key = step.after.motion.since_key
                moved = since_key if since_key is not None else _moved(picture, following, points, params) @ carried
        except MissingFrame:  # where its file is damaged may show only when it is read there
            step = None
        if step is not None:
            engine, motion, carried, picture = step.after, step.after.motion, moved, following
            points = tuple(result.points for result in step.results)
            confidence = tuple(result.confidence for result in step.results)
            stops[frame] = Stop(points, confidence, carried, motion)
        if passed is not None:
            passed()
    return DirectionalPass(stops, key)


def _moved(before: PreparedFrame, after: PreparedFrame, points: tuple[Array, ...], params: RoamParams) -> Array:
    """The similarity `(3, 3)` of the largest outline from one frame to the next."""
    lines = [bezier.flatten(each) for each in points]
    largest = max(lines, key=lambda line: float(np.prod(np.ptp(line, axis=0))))
    warp = similarity_warp(before, after, largest, params, scale_for(before.size))
    return np.vstack([warp.transform, [0.0, 0.0, 1.0]])
