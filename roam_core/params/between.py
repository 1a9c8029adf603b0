"""Parameters of filling between two keys."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.evidence import KeyColoursParams
from roam_core.params.stamped import later
from roam_core.params.steadiness import STEADINESS


@dataclass(frozen=True)
class EndpointConsistencyParams:
    """Parameters of how far each pass missed the other key (`propagate.between.endpoint_consistency`).

    Attributes
    ----------
    reach : pixels of a 480-line image around a place over which its residuals are averaged.
    lenient : what a lone shape's pose may miss the keys by, against the region: what it says between them is
        steadier.
    dear : mean cost from which a lone shape's poses are not taken: it does not look as on its keys. Where one costs
        less and comes elsewhere than to the other key, it has followed another thing.
    look : pixels of a 480-line image around the outlines that are compared.
    """

    reach: float = 10.0
    lenient: float = 1.3
    dear: float = 0.5
    look: float = 24.0


@dataclass(frozen=True)
class SpanParams:
    """Parameters of merging two passes (`propagate.between.merge`).

    Attributes
    ----------
    sure_of : pixels of a 480-line image by which even an estimate that met the other key may be wrong between.
    planar : weight of planar motion in the middle of a span, against one pass.
    slope : nats that planar motion gives a pixel of depth inside its region.
    depth : pixels of a 480-line image beyond which depth counts no more.
    beside : cells around those on which the passes disagree in which the picture is asked, too.
    disputed : share of what the estimates say that counts where the passes disagree.
    agreed : overlap of two passes that each moved the object as one piece from which they are taken at their
        word.
    apart_by : distance of the two passes of an outline, in its own size, from which their mean is a place of
        neither.
    alike : pixels of a 480-line image, in the mean, up to which the poses from both ends are taken for the same
        one.
    sure_cost : what is added to the cost of a pose: even the best may be wrong.
    sure_share : share of the region that even parts that lie along with the union are taken to miss.
    unposed : what an outline that was not carried by its pose is taken to cost. arrived : overlap with the other key
        from which a pass by poses has come to it. likely : confidence from which a pose is believed.
    apart : pixels of a 480-line image between the estimates of a point at which half the trust in it is gone.
    places : places along two outlines by which they are laid on each other.
    steadiness : strength, in [0, 1], by which what was merged is drawn to the motion of the picture
        (`propagate.steadiness.steadied`).
    endpoint_consistency : of what both passes are believed by. key_colours : of what the colours of both keys say.
    """

    sure_of: float = 0.5
    planar: float = 1.0
    slope: float = 2.0
    depth: float = 40.0
    beside: int = 2
    disputed: float = 0.5
    agreed: float = 0.85
    apart_by: float = 0.5
    alike: float = 8.0
    sure_cost: float = 0.1
    unposed: float = 0.4
    arrived: float = 0.6
    likely: float = 0.5
    apart: float = 4.0
    places: int = later(64)
    sure_share: float = later(0.01)
    steadiness: float = later(STEADINESS.strength)
    endpoint_consistency: EndpointConsistencyParams = later(EndpointConsistencyParams())
    key_colours: KeyColoursParams = later(KeyColoursParams())
