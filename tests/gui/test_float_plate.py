"""A scene-linear plate in the whole window: its own values in the status bar, light above white by less exposure."""

from __future__ import annotations

import threading
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.panels.bars.readout import Readout
from roam_core.arrays import Float32, Image
from roam_core.media import looking
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window

SIZE, LIGHT = (64, 48), (3.0, 0.5, 0.25)


def write_light(folder: Path) -> Path:
    """Three frames of one colour, half floats, brighter than white in red."""
    folder.mkdir()
    pixels = np.full((SIZE[1], SIZE[0], 3), LIGHT, dtype=np.float32)
    for frame in range(1001, 1004):
        target = oiio.ImageOutput.create(str(folder / f"light.{frame}.exr"))
        target.open(str(folder / f"light.{frame}.exr"), oiio.ImageSpec(*SIZE, 3, "half"))
        target.write_image(pixels)
        target.close()
    return folder


def test_what_lies_above_white_is_told_and_brought_back(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_light(tmp_path / "light"), tmp_path / "journal") as window:
        canvas, readout = window.canvas, window.findChild(Readout)
        spot = canvas.image_to_widget(20.5, 30.5).toPoint()
        qtbot.mouseMove(canvas, spot)
        assert readout.text().split()[4:] == ["R", "3.000", "G", "0.500", "B", "0.250"]
        assert canvas.grab().toImage().pixelColor(spot) == QColor(255, 188, 137)
        canvas.viewing.set_look(exposure=-2.0)
        qtbot.waitUntil(
            lambda: canvas.grab().toImage().pixelColor(spot) == QColor(225, 99, 71), timeout=WAIT
        )  # made on the worker
        assert readout.text().split()[4:] == ["R", "3.000", "G", "0.500", "B", "0.250"]


def test_half_floats_are_made_ready_for_a_view_beside_the_windows_thread(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads: set[threading.Thread] = set()
    unit_floats = looking.unit_floats

    def watched(values: Image) -> Float32:
        threads.add(threading.current_thread())
        return unit_floats(values)

    with opened_window(qtbot, write_light(tmp_path / "light"), tmp_path / "journal") as window:
        monkeypatch.setattr(looking, "unit_floats", watched)
        spot = window.canvas.image_to_widget(20.5, 30.5).toPoint()
        before = window.canvas.grab().toImage().pixelColor(spot)
        window.canvas.viewing.set_look(view=("sRGB - Display", "ACES 2.0 - SDR 100 nits (Rec.709)"))
        qtbot.waitUntil(lambda: window.canvas.grab().toImage().pixelColor(spot) != before, timeout=WAIT)
        made = {thread for thread in threads if thread is not threading.main_thread()}
        assert made
