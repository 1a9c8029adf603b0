"""What is seen on a frame of an object that is carried by regions, before anything is decided."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, similarity
from roam_core.motion.fast import fast_displacement, with_fast_flow
from roam_core.motion.flow import carried_by_flow, dense_flow, flow_similarity, on_grid
from roam_core.motion.patches import PatchMotion
from roam_core.params import FastMotionParams, RegionParams, scale_for
from roam_core.propagate.frame.covering import visible
from roam_core.propagate.frame.redetection import Behind, area_of, carried_area
from roam_core.propagate.whole import patched
from roam_core.propagate.whole.interest import box_of, corners, grid_around
from roam_core.propagate.whole.rigid import PlanePose, Rigidity
from roam_core.propagate.whole.state import RegionState
from roam_core.proposal.cues.background import correction
from roam_core.proposal.cues.evidence import Expectation, KeyMemory, Sources
from roam_core.proposal.cues.exposure import light_since
from roam_core.proposal.cues.key_view import KeyView, lab
from roam_core.proposal.cues.label_propagation import label_propagation
from roam_core.proposal.cues.motion_cue import MotionMisfit
from roam_core.proposal.cues.shadow import relit
from roam_core.threads import beside


@dataclass(frozen=True, eq=False)
class Observation:
    """What is seen on a frame before anything is decided on it.

    Attributes
    ----------
    frame : the picture, as it would be in the light of the key. sources : what the cues are drawn from; they know the
        key, carried on to the frame.
    moved : (3, 3) similarity by which the object went as a whole. agreement : how much of it did, in [0, 1].
    rigidity : whether it may still move as one piece. plane_pose : where it lies so, if that is to be seen.
    patch_motion : where its patches lie.
    """

    frame: PreparedFrame
    sources: Sources
    moved: Array
    agreement: float
    rigidity: Rigidity
    plane_pose: PlanePose | None
    patch_motion: PatchMotion | None = None


def observed(
    state: RegionState,
    frame: PreparedFrame,
    params: RegionParams,
    token: CancelToken | None = None,
    surroundings: Array | None = None,
    is_relit: bool = False,
) -> Observation | None:
    """Where the object should be on `frame`, and what may be asked about it; None where it has left the picture.

    So has one of which the key shows nothing: there is nothing to know it by.

    Parameters
    ----------
    surroundings : (3, 3) the motion of the key's to `frame`, where it is known already.
    is_relit : what lies in a shadow was brought into the light. Where it was not, and there is one, all is seen anew.
    """
    if not state.key.region.inside.any():
        return None
    scale = scale_for(frame.size)
    spots = np.vstack([corners(state.region), *(part.points[:, bezier.ANCHOR] for part in state.parts)])
    displacement = _displacement(state, frame, spots, params.fast_motion)
    near = grid_around(spots, frame.size, params, scale, displacement)
    grid = grid_around(spots, frame.size, params, scale, displacement, _mostly_hidden(state, params))
    if min(grid.shape) < 4:
        return None
    fine = Grid.over(grid.region, 1.0 / scale)
    flows = dense_flow(state.frame, frame, fine, params.label_propagation_weight > 0, near.region)
    everywhere = state.region.on(fine) > 0.5
    inside = visible(everywhere, state.covers, fine, params.least_seen)
    if displacement is not None:
        flows = with_fast_flow(state.frame, frame, fine, flows, inside, displacement, params.fast_motion)
    forth, back = (on_grid(flow, fine, grid) for flow in flows)
    moved, agreement = flow_similarity(flows[0], inside, fine)
    if token is not None:
        token.check()
    around, _ = flow_similarity(flows[0], ~everywhere, fine)
    misfit = MotionMisfit.on(grid, back, moved, around, params.motion_sigma * scale)
    if surroundings is not None:
        around = surroundings @ np.linalg.inv(state.key.surroundings)
    key = replace(state.key.with_surroundings_moved(around), to_now=moved @ state.key.to_now)
    last = state.region.on(grid)
    expected = Expectation(
        last,
        state.region.continued_on(grid, moved, frame.size) > 0.5,
        carried_by_flow(last, back, is_continued=True) > 0.5,
        key.region.on(grid, key.to_now),
        misfit.left_behind(agreement, params),
    )
    key, view = _drawn_to(frame, key, expected.possible, grid, params)
    if key.light.shades and not is_relit:
        again = _relit(state, frame, key, view, (moved, back), expected, params)
        if again is not None:
            return observed(state, again, params, token, surroundings, is_relit=True)
    frame = key.in_its_light(frame)
    as_one_piece = beside(lambda: state.rigidity.step(frame, moved, params.rigid))
    pictures = grid.colours_of(state.frame), grid.colours_of(frame)
    lines = sides = None
    patch_motion = state.patch_motion
    if params.label_propagation_weight > 0:
        before = carried_by_flow(state.region.nats_on(fine), flows[1], is_continued=True)
        # What lay beyond the last grid lay outside of the object: there the flow has been as sound as on the key.
        unreliable = grid.warped(np.float32(1.0) - state.flow_reliability, state.region.grid.map_to_image)
        reliable = np.float32(1.0) - unreliable
        lines = label_propagation(pictures, before, (forth, back), reliable, grid, frame.size, params.label_propagation)
    rigidity, plane_pose = as_one_piece()
    if state.patches is not None and patch_motion is not None:
        patch_motion, sides = patched.step(state.patches, patch_motion, frame, (fine, flows[0]), grid, params)
    background = key.behind_it(view) if params.background is not None else None
    sources = Sources(
        *pictures, grid, expected, back, key, state.colours, misfit.told(agreement, params), params.band, lines,
        sides, background, state.texture,
    )  # fmt: skip
    return Observation(frame, sources, moved, agreement, rigidity, plane_pose, patch_motion)


def _mostly_hidden(state: RegionState, params: RegionParams) -> Array | None:
    """The corners `(4, 2)` of the box of the object, carried from the key, where most of it is hidden; else None.

    So of one that its colours tell where it comes out: a limb has lookalikes.
    """
    if not state.is_told_by_colours or area_of(state.region) >= params.redetection.whole * carried_area(state.key):
        return None
    return similarity.apply(state.key.to_now[:2], box_of(state.key.region))


def _drawn_to(
    frame: PreparedFrame, key: KeyMemory, possible: Bools, grid: Grid, params: RegionParams
) -> tuple[KeyMemory, KeyView]:
    """A key that was carried to `frame`, with the motion of its surroundings and its light as they are seen there.

    And it as it looks there, carried by that motion. `possible (rows, columns)`: where the object may be.
    """
    if params.background is not None:
        drawn = correction(key.behind(grid), key.later, grid.grey_of(frame), possible, params.background)
        key = key.with_surroundings_moved(drawn)
    view = key.behind(grid)
    if params.exposure is not None:
        key = replace(key, light=light_since(view, frame, possible, key.light, params.exposure))
    return key, view


def _relit(
    state: RegionState,
    frame: PreparedFrame,
    key: KeyMemory,
    view: KeyView,
    motion: tuple[Array, Float32],
    expected: Expectation,
    params: RegionParams,
) -> PreparedFrame | None:
    """A frame with what lies in a shadow in the light of all else; None where nothing does.

    `motion`: the similarity `(3, 3)` by which the object went, and the flow back `(rows, columns, 2)`.
    """
    assert params.exposure is not None
    grid, (moved, back) = view.grid, motion
    everywhere = np.ones(grid.shape, np.bool_)
    pictures = (
        (view.seen, view.in_sight & (view.coverage < params.exposure.beside)),
        (KeyView(key.frame, key.to_now, grid, expected.remembered).seen, expected.remembered > 0.5),
        (carried_by_flow(grid.colours_of(state.frame), back, is_continued=True), everywhere),
        (grid.warped(state.frame.image, moved), everywhere),
    )
    return relit(frame, key.light, grid, pictures, params.exposure.shadow)


def _displacement(state: RegionState, frame: PreparedFrame, spots: Array, params: FastMotionParams) -> Array | None:
    """Pixels `(2,)` by which the object with these corners `(N, 2)` went to `frame`; None of one that is slow."""
    scale = scale_for(frame.size)
    cell = max(round(scale / params.factor), 1)  # of whole pixels: these are averaged several times as fast
    area = Region.around(spots, params.window * scale, frame.size).in_wholes(cell, frame.size)
    if area.is_empty:
        return None
    grid = Grid.over(area, 1.0 / cell)
    return fast_displacement(state.frame, frame, grid, state.region.on(grid) > 0.5, scale, params)


def behind(key: KeyMemory, frame: PreparedFrame, params: RegionParams) -> Behind | None:
    """What the key's background says of any cells of a frame to which its surroundings were followed already."""
    asked = params.background
    if asked is None:
        return None

    def told(grid: Grid) -> Float32:
        return key.background(grid).log_ratio(lab(grid.colours_of(frame)), np.ones(grid.shape, bool), asked)

    return told
