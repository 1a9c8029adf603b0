"""The global colour model p_0 as histograms: colours inside the shape against those around it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Bools, Float32, UInt8
from roam_core.kernels.colour_bins import bin_counts, looked_up


@dataclass(frozen=True, eq=False)
class GlobalModel:
    """Densities of RGB colours in 32^3 bins, `inside` and `outside (32768,)`, each summing to one."""

    inside: Float32
    outside: Float32

    @classmethod
    def learned(cls, image: UInt8, inside: Bools, outside: Bools) -> GlobalModel:
        """From an image `(h, w, 3)` and the pixels that lie inside and outside."""
        return cls(_density(image, inside), _density(image, outside))

    def adapted(self, other: GlobalModel, rate: float) -> GlobalModel:
        """Moved towards another model by `rate` (exponential forgetting, after Stauffer and Grimson, 1999)."""
        keep = np.float32(1.0 - rate)
        gain = np.float32(rate)
        return GlobalModel(keep * self.inside + gain * other.inside, keep * self.outside + gain * other.outside)

    def log_ratio(self, image: UInt8, clip: float, unseen: float) -> Float32:
        """ln p_f / p_b of each pixel `(h, w)`, clipped to +-`clip` nats; `unseen`: density of unknown colours."""
        table = np.log((self.inside + np.float32(unseen)) / (self.outside + np.float32(unseen)))
        return looked_up(image, np.clip(table, np.float32(-clip), np.float32(clip)))


def _density(image: UInt8, wanted: Bools) -> Float32:
    counts = bin_counts(image, wanted)
    return np.asarray(counts / max(float(counts.sum()), 1.0), dtype=np.float32)
