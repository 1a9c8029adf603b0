"""A shot at a glance: some of its frames with the matte's outline drawn on them, in one picture, for the eye alone."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

COLUMNS, ROWS, WIDTH = 4, 3, 427
"""Frames across and down, and the width of each in pixels."""


def contact_sheet(pictures: Path, mattes: Path, path: Path) -> None:
    """Write to `path` a sheet of frames, spread evenly over the shot, each with the outline of its matte.

    `mattes` holds `NAME.png` for the picture `NAME.*`; the first frame has none.
    """
    files = sorted(pictures.iterdir())[1:]
    chosen = np.unique(np.linspace(0, len(files) - 1, COLUMNS * ROWS).round().astype(int))
    tiles = [_tile(files[k], mattes / f"{files[k].stem}.png") for k in chosen]
    tiles += [np.zeros_like(tiles[0])] * (-len(tiles) % COLUMNS)
    rows = [np.hstack(tiles[k : k + COLUMNS]) for k in range(0, len(tiles), COLUMNS)]
    cv2.imwrite(str(path), np.vstack(rows), [cv2.IMWRITE_JPEG_QUALITY, 88])


def _tile(picture: Path, matte: Path) -> NDArray[np.uint8]:
    image, mask = cv2.imread(str(picture)), cv2.imread(str(matte), cv2.IMREAD_GRAYSCALE)
    assert image is not None
    assert mask is not None
    outline, _ = cv2.findContours((mask > 127).astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)
    cv2.drawContours(image, outline, -1, (0, 160, 255), 2)
    height = round(image.shape[0] * WIDTH / image.shape[1])
    tile = cv2.resize(image, (WIDTH, height), interpolation=cv2.INTER_AREA)
    cv2.putText(tile, picture.stem, (8, 18), cv2.FONT_HERSHEY_SIMPLEX, 0.5, (255, 255, 255), 1, cv2.LINE_AA)
    return np.asarray(tile, dtype=np.uint8)
