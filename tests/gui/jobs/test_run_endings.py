"""What is said of a run that ended: whether its frames are there still, and how many of them there were."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Origin, Project, edit
from tests.gui.engines import OUT_OF_DATE, GlidingEngine, put_in
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
TAKEN_BACK = "Tracking stopped at frame 3; its frames were taken back."


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> GlidingEngine:
    return put_in(monkeypatch, GlidingEngine())


@pytest.fixture
def propagation(document: Document, view_state: ViewState, runner: Runner, engine: GlidingEngine) -> Propagation:
    document.open(edit.new_shape(Project(), SQUARE, 1)[0], None)
    return Propagation(document, view_state, runner, lambda frame: None)


def run_to_the_third_frame(qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine) -> None:
    """A run over frames 1 to 5 that waits after frame 3."""
    engine.allow(2)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: trusted(document, 3), timeout=WAIT)


def trusted(document: Document, frame: int) -> bool:
    key = document.project.shape("shape-1").key_at(frame)
    return key is not None and key.confidence in (0.4, 0.9) and not key.inputs


def undone(document: Document) -> None:
    document.undo_stack.undo()


def deleted_frames(document: Document) -> None:
    shape = document.project.shape("shape-1")
    document.apply("Delete", document.project.with_shape(edit.delete_keys(shape, [2, 3])))


@pytest.mark.parametrize("take_back", [undone, deleted_frames])
def test_frames_that_were_taken_back_are_not_said_to_stay(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine,
    take_back: Callable[[Document], None],
) -> None:  # fmt: skip
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        take_back(document)
    assert finished.args == [Ending.CANCELLED, TAKEN_BACK]


def test_nor_are_they_where_others_lay_in_their_place(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    old = [Keyframe(frame, SQUARE - 5.0, origin=Origin.ENGINE, inputs=OUT_OF_DATE) for frame in (2, 3, 4)]
    shape = edit.set_engine_keys(document.project.shape("shape-1"), old)
    document.apply("Track", document.project.with_shape(shape))
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        document.undo_stack.undo()
    assert finished.args == [Ending.CANCELLED, TAKEN_BACK]


def test_frames_of_a_shape_that_was_deleted_are_not_said_to_stay(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        document.apply("Delete", edit.remove_items(document.project, ["shape-1"]))
    assert finished.args[1] == f"{TAKEN_BACK} Shape 1 was deleted meanwhile."


def test_a_run_that_goes_on_from_a_change_counts_all_its_frames(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    """The doubtful ones are those of the whole run: of one frame two could be doubtful."""
    run_to_the_third_frame(qtbot, propagation, document, engine)
    corrected = edit.set_key(document.project.shape("shape-1"), 3, SQUARE * 2)
    propagation.go_on_from(document.project.with_shape(corrected), 3, [])
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        pass
    assert finished.args[1].startswith("Tracked Shape 1 to frame 5: 4 frames, 10 ms each. 1 doubtful frame")


def test_a_run_that_was_stopped_goes_on_from_no_change(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    """The change stays; nothing that was not asked for begins."""
    run_to_the_third_frame(qtbot, propagation, document, engine)
    corrected = edit.set_key(document.project.shape("shape-1"), 3, SQUARE * 2)
    propagation.stop()
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.go_on_from(document.project.with_shape(corrected), 3, [])
        engine.allow(4)
    qtbot.wait(50)
    assert (finished.args[0], propagation.is_running) == (Ending.CANCELLED, False)
    assert document.project.shape("shape-1").frames == (1, 2, 3)
    np.testing.assert_array_equal(document.project.shape("shape-1").at(3).points, SQUARE * 2)


def test_the_frame_from_which_a_run_goes_on_is_none_of_its_frames(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    """It is solved anew where it is out of date; its doubt was counted, the frame was not."""
    stale = Keyframe(4, SQUARE, origin=Origin.ENGINE, confidence=0.3, inputs=OUT_OF_DATE)
    shape = edit.set_engine_keys(document.project.shape("shape-1"), [stale])
    document.apply("Track", document.project.with_shape(shape))
    engine.allow(1)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.start(["shape-1"], range(4, 6))
    key = document.project.shape("shape-1").key_at(4)
    assert key is not None
    np.testing.assert_array_equal(key.points, SQUARE + 1.0)
    assert finished.args == [Ending.DONE, "Tracked Shape 1 to frame 5: 1 frame, 10 ms."]
