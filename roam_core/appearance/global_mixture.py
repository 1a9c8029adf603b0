"""GlobalMixture: the global appearance model p_0 of equation 4, one mixture for the object and one for the rest.

`appearance.global_model` holds the same model as histograms, which are dearer to keep and cheaper to ask.
"""

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
class GlobalMixture:
    """p_0 = (p_0^f, p_0^b) in Lab, as adapted so far and as learned on the artist's key, which keeps its share."""

    inside: Mixtures
    outside: Mixtures
    key_inside: Mixtures
    key_outside: Mixtures

    @classmethod
    def learned(cls, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float) -> GlobalMixture:
        """From R and its surroundings on a frame whose outline `nodes (N, 2)` is given."""
        inside, outside = (
            gmm.learned(side, params.global_components, params.variance_floor, steps=params.global_steps)
            for side in _sides(frame, nodes, params, scale)
        )
        inside, outside = gmm.known_on_both_sides(inside, outside)
        return cls(inside, outside, inside, outside)

    def adapted(
        self, frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float, confidence: float
    ) -> GlobalMixture:
        """After an accepted frame with the outline `nodes (N, 2)`: moved towards its colours, the more the surer."""
        rate = params.adaptation * confidence
        inside, outside = (
            adapted(model, side, rate, params)
            for model, side in zip((self.inside, self.outside), _sides(frame, nodes, params, scale), strict=True)
        )
        return replace(self, inside=inside, outside=outside)

    def log_ratio(self, band: Band, params: AppearanceParams) -> Float32:
        """ln p_0^f / p_0^b `(rows, columns)` of the cells of a band, clipped to `params.clip`; 0 outside it."""
        index = np.where(band.near, 0, -1).astype(np.int32)
        share = params.key_share
        inside = self.inside.joined(self.key_inside, share).log_density(band.colours, index, params.density)
        outside = self.outside.joined(self.key_outside, share).log_density(band.colours, index, params.density)
        return np.asarray(np.clip(inside - outside, -params.clip, params.clip), dtype=np.float32)


def _sides(frame: PreparedFrame, nodes: Array, params: AppearanceParams, scale: float) -> tuple[Samples, Samples]:
    """The colours of R, and those of a ring around it that stands for P without R."""
    band = Band.around(frame, nodes, params.global_ring, scale)
    most = params.global_samples
    return _thinned(band.colours[band.inside], most), _thinned(band.colours[band.near & ~band.inside], most)


def _thinned(colours: Float32, most: int) -> Samples:
    step = max(1, -(-len(colours) // most))
    chosen = colours[::step].astype(np.float64)
    return Samples.of(chosen, np.zeros(len(chosen), dtype=np.int32), 1)
