"""Declared plates: what an artist says of a plate's colours, speed and pixels holds against what its files say."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from roam_core.arrays import Image
from roam_core.media.source import Areas, PlateSource


@dataclass(frozen=True)
class DeclaredPlate:
    """A plate whose files are read as they are, under another name for their colours, speed and pixels.

    See `PlateSource` for the attributes.
    """

    source: PlateSource
    colour_space: str
    fps: float
    pixel_aspect: float

    @property
    def path(self) -> Path:
        return self.source.path

    @property
    def frames(self) -> tuple[int, ...]:
        return self.source.frames

    @property
    def missing(self) -> tuple[int, ...]:
        return self.source.missing

    @property
    def size(self) -> tuple[int, int]:
        return self.source.size

    @property
    def depth(self) -> str:
        return self.source.depth

    @property
    def layer(self) -> str:
        return self.source.layer

    @property
    def layers(self) -> tuple[str, ...]:
        return self.source.layers

    @property
    def readers(self) -> int:
        return self.source.readers

    def read(self, frame: int) -> Image:
        """The picture `(h, w, 3)` of a frame: the same values; what they mean is what was declared."""
        return self.source.read(frame)

    def areas(self, frame: int) -> Areas | None:
        """The areas of a frame, where one is read in less time than all of it."""
        return self.source.areas(frame)

    def file_of(self, frame: int) -> Path:
        """The file that holds a frame."""
        return self.source.file_of(frame)

    def frame_name(self, frame: int) -> str:
        """The name of a frame without its extension."""
        return self.source.frame_name(frame)


def declared(source: PlateSource, colour_space: str, fps: float, pixel_aspect: float) -> PlateSource:
    """The plate under these declarations; the plate itself where its files say the same."""
    if (source.colour_space, source.fps, source.pixel_aspect) == (colour_space, fps, pixel_aspect):
        return source
    return DeclaredPlate(source, colour_space, fps, pixel_aspect)
