"""Parameters of the region proposals, with a room for each step of a frame."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.between import SpanParams
from roam_core.params.confidence import ConfidenceParams
from roam_core.params.contour import ContourFitParams
from roam_core.params.evidence import (
    BackgroundParams,
    BarsParams,
    ComponentsParams,
    ExposureParams,
    LabelPropagationParams,
    LevelsParams,
    TextureParams,
)
from roam_core.params.fast_motion import FastMotionParams
from roam_core.params.figure import FigureParams
from roam_core.params.patches import PatchParams
from roam_core.params.pose import PoseParams
from roam_core.params.redetection import RedetectionParams
from roam_core.params.rigid import RigidityParams
from roam_core.params.stamped import former, later


@dataclass(frozen=True)
class RegionParams:
    """Parameters of the region proposals. Reaches are cells of the evidence grid unless said otherwise; weights are
    per nat of a log-likelihood ratio.

    Attributes
    ----------
    grid_factor : cells a pixel of a 480-line image; `least_cells`: cells across a small object, whose grid is finer.
        fill_factor : the same between two keys, where nobody waits for the next frame.
    margin : pixels of a 480-line image around the object that are looked at.
    band : cells to both sides of the expected outline in which pixels are in doubt.
    local_weight, local_radius, local_sigma, local_spread : nearest colours of the last frame, along the flow; sigma in
        Lab units, spread in Lab units squared a cell squared.
    key_weight, key_radius, key_spread : the same on the key frame, carried by the accumulated similarity.
    key_aged : the nearest colour of the last frame or of the key is taken, that of the key along the flow that is left;
        by how much more a difference counts there. 0: the last frame is asked alone, and the key where it is carried.
    global_weight : histograms of the key frame, adapted since.
    adaptation : rate of that adaptation, a frame; the same of textures.
    clip : bound on each cue, nats. bias : nats towards the outside where nothing is known.
    motion_weight, motion_sigma : background that moves with the surroundings and not with the object is not taken in;
        the weight counts in full where the object moves as one. sigma in pixels of a 480-line image.
    motion_agreed : one over this is the share of the object that must move as one for its motion to say anything; from
        twice that share on it says all that it knows.
    key_sigma : how much farther a colour of the key may be than one of the last frame, as a factor on `local_sigma`.
    prior_reach : cells of depth beyond which `prior_weight` grows no more.
    uncovered_weight : the same against what only the flow carries along: where neither the similarity nor the key
        expects the object, what moves with the surroundings is the background that it has uncovered.
    prior_weight : nats a cell of depth inside the region carried from the last frame.
    label_propagation_weight : nats of the side that a cell brings along from the key by sound flow
        (`proposal.cues.label_propagation`); 0: it is not asked. beside_label_propagation : share of the other cues that
        is heard where the flow has been sound all the way.
    keys_weight : between two keys, of what the colours of both say (`proposal.cues.key_colours`); 0: they are not
        asked.
    kept_shares : how far each component's share of an outline's length is to be the key's (1), not the last frame's
        (0).
    longest_bridge : by which components of a region hang together in one outline (`proposal.segment.components`), in
        the square root of a component's area, and slit, by which a bay that closed stays open, in that of the bay's; 0:
        each outline has one component, without holes.
    key_pull : how far points are expected to have gone back, on each frame, to where the key carried as one piece has
        them.
    key_pull_reach : pixels of a 480-line image from there at which it is half as far, for limbs swing.
    blur : Gaussian on the ratio. diffusion, contrast, sweeps : contrast-dependent smoothing (`kernels.diffusion`).
    overlap : share of a detached part that must lie where the object was expected.
    doubted : expected IoU under which the object is looked for as it was on the key (`propagate.frame.redetection`); 0:
        never.
    better : by how much more must be expected of what is found for it to be believed. believed : how much, at least.
    hopeless : expected IoU under which what is left of a region is not the object.
    rigid : share of the key's corners that must be found where the motion of a plane puts them for the object to be
        carried as one piece (`propagate.whole.rigid`); above 1: never.
    hole_own : nats by which what lies in a hole must look like the object, not like its surroundings, for the hole to
        be carried by itself (`propagate.parts.holes`).
    part : of the poses of an object drawn in parts (`propagate.parts.figure`); None: it is carried as one region.
    pose : of the pose of a lone shape, one more hypothesis (`propagate.whole.posed`); None: it is not asked.
    pose_densest_seam : share without an edge, on the key, of the stretch of the outline that has most of it
        (`motion.template`), from which it is. pose_area : square pixels of a 480-line image that the outline encloses
        at most for it to be.
        pose_edged : how unlike the key a small one that hangs on nothing may be. pose_agrees : overlap with the region
        from which it is not needed. pose_unlike : how unlike the key it may be. pose_against : how much may speak
        against it at the disputed places.
    patches : of the key's patches that are followed one by one (`motion.patches`); None: they are not asked.
    patches_inside : by how much what they say of a cell inside is taken to be surer; in full, it counts as the key's
        word. patches_outside : nats of what they say of one outside.
    background : of what the key's background says (`proposal.cues.background`); None: it is not asked.
    exposure : of how much brighter the picture has become since the key (`proposal.cues.exposure`); None: it is not
        asked.
    levels : of how a picture of little contrast is stretched (`features.levels`); None: it is seen as it is.
    bars : of black bars around the picture (`features.active_area`); None: they are taken for a part of it.
    texture : of what tells the object's texture from that of its surroundings (`appearance.texture_model`); None: it is
        not asked. texture_weight : of what it says.
    pose_steady : difference of colour to the key that a quarter of a large shape stays under for the shape to be held
        to its pose. pose_steady_seam : share of the outline of a large shape beside which nothing changes, from which
        it may be. pose_near : pixels of a 480-line image within which its patches must lie of where the pose has them.
        pose_agreed : the share of them that must.
        pose_kept : the pose of a large shape that is no longer held to it is looked for as long as anything is clearly
        as on the key: a fill may take it.
    unseen : density of a colour that the histograms never saw. trusted : steadiness below which a frame teaches them
        nothing. least_seen : share of an object that must be seen for its motion to be taken from that alone.
    whole_cells : cells, at most, after which a whole pixel begins.
    closed : radius, in pixels, to which an outline closes while the region has no place for it: it shows nothing.
    label_propagation : of what a cell brings along. components : of the region's components. contour_fit : of laying
        points along it.
    fast_motion : of where an object went that moves fast. redetection : of looking for what was lost. rigidity : of
        what is carried as one piece. figure : of an object in parts. span : of filling between two keys.
    confidence : of how far all that is trusted.
    """

    grid_factor: float = 0.5
    fill_factor: float = 2.0 / 3.0
    least_cells: float = 40.0
    margin: float = 44.0
    band: int = 10
    local_weight: float = 1.0
    local_radius: int = 5
    local_sigma: float = 2.0
    local_spread: float = 0.3
    key_weight: float = 0.5
    key_radius: int = 5
    key_spread: float = 0.1
    key_aged: float = 2.0
    global_weight: float = 0.7
    adaptation: float = 0.1
    clip: float = 3.0
    bias: float = -0.2
    motion_weight: float = 1.0
    motion_sigma: float = 1.5
    uncovered_weight: float = 3.0
    prior_weight: float = 0.05
    label_propagation_weight: float = 8.0
    beside_label_propagation: float = 0.2
    keys_weight: float = 1.0
    longest_bridge: float = 2.0
    kept_shares: float = 0.5
    key_pull: float = former("held", 0.1)
    key_pull_reach: float = former("held_within", 50.0)
    blur: float = 0.6
    diffusion: float = 2.0
    contrast: float = 12.0
    sweeps: int = 20
    overlap: float = 0.3
    doubted: float = 0.7
    better: float = 0.05
    believed: float = 0.5
    hopeless: float = later(0.1)
    rigid: float = 0.6
    pose: PoseParams | None = None
    part: PoseParams | None = None
    pose_densest_seam: float = later(0.45)
    pose_area: float = 6500.0
    pose_edged: float = 0.45
    pose_agrees: float = 0.97
    pose_unlike: float = 0.6
    pose_against: float = 0.7
    patches: PatchParams | None = None
    patches_inside: float = 3.0
    patches_outside: float = 5.0
    background: BackgroundParams | None = later(None)
    exposure: ExposureParams | None = later(None)
    levels: LevelsParams | None = later(None)
    bars: BarsParams | None = later(None)
    texture: TextureParams | None = later(None)
    texture_weight: float = later(1.0)
    pose_steady: float = later(1.4)
    pose_steady_seam: float = later(0.03)
    pose_near: float = later(2.0)
    pose_agreed: float = later(0.75)
    pose_kept: bool = later(False)
    motion_agreed: float = later(2.5)
    key_sigma: float = later(1.5)
    prior_reach: float = later(20.0)
    unseen: float = later(2e-5)
    trusted: float = later(0.3)
    least_seen: float = later(0.05)
    whole_cells: int = later(2)
    closed: float = later(0.02)
    hole_own: float = later(1.0)
    label_propagation: LabelPropagationParams = later(LabelPropagationParams())
    components: ComponentsParams = later(ComponentsParams())
    contour_fit: ContourFitParams = later(ContourFitParams(stretch=12.0))
    fast_motion: FastMotionParams = later(FastMotionParams())
    redetection: RedetectionParams = later(RedetectionParams())
    rigidity: RigidityParams = later(RigidityParams())
    figure: FigureParams = later(FigureParams())
    span: SpanParams = later(SpanParams())
    confidence: ConfidenceParams = later(ConfidenceParams())
