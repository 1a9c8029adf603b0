"""Small line charts as PNG, drawn with OpenCV: enough for a look at a benchmark, no plotting library wanted."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import ArrayLike

from roam_core.arrays import Array, Int32, UInt8

Colour = tuple[int, int, int]

WIDTH, HEIGHT = 900, 480
LEFT, RIGHT, TOP, BOTTOM = 70, 210, 56, 54
"""Pixels around the plot: for the axes, the legend, the title."""
INK, GRID, PAPER = (60, 60, 60), (225, 225, 225), (255, 255, 255)
PALETTE: tuple[Colour, ...] = (
    (178, 114, 0),
    (0, 94, 213),
    (115, 158, 0),
    (167, 121, 204),
    (0, 159, 230),
    (66, 228, 240),
    (233, 180, 86),
    (0, 0, 0),
)
"""Okabe and Ito's colours, which the colour-blind can tell apart; blue, green, red."""
FONT = cv2.FONT_HERSHEY_SIMPLEX


@dataclass(frozen=True, eq=False)
class Line:
    """`y (K,)` over `x (K,)` under a name."""

    name: str
    x: Array
    y: Array


@dataclass(frozen=True, eq=False)
class Band:
    """The shade between `low (K,)` and `high (K,)` over `x (K,)`."""

    name: str
    x: Array
    low: Array
    high: Array


@dataclass(frozen=True)
class Axes:
    """Title and the names of the axes; the ranges come from what is drawn, or are given."""

    title: str
    across: str
    up: str
    up_range: tuple[float, float] | None = None


def line(name: str, x: ArrayLike, y: ArrayLike) -> Line:
    """A `Line` of anything that numpy takes for numbers."""
    return Line(name, np.asarray(x, dtype=np.float64), np.asarray(y, dtype=np.float64))


def write(path: Path, axes: Axes, lines: Sequence[Line], band: Band | None = None) -> None:
    """Draw the lines over the band and write the picture."""
    path.parent.mkdir(parents=True, exist_ok=True)
    cv2.imwrite(str(path), drawn(axes, lines, band))


def drawn(axes: Axes, lines: Sequence[Line], band: Band | None = None) -> UInt8:
    """The chart `(h, w, 3)`, blue first as OpenCV writes it."""
    picture = np.full((HEIGHT, WIDTH, 3), 255, dtype=np.uint8)
    x = np.concatenate([each.x for each in lines])
    y = np.concatenate([each.y for each in lines] + ([band.low, band.high] if band else []))
    across, up = _range(x), axes.up_range or _range(y)
    frame = _Frame(across, up)
    if band is not None:
        outline = np.vstack([frame.at(band.x, band.high), frame.at(band.x[::-1], band.low[::-1])])
        cv2.fillPoly(picture, [outline], (240, 222, 200), cv2.LINE_AA)
    _axes(picture, axes, frame)
    for k, each in enumerate(lines):
        cv2.polylines(picture, [frame.at(each.x, each.y)], False, PALETTE[k % len(PALETTE)], 2, cv2.LINE_AA)
    _legend(picture, [each.name for each in lines], band)
    return picture


@dataclass(frozen=True)
class _Frame:
    """Where values lie in the picture."""

    across: tuple[float, float]
    up: tuple[float, float]

    def at(self, x: Array, y: Array) -> Int32:
        """Pixels `(K, 2)`; values beyond the range stay at its border."""
        u = np.clip((x - self.across[0]) / (self.across[1] - self.across[0]), 0.0, 1.0)
        v = np.clip((y - self.up[0]) / (self.up[1] - self.up[0]), 0.0, 1.0)
        columns, rows = LEFT + u * (WIDTH - LEFT - RIGHT), HEIGHT - BOTTOM - v * (HEIGHT - TOP - BOTTOM)
        return np.round(np.stack([columns, rows], axis=1)).astype(np.int32)


def _range(values: Array) -> tuple[float, float]:
    finite = values[np.isfinite(values)]
    low, high = (float(finite.min()), float(finite.max())) if len(finite) else (0.0, 1.0)
    return (low, high) if high > low else (low - 0.5, high + 0.5)


def ticks(low: float, high: float, count: int = 6) -> Array:
    """Round numbers in a range, at most about `count` of them."""
    rough = (high - low) / count
    power = 10.0 ** np.floor(np.log10(rough))
    step = power * min((s for s in (1.0, 2.0, 5.0, 10.0) if s * power >= rough * 0.999), default=10.0)
    # Plus nothing: minus nought would be written as such.
    return np.asarray(np.arange(np.ceil(low / step - 1e-9), np.floor(high / step + 1e-9) + 1.0) * step + 0.0)


def _axes(picture: UInt8, axes: Axes, frame: _Frame) -> None:
    for value in ticks(*frame.across):
        (column, row), *_ = frame.at(np.array([value]), np.array([frame.up[0]]))
        cv2.line(picture, (column, TOP), (column, row), GRID, 1)
        _text(picture, f"{value:g}", (column, row + 18), centred=1)
    for value in ticks(*frame.up):
        (column, row), *_ = frame.at(np.array([frame.across[0]]), np.array([value]))
        cv2.line(picture, (column, row), (WIDTH - RIGHT, row), GRID, 1)
        _text(picture, f"{value:g}", (column - 8, row + 4), centred=2)
    cv2.rectangle(picture, (LEFT, TOP), (WIDTH - RIGHT, HEIGHT - BOTTOM), INK, 1)
    _text(picture, axes.title, (LEFT, 22), size=0.55)
    _text(picture, axes.across, ((LEFT + WIDTH - RIGHT) // 2, HEIGHT - 14), centred=1)
    _text(picture, axes.up, (8, TOP - 12))


def _legend(picture: UInt8, names: Sequence[str], band: Band | None) -> None:
    column = WIDTH - RIGHT + 14
    for k, name in enumerate(names):
        row = TOP + 10 + 20 * k
        cv2.line(picture, (column, row), (column + 20, row), PALETTE[k % len(PALETTE)], 2, cv2.LINE_AA)
        _text(picture, name, (column + 28, row + 4))
    if band is not None:
        row = TOP + 10 + 20 * len(names)
        cv2.rectangle(picture, (column, row - 6), (column + 20, row + 6), (240, 222, 200), -1)
        _text(picture, band.name, (column + 28, row + 4))


def _text(picture: UInt8, text: str, at: tuple[int, int], size: float = 0.42, centred: int = 0) -> None:
    """Text that begins at a place, or by `centred` has its middle (1) or its end (2) there."""
    (wide, _), _ = cv2.getTextSize(text, FONT, size, 1)
    cv2.putText(picture, text, (int(at[0]) - wide * centred // 2, int(at[1])), FONT, size, INK, 1, cv2.LINE_AA)
