"""The object in a box, or under a click, told from its surroundings: GrabCut on a small copy of the picture.

Rother, Kolmogorov and Blake, "GrabCut", SIGGRAPH 2004, as OpenCV has it. For the first key of a shape; what follows it
through time is the engine's own.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass, replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.params import CUT_OUT
from roam_core.proposal.assist.growing import grown
from roam_core.roto import BlendMode, RotoShape
from roam_core.translatable import sentence

Spot = tuple[float, float]


@dataclass(frozen=True, eq=False)
class _Piece:
    """A small copy of a part of the picture: `pixels (rows, columns, 3)`, its corner, its cells' size in pixels."""

    pixels: UInt8
    corner: Array
    cell: Array

    @classmethod
    def of(cls, image: UInt8, low: Array, high: Array) -> _Piece:
        height, width = image.shape[:2]
        left, top = (max(math.floor(v), 0) for v in low)
        right, bottom = min(math.ceil(high[0]), width), min(math.ceil(high[1]), height)
        if right - left < CUT_OUT.least_box or bottom - top < CUT_OUT.least_box:
            raise RoamError(sentence("There is too little of the picture there; drag a box around the object."))
        shrink = max(1.0, max(right - left, bottom - top) / CUT_OUT.most_cells)
        cells = max(4, round((right - left) / shrink)), max(4, round((bottom - top) / shrink))
        pixels = cv2.resize(image[top:bottom, left:right], cells, interpolation=cv2.INTER_AREA)
        cell = np.array([(right - left) / cells[0], (bottom - top) / cells[1]])
        return cls(np.ascontiguousarray(pixels, dtype=np.uint8), np.array([left, top], dtype=np.float64), cell)

    def cells(self, spot: Array) -> tuple[int, int]:
        """The cell `(column, row)` of a place, also outside of the piece."""
        column, row = np.floor((spot - self.corner) / self.cell).astype(int).tolist()
        return column, row


@dataclass(frozen=True)
class Marks:
    """Places `(x, y)` in pixels that are known to lie `inside` of the object and `outside` of it."""

    inside: tuple[Spot, ...] = ()
    outside: tuple[Spot, ...] = ()


UNMARKED = Marks()


def cut_box(
    image: UInt8,
    low: Spot,
    high: Spot,
    frame: int,
    marks: Marks = UNMARKED,
    token: CancelToken | None = None,
    progress: Progress | None = None,
) -> list[RotoShape]:
    """The object in the box between `low` and `high` as shapes keyed on `frame`: its outline, then its holes.

    Parameters
    ----------
    image : (h, w, 3) uint8, as on the screen.
    low, high : (x, y) pixels; the object should touch the box's sides, or nearly.
    marks : what is known of the object beside its box.

    Raises
    ------
    RoamError
        when the box is too small, leaves no background to tell the object from, or nothing in it stands out.
    """
    size = np.array(image.shape[1::-1], dtype=np.float64)
    a, b = np.clip(np.array(low), 0.0, size), np.clip(np.array(high), 0.0, size)
    if (b - a).min() < CUT_OUT.least_box:
        raise RoamError(
            sentence(
                "The box is too small; drag one of at least {least:.0f} pixels around the object.",
                least=CUT_OUT.least_box,
            )
        )
    margin = np.maximum((b - a) * CUT_OUT.margin, 4.0)
    piece = _Piece.of(image, a - margin, b + margin)
    labels = np.full(piece.pixels.shape[:2], cv2.GC_BGD, dtype=np.uint8)
    (left, top), (right, bottom) = piece.cells(a), piece.cells(b)
    labels[max(top, 0) : bottom + 1, max(left, 0) : right + 1] = cv2.GC_PR_FGD
    _put_marks(labels, piece, marks)
    return _fitted(piece, _chosen(_cut(piece.pixels, labels, _Told(token, progress)), piece, marks), frame)


def cut_click(
    image: UInt8, frame: int, marks: Marks, token: CancelToken | None = None, progress: Progress | None = None
) -> list[RotoShape]:
    """The object at `marks.inside` (clicks on it): regions of like colour are grown there, boxed and cut out.

    Raises
    ------
    RoamError
        when a click is outside of the picture, none is inside of the object, or no region ends around one.
    """
    height, width = image.shape[:2]
    if not marks.inside or not all(0.0 <= x < width and 0.0 <= y < height for x, y in marks.inside):
        raise RoamError(sentence("Click on the object, inside of the picture."))
    whole = _Piece.of(image, np.zeros(2), np.array([width, height], dtype=np.float64))
    region = _marked_region(whole, marks)
    for attempt in range(CUT_OUT.growths):
        low, high = _box_of(region, whole)
        piece = _Piece.of(image, low - (high - low) * CUT_OUT.margin / 2.0, high + (high - low) * CUT_OUT.margin / 2.0)
        labels = _seeded(piece, _resampled(region, whole, piece), low, high)
        _put_marks(labels, piece, marks)
        cut = _chosen(_cut(piece.pixels, labels, _Told(token, progress, attempt, CUT_OUT.growths)), piece, marks)
        if attempt == CUT_OUT.growths - 1 or not _touches(cut, piece, low, high, size=(width, height)):
            break
        region |= _resampled(cut, piece, whole)
    return _fitted(piece, cut, frame)


def _marked_region(whole: _Piece, marks: Marks) -> Bools:
    """The regions of like colour around the marks inside; the first must have one.

    One around a later mark that is much larger than those before it and runs along the picture's border is the
    background, which shows through there.
    """
    region: Bools | None = None
    for spot in marks.inside:
        cell = whole.cells(np.array(spot))
        found = grown(whole.pixels, cell)
        if region is None:
            if found is None:
                raise RoamError(sentence("No object ends around that place; drag a box around it instead."))
            region = found
        elif found is not None and not (
            found.sum() > CUT_OUT.swell * region.sum() and _along_border(found) > CUT_OUT.along
        ):
            region = region | found
        else:
            region = region.copy()
            region[cell[1], cell[0]] = True
    assert region is not None
    return region


def _along_border(region: Bools) -> float:
    """The share of the picture's border that lies in a region."""
    border = np.concatenate([region[0], region[-1], region[1:-1, 0], region[1:-1, -1]])
    return float(border.mean())


def _put_marks(labels: UInt8, piece: _Piece, marks: Marks) -> None:
    """Hold the cells around each mark in the labels `(rows, columns)` on its side.

    What is of like colour around a mark beside the object is likely background, too.
    """
    rows, columns = labels.shape
    for spot in marks.outside:
        column, row = piece.cells(np.array(spot))
        if 0 <= row < rows and 0 <= column < columns:
            found = grown(piece.pixels, (column, row))
            if found is not None:
                labels[found & (labels == cv2.GC_PR_FGD)] = cv2.GC_PR_BGD
    for spots, label in ((marks.inside, cv2.GC_FGD), (marks.outside, cv2.GC_BGD)):
        for spot in spots:
            cv2.circle(labels, piece.cells(np.array(spot)), CUT_OUT.mark, int(label), -1)


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
            self.progress((self.part + share) / self.parts, sentence("Finding the object …"))


def _fitted(piece: _Piece, cut: Bools, frame: int) -> list[RotoShape]:
    """What was cut out of a piece as shapes on the picture: each outline with its holes after it."""
    soft = cv2.GaussianBlur(_covered(piece.pixels, cut), (0, 0), CUT_OUT.softness, borderType=cv2.BORDER_REPLICATE)
    found = shapes_from_mask(soft, frame, CUT_OUT.tolerance)
    if not found:
        raise RoamError(sentence("Nothing stands out there; drag a closer box around the object."))
    parts = cv2.connectedComponents(cut.astype(np.uint8), connectivity=4)[0] - 1
    # Largest first; what the border's mixed cells split off is no part.
    starts = [k for k, shape in enumerate(found) if shape.blend is not BlendMode.SUBTRACT]
    kept = found[: starts[parts]] if parts < len(starts) else found
    return [_placed(shape, lambda points: piece.corner + points * piece.cell) for shape in kept]


def _covered(pixels: UInt8, cut: Bools) -> Float32:
    """How much of each cell the object covers: near the border of the cut, how far its colour is the object's.

    The border's cells mix both sides, and the cut counts most of them as inside. Where the sides differ too little to
    tell, the cut's word holds.
    """
    inside, colours = cut.astype(np.uint8), pixels.astype(np.float32)
    kernel = np.ones((5, 5), dtype=np.uint8)
    core, beyond = cv2.erode(inside, kernel), cv2.erode(1 - inside, kernel)
    object_, background = _local_mean(colours, core), _local_mean(colours, beyond)
    across = object_ - background
    contrast = np.einsum("rcl,rcl->rc", across, across)
    share = np.einsum("rcl,rcl->rc", colours - background, across) / np.maximum(contrast, 1.0)
    told = (core == 0) & (beyond == 0) & (contrast > CUT_OUT.least_contrast**2)
    return np.where(told, np.clip(share, 0.0, 1.0), inside).astype(np.float32)


def _local_mean(colours: Float32, chosen: UInt8) -> Float32:
    """The mean colour `(rows, columns, 3)` of the chosen cells around each cell."""
    weight = chosen.astype(np.float32)
    total = cv2.boxFilter(colours * weight[:, :, None], -1, (CUT_OUT.local, CUT_OUT.local), normalize=False)
    count = cv2.boxFilter(weight, -1, (CUT_OUT.local, CUT_OUT.local), normalize=False)
    return np.asarray(total / np.maximum(count, 1.0)[:, :, None], dtype=np.float32)


def _placed(shape: RotoShape, place: Callable[[Array], Array]) -> RotoShape:
    return replace(shape, keys=tuple(replace(key, points=place(key.points)) for key in shape.keys))


def _cut(pixels: UInt8, labels: UInt8, told: _Told) -> Bools:
    """GrabCut from the first `labels`, round after round; True inside."""
    colours = cv2.GaussianBlur(pixels, (0, 0), CUT_OUT.smoothing)
    if not ((labels == cv2.GC_BGD) | (labels == cv2.GC_PR_BGD)).any():
        raise RoamError(
            sentence("The box leaves no background around the object; drag one that does not fill the picture.")
        )
    behind, before, least = np.zeros((1, 65)), np.zeros((1, 65)), CUT_OUT.least_share * _inside(labels).sum()
    cv2.setRNGSeed(0)  # The colours' first guess is drawn at random: the same box gives the same shape.
    for number in range(CUT_OUT.rounds):
        told.of(number / CUT_OUT.rounds)
        mode, last = cv2.GC_INIT_WITH_MASK if number == 0 else cv2.GC_EVAL, labels.copy()
        cv2.grabCut(colours, labels, None, behind, before, 1, mode)
        if _inside(labels).sum() < least:
            labels = last
            break
    told.of(1.0)
    return _inside(labels)


def _inside(labels: UInt8) -> Bools:
    return np.asarray((labels == cv2.GC_FGD) | (labels == cv2.GC_PR_FGD))


def _chosen(inside: Bools, piece: _Piece, marks: Marks) -> Bools:
    """The connected parts that are marked as inside, or else the largest one."""
    count, parts, stats, _ = cv2.connectedComponentsWithStats(inside.astype(np.uint8), connectivity=4)
    if count < 2:
        return inside
    rows, columns = inside.shape
    cells = [piece.cells(np.array(spot)) for spot in marks.inside]
    marked = {int(parts[row, column]) for column, row in cells if 0 <= row < rows and 0 <= column < columns} - {0}
    return np.isin(parts, list(marked or {1 + int(np.argmax(stats[1:, cv2.CC_STAT_AREA]))}))


def _box_of(region: Bools, whole: _Piece) -> tuple[Array, Array]:
    """The box for an object of which a region is known: wide enough that every kind of background is in it."""
    rows, columns = np.nonzero(region)
    low = whole.corner + np.array([columns.min(), rows.min()]) * whole.cell
    high = whole.corner + (np.array([columns.max(), rows.max()]) + 1) * whole.cell
    margin = np.maximum(
        (high - low) * CUT_OUT.around, CUT_OUT.nearby * np.array(whole.pixels.shape[1::-1]) * whole.cell
    )
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


def _seeded(piece: _Piece, region: Bools, low: Array, high: Array) -> UInt8:
    """First labels: the region is likely inside, its core surely; outside of the box `low`, `high` is background."""
    labels = np.full(region.shape, cv2.GC_BGD, dtype=np.uint8)
    (left, top), (right, bottom) = piece.cells(low), piece.cells(high)
    labels[max(top, 0) : bottom + 1, max(left, 0) : right + 1] = cv2.GC_PR_BGD
    labels[region] = cv2.GC_PR_FGD
    core = cv2.erode(region.astype(np.uint8), np.ones((3, 3), dtype=np.uint8), iterations=2)
    labels[core > 0] = cv2.GC_FGD
    return labels
