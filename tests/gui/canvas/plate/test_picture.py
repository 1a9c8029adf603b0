"""A picture at any zoom: squares when near, smooth when far, where it belongs."""

from __future__ import annotations

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QSizeF
from PySide6.QtGui import QImage, QPainter

from app.canvas.plate.backdrop import Backdrop, Below
from app.canvas.plate.picture import Picture
from app.paint.viewport import Viewport
from roam_core.arrays import Array, UInt8
from roam_core.media.colour import to_display
from roam_core.media.curves import LINEAR
from roam_core.media.looking import Channel, Look, Plate


def painted(pixels: UInt8, viewport: Viewport, width: int, height: int, size: QSizeF | None = None) -> UInt8:
    """What a black background of width x height looks like with the picture on it, (h, w, 3)."""
    background = QImage(width, height, QImage.Format.Format_RGB32)
    background.fill(0)
    picture = Picture(pixels)
    painter = QPainter(background)
    picture.paint(painter, viewport, size or picture.size, 1.0)
    painter.end()
    shown = np.frombuffer(background.constBits(), dtype=np.uint8).reshape(height, width, 4)
    return shown[:, :, 2::-1].copy()


def noise(height: int, width: int) -> UInt8:
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
    squares = painted(pixels, Viewport(2.0), 40, 32, QSizeF(20.0, 16.0))
    np.testing.assert_array_equal(squares, pixels.repeat(8, axis=0).repeat(8, axis=1))
    smooth = painted(pixels, Viewport(), 20, 16, QSizeF(20.0, 16.0))  # the plate's own pixels are no squares yet
    np.testing.assert_array_equal(smooth[[0, 0, -1, -1], [0, -1, 0, -1]], pixels[[0, 0, -1, -1], [0, -1, 0, -1]])
    assert np.abs(np.diff(smooth.astype(int), axis=1)).max() < np.abs(np.diff(pixels.astype(int), axis=1)).max()


def test_of_a_proxy_the_plates_own_values_are_told() -> None:
    light = np.arange(8 * 12 * 3, dtype=np.float32).reshape(8, 12, 3)
    picture = Picture(noise(4, 6), Plate(light, LINEAR))
    np.testing.assert_array_equal(picture.value(2.9, 1.6), light[3, 5])
    np.testing.assert_array_equal(picture.value(5.99, 3.99), light[7, 11])
    assert picture.looked_at(1, 1, Look(exposure=1.0)) != picture.looked_at(1, 1, Look())  # made of display values


def test_exposure_of_a_proxy_is_made_of_its_own_values() -> None:
    light = np.full((8, 8, 3), 4.0, dtype=np.float32)
    small = light[::2, ::2].copy()
    picture = Picture(to_display(small, LINEAR), Plate(light, LINEAR, small))
    assert picture.looked_at(3, 3, Look(exposure=-3.0)) == (188, 188, 188)


def test_grey_picture() -> None:
    grey = noise(4, 5)[:, :, 0].copy()
    np.testing.assert_array_equal(painted(grey, Viewport(), 5, 4), grey[:, :, None].repeat(3, axis=2))


def test_what_lies_far_outside_of_the_widget_costs_nothing_and_moves_nothing() -> None:
    pixels = noise(50, 60)
    for scale in (0.5, 1.0, 3.0):
        whole = painted(pixels, Viewport(scale), 200, 160)
        aside = painted(pixels, Viewport(scale, -8.0 * scale, -6.0 * scale), 200, 160)
        shift = round(8.0 * scale), round(6.0 * scale)
        inside = round(40 * scale), round(30 * scale)
        np.testing.assert_array_equal(
            aside[: inside[1], : inside[0]],
            whole[shift[1] : shift[1] + inside[1], shift[0] : shift[0] + inside[0]],
        )
        assert (painted(pixels, Viewport(scale, 500.0, 0.0), 200, 160) == 0).all()
        assert (painted(pixels, Viewport(scale, 0.0, -500.0), 200, 160) == 0).all()


def test_a_picture_stays_in_its_place_at_every_zoom() -> None:
    pixels = np.zeros((64, 64, 3), dtype=np.uint8)
    pixels[16:48, 24:56] = 250
    for scale in (0.25, 0.4, 0.7, 1.0, 1.6, 3.0):
        shown = painted(pixels, Viewport(scale, 5.0, 9.0), 220, 220)[..., 0].astype(float)
        rows, columns = np.nonzero(shown > 125)
        assert columns.mean() + 0.5 == pytest.approx(5.0 + 40.0 * scale, abs=0.75)
        assert rows.mean() + 0.5 == pytest.approx(9.0 + 32.0 * scale, abs=0.75)


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_no_more_is_resampled_than_the_screen_has_pixels(monkeypatch: pytest.MonkeyPatch, ratio: float) -> None:
    sizes: list[tuple[int, int]] = []
    warp = cv2.warpAffine

    def counted(pixels: UInt8, matrix: Array, size: tuple[int, int], **how: int) -> object:
        sizes.append(size)
        return warp(pixels, matrix, size, **how)

    monkeypatch.setattr(cv2, "warpAffine", counted)
    screen = QImage(round(100 * ratio), round(80 * ratio), QImage.Format.Format_RGB32)
    screen.fill(0)
    painter = QPainter(screen)
    painter.setWindow(0, 0, 100, 80)
    picture = Picture(noise(600, 800))
    Backdrop().paint(painter, Below(picture), Viewport(0.6, -90.0, -70.0), picture.size, ratio)
    painter.end()
    ((across, down),) = sizes
    assert 100 * ratio <= across <= 100 * ratio + 1
    assert 80 * ratio <= down <= 80 * ratio + 1


@pytest.mark.parametrize("scale", [0.5, 1.0, 4.0])
def test_a_look_changes_what_is_painted_and_not_the_picture(scale: float) -> None:
    pixels = noise(8, 8)
    picture, before = Picture(pixels), pixels.copy()
    background = QImage(32, 32, QImage.Format.Format_RGB32)
    background.fill(0)
    painter = QPainter(background)
    picture.paint(painter, Viewport(scale), picture.size, 1.0, Look(channel=Channel.GREEN))
    painter.end()
    shown = np.frombuffer(background.constBits(), dtype=np.uint8).reshape(32, 32, 4)
    assert (shown[..., 0] == shown[..., 1]).all()
    assert (shown[..., 1] == shown[..., 2]).all()
    assert shown.any()
    np.testing.assert_array_equal(picture.pixels, before)


def test_less_exposure_brings_back_what_is_brighter_than_white() -> None:
    light = np.full((6, 6, 3), 4.0, dtype=np.float32)
    light[:, 3:] = 2.0
    picture = Picture(to_display(light, LINEAR), Plate(light, LINEAR, light))
    assert picture.looked_at(0, 0, Look()) == picture.looked_at(5, 0, Look()) == (255, 255, 255)
    bright, dim = (picture.looked_at(x, 0, Look(exposure=-2.0))[0] for x in (0, 5))
    assert (bright, dim) == (255, 188)


def test_the_array_may_change_after_it_was_taken() -> None:
    pixels = noise(3, 3)
    before = pixels.copy()
    picture = Picture(pixels)
    pixels[:] = 0
    background = QImage(3, 3, QImage.Format.Format_RGB32)
    painter = QPainter(background)
    picture.paint(painter, Viewport(), picture.size, 1.0)
    painter.end()
    assert background.pixelColor(1, 1).getRgb()[:3] == tuple(before[1, 1].tolist())


def test_an_array_that_is_not_contiguous() -> None:
    pixels = noise(5, 7)[:, ::-1, ::-1]
    np.testing.assert_array_equal(painted(pixels, Viewport(), 7, 5), pixels)
