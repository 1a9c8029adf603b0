"""ReviewLook: what a picture for review shows, and what is written on it."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from roam_core.errors import RoamError
from roam_core.translatable import sentence

SCALES = (0.05, 4.0)
"""How much smaller or larger than the plate a picture may be."""


class ReviewView(StrEnum):
    """What is seen of the shot: the plate with the outlines on it, or what the mattes cut out of it."""

    OVERLAY = "overlay"
    CUTOUT = "cutout"


class Ground(StrEnum):
    """What a cut-out lies on."""

    GREY = "grey"
    CHECKER = "checker"
    BLACK = "black"


class Burn(StrEnum):
    """What may be written on the picture: the frame's number, its note, how far it can be trusted."""

    FRAME = "frame"
    NOTE = "note"
    CONFIDENCE = "confidence"


@dataclass(frozen=True)
class ReviewLook:
    """How a picture for review looks.

    Attributes
    ----------
    view : outlines on the plate, or a cut-out. ground : what a cut-out lies on.
    burns : what is written on the picture.
    scale : of the picture's height to the plate's; pixels that are not square are made so.
    font : name or file of the font; "" for the one that comes with OpenImageIO, which has the letters of Western
        Europe. What it lacks is drawn by the fonts of the machine.
    """

    view: ReviewView = ReviewView.OVERLAY
    ground: Ground = Ground.GREY
    burns: frozenset[Burn] = frozenset({Burn.FRAME, Burn.NOTE})
    scale: float = 1.0
    font: str = ""

    def __post_init__(self) -> None:
        if not SCALES[0] <= self.scale <= SCALES[1]:
            raise RoamError(
                sentence(
                    "Pictures are scaled by {least:g} to {most:g}, not by {scale:g}.",
                    least=SCALES[0],
                    most=SCALES[1],
                    scale=self.scale,
                )
            )

    def size(self, plate: tuple[int, int], pixel_aspect: float = 1.0) -> tuple[int, int]:
        """(width, height) of the picture of a plate of (width, height): even numbers, as encoders ask for them."""
        wide, high = plate[0] * self.scale * pixel_aspect, plate[1] * self.scale
        return max(2, 2 * round(wide / 2)), max(2, 2 * round(high / 2))
