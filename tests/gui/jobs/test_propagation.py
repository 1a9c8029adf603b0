"""Tracking as a job: one undo step a run, artist keys untouched, an edit of a shape under work ends the run."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import replace

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.features.playback import Playback
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from app.tools.in_hand import ToolInHand
from app.tools.tool import Pointer
from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.frame.result import FrameResult
from roam_core.roto import BlendMode, Keyframe, Origin, Project, RotoShape, edit, layers
from tests.gui.engines import OUT_OF_DATE, Asked, GlidingEngine, put_in
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> GlidingEngine:
    return put_in(monkeypatch, GlidingEngine())


@pytest.fixture
def propagation(document: Document, view_state: ViewState, runner: Runner, engine: GlidingEngine) -> Propagation:
    project, _ = edit.new_shape(Project(), SQUARE, 1)
    project, _ = edit.new_shape(project, SQUARE, 1)
    document.open(project, None)
    return Propagation(document, view_state, runner, lambda frame: None)


def shape(document: Document) -> RotoShape:
    return document.project.shape("shape-1")


def solved(document: Document, frames: list[int]) -> Callable[[], bool]:
    return lambda: [key.frame for key in shape(document).keys if key.origin is Origin.ENGINE] == frames


def run_to_the_third_frame(qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine) -> None:
    """A run over frames 1 to 5 that waits after frame 3."""
    engine.allow(2)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)


def test_a_run_is_one_undo_step_and_the_playhead_goes_with_it(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: GlidingEngine
) -> None:
    before = document.project
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.start(["shape-1"], range(1, 6))
    assert solved(document, [2, 3, 4, 5])()
    assert view_state.frame == 5
    assert document.undo_stack.count() == 1
    assert finished.args == [
        Ending.DONE,
        "Tracked Shape 1 to frame 5: 4 frames, 10 ms each. "
        "1 doubtful frame: <track.most_doubtful> goes to the worst one.",
    ]
    document.undo_stack.undo()
    assert document.project is before


def test_a_run_derives_the_points_of_a_key_that_the_artist_did_not_set(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    tracked = edit.set_engine_keys(shape(document), [Keyframe(3, SQUARE - 5.0, origin=Origin.ENGINE)])
    drawn = edit.key_points(tracked, 3, [0])
    document.apply("Points", document.project.with_shape(drawn))
    before = document.project
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(1, 6))
    key = shape(document).key_at(3)
    assert key is not None
    assert (key.origin, key.set_points) == (Origin.ARTIST, (0,))
    np.testing.assert_array_equal(key.points[0], SQUARE[0] - 5.0)
    np.testing.assert_array_equal(key.points[1:], SQUARE[1:] + 2.0)
    assert solved(document, [2, 4, 5])()
    document.undo_stack.undo()
    assert document.project is before


def test_a_run_takes_over_what_was_out_of_date_on_its_first_frame(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    """As where the artist corrected another part there."""
    stale = Keyframe(2, SQUARE, origin=Origin.ENGINE, confidence=0.9, inputs=OUT_OF_DATE)
    document.apply("Track", document.project.with_shape(edit.set_engine_keys(shape(document), [stale])))
    before = document.project
    engine.allow(1)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(2, 4))
    assert solved(document, [2, 3])()
    np.testing.assert_array_equal(shape(document).at(2).points, SQUARE + 1.0)
    document.undo_stack.undo()
    assert document.project is before


def test_a_frame_without_a_picture_is_bridged_and_told(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    engine.damaged = 3
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.start(["shape-1"], range(1, 6))
    assert solved(document, [2, 4, 5])()
    assert finished.args[1].endswith("each. Bridged without a picture: 1.")


def test_the_status_tells_what_how_far_and_how_fast(
    qtbot: QtBot, propagation: Propagation, engine: GlidingEngine
) -> None:
    told: list[tuple[float, str]] = []
    propagation.progress.connect(lambda fraction, text: told.append((fraction, text)))
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(1, 6))
    assert told[-1] == (1.0, "Tracking Shape 1 forward: frame 5 of 5 · 10 ms a frame")


def test_the_first_frame_which_compiles_says_nothing_of_the_pace(
    qtbot: QtBot, propagation: Propagation, engine: GlidingEngine, monkeypatch: pytest.MonkeyPatch
) -> None:
    def slow_at_first(asked: Asked) -> Iterator[FrameResult]:
        for each in GlidingEngine.found(engine, asked):
            yield replace(each, seconds=7.4) if each.frame == 2 else each

    monkeypatch.setattr(engine, "found", slow_at_first)
    told: list[str] = []
    propagation.progress.connect(lambda _, text: told.append(text))
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: told[-1] == "Tracking Shape 1 forward: frame 2 of 5", timeout=WAIT)
    engine.allow(3)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        pass
    assert told[-1] == "Tracking Shape 1 forward: frame 5 of 5 · 10 ms a frame"
    assert finished.args[1].startswith("Tracked Shape 1 to frame 5: 4 frames, 10 ms each.")


def test_stop_keeps_the_frames_that_are_finished(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.stop()
    assert finished.args == [Ending.CANCELLED, "Tracking stopped at frame 3; the finished frames stay."]
    assert solved(document, [2, 3])()
    assert not propagation.is_running


def test_an_engine_that_does_not_listen_is_not_waited_for(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    engine.is_deaf = True
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.stop()
    assert finished.args == [Ending.CANCELLED, "Tracking stopped at frame 3; the finished frames stay."]
    engine.is_deaf = False
    engine.allow(6)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(3, 6))
    assert solved(document, [2, 3, 4, 5])()


def test_artist_keys_come_back_bit_identical(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    keyed = edit.set_key(shape(document), 3, SQUARE * 2)
    document.apply("Key", document.project.with_shape(keyed))
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(1, 6))
    assert shape(document).key_at(3) is keyed.key_at(3)
    assert solved(document, [2, 4, 5])()


@pytest.mark.parametrize("act", ["edit", "undo", "delete"])
def test_touching_a_shape_under_work_ends_its_run_at_once(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, act: str
) -> None:
    engine.allow(2)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    if act == "edit":
        moved = edit.set_key(shape(document), 3, SQUARE + 1.5)
        document.apply("Move", document.project.with_shape(moved))
    elif act == "undo":
        document.undo_stack.undo()
    else:
        document.apply("Delete", edit.remove_items(document.project, ["shape-1"]))
    assert not propagation.is_running
    after = document.project
    engine.allow(3)
    qtbot.wait(50)
    assert document.project is after


def test_other_edits_leave_the_run_alone(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(solved(document, [2]), timeout=WAIT)
    document.apply("Colour", edit.set_properties(document.project, "shape-1", colour=(1.0, 0.0, 0.0)))
    document.apply("Name", edit.set_properties(document.project, "shape-2", name="Arm"))
    document.apply("Draw", edit.new_shape(document.project, SQUARE + 500.0, 4)[0])
    assert propagation.is_running
    engine.allow(3)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert solved(document, [2, 3, 4, 5])()
    assert shape(document).colour == (1.0, 0.0, 0.0)


@pytest.mark.parametrize("alone", [False, True])
def test_an_edit_of_a_shape_that_is_solved_along_ends_the_run(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, alone: bool
) -> None:
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6), alone=alone)
    qtbot.waitUntil(solved(document, [2]), timeout=WAIT)
    document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("shape-2"), 4)))
    assert propagation.is_running is alone


@pytest.mark.parametrize("alone", [False, True])
def test_restacking_the_shapes_of_an_object_ends_its_run(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, alone: bool
) -> None:
    """What hides what is another thing then: what the run found on would be out of date as it came."""
    run_on_both(qtbot, propagation, document, engine, alone=alone)
    sentences = []
    propagation.finished.connect(lambda _, sentence: sentences.append(sentence))
    document.apply("Raise", layers.raised(document.project, ["shape-1"], 1))
    assert propagation.is_running is alone
    if not alone:
        qtbot.waitUntil(lambda: bool(sentences), timeout=WAIT)
        assert sentences[0].endswith("the finished frames stay. Its shapes were restacked meanwhile.")


def test_restacking_what_is_no_part_of_the_object_leaves_the_run_alone(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    project, far = edit.new_shape(document.project, SQUARE + 500.0, 1)
    document.open(project, None)
    run_on_both(qtbot, propagation, document, engine)
    document.apply("Lower", layers.raised(document.project, [far.id], -1))
    assert propagation.is_running


def run_on_both(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, *, alone: bool = False
) -> None:
    """A run over the two squares, which are one object, that waits after frame 2."""
    engine.allow(1)
    propagation.start(["shape-1", "shape-2"], range(1, 6), alone=alone)
    qtbot.waitUntil(solved(document, [2]), timeout=WAIT)


@pytest.mark.parametrize("values", [{"blend": BlendMode.SUBTRACT}, {"link": "hero"}, {"lifetime": (1, 4)}])
def test_what_decides_how_a_shape_is_solved_ends_its_run(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, values: dict[str, object]
) -> None:
    """What the run found from then on would be out of date as it came."""
    run_to_the_third_frame(qtbot, propagation, document, engine)
    document.apply("Change", edit.set_properties(document.project, "shape-1", **values))
    assert not propagation.is_running


def test_a_run_that_an_edit_ends_says_of_what(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    run_to_the_third_frame(qtbot, propagation, document, engine)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        document.apply("Move", document.project.with_shape(edit.set_key(shape(document), 1, SQUARE + 1.0)))
    told = "Tracking stopped at frame 3; the finished frames stay. Shape 1 was changed meanwhile."
    assert finished.args == [Ending.CANCELLED, told]


@pytest.mark.parametrize("is_in_layer", [False, True])
def test_locking_a_shape_under_work_ends_its_run(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine, is_in_layer: bool
) -> None:
    project, layer = edit.add_layer(Project())
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    document.open(project, None)
    run_to_the_third_frame(qtbot, propagation, document, engine)
    locked = layer.id if is_in_layer else "shape-1"
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        document.apply("Lock", edit.set_properties(document.project, locked, locked=True))
    told = "Tracking stopped at frame 3; the finished frames stay. Shape 1 was locked meanwhile."
    assert finished.args == [Ending.CANCELLED, told]
    engine.allow(2)
    qtbot.waitUntil(lambda: propagation._runner.is_idle, timeout=WAIT)
    assert solved(document, [2, 3])()


def test_a_run_stays_one_step_and_edits_made_meanwhile_are_steps_of_their_own(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    before, stack = document.project, document.undo_stack
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(solved(document, [2]), timeout=WAIT)
    document.apply("Colour", edit.set_properties(document.project, "shape-1", colour=(1.0, 0.0, 0.0)))
    engine.allow(1)
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    document.apply("Name", edit.set_properties(document.project, "shape-2", name="Arm"))
    stack.undo()
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert [stack.text(index) for index in range(stack.count())] == ["Track", "Colour", "Name"]
    stack.redo()
    assert document.project.shape("shape-2").name == "Arm"
    assert solved(document, [2, 3, 4, 5])()
    tracked = shape(document)
    stack.undo()
    assert shape(document) is tracked, "what a later step leaves alone is held once, not by each step anew"
    stack.undo()
    assert shape(document).colour == before.shape("shape-1").colour
    assert solved(document, [2, 3, 4, 5])()
    stack.undo()
    assert document.project is before
    for _ in range(3):
        stack.redo()
    assert solved(document, [2, 3, 4, 5])()
    assert shape(document).colour == (1.0, 0.0, 0.0)


def test_what_is_undone_before_the_first_frame_comes_can_be_done_again(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    before = document.project
    document.apply(
        "Move", document.project.with_shape(edit.set_key(document.project.shape("shape-2"), 1, SQUARE + 7.0))
    )
    moved = document.project.shape("shape-2")
    propagation.start(["shape-1"], range(1, 6), alone=True)
    document.undo_stack.undo()
    engine.allow(2)
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    assert (document.undo_stack.undoText(), document.undo_stack.redoText()) == ("Track", "Move")
    document.undo_stack.redo()
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert solved(document, [2, 3, 4, 5])()
    assert document.project.shape("shape-2") == moved
    document.undo_stack.setIndex(0)
    assert document.project == before
    document.undo_stack.setIndex(2)
    assert solved(document, [2, 3, 4, 5])()
    assert document.project.shape("shape-2") == moved


def test_what_was_undone_before_a_run_began_is_gone_with_it_as_with_any_step(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    document.apply(
        "Move", document.project.with_shape(edit.set_key(document.project.shape("shape-2"), 1, SQUARE + 7.0))
    )
    document.undo_stack.undo()
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.start(["shape-1"], range(1, 6))
    assert not document.undo_stack.canRedo()


def test_a_change_taken_into_the_run_joins_its_step_below_what_the_artist_did(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    before, stack = document.project, document.undo_stack
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(solved(document, [2]), timeout=WAIT)
    document.apply("Colour", edit.set_properties(document.project, "shape-1", colour=(1.0, 0.0, 0.0)))
    split = document.project.with_shape(edit.set_key(shape(document), 2, SQUARE * 2))
    split, part = edit.new_shape(split, SQUARE, 2)
    propagation.go_on_from(split, 2, [part.id])
    assert document.project is split
    engine.allow(4)  # the run before may still take one, and is not listened to
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert [stack.text(index) for index in range(stack.count())] == ["Track", "Colour"]
    assert document.project.shape(part.id).frames == (2, 3, 4, 5)
    stack.undo()
    assert shape(document).colour == before.shape("shape-1").colour
    assert (shape(document).artist_frames, shape(document).frames) == ((1, 2), (1, 2, 3, 4, 5))
    assert document.project.shape(part.id).frames == (2, 3, 4, 5)
    stack.undo()
    assert document.project is before


def test_the_playhead_stays_where_the_artist_scrubbed_to(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: GlidingEngine
) -> None:
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: view_state.frame == 2, timeout=WAIT)
    view_state.set_frame(1)
    engine.allow(3)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert view_state.frame == 1


def test_the_frame_stays_under_the_hand_while_something_is_dragged(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: GlidingEngine
) -> None:
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: view_state.frame == 2, timeout=WAIT)
    other = edit.key_here(document.project.shape("shape-2"), 2)
    view_state.set_preview(document.project.with_shape(other))
    engine.allow(1)
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    assert view_state.frame == 2
    view_state.set_preview(None)
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert view_state.frame == 5


def test_a_run_leaves_the_playhead_alone_while_the_clip_is_played(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: GlidingEngine
) -> None:
    """Also where it comes by the frame that the run showed last: it would jump."""
    playback = Playback(view_state, clock=lambda: 0.0)
    view_state.set_play_range(1, 6)  # a tick takes the playhead into it
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: view_state.frame == 2, timeout=WAIT)
    playback.play()
    engine.allow(1)
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    assert view_state.frame == 2
    playback.pause()
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert view_state.frame == 5


@pytest.mark.parametrize("name", ["bezier", "polygon", "freehand", "ellipse", "object", "points"])
def test_the_frame_stays_while_a_tool_has_something_half_done_on_it(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: GlidingEngine, name: str
) -> None:
    hand = ToolInHand(document, view_state)
    view_state.set_tool(name)
    engine.allow(1)
    propagation.start(["shape-1"], range(1, 6))
    qtbot.waitUntil(lambda: view_state.frame == 2, timeout=WAIT)
    hand.tool.press(Pointer((5.0, 5.0), (1.0, 1.0)))
    engine.allow(1)
    qtbot.waitUntil(solved(document, [2, 3]), timeout=WAIT)
    assert view_state.frame == 2
    hand.tool.drop()
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        pass
    assert view_state.frame == 5


def test_opening_another_project_ends_the_run(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: GlidingEngine
) -> None:
    propagation.start(["shape-1"], range(1, 6))
    document.open(Project(), None)
    assert not propagation.is_running
    engine.allow(4)
    qtbot.wait(50)
    assert document.project == Project()


def test_of_doubtful_frames_ahead_the_next_one_is_offered(
    qtbot: QtBot, propagation: Propagation, view_state: ViewState, engine: GlidingEngine
) -> None:
    view_state.set_frame(2)
    engine.allow(4)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.start(["shape-1"], range(1, 6))
        view_state.set_frame(1)
    assert finished.args[1].endswith("1 doubtful frame: <track.next_doubtful> goes to the next one.")
