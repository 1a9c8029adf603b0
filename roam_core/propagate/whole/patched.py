"""Patches of a whole object, followed from its key: where they have its inside, and the points of its shapes."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, similarity
from roam_core.motion.patches import Levels, Patches, PatchMotion
from roam_core.motion.pose import Pose
from roam_core.params import RegionParams, scale_for
from roam_core.propagate.frame.covering import visible
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.cues.patch_sides import PatchSides
from roam_core.proposal.outline.contour import KeyConstraints


def learned(frame: PreparedFrame, region: Field, covers: Sequence[Array], params: RegionParams) -> Patches | None:
    """The patches of an object on its key, where its region is and nothing `covers` it; None where they are not asked.

    `covers`: closed polylines `(K, 2)`.
    """
    if params.patches is None:
        return None
    scale = scale_for(frame.size)
    fine = Grid.over(region.grid.region, 1.0 / scale)
    inside = region.on(fine) > 0.5
    seen = visible(inside, covers, fine, params.least_seen)
    return Patches.learned(frame, inside, seen, fine, scale, params.patches)


def step(
    patches: Patches,
    motion: PatchMotion,
    frame: PreparedFrame,
    flow: tuple[Grid, Float32],
    grid: Grid,
    params: RegionParams,
) -> tuple[PatchMotion, PatchSides]:
    """Where the patches lie on the next frame, and on which side they have the cells of `grid`.

    `flow`: a grid of about a pixel of a 480-line image over the same region, and the flow from the last frame in it.
    """
    now = Levels.of(frame, flow[0], patches.params)
    moved = patches.step(motion, now, *flow)
    return moved, PatchSides.of(patches, moved, now, grid, params.patches_inside)


def judged(patches: Patches | None, motion: PatchMotion | None, found: Field) -> PatchMotion | None:
    """Their motion once the object's region was `found`."""
    return motion if patches is None or motion is None else patches.judged(motion, found.inside, found.grid)


def expected_points(
    part: Part,
    drawn: Part,
    constraints: KeyConstraints,
    to_now: Array,
    patches: Patches | None,
    motion: PatchMotion | None,
    params: RegionParams,
    scale: float,
) -> Array:
    """Where the points `(P, 3, 2)` of a shape that was carried on from the last frame are expected.

    They are drawn a little towards where the key lies as a whole, carried by `to_now (3, 3)`, for what they slide by
    from frame to frame would add up otherwise; and to where the patches about them have them, as surely as those do.
    """
    way = similarity.apply(to_now[:2], drawn.points) - part.points
    length = np.hypot(*way[:, bezier.ANCHOR].T) / (params.key_pull_reach * scale)
    points = part.points + (params.key_pull / (1.0 + length**2))[:, None, None] * way
    if patches is not None and motion is not None:
        there, sure = patches.carried_points(motion, drawn.points)
        points = points + np.minimum(params.patches_inside * sure, 1.0)[:, None, None] * (there - points)
    return bezier.aligned(points, constraints.smooth)


def go_with(pose: Pose, patches: Patches | None, motion: PatchMotion | None, params: RegionParams) -> bool:
    """Whether most of an object's patches, each as far as it is believed, lie where its one `pose` has them.

    Those of a figure with limbs do not, though its torso still looks as on the key.
    """
    if patches is None or motion is None:
        return True
    away = np.hypot(*(pose.carried(patches.templates.centres) - motion.affines[:, :2]).T)
    believed = patches.weights(motion)
    return bool(believed[away < params.pose_near * patches.scale].sum() >= params.pose_agreed * believed.sum())
