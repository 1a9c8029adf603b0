"""ColourFields: the colour models, asked once a frame for every cell near the curve."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from roam_core.arrays import Array, Float32
from roam_core.features.grid import Grid
from roam_core.kernels.region_sums import row_sums


@dataclass(frozen=True, eq=False)
class ColourFields:
    """Log densities on `grid`, `(rows, columns)` each. They score any curve in the band, of any number of nodes.

    Attributes
    ----------
    foreground, background : ln p_n^f and ln p_n^b of the nearest edge; equal, and nothing known, outside the band.
    clip : bound on the log-ratios, nats.
    global_ratio : ln p_0^f / p_0^b, clipped; None where no global model is used.
    """

    grid: Grid
    foreground: Float32
    background: Float32
    clip: float
    global_ratio: Float32 | None = None

    @cached_property
    def log_ratio(self) -> Float32:
        """ln p_n^f / p_n^b, clipped: positive where the local models see the object."""
        return np.asarray(np.clip(self.foreground - self.background, -self.clip, self.clip), dtype=np.float32)

    @cached_property
    def local_sums(self) -> Array:
        """Row sums Q of the local log-ratio, `(rows, columns + 1)`."""
        return row_sums(self.log_ratio)

    @cached_property
    def global_sums(self) -> Array:
        """Row sums Q of the global log-ratio, `(rows, columns + 1)`; zero without a global model."""
        return np.zeros_like(self.local_sums) if self.global_ratio is None else row_sums(self.global_ratio)
