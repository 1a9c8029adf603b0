"""A picture at any zoom: squares when near, smooth when far, where it belongs."""

from __future__ import annotations

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import QSizeF
from PySide6.QtGui import QImage, QPainter

from app.canvas.picture import Picture
from app.canvas.viewport import Viewport


def painted(
    pixels: NDArray[np.uint8], viewport: Viewport, width: int, height: int, size: QSizeF | None = None
) -> NDArray[np.uint8]:
    """What a black ground of width x height looks like with the picture on it, (h, w, 3)."""
    ground = QImage(width, height, QImage.Format.Format_RGB32)
    ground.fill(0)
    picture = Picture(pixels)
    painter = QPainter(ground)
    picture.paint(painter, viewport, size or picture.size, 1.0)
    painter.end()
    shown = np.frombuffer(ground.constBits(), dtype=np.uint8).reshape(height, width, 4)
    return shown[:, :, 2::-1].copy()


def noise(height: int, width: int) -> NDArray[np.uint8]:
    return np.random.default_rng(0).integers(0, 256, (height, width, 3), dtype=np.uint8)


def test_pixels_are_themselves_at_100_percent() -> None:
    pixels = noise(7, 9)
    np.testing.assert_array_equal(painted(pixels, Viewport(), 9, 7), pixels)


def test_enlarged_pixels_are_squares() -> None:
    pixels = noise(4, 5)
    np.testing.assert_array_equal(painted(pixels, Viewport(4.0), 20, 16), pixels.repeat(4, axis=0).repeat(4, axis=1))


def test_slightly_enlarged_pixels_are_smooth() -> None:
    pixels = np.zeros((4, 4, 3), dtype=np.uint8)
    pixels[:, 2:] = 200
    row = painted(pixels, Viewport(1.5), 6, 6)[3, :, 0]
    assert ((row > 0) & (row < 200)).any()


def test_far_away_pixels_are_averaged() -> None:
    pixels = np.zeros((64, 64, 3), dtype=np.uint8)
    pixels[::2] = 200
    shown = painted(pixels, Viewport(1 / 8), 8, 8)
    assert np.abs(shown.astype(int) - 100).max() <= 3


def test_proxy_covers_the_full_size() -> None:
    pixels = noise(4, 5)
    shown = painted(pixels, Viewport(), 20, 16, QSizeF(20.0, 16.0))
    np.testing.assert_array_equal(shown, pixels.repeat(4, axis=0).repeat(4, axis=1))


def test_grey_picture() -> None:
    grey = noise(4, 5)[:, :, 0].copy()
    np.testing.assert_array_equal(painted(grey, Viewport(), 5, 4), grey[:, :, None].repeat(3, axis=2))


def test_grid_between_large_pixels_only() -> None:
    flat = np.full((3, 3, 3), 40, dtype=np.uint8)
    assert (painted(flat, Viewport(15.0), 45, 45) == 40).all()
    gridded = painted(flat, Viewport(20.0), 60, 60)
    assert (gridded[5:15, 5:15] == 40).all()
    assert (gridded[10, 18:22] != 40).any()


def test_the_array_may_change_after_it_was_taken() -> None:
    pixels = noise(3, 3)
    before = pixels.copy()
    picture = Picture(pixels)
    pixels[:] = 0
    ground = QImage(3, 3, QImage.Format.Format_RGB32)
    painter = QPainter(ground)
    picture.paint(painter, Viewport(), picture.size, 1.0)
    painter.end()
    assert ground.pixelColor(1, 1).getRgb()[:3] == tuple(before[1, 1].tolist())


def test_an_array_that_is_not_contiguous() -> None:
    pixels = noise(5, 7)[:, ::-1, ::-1]
    np.testing.assert_array_equal(painted(pixels, Viewport(), 7, 5), pixels)
