"""EdgeModels: the local appearance models p_n of equation 3, one mixture inside and one outside for every edge."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.appearance import gmm
from roam_core.appearance.band import Band
from roam_core.appearance.gmm import Mixtures, Samples
from roam_core.appearance.update import adapted
from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame
from roam_core.params import AppearanceParams


@dataclass(frozen=True, eq=False)
class EdgeModels:
    """p_n = (p_n^f, p_n^b) of all edges, in Lab: as adapted so far, and as learned on the artist's key.

    The artist's key is never forgotten: it keeps the share `AppearanceParams.key_share` of every density. The models
    belong to the edges by their index, which the nodes' fixed places on the spline keep through time.
    """

    inside: Mixtures
    outside: Mixtures
    key_inside: Mixtures
    key_outside: Mixtures

    @classmethod
    def learned(cls, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float) -> EdgeModels:
        """From the ribbons R_n^in and R_n^out of a frame whose outline `nodes (N, 2)` is given."""
        sides = ribbon_samples(frame, nodes, params, scale)
        inside, outside = (gmm.learned(side, params.components, params.variance_floor, params.spread) for side in sides)
        inside, outside = gmm.known_on_both_sides(inside, outside)
        return cls(inside, outside, inside, outside)

    def adapted(
        self, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float, confidence: float
    ) -> EdgeModels:
        """After an accepted frame with the outline `nodes (N, 2)`: moved towards its ribbons, the more the surer."""
        sides = ribbon_samples(frame, nodes, params, scale)
        rate = params.adaptation * confidence
        inside, outside = (
            adapted(model, side, rate, params, params.spread)
            for model, side in zip((self.inside, self.outside), sides, strict=True)
        )
        return replace(self, inside=inside, outside=outside)

    def log_densities(self, band: Band, params: AppearanceParams) -> tuple[Float32, Float32]:
        """ln p_n^f and ln p_n^b `(rows, columns)` of the cells of a band; `gmm.FLOOR` outside it.

        Each cell is asked under the model of its nearest edge - the edge's ribbon, widened by the moves that the nodes
        may make - so that a frame's densities are made once, for any curve in the band.
        """
        share = params.key_share
        inside, outside = self.inside.joined(self.key_inside, share), self.outside.joined(self.key_outside, share)
        return (
            inside.log_density(band.colours, band.edge, params.density),
            outside.log_density(band.colours, band.edge, params.density),
        )


def ribbon_samples(
    frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float
) -> tuple[Samples, Samples]:
    """The colours of R_n^in and of R_n^out for every edge: pixels by their nearest edge, up to the ribbon's depth.

    A pixel on the far side of a thin part belongs to the edge over there, not to the ribbon of this one.
    """
    band = Band.around(frame, nodes, params.ribbon_depth, scale)
    usable = band.near & (band.distance >= params.edge_blur)
    inside, outside = (
        Samples.of(band.colours[side].astype(np.float64), band.edge[side], len(nodes))
        for side in (usable & band.inside, usable & ~band.inside)
    )
    return inside, outside
