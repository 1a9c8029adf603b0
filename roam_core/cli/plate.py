"""Opening a clip for a command: the source behind a cache that decodes ahead, and pictures as the engine wants them."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from typing import Any

from numpy.typing import NDArray

from roam_core.errors import RoamError
from roam_core.media import FrameCache, PlateSource, declared, open_clip
from roam_core.media.colour import to_engine
from roam_core.roto import Clip
from roam_core.roto.relinking import other_content, other_size

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
def opened(path: str, clip: Clip | None = None) -> Iterator[Plate]:
    """A plate for the length of a `with` block; its reading thread ends with it.

    What the project's `clip` declares of its colours and its speed holds, where that is the plate. A plate of another
    size than the project's is refused; of one with another content stderr says so.
    """
    source = open_clip(path)
    if clip is not None:
        _compare(clip, Clip.of(source))
    if clip is not None and clip.path == source.path:
        source = declared(source, clip.colour_space, clip.fps, clip.pixel_aspect)
    cache = FrameCache(source, limit_bytes=1 << 29)
    try:
        yield Plate(source, cache)
    finally:
        cache.close()


def _compare(clip: Clip, found: Clip) -> None:
    if refusal := other_size(clip, found):
        raise RoamError(refusal)
    if warning := other_content(clip, found):
        print(f"roam: {warning}", file=sys.stderr)
