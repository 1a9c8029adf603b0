"""PlateSource: the one face that image sequences and movies show."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Protocol

from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media.area import Area

SPEEDS = (0.01, 1000.0)
"""Frames a second that a plate may run at: lapses of time are slow. Another number in a header is taken for none."""
USUAL_SPEED = 24.0
"""Frames a second of a plate whose files do not say."""

ReadImage = Callable[[int], Image]
"""Gives the picture `(h, w, 3)` of a frame by its number; raises `MissingFrame` in a gap."""


def likely_speed(told: float) -> float:
    """The frames a second that a header tells; the usual ones where that is no speed."""
    return told if SPEEDS[0] <= told <= SPEEDS[1] else USUAL_SPEED


class Areas(Protocol):
    """A frame's file whose areas can be read by themselves."""

    def read(self, area: Area) -> Image:
        """An area `(rows, columns, 3)` of the picture, as it is in that which `PlateSource.read` gives.

        Raises
        ------
        DamagedFrame
            where it cannot be read.
        """


class MissingFrame(RoamError):
    """The plate has no such frame: outside its range, or a gap in its numbers."""


class DamagedFrame(MissingFrame):
    """The frame is there and cannot be used: damaged, cut short, of another size. A run bridges it like a gap."""


@dataclass(frozen=True)
class ImageHeader:
    """What a file says of its picture before a pixel is read; see `PlateSource` for the attributes."""

    size: tuple[int, int]
    fps: float
    pixel_aspect: float
    colour_space: str
    depth: str
    layer: str
    layers: tuple[str, ...]


class PlateSource(Protocol):
    """A plate that gives its frames by their own numbers. Reading is safe from any thread."""

    @property
    def path(self) -> Path:
        """The folder, pattern, image or movie that opens this plate again."""

    @property
    def frames(self) -> tuple[int, ...]:
        """The numbers of the frames that exist, sorted."""

    @property
    def missing(self) -> tuple[int, ...]:
        """The gaps: numbers between the first and the last frame that have none, sorted."""

    @property
    def size(self) -> tuple[int, int]:
        """(width, height) in pixels."""

    @property
    def fps(self) -> float:
        """Frames per second; `USUAL_SPEED` where the files do not say."""

    @property
    def pixel_aspect(self) -> float:
        """Width of a pixel over its height."""

    @property
    def colour_space(self) -> str:
        """`"sRGB"`, `"linear"` or `"log"`: what `roam_core.media.colour` needs to show the values."""

    @property
    def depth(self) -> str:
        """How finely the files hold their values, in an artist's words: `8 bits`, `half float`."""

    @property
    def layer(self) -> str:
        """The layer of the files that is read."""

    @property
    def layers(self) -> tuple[str, ...]:
        """All layers of the files, in their order; a movie has one."""

    @property
    def readers(self) -> int:
        """How many threads are worth reading it at once: a movie is decoded in one go by one."""

    def read(self, frame: int) -> Image:
        """The picture `(h, w, 3)` of a frame, RGB, uint8, uint16, float16 or float32.

        Raises
        ------
        MissingFrame
            when the plate has no such frame; `DamagedFrame` when it is there and cannot be decoded, or differs in size
            from the others.
        ValueError
            for what is no frame's number.
        """

    def areas(self, frame: int) -> Areas | None:
        """The areas of a frame, where one is read in less time than all of it; None where not, as of a movie.

        Raises
        ------
        MissingFrame, DamagedFrame
            as `read` does; what is damaged may show only where it is read.
        """

    def file_of(self, frame: int) -> Path:
        """The file that holds a frame; it need not be there."""

    def frame_name(self, frame: int) -> str:
        """The name of a frame without its extension, by which its matte is named."""
