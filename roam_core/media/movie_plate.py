"""MoviePlate: what every movie is as a plate, whoever decodes it; and whether one is shorter than it says."""

from __future__ import annotations

import math
from abc import ABC, abstractmethod
from pathlib import Path
from typing import Any

from roam_core.arguments import frame_number
from roam_core.arrays import Image
from roam_core.media.curves import SRGB
from roam_core.media.layers import PLAIN
from roam_core.media.source import DamagedFrame, MissingFrame, PlateSource
from roam_core.translatable import sentence

ROUNDED = 0.01
"""The share of its frames by which a header may be wrong that reckons them from the length and the speed."""


def shortfall(source: PlateSource) -> str:
    """That a movie has fewer frames than its header speaks of, in a sentence; "" where it has them, or is no movie."""
    if not isinstance(source, MoviePlate) or source.claimed - source.count <= max(1.0, ROUNDED * source.claimed):
        return ""
    return sentence(
        "{name} has {count} frames that can be read, its header says {claimed}: it may be cut short.",
        name=source.path.name,
        count=source.count,
        claimed=source.claimed,
    )


def turned_aspect(aspect: float, degrees: float) -> float:
    """The pixels' width over their height in pictures that are turned as the camera was held; 1 where it is none."""
    if not 0.1 <= aspect <= 10.0:
        return 1.0
    return 1.0 / aspect if math.isfinite(degrees) and round(degrees / 90.0) % 2 else aspect


class MoviePlate(ABC):
    """A movie as a plate: frames are numbered from 1. See `PlateSource` for the attributes.

    A copy, also in another process, opens the file anew.
    """

    readers = 1
    size: tuple[int, int]
    fps: float
    pixel_aspect: float
    depth = "8 bits"
    colour_space = SRGB
    missing: tuple[int, ...] = ()
    layer, layers = PLAIN, (PLAIN,)
    claimed = 0
    """How many frames its header speaks of; 0 where it does not say."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.frames: tuple[int, ...] = ()

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (self.path,)

    @property
    def count(self) -> int:
        """The number of its frames."""
        return len(self.frames)

    def _number(self, count: int) -> None:
        """Number its frames, so many."""
        self.frames = tuple(range(1, count + 1))

    def file_of(self, frame: int) -> Path:
        """The movie, whichever the frame."""
        return self.path

    def frame_name(self, frame: int) -> str:
        """The frame's number, padded with zeros: to five digits, more for a longer movie."""
        return f"{frame:0{max(5, len(str(self.count)))}d}"

    def read(self, frame: int) -> Image:
        """The picture `(h, w, 3)` of a frame: uint8, or uint16 of a movie with more than 8 bits.

        Raises
        ------
        MissingFrame, DamagedFrame
            see `PlateSource.read`.
        """
        frame = frame_number(frame)
        if not 1 <= frame <= self.count:
            raise MissingFrame(
                sentence(
                    "Frame {frame} of {path} is missing: the movie has the frames 1 to {last}.",
                    frame=frame,
                    path=self.path,
                    last=self.count,
                )
            )
        picture = self._picture(frame - 1)
        if picture is None:
            raise DamagedFrame(
                sentence(
                    "Frame {frame} of {path} cannot be decoded; the movie is damaged or cut short.",
                    frame=frame,
                    path=self.path,
                )
            )
        if (picture.shape[1], picture.shape[0]) != self.size:
            raise DamagedFrame(
                sentence(
                    "Frame {frame} of {path} differs in size from the first; a plate needs one size.",
                    frame=frame,
                    path=self.path,
                )
            )
        return picture

    def areas(self, frame: int) -> None:
        """None: a movie's pictures are decoded whole."""
        return None  # noqa: RET501 - that is an answer

    @abstractmethod
    def _picture(self, index: int) -> Image | None:
        """The picture of the frame `index`, from 0; None where it cannot be decoded."""
