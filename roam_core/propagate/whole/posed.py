"""One more hypothesis for an object drawn as one shape: it lies there as on its key, only moved, turned and bent.

Where the region and the pose (`motion.pose`) differ, the picture is asked at the disputed places. A limb, whose outline
runs where nothing changes, is so held together by its pose; an object that changes what it looks like by its region.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from roam_core.arrays import Array
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import bezier, plane_motion, projective
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.kernels.coverage import coverage
from roam_core.motion.flow import dense_flow
from roam_core.motion.pose import Pose, Surroundings
from roam_core.motion.template import Template
from roam_core.params import ConfidenceParams, FreeEdgesParams, PoseParams, RegionParams, scale_for
from roam_core.propagate.frame.confidence import PoseFeatures, expected_overlap, overlap, vertex_confidence
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.free_edges import Border, drawn_to
from roam_core.propagate.frame.result import Part, StepResult, Termination
from roam_core.proposal.cues.evidence import Field


def on_key(
    frame: PreparedFrame, parts: Sequence[Part], params: RegionParams, covers: Sequence[Array] = ()
) -> Pose | None:
    """The pose of an object's one solid shape on its key; None where there are more, or too little of it is seen.

    `covers` are closed polylines `(K, 2)` of what lies before it.
    """
    solid = [part for part in parts if not part.subtracts]
    if params.pose is None or len(solid) != 1:
        return None
    holes = [bezier.flatten(part.points) for part in parts if part.subtracts]
    return learned(frame, bezier.flatten(solid[0].points), params.pose, [*holes, *covers])


def learned(frame: PreparedFrame, line: Array, params: PoseParams, covers: Sequence[Array]) -> Pose | None:
    """The pose, on its key, of what a closed polyline `line (K, 2)` encloses and nothing covers."""
    scale = scale_for(frame.size)
    window = Region.around(line, params.margin * scale, frame.size)
    if is_narrow(window, params):
        return None
    template = Template.of(Pyramid.of(frame, window, 1.0 / scale, params.pyramid), line, params, scale, covers)
    return None if template is None else Pose.on_key(template, params)


def step(
    pose: Pose,
    drawn: Sequence[Part],
    before: PreparedFrame,
    frame: PreparedFrame,
    params: RegionParams,
    covers: Sequence[Array] = (),
) -> Pose:
    """The pose on the next frame of the object that was `drawn` on the key; `before` is the frame before."""
    assert params.pose is not None
    search, scale = params.pose, scale_for(frame.size)
    spots = np.vstack([pose.carried(bezier.flatten(part.points)) for part in drawn])
    window = Region.around(spots, (search.margin + search.search_move * pose.reach(search)) * scale, frame.size)
    if is_narrow(window, search):
        return pose.missed()
    pyramid = Pyramid.of(frame, window, 1.0 / scale, search.pyramid)

    def drift(places: Array) -> Array:
        return _moved(before, frame, window, places, scale, search.along)

    hidden, is_limb = pyramid.outlined(list(covers)), may_be_limb(pose, params)
    return pose.step(Surroundings(pyramid, hidden, is_complete=False, is_sought=is_limb, drift=drift), search)


def _moved(
    before: PreparedFrame, frame: PreparedFrame, window: Region, places: Array, scale: float, along: int
) -> Array:
    """By how much `(2,)` what lies at `places (N, 2)` and around them moved: the median of the flow there."""
    grid = Grid.over(window, 1.0 / scale)
    low, high = np.floor(grid.to_grid(np.stack([places.min(axis=0), places.max(axis=0)]))).astype(np.intp)
    (left, top), (right, below) = np.maximum(low - along, 0), np.maximum(high + along + 1, 0)
    flow = dense_flow(before, frame, grid)[0][top:below, left:right]
    if flow.size == 0:
        return np.zeros(2)
    return np.asarray(np.median(flow.reshape(-1, 2), axis=0) / grid.factor, dtype=np.float64)


def is_narrow(window: Region, params: PoseParams) -> bool:
    """Whether a part of a picture is too narrow to see anything in it."""
    return min(window.x1 - window.x0, window.y1 - window.y0) < params.narrow


def carried(pose: Pose, drawn: Sequence[Part]) -> tuple[Part, ...]:
    """The parts of the key under a pose."""
    return tuple(Part(pose.spline(part.points), part.subtracts) for part in drawn)


def is_believable(pose: Pose, params: RegionParams) -> bool:
    """Whether a lone shape may be a part: a small one, one stretch of its outline without an edge.

    One that hangs on nothing is taken for a whole object, but where it still looks as on its key. A large one is.
    """
    if may_be_limb(pose, params):
        return True
    return pose.look is not None and is_small(pose, params) and pose.unlike < params.pose_edged


def may_be_limb(pose: Pose, params: RegionParams) -> bool:
    """Whether a lone shape is small, and one stretch of its outline, where it hangs on, without an edge."""
    return pose.template.densest_seam >= params.pose_densest_seam and is_small(pose, params)


def is_steady(pose: Pose, params: RegionParams) -> bool:
    """Whether a large shape, part of its outline without an edge, still looks as on its key.

    What a limb before it covers may be unlike the key: a quarter of it that is seen tells.
    """
    return (
        pose.look is not None
        and not is_small(pose, params)
        and pose.template.seam >= params.pose_steady_seam
        and pose.look.closest < params.pose_steady
    )


def is_clear(pose: Pose, params: RegionParams) -> bool:
    """Whether what was seen of a shape within the last frames looked clearly as on its key."""
    return params.pose is not None and pose.unclear < params.pose.recent


def is_small(pose: Pose, params: RegionParams) -> bool:
    """Whether a lone shape is small enough for a limb."""
    return pose.template.area <= params.pose_area * pose.template.scale**2


def is_believed(pose: Pose, parts: Sequence[Part], found: Field, params: RegionParams, was_posed: bool) -> bool:
    """Whether the pose, which puts the shapes at `parts`, is taken where the region that was `found` disputes it.

    It is where the object may be a part, still looks as on its key, and what is seen at the disputed places does not
    speak against it. A limb that was carried by its pose the frame before (`was_posed`) is held to it: what hides it
    is no change of its shape.
    """
    is_limb = was_posed and may_be_limb(pose, params)
    if is_limb and pose.is_gone:
        return True
    if pose.look is None or not is_believable(pose, params) or pose.unlike >= params.pose_unlike:
        return False
    if is_limb:
        return True
    if overlap(enclosed(parts, found.grid) > 0.5, found.inside) >= params.pose_agrees:
        return False
    rows, columns = found.grid.shape
    x, y = np.floor(found.grid.to_grid(pose.look.places)).astype(np.intp).T
    inside = found.inside[np.clip(y, 0, rows - 1), np.clip(x, 0, columns - 1)]
    return pose.look.against(inside) < params.pose_against


def continued(pose: Pose, parts: Sequence[Part], found: Field, size: tuple[int, int], params: RegionParams) -> Field:
    """The region of an object of which more is in the picture than its key, of `size` (h, w), shows.

    What may be a limb, looks as on the key and is disputed by the region lies by its pose, which puts it at `parts`,
    where the key shows it, and as it was `found` beyond the edge of the key's picture.
    """
    if pose.look is None or not may_be_limb(pose, params) or pose.unlike >= params.pose_unlike:
        return found
    known = pose.template.levels[0].places
    motion = plane_motion.fit(PlaneMotion.AFFINE, known, pose.carried(known))
    if motion is None:
        return found
    height, width = size
    edge = projective.apply(motion, np.array([[0.0, 0.0], [width, 0.0], [width, height], [0.0, height]]))
    is_shown = coverage(found.grid.to_grid(edge), found.grid.shape) > 0.5
    under_pose = Field.of_coverage(found.grid, enclosed(parts, found.grid))
    both = Field(found.grid, np.where(is_shown, under_pose.values, found.values))
    return found if overlap(both.inside, found.inside) >= params.pose_agrees else both


def trust(pose: Pose, params: ConfidenceParams) -> float:
    """The IoU with the artist's wish, in [0, 1], to be expected of a pose."""
    return expected_overlap(PoseFeatures.of(pose), params=params)


def results(pose: Pose, parts: Sequence[Part], params: ConfidenceParams) -> tuple[StepResult, ...]:
    """What a pose that puts the outlines at `parts` gives for each of them, trusted as far as its looks allow."""
    confidence = trust(pose, params)
    return tuple(
        StepResult(
            points=part.points,
            confidence=confidence,
            vertex_confidence=vertex_confidence(pose.support(part.points[:, bezier.ANCHOR]), confidence, params),
            energies={"pose": pose.cost, "total": pose.cost},
            termination=Termination.of(confidence),
        )
        for part in parts
    )


def at_the_edges(parts: Sequence[Part], found: Field, scale: float, params: FreeEdgesParams) -> tuple[Part, ...]:
    """The parts of an object of one shape with their free edges where the region that was `found` ends."""
    border, nothing = Border(found, found.grid, scale, params), np.zeros(found.grid.shape, np.uint8)
    return tuple(replace(part, points=drawn_to(border, part.points, nothing)) for part in parts)
