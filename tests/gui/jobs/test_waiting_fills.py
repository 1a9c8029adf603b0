"""Fills that wait for others, or go on after what took their place."""

from __future__ import annotations

import threading
from dataclasses import replace

import pytest
from pytestqt.qtbot import QtBot

from app.jobs.propagation import Propagation
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.roto import edit
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.jobs.spans import GAPS, SQUARE, Engine, HeldTrack, engine_frames
from tests.gui.waiting import WAIT


def test_a_fill_of_other_shapes_waits_for_the_one_under_way(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2"], [(1, 7)])
    assert view_state.message == "Filling Shape 2 begins when the fill under way has ended."
    engine.allow(3)
    qtbot.waitUntil(lambda: bool(engine_frames(document, "shape-2")) and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document) == [2, 3, 5, 6]
    assert [ids for *_, ids in engine.asked] == [("shape-1",), ("shape-1",), ("shape-2",)]
    assert document.undo_stack.count() == 2
    document.undo_stack.undo()
    assert (engine_frames(document), engine_frames(document, "shape-2")) == ([2, 3, 5, 6], [])


def test_what_ends_one_fill_does_not_end_those_that_wait(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2"], [(1, 7)])
    document.apply("Move", document.project.with_shape(edit.set_key(document.project.shape("shape-1"), 4, SQUARE + 3)))
    engine.allow(2)  # the fill that was ended may take one before it hears of that
    qtbot.waitUntil(lambda: bool(engine_frames(document, "shape-2")) and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document) == []


@pytest.mark.parametrize("tracked", ["", "shape-1", "shape-2"])
def test_a_run_that_takes_the_place_of_a_fill_leaves_those_of_other_shapes_waiting(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, monkeypatch: pytest.MonkeyPatch,
    tracked: str,
) -> None:  # fmt: skip
    """What the new run is about waits no more: something else was asked of it since. What was begun goes on first."""
    gliding = put_in(monkeypatch, GlidingEngine())
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2"], [(1, 7)])
    if tracked:
        propagation.start([tracked], range(7, 10))
    else:
        propagation.fill(["shape-1"], [(4, 7)])
    gliding.allow(2)
    engine.allow(3)  # the fill that was ended may take one before it hears of that
    qtbot.waitUntil(lambda: not propagation.is_running and not propagation._waiting, timeout=WAIT)
    made = engine_frames(document), engine_frames(document, "shape-2")
    assert (
        made
        == {"": ([5, 6], [2, 3, 4, 5, 6]), "shape-1": ([8, 9], [2, 3, 4, 5, 6]), "shape-2": ([2, 3, 5, 6], [8, 9])}[
            tracked
        ]
    )


def test_a_fill_goes_on_in_its_undo_step_after_a_track_of_another_shape(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, monkeypatch: pytest.MonkeyPatch
) -> None:
    gliding = put_in(monkeypatch, GlidingEngine())
    propagation.fill(["shape-1"], GAPS)
    engine.allow(1)
    qtbot.waitUntil(lambda: engine_frames(document) == [2, 3], timeout=WAIT)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.start(["shape-2"], range(7, 10))
    assert finished.args[1] == (
        "Filling stopped after the gap up to frame 4; the finished frames stay. It goes on after what begins now."
    )
    gliding.allow(2)
    qtbot.waitUntil(lambda: engine_frames(document, "shape-2") == [8, 9], timeout=WAIT)
    engine.allow(1)
    qtbot.waitUntil(lambda: engine_frames(document) == [2, 3, 5, 6] and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document, "shape-2") == [8, 9]
    stack = document.undo_stack
    assert [stack.text(index) for index in range(stack.count())] == ["Fill", "Track"]
    assert [gap for *gap, _ in engine.asked] == [[1, 4], [4, 7]]


@pytest.mark.parametrize("way", ["undone", "stopped"])
def test_a_fill_that_is_not_wanted_any_more_does_not_go_on(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, monkeypatch: pytest.MonkeyPatch,
    way: str,
) -> None:  # fmt: skip
    gliding = put_in(monkeypatch, GlidingEngine())
    propagation.fill(["shape-1"], GAPS)
    engine.allow(1)
    qtbot.waitUntil(lambda: engine_frames(document) == [2, 3], timeout=WAIT)
    if way == "stopped":
        propagation.stop()
    propagation.start(["shape-2"], range(7, 10))
    if way == "undone":
        document.undo_stack.undo()
    gliding.allow(2)
    qtbot.waitUntil(lambda: engine_frames(document, "shape-2") == [8, 9], timeout=WAIT)
    engine.allow(1)
    qtbot.waitUntil(lambda: not propagation.is_running and not propagation._waiting, timeout=WAIT)
    qtbot.wait(50)
    assert (engine_frames(document), engine_frames(document, "shape-2")) == ([2, 3] if way == "stopped" else [], [8, 9])
    assert len(engine.asked) == 1


def test_of_a_fill_that_waits_shapes_that_are_locked_or_gone_are_left_out(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    project, _ = edit.new_shape(document.project, SQUARE, 1)
    project = project.with_shape(edit.key_here(project.shape("shape-3"), 7))
    document.apply("Third", edit.add_shape(project, replace(project.shape("shape-3"), id="shape-4")))
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2", "shape-3", "shape-4"], [(1, 7)])
    document.apply("Lock", edit.set_properties(document.project, "shape-2", locked=True))
    document.apply("Delete", edit.remove_items(document.project, ["shape-4"]))
    engine.allow(3)
    qtbot.waitUntil(lambda: bool(engine_frames(document, "shape-3")) and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document, "shape-2") == []


def test_a_fill_that_waits_begins_after_a_planar_track_that_took_the_place_of_the_one_before(
    qtbot: QtBot, propagation: Propagation, document: Document, runner: Runner, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2"], [(1, 7)])
    may_end = threading.Event()
    other = runner.start("track", lambda _: str(may_end.wait()))  # as a planar track is started
    with qtbot.waitSignal(other.started, timeout=WAIT):
        pass
    engine.allow(1)
    may_end.set()
    qtbot.waitUntil(lambda: bool(engine_frames(document, "shape-2")) and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document) == []


@pytest.mark.parametrize("way", ["locked", "deleted"])
def test_a_fill_goes_on_with_the_others_where_one_of_its_shapes_is_locked_or_deleted(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, way: str
) -> None:
    """All of it ended there, though a fill that waits leaves such shapes out."""
    propagation.fill(["shape-1", "shape-2"], [*GAPS, (1, 7)])
    engine.allow(1)
    qtbot.waitUntil(lambda: bool(engine_frames(document)), timeout=WAIT)
    said: list[str] = []
    propagation.finished.connect(lambda _ending, sentence: said.append(sentence))
    if way == "locked":
        document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    else:
        document.apply("Delete", edit.remove_items(document.project, ["shape-1"]))
    assert said[0].endswith(f"Shape 1 was {way} meanwhile. It goes on with the others.")
    engine.allow(3)
    qtbot.waitUntil(lambda: len(engine_frames(document, "shape-2")) == 5 and not propagation.is_running, timeout=WAIT)
    assert engine.asked[-1] == (1, 7, ("shape-2",))


def test_a_fill_whose_only_shape_is_deleted_or_that_is_undone_does_not_go_on(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    document.apply("Delete", edit.remove_items(document.project, ["shape-1"]))
    assert not propagation.is_running
    document.undo_stack.undo()
    propagation.fill(["shape-1", "shape-2"], [*GAPS, (1, 7)])
    engine.allow(1)
    qtbot.waitUntil(lambda: bool(engine_frames(document)), timeout=WAIT)
    document.undo_stack.undo()
    engine.allow(3)
    qtbot.wait(50)
    assert not propagation.is_running
    assert not propagation._waiting
    assert engine_frames(document) == []


def test_a_fill_goes_on_after_a_planar_track_that_is_begun_while_it_runs(
    qtbot: QtBot, propagation: Propagation, document: Document, held: HeldTrack, engine: Engine
) -> None:
    """It ended there, and nobody said so but the status bar."""
    propagation.fill(["shape-1"], GAPS)
    engine.allow(1)
    qtbot.waitUntil(lambda: bool(engine_frames(document)), timeout=WAIT)
    first = engine_frames(document)
    said: list[str] = []
    propagation.finished.connect(lambda _ending, sentence: said.append(sentence))
    held.begin()
    assert (said[0].endswith("It goes on after what begins now."), propagation.is_running) == (True, False)
    engine.allow(len(GAPS))
    held.end()
    qtbot.waitUntil(lambda: len(engine_frames(document)) > len(first) and not propagation.is_running, timeout=WAIT)
    assert engine_frames(document) == [2, 3, 5, 6]
    assert document.undo_stack.count() == 1


def test_a_fill_that_is_begun_while_a_surface_is_tracked_waits_for_it(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, held: HeldTrack, engine: Engine
) -> None:
    """It ended the track."""
    held.begin()
    propagation.fill(["shape-1"], GAPS)
    assert view_state.message == "Filling Shape 1 begins when the planar track has ended."
    engine.allow(len(GAPS))
    qtbot.wait(50)
    assert (held.track.is_running, propagation.is_running) == (True, False)
    held.end()
    qtbot.waitUntil(lambda: len(engine_frames(document)) == 4 and not propagation.is_running, timeout=WAIT)


@pytest.mark.parametrize("way", ["stop", "drop", "gone", "keyed", "locked"])
def test_no_fill_begins_that_is_not_wanted_any_more(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, way: str
) -> None:
    """Esc means all of them."""
    propagation.fill(["shape-1"], GAPS)
    propagation.fill(["shape-2"], [(1, 7)])
    if way == "stop":
        propagation.stop()
    elif way == "drop":
        propagation.drop()
    elif way == "keyed":
        document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("shape-2"), 3)))
    elif way == "locked":
        document.apply("Lock", edit.set_properties(document.project, "shape-2", locked=True))
    else:
        document.apply("Delete", edit.remove_items(document.project, ["shape-2"]))
    engine.allow(3)
    qtbot.waitUntil(lambda: not propagation.is_running and not propagation._waiting, timeout=WAIT)
    assert {ids for *_, ids in engine.asked} <= {("shape-1",)}


@pytest.mark.parametrize("way", ["locked", "deleted"])
def test_a_fill_that_was_stopped_does_not_go_on_with_the_others(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine, way: str
) -> None:
    propagation.fill(["shape-1", "shape-2"], [*GAPS, (1, 7)])
    propagation.stop()
    if way == "locked":
        document.apply("Lock", edit.set_properties(document.project, "shape-2", locked=True))
    else:
        document.apply("Delete", edit.remove_items(document.project, ["shape-2"]))
    engine.allow(3)
    qtbot.waitUntil(lambda: not propagation.is_running and not propagation._waiting, timeout=WAIT)
    qtbot.wait(50)
    assert (engine.asked, engine_frames(document)) == ([], [])
