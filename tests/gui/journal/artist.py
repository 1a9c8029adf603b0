"""An artist at work in a process of its own, to be killed: says each edit as it is made, and what is saved.

Run as `python -m tests.gui.journal.artist FOLDER [PROJECT]`: opens the window offscreen, on a project if one is named,
draws, moves, undoes, saves and tracks, and prints a line for each: the time, `edit` or `saved`, and how many edits the
document has had. A project is saved after every fifth edit.
"""

from __future__ import annotations

import random
import sys
import time
from dataclasses import replace
from pathlib import Path

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QApplication

from app.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Origin, edit, timing

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
PACE = 15
"""Milliseconds between two edits: no hand is faster."""


class Artist:
    """Numbers each state by a mark on the timeline, so that whoever reads a project knows which one it is."""

    def __init__(self, window: MainWindow, seed: int) -> None:
        self.window, self.random, self.edits = window, random.Random(seed), 0

    def work(self) -> None:
        """One edit, and now and then a save."""
        document, number = self.window.document, self.edits + 1
        project = timing.set_mark(replace(document.project, marks=()), 1, str(number))
        shapes = project.shapes
        if len(shapes) < 3:
            project = edit.new_shape(project, SQUARE, 1)[0]
        elif number % 3:  # as a tracked frame arrives
            shape = self.random.choice(shapes)
            key = Keyframe(number, SQUARE + number % 7, origin=Origin.ENGINE, confidence=0.5)
            project = project.with_shape(edit.set_engine_keys(shape, [key]))
        else:
            shape = self.random.choice(shapes)
            project = project.with_shape(replace(shape, opacity=self.random.random()))
        document.apply("Work", project)
        self.edits = number
        self.say("edit", number)
        if document.path is not None and number % 5 == 0:
            self.window.files.save(document.path)

    def say(self, what: str, number: int) -> None:
        sys.stdout.write(f"{time.time()} {what} {number}\n")
        sys.stdout.flush()


def main() -> int:
    folder, path = Path(sys.argv[1]), Path(sys.argv[2]) if len(sys.argv) > 2 else None
    application = QApplication([])
    window = MainWindow(folder)
    window.show()
    artist = Artist(window, 1)
    window.files.saved.connect(lambda: artist.say("saved", artist.edits))
    if path is not None:
        window.files.open(path)
        while window.document.path is None:
            application.processEvents()
    timer = QTimer(interval=PACE)
    timer.timeout.connect(artist.work)
    timer.start()
    return application.exec()


if __name__ == "__main__":
    sys.exit(main())
