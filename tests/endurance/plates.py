"""Opens damaged pictures and movies in the real application, offscreen: each has to be shown or told in a sentence."""

from __future__ import annotations

import argparse
import os
import random
import shutil
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Iterator
from contextlib import suppress
from dataclasses import dataclass
from enum import StrEnum
from pathlib import Path
from typing import TYPE_CHECKING

from PySide6.QtCore import QCoreApplication, QEventLoop

from tests.endurance.environment import environment
from tests.fuzz import READERS, SEED, damaged

if TYPE_CHECKING:
    from app.jobs.runner import Ending
    from app.shell.main_window import MainWindow

KINDS = ("png", "jpg", "tif", "exr", "parts", "dpx", "tga", "gif", "movie", "mp4")
MOVIES = frozenset({"movie", "mp4"})
MOST_SECONDS, MOST_MEMORY = 5.0, 1 << 30
BETWEEN = 1002
"""The frame of a sequence that is damaged; the one before and the one after are whole."""
KEPT = Path("damaged-plates")


class Outcome(StrEnum):
    """What became of a damaged file: shown all the same, told by a placeholder, not opened; or what is wrong."""

    SHOWN = "shown"
    PLACEHOLDER = "a placeholder and a sentence"
    REFUSED = "refused in a sentence"
    SILENT = "no sentence"
    SLOW = "more than five seconds"
    GREEDY = "more than a gibibyte"


WRONG = frozenset({Outcome.SILENT, Outcome.SLOW, Outcome.GREEDY})


@dataclass(frozen=True)
class Looked:
    """One file that was opened: its kind and bytes, what became of it, in how many seconds, and what was said."""

    kind: str
    content: bytes
    outcome: Outcome
    seconds: float
    sentence: str
    decoding: int = 0
    """The most bytes that a process which decodes has held by then."""


def plates(folder: Path, count: int, seed: int) -> Iterator[tuple[str, bytes, Path]]:
    """Damaged files, each within a plate: their kind, their bytes, and what to open."""
    rng = random.Random(seed)
    whole = {kind: READERS[kind][1](READERS[kind][2], folder) for kind in KINDS}
    for number in range(count):
        kind = KINDS[number % len(KINDS)]
        suffix, content = READERS[kind][0], damaged(whole[kind], rng)
        place = folder / "plate"
        shutil.rmtree(place, ignore_errors=True)
        place.mkdir()
        if kind in MOVIES:
            path = place / f"plate{suffix}"
            path.write_bytes(content)
        else:
            path = place
            for frame in range(BETWEEN - 1, BETWEEN + 2):
                (place / f"plate.{frame}{suffix}").write_bytes(content if frame == BETWEEN else whole[kind])
        yield kind, content, path


class Looker:
    """Opens plates in a window and looks at every frame of them."""

    def __init__(self, window: MainWindow) -> None:
        self._window = window
        self._pictures: dict[int, bool] = {}
        self._said: list[str] = []
        self._ended: list[tuple[Ending, str]] = []
        window.reader.picture.connect(self._take_picture)
        window.reader.refused.connect(self._said.append)
        window.files.finished.connect(self._take_end)

    def look(self, kind: str, content: bytes, path: Path) -> Looked:
        """Open a plate, and go to each of its frames."""
        self._pictures.clear()
        self._said.clear()
        self._ended.clear()
        began, memory = time.monotonic(), peak()
        self._window.files.open(path)
        outcome = Outcome.SLOW
        if self._wait(lambda: bool(self._ended)):
            outcome = self._frames() if self._ended[-1][0] == "done" else Outcome.REFUSED
        sentence = self._said[-1] if self._said else self._ended[-1][1] if self._ended else ""
        if peak() - memory > MOST_MEMORY:
            outcome = Outcome.GREEDY
        elif outcome in (Outcome.PLACEHOLDER, Outcome.REFUSED) and not is_sentence(sentence):
            outcome = Outcome.SILENT
        return Looked(kind, content, outcome, time.monotonic() - began, sentence, peak_of_decoders())

    def _frames(self) -> Outcome:
        source = self._window.files.plate
        for frame in source.frames if source is not None else ():
            self._pictures.pop(frame, None)
            self._window.view_state.set_frame(frame)
            if self._window.reader.plate(frame) is None and not self._wait(lambda: frame in self._pictures):  # noqa: B023
                return Outcome.SLOW
        return Outcome.SHOWN if all(self._pictures.values()) else Outcome.PLACEHOLDER

    def _wait(self, condition: Callable[[], bool]) -> bool:
        until = time.monotonic() + MOST_SECONDS
        while not condition():
            if time.monotonic() > until:
                return False
            QCoreApplication.processEvents(QEventLoop.ProcessEventsFlag.AllEvents, 20)
            time.sleep(0.001)
        return True

    def _take_picture(self, frame: int, image: object) -> None:
        self._pictures[frame] = image is not None

    def _take_end(self, ending: Ending, sentence: str) -> None:
        self._ended.append((ending, sentence))


def is_sentence(text: str) -> bool:
    """One line that ends as a sentence does."""
    return bool(text) and "\n" not in text and text.rstrip()[-1] in ".!?"


def peak() -> int:
    """The most bytes that this process has held."""
    import resource  # Windows has no such module, and collects the tests that use this one

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss << 10


def peak_of_decoders() -> int:
    """The most bytes that one of the processes which this one started has held, of those that run."""
    running: list[str] = []
    for path in Path("/proc/self/task").glob("*/children"):
        with suppress(OSError):  # the thread may end meanwhile
            running += path.read_text().split()
    peaks = [0]
    for process_id in running:
        with suppress(OSError):
            status = Path(f"/proc/{process_id}/status").read_text()
            peaks += [int(line.split()[1]) << 10 for line in status.splitlines() if line.startswith("VmHWM")]
    return max(peaks)


def table(looked: list[Looked]) -> str:
    """How many files of each kind ended how, and the longest that one took."""
    outcomes = [outcome for outcome in Outcome if any(each.outcome is outcome for each in looked)]
    lines = ["| kind | " + " | ".join(outcomes) + " | longest, s |", "|---" * (len(outcomes) + 2) + "|"]
    for kind in (*KINDS, "all"):
        of_kind = [each for each in looked if kind in ("all", each.kind)]
        count = Counter(each.outcome for each in of_kind)
        longest = max((each.seconds for each in of_kind), default=0.0)
        lines.append(f"| {kind} | " + " | ".join(str(count[outcome]) for outcome in outcomes) + f" | {longest:.2f} |")
    return "\n".join(lines)


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `plates` may be told."""
    parser.add_argument("--files", type=int, default=1000, metavar="N", help="how many (default 1000)")
    parser.add_argument("--seed", type=int, default=SEED, metavar="S", help="of the damage")
    parser.add_argument("--keep", type=Path, default=KEPT, metavar="FOLDER", help="where files with findings are kept")


def run(given: argparse.Namespace) -> int:
    """Look at so many damaged files, print what became of them, and fail where something is wrong."""
    from app.shell import launch
    from roam_core.cli.environment import decoding_apart

    looked: list[Looked] = []

    def work(window: MainWindow) -> None:
        looker = Looker(window)
        with tempfile.TemporaryDirectory() as folder:
            for plate in plates(Path(folder), given.files, given.seed):
                looked.append(looker.look(*plate))
                if (last := looked[-1]).outcome in WRONG:
                    given.keep.mkdir(parents=True, exist_ok=True)
                    name = f"{len(looked)}{READERS[last.kind][0]}"
                    (given.keep / name).write_bytes(last.content)
                    print(f"{given.keep / name}: {last.outcome}: {last.sentence}", file=sys.stderr, flush=True)
                window.files.new()
        window.leave_unasked()

    with tempfile.TemporaryDirectory() as state:
        os.environ.update(environment(Path(state)))
        os.environ.setdefault("QT_LOGGING_RULES", "default.warning=false")  # what no screen can do
        with decoding_apart():
            code = launch._run(work)
    print(table(looked))
    print(
        f"the window held {peak() >> 20} MiB at most, "
        f"a process that decodes {max(each.decoding for each in looked) >> 20} MiB"
    )
    return code or int(len(looked) < given.files or any(each.outcome in WRONG for each in looked))
