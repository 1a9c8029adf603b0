"""Filling as a job: gap by gap, one undo step, artist keys untouched, an edit ends it, what is filled is not redone."""

from __future__ import annotations

import threading
from collections.abc import Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs.filling import gaps_of
from app.jobs.planar import PlanarTrack
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import UInt8
from roam_core.cancel import CancelToken
from roam_core.geometry.bezier import polygon_points
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.media import DamagedFrame, MissingFrame
from roam_core.propagate.between import span
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit
from tests.gui.engines import GlidingEngine, put_in

WAIT = 5000
SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1, 12, (64, 48))
SIZE = 48, 64
GAPS = [(1, 4), (4, 7)]
RAMP = np.broadcast_to((4 * np.arange(SIZE[1]) % 256)[None, :, None], (*SIZE, 3)).astype(np.uint8)
"""A picture that shows something."""


class Engine:
    """Stands in for `fill_span`: one gap for each `allow`, and a look at a picture of every gap."""

    def __init__(self) -> None:
        self.gate = threading.Semaphore(0)
        self.asked: list[tuple[int, int, tuple[str, ...]]] = []
        self.passed_over: tuple[int, ...] = ()

    def allow(self, gaps: int) -> None:
        self.gate.release(gaps)

    def fill_span(
        self, images: Mapping[int, Any], shapes: Sequence[RotoShape], start: int, stop: int, *rest: Any
    ) -> list[RotoShape]:
        params, token, progress, clip, asked, alone = rest
        assert isinstance(token, CancelToken)
        progress(0.5, "Half way")
        while not self.gate.acquire(timeout=0.01):
            token.check()
        assert isinstance(images[start], np.ndarray)
        self.asked.append((start, stop, tuple(shape.id for shape in shapes if shape.id in asked)))
        stamps = Stamps(shapes, clip, SIZE)
        filled = []
        for k, shape in enumerate(shapes):
            inputs = stamps.filled(k, (start, stop), params, alone)
            keys = [
                Keyframe(f, SQUARE + f, origin=Origin.ENGINE, confidence=0.3, inputs=inputs)
                for f in range(start + 1, stop)
                if f not in self.passed_over
            ]
            filled.append(edit.set_engine_keys(shape, keys))
        return filled


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    engine = Engine()
    monkeypatch.setattr(span, "fill_span", engine.fill_span)
    return engine


@pytest.fixture
def propagation(document: Document, view_state: ViewState, runner: Runner, engine: Engine) -> Propagation:
    """A square with artist keys on 1, 4 and 7, and one with keys on 1 and 7."""
    project, first = edit.new_shape(Project(CLIP), SQUARE, 1)
    project, second = edit.new_shape(project, SQUARE, 1)
    project = project.with_shape(edit.key_here(edit.key_here(first, 4), 7)).with_shape(edit.key_here(second, 7))
    document.open(project, None)
    return Propagation(document, view_state, runner, lambda frame: RAMP)


@pytest.fixture
def held(document: Document, view_state: ViewState, runner: Runner, propagation: Propagation) -> HeldTrack:
    return HeldTrack(document, view_state, runner, propagation)


class HeldTrack:
    """A planar track that waits for its first picture until it is ended."""

    def __init__(self, document: Document, view: ViewState, runner: Runner, propagation: Propagation) -> None:
        self._picture = threading.Event()
        self.track = PlanarTrack(document, view, runner, self._read, None, propagation.make_way)

    def begin(self) -> None:
        self.track.start(["shape-2"], range(1, 8), PlaneMotion.SIMILARITY)

    def end(self) -> None:
        self.track.drop()
        self._picture.set()

    def _read(self, frame: int) -> UInt8:
        assert self._picture.wait(WAIT / 1000)
        return RAMP


def engine_frames(document: Document, shape_id: str = "shape-1") -> list[int]:
    return [key.frame for key in document.project.shape(shape_id).keys if key.origin is Origin.ENGINE]


def test_gaps_are_told_by_their_keys_and_not_twice(propagation: Propagation, document: Document) -> None:
    assert gaps_of(document.project.shapes) == [(1, 4), (1, 7), (4, 7)]
    assert gaps_of([edit.key_here(document.project.shape("shape-2"), 2)]) == [(2, 7)]


def test_a_fill_is_one_undo_step_and_the_playhead_stays(
    qtbot: QtBot, propagation: Propagation, document: Document, view_state: ViewState, engine: Engine
) -> None:
    before = document.project
    told: list[tuple[float, str]] = []
    propagation.progress.connect(lambda fraction, text: told.append((fraction, text)))
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.fill(["shape-1"], GAPS)
    assert engine_frames(document) == [2, 3, 5, 6]
    assert document.project.shape("shape-1").artist_frames == (1, 4, 7)
    assert document.project.shape("shape-1").key_at(4) is before.shape("shape-1").key_at(4)
    assert view_state.frame == 1
    assert finished.args == [
        Ending.DONE,
        "Filled 2 gaps between frames 1 and 7. 4 doubtful frames: <track.next_doubtful> goes to the next one.",
    ]
    assert (0.25, "Filling frames 2 to 3") in told
    assert document.undo_stack.count() == 1
    assert document.undo_stack.undoText() == "Fill"
    document.undo_stack.undo()
    assert document.project is before


def test_what_is_filled_already_is_not_solved_again(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    sentences = []
    propagation.finished.connect(lambda _, sentence: sentences.append(sentence))
    engine.allow(4)
    for act in (None, None, "move a key"):
        if act:
            moved = edit.set_key(document.project.shape("shape-1"), 7, SQUARE + 3)
            document.apply("Move", document.project.with_shape(moved))
        with qtbot.waitSignal(propagation.finished, timeout=WAIT):
            propagation.fill(["shape-1"], GAPS)
    assert [asked[:2] for asked in engine.asked] == [*GAPS, (4, 7)]
    assert sentences[1] == "Filled already: nothing that it depends on has changed."


def test_frames_that_a_fill_passed_over_are_not_solved_again(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, propagation: Propagation, engine: Engine
) -> None:
    def read(frame: int) -> UInt8:
        if frame == 2:
            raise DamagedFrame("Frame 2 is damaged.")
        return np.zeros_like(RAMP) if frame == 6 else RAMP

    engine.allow(4)
    engine.passed_over = 2, 6
    looking = Propagation(document, view_state, runner, read)
    for _ in range(2):
        with qtbot.waitSignal(looking.finished, timeout=WAIT):
            looking.fill(["shape-1"], GAPS)
    assert [asked[:2] for asked in engine.asked] == GAPS
    assert engine_frames(document) == [3, 5]


def test_a_gap_of_which_no_frame_shows_anything_is_not_solved_at_all(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, propagation: Propagation, engine: Engine
) -> None:
    def read(frame: int) -> UInt8:
        if frame == 2:
            raise MissingFrame("The plate has no frame 2.")
        return np.zeros_like(RAMP) if frame == 3 else RAMP

    looking = Propagation(document, view_state, runner, read)
    with qtbot.waitSignal(looking.finished, timeout=WAIT) as finished:
        looking.fill(["shape-1"], GAPS[:1])
    assert not engine.asked
    assert finished.args == [Ending.DONE, "No frame between these keys shows anything: there is nothing to fill."]
    engine.allow(1)
    with qtbot.waitSignal(looking.finished, timeout=WAIT):
        looking.fill(["shape-1"], GAPS)
    assert [asked[:2] for asked in engine.asked] == GAPS[1:]


def test_shapes_keyed_inside_a_gap_are_left_out_of_it(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    engine.allow(3)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.fill(["shape-1", "shape-2"], [*GAPS, (1, 7)])
    assert (1, 7, ("shape-2",)) in engine.asked
    assert engine_frames(document, "shape-2") == [2, 3, 4, 5, 6]


def test_stop_keeps_the_gaps_that_are_finished(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    engine.allow(1)
    propagation.fill(["shape-1"], GAPS)
    qtbot.waitUntil(lambda: engine_frames(document) == [2, 3], timeout=WAIT)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        propagation.stop()
    assert finished.args == [
        Ending.CANCELLED, "Filling stopped after the gap up to frame 4; the finished frames stay."
    ]  # fmt: skip
    assert engine_frames(document) == [2, 3]


def test_a_gap_that_cannot_be_filled_does_not_lose_the_others(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, propagation: Propagation, engine: Engine
) -> None:
    def read(frame: int) -> UInt8:
        if frame == 1:
            raise DamagedFrame("Frame 1 is damaged.")
        return RAMP

    damaged = Propagation(document, view_state, runner, read)
    engine.allow(2)
    with qtbot.waitSignal(damaged.finished, timeout=WAIT) as finished:
        damaged.fill(["shape-1"], GAPS)
    assert finished.args == [Ending.FAILED, "1 of 2 gap(s) could not be filled: Frame 1 is damaged."]
    assert engine_frames(document) == [5, 6]


def test_an_edit_of_a_shape_under_work_ends_the_fill_at_once(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    moved = edit.set_key(document.project.shape("shape-1"), 4, SQUARE + 1.5)
    document.apply("Move", document.project.with_shape(moved))
    assert not propagation.is_running
    engine.allow(2)
    qtbot.wait(50)
    assert engine_frames(document) == []


# ---- one fill after the other


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
    engine.allow(1)
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
