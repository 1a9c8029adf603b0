"""The picture below a cut-out is read off the window's thread; what cannot be read is told once."""

from __future__ import annotations

import threading
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.canvas.plate import background
from app.canvas.plate.background import BackgroundLayer
from app.canvas.plate.picture import Picture
from app.model.viewing import Background, BackgroundKind
from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from tests.gui.waiting import WAIT


def of_image(name: str) -> Background:
    return Background(BackgroundKind.IMAGE, image=name)


def is_quiet() -> bool:
    """The thread that reads has ended: it lives for a moment after what it read has come."""
    return not any(thread.name == "ground" for thread in threading.enumerate())


def test_after_any_error_the_next_picture_is_read(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    told: list[type[BaseException]] = []
    monkeypatch.setattr(threading, "excepthook", lambda args: told.append(args.exc_type))

    def read(path: Path) -> UInt8:
        if path.name == "damaged.png":
            raise RoamError("damaged.png is damaged.")
        if path.name == "huge.png":
            raise MemoryError
        return np.zeros((2, 2, 3), dtype=np.uint8)

    monkeypatch.setattr(background, "_read", read)
    layer, refused = BackgroundLayer(), []
    layer.refused.connect(refused.append)
    for name in ("damaged.png", "huge.png", "sky.png"):
        with qtbot.waitSignal(layer.ready, timeout=WAIT):
            layer.of(of_image(name))
    assert isinstance(layer.of(of_image("sky.png")), Picture)
    layer.close()
    qtbot.waitUntil(is_quiet, timeout=WAIT)
    assert (refused, told) == (["damaged.png is damaged."], [MemoryError])


def test_a_picture_is_read_once_for_each_time_it_is_chosen(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch) -> None:
    read: list[str] = []
    monkeypatch.setattr(background, "_read", lambda path: read.append(path.name) or np.zeros((2, 2, 3), np.uint8))
    layer = BackgroundLayer()
    for choice in (1, 2):
        chosen = replace(of_image("sky.png"), choice=choice)
        with qtbot.waitSignal(layer.ready, timeout=WAIT):
            assert not isinstance(layer.of(chosen), Picture), "not that of before"
        assert isinstance(layer.of(chosen), Picture)
    layer.close()
    qtbot.waitUntil(is_quiet, timeout=WAIT)
    assert read == ["sky.png", "sky.png"]
