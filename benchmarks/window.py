"""The window's own speed: at 4K from a drag's mouse event to the painted frame, and playback; the start of the program.

The whole main window is up, 1600 x 1000, with the plate fitted into its viewer. A frame is painted when Qt has
delivered the paint event and handed the pixels to the screen (or to memory, offscreen).
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

import cv2
import numpy as np

from benchmarks import report
from benchmarks.mattes import scene
from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

SIZE = (4096, 2160)
WINDOW = (1600, 1000)
FRAMES = 24
"""Frames of the clip that is played; all of them fit into the cache."""
DRAGGED_POINTS = 200
MOVES = 120
"""Mouse events of the drag that is measured, after as many of a tenth to warm up."""
PLAYED_SECONDS = 4.0
FASTER_THAN_ANY = 200.0
"""Frames a second that are asked for when the most is measured."""
AIM_MILLISECONDS, AIM_FPS = 16.0, 24.0
SCREENS = {"offscreen": "in memory", "xcb": "X11 window"}
ROWS = (
    ("point drag: event to painted frame, median ms", "median", f"{AIM_MILLISECONDS:.0f}"),
    ("point drag: 90 % are faster than, ms", "ninetieth", "-"),
    ("point drag: processor ms of the window's thread, median", "busy", "-"),
    ("playback at 24 fps: frames shown a second", "shown", f"{AIM_FPS:.0f}"),
    ("playback at 24 fps: processor ms of the window's thread a frame", "spent", "-"),
    ("playback as fast as it goes: frames a second", "most", "-"),
    ("start: to the painted window, ms", "start", "-"),
    ("start: processor ms", "work", "-"),
)
ROUNDS = 3
"""How often two checkouts are measured in turn."""
START = """
import sys, tempfile, time
from pathlib import Path
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from app import style
from app.shell.main_window import MainWindow
application = QApplication(sys.argv[:1])
style.apply(application)
with tempfile.TemporaryDirectory() as folder:
    window = MainWindow(Path(folder))
    window.resize(1500, 940)
    window.show()
    QTest.qWaitForWindowExposed(window)
    window.grab()
    print(1000.0 * (time.monotonic() - float(sys.argv[1])), 1000.0 * time.process_time())
    window._leave()
    while window.isVisible():
        QTest.qWait(10)
"""
"""Opens the window, empty; tells the milliseconds since the time that it is given, and those of the processor."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `window` may be told."""
    parser.add_argument("--inside", action="store_true", help="measure in this process, on Qt's present platform")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")
    parser.add_argument(
        "--beside", type=Path, metavar="CHECKOUT", help="another checkout, measured in turn: told as ratios to it"
    )


def run(given: argparse.Namespace) -> None:
    """Measure offscreen and, where there is a display, in a window; each in a process of its own."""
    if given.inside:
        print(json.dumps(measured()))
        return
    from app.shell.launch import has_display

    platforms = ["offscreen", *(["xcb"] if has_display() and sys.platform.startswith("linux") else [])]
    title = (
        f"{DRAGGED_POINTS} points dragged over a plate of {SIZE[0]}x{SIZE[1]}; {FRAMES} cached frames of it played "
        f"with {len(list(scene().children))} shapes drawn. {report.circumstances()}."
    )
    if given.beside is not None:
        print(f"{title}\n\n{ratios(platforms, given.beside)}")
        return
    results = {platform: _in_a_process(platform) for platform in platforms}
    rows = [
        [f"{what}, {SCREENS[platform]}", f"{result[key]:.1f}", aim]
        for what, key, aim in ROWS
        for platform, result in results.items()
    ]
    table = report.table(["the window", "measured", "aim"], rows)
    report.write("window", f"{title}\n\n{table}", {"results": results}, publish=given.publish)


def ratios(platforms: Sequence[str], other: Path) -> str:
    """A table of this checkout's figures over the other's: medians of rounds in which both were measured in turn."""
    rows = []
    for platform in platforms:
        pairs = [(_in_a_process(platform), _in_a_process(platform, other)) for _ in range(ROUNDS)]
        for what, key, _ in ROWS:
            ours, theirs = (float(np.median([pair[which][key] for pair in pairs])) for which in (0, 1))
            rows.append([f"{what}, {SCREENS[platform]}", f"{ours:.1f}", f"{theirs:.1f}", f"{ours / theirs:.2f}"])
    return report.table(["the window", "here", "there", "ratio"], rows)


def measured() -> dict[str, float]:
    """All figures, in this process."""
    with tempfile.TemporaryDirectory() as folder, opened_window(Path(folder)) as window:
        laps, busy = (1000.0 * np.array(times) for times in zip(*drag_laps(window), strict=True))
        (shown, spent), (most, _) = (frames_a_second(window, fps) for fps in (AIM_FPS, FASTER_THAN_ANY))
    median, ninetieth = (float(lap) for lap in np.percentile(laps, [50, 90]))
    figures = {"median": median, "ninetieth": ninetieth, "busy": float(np.median(busy))}
    return figures | {"shown": shown, "spent": spent, "most": most}


class DrawnPlate:
    """A `PlateSource` of pictures that are drawn when they are asked for: blurred noise that glides."""

    missing: tuple[int, ...] = ()
    fps, pixel_aspect, colour_space, readers = 24.0, 1.0, "sRGB", 1
    layer, layers = "rgb", ("rgb",)

    def __init__(self, frames: int = FRAMES, size: tuple[int, int] = SIZE) -> None:
        self.frames, self.size, self.path = tuple(range(1, frames + 1)), size, Path("drawn")
        width, height = size
        noise = np.random.default_rng(0).integers(0, 256, (height // 8, width // 8, 3), dtype=np.uint8)
        self._picture = cv2.resize(noise, size, interpolation=cv2.INTER_CUBIC)

    def read(self, frame: int) -> UInt8:
        """The picture `(h, w, 3)` of a frame."""
        return np.roll(self._picture, 16 * frame, axis=1)

    @property
    def clip(self) -> Clip:
        """The project's reference to it."""
        return Clip(self.path, self.frames[0], self.frames[-1], self.size)


def ring(points: int = DRAGGED_POINTS) -> RotoShape:
    """A wavy ring of smooth points that fills most of the picture's height."""
    angle = np.arange(points) * 2.0 * np.pi / points
    outward = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    along = np.stack([-outward[:, 1], outward[:, 0]], axis=1) * (2.0 / points)
    radius = 0.4 * SIZE[1] * (1.0 + 0.1 * np.cos(9.0 * angle))
    where = np.stack([outward, outward - along, outward + along], axis=1)
    return RotoShape("ring", "Ring", (Keyframe(1, np.array(SIZE) / 2.0 + radius[:, None, None] * where),))


@contextmanager
def opened_window(state: Path) -> Iterator[MainWindow]:
    """The main window on the drawn plate, all of whose frames are in the cache."""
    from PySide6.QtTest import QTest
    from PySide6.QtWidgets import QApplication

    from app import style
    from app.shell.main_window import MainWindow

    application = QApplication.instance() or QApplication(sys.argv[:1])
    assert isinstance(application, QApplication)
    style.apply(application)
    window, plate = MainWindow(state), DrawnPlate()
    window.resize(*WINDOW)
    window.show()
    QTest.qWaitForWindowExposed(window)
    window.document.open(Project(clip=plate.clip), None)
    window.reader.open(plate)
    _live_until(lambda: len(window.reader.cached_frames()) == FRAMES, "the frames")
    window.canvas.fit()
    try:
        yield window
    finally:
        window._leave()
        _live_until(lambda: not window.isVisible(), "the window to close")
        window.deleteLater()


def drag_laps(window: MainWindow, moves: int = MOVES) -> list[tuple[float, float]]:
    """Seconds from each mouse event of a point's drag to the painted frame: by the clock, and of this thread's work."""
    from PySide6.QtCore import QEvent, QPointF, Qt
    from PySide6.QtGui import QMouseEvent
    from PySide6.QtWidgets import QApplication

    shape, canvas = ring(), window.canvas
    window.document.open(Project(root=Layer("root", "Root", (shape,)), clip=window.document.project.clip), None)
    window.view_state.select(frozenset([shape.id]))
    painted, left, none = _Painted(canvas), Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton
    start = canvas.image_to_widget(*shape.keys[0].points[0, 0].tolist())

    def send(kind: QEvent.Type, to: QPointF, button: Qt.MouseButton, held: Qt.MouseButton) -> None:
        where = to, QPointF(canvas.mapToGlobal(to))
        QApplication.sendEvent(canvas, QMouseEvent(kind, *where, button, held, Qt.KeyboardModifier.NoModifier))

    send(QEvent.Type.MouseMove, start, none, none)
    send(QEvent.Type.MouseButtonPress, start, left, left)
    laps = []
    for move in range(moves + moves // 10):
        to = start + QPointF(60.0 * np.sin(move / 9.0), 40.0 * np.sin(move / 13.0) + 8.0)
        QApplication.processEvents()
        count, began, spent = painted.count, time.perf_counter(), time.thread_time()
        send(QEvent.Type.MouseMove, to, none, left)
        while painted.count == count:
            QApplication.processEvents()
        laps.append((time.perf_counter() - began, time.thread_time() - spent))
    send(QEvent.Type.MouseButtonRelease, start, left, none)
    return laps[moves // 10 :]


def frames_a_second(window: MainWindow, fps: float, seconds: float = PLAYED_SECONDS) -> tuple[float, float]:
    """Different frames of the clip that were painted in a second while it was played at `fps`.

    The second figure is processor time of the window's thread for each of them, milliseconds.
    """
    canvas = window.canvas
    window.document.open(Project(root=scene(), clip=window.document.project.clip), None)
    window.playback.fps = fps
    shown: list[int] = []
    window.reader.picture.connect(lambda frame, _: shown.append(frame))
    painted = _Painted(canvas, lambda: shown[-1] if shown else None)
    window.playback.play()
    _live_until(lambda: painted.seen, "the first frame")
    began, spent, count = time.perf_counter(), time.thread_time(), painted.changes
    _live_until(lambda: time.perf_counter() - began >= seconds, "the clip to be played")
    elapsed, spent, changes = time.perf_counter() - began, time.thread_time() - spent, painted.changes - count
    window.playback.pause()
    return changes / elapsed, 1000.0 * spent / max(changes, 1)


def _Painted(canvas: Any, what: Callable[[], object] = lambda: None) -> Any:  # noqa: N802
    """Counts the paint events of a widget, and how often what it shows was another thing than before."""
    from PySide6.QtCore import QEvent, QObject

    class Painted(QObject):
        def __init__(self) -> None:
            super().__init__(canvas)
            self.count = self.changes = 0
            self.seen: object = None
            canvas.installEventFilter(self)

        def eventFilter(self, watched: QObject, event: QEvent) -> bool:  # noqa: N802
            if event.type() is QEvent.Type.Paint:
                self.count += 1
                self.changes += what() != self.seen
                self.seen = what()
            return False

    return Painted()


def _live_until(condition: Callable[[], object], what: str, patience: float = 120.0) -> None:
    """Let the window live until a condition holds."""
    from PySide6.QtCore import QEventLoop, QTimer

    deadline = time.monotonic() + patience
    while not condition():
        if time.monotonic() > deadline:
            raise RoamError(f"waited in vain for {what}")
        loop = QEventLoop()
        QTimer.singleShot(20, loop.quit)
        loop.exec()


def _in_a_process(platform: str, root: Path = report.ROOT) -> dict[str, float]:
    """The figures of Qt's platform `platform`, of the checkout `root`."""
    measures = [sys.executable, "-m", "benchmarks", "window", "--inside"]
    result: dict[str, float] = json.loads(_told(measures, platform, root).splitlines()[-1])
    told = [_told([sys.executable, "-c", START, str(time.monotonic())], platform, root) for _ in range(3)]
    starts = np.array([line.split() for line in told], dtype=float).min(axis=0)
    return result | {"start": float(starts[0]), "work": float(starts[1])}


def _told(command: list[str], platform: str, root: Path) -> str:
    """What a program of a checkout prints."""
    environment = os.environ | {"QT_QPA_PLATFORM": platform, "PYTHONPATH": str(root)}
    done = subprocess.run(command, env=environment, cwd=root, capture_output=True, text=True, check=False)
    if done.returncode:
        raise RoamError(f"the window could not be measured on {platform}:\n{done.stderr.strip()}")
    return done.stdout
