"""Anything at all in the whole window, offscreen: random actions, presses, drags, keys and words, in dialogs too."""

from __future__ import annotations

import argparse
import faulthandler
import random
import subprocess
import sys
import tempfile
import threading
import time
import traceback
from collections.abc import Callable
from pathlib import Path
from typing import IO, TYPE_CHECKING, Any

from PySide6.QtCore import QObject, QPoint, QPointF, Qt, QTimer, QtMsgType, qInstallMessageHandler
from PySide6.QtGui import QDesktopServices, QWheelEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from tests.conftest import ROOT
from tests.endurance.artist import SQUARE
from tests.endurance.environment import environment
from tests.gui.windows import write_clip

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

PACE = 5
"""Milliseconds between two steps."""
FRAMES = 8
LEAVING = {"file.quit", "help.report"}
"""Actions that end the program or tell of it to others."""
HARMLESS = ("This plugin does not support", "propagateSizeHints", "QFont::setPointSize")
"""How what Qt says begins where that is no fault: there is no screen."""
KEYS = (
    *(Qt.Key.Key_Escape, Qt.Key.Key_Return, Qt.Key.Key_Tab, Qt.Key.Key_Backspace, Qt.Key.Key_Delete, Qt.Key.Key_Space),
    *(Qt.Key.Key_Left, Qt.Key.Key_Right, Qt.Key.Key_Up, Qt.Key.Key_Down, Qt.Key.Key_Home, Qt.Key.Key_End),
    *map(Qt.Key, range(Qt.Key.Key_A.value, Qt.Key.Key_Z.value + 1)),
    *map(Qt.Key, range(Qt.Key.Key_0.value, Qt.Key.Key_9.value + 1)),
)
HELD = (
    *(Qt.KeyboardModifier.NoModifier,) * 6,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.AltModifier,
    Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.AltModifier,
)
WORDS = ("12", "-3.5", "2,5", "arm", "1e9", "", "1001-1004", "x" * 300)
LAST_STEPS = 25
"""Steps that are told of where something fails."""


class Monkey(QObject):
    """Takes random steps; the same seed the same, but for what runs beside.

    `notes` gets each step before it is taken, so that what ended the program is known.
    """

    def __init__(self, window: MainWindow, folder: Path, given: argparse.Namespace, notes: IO[str]) -> None:
        super().__init__(window)
        self._window, self._folder, self._notes = window, folder, notes
        self._random, self._until = random.Random(given.seed), time.monotonic() + 60.0 * given.minutes
        self._pressed: QWidget | None = None
        self.steps, self.failure = 0, ""
        window.tracking.config = "baseline"
        self._steps: tuple[Callable[[QWidget], object], ...] = (
            *(self._act,) * 6,
            *(self._click,) * 6,
            *(self._drag,) * 5,
            *(self._press,) * 5,
            *(self._type,) * 2,
            self._double_click,
            self._right_click,
            self._wheel,
            self._resize,
            self._draw,
        )

    def begin(self) -> None:
        self._window.files.open(self._folder / "plate")
        QTimer.singleShot(PACE, self._step)

    def fail(self, what: str) -> None:
        """Something went wrong; the first of it counts."""
        self.failure = self.failure or what

    def _step(self) -> None:
        if self.failure or time.monotonic() > self._until:
            for widget in (QApplication.activePopupWidget(), QApplication.activeModalWidget()):
                if widget is not None:
                    widget.close()
            self._window.leave_unasked()
            QTimer.singleShot(PACE, self._step)
            return
        QTimer.singleShot(PACE, self._step)  # before the step, which may wait for the answer to a question
        target = QApplication.activePopupWidget() or QApplication.activeModalWidget()
        if target is None:
            shown = [each for each in QApplication.topLevelWidgets() if each.isVisible()]
            target = self._random.choice([*shown, *(self._window,) * 3])
        step = self._random.choice(self._steps)
        self.steps += 1
        self._notes.write(f"{self.steps} {step.__name__} in {_told(target)}")
        step(target)
        self._notes.write("\n")
        self._notes.flush()

    def _note(self, what: str) -> None:
        self._notes.write(f": {what}")
        self._notes.flush()

    # ---- steps

    def _act(self, _: QWidget) -> None:
        if QApplication.activeModalWidget() is None:
            name = self._random.choice([each for each in self._window.actions_by_id if each not in LEAVING])
            self._note(name)
            self._window.actions_by_id[name].trigger()

    def _draw(self, _: QWidget) -> None:
        """A shape, so that there is something to work on."""
        from roam_core.roto import edit

        document = self._window.document
        if document.project.clip is not None and len(document.project.shapes) < 6:
            points = SQUARE + self._random.uniform(-10.0, 30.0)
            document.apply("Draw", edit.new_shape(document.project, points, self._window.view_state.frame)[0])

    def _click(self, target: QWidget) -> None:
        widget, spot = self._spot(target)
        QTest.mouseClick(widget, Qt.MouseButton.LeftButton, self._random.choice(HELD), spot)

    def _double_click(self, target: QWidget) -> None:
        widget, spot = self._spot(target)
        QTest.mouseDClick(widget, Qt.MouseButton.LeftButton, self._random.choice(HELD), spot)

    def _right_click(self, target: QWidget) -> None:
        widget, spot = self._spot(target)
        QTest.mouseClick(widget, Qt.MouseButton.RightButton, Qt.KeyboardModifier.NoModifier, spot)

    def _drag(self, target: QWidget) -> None:
        """A press, moves and a release; now and then a key amid it."""
        widget, spot = self._spot(self._window.canvas if self._random.random() < 0.5 else target)
        held, left = self._random.choice(HELD), Qt.MouseButton.LeftButton
        QTest.mousePress(widget, left, held, spot)
        for _ in range(self._random.randint(1, 4)):
            spot = spot + QPoint(self._random.randint(-60, 60), self._random.randint(-40, 40))
            QTest.mouseMove(widget, spot)
            if self._random.random() < 0.05:
                self._press(widget)
        QTest.mouseRelease(widget, left, held, spot)

    def _press(self, target: QWidget) -> None:
        key, held = self._random.choice(KEYS), self._random.choice(HELD)
        receiver = QApplication.focusWidget() or target
        if (key, held) != (Qt.Key.Key_Q, Qt.KeyboardModifier.ControlModifier):
            self._note(f"{held.value >> 25} {key.name} to {_told(receiver)}")
            QTest.keyClick(receiver, key, held)

    def _type(self, target: QWidget) -> None:
        word = self._random.choice(WORDS)
        receiver = QApplication.focusWidget() or target
        self._note(f"{word[:20]!r} to {_told(receiver)}")
        QTest.keyClicks(receiver, word)

    def _wheel(self, target: QWidget) -> None:
        widget, spot = self._spot(target)
        turn = QPoint(0, self._random.choice((-360, -120, 120, 360)))
        where, there = QPointF(spot), QPointF(widget.mapToGlobal(spot))
        held, button = self._random.choice(HELD), Qt.MouseButton.NoButton
        phase = Qt.ScrollPhase.NoScrollPhase
        QApplication.sendEvent(widget, QWheelEvent(where, there, QPoint(), turn, button, held, phase, False))

    def _resize(self, _: QWidget) -> None:
        self._window.resize(self._random.randint(500, 1800), self._random.randint(400, 1200))

    def _spot(self, target: QWidget) -> tuple[QWidget, QPoint]:
        """A widget in `target`, and a place in it."""
        # Not by `findChildren`: PySide ties what it finds to the window, and lets go of it where a floating one ends.
        inside = (each for each in QApplication.allWidgets() if each.isVisible() and each.window() is target.window())
        widget = self._random.choice([each for each in inside if target.isAncestorOf(each)] or [target])
        spot = QPoint(self._random.randrange(max(widget.width(), 1)), self._random.randrange(max(widget.height(), 1)))
        self._note(f"{_told(widget)} at {spot.x()}, {spot.y()}")
        return widget, spot


def _told(widget: QWidget) -> str:
    return f"{type(widget).__name__} {widget.objectName()}".rstrip()


class Paths:
    """Answers to the system's dialogs of files: one of those that lie about, a new one, or none."""

    def __init__(self, folder: Path, seed: int) -> None:
        self._folder, self._random = folder, random.Random(seed)

    def one_to_open(self, *_: object, **__: object) -> tuple[str, str]:
        files = sorted(path for path in self._folder.rglob("*") if path.is_file())
        return str(self._random.choice([*files, self._folder / "gone.roam", ""])), ""

    def one_to_save(self, *words: object, **__: object) -> tuple[str, str]:
        suffix = self._random.choice((".roam", ".nk", ".json", ".mov", ""))
        return str(self._random.choice((self._folder / f"out{self._random.randint(1, 5)}{suffix}", ""))), ""

    def folder(self, *_: object, **__: object) -> str:
        folders = sorted(path for path in self._folder.rglob("*") if path.is_dir())
        return str(self._random.choice([*folders, self._folder / "new", ""]))


def arguments(parser: argparse.ArgumentParser) -> None:
    parser.add_argument("--minutes", type=float, default=10.0, help="how long (10)")
    parser.add_argument("--seed", type=int, default=1, help="which random steps (1)")
    parser.add_argument("--here", type=Path, help=argparse.SUPPRESS)


def run(given: argparse.Namespace) -> int:
    """Take the steps in a process of its own; how that ended, and its last steps where it did not end well."""
    if given.here is not None:
        return _run_here(given)
    with tempfile.TemporaryDirectory(prefix="roam-monkey-") as folder:
        words = ["-m", "tests.endurance", "monkey", f"--minutes={given.minutes}", f"--seed={given.seed}"]
        command = [sys.executable, *words, f"--here={folder}"]
        done = subprocess.run(command, env=environment(Path(folder)), cwd=ROOT, check=False)
        steps = (Path(folder) / "steps.txt").read_text(encoding="utf-8").splitlines()
        print(f"{len(steps)} steps of seed {given.seed}, ended with {done.returncode}.")
        if done.returncode:
            print("\n".join(steps[-LAST_STEPS:]))
    return int(done.returncode != 0)


def _run_here(given: argparse.Namespace) -> int:
    from app import style
    from app.shell.main_window import MainWindow

    faulthandler.enable()
    work = given.here / "work"
    write_clip(work / "plate", FRAMES)
    paths = Paths(work, given.seed)
    for name, answer in (
        ("getOpenFileName", paths.one_to_open),
        ("getSaveFileName", paths.one_to_save),
        ("getExistingDirectory", paths.folder),
    ):
        setattr(QFileDialog, name, staticmethod(answer))
    QDesktopServices.openUrl = staticmethod(lambda *_: True)  # type: ignore[method-assign, assignment]
    application = QApplication(["roam"])
    style.apply(application)
    window = MainWindow(given.here / "journal")
    with (given.here / "steps.txt").open("w", encoding="utf-8") as notes:
        monkey = Monkey(window, work, given, notes)
        _listen(monkey)
        window.show()
        monkey.begin()
        application.exec()
    if monkey.failure:
        print(monkey.failure, file=sys.stderr)
    return int(bool(monkey.failure))


def _listen(monkey: Monkey) -> None:
    """Let an error that nobody caught, and a warning of Qt's, fail the run."""

    def in_a_slot(kind: type[BaseException], error: BaseException, trace: Any) -> None:
        monkey.fail("".join(traceback.format_exception(kind, error, trace)))

    def in_a_thread(args: threading.ExceptHookArgs) -> None:
        monkey.fail("".join(traceback.format_exception(args.exc_value)))

    def said(kind: QtMsgType, _: object, text: str) -> None:
        if kind is not QtMsgType.QtDebugMsg and kind is not QtMsgType.QtInfoMsg and not text.startswith(HARMLESS):
            monkey.fail(f"Qt says: {text}\n{''.join(traceback.format_stack())}")

    sys.excepthook, threading.excepthook = in_a_slot, in_a_thread
    qInstallMessageHandler(said)
