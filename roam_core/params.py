"""RoamParams: every number of the engine, one field for each symbol, and the named configurations."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from functools import lru_cache
from typing import Literal

from roam_core.dials import turned
from roam_core.errors import RoamError


@dataclass(frozen=True)
class PoseParams:
    """Parameters of the pose of a part (`motion.pose`). Lengths are pixels of a 480-line image, turns radians,
    differences of colour units of Lab (L from 0 to 100), strains natural logarithms of a stretch.

    Attributes
    ----------
    samples : places of a part that are compared with its key.
    joints : places at which a long part may bend.
    like : difference of colour at which a sample is half unlike the key, the least and the most: it follows
        `like_times` the median of what was seen. like_roughly : the least in the search from afar.
    beside, beside_at, beside_like : weight of the places beside the outline that may not look like the inside, how far
        from it they lie, and the difference of colour up to which they do.
    unseen : what a sample costs that is hidden or lies outside the picture.
    needless, needed : what a sample costs where the object is not, or another part is; what a place beside the outline
        costs where the object is and no other part. tie, tie_reach : weight of a joint, and pixels at which it gives.
    search_move, search_step, search_turn, search_turns : how far around the expected pose, in which steps, and through
        which turns in how many steps, poses are tried; looked_at, candidates : of how many of the best how many, apart
        from each other, are followed up. rounds : of the descent on each level.
    followed : of these, and of two from the last frame, how many beyond the coarsest level. sure : cost up to which
        the pose near the last one is taken without a search.
    momentum : share of the last frame's motion that is expected to go on.
    expect_move, expect_turn, expect_strain : standard deviations from what is expected; most_strain : those from the
        key (along the part, across, shear). prior : weight of all that, in units of a sample's cost.
    bend, straight : standard deviations of how a joint's angle changes in a frame, and of the angle itself.
    lost : cost from which a pose is in doubt; each further such frame widens the search, up to `widened` times.
    """

    samples: int = 600
    joints: int = 1
    like: tuple[float, float] = (5.0, 15.0)
    like_times: float = 3.0
    like_roughly: float = 10.0
    beside: float = 0.4
    beside_at: float = 4.0
    beside_like: float = 10.0
    unseen: float = 0.55
    needless: float = 0.3
    needed: float = 0.1
    tie: float = 0.1
    tie_reach: float = 8.0
    search_move: float = 24.0
    search_step: float = 4.0
    search_turn: float = 0.35
    search_turns: int = 9
    looked_at: int = 400
    candidates: int = 6
    followed: int = 6
    sure: float = 0.3
    rounds: int = 12
    momentum: float = 0.6
    expect_move: float = 10.0
    expect_turn: float = 0.16
    expect_strain: tuple[float, float, float] = (0.1, 0.07, 0.07)
    most_strain: tuple[float, float, float] = (0.25, 0.15, 0.15)
    prior: float = 0.02
    bend: float = 0.1
    straight: float = 1.0
    lost: float = 0.4
    widened: float = 2.5


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
    global_key_weight, global_weight : histograms of the key frame, and those adapted since.
    adaptation : rate of that adaptation, a frame.
    clip : bound on each cue, nats. bias : nats towards the outside where nothing is known.
    motion_weight, motion_sigma : ground that moves with the surroundings and not with the object is not taken in; the
        weight counts in full where the object moves as one. sigma in pixels of a 480-line image.
    uncovered_weight : the same against what only the flow carries along: where neither the similarity nor the key
        expects the object, what moves with the surroundings is the ground that it has uncovered.
    prior_weight : nats a cell of depth inside the region carried from the last frame.
    lineage_weight : nats of the side that a cell brings along from the key by sound flow (`proposal.lineage`); 0: it is
        not asked. beside_lineage : share of the other cues that is heard where the flow has been sound all the way.
    keys_weight : between two keys, of what the colours of both say (`proposal.key_colours`); 0: they are not asked.
    kept_shares : how far each piece's share of an outline's length is to be the key's (1), not the last frame's (0).
    longest_thread : by which pieces of a region hang together in one outline (`proposal.pieces`), in the square root of
        a piece's area; 0: each outline has one piece.
    held : how far points are expected to have gone back, on each frame, to where the key carried as one piece has them;
        half as far `held_within` pixels of a 480-line image from there, for limbs swing.
    blur : Gaussian on the ratio. diffusion, contrast, sweeps : contrast-dependent smoothing (`kernels.diffusion`).
    overlap : share of a detached part that must lie where the object was expected.
    doubted : expected IoU under which the object is looked for as it was on the key (`propagate.refinding`); 0: never.
    better : by how much more must be expected of what is found for it to be believed. believed : how much, at least.
    rigid : share of the key's corners that must be found where the motion of a plane puts them for the object to be
        carried as one piece (`propagate.rigid`); above 1: never.
    part : of the poses of an object drawn in parts (`propagate.figure`); None: it is carried as one region.
    pose : of the pose of a lone shape, one more hypothesis (`propagate.posed`); None: it is not asked. It is where
        nothing changes beside at least `pose_seam` of the outline on the key, and that encloses at most `pose_area`
        square pixels of a 480-line image. It is believed where it overlaps the region by less than `pose_agrees`, is
        less unlike the key than `pose_unlike`, and at the disputed places less than `pose_against` speaks against it.
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
    global_key_weight: float = 0.5
    global_weight: float = 0.7
    adaptation: float = 0.1
    clip: float = 3.0
    bias: float = -0.2
    motion_weight: float = 1.0
    motion_sigma: float = 1.5
    uncovered_weight: float = 3.0
    prior_weight: float = 0.05
    lineage_weight: float = 8.0
    beside_lineage: float = 0.2
    keys_weight: float = 1.0
    longest_thread: float = 2.0
    kept_shares: float = 0.5
    held: float = 0.1
    held_within: float = 50.0
    blur: float = 0.6
    diffusion: float = 2.0
    contrast: float = 12.0
    sweeps: int = 20
    overlap: float = 0.3
    doubted: float = 0.6
    better: float = 0.05
    believed: float = 0.5
    rigid: float = 0.6
    pose: PoseParams | None = None
    part: PoseParams | None = None
    pose_seam: float = 0.1
    pose_area: float = 6500.0
    pose_agrees: float = 0.97
    pose_unlike: float = 0.6
    pose_against: float = 0.7


@dataclass(frozen=True)
class AppearanceParams:
    """Parameters of the local appearance models p_n (equation 3). Lengths are pixels of a 480-line image.

    Attributes
    ----------
    local_kind : what says ln p_n^f / p_n^b. "mixture", the paper's: one model an edge. "nearest", beyond the paper: the
        nearest colours of the last frame along the flow and of the artist's key, with the parameters `cues`, of which
        those named local, key and motion, band, bias, blur, clip, margin and grid_factor are read
        (`proposal.nearest_colours`), and doubted, better and believed, on the resemblance to the key
        (`propagate.refinding.Watch`) in place of an expected IoU. "both": the mean of the two log-ratios; what one
        loses the other mostly holds.
    term : how the models enter the energy. "ribbon", the paper's: each edge's colours on both sides, up to the ribbon's
        depth, under its own model. "region": the same log-ratios ln p_n^f / p_n^b summed over all that the curve
        encloses near its old place (region competition, Zhu and Yuille 1996), so that it is drawn from farther away.
    components : Gaussians in a mixture, with diagonal covariances in Lab. density : "sum" for the mixture, "maximum"
        for its greatest component alone. variance_floor : least variance, Lab units squared.
    ribbon_depth : half width of the ribbon R_n. spread : edges to both sides whose ribbons an edge learns from too.
    clip : bound on a log-ratio, nats.
    key_share : share of the artist's key frame in every density, however long ago it was.
    adaptation : rate of the Stauffer-Grimson update, a frame of full confidence.
    trusted : confidence below which a frame teaches nothing.
    global_kind : the global model p_0 (equation 4), made where `lambda_global` is above zero: "mixture", the paper's,
        of `global_components` Gaussians a side, or "histogram", beyond the paper. global_ring : depth of the
        surroundings that it learns the background from.
    """

    local_kind: Literal["mixture", "nearest", "both"] = "mixture"
    cues: RegionParams = field(default_factory=RegionParams)
    term: Literal["ribbon", "region"] = "region"
    components: int = 3
    density: Literal["sum", "maximum"] = "maximum"
    variance_floor: float = 20.0
    ribbon_depth: float = 8.0
    spread: int = 1
    clip: float = 3.0
    key_share: float = 0.3
    adaptation: float = 0.1
    trusted: float = 0.3
    global_kind: Literal["mixture", "histogram"] = "mixture"
    global_components: int = 5
    global_ring: float = 40.0


@dataclass(frozen=True)
class LandmarkParams:
    """Parameters of the landmarks. Lengths are pixels of a 480-line image, as in `RoamParams`.

    Attributes
    ----------
    count : upper bound on M, the landmarks of one object.
    window : side of the patch that a correlation filter knows; smaller on small objects.
    target_sigma : width of the Gaussian answer that a filter is trained for.
    ridge : weight of the filter's own square in the regression, in units of the patch's mean power.
    adaptation : rate at which filters learn from an accepted frame.
    search : how far from its expected place a landmark is looked for before the pre-warp.
    reach : how far from its pre-warped place it may still move in the alternation; S = (2 reach + 1)^2.
    ambiguity : peak-to-sidelobe ratio below which a landmark is removed.
    neighbours : landmarks that each node is paired with, the nearest ones (equation 8).
    weight : of the filters' answers in equation 6, per landmark.
    star : weight of the springs of equation 7, per landmark and squared pixel.
    joint : weight of equation 9, per pair and squared pixel.
    shift_rate : share by which the shifts mu_nm follow the curve on every frame; 0 is the paper's.
    """

    count: int = 40
    window: int = 32
    target_sigma: float = 0.8
    ridge: float = 1.0
    adaptation: float = 0.1
    search: float = 20.0
    reach: float = 6.0
    ambiguity: float = 4.0
    neighbours: int = 2
    weight: float = 1.0
    star: float = 0.02
    joint: float = 0.01
    shift_rate: float = 0.0


@dataclass(frozen=True)
class ProposalParams:
    """Parameters of the proposals by graph cut. Lengths are pixels of a 480-line image, weights nats a cell.

    Attributes
    ----------
    grid_factor : cells a pixel of a 480-line image. reach : how far from the pre-warped outline cells are in doubt.
    local_weight, global_weight : of the log-ratios of the edges' models and of the global model p_0.
    prior_weight : nats a cell of depth inside, or of distance from, the pre-warped outline; beyond the paper.
    strength, contrast, neighbours : nats of smoothing between neighbours of one colour, the Lab distance over which it
        falls, and 4 or 8 neighbours.
    area, depth : cells that a difference has, and how deep it is, to be marked. most : pieces looked at on a frame.
    part : cells that a part has at least to be offered as a shape of its own.
    overlap : share of what is added that must lie near where the object was expected.
    node_price : what one node more costs, in units of the energy, when a proposal makes the curve longer.
    least_share : a proposal takes nothing away that leaves less than this share of the area that the key's region has
        by now: what passes behind a post is held, not given up. 0 lets everything go; beyond the paper, and only where
        the key is remembered (`AppearanceParams.local_kind` "nearest" or "both").
    rounds : times that a frame's curve and segmentation are compared.
    """

    grid_factor: float = 0.5
    reach: float = 20.0
    local_weight: float = 1.0
    global_weight: float = 1.0
    prior_weight: float = 0.0
    strength: float = 0.7
    contrast: float = 12.0
    neighbours: int = 8
    area: int = 12
    depth: float = 1.5
    most: int = 8
    part: int = 60
    overlap: float = 0.2
    node_price: float = 1.0
    least_share: float = 0.0
    rounds: int = 1


@dataclass(frozen=True)
class RoamParams:
    """Parameters of the engine. Lengths are pixels of a 480-line image and grow with the image (`scale_for`).

    Attributes
    ----------
    config : the name of the configuration.
    node_spacing : distance of neighbouring nodes x_n on the outline; more nodes follow finer detail and cost more.
    min_nodes, max_nodes : bounds on N; the spacing gives way to them.
    window : side of the square of moves of a node, so D = window**2; odd. The paper varies 3 to 13.
    steps : step between neighbouring moves, one entry for each round of inference, coarse to fine.
    max_iterations : rounds of dynamic programming at each step size.
    mu : weight of the l2 regulariser (equation 3), per node, of the squared edge length over the squared spacing.
    l2_rest : where that term rests: `mu |e_n - l2_rest e^_n|^2`, with e^_n the edge as the pre-warp carried it. 0, the
        paper's, draws every edge to length zero and so smooths and shrinks; 1, beyond the paper, resists only what the
        pre-warp does not explain. Between them lies the mixture: up to a constant the term is that of
        `(1 - l2_rest) mu |e_n|^2 + l2_rest mu |e_n - e^_n|^2`. Proposals, whose edges nothing carried, rest at zero.
    lambda_gradient : weight of the squared image gradient (equation 3), per node, of its mean along the edge.
    gradient_sigma : blur before the gradient is taken.
    lambda_local : weight of the local appearance term (equation 3), per node and nat: of the mean over the ribbon, or,
        for region competition, of the sum along the normal.
    lambda_global : weight of the global appearance term (equations 4, 5), per node, of its sum along the normal.
    appearance : parameters of the local appearance models; None leaves the curve without colour.
    warp : where the object went between two frames, the place that inference starts from: "none", "klt" (a similarity
        of points followed inside the outline), "flow" (a similarity of dense flow), "landmarks" (one of the landmarks:
        the paper's), "landmarks+klt" (one that both vote for) or "nodes" (each control point with the landmarks nearest
        to it: the paper's node projection).
    fit_rigidity : weight, per control point, that holds the fitted spline to the pre-warped one where nodes say little.
    motion_features : upper bound on the points that KLT follows for the pre-warp.
    motion_threshold : distance up to which a followed point agrees with a similarity.
    motion_size : the region is scaled down to this side before points are followed; costs follow it.
    landmarks : parameters of the landmarks and what ties them to the curve; None leaves the curve without landmarks.
    proposals : parameters of the proposals by graph cut; None leaves topology and parametrisation alone.
    region : parameters of region proposals on every frame; None leaves the curve to the curve's energy alone.
    """

    config: str = "baseline"
    node_spacing: float = 8.0
    min_nodes: int = 12
    max_nodes: int = 220
    window: int = 5
    steps: tuple[float, ...] = (2.0, 1.0)
    max_iterations: int = 3
    mu: float = 0.06
    l2_rest: float = 0.0
    lambda_gradient: float = 1.0
    gradient_sigma: float = 1.0
    lambda_local: float = 0.0
    lambda_global: float = 0.0
    appearance: AppearanceParams | None = None
    warp: Literal["none", "klt", "flow", "landmarks", "landmarks+klt", "nodes"] = "klt"
    fit_rigidity: float = 0.02
    motion_features: int = 300
    motion_threshold: float = 2.0
    motion_size: int = 512
    landmarks: LandmarkParams | None = None
    proposals: ProposalParams | None = None
    region: RegionParams | None = None

    def values(self) -> dict[str, object]:
        """All fields by name: what the hash of an ENGINE key covers."""
        return asdict(self)


CONFIGS: dict[str, RoamParams] = {
    "baseline": RoamParams(),
    "lean": RoamParams(config="lean", appearance=AppearanceParams(), lambda_local=0.03, mu=0.6, l2_rest=0.7),
    "medium": RoamParams(
        config="medium",
        appearance=AppearanceParams(),
        lambda_local=0.03,
        mu=0.6,
        l2_rest=0.7,
        warp="landmarks+klt",
        landmarks=LandmarkParams(),
    ),
    "full": RoamParams(
        config="full",
        appearance=AppearanceParams(
            local_kind="both",
            cues=RegionParams(
                motion_weight=0.0,
                uncovered_weight=0.0,
                lineage_weight=0.0,
                key_aged=0.0,
                doubted=0.5,
                better=0.3,
                believed=0.6,
            ),
            global_kind="histogram",
        ),
        lambda_local=0.03,
        lambda_global=0.03,
        warp="landmarks+klt",
        landmarks=LandmarkParams(),
        proposals=ProposalParams(least_share=0.7),
    ),
    "best": RoamParams(config="best", region=RegionParams(pose=PoseParams(like=(5.0, 12.0)), part=PoseParams())),
}
"""Configurations by name. `baseline`: gradient and l2 regulariser (the paper's Baseline); `lean`: local colour models
of the edges beside them (the paper's Lean, as region competition); `medium`: landmarks as well, in the pre-warp and
tied to the curve (the paper's Medium); `full`: the global colour model as well, and proposals by graph cut (the paper's
Full; p_0 as histograms, the local models with the nearest colours, what is lost is looked for again); `best`: all that
proved itself, at present the region proposals."""

DOUBTFUL = 0.75
"""Confidence below which a frame ends as LOW_CONFIDENCE and is offered as worth fixing.

Confidence is an expected IoU. Of the frames below this value in runs of twenty frames on the shared shots, six in seven
were under 0.8, where an edit pays, and they were four in five of all frames under 0.7; above it the mean was .87."""

DEFAULT_CONFIG = "best"


def params_for(config: str | RoamParams) -> RoamParams:
    """The parameters of a named configuration, with dials turned where the name says so (`best+reach=1.5`).

    A `RoamParams` is passed through.
    """
    if isinstance(config, RoamParams):
        return config
    base = CONFIGS.get(config.partition("+")[0])
    if base is None:
        raise RoamError(f"There is no configuration {config!r}; choose from {', '.join(CONFIGS)}.")
    return base if config in CONFIGS else _turned(base, config)


@lru_cache(maxsize=64)
def _turned(base: RoamParams, name: str) -> RoamParams:
    """One value for one name: who compares parameters, or keeps something by them, may go by identity."""
    params = turned(base, name)
    assert isinstance(params, RoamParams)
    return params


def scale_for(size: tuple[int, int]) -> float:
    """How much longer lengths are in an image of `size` (h, w) than in one of 480 lines; never below 1."""
    return max(1.0, min(size) / 480.0)
