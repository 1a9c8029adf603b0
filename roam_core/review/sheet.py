"""Contact sheets: many frames small on a page, each with its number, its confidence and its note."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from roam_core.params import is_doubtful
from roam_core.review.lettering import LEADING, Colour, text_width, wrapped, write
from roam_core.review.look import SCALES, ReviewLook
from roam_core.review.picture import confidence_at, review_picture
from roam_core.roto import Project
from roam_core.roto.timing import mark_at
from roam_core.translatable import N_, sentence

PAPER, INK, WEAK, DOUBT = (38, 38, 38), (216, 216, 216), (154, 154, 154), (255, 140, 26)
MARGIN, GAP = 24, 16
"""Pixels around a page, and between its pictures."""
LETTERS, HEADING = 14, 20
NOTE_LINES = 3
"""Lines of a note that stand under its picture."""
MOST_ACROSS, MOST_DOWN, WIDTHS = 20, 50, (320, 16384)

Read = Callable[[int], Any | None]
"""Gives the working picture of a frame, or None where the plate has none."""


@dataclass(frozen=True)
class SheetLayout:
    """How many pictures lie beside and below each other on a page, and its width in pixels."""

    columns: int = 4
    rows: int = 5
    width: int = 1920

    def __post_init__(self) -> None:
        for number, (least, most), what in (
            (self.columns, (1, MOST_ACROSS), N_("pictures beside each other")),
            (self.rows, (1, MOST_DOWN), N_("rows of pictures")),
            (self.width, WIDTHS, N_("pixels of width")),
        ):
            if not least <= number <= most:
                raise RoamError(
                    sentence(
                        "A contact sheet has {least} to {most} {what}, not {number}.",
                        least=least,
                        most=most,
                        what=sentence(what),
                        number=number,
                    )
                )

    @property
    def cell(self) -> int:
        """The width of a picture in pixels."""
        return (self.width - 2 * MARGIN - (self.columns - 1) * GAP) // self.columns

    def pages(self, frames: Sequence[int]) -> list[tuple[int, ...]]:
        """The frames of each page."""
        count = self.columns * self.rows
        return [tuple(frames[start : start + count]) for start in range(0, len(frames), count)]


def page_paths(path: Path, pages: int) -> list[Path]:
    """The files of so many pages: `path` itself for one, else with the page's number before the suffix."""
    if pages == 1:
        return [path]
    width = len(str(pages))
    return [path.with_name(f"{path.stem}.{page:0{width}d}{path.suffix}") for page in range(1, pages + 1)]


def page_picture(
    project: Project, frames: Sequence[int], read: Read, look: ReviewLook, layout: SheetLayout, title: str
) -> UInt8:
    """One page: `(h, w, 3)` uint8; as high as its pictures and their notes need.

    Parameters
    ----------
    frames : at most as many as the layout has room for. title : stands above the pictures.
    """
    clip = project.require_clip()
    scale = layout.cell / (clip.size[0] * clip.pixel_aspect)
    small = replace(look, burns=frozenset(), scale=min(max(scale, SCALES[0]), SCALES[1]))
    rows = [frames[start : start + layout.columns] for start in range(0, len(frames), layout.columns)]
    strips = [_strip(project, row, read, small, layout) for row in rows]
    heading = np.empty((MARGIN + round(LEADING * HEADING) + GAP, layout.width, 3), dtype=np.uint8)
    heading[:] = PAPER
    write(heading, title, (MARGIN, MARGIN), HEADING, INK, look.font)
    below = np.empty((MARGIN - GAP, layout.width, 3), dtype=np.uint8)
    below[:] = PAPER
    return np.vstack([heading, *strips, below])


def _strip(project: Project, frames: Sequence[int], read: Read, look: ReviewLook, layout: SheetLayout) -> UInt8:
    """A row of pictures with what is said under each."""
    pictures = [_fitting(review_picture(read(frame), project, frame, look), layout.cell) for frame in frames]
    notes = [wrapped(_note(project, frame), layout.cell, LETTERS, look.font, NOTE_LINES) for frame in frames]
    high, step = max(picture.shape[0] for picture in pictures), round(LEADING * LETTERS)
    strip = np.empty((high + step * (1 + max(map(len, notes))) + 4 + GAP, layout.width, 3), dtype=np.uint8)
    strip[:] = PAPER
    for column, (frame, picture, note) in enumerate(zip(frames, pictures, notes, strict=True)):
        left = MARGIN + column * (layout.cell + GAP)
        wide = min(picture.shape[1], layout.width - left)
        strip[: picture.shape[0], left : left + wide] = picture[:, :wide]
        write(strip, str(frame), (left, high + 4), LETTERS, INK, look.font)
        said, colour = _trust(confidence_at(project, frame))
        right = left + layout.cell - text_width(said, LETTERS, look.font)
        write(strip, said, (right, high + 4), LETTERS, colour, look.font)
        for line, text in enumerate(note, 1):
            write(strip, text, (left, high + 4 + line * step), LETTERS, INK, look.font)
    return strip


def _fitting(picture: UInt8, most: int) -> UInt8:
    """A picture no wider than its place: a wide plate's may be, which `SCALES` lets be no smaller."""
    height, width = picture.shape[:2]
    if width <= most + 1:  # widths are even
        return picture
    size = max(most, 1), max(round(height * most / width), 1)
    return np.asarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA))


def _note(project: Project, frame: int) -> str:
    mark = mark_at(project, frame)
    return mark.text if mark is not None else ""


def _trust(confidence: float | None) -> tuple[str, Colour]:
    """What is said of a frame's confidence, doubt also by another word than its colour."""
    if confidence is None:
        return "", WEAK
    return (f"{confidence:.2f} doubtful", DOUBT) if is_doubtful(confidence) else (f"{confidence:.2f}", WEAK)
