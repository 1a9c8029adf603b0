"""The status bar: a sentence that is cut with a sign of it, the memory of the frames in a unit that shows it."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QObject, Signal
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.features.tracking import Tracking
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.jobs.under_way import UnderWay
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.bars.status import Sentence, StatusBar
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Project, edit
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
MB, GB = 2**20, 2**30


@pytest.mark.parametrize(
    ("used", "limit", "told"),
    [
        (0, GB, "memory 0 MB of 1.0 GB"),
        (960 * 540 * 3, GB, "memory 1.5 MB of 1.0 GB"),
        (75 * MB, GB, "memory 75 MB of 1.0 GB"),
        (3 * GB // 2, 8 * GB, "memory 1.5 GB of 8.0 GB"),
        (0, 0, ""),  # no plate
    ],
)
def test_the_memory_of_the_frames(qtbot: QtBot, view_state: ViewState, used: int, limit: int, told: str) -> None:
    status = StatusBar(view_state, UnderWay())
    qtbot.addWidget(status)
    status.show_memory(used, limit)
    assert status._memory.text() == told


def test_a_sentence_without_room_keeps_its_beginning_and_its_end(qtbot: QtBot) -> None:
    sentence = Sentence()
    qtbot.addWidget(sentence)

    def looks(text: str, width: int) -> QImage:
        sentence.setText(text)
        sentence.resize(width, 26)
        return sentence.grab().toImage()

    one, two = (f"/shots/of/a/long/show/{name}/with/a/long/name.roam cannot be written" for name in ("one", "two"))
    three = one.replace("cannot be written", "is written")
    assert looks(one, 120) == looks(two, 120)
    assert looks(one, 120) != looks(three, 120)
    assert looks(one, 600) != looks(two, 600)


def test_what_was_said_before_goes_with_the_next_edit(
    qtbot: QtBot, qapp: QApplication, document: Document, view_state: ViewState
) -> None:
    status = StatusBar(view_state, UnderWay())
    qtbot.addWidget(status)
    status.follow(document)
    view_state.say_hint("Click an outline.")

    def after(sentence: str, *, is_older: bool = True, is_drag: bool = False, tells: str = "") -> str:
        """What is said after an edit, of a drag that may tell something itself."""
        view_state.say(sentence)
        if is_older:
            qapp.processEvents()
        view_state.set_preview(Project() if is_drag else None)
        if tells:
            view_state.say(tells)
            qapp.processEvents()
        document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])
        view_state.set_preview(None)
        return status.sentence.text()

    assert after("Hat is locked; unlock it to track it.") == "Click an outline."
    assert after("Hat is a B-spline.", is_older=False) == "Hat is a B-spline."
    assert after("Hat is a B-spline.", is_drag=True) == "Click an outline."
    assert after("Hat is a B-spline.", is_drag=True, tells="Move +3.0, +2.0 px") == "Move +3.0, +2.0 px"
    view_state.advise("Hat is drawn: drag its points.")
    assert after(view_state.message) == "Hat is drawn: drag its points."


def test_frames_of_a_run_take_no_sentence_away(qtbot: QtBot, qapp: QApplication, document: Document) -> None:
    view_state, work = ViewState(), Work()
    status = StatusBar(view_state, UnderWay(work))
    qtbot.addWidget(status)
    status.follow(document)
    work.progress.emit(0.5, "Tracking")
    view_state.say("Hat is locked; unlock it to track it.")
    qapp.processEvents()
    document.apply("Track", edit.new_shape(document.project, SQUARE, 1)[0])
    assert status.sentence.text() == "Hat is locked; unlock it to track it."


def test_a_hint_that_is_left_where_a_place_is_left_does_not_hide_how_far_a_run_is(
    qtbot: QtBot, view_state: ViewState
) -> None:
    """Whoever looked at another frame meanwhile read the tool's hint for some seconds."""
    work = Work()
    status = StatusBar(view_state, UnderWay(work))
    qtbot.addWidget(status)
    view_state.say_hint("Click an outline.")
    view_state.advise("Hat is drawn: drag its points.")
    work.progress.emit(0.5, "Tracking")
    view_state.select(frozenset({"hat"}))
    assert view_state.message == "Click an outline."
    assert status.sentence.text() == "Tracking"
    view_state.say_here("There is no key after this frame.")
    assert status.sentence.text() == "There is no key after this frame."
    view_state.select(frozenset())
    assert status.sentence.text() == "Tracking"
    view_state.say_hint("Click a point.")
    assert status.sentence.text() == "Click a point."


def with_a_post(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner
) -> tuple[Propagation, StatusBar]:
    """A torso that is drawn on the first frame, and a post before it that is drawn where it comes in."""
    project, _ = edit.new_shape(Project(Clip(Path("shot"), 1, 9, (64, 48))), SQUARE, 1, name="Torso")
    document.open(edit.new_shape(project, SQUARE, 5, name="Post")[0], None)
    view_state.set_play_range(1, 10)
    propagation = Propagation(document, view_state, runner, lambda frame: None)
    status = StatusBar(view_state, UnderWay(propagation))
    qtbot.addWidget(status)
    return propagation, status


def test_what_a_run_leaves_out_is_read_before_how_far_it_is(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It gave way at once to the sentence with which a run begins: an occluder that is drawn where it comes in."""
    engine = put_in(monkeypatch, GlidingEngine())
    propagation, status = with_a_post(qtbot, document, view_state, runner)
    Tracking(document, view_state, propagation).forward()
    engine.allow(2)
    qtbot.waitUntil(lambda: view_state.frame == 3, timeout=WAIT)
    left_out = "Post is not tracked: its first key lies on frame 5. Track from there, or set a key here"
    assert status.sentence.text().startswith(left_out)
    status.reading.setInterval(0)
    qtbot.waitUntil(lambda: status.sentence.text().startswith("Tracking Torso forward"), timeout=WAIT)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        propagation.drop()


def test_the_end_of_a_short_run_waits_until_it_is_read_what_it_left_out(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After one frame the end took its place."""
    put_in(monkeypatch, GlidingEngine()).allow(1)
    propagation, status = with_a_post(qtbot, document, view_state, runner)
    with qtbot.waitSignal(propagation.finished, timeout=WAIT):
        Tracking(document, view_state, propagation).forward_one()
    assert status.sentence.text().startswith("Post is not tracked: its first key lies on frame 5.")
    assert view_state.message.startswith("Tracked Torso")
    status.reading.timeout.emit()
    assert status.sentence.text() == view_state.message


@pytest.mark.parametrize("ending", [Ending.CANCELLED, Ending.FAILED])
def test_a_run_that_ends_before_its_end_says_so_at_once(qtbot: QtBot, view_state: ViewState, ending: Ending) -> None:
    work = Work()
    status = StatusBar(view_state, UnderWay(work))
    qtbot.addWidget(status)
    work.progress.emit(0.0, "Tracking")
    view_state.say("Post is not tracked.")
    work.finished.emit(ending, "It ended.")
    assert status.sentence.text() == "It ended."


def test_work_that_ends_without_a_word_is_told_no_more(qtbot: QtBot, view_state: ViewState) -> None:
    work = Work()
    status = StatusBar(view_state, UnderWay(work))
    qtbot.addWidget(status)
    view_state.say("Opened shot.")
    work.progress.emit(0.0, "Looking at other …")
    work.finished.emit(Ending.DONE, "")
    assert status.sentence.text() == "Opened shot."


class Work(QObject):
    progress = Signal(float, str)
    finished = Signal(object, str)

    def stop(self) -> None:
        """Nothing goes on."""


def test_at_rest_the_memory_gives_way_to_a_sentence_that_lacks_room(qtbot: QtBot, view_state: ViewState) -> None:
    status = StatusBar(view_state, UnderWay())
    qtbot.addWidget(status)
    status.show_memory(75 * MB, GB)
    status.resize(420, 26)
    view_state.say("Short.")
    assert not status._memory.isHidden()
    view_state.say("A sentence that tells what to do next and needs nearly all of the bar to tell it.")
    assert status._memory.isHidden()
    status.resize(1600, 26)
    status._fit()
    assert not status._memory.isHidden()
