"""Levels: a picture of little contrast as one of the usual contrast, which the engine's differences of colour are of.

A night exterior, haze or a log plate spans a small part of the range. Seen as it is, what tells the object from its
ground lies below what the engine takes for the same colour. The whole picture tells, for around a small object the
ground may be plain on any plate.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from roam_core.arrays import UInt8
from roam_core.features.frame import PreparedFrame
from roam_core.params.evidence import LevelsParams


@dataclass(frozen=True)
class Levels:
    """From `black` on, in [0, 255], all channels are stretched by `contrast`; black comes to lie on `floor`."""

    black: float
    contrast: float
    floor: float

    @classmethod
    def of(cls, picture: PreparedFrame, params: LevelsParams) -> Levels | None:
        """Those that a picture asks for; None where it has the contrast."""
        count = np.cumsum(np.bincount(picture.grey.ravel(), minlength=256))
        black, white = (float(np.searchsorted(count, share * count[-1])) for share in (params.dark, params.bright))
        if white - black >= params.under:
            return None
        return cls(black, min(params.span / max(white - black, 1.0), params.most), params.floor)

    @cached_property
    def table(self) -> UInt8:
        """What each value becomes, `(256,)`: rounded, and cut at black and white."""
        values = self.floor + self.contrast * (np.arange(256.0) - self.black)
        return np.clip(np.round(values), 0.0, 255.0).astype(np.uint8)
