"""Parameters of the colour models of an edge, and of the whole object."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from roam_core.params.region import RegionParams
from roam_core.params.stamped import later


@dataclass(frozen=True)
class AppearanceParams:
    """Parameters of the local appearance models p_n (equation 3). Lengths are pixels of a 480-line image.

    Attributes
    ----------
    local_kind : what says ln p_n^f / p_n^b. "mixture", the paper's: one model an edge. "nearest", beyond the paper: the
        nearest colours of the last frame along the flow and of the artist's key (`proposal.cues.nearest_colours`).
        "both": the mean of the two log-ratios; what one loses the other mostly holds.
    cues : of the nearest colours; of them those named local, key and motion, band, bias, blur, clip, margin and
        grid_factor are read, and doubted, better, believed and redetection, on the resemblance to the key
        (`propagate.frame.redetection.Watch`) in place of an expected IoU.
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
        or "histogram", beyond the paper. global_components : Gaussians of that mixture, a side.
    global_ring : depth of the surroundings that it learns the background from.
    ribbon_step : cells between the samples of the ribbon, across it and along it.
    edge_blur : cells on both sides of the outline whose colours are mixed from both, and teach nothing.
    matched : standard deviations within which a colour matches a component (`appearance.update`).
    new_variance : least variance, Lab units squared, of a component that is put in for colours that matched none.
    replaced : share of an edge's colours that must match no component before one is given up for them.
    global_samples : colours of one side that the global mixture is learned from; of more, every so-manieth is taken.
    global_steps : steps of expectation maximisation of the global mixture.
    unseen : density of a colour that the global histograms never saw.
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
    ribbon_step: float = later(2.0)
    edge_blur: float = later(0.7)
    matched: float = later(2.5)
    new_variance: float = later(100.0)
    replaced: float = later(0.2)
    global_samples: int = later(6000)
    global_steps: int = later(15)
    unseen: float = later(2e-5)
