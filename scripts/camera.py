"""The hand and the camera of the documentation's pictures: opens the real window, points, drags, waits, photographs."""

from __future__ import annotations

import os
import shutil
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from scripts.virtual_display import virtual_display

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray
    from PySide6.QtCore import QPoint
    from PySide6.QtWidgets import QWidget

    from app.shell.main_window import MainWindow

    Vector = NDArray[np.float64]

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "images"
SIZE = (1280, 800)
QUALITY = 88
"""Of JPEG, for pictures with a plate in them; dialogs are PNG."""
PATIENCE = 120.0
"""Seconds after which the window is thought to be stuck; the first run compiles kernels and renders the shot."""


@contextmanager
def display() -> Iterator[bool]:
    """A display for Qt: the one that is there, or a virtual one. Gives False when there is neither."""
    from app.shell.launch import has_display

    if has_display():
        yield True
        return
    if shutil.which("Xvfb") is None:
        yield False
        return
    with virtual_display(1600, 1000) as name:
        os.environ["DISPLAY"] = name
        yield True


@contextmanager
def window(state: Path) -> Iterator[MainWindow]:
    """The application's window, as `roam` opens it."""
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    from app import style
    from app.jobs import warm_up
    from app.model.personal import Personal
    from app.shell.main_window import MainWindow

    application = QApplication(sys.argv[:1])
    application.setApplicationName("ROAM")
    style.apply(application)
    shown = MainWindow(state / "journal", Personal(state / "settings", state / "cache"))
    shown.resize(*SIZE)
    shown.show()
    QTest.qWaitForWindowExposed(shown)
    warm_up.start(shown.solver, shown.tracking.config)
    until(lambda: shown.solver.is_idle, "the engine to be compiled")
    try:
        yield shown
    finally:
        shown._leave()
        until(lambda: not shown.isVisible(), "the window to close")


def opened(shown: MainWindow, begin: Callable[[], object]) -> None:
    """Open something and wait until its first frame is there."""
    before = shown.document.project
    begin()
    until(lambda: shown.document.project is not before, "the project")
    until(lambda: shown.view_state.frame in shown.reader.cached_frames(), "the first frame")


def show_frame(shown: MainWindow, frame: int) -> None:
    """Go to a frame and wait for its picture."""
    shown.view_state.set_frame(frame)
    until(lambda: frame in shown.reader.cached_frames(), "the frame")


def close_up(shown: MainWindow) -> None:
    """Show the only shape as large as can be, none of its points selected."""
    (shape,) = shown.document.project.shapes
    shown.view_state.select(frozenset([shape.id]))
    shown.actions_by_id["view.fit_selection"].trigger()


def close_up_on_all(shown: MainWindow) -> None:
    """Show all shapes as large as can be, and then none of them selected."""
    shown.view_state.select(frozenset(shape.id for shape in shown.document.project.shapes))
    shown.actions_by_id["view.fit_selection"].trigger()
    shown.view_state.select(frozenset())


def hover(shown: MainWindow, position: Vector) -> None:
    """Move the pointer to an image position."""
    from PySide6.QtTest import QTest

    QTest.mouseMove(shown.canvas, on_screen(shown, position))


def anchors_of(shown: MainWindow) -> Vector:
    """The points of the only shape on the present frame, `(P, 2)` image positions."""
    (shape,) = shown.document.project.shapes
    return shape.at(shown.view_state.frame).points[:, 0]


def drag(shown: MainWindow, start: Vector, end: Vector) -> None:
    """Drag with the left button, image positions."""
    drag_on_screen(shown, on_screen(shown, start), on_screen(shown, end))


def drag_on_screen(shown: MainWindow, first: QPoint, last: QPoint) -> None:
    """Drag with the left button, positions in the viewer."""
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    canvas, left = shown.canvas, Qt.MouseButton.LeftButton
    QTest.mouseMove(canvas, first)
    QTest.mousePress(canvas, left, pos=first)
    QTest.mouseMove(canvas, (first + last) / 2)
    QTest.mouseMove(canvas, last)
    QTest.mouseRelease(canvas, left, pos=last)


def on_screen(shown: MainWindow, position: Vector) -> QPoint:
    """Where an image position lies in the viewer."""
    return shown.canvas.image_to_widget(float(position[0]), float(position[1])).toPoint()


def photograph(shown: QWidget, name: str, height: int | None = None) -> None:
    """Write the picture of a window, or of a part of it, when what it began to show is painted.

    Of its whole height, or only down to `height`.
    """
    live(600)
    save(shown, name, height)


def save(shown: QWidget, name: str, height: int | None = None) -> None:
    """Write its picture as it is now."""
    from PySide6.QtCore import QRect

    path = IMAGES / name
    picture = shown.grab(QRect(0, 0, shown.width(), shown.height() if height is None else height))
    if not picture.save(str(path), quality=QUALITY if path.suffix == ".jpg" else -1):
        raise SystemExit(f"screenshots: {path} cannot be written")
    size = path.stat().st_size / 1000.0
    print(f"Wrote {path.relative_to(IMAGES.parent.parent)}, {picture.width()}x{picture.height()}, {size:.0f} kB.")


def until(condition: Callable[[], object], what: str) -> None:
    """Let the window live until a condition holds."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > deadline:
            raise SystemExit(f"screenshots: waited in vain for {what}")
        live(20)


def live(milliseconds: int) -> None:
    """Let the window live for a while. Unlike `QTest.qWait`, a loop of Qt's lets the other threads run meanwhile."""
    from PySide6.QtCore import QEventLoop, QTimer

    loop = QEventLoop()
    QTimer.singleShot(milliseconds, loop.quit)
    loop.exec()
