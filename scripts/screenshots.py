"""The pictures of the documentation: the real window on the demo shot, photographed. `make screenshots` runs this.

Takes the display that is there, or starts a virtual one where there is none. Settings, autosaves and the log of the
person who runs it stay untouched: the window gets a state folder of its own.
"""

from __future__ import annotations

import os
import shutil
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING

from scripts.virtual_display import virtual_display

if TYPE_CHECKING:
    from PySide6.QtWidgets import QWidget

    from app.main_window import MainWindow

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "images"
SIZE = (1440, 900)
TRACKED_TO, LOOKED_AT = 1024, 1012
DRAWN_POINTS = 11
"""Points of the outline that are drawn when the picture of drawing is taken."""
PATIENCE = 120.0
"""Seconds after which the window is thought to be stuck; the first run compiles kernels and renders the shot."""


def main() -> int:
    """Take all pictures. Returns the exit code."""
    with tempfile.TemporaryDirectory() as state, display() as found:
        if not found:
            print(
                "screenshots: there is no display and no Xvfb; install xvfb or log in with a display.", file=sys.stderr
            )
            return 1
        os.environ["XDG_STATE_HOME"] = state
        IMAGES.mkdir(parents=True, exist_ok=True)
        with window(Path(state)) as shown:
            photograph_drawing(shown)
            photograph_tracking(shown)
            photograph_doubt(shown)
            photograph_export(shown)
    return 0


@contextmanager
def display() -> Iterator[bool]:
    """A display for Qt: the one that is there, or a virtual one. Gives False when there is neither."""
    from app.launch import has_display

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
    from app.main_window import MainWindow

    application = QApplication(sys.argv[:1])
    application.setApplicationName("ROAM")
    style.apply(application)
    shown = MainWindow(state / "autosave")
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


def photograph_drawing(shown: MainWindow) -> None:
    """A Bezier shape around the manta, half drawn with real presses and drags."""
    from PySide6.QtCore import QPoint, Qt
    from PySide6.QtTest import QTest

    from resources import demo
    from roam_core.cli.demo import demo_frames

    frames = demo_frames()
    opened(shown, lambda: shown.files.open(frames))
    shown.actions_by_id["tool.bezier"].trigger()
    canvas, left = shown.canvas, Qt.MouseButton.LeftButton

    def on_screen(position: tuple[float, float]) -> QPoint:
        return canvas.image_to_widget(*position).toPoint()

    points = demo.true_points(demo.FIRST)
    for anchor, _, out in points[:DRAWN_POINTS]:
        QTest.mouseMove(canvas, on_screen(anchor))
        QTest.mousePress(canvas, left, pos=on_screen(anchor))
        QTest.mouseMove(canvas, (on_screen(anchor) + on_screen(out)) / 2)
        QTest.mouseMove(canvas, on_screen(out))
        QTest.mouseRelease(canvas, left, pos=on_screen(out))
    QTest.mouseMove(canvas, on_screen(points[DRAWN_POINTS, 0]))
    photograph(shown, "drawing")
    shown.actions_by_id["tool.select"].trigger()


def photograph_tracking(shown: MainWindow) -> None:
    """The demo as it opens, tracked part of the way: the plate with the shape, and the matte."""
    from resources import demo

    opened(shown, shown.files.open_demo)
    shown.view_state.set_play_range(demo.FIRST, TRACKED_TO + 1)
    shown.actions_by_id["track.forward"].trigger()
    until(lambda: shown.propagation.is_running, "the engine to begin")
    until(lambda: not shown.propagation.is_running, "the engine to end")
    shown.view_state.set_play_range(demo.FIRST, demo.LAST + 1)
    seen: list[int] = []
    shown.reader.picture.connect(lambda frame, _: seen.append(frame))
    shown.view_state.set_frame(LOOKED_AT)
    until(lambda: LOOKED_AT in seen, "the frame")
    photograph(shown, "window")
    rendered: list[bool] = []
    shown.canvas.matte_ready.connect(lambda: rendered.append(True))
    shown.actions_by_id["view.matte"].trigger()
    until(lambda: rendered, "the matte")
    photograph(shown, "matte")


def photograph_doubt(shown: MainWindow) -> None:
    """The frame of the tracked demo that the engine trusts least, in the confidence view."""
    shown.actions_by_id["view.confidence"].trigger()
    shown.actions_by_id["track.most_doubtful"].trigger()
    frame = shown.view_state.frame
    until(lambda: frame in shown.reader.cached_frames(), "the most doubtful frame")
    photograph(shown, "confidence")
    shown.actions_by_id["view.overlay"].trigger()


def photograph_export(shown: MainWindow) -> None:
    """The export dialog on the tracked demo, with the options of mattes."""
    from app.export_dialog import MATTES, ExportDialog

    shown.actions_by_id["file.export"].trigger()
    dialog = shown.findChild(ExportDialog)
    assert dialog is not None
    dialog.target.setText("shots/demo/demo.nk")
    dialog.choose(MATTES)
    dialog.target.setText("shots/demo/mattes")
    photograph(dialog, "export")
    dialog.close()


def opened(shown: MainWindow, begin: Callable[[], object]) -> None:
    """Open something and wait until its first frame is there."""
    before = shown.document.project
    begin()
    until(lambda: shown.document.project is not before, "the project")
    until(lambda: shown.view_state.frame in shown.reader.cached_frames(), "the first frame")


def photograph(shown: QWidget, name: str) -> None:
    """Write the window's picture when what it began to show is painted."""
    live(600)
    path = IMAGES / f"{name}.png"
    picture = shown.grab()
    if not picture.save(str(path)):
        raise SystemExit(f"screenshots: {path} cannot be written")
    print(f"Wrote {path.relative_to(IMAGES.parent.parent)}, {picture.width()}x{picture.height()}.")


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


if __name__ == "__main__":
    sys.exit(main())
