"""Matching the plate's edge: shapes get the plate's motion blur in one undo step; what is edited meanwhile is left."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from app.features.tracking import NO_CLIP
from app.features.verbs.plate_edge import PlateEdge
from app.jobs.by_plate.softening import Softening
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import UInt8
from roam_core.matte import shape_matte
from roam_core.roto import Clip, MotionBlur, Project, edit
from tests.gui.waiting import WAIT
from tests.unit.matte.test_softness import SIZE, disc, picture

FRAMES = range(1, 4)
BLURRED = replace(disc(step=8.0, frames=range(0, 5)), motion_blur=MotionBlur(0.5, -0.25, 32))


class Plate:
    """Pictures of the blurred disc; with `hold` none is given before `go`."""

    def __init__(self) -> None:
        self.go, self.asked = threading.Event(), threading.Event()
        self.go.set()

    def read(self, frame: int) -> UInt8:
        self.asked.set()
        assert self.go.wait(WAIT / 1000)
        return picture(shape_matte(BLURRED, frame, SIZE), seed=frame)


@pytest.fixture
def plate() -> Plate:
    return Plate()


@pytest.fixture
def softening(document: Document, runner: Runner, plate: Plate) -> Softening:
    project = Project(clip=Clip(__file__, FRAMES[0], FRAMES[-1], (SIZE[1], SIZE[0])))
    document.open(edit.add_shape(project, disc(step=8.0, frames=FRAMES)), None)
    return Softening(document, runner, plate.read)


@pytest.fixture
def verb(document: Document, view_state: ViewState, softening: Softening) -> PlateEdge:
    return PlateEdge(document, view_state, softening)


def finish(qtbot: QtBot, softening: Softening, begin: Callable[[], object]) -> tuple[Ending, str]:
    with qtbot.waitSignal(softening.finished, timeout=WAIT) as signal:
        begin()
    return tuple(signal.args)


def test_the_shape_gets_the_plates_shutter_in_one_step(
    qtbot: QtBot, document: Document, softening: Softening, verb: PlateEdge
) -> None:
    before = document.project
    ending, sentence = finish(qtbot, softening, verb.match)
    blur = document.project.shape("disc").motion_blur
    assert ending is Ending.DONE
    assert blur is not None
    assert blur.shutter == pytest.approx(0.5, abs=0.06)
    assert sentence.startswith(f"Shutter {blur.shutter:.2f} frames. Edge ")
    assert document.undo_stack.undoText() == "Match the plate's edge"
    document.undo_stack.undo()
    assert document.project == before


def test_a_shape_that_is_edited_meanwhile_is_left_as_it_is(
    qtbot: QtBot, document: Document, softening: Softening, verb: PlateEdge, plate: Plate
) -> None:
    plate.go.clear()
    with qtbot.waitSignal(softening.finished, timeout=WAIT) as signal:
        verb.match()
        assert plate.asked.wait(WAIT / 1000)
        document.apply("Key", document.project.with_shape(edit.delete_keys(document.project.shape("disc"), [2])))
        plate.go.set()
    assert (document.project.shape("disc").frames, document.project.shape("disc").motion_blur) == ((1, 3), None)
    assert signal.args[1].endswith(" 1 shape edited or locked meanwhile: left as they are.")


def test_what_a_shape_is_called_and_whether_it_is_seen_may_change_meanwhile(
    qtbot: QtBot, document: Document, softening: Softening, verb: PlateEdge, plate: Plate
) -> None:
    plate.go.clear()
    looks = {"name": "Other", "visible": False, "colour": (1.0, 0.0, 0.0)}
    with qtbot.waitSignal(softening.finished, timeout=WAIT):
        verb.match()
        assert plate.asked.wait(WAIT / 1000)
        document.apply("Rename", edit.set_properties(document.project, "disc", **looks))
        plate.go.set()
    shape = document.project.shape("disc")
    assert shape.motion_blur is not None
    assert {name: getattr(shape, name) for name in looks} == looks


def test_a_shape_whose_layer_is_locked_meanwhile_is_left_as_it_is(
    qtbot: QtBot, document: Document, softening: Softening, verb: PlateEdge, plate: Plate
) -> None:
    plate.go.clear()
    with qtbot.waitSignal(softening.finished, timeout=WAIT) as signal:
        verb.match()
        assert plate.asked.wait(WAIT / 1000)
        document.apply("Lock", edit.set_properties(document.project, "root", locked=True))
        plate.go.set()
    assert document.project.shape("disc").motion_blur is None
    assert signal.args[1].endswith(" 1 shape edited or locked meanwhile: left as they are.")


def test_stopped_changes_nothing(
    qtbot: QtBot, document: Document, softening: Softening, verb: PlateEdge, plate: Plate
) -> None:
    before = document.project
    plate.go.clear()
    with qtbot.waitSignal(softening.finished, timeout=WAIT) as signal:
        verb.match()
        assert plate.asked.wait(WAIT / 1000)
        softening.stop()
        plate.go.set()
    assert tuple(signal.args) == (Ending.CANCELLED, "Stopped; no edge was changed.")
    assert document.project is before


def test_what_cannot_be_matched_is_said(document: Document, view_state: ViewState, verb: PlateEdge) -> None:
    project = document.project
    document.apply("Lock", edit.set_properties(project, "disc", locked=True))
    verb.match()
    assert view_state.message == "Only a closed shape that is not locked has an edge to match; unlock or close one."
    document.apply("Delete", edit.remove_items(project, ["disc"]))
    verb.match()
    assert view_state.message == "Draw a shape first: press B in the viewer."
    document.open(Project(), None)
    verb.match()
    assert view_state.message == NO_CLIP
