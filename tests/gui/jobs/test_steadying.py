"""Steadying outlines: tracked keys move in one undo step; what is edited meanwhile is left; it can be stopped."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication, QWidget
from pytestqt.qtbot import QtBot

from app.features.tracking import NO_CLIP
from app.features.verbs.steady import Steady
from app.features.verbs.steady_dialog import SteadyDialog
from app.jobs.by_plate.steadying import Steadying
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import UInt8
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit
from tests.golden.shots import Shot, blob, gliding
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, centre, opened_window, write_clip
from tests.unit.propagate.steadiness.test_steadied import FRAMES, RADII, drawn


class Plate:
    """Pictures of a gliding body; without `go` none is given."""

    def __init__(self, shot: Shot) -> None:
        self.shot, self.go, self.asked = shot, threading.Event(), threading.Event()
        self.go.set()

    def read(self, frame: int) -> UInt8:
        self.asked.set()
        assert self.go.wait(WAIT / 1000)
        return self.shot.read(frame)


@pytest.fixture(scope="module")
def shot() -> Shot:
    return gliding(blob(RADII), len(FRAMES), (60.0, 60.0), (2.3, 0.7), drift=(-0.6, 0.4))


@pytest.fixture
def plate(shot: Shot) -> Plate:
    return Plate(shot)


@pytest.fixture
def steadying(document: Document, view_state: ViewState, runner: Runner, plate: Plate) -> Steadying:
    rng = np.random.default_rng(5)
    shape = drawn(plate.shot, {frame: rng.normal(0.0, 0.8, len(RADII)) for frame in FRAMES})
    height, width = plate.shot.size
    document.open(edit.add_shape(Project(Clip(__file__, FRAMES[0], FRAMES[-1], (width, height))), shape), None)
    view_state.set_play_range(FRAMES.start, FRAMES.stop)
    return Steadying(document, runner, plate.read)


@pytest.fixture
def window(qtbot: QtBot) -> QWidget:
    widget = QWidget()
    qtbot.addWidget(widget)
    return widget


@pytest.fixture
def verb(window: QWidget, document: Document, view_state: ViewState, steadying: Steadying) -> Iterator[Steady]:
    yield Steady(window, document, view_state, steadying)
    for dialog in dialogs():
        dialog.close()


def dialogs() -> list[SteadyDialog]:
    return [each for each in QApplication.topLevelWidgets() if isinstance(each, SteadyDialog) and each.isVisible()]


def accept(verb: Steady) -> None:
    """Ask, and take what the dialog proposes."""
    verb.ask()
    (dialog,) = dialogs()
    dialog.accept()


def finish(qtbot: QtBot, steadying: Steadying, begin: Callable[[], object]) -> tuple[Ending, str]:
    with qtbot.waitSignal(steadying.finished, timeout=WAIT) as signal:
        begin()
    return tuple(signal.args)


def moved(before: Project, after: Project) -> list[int]:
    """The frames whose keys are others."""
    old, new = before.shape("body"), after.shape("body")
    return [key.frame for key in new.keys if key != old.key_at(key.frame)]


def test_tracked_keys_move_in_one_step(qtbot: QtBot, document: Document, steadying: Steadying, verb: Steady) -> None:
    before = document.project
    ending, sentence = finish(qtbot, steadying, lambda: accept(verb))
    assert ending is Ending.DONE
    assert sentence.startswith("8 keys moved; boil ")
    assert moved(before, document.project) == [1002, 1003, 1004, 1005, 1007, 1008, 1009, 1010]
    assert document.undo_stack.undoText() == "Steady the outline"
    document.undo_stack.undo()
    assert document.project == before


def test_only_keys_between_in_and_out_move(
    qtbot: QtBot, document: Document, view_state: ViewState, steadying: Steadying, verb: Steady
) -> None:
    before = document.project
    view_state.set_play_range(1003, 1006)
    finish(qtbot, steadying, lambda: accept(verb))
    assert moved(before, document.project) == [1003, 1004, 1005]


def test_at_nothing_no_step_is_made(qtbot: QtBot, document: Document, steadying: Steadying) -> None:
    before = document.project
    ending, sentence = finish(qtbot, steadying, lambda: steadying.start(["body"], FRAMES, 0.0))
    assert (ending, sentence) == (Ending.DONE, "No tracked key could be steadied; nothing was changed.")
    assert document.project is before


def test_the_dial_says_how_strongly(qtbot: QtBot) -> None:
    dialog = SteadyDialog(1, (1001, 1011))
    qtbot.addWidget(dialog)
    assert dialog.strength == 0.5
    dialog.steadiness.setValue(80.0)
    assert dialog.strength == pytest.approx(0.8)


def test_a_shape_that_is_edited_meanwhile_is_left_as_it_is(
    qtbot: QtBot, document: Document, steadying: Steadying, verb: Steady, plate: Plate
) -> None:
    plate.go.clear()
    with qtbot.waitSignal(steadying.finished, timeout=WAIT) as signal:
        accept(verb)
        assert plate.asked.wait(WAIT / 1000)
        document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("body"), FRAMES[1])))
        edited = document.project
        plate.go.set()
    assert document.project is edited
    assert signal.args[1].endswith(" 1 shape edited or locked meanwhile: left as they are.")


def test_another_project_that_is_opened_meanwhile_gets_nothing(
    qtbot: QtBot, document: Document, steadying: Steadying, verb: Steady, runner: Runner, plate: Plate
) -> None:
    plate.go.clear()
    with qtbot.waitSignal(steadying.finished, timeout=WAIT) as signal:
        accept(verb)
        assert plate.asked.wait(WAIT / 1000)
        other = document.project  # with shapes of the same ids, as the first ones of every project have
        document.open(other, None)
    plate.go.set()
    qtbot.waitUntil(lambda: runner.is_idle, timeout=WAIT)
    assert signal.args[0] is Ending.CANCELLED
    assert document.project is other


def test_stopped_changes_nothing(
    qtbot: QtBot, document: Document, steadying: Steadying, verb: Steady, plate: Plate
) -> None:
    before = document.project
    plate.go.clear()
    with qtbot.waitSignal(steadying.finished, timeout=WAIT) as signal:
        accept(verb)
        assert plate.asked.wait(WAIT / 1000)
        steadying.stop()
        plate.go.set()
    assert tuple(signal.args) == (Ending.CANCELLED, "Stopped; no key was moved.")
    assert document.project is before


def test_what_cannot_be_steadied_is_said(document: Document, view_state: ViewState, verb: Steady) -> None:
    project = document.project
    view_state.set_play_range(1001, 1002)
    verb.ask()
    assert view_state.message == "No tracked key lies between in and out; track or fill the shapes first."
    document.apply("Lock", edit.set_properties(project, "body", locked=True))
    verb.ask()
    assert view_state.message == "Only a closed shape that is not locked can be steadied; unlock or close one."
    document.apply("Delete", edit.remove_items(project, ["body"]))
    verb.ask()
    assert view_state.message == "Draw a shape first: press B in the viewer."
    document.open(Project(), None)
    verb.ask()
    assert view_state.message == NO_CLIP
    assert dialogs() == []


def test_the_window_has_it_between_its_in_and_out(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "clip"), tmp_path / "state") as window:
        truth = {frame: blob(np.full(8, 24.0)) + centre(frame) for frame in range(FIRST, FIRST + COUNT)}
        keys = [
            Keyframe(frame, points + 0.8 * (-1) ** frame, origin=Origin.ARTIST if frame == FIRST else Origin.ENGINE)
            for frame, points in truth.items()
        ]
        window.document.apply("Add", edit.add_shape(window.document.project, RotoShape("body", "Body", tuple(keys))))
        before = window.document.project
        window.view_state.set_play_range(FIRST, FIRST + 5)
        with qtbot.waitSignal(window.under_way.ended, timeout=WAIT) as signal:
            window.actions_by_id["shape.steady"].trigger()
            (dialog,) = dialogs()
            dialog.accept()
        assert signal.args[0] is Ending.DONE
        assert moved(before, window.document.project) == [FIRST + k for k in range(1, 5)]
        window.actions_by_id["edit.undo"].trigger()
        assert window.document.project == before


def test_what_is_typed_at_once_replaces_the_steadiness(qtbot: QtBot, window: QWidget) -> None:
    dialog = SteadyDialog(1, (1001, 1011), window)
    qtbot.addWidget(dialog)
    with qtbot.waitExposed(dialog, timeout=WAIT):
        dialog.show()
    assert dialog.focusWidget() is dialog.steadiness
    qtbot.keyClicks(dialog.steadiness, "80")
    dialog.accept()
    assert dialog.strength == pytest.approx(0.8)
