"""A shot at a glance: every tenth frame with outlines drawn on it, in one picture, for the eye alone."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

import cv2
import numpy as np

from roam_core.arrays import Int32, UInt8

Drawn = tuple[Sequence[Int32], tuple[int, int, int]]
"""Closed polylines `(K, 2)` in whole pixels, and their colour."""

EVERY, COLUMNS, WIDTH = 10, 4, 427
"""Frames from tile to tile, tiles across, and the width of each in pixels."""
ORANGE, GREEN = (0, 160, 255), (80, 220, 80)
"""Blue, green, red: what was tracked, what is true."""


def contact_sheet(pictures: Path, mattes: Path, path: Path) -> None:
    """Write to `path` a sheet of every tenth frame and the last one, each with the outline of its matte.

    `mattes` holds `NAME.png` for the picture `NAME.*`; the first frame has none.
    """
    files = sorted(pictures.iterdir())[1:]
    write_sheet([_of_files(file, mattes / f"{file.stem}.png") for file in tenths(files)], path)


def tenths(frames: Sequence[Path] | Sequence[int]) -> list[Path] | list[int]:
    """Every tenth of the frames behind the first one, and the last."""
    chosen = list(frames[EVERY - 1 :: EVERY])
    return chosen if chosen and chosen[-1] == frames[-1] else [*chosen, frames[-1]]


def write_sheet(tiles: Sequence[UInt8], path: Path, columns: int = COLUMNS) -> None:
    """Tiles of one size side by side, row by row."""
    filled = [*tiles, *[np.zeros_like(tiles[0])] * (-len(tiles) % columns)]
    rows = [np.hstack(filled[k : k + columns]) for k in range(0, len(filled), columns)]
    quality = [cv2.IMWRITE_JPEG_QUALITY, 88] if path.suffix == ".jpg" else []
    cv2.imwrite(str(path), np.vstack(rows), quality)


def tile(image: UInt8, label: str, outlines: Sequence[Drawn]) -> UInt8:
    """A picture (h, w, 3) in OpenCV's order of channels, smaller, with closed polylines in their colours."""
    drawn = np.ascontiguousarray(image)
    for lines, colour in outlines:
        cv2.polylines(drawn, list(lines), True, colour, 2, cv2.LINE_AA)
    small = cv2.resize(drawn, (WIDTH, round(drawn.shape[0] * WIDTH / drawn.shape[1])), interpolation=cv2.INTER_AREA)
    cv2.putText(small, label, (8, 18), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255), 1, cv2.LINE_AA)
    return np.asarray(small, dtype=np.uint8)


def _of_files(picture: Path, matte: Path) -> UInt8:
    image, mask = cv2.imread(str(picture)), cv2.imread(str(matte), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    assert mask is not None
    rings, _ = cv2.findContours((mask > 127).astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    whole = [np.asarray(ring, dtype=np.int32) for ring in rings]
    return tile(np.asarray(image, dtype=np.uint8), picture.stem, [(whole, ORANGE)])
