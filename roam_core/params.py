"""RoamParams: every number of the engine, one field for each symbol, and the named configurations."""

from __future__ import annotations

from dataclasses import asdict, dataclass

from roam_core.errors import RoamError


@dataclass(frozen=True)
class RegionParams:
    """Parameters of the region proposals. Reaches are cells of the evidence grid unless said otherwise; weights are
    per nat of a log-likelihood ratio.

    Attributes
    ----------
    grid_factor : cells a pixel of a 480-line image; `least_cells`: cells across a small object, whose grid is finer.
    margin : pixels of a 480-line image around the object that are looked at.
    band : cells to both sides of the expected outline in which pixels are in doubt.
    local_weight, local_radius, local_sigma, local_spread : nearest colours of the last frame, along the flow; sigma in
        Lab units, spread in Lab units squared a cell squared.
    key_weight, key_radius, key_spread : the same on the key frame, carried by the accumulated similarity.
    global_key_weight, global_weight : histograms of the key frame, and those adapted since.
    adaptation : rate of that adaptation, a frame.
    clip : bound on each cue, nats. bias : nats towards the outside where nothing is known.
    motion_weight, motion_sigma : ground that moves with the surroundings and not with the object is not taken in; the
        weight counts in full where the object moves as one. sigma in pixels of a 480-line image.
    prior_weight : nats a cell of depth inside the region carried from the last frame.
    blur : Gaussian on the ratio. diffusion, contrast, sweeps : contrast-dependent smoothing (`kernels.diffusion`).
    overlap : share of a detached part that must lie where the object was expected.
    """

    grid_factor: float = 0.5
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
    global_key_weight: float = 0.5
    global_weight: float = 0.7
    adaptation: float = 0.1
    clip: float = 3.0
    bias: float = -0.2
    motion_weight: float = 1.0
    motion_sigma: float = 1.5
    prior_weight: float = 0.05
    blur: float = 0.6
    diffusion: float = 2.0
    contrast: float = 12.0
    sweeps: int = 20
    overlap: float = 0.3


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
    lambda_gradient : weight of the squared image gradient (equation 3), per node, of its mean along the edge.
    gradient_sigma : blur before the gradient is taken.
    fit_rigidity : weight, per control point, that holds the fitted spline to the pre-warped one where nodes say little.
    motion_features : upper bound on the points that KLT follows for the pre-warp.
    motion_threshold : distance up to which a followed point agrees with a similarity.
    motion_size : the region is scaled down to this side before points are followed; costs follow it.
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
    lambda_gradient: float = 1.0
    gradient_sigma: float = 1.0
    fit_rigidity: float = 0.02
    motion_features: int = 300
    motion_threshold: float = 2.0
    motion_size: int = 512
    region: RegionParams | None = None

    def values(self) -> dict[str, object]:
        """All fields by name: what the hash of an ENGINE key covers."""
        return asdict(self)


CONFIGS: dict[str, RoamParams] = {
    "baseline": RoamParams(),
    "best": RoamParams(config="best", region=RegionParams()),
}
"""Configurations by name. `baseline`: gradient and l2 regulariser (the paper's Baseline); `best`: all that proved
itself, at present the region proposals."""

DOUBTFUL = 0.5
"""Confidence below which a frame ends as LOW_CONFIDENCE and is offered as worth fixing."""

DEFAULT_CONFIG = "best"


def params_for(config: str | RoamParams) -> RoamParams:
    """The parameters of a named configuration; a `RoamParams` is passed through."""
    if isinstance(config, RoamParams):
        return config
    try:
        return CONFIGS[config]
    except KeyError:
        raise RoamError(f"There is no configuration {config!r}; choose from {', '.join(CONFIGS)}.") from None


def scale_for(size: tuple[int, int]) -> float:
    """How much longer lengths are in an image of `size` (h, w) than in one of 480 lines; never below 1."""
    return max(1.0, min(size) / 480.0)
