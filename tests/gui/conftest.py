"""Fixtures of the window's tests: no screen, a fresh document, and nothing that survives its test."""

from __future__ import annotations

import gc
import os
import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

os.environ.setdefault("QT_QPA_PLATFORM", "offscreen")

from PySide6.QtCore import QCoreApplication, QEvent, QLocale, QThread, QTimer
from PySide6.QtWidgets import QApplication, QComboBox
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.view import CanvasView
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry import bezier
from roam_core.roto import Clip, Project
from tests.gui.hand import Hand
from tests.gui.watchdog import WatchedApplication


@pytest.fixture(scope="session")
def qapp_cls() -> type[QApplication]:
    """The application of all tests: it notes which events held it up."""
    return WatchedApplication


@pytest.fixture(scope="session", autouse=True)
def first_things(qapp: QApplication) -> None:
    """What the program does as it starts: Qt makes fonts and the parts of its style; kernels are loaded."""
    QLocale.setDefault(QLocale.c())  # macOS asks its settings, not the environment
    bezier.flatten(np.array([[[0.0, 0.0]] * 3, [[9.0, 0.0]] * 3, [[9.0, 9.0]] * 3]))
    box = QComboBox()
    box.addItem("first")
    box.show()
    qapp.processEvents()
    box.close()


@pytest.fixture(autouse=True)
def nothing_blocks(qapp: WatchedApplication, request: pytest.FixtureRequest) -> Iterator[None]:
    """With `--watch`, fail a test in which one event held the window's thread for longer than goes unnoticed."""
    if not request.config.getoption("--watch"):
        yield
        return
    with qapp.watching() as blocks:
        yield
    assert not blocks, f"the window's thread was blocked: {'; '.join(map(str, blocks))}"


@pytest.fixture(autouse=True)
def nothing_survives(qapp: QApplication) -> Iterator[None]:
    """Fail a test that leaves a thread, a running timer or a top-level widget behind."""
    gc.freeze()  # Whatever was there before is not looked through again: only what this test makes.
    threads, widgets = set(threading.enumerate()), set(QApplication.topLevelWidgets())
    yield
    _let_go()
    running = [item for item in gc.get_objects() if isinstance(item, QThread | QTimer) and _is_running(item)]
    gc.unfreeze()  # What stayed frozen would never be freed, and OpenImageIO would list it at the end as leaked.
    new_widgets = [widget for widget in QApplication.topLevelWidgets() if widget not in widgets]
    assert not new_widgets, f"widgets survive the test: {new_widgets}"
    new_threads = [thread for thread in threading.enumerate() if thread not in threads and not _is_kept(thread)]
    assert not new_threads, f"threads survive the test: {new_threads}"
    assert not running, f"threads or timers run on after the test: {running}"


@pytest.fixture
def runner(qtbot: QtBot) -> Iterator[Runner]:
    """One worker thread, ended with the test."""
    runner = Runner("worker")
    yield runner
    assert runner.close()


@pytest.fixture
def document(qapp: QApplication) -> Document:
    """An empty document."""
    return Document()


@pytest.fixture
def view_state(qapp: QApplication) -> ViewState:
    """A view state on frame 1."""
    return ViewState()


@pytest.fixture
def canvas(document: Document, view_state: ViewState, qtbot: QtBot) -> CanvasView:
    """A canvas on a grey plate of 200 x 150 pixels, fitted at 200 %: image (x, y) lies at widget (24 + 2x, 24 + 2y)."""
    document.open(Project(clip=Clip(Path("plate"), 1, 20, (200, 150))), None)
    view = CanvasView(document, view_state)
    qtbot.addWidget(view)
    view.resize(448, 348)
    view.set_image(1, np.full((150, 200, 3), 100, dtype=np.uint8))
    view.show()
    view.setFocus()
    Actions(view, view, load_keymap()).connect_all(view.handlers())
    return view


@pytest.fixture
def hand(canvas: CanvasView) -> Hand:
    """The artist's hand over `canvas`."""
    return Hand(canvas)


def _let_go() -> None:
    """Deliver what `deleteLater` put off, and collect what only cycles hold."""
    gc.collect()
    QCoreApplication.sendPostedEvents(None, QEvent.Type.DeferredDelete)
    QCoreApplication.processEvents()


def _is_kept(thread: threading.Thread) -> bool:
    """A thread of the engine that waits for more work (`roam_core.threads`), or one of Qt that Python has met.

    That ends with its QThread, which is looked at by itself.
    """
    return thread.name.startswith(("rows", "Dummy-"))


def _is_running(item: QThread | QTimer) -> bool:
    if not isValid(item):
        return False
    if isinstance(item, QTimer):
        return item.isActive()
    return item.isRunning() and item is not QThread.currentThread()
