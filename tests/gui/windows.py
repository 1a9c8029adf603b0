"""A tiny clip and a window on it, for the tests that need the whole of the application."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.dialogs.mask_dialog import MaskDialog
from app.dialogs.palette import Palette
from app.features.clipboards.paste_range import PasteRangeDialog
from app.features.verbs.shift_dialog import ShiftDialog
from app.features.verbs.steady_dialog import SteadyDialog
from app.files import files
from app.model.personal import Personal
from app.shell.main_window import MainWindow
from app.tools.edit.numbers import NumbersDialog
from roam_core.media.sequence import ImageSequence
from roam_core.propagate import run
from roam_core.roto import Project, RotoShape, file
from tests.gui.waiting import WAIT

FIRST, COUNT, SIZE = 1001, 8, (160, 120)
DIALOGS = ("edit.settings", "edit.keymap", "help.keys", "help.about", "help.report", "file.export")
"""Actions that open a dialog."""


def centre(frame: int) -> tuple[float, float]:
    """The middle of the disc: it moves by (2, 1) pixels a frame."""
    return 60.0 + 2.0 * (frame - FIRST), 50.0 + (frame - FIRST)


def write_clip(folder: Path, count: int = COUNT) -> Path:
    """A light disc of radius 24 on a dark, textured background, as `plate.1001.png` and so on."""
    folder.mkdir(parents=True)
    width, height = SIZE
    background = cv2.GaussianBlur(np.random.default_rng(7).uniform(20, 90, (height, width, 3)), (0, 0), 2)
    for frame in range(FIRST, FIRST + count):
        picture = background.astype(np.uint8)
        x, y = centre(frame)
        cv2.circle(picture, (round(x * 16), round(y * 16)), 24 * 16, (210, 190, 170), -1, cv2.LINE_AA, 4)
        assert cv2.imwrite(str(folder / f"plate.{frame}.png"), picture)
    return folder


@contextmanager
def opened_window(
    qtbot: QtBot, path: Path | None, state: Path, personal: Personal | None = None
) -> Iterator[MainWindow]:
    """A shown window with a clip or project open; closed, its changes thrown away, at the end."""
    window = MainWindow(state, personal)
    window.resize(1000, 700)
    try:
        with qtbot.waitExposed(window, timeout=WAIT):
            window.show()
        if path is not None:
            with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
                window.files.open(path)
        yield window
    finally:
        window._leave()
        qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
        window.deleteLater()


class Gate:
    """Holds up what opens, as a function of `app.files.files` reads it, until it is opened."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, function: str) -> None:
        self.reached, self.open = threading.Event(), threading.Event()
        read = getattr(files, function)

        def slow(*args: Any) -> Any:
            self.reached.set()
            assert self.open.wait(WAIT / 1000)
            return read(*args)

        monkeypatch.setattr(files, function, slow)


@contextmanager
def nothing_slow_in_the_window_thread(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """Record every decoding, solving and saving; afterwards none may have run in the window's thread."""
    calls: list[tuple[str, bool]] = []

    def watched(name: str, function: Any) -> Any:
        def call(*args: Any, **kwargs: Any) -> Any:
            calls.append((name, threading.current_thread() is threading.main_thread()))
            return function(*args, **kwargs)

        return call

    def watched_track(*args: Any, **kwargs: Any) -> Iterator[Any]:
        for result in original_track(*args, **kwargs):
            calls.append(("solve", threading.current_thread() is threading.main_thread()))
            yield result

    original_track = run.track
    monkeypatch.setattr(ImageSequence, "read", watched("decode", ImageSequence.read))
    monkeypatch.setattr(run, "track", watched_track)
    monkeypatch.setattr(file, "save", watched("save", file.save))
    names: list[str] = []
    yield names
    names.extend(name for name, _ in calls)
    assert [name for name, in_window in calls if in_window] == []


def dialogs_of(window: MainWindow) -> Iterator[QWidget]:
    """The dialogs that open without a file and the palette, shown one after the other."""
    for name in DIALOGS:
        before = {each for each in QApplication.topLevelWidgets() if each.isVisible()}
        window.actions_by_id[name].trigger()
        opened = [each for each in QApplication.topLevelWidgets() if each.isVisible() and each not in before]
        assert opened, name
        yield from opened
        for dialog in opened:
            dialog.close()
    window.actions_by_id["help.palette"].trigger()
    palette = window.findChild(Palette)
    assert palette is not None
    assert palette.isVisible()
    yield palette
    palette.hide()
    in_out = FIRST, FIRST + COUNT
    shift = ShiftDialog([FIRST, FIRST + 4], [FIRST], None)
    for made in (
        MaskDialog("masks", SIZE), PasteRangeDialog(in_out), SteadyDialog(2, in_out), NumbersDialog(), shift
    ):  # fmt: skip
        made.show()
        yield made
        made.close()
        made.deleteLater()


def widget_point(window: MainWindow, position: tuple[float, float]) -> QPoint:
    """Where an image position lies in the viewer."""
    return window.canvas.image_to_widget(*position).toPoint()


def click(qtbot: QtBot, window: MainWindow, position: tuple[float, float]) -> None:
    """A click of the left button at an image position."""
    point = widget_point(window, position)
    qtbot.mouseMove(window.canvas, point)
    qtbot.mouseClick(window.canvas, Qt.MouseButton.LeftButton, pos=point)


def drag(qtbot: QtBot, window: MainWindow, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press, move and release between two image positions."""
    first, last = widget_point(window, start), widget_point(window, end)
    qtbot.mouseMove(window.canvas, first)
    qtbot.mousePress(window.canvas, Qt.MouseButton.LeftButton, pos=first)
    for point in (first + (last - first) / 2, last):
        qtbot.mouseMove(window.canvas, point)
    qtbot.mouseRelease(window.canvas, Qt.MouseButton.LeftButton, pos=last)


def shape(project: Project) -> RotoShape:
    """The only shape."""
    (only,) = project.shapes
    return only
