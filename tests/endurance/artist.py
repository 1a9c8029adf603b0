"""An artist in a process of its own, who works in the real application until it is killed.

Each edit has a number, which the shape bears as its name, and is noted in a file once it is committed: what was noted
is what the artist has seen; or, `flushed`, once the journal says that it is on the disk.
`python -m tests.endurance.artist MODE FOLDER [flushed]`.
"""

from __future__ import annotations

import os
import sys
import time
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QObject, QTimer

from app.shell import launch
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

UNTITLED, TITLED, SAVING, TRACKING = MODES = ("untitled", "titled", "saving", "tracking")
WORK, NOTES = "work.roam", "notes.txt"
PACE = 15
"""Milliseconds between two edits."""
SAVES = 4
"""Edits between two saves."""
SQUARE = polygon_points([(20, 20), (80, 20), (80, 80), (20, 80)])


class Artist(QObject):
    """Edits one shape again and again; or tracks it, again and again, and notes how many frames are solved."""

    def __init__(self, window: MainWindow, mode: str, folder: Path, *, flushed: bool) -> None:
        super().__init__(window)
        self._window, self._mode, self._path, self._flushed = window, mode, folder / WORK, flushed
        self._notes = os.open(folder / NOTES, os.O_WRONLY | os.O_CREAT | os.O_APPEND)
        self._number = 0
        self._timer = QTimer(self, interval=PACE)
        self._timer.timeout.connect(self._track if mode == TRACKING else self._edit)
        if mode == UNTITLED:
            self._begin(None)
        else:
            window.files.opened.connect(self._begin)
            window.files.open(self._path)

    def _begin(self, _path: object) -> None:
        if self._mode == UNTITLED:
            project, _ = edit.new_shape(Project(), SQUARE, 1, name="0")
            self._window.document.apply("Draw", project)
        if self._mode == TRACKING:
            self._window.tracking.config = "baseline"
            self._window.document.changed.connect(lambda _ids: self._note(len(self._shape.keys)))
        self._timer.start()

    @property
    def _shape(self):  # type: ignore[no-untyped-def]
        return self._window.document.project.shapes[0]

    def _edit(self) -> None:
        self._number += 1
        document, frame = self._window.document, 1 + self._number % 20
        moved = edit.set_key(self._shape, frame, SQUARE + 0.01 * self._number)
        renamed = edit.set_properties(document.project.with_shape(moved), moved.id, name=str(self._number))
        document.apply(f"Edit {self._number}", renamed)
        self._note(self._number)
        if self._mode == SAVING and self._number % SAVES == 0:
            self._window.files.save(self._path)

    def _track(self) -> None:
        """Begin a run, or, when the last one is over, throw its frames away and begin again."""
        if self._window.propagation.is_running:
            return
        document = self._window.document
        if len(self._shape.keys) > 1:
            document.undo_stack.undo()
        self._window.actions_by_id["track.forward"].trigger()

    def _note(self, number: int) -> None:
        """Straight to the system, which keeps it when this process is killed."""
        if self._flushed and not self._window.journal.flush():
            return
        os.write(self._notes, f"{number} {time.time()}\n".encode())


def main() -> int:
    mode, folder, *how = sys.argv[1:]
    return launch._run(lambda window: Artist(window, mode, Path(folder), flushed=bool(how)))


if __name__ == "__main__":
    sys.exit(main())
