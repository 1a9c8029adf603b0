"""Exports as jobs: the file appears, what cannot be exported is one sentence."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.document import Document
from app.jobs.export import Export
from app.jobs.runner import Ending, Runner
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Project, edit

WAIT = 30_000
CLIP = Clip(Path("/plates/shot"), 1001, 1003, (64, 48))


@pytest.fixture
def drawn(document: Document) -> Document:
    square = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
    document.open(edit.new_shape(Project(CLIP), square, 1001)[0], None)
    return document


@pytest.mark.parametrize(("name", "target"), [("nuke", "a.nk"), ("silhouette", "a.fxs"), ("mattes", "mattes")])
def test_an_export_is_written_on_the_worker(
    qtbot: QtBot, drawn: Document, runner: Runner, tmp_path: Path, name: str, target: str
) -> None:
    export = Export(drawn, runner)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start(name, tmp_path / target)
    assert finished.args[0] is Ending.DONE
    assert str(tmp_path / target) in finished.args[1]
    written = tmp_path / target
    assert len(list(written.iterdir())) == 3 if name == "mattes" else written.stat().st_size > 100


def test_a_project_without_a_clip_is_refused_in_a_sentence(
    qtbot: QtBot, document: Document, runner: Runner, tmp_path: Path
) -> None:
    export = Export(document, runner)
    with qtbot.waitSignal(export.finished, timeout=WAIT) as finished:
        export.start("nuke", tmp_path / "a.nk")
    assert finished.args[0] is Ending.FAILED
    assert "clip" in finished.args[1]
    assert list(tmp_path.iterdir()) == []
