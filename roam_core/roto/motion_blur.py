"""MotionBlur: for how long, and from when on, a shape's shutter is open."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class MotionBlur:
    """Motion blur from the vertices' motion: `shutter` in frames, `phase` of its opening in frames, `samples`."""

    shutter: float = 0.5
    phase: float = -0.25
    samples: int = 16
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    @property
    def is_seen(self) -> bool:
        """Whether the shutter is open for a time, and that is sampled."""
        return self.shutter != 0.0 and self.samples >= 2

    def seen_from(self, frames: range) -> range:
        """The whole frames between which a shape moves while the shutter is open on `frames`."""
        if not self.is_seen:
            return frames
        opens, closes = sorted((self.phase, self.phase + self.shutter))
        return range(frames.start + min(math.floor(opens), 0), frames.stop + max(math.ceil(closes), 0))
