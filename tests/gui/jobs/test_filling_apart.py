"""Large fills of the window on processes of this machine: the keys are those of one process, in one step to undo."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.jobs import filling
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.cli import spreading
from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.between import span
from roam_core.propagate.shapes.gaps import gaps_of
from roam_core.roto import Clip, Project, edit
from tests.conftest import ROOT
from tests.gui.jobs.test_filling import RAMP
from tests.gui.waiting import WAIT
from tests.unit.studio.shots import put_gaps, put_plate

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


def filled(given: Path, out: Path, processes: int) -> list[str]:
    """What the window tells of a fill, line by line."""
    words = [sys.executable, "-m", "tests.gui.jobs.filling_program", str(given), str(out), str(processes)]
    done = subprocess.run(words, cwd=ROOT, capture_output=True, text=True, check=False, timeout=300)
    assert done.returncode == 0, done.stderr
    return done.stdout.splitlines()


def test_a_fill_on_two_processes_is_that_of_one(tmp_path: Path) -> None:
    pytest.importorskip("distributed", reason="Dask is not installed (pip install 'roam-roto[studio]')")
    given = tmp_path / "given.roam"
    put_gaps(given, put_plate(tmp_path / "plate"))
    alone, apart = (filled(given, tmp_path / f"{count}.roam", count) for count in (1, 2))
    assert (tmp_path / "2.roam").read_bytes() == (tmp_path / "1.roam").read_bytes() != given.read_bytes()
    assert "Starting 2 processes …" in apart
    assert "Filled 4 of 4 pieces on 2 processes" in apart
    assert not any("processes" in line for line in alone)
    assert apart[-2:] == alone[-2:]
    assert apart[-1] == "1 step to undo"


def test_few_frames_are_filled_here(
    document: Document, view_state: ViewState, runner: Runner, monkeypatch: pytest.MonkeyPatch, qtbot: QtBot
) -> None:
    project, shape = edit.new_shape(Project(Clip(Path("shot"), 1, 12, (64, 48))), SQUARE, 1)
    for frame in (4, 7):
        shape = edit.key_here(shape, frame)
    document.open(project.with_shape(shape), None)
    monkeypatch.setattr(span, "fill_span", lambda *_: [])
    monkeypatch.setattr(spreading, "spread", lambda *_, **__: pytest.fail("processes were started"))
    propagation = Propagation(document, view_state, runner, lambda frame: RAMP)
    propagation.processes = 8
    gaps = gaps_of([shape])
    assert sum(last - first - 1 for first, last in gaps) < filling.WORTH_PROCESSES
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.fill([shape.id], gaps)
    assert finished.args[0] is Ending.DONE
