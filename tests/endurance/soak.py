"""Works in the real application, offscreen, for as long as asked: its memory, threads and handles over the time."""

from __future__ import annotations

import argparse
import csv
import os
import random
import sys
import tempfile
import threading
import time
from collections.abc import Callable, Sequence
from dataclasses import astuple, dataclass, fields
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QObject, QTimer

from tests.endurance.artist import SQUARE
from tests.endurance.environment import environment
from tests.gui.windows import COUNT, FIRST, write_clip

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

PACE = 30
"""Milliseconds between two commands."""
EVERY = 5.0
"""Seconds between two looks at the memory."""
MOST_SHAPES = 6
SHARE = 0.1
"""Share of the time at the end that is held against as much after the first quarter, when all is warm."""


@dataclass(frozen=True)
class Look:
    """The process at one moment: seconds since the start, MiB that it holds, threads, open handles, commands done."""

    seconds: float
    memory: float
    threads: int
    handles: int
    commands: int

    @classmethod
    def now(cls, seconds: float, commands: int) -> Look:
        pages = int(Path("/proc/self/statm").read_text(encoding="ascii").split()[1])
        memory = pages * os.sysconf("SC_PAGE_SIZE") / (1 << 20)
        handles = sum(1 for _ in Path("/proc/self/fd").iterdir())
        return cls(round(seconds, 1), memory, threading.active_count(), handles, commands)


class Worker(QObject):
    """Does whatever an artist does, at random: the same seed the same, but for what runs beside."""

    def __init__(self, window: MainWindow, clip: Path, folder: Path, given: argparse.Namespace) -> None:
        super().__init__(window)
        self._window, self._clip, self._path = window, clip, folder / "work.roam"
        self._random, self._given = random.Random(given.seed), given
        self.looks: list[Look] = []
        self._commands, self._begun, self._next = 0, time.monotonic(), 0.0
        window.tracking.config = "baseline"
        self._timer = QTimer(self, interval=PACE)
        self._timer.timeout.connect(self._work)
        self._timer.start()
        window.files.open(clip)

    def _work(self) -> None:
        seconds = time.monotonic() - self._begun
        if seconds >= self._next:
            self.looks.append(Look.now(seconds, self._commands))
            self._next += EVERY
        if seconds > 60.0 * self._given.minutes:
            self._timer.stop()
            self._window.leave_unasked()
        elif not self._window.files.is_opening:
            self._commands += 1
            self._random.choice(self._choices())()

    def _choices(self) -> Sequence[Callable[[], object]]:
        act = self._window.actions_by_id
        return (
            *(self._edit,) * 12,
            *(self._draw,) * 2,
            *(act["edit.undo"].trigger,) * 4,
            *(act["edit.redo"].trigger,) * 3,
            *(act["track.forward"].trigger,) * 2,
            act["track.backward"].trigger,
            act["track.stop"].trigger,
            *(self._look_at,) * 6,
            self._save,
            self._delete,
            *((self._open,) if self._random.random() < 0.02 else ()),
        )

    def _shapes(self) -> list[str]:
        return [shape.id for shape in self._window.document.project.shapes]

    def _draw(self) -> None:
        from roam_core.roto import edit

        document = self._window.document
        if document.project.clip is not None and len(self._shapes()) < MOST_SHAPES:
            points = SQUARE + self._random.uniform(-10.0, 30.0)
            project, shape = edit.new_shape(document.project, points, self._window.view_state.frame)
            document.apply("Draw", project)
            self._window.view_state.select(frozenset([shape.id]))

    def _edit(self) -> None:
        from roam_core.roto import edit

        if shapes := self._shapes():
            document = self._window.document
            shape = document.project.shape(self._random.choice(shapes))
            frame = self._random.randint(FIRST, FIRST + COUNT - 1)
            noise = np.random.default_rng(self._commands).normal(scale=1.0, size=2)
            moved = edit.set_key(shape, frame, shape.at(frame).points + noise)
            document.apply("Move", document.project.with_shape(moved))

    def _delete(self) -> None:
        from roam_core.roto import edit

        if shapes := self._shapes():
            document = self._window.document
            document.apply("Delete", edit.remove_items(document.project, [self._random.choice(shapes)]))

    def _look_at(self) -> None:
        self._window.view_state.set_frame(self._random.randint(FIRST, FIRST + COUNT - 1))

    def _save(self) -> None:
        self._window.files.save(self._path)

    def _open(self) -> None:
        self._window.files.open(self._path if self._path.exists() else self._clip)


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `soak` may be told."""
    parser.add_argument("--minutes", type=float, default=60.0, metavar="M", help="how long (default 60)")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="of what is done (default 0)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="write the curve as CSV")


def run(given: argparse.Namespace) -> int:
    """Work so long, print how memory, threads and handles went, and fail where they grew."""
    from app.shell import launch

    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        os.environ.update(environment(folder))
        clip = write_clip(folder / "plate")
        workers: list[Worker] = []
        code = launch._run(lambda window: workers.append(Worker(window, clip, folder, given)))
    looks = workers[0].looks
    if given.out is not None:
        with given.out.open("w", encoding="ascii", newline="") as file:
            table = csv.writer(file)
            table.writerow(field.name for field in fields(Look))
            table.writerows(astuple(look) for look in looks)
    print(report(looks))
    return code or (0 if is_flat(looks) else 1)


def report(looks: Sequence[Look]) -> str:
    """A table of ten moments."""
    chosen = [looks[round(k * (len(looks) - 1) / 10)] for k in range(11)]
    lines = ["| minutes | MiB | threads | handles | commands |", "|---|---|---|---|---|"]
    lines += [f"| {a.seconds / 60:.1f} | {a.memory:.0f} | {a.threads} | {a.handles} | {a.commands} |" for a in chosen]
    return "\n".join(lines)


def is_flat(looks: Sequence[Look]) -> bool:
    """Whether the last tenth of the time holds hardly more than a tenth of it after the first quarter."""
    count = max(1, round(SHARE * len(looks)))
    warm, last = looks[len(looks) // 4 :][:count], looks[-count:]

    def middle(of: Sequence[Look], name: str) -> float:
        return float(np.median([getattr(look, name) for look in of]))

    grown = {name: middle(last, name) - middle(warm, name) for name in ("memory", "threads", "handles")}
    print(f"grown since the first quarter: {grown}", file=sys.stderr)
    return grown["memory"] < 0.1 * middle(warm, "memory") and grown["threads"] <= 1 and grown["handles"] <= 4
