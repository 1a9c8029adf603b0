"""One picture of a shot for review: outlines on the plate, or a cut-out, with what is written on it."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.geometry import bezier
from roam_core.matte import render_matte
from roam_core.propagate.shapes.frame_confidence import whole_confidence
from roam_core.review.lettering import WHITE, box_height, lines_in, wrapped, write_boxed
from roam_core.review.look import Burn, Ground, ReviewLook, ReviewView
from roam_core.roto import Clip, Layer, Project, RotoShape
from roam_core.roto.timing import mark_at

GREY, BLACK, MISSING = 96, 0, 40
"""Grey levels under a cut-out, and where the plate has no picture."""
CHECKERS = (74, 106)
CHECKER_ROWS = 45
"""Squares of the checkerboard from top to bottom."""
LETTER_ROWS = 30
"""Heights of letters from top to bottom of a picture."""
LEAST_LETTERS = 11
LINE_ROWS = 1080
"""Rows of a picture that give an outline two pixels of width."""
NOTES = ((1.0, 0.6), (1.0, 0.95), (0.75, 0.95), (0.5, 0.95))
"""How a note is written, the first of these in which all of it has room: the size of its letters to that of others, and
its share of the picture's width."""
FAR = 1e6
"""Pixels from the picture's corner at which an outline is cut off."""
FRACTION = 4
"""Bits of a fraction of a pixel in which OpenCV is told positions."""


def review_picture(plate: Any, project: Project, frame: int, look: ReviewLook) -> UInt8:
    """The picture of one frame: `(h, w, 3)` uint8 for a screen, of the size that the look gives.

    Parameters
    ----------
    plate : the frame in the working picture's colours, `(H, W, 3)` uint8 or floating point in [0, 1], of the clip's
        size; None where the plate has no picture of it.
    project : with a clip. frame : the plate's frame number.
    """
    clip = project.require_clip()
    size = look.size(clip.size, clip.pixel_aspect)
    if look.view is ReviewView.CUTOUT:
        pixels = _cut_out(plate, project, frame, size, look.ground)
    else:
        pixels = _scaled(_shown(plate, clip), size)
        _draw_outlines(pixels, project, frame)
    _burn(pixels, project, frame, look, plate is not None)
    return pixels


def shapes_in_sight(project: Project, frame: int) -> list[RotoShape]:
    """The visible shapes that exist on a frame, in plate space, bottom first."""
    return [shape for shape in _visible(project.plate_root) if shape.exists_at(frame)]


def confidence_at(project: Project, frame: int) -> float | None:
    """How far a frame is trusted as a whole, in [0, 1]; None where no shape in sight was tracked there."""
    keys = [(shape, shape.key_at(frame)) for shape in shapes_in_sight(project, frame)]
    rated = [(shape, key.confidence) for shape, key in keys if key is not None and key.confidence is not None]
    return whole_confidence(rated, frame)[0] if rated else None


def letters_for(rows: int) -> int:
    """The size of letters on a picture of so many rows."""
    return max(LEAST_LETTERS, round(rows / LETTER_ROWS))


def _visible(layer: Layer) -> Iterator[RotoShape]:
    for child in layer.children if layer.visible else ():
        if isinstance(child, Layer):
            yield from _visible(child)
        elif child.visible:
            yield child


def _shown(plate: Any, clip: Clip) -> UInt8:
    """A working picture as pixels of a screen; grey where there is none."""
    if plate is None:
        return np.full((clip.size[1], clip.size[0], 3), MISSING, dtype=np.uint8)
    if plate.dtype == np.uint8:
        return np.asarray(plate)
    return np.asarray(np.rint(np.clip(plate, 0.0, 1.0) * 255.0), dtype=np.uint8)


def _scaled(pixels: UInt8, size: tuple[int, int]) -> UInt8:
    """A new picture of (width, height)."""
    if pixels.shape[1::-1] == size:
        return pixels.copy()
    smaller = size[1] < pixels.shape[0]
    return np.asarray(cv2.resize(pixels, size, interpolation=cv2.INTER_AREA if smaller else cv2.INTER_CUBIC))


def _cut_out(plate: Any, project: Project, frame: int, size: tuple[int, int], ground: Ground) -> UInt8:
    clip = project.require_clip()
    matte = render_matte(project, frame, (clip.size[1], clip.size[0]))
    cover = cv2.resize(matte, size, interpolation=cv2.INTER_AREA)[:, :, None]
    above = _scaled(_shown(plate, clip), size)
    below = _ground(ground, size)
    return np.asarray(np.rint(above * cover + below * (np.float32(1.0) - cover)), dtype=np.uint8)


def _ground(ground: Ground, size: tuple[int, int]) -> UInt8:
    if ground is not Ground.CHECKER:
        return np.full((size[1], size[0], 3), GREY if ground is Ground.GREY else BLACK, dtype=np.uint8)
    side = max(4, round(size[1] / CHECKER_ROWS))
    rows, columns = np.arange(size[1]) // side, np.arange(size[0]) // side
    odd = (rows[:, None] + columns[None, :]) % 2
    return np.repeat(np.asarray(CHECKERS, dtype=np.uint8)[odd][:, :, None], 3, axis=2)


def _draw_outlines(pixels: UInt8, project: Project, frame: int) -> None:
    """The outlines of all shapes in sight, each in its colour with a dark rim."""
    clip = project.require_clip()
    factor = np.array(pixels.shape[1::-1], dtype=np.float64) / clip.size
    core = max(1, 2 * round(pixels.shape[0] / LINE_ROWS))  # of 1 or even widths OpenCV draws the next one wider
    for shape in shapes_in_sight(project, frame):
        line = bezier.flatten(shape.at(frame).points, shape.closed, 0.25 / float(factor.max()))
        pieces, closed = _near(line * factor, shape.closed)
        places = [_for_drawing(piece) for piece in pieces]
        colour = tuple(round(255 * value) for value in shape.colour)
        for ink, width in (((0, 0, 0), core + 1), (colour, core)):
            cv2.polylines(pixels, places, closed, ink, width, cv2.LINE_AA, FRACTION)


def _near(line: Array, closed: bool) -> tuple[list[Array], bool]:
    """The polyline in pieces, and whether each closes: itself, or of one that goes far its edges, cut off there.

    Perspective puts what lies beyond its horizon so far away that OpenCV cannot count the pixels.
    """
    if np.abs(line).max() <= FAR:
        return [line], closed
    ends = np.roll(line, -1, axis=0) if closed else line[1:]
    starts = line[: len(ends)]
    way = np.where(ends == starts, 1e-9, ends - starts)
    borders = np.stack([(-FAR - starts) / way, (FAR - starts) / way])
    first = np.clip(borders.min(axis=0).max(axis=1), 0.0, 1.0)[:, None]
    last = np.clip(borders.max(axis=0).min(axis=1), 0.0, 1.0)[:, None]
    pieces = np.stack([starts + first * (ends - starts), starts + last * (ends - starts)], axis=1)
    return [piece for piece, there in zip(pieces, (first < last)[:, 0], strict=True) if there], False


def _for_drawing(line: Array) -> Any:
    """Positions as OpenCV wants them: `(N, 1, 2)` from pixel centres, in fractions of a pixel."""
    return np.rint((line - 0.5) * (1 << FRACTION)).astype(np.int32)[:, None]


def _burn(pixels: UInt8, project: Project, frame: int, look: ReviewLook, has_picture: bool) -> None:
    size = letters_for(pixels.shape[0])
    said = [str(frame)] if Burn.FRAME in look.burns else []
    write_boxed(pixels, [*said, *([] if has_picture else ["no picture"])], ("left", "bottom"), size, WHITE, look.font)
    if Burn.CONFIDENCE in look.burns and (confidence := confidence_at(project, frame)) is not None:
        write_boxed(pixels, [f"{confidence:.2f}"], ("right", "bottom"), size, WHITE, look.font)
    mark = mark_at(project, frame)
    if Burn.NOTE in look.burns and mark is not None and mark.text:
        _write_note(pixels, mark.text, size, look.font)


def _write_note(pixels: UInt8, text: str, size: int, font: str) -> None:
    """A note above what stands at the lower edge; where it is too long for the picture an ellipsis says so."""
    rows = pixels.shape[0] - box_height(1, size)
    for smaller, share in NOTES:
        letters = max(LEAST_LETTERS, round(smaller * size))
        most = max(lines_in(rows, letters), 1)
        width = round(share * pixels.shape[1])
        if len(wrapped(text, width, letters, font)) <= most:
            break
    write_boxed(pixels, wrapped(text, width, letters, font, most), ("left", "top"), letters, WHITE, font)
