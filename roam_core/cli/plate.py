"""Opening a clip for a command: the source behind a cache that decodes ahead, and pictures as the engine wants them."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from roam_core.media import FrameCache, PlateSource, open_clip
from roam_core.media.colour import to_engine

AHEAD = 4
"""Frames decoded ahead of the solver."""


@dataclass(frozen=True)
class Plate:
    """A clip being read."""

    source: PlateSource
    cache: FrameCache

    def read(self, frame: int) -> NDArray[Any]:
        """The picture of a frame, display-referred, for the engine."""
        return to_engine(self.cache.read(frame), self.source.colour_space)

    def ahead_of(self, frame: int, frames: range) -> None:
        """Decode the frames that follow `frame` in `frames` in the background."""
        position = frames.index(frame)
        self.cache.read_ahead([f for f in frames[position + 1 : position + 1 + AHEAD] if f in self.source.frames])


@contextmanager
def opened(path: str) -> Iterator[Plate]:
    """A plate for the length of a `with` block; its reading thread ends with it."""
    source = open_clip(path)
    cache = FrameCache(source, limit_bytes=1 << 29)
    try:
        yield Plate(source, cache)
    finally:
        cache.close()
