"""What is known of an object that is carried by regions, after each frame."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from roam_core.appearance.global_model import GlobalModel
from roam_core.appearance.texture_model import TextureModel
from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid
from roam_core.features.texture import texture
from roam_core.geometry import bezier
from roam_core.motion.patches import Patches, PatchMotion
from roam_core.motion.pose import Pose
from roam_core.params import RegionParams, TextureParams, scale_for
from roam_core.propagate.frame.confidence import ConfidenceFeatures, PoseFeatures, expected_overlap
from roam_core.propagate.frame.contour_fit import enclosed
from roam_core.propagate.frame.covering import learned_colours, sure_sides
from roam_core.propagate.frame.nodes import smooth_points
from roam_core.propagate.frame.redetection import AppearanceTemplate, LastSeen, area_of, middle_of
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole import patched, posed
from roam_core.propagate.whole.interest import grid_around
from roam_core.propagate.whole.rigid import Rigidity
from roam_core.proposal.cues.evidence import Field, KeyMemory
from roam_core.proposal.cues.key_view import lab
from roam_core.proposal.outline.contour import KeyConstraints


@dataclass(frozen=True, eq=False)
class RegionState:
    """After a frame: its picture, the region, each shape where it was last seen, and what is known of the object.

    `drawn` are the shapes on the key and `constraints` what they keep of it, `appearance` what the object looked like
    there, `last_seen` tells when it was last whole, `rigidity` whether it may still move as one piece;
    `flow_reliability`, on the region's grid, how far each cell's side still is the key's word
    (`proposal.cues.label_propagation`); `steps` counts the frames since the key; `features` tell how well the last of
    them went. `pose` is that of an object drawn as one shape; `covers` are closed polylines `(K, 2)` of what lies
    before the object; `params` those that it began with. `patches` are what was learned of small pieces of the object
    on its key, `patch_motion` where they lie; `is_steady`: a large shape looked as on its key all the time. `texture`
    tells the object's texture from that of its surroundings.
    """

    frame: PreparedFrame
    region: Field
    parts: tuple[Part, ...]
    constraints: tuple[KeyConstraints, ...]
    key: KeyMemory
    colours: GlobalModel
    drawn: tuple[Part, ...]
    appearance: AppearanceTemplate
    last_seen: LastSeen
    rigidity: Rigidity
    flow_reliability: Float32
    params: RegionParams
    steps: int = 0
    features: ConfidenceFeatures | PoseFeatures | None = None
    pose: Pose | None = None
    covers: tuple[Array, ...] = ()
    patches: Patches | None = None
    patch_motion: PatchMotion | None = None
    is_steady: bool = True
    texture: TextureModel | None = None

    @property
    def trust(self) -> float:
        """The IoU to be expected of the last frame; 0 where the object was lost on it."""
        if self.features is None or self.is_lost:
            return 0.0
        return expected_overlap(self.features, params=self.params.confidence)

    @property
    def is_lost(self) -> bool:
        """Whether nothing of the object was seen on the last frame."""
        return self.last_seen.since > 0

    @property
    def is_posed(self) -> bool:
        """Whether the outlines of the last frame were carried by the pose."""
        return isinstance(self.features, PoseFeatures)

    @property
    def is_told_by_colours(self) -> bool:
        """Whether the object's colours tell it from its surroundings, and no pose holds it: then it is known again."""
        return self.appearance.is_distinct and not self.is_posed

    @cached_property
    def resemblance(self) -> float:
        """How much the region and what lies around it look as on the key, in [0, 1]; 1 where that tells nothing.

        A region that holds background or leaves some of the object out may be as sure as a good one: flow led it there.
        The frame is seen in the light of the key, out of shadows.
        """
        if not self.is_told_by_colours or self.is_lost:
            return 1.0
        return self.appearance.resemblance_of(self.frame, self.region)

    @property
    def agreement_as_one_piece(self) -> float | None:
        """The share of the key's corners that agreed, where the last frame was carried as one piece; else None."""
        return (
            1.0 - self.features.disagreeing
            if isinstance(self.features, ConfidenceFeatures) and self.rigidity.held
            else None
        )


def knowing(state: RegionState, other: RegionState) -> RegionState:
    """A state on its key that knows the textures of `other`, the same object on another key, as well as its own."""
    if state.texture is None:
        return state
    seen = _texture_on(other.frame, other.region.grid, state.texture.params)
    return replace(state, texture=state.texture.on_both(seen, *sure_sides(other.region, other.covers)))


def _texture_on(frame: PreparedFrame, grid: Grid, params: TextureParams) -> Float32:
    """The texture `(F, rows, columns)` around the cells of a grid."""
    return texture(lab(grid.colours_of(frame)), params)


def begin(
    frame: PreparedFrame, parts: tuple[Part, ...], params: RegionParams, covers: Sequence[Array] = ()
) -> RegionState:
    """The state on a frame whose outlines are given: they enclose the region, and the models are learned from it.

    From what `covers` it, closed polylines `(K, 2)`, nothing is learned.
    """
    scale = scale_for(frame.size)
    grid = grid_around(np.vstack([part.points.reshape(-1, 2) for part in parts]), frame.size, params, scale)
    region = Field.of_coverage(grid, enclosed(parts, grid))
    colours = learned_colours(grid.colours_of(frame), region, covers)
    model = None
    if params.texture is not None:
        seen = _texture_on(frame, grid, params.texture)
        model = TextureModel.learned(seen, *sure_sides(region, covers), params.texture)
    holes = [bezier.flatten(part.points) for part in parts if part.subtracts]
    key = KeyMemory(frame, region, colours, np.eye(3), np.eye(3), (*covers, *holes))
    fit, kept = params.contour_fit, params.kept_shares
    constraints = tuple(KeyConstraints.of(part.points, smooth_points(part.points), fit, scale, kept) for part in parts)
    last_seen = LastSeen(key.to_now, area_of(region), middle_of(region), params.redetection)
    rigidity = Rigidity.learned(frame, parts, params.rigidity)
    appearance, flow_reliability = (
        AppearanceTemplate(frame, region, params.redetection, params.unseen),
        np.ones(grid.shape, np.float32),
    )
    patches = patched.learned(frame, region, covers, params)
    return RegionState(
        frame, region, parts, constraints, key, colours, parts, appearance, last_seen, rigidity, flow_reliability,
        params, pose=posed.on_key(frame, parts, params, covers), covers=tuple(covers), patches=patches,
        patch_motion=None if patches is None else patches.on_key, texture=model,
    )  # fmt: skip
