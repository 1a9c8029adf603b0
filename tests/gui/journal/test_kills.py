"""The window killed at random moments of work: its file opens, and no more than the last edit is lost."""

from __future__ import annotations

import os
import random
import subprocess
import sys
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

import pytest

from app.journal import recovery
from roam_core.errors import RoamError
from roam_core.roto import Project, file
from tests.conftest import ROOT

KILLS = int(os.environ.get("ROAM_KILLS", "1"))
"""Kills of each kind. `ROAM_KILLS=100` takes some minutes and is what the published figure comes from."""
START = 60.0
"""Seconds that the window may take to come up."""


@dataclass(frozen=True)
class Outcome:
    """Edits said and edits that came back; seconds between the last edit that came back and the kill."""

    said: int
    back: int
    seconds: float


def state(project: Project) -> int:
    """Which state of the artist's work a project is."""
    return int(project.marks[0].text) if project.marks else 0


def killed(folder: Path, path: Path | None, delay: float) -> Outcome:
    """Let an artist work for a while, kill the program, and see what is left."""
    command = [sys.executable, "-m", "tests.gui.journal.artist", str(folder), *([] if path is None else [str(path)])]
    environment = os.environ | {"PYTHONPATH": str(ROOT), "QT_QPA_PLATFORM": "offscreen"}
    program = subprocess.Popen(command, env=environment, cwd=ROOT, stdout=subprocess.PIPE, text=True)
    assert program.stdout is not None
    first = program.stdout.readline()
    time.sleep(delay)
    end = time.time()
    program.kill()
    lines = [line.split() for line in (first + program.stdout.read()).splitlines() if line.count(" ") == 2]
    program.stdout.close()
    program.wait()
    times = {int(number): float(when) for when, what, number in lines if what == "edit"}
    back = 0 if path is None else state(file.load(path))  # it always opens
    for each in recovery.offered(recovery.recoveries(folder)):
        with suppress(RoamError):  # killed while the file was replaced: then that holds what the journal builds up to
            back = max(back, state(recovery.load(each)[0]))
    said = max(times)
    return Outcome(said, back, end - times[back] if back in times else end - times[1])


@pytest.mark.parametrize("titled", [False, True], ids=["untitled", "titled"])
def test_a_kill_loses_at_most_one_edit_or_one_second(tmp_path: Path, titled: bool) -> None:
    moments = random.Random(17)
    outcomes = []
    for number in range(KILLS):
        folder = tmp_path / str(number)
        folder.mkdir()
        path = folder / "mine.roam" if titled else None
        if path is not None:
            file.save(Project(), path)
        outcomes.append(killed(folder / "journal", path, moments.uniform(0.0, 1.5)))
    lost = [max(0, outcome.said - outcome.back) for outcome in outcomes]
    print(f"{len(lost)} kills: at most {max(lost)} edits lost, {sum(lost)} of {sum(o.said for o in outcomes)} in all")
    assert [o for o in outcomes if o.said - o.back > 1 and o.seconds > 1.0] == []
