"""RoamParams: all numbers of one configuration of the engine, one field for each symbol, a room for each step."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from roam_core.params.appearance import AppearanceParams
from roam_core.params.confidence import ConfidenceParams
from roam_core.params.contour import UNTYING, UntyingParams
from roam_core.params.evidence import BlankParams
from roam_core.params.klt import KLT, KltParams
from roam_core.params.landmarks import LandmarkParams
from roam_core.params.proposals import ProposalParams
from roam_core.params.region import RegionParams
from roam_core.params.stamped import later, values


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
    motion_travel : how far an object may move between two frames and still be found by followed points.
    gradient_margin : how far beyond the reach of the moves the gradient is looked at.
    gradient_top : percentile of the squared gradients of the region that counts as its strongest edge.
    gradient_floor : squared grey levels per pixel, the least that counts as the strongest edge of a region.
    untangling : times that loops are looked for in a round; a curve that still crosses itself then is put back.
    klt : of the followed points.
    untying : of taking crossings out of the fitted spline. confidence : of edges and motion, where there is no region.
    blank : of frames that show nothing.
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
    motion_travel: float = later(48.0)
    gradient_margin: float = later(12.0)
    gradient_top: float = later(98.0)
    gradient_floor: float = later(144.0)
    untangling: int = later(8)
    klt: KltParams = later(KLT)
    untying: UntyingParams = later(UNTYING)
    confidence: ConfidenceParams = later(ConfidenceParams())
    blank: BlankParams = later(BlankParams())

    def __hash__(self) -> int:
        return hash(self.config)

    def named(self, config: str) -> RoamParams:
        """The same numbers under another name."""
        return replace(self, config=config)

    def values(self) -> dict[str, object]:
        """All fields by name, as the stamp of an ENGINE key tells them (`params.stamped`)."""
        return values(self)


STANDARD_LINES = 480
"""Lines of the image that lengths of parameters are told for."""
MOST_ENLARGED = 2.0
"""Factor by which a picture is enlarged at most: more shows nothing more."""


def enlargement_for(size: tuple[int, int]) -> float:
    """By how much a picture of `size` (h, w) is enlarged for an engine of regions: towards `STANDARD_LINES`."""
    return min(max(1.0, STANDARD_LINES / max(min(size), 1)), MOST_ENLARGED)


def scale_for(size: tuple[int, int]) -> float:
    """How much longer lengths are in an image of `size` (h, w) than in one of 480 lines; never below 1."""
    return max(1.0, min(size) / STANDARD_LINES)
