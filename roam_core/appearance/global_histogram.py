"""GlobalHistogram: the global model p_0 of equation 4 as histograms; beyond the paper, whose p_0 is a mixture.

Histograms follow colours that a handful of Gaussians run together, and cost a look-up each.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.appearance.band import Band
from roam_core.appearance.global_model import GlobalModel
from roam_core.arrays import Array, Float32
from roam_core.features import PreparedFrame
from roam_core.params import AppearanceParams


@dataclass(frozen=True, eq=False)
class GlobalHistogram:
    """p_0 in RGB bins: as adapted so far (`now`), and as learned on the artist's key, which keeps its share."""

    now: GlobalModel
    key: GlobalModel

    @classmethod
    def learned(cls, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float) -> GlobalHistogram:
        """From R and its surroundings on a frame whose outline `nodes (N, 2)` is given."""
        model = _seen(frame, nodes, params, scale)
        return cls(model, model)

    def adapted(
        self, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float, confidence: float
    ) -> GlobalHistogram:
        """After an accepted frame with the outline `nodes (N, 2)`: moved towards its colours, the more the surer."""
        seen = _seen(frame, nodes, params, scale)
        return replace(self, now=self.now.adapted(seen, params.adaptation * confidence))

    def log_ratio(self, band: Band, params: AppearanceParams) -> Float32:
        """ln p_0^f / p_0^b `(rows, columns)` of the cells of a band, clipped to `params.clip`; 0 outside it."""
        now, key = (model.log_ratio(band.picture, params.clip, params.unseen) for model in (self.now, self.key))
        share = np.float32(params.key_share)
        return np.asarray(np.where(band.near, (1 - share) * now + share * key, np.float32(0.0)), dtype=np.float32)


def _seen(frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float) -> GlobalModel:
    band = Band.around(frame, nodes, params.global_ring, scale)
    return GlobalModel.learned(band.picture, band.inside, band.near & ~band.inside)
