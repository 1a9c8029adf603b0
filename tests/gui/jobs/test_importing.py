"""Imports as jobs: shapes arrive as one undo step, what is lost is told, a dropped job brings nothing."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.jobs.importing import Import
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange.nuke.exporter import roto_document
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import clip_stamp, stamp
from roam_core.roto import Clip, Keyframe, Origin, Project, edit
from tests.gui.waiting import WAIT

CLIP = Clip(Path("/plates/shot"), 1001, 1003, (64, 48))
SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])


@pytest.fixture
def script(tmp_path: Path) -> Path:
    """A Nuke script with one shape."""
    path = tmp_path / "a.nk"
    path.write_text(roto_document(edit.new_shape(Project(CLIP), SQUARE, 1002, name="Arm")[0])[0])
    return path


def test_shapes_arrive_as_one_undo_step(qtbot: QtBot, document: Document, runner: Runner, script: Path) -> None:
    document.open(Project(CLIP), None)
    importing = Import(document, runner)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(script)
    assert finished.args == [Ending.DONE, "Read 1 shape from a.nk."]
    (shape,) = document.project.shapes
    assert (shape.name, shape.frames) == ("Arm", (1002,))
    assert document.undo_stack.count() == 1


def test_what_lies_on_a_tracked_shape_says_that_its_tracked_frames_are_out_of_date(
    qtbot: QtBot, document: Document, runner: Runner, script: Path
) -> None:
    """As what is pasted, drawn or duplicated there does."""
    project, body = edit.new_shape(Project(CLIP), SQUARE + 2.0, 1002, name="Body")
    inputs = stamp([body], 1003, 1002, CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP), forward=True)
    made = Keyframe(1003, SQUARE, origin=Origin.ENGINE, inputs=inputs)
    document.open(project.with_shape(edit.set_engine_keys(body, [made])), None)
    importing = Import(document, runner)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(script)
    assert finished.args[1].startswith("Read 1 shape from a.nk. Tracked frames of Body are out of date: what is new")


def test_without_a_clip_it_is_refused_in_a_sentence(
    qtbot: QtBot, document: Document, runner: Runner, script: Path
) -> None:
    importing = Import(document, runner)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(script)
    assert finished.args[0] is Ending.FAILED
    assert "clip" in finished.args[1]


def test_a_project_that_is_replaced_gets_nothing_of_it(
    qtbot: QtBot, document: Document, runner: Runner, script: Path
) -> None:
    document.open(Project(CLIP), None)
    importing = Import(document, runner)
    with qtbot.waitSignal(importing.finished, timeout=WAIT) as finished:
        importing.start(script)
        document.open(Project(CLIP), None)
    assert finished.args[0] is Ending.CANCELLED
    qtbot.waitUntil(lambda: runner.is_idle, timeout=WAIT)
    assert document.project.shapes == ()


def test_what_is_read_comes_in_though_another_file_is_asked_for(
    qtbot: QtBot, document: Document, runner: Runner, script: Path
) -> None:
    document.open(Project(CLIP), None)
    importing, endings = Import(document, runner), list[Ending]()
    importing.finished.connect(lambda ending, _: endings.append(ending))
    importing.start(script)
    importing.start(script)
    qtbot.waitUntil(lambda: len(endings) == 2, timeout=WAIT)
    assert endings == [Ending.DONE, Ending.DONE]
    assert len(document.project.shapes) == 2
