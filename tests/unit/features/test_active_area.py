"""Bars are found where there are some, whatever the codec left on them; what is dark at its edge is no bar."""

from __future__ import annotations

import cv2
import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.active_area import active_area
from roam_core.params.evidence import BarsParams

HEIGHT, WIDTH = 120, 200
WHOLE = Region(0, 0, WIDTH, HEIGHT)


@pytest.fixture
def scene() -> UInt8:
    noise = np.random.default_rng(3).normal(0.0, 60.0, (HEIGHT, WIDTH, 3)).astype(np.float32)
    return np.clip(110.0 + 4.0 * cv2.GaussianBlur(noise, (0, 0), 4.0), 40.0, 250.0).astype(np.uint8)


def found(picture: UInt8) -> Region:
    return active_area(PreparedFrame(picture), BarsParams())


def barred(scene: UInt8, window: Region, value: int = 0) -> UInt8:
    picture = np.full_like(scene, value)
    picture[window.slices] = scene[window.slices]
    return picture


@pytest.mark.parametrize("value", [0, 16], ids=["full range", "video black"])
@pytest.mark.parametrize(
    "window",
    [
        Region(0, 15, WIDTH, HEIGHT - 15),
        Region(70, 0, 130, HEIGHT),
        Region(30, 20, WIDTH - 30, HEIGHT - 20),
        Region(1, 0, WIDTH - 6, HEIGHT - 2),
        WHOLE,
    ],
    ids=["letterbox", "pillarbox", "all around", "edges of a capture", "none"],
)
def test_bars_are_found_to_the_line(scene: UInt8, window: Region, value: int) -> None:
    assert found(barred(scene, window, value)) == window


@pytest.mark.parametrize("quality", [95, 60])
def test_a_codec_may_have_been_at_work(scene: UInt8, quality: int) -> None:
    window = Region(0, 16, WIDTH, HEIGHT - 16)
    _, coded = cv2.imencode(".jpg", barred(scene, window, 16), [cv2.IMWRITE_JPEG_QUALITY, quality])
    assert found(np.asarray(cv2.imdecode(coded, cv2.IMREAD_COLOR), dtype=np.uint8)) == window


def test_what_is_dark_at_its_edge_has_no_bar(scene: UInt8) -> None:
    """A night sky over a ridge; one over a straight horizon, of which little is lit; a black frame."""
    ridge = scene.copy()
    for column, height in enumerate(30 + 12 * np.sin(np.arange(WIDTH) / 9.0)):
        ridge[: int(height), column] = 2
    assert found(ridge) == WHOLE
    shore = scene.copy()
    shore[:40] = 2
    shore[40:100, : int(0.7 * WIDTH)] = 5
    assert found(shore) == WHOLE
    assert found(np.zeros_like(scene)) == WHOLE
