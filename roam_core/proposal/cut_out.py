"""The object in a box, or under a click, told from its surroundings: GrabCut on a small copy of the picture.

Rother, Kolmogorov and Blake, "GrabCut", SIGGRAPH 2004, as OpenCV has it. For the first key of a shape; what follows it
through time is the engine's own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace
from itertools import pairwise, takewhile

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.roto import BlendMode, RotoShape

Array = NDArray[np.float64]
Image = NDArray[np.uint8]
Mask = NDArray[np.uint8]
Float32 = NDArray[np.float32]
Bools = NDArray[np.bool_]
Spot = tuple[float, float]

MOST_CELLS = 360
"""Cells on the longer side of the copy that is cut."""

MARGIN = 0.3
"""How much of the box's size is looked at on each side of it: the ground that the object differs from."""

AROUND, NEARBY = 1.0, 0.15
"""The box around a click's region goes so many of its sizes beyond it, and at least this share of the picture's."""

GROWTHS = 3
"""Times that the box around a click is cut, and made larger where the object runs against its side."""

ROUNDS = 5
"""Rounds of learning colours and cutting."""

LEAST_SHARE = 0.08
"""Share of what was thought to be inside at first that must be left; a cut that leaves less has collapsed."""

LEAST_BOX = 6.0
"""Pixels on the shorter side of the smallest box."""

STEPS = (3.0, 4.5, 6.0, 8.0, 10.0, 13.0, 17.0, 22.0)
"""Lab distances from the colour that was clicked at which its region is grown."""

LEAK = 2.5
"""A region that grows by more than this from one distance to the next has run out into its surroundings."""

LARGEST, SMALLEST = 0.4, 0.0004
"""Shares of the picture: a region outside of these is no object that was clicked on."""

TOLERANCE = 1.0
"""Cells by which the shape may stray from the cut."""

LOCAL = 11
"""Cells on a side of the square in which the colours on both sides of the border are learned for its cells."""

LEAST_CONTRAST = 24.0
"""Grey values between the two sides, all channels together, at which a mixed cell tells how much is covered."""

SOFTNESS = 1.2
"""Cells of the Gaussian that takes the stairs off the cut before its outline is fitted."""


@dataclass(frozen=True, eq=False)
class _Piece:
    """A small copy of a part of the picture: `pixels (rows, columns, 3)`, its corner, its cells' size in pixels."""

    pixels: Image
    corner: Array
    cell: Array

    @classmethod
    def of(cls, image: Image, low: Array, high: Array) -> _Piece:
        height, width = image.shape[:2]
        left, top = (max(math.floor(v), 0) for v in low)
        right, bottom = min(math.ceil(high[0]), width), min(math.ceil(high[1]), height)
        if right - left < LEAST_BOX or bottom - top < LEAST_BOX:
            raise RoamError("There is too little of the picture there; drag a box around the object.")
        shrink = max(1.0, max(right - left, bottom - top) / MOST_CELLS)
        cells = max(4, round((right - left) / shrink)), max(4, round((bottom - top) / shrink))
        pixels = cv2.resize(image[top:bottom, left:right], cells, interpolation=cv2.INTER_AREA)
        cell = np.array([(right - left) / cells[0], (bottom - top) / cells[1]])
        return cls(np.ascontiguousarray(pixels, dtype=np.uint8), np.array([left, top], dtype=np.float64), cell)

    def cells(self, spot: Array) -> tuple[int, int]:
        """The cell `(column, row)` of a place, also outside of the piece."""
        column, row = np.floor((spot - self.corner) / self.cell).astype(int).tolist()
        return column, row


def cut_box(
    image: Image, low: Spot, high: Spot, frame: int, token: CancelToken | None = None, progress: Progress | None = None
) -> list[RotoShape]:
    """The object in the box between `low` and `high` as shapes keyed on `frame`: its outline, then its holes.

    Parameters
    ----------
    image : (h, w, 3) uint8, as on the screen.
    low, high : (x, y) pixels; the object should touch the box's sides, or nearly.

    Raises
    ------
    RoamError
        when the box is too small, leaves no ground to tell the object from, or nothing in it stands out.
    """
    size = np.array(image.shape[1::-1], dtype=np.float64)
    a, b = np.clip(np.array(low), 0.0, size), np.clip(np.array(high), 0.0, size)
    if (b - a).min() < LEAST_BOX:
        raise RoamError(f"The box is too small; drag one of at least {LEAST_BOX:.0f} pixels around the object.")
    margin = np.maximum((b - a) * MARGIN, 4.0)
    piece = _Piece.of(image, a - margin, b + margin)
    labels = np.full(piece.pixels.shape[:2], cv2.GC_BGD, dtype=np.uint8)
    (left, top), (right, bottom) = piece.cells(a), piece.cells(b)
    labels[max(top, 0) : bottom + 1, max(left, 0) : right + 1] = cv2.GC_PR_FGD
    return _fitted(piece, _largest(_cut(piece.pixels, labels, _Told(token, progress))), frame)


def cut_click(
    image: Image, spot: Spot, frame: int, token: CancelToken | None = None, progress: Progress | None = None
) -> list[RotoShape]:
    """The object under a click at `spot` (x, y): a region of like colour is grown there, boxed and cut out.

    Raises
    ------
    RoamError
        when the click is outside of the picture or no region ends around it.
    """
    height, width = image.shape[:2]
    if not (0.0 <= spot[0] < width and 0.0 <= spot[1] < height):
        raise RoamError("Click on the object, inside of the picture.")
    whole = _Piece.of(image, np.zeros(2), np.array([width, height], dtype=np.float64))
    region = _grown(whole.pixels, whole.cells(np.array(spot)))
    for attempt in range(GROWTHS):
        low, high = _box_of(region, whole)
        piece = _Piece.of(image, low - (high - low) * MARGIN / 2.0, high + (high - low) * MARGIN / 2.0)
        labels = _seeded(piece, _resampled(region, whole, piece), low, high)
        told = _Told(token, progress, attempt, GROWTHS)
        cut = _largest(_cut(piece.pixels, labels, told), piece.cells(np.array(spot)))
        if attempt == GROWTHS - 1 or not _touches(cut, piece, low, high, size=(width, height)):
            break
        region |= _resampled(cut, piece, whole)
    return _fitted(piece, cut, frame)


@dataclass(frozen=True)
class _Told:
    """Who wants to know how far it is, and may stop it."""

    token: CancelToken | None
    progress: Progress | None
    part: int = 0
    parts: int = 1

    def of(self, share: float) -> None:
        if self.token is not None:
            self.token.check()
        if self.progress is not None:
            self.progress((self.part + share) / self.parts, "Finding the object …")


def _fitted(piece: _Piece, cut: Bools, frame: int) -> list[RotoShape]:
    """What was cut out of a piece as shapes on the picture: its outline, then its holes."""
    soft = cv2.GaussianBlur(_covered(piece.pixels, cut), (0, 0), SOFTNESS, borderType=cv2.BORDER_REPLICATE)
    found = shapes_from_mask(soft, frame, TOLERANCE)
    if not found:
        raise RoamError("Nothing stands out there; drag a closer box around the object.")
    holes = takewhile(lambda shape: shape.blend is BlendMode.SUBTRACT, found[1:])
    return [_placed(shape, lambda points: piece.corner + points * piece.cell) for shape in (found[0], *holes)]


def _covered(pixels: Image, cut: Bools) -> Float32:
    """How much of each cell the object covers: near the border of the cut, how far its colour is the object's.

    The border's cells mix both sides, and the cut counts most of them as inside. Where the sides differ too little to
    tell, the cut's word holds.
    """
    inside, colours = cut.astype(np.uint8), pixels.astype(np.float32)
    kernel = np.ones((5, 5), dtype=np.uint8)
    core, beyond = cv2.erode(inside, kernel), cv2.erode(1 - inside, kernel)
    object_, ground = _local_mean(colours, core), _local_mean(colours, beyond)
    across = object_ - ground
    contrast = np.einsum("rcl,rcl->rc", across, across)
    share = np.einsum("rcl,rcl->rc", colours - ground, across) / np.maximum(contrast, 1.0)
    told = (core == 0) & (beyond == 0) & (contrast > LEAST_CONTRAST**2)
    return np.where(told, np.clip(share, 0.0, 1.0), inside).astype(np.float32)


def _local_mean(colours: Float32, chosen: Mask) -> Float32:
    """The mean colour `(rows, columns, 3)` of the chosen cells around each cell."""
    weight = chosen.astype(np.float32)
    total = cv2.boxFilter(colours * weight[:, :, None], -1, (LOCAL, LOCAL), normalize=False)
    count = cv2.boxFilter(weight, -1, (LOCAL, LOCAL), normalize=False)
    return np.asarray(total / np.maximum(count, 1.0)[:, :, None], dtype=np.float32)


def _placed(shape: RotoShape, place: Callable[[Array], Array]) -> RotoShape:
    return replace(shape, keys=tuple(replace(key, points=place(key.points)) for key in shape.keys))


def _cut(pixels: Image, labels: Mask, told: _Told) -> Bools:
    """GrabCut from the first `labels`, round after round; True inside."""
    colours = cv2.GaussianBlur(pixels, (0, 0), 0.8)
    if not ((labels == cv2.GC_BGD) | (labels == cv2.GC_PR_BGD)).any():
        raise RoamError("The box leaves no ground around the object; drag one that does not fill the picture.")
    behind, before, least = np.zeros((1, 65)), np.zeros((1, 65)), LEAST_SHARE * _inside(labels).sum()
    cv2.setRNGSeed(0)  # The colours' first guess is drawn at random: the same box gives the same shape.
    for number in range(ROUNDS):
        told.of(number / ROUNDS)
        mode, last = cv2.GC_INIT_WITH_MASK if number == 0 else cv2.GC_EVAL, labels.copy()
        cv2.grabCut(colours, labels, None, behind, before, 1, mode)
        if _inside(labels).sum() < least:
            labels = last
            break
    told.of(1.0)
    return _inside(labels)


def _inside(labels: Mask) -> Bools:
    return np.asarray((labels == cv2.GC_FGD) | (labels == cv2.GC_PR_FGD))


def _largest(inside: Bools, cell: tuple[int, int] | None = None) -> Bools:
    """The connected part that holds a cell `(column, row)`, or else the largest one."""
    count, parts, stats, _ = cv2.connectedComponentsWithStats(inside.astype(np.uint8), connectivity=4)
    if count < 2:
        return inside
    largest = 1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))
    chosen = int(parts[cell[1], cell[0]]) if cell is not None else 0
    return np.asarray(parts == (chosen or largest))


def _grown(pixels: Image, cell: tuple[int, int]) -> Bools:
    """The region of like colour around a cell `(column, row)`, as large as it gets before it leaks out."""
    colours = cv2.cvtColor(cv2.bilateralFilter(pixels, 5, 30.0, 5.0).astype(np.float32) / 255.0, cv2.COLOR_RGB2Lab)
    column, row = cell
    # Like the median of a few cells: a single one may be grain.
    around = colours[max(row - 2, 0) : row + 3, max(column - 2, 0) : column + 3].reshape(-1, 3)
    distance = np.sqrt(((colours - np.median(around, axis=0)) ** 2).sum(axis=2))
    regions = [_part_at(distance <= step, cell) for step in STEPS]
    total = pixels.shape[0] * pixels.shape[1]
    fit = [region for region in regions if SMALLEST * total <= region.sum() <= LARGEST * total]
    if not fit:
        raise RoamError("No object ends around that place; drag a box around it instead.")
    for small, large in pairwise(fit):
        if large.sum() > LEAK * small.sum() and small.sum() > 8 * SMALLEST * total:
            return small
    return fit[-1]


def _part_at(like: Bools, cell: tuple[int, int]) -> Bools:
    """The connected part of `like` at a cell `(column, row)`; holes that grain leaves are filled."""
    column, row = cell
    like = like.copy()
    like[max(row - 1, 0) : row + 2, max(column - 1, 0) : column + 2] = True
    closed = cv2.morphologyEx(like.astype(np.uint8), cv2.MORPH_CLOSE, np.ones((5, 5), dtype=np.uint8))
    _, parts = cv2.connectedComponents(closed, connectivity=4)
    return np.asarray(parts == parts[row, column])


def _box_of(region: Bools, whole: _Piece) -> tuple[Array, Array]:
    """The box that an object may fill of which a region is known: wide enough that all kinds of ground are in it."""
    rows, columns = np.nonzero(region)
    low = whole.corner + np.array([columns.min(), rows.min()]) * whole.cell
    high = whole.corner + (np.array([columns.max(), rows.max()]) + 1) * whole.cell
    margin = np.maximum((high - low) * AROUND, NEARBY * np.array(whole.pixels.shape[1::-1]) * whole.cell)
    return low - margin, high + margin


def _touches(cut: Bools, piece: _Piece, low: Array, high: Array, size: tuple[int, int]) -> bool:
    """True where the cut runs against a side of the box that is not the picture's own."""
    rows, columns = np.nonzero(cut)
    if not len(rows):
        return False
    first = piece.corner + np.array([columns.min() - 1, rows.min() - 1]) * piece.cell
    last = piece.corner + (np.array([columns.max(), rows.max()]) + 2) * piece.cell
    return bool(((first <= low) & (low > 0.0)).any() or ((last >= high) & (high < np.array(size))).any())


def _resampled(mask: Bools, source: _Piece, target: _Piece) -> Bools:
    """A mask on the cells of one piece as one on those of another; nothing beyond the first."""
    rows, columns = target.pixels.shape[:2]
    found = []
    for axis, count in enumerate((columns, rows)):
        centres = target.corner[axis] + (np.arange(count) + 0.5) * target.cell[axis]
        found.append(np.floor((centres - source.corner[axis]) / source.cell[axis]).astype(int))
    across, down = found
    inside = np.ix_((down >= 0) & (down < mask.shape[0]), (across >= 0) & (across < mask.shape[1]))
    result = np.zeros((rows, columns), dtype=bool)
    result[inside] = mask[np.ix_(np.clip(down, 0, mask.shape[0] - 1), np.clip(across, 0, mask.shape[1] - 1))][inside]
    return result


def _seeded(piece: _Piece, region: Bools, low: Array, high: Array) -> Mask:
    """First labels: the region is likely inside, its core surely; outside of the box `low`, `high` is ground."""
    labels = np.full(region.shape, cv2.GC_BGD, dtype=np.uint8)
    (left, top), (right, bottom) = piece.cells(low), piece.cells(high)
    labels[max(top, 0) : bottom + 1, max(left, 0) : right + 1] = cv2.GC_PR_BGD
    labels[region] = cv2.GC_PR_FGD
    core = cv2.erode(region.astype(np.uint8), np.ones((3, 3), dtype=np.uint8), iterations=2)
    labels[core > 0] = cv2.GC_FGD
    return labels
