"""Filling as a job: gap by gap, one undo step, artist keys untouched, an edit ends it, what is filled is not redone."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from pytestqt.qtbot import QtBot

from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import UInt8
from roam_core.media import DamagedFrame, MissingFrame
from roam_core.propagate.shapes.gaps import gaps_of
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import edit
from tests.gui.jobs.spans import GAPS, RAMP, SQUARE, Engine, engine_frames
from tests.gui.waiting import WAIT


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


def test_what_ends_in_a_gap_is_filled_up_to_there(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    ends = replace(edit.delete_keys(document.project.shape("shape-2"), [7]), lifetime=(None, 3))
    document.apply("End", document.project.with_shape(ends))
    engine.allow(2)
    for ids in (["shape-1"], ["shape-1", "shape-2"]):
        with qtbot.waitSignal(propagation.finished, timeout=WAIT):
            propagation.fill(ids, GAPS[:1])
    assert engine_frames(document, "shape-2")[0] == 2
    assert engine.asked == [(1, 4, ("shape-1",)), (1, 4, ("shape-1", "shape-2"))]


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


def test_a_fill_begins_again_where_a_part_that_is_solved_along_changes(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    """What was filled with that part as it was is filled anew; the rest comes up to date, too."""
    key = edit.key_here(document.project.shape("shape-2"), 4)
    document.apply("Key", document.project.with_shape(key))
    sentences = []
    propagation.finished.connect(lambda _, sentence: sentences.append(sentence))
    engine.allow(1)
    propagation.fill(["shape-1"], GAPS)
    qtbot.waitUntil(lambda: engine_frames(document) == [2, 3], timeout=WAIT)
    moved = edit.set_key(document.project.shape("shape-2"), 4, SQUARE + 1.5)
    document.apply("Move", document.project.with_shape(moved))
    qtbot.waitUntil(lambda: propagation._run is not None and len(sentences) == 1, timeout=WAIT)
    engine.allow(3)  # the ended fill may take one
    qtbot.waitUntil(lambda: len(sentences) == 2, timeout=WAIT)
    assert sentences[0].endswith("the finished frames stay. Shape 2 was changed meanwhile. It goes on from that.")
    stamps = Stamps.of(document.project.shapes, document.project.clip)
    shape = document.project.shape("shape-1")
    assert engine_frames(document) == [2, 3, 5, 6]
    assert not any(stamps.is_stale(shape, key) for key in shape.keys)


def test_a_key_of_a_part_beside_the_gaps_leaves_the_fill_alone(
    qtbot: QtBot, propagation: Propagation, document: Document, engine: Engine
) -> None:
    propagation.fill(["shape-1"], GAPS)
    keyed = edit.key_here(document.project.shape("shape-2"), 11)
    document.apply("Key", document.project.with_shape(keyed))
    document.apply("Delete", edit.remove_items(document.project, ["shape-2"]))  # it has no key on 4
    assert propagation.is_running
    engine.allow(2)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        pass
    assert finished.args[0] is Ending.DONE


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
