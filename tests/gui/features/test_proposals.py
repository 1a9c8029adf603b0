"""Proposals in the window: shown before and after with their gain, kept, refused, always, never, remembered."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QEvent, Qt
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.features.proposals import NONE_LEFT, sentence_of
from app.shell.main_window import MainWindow
from roam_core.geometry import bezier
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS
from roam_core.propagate.frame.result import FrameResult, Termination, TrackResult
from roam_core.propagate.frame.topology_proposals import Proposal
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import governing_key
from roam_core.proposal.reshaping.topology import TopologyChange, TopologyKind
from roam_core.roto import Keyframe, Origin, RotoShape, edit, timing
from roam_core.roto.layers import grouped
from tests.gui.engines import Asked, StandIn, put_in
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, opened_window, write_clip

LAST = FIRST + COUNT - 1
OFFERED = FIRST + 3, FIRST + 4, FIRST + 5
LEFT, RIGHT = ((20, 20), (60, 20), (60, 70), (20, 70)), ((90, 30), (120, 30), (120, 60), (90, 60))
WHOLE = polygon_points([(20, 20), (60, 20), (60, 42), (90, 42), (90, 30), (120, 30), (120, 60), (90, 60), (90, 48),
                        (60, 48), (60, 70), (20, 70)])  # fmt: skip
RINGS = tuple(bezier.flatten(polygon_points(list(ring))) for ring in (LEFT, RIGHT))
CTRL = Qt.KeyboardModifier.ControlModifier


class Engine(StandIn):
    """The shape stands still, and on three frames it is offered to be split."""

    def __init__(self) -> None:
        self.kind, self.asked = TopologyKind.SPLIT, list[tuple[tuple[str, ...], int]]()

    def found(self, asked: Asked) -> Iterator[FrameResult]:
        frames = asked.frames
        stamps = Stamps(asked.shapes, asked.clip, asked.read(frames[0]).size)
        self.asked.append((tuple(shape.id for shape in asked.wanted), frames[0]))
        for frame in frames[1:]:
            asked.token.check()
            solved = [self.solved(shape, frames, frame, asked.config, stamps) for shape in asked.wanted]
            yield FrameResult(frame, tuple(solved))

    def solved(self, shape: RotoShape, frames: range, frame: int, config: str, stamps: Stamps) -> TrackResult:
        source = governing_key(shape, frame, forward=frames.step > 0)
        assert source is not None
        place = stamps.shapes.index(shape)
        inputs = stamps.tracked(place, frame, frames[0], CONFIGS[config], frames.step > 0)
        key = Keyframe(frame, source.points, origin=Origin.ENGINE, confidence=0.9, inputs=inputs)
        moved = edit.set_engine_keys(shape, [key])
        rings = RINGS if self.kind is TopologyKind.SPLIT else RINGS[:1]
        change = TopologyChange(self.kind, rings, 12.34)
        is_whole = len(shape.at(frames[0]).points) == len(WHOLE) and np.array_equal(source.points, WHOLE)
        offers = (Proposal.of(change, moved, frame, 1.0),) if frame in OFFERED and is_whole else ()
        return TrackResult(frame, moved, 0.9, {}, Termination.CONVERGED, 0.01, offers)


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> Engine:
    engine = Engine()
    shape = RotoShape("s", "Warm", (Keyframe(FIRST, WHOLE),))
    change = TopologyChange(TopologyKind.SPLIT, RINGS, 1.0)
    assert Proposal.of(change, shape, FIRST, 1.0).after  # compiles what no run may have to wait for
    return put_in(monkeypatch, engine)


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path, engine: Engine) -> Iterator[MainWindow]:
    """A window with a shape of two parts and a thread between them on the first frame."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        draw(window)
        yield window


def draw(window: MainWindow) -> None:
    project, shape = edit.new_shape(window.document.project, WHOLE, FIRST, name="Bell")
    window.document.apply("Draw", project)
    window.view_state.select(frozenset([shape.id]))


def track(qtbot: QtBot, window: MainWindow) -> None:
    window.view_state.set_frame(FIRST)
    with qtbot.waitSignal(window.propagation.finished, timeout=WAIT):
        qtbot.keyClick(window.canvas, Qt.Key.Key_BracketRight)


def names(window: MainWindow) -> list[str]:
    return [shape.name for shape in window.document.project.shapes]


def area_of(window: MainWindow, shape_id: str, frame: int) -> float:
    shape = window.document.project.shape(shape_id)
    x, y = shape.at(frame).flatten().T
    return abs(float(np.dot(x, np.roll(y, 1)) - np.dot(y, np.roll(x, 1)))) / 2


def test_a_run_tells_of_proposals_and_changes_nothing_by_itself(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    assert window.view_state.message.endswith("1 proposal to answer: Alt+P goes there.")
    assert names(window) == ["Bell"]
    assert window.proposals.frames == [OFFERED[0]]
    assert not window.proposal_bar.isVisible()
    assert not window.actions_by_id["proposal.keep"].isEnabled()


def test_what_is_offered_of_a_locked_shape_does_not_stand(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    document, place = window.document, window.document.project.shapes[0].id
    document.apply("Lock", edit.set_properties(document.project, place, locked=True))
    assert window.proposals.frames == []
    document.apply("Unlock", edit.set_properties(document.project, place, locked=False))
    assert window.proposals.frames == [OFFERED[0]]


def test_the_viewer_shows_before_and_after_with_the_gain(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0] - 1)
    plain = window.canvas.grab().toImage()
    qtbot.keyClick(window.canvas, Qt.Key.Key_P, Qt.KeyboardModifier.AltModifier)
    assert window.view_state.frame == OFFERED[0]
    assert window.proposal_bar.isVisible()
    assert window.proposal_bar.sentence.text() == "Split Bell into 2 shapes?  The energy falls by 12.3."
    assert window.canvas.rect().contains(window.proposal_bar.geometry())
    window.proposal_bar.hide()
    shown = window.canvas.grab().toImage()

    def change(x: float, y: float) -> int:
        """By how much a row of ten pixels was changed by the proposal."""
        spot = window.canvas.image_to_widget(x, y).toPoint()
        row = [(spot.x() + step, spot.y()) for step in range(10)]
        return sum(abs(shown.pixelColor(*at).red() - plain.pixelColor(*at).red()) for at in row)

    assert change(72, 45) > 200  # the thread that would go is hatched
    assert change(40, 35) < 100  # what stays is as it was; the plate itself has moved by a frame


def test_while_others_are_soloed_nothing_is_asked_about_what_is_not_shown(qtbot: QtBot, window: MainWindow) -> None:
    bell = window.document.project.shapes[0].id
    project, other = edit.new_shape(window.document.project, WHOLE + 3.0, FIRST, name="Other")
    window.document.apply("Draw", project)
    window.view_state.solo.set({other.id}, window.document.project)
    track(qtbot, window)
    assert window.view_state.message.endswith("not shown while others are soloed; Ctrl+H shows all.")
    window.view_state.set_frame(OFFERED[0])
    assert not window.proposal_bar.isVisible()
    assert window.canvas.proposed() is None
    window.view_state.say("")
    window.proposals.next()
    assert "Ctrl+H shows all" in window.view_state.message
    window.view_state.solo.set({bell}, window.document.project)
    assert window.proposal_bar.isVisible()
    window.view_state.solo.set({other.id}, window.document.project)
    assert not window.proposal_bar.isVisible()
    assert not window.actions_by_id["proposal.keep"].isEnabled()
    window.view_state.solo.set((), window.document.project)
    assert window.proposals.frames == [OFFERED[0]]


def test_an_answer_shows_what_it_would_leave_while_the_pointer_rests_on_it(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    bar, canvas = window.proposal_bar, window.canvas
    gap = canvas.image_to_widget(75, 45).toPoint()

    def looks() -> list[tuple[int, ...]]:
        shown = canvas.grab().toImage()
        return [shown.pixelColor(gap.x() + step, gap.y()).getRgb() for step in range(10)]

    both = looks()
    for answer in ("proposal.refuse", "proposal.keep"):
        qtbot.mouseMove(bar.buttons[answer])
        QApplication.sendEvent(bar.buttons[answer], QEvent(QEvent.Type.Enter))
        assert looks() != both  # the hatching of what would go is gone
        QApplication.sendEvent(bar.buttons[answer], QEvent(QEvent.Type.Leave))
        assert looks() == both


def test_the_bar_fits_into_the_viewer_with_its_answers_whatever_the_windows_width(
    qtbot: QtBot, window: MainWindow
) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    bar, canvas = window.proposal_bar, window.canvas
    has_legend = []
    for width in (1100, 1280, 1700):
        window.resize(width, 800)
        qtbot.waitUntil(lambda: canvas.rect().contains(bar.geometry()), timeout=WAIT)
        has_legend.append(bar.legend.isVisible())
        assert bar.buttons["proposal.refuse_always"].isVisible()
    assert has_legend[0] is False
    assert has_legend[-1] is True


def test_the_bar_tells_its_keys_and_what_the_gain_means(qtbot: QtBot, window: MainWindow) -> None:
    bar = window.proposal_bar
    assert [label.text() for label in bar._keys.values()] == ["Return", "Backspace"]
    assert "agree with the picture" in bar.sentence.toolTip()


def test_enter_keeps_it_as_the_artists_and_undo_asks_again(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    before = window.document.project
    window.view_state.set_frame(OFFERED[1])
    window.view_state.set_keymap({**window.view_state.keymap, "track.forward": ("Ctrl+9",)})
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    assert window.view_state.message == "Kept: it is yours now. Ctrl+9 tracks on from here."
    assert names(window) == ["Bell", "Bell part 1"]
    assert window.document.project.shape("shape-1").artist_frames == (FIRST, OFFERED[1])
    assert window.document.project.shape("shape-2").frames == (OFFERED[1],)
    assert window.document.project.shape("shape-2").lifetime == (OFFERED[1], LAST + 1)
    assert area_of(window, "shape-1", OFFERED[1]) == pytest.approx(2000, rel=0.1)
    assert area_of(window, "shape-2", OFFERED[1]) == pytest.approx(900, rel=0.1)
    assert window.view_state.selection.shapes == {"shape-1", "shape-2"}
    assert not window.proposal_bar.isVisible()
    window.view_state.set_frame(OFFERED[2])  # tracked from the old outline: stale, and so is its proposal
    assert not window.proposal_bar.isVisible()
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)
    assert window.document.project is before
    assert window.proposal_bar.isVisible()


def test_what_is_refused_is_told_as_waiting_no_more(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    assert window.view_state.message.endswith("1 proposal to answer: Alt+P goes there.")
    window.actions_by_id["proposal.next"].trigger()
    window.actions_by_id["proposal.refuse"].trigger()
    assert window.view_state.message == "Left as it is."


def test_backspace_refuses_it_for_the_frames_around_too(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    before = window.document.project
    window.view_state.set_frame(OFFERED[1])
    qtbot.keyClick(window.canvas, Qt.Key.Key_Backspace)
    assert window.document.project is before
    for frame in OFFERED:
        window.view_state.set_frame(frame)
        assert not window.proposal_bar.isVisible()
    qtbot.keyClick(window.canvas, Qt.Key.Key_P, Qt.KeyboardModifier.AltModifier)
    assert window.view_state.message == NONE_LEFT


def test_an_edit_of_the_frame_withdraws_its_proposal(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    assert window.proposal_bar.isVisible()
    qtbot.keyClick(window.canvas, Qt.Key.Key_S)
    assert not window.proposal_bar.isVisible()
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    assert names(window) == ["Bell"]


def test_a_part_that_came_off_is_dropped(qtbot: QtBot, window: MainWindow, engine: Engine) -> None:
    engine.kind = TopologyKind.DROP
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    assert window.proposal_bar.sentence.text().startswith("Drop the part that came off Bell?")
    qtbot.keyClick(window.canvas, Qt.Key.Key_Enter)
    assert names(window) == ["Bell"]
    assert area_of(window, "shape-1", OFFERED[0]) == pytest.approx(2000, rel=0.1)


def test_always_makes_the_change_during_the_run_which_goes_on_with_all_parts(
    qtbot: QtBot, window: MainWindow, engine: Engine
) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    always = window.actions_by_id["proposal.keep_always"]
    assert always.isEnabled()
    always.trigger()
    assert names(window) == ["Bell", "Bell part 1"]
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)
    untracked = window.document.project
    track(qtbot, window)
    assert names(window) == ["Bell", "Bell part 1"]
    assert engine.asked[-2:] == [(("shape-1",), FIRST), (("shape-1", "shape-2"), OFFERED[0])]
    bell, part = window.document.project.shapes
    assert bell.frames == tuple(range(FIRST, LAST + 1))
    assert bell.artist_frames == (FIRST, OFFERED[0])
    assert part.frames == tuple(range(OFFERED[0], LAST + 1))
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)  # the run with its change is one step
    assert window.document.project is untracked


def test_what_came_off_lies_in_its_layer_also_where_a_later_step_is_undone(
    qtbot: QtBot, window: MainWindow, engine: Engine
) -> None:
    document = window.document
    project, layer = grouped(document.project, {"shape-1"})
    document.apply("Group", project)
    window.proposals.answers[""] = {"shape-1": "always"}
    frames: list[int] = []

    def mark_meanwhile(result: FrameResult, _step: int) -> None:
        frames.append(result.frame)
        if len(frames) == 2:
            document.apply("Mark frame", timing.set_mark(document.project, FIRST, "meanwhile"))

    window.propagation.solved.connect(mark_meanwhile)
    track(qtbot, window)
    document.undo_stack.undo()
    assert not document.project.marks
    part = next(shape for shape in document.project.shapes if shape.name == "Bell part 1")
    assert document.project.layers_above(part.id)[-1].id == layer.id
    assert len({shape.compound for shape in document.project.shapes}) == 1


def test_a_change_on_the_last_frame_of_a_run_ends_it_in_good_order(
    qtbot: QtBot, window: MainWindow, engine: Engine
) -> None:
    window.proposals.answers[""] = {"shape-1": "always"}
    window.view_state.set_play_range(FIRST, OFFERED[0] + 1)
    track(qtbot, window)
    assert names(window) == ["Bell", "Bell part 1"]
    assert len(engine.asked) == 1
    assert not window.propagation.is_running


def test_never_asks_no_more_until_it_is_wanted_again(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    window.actions_by_id["proposal.refuse_always"].trigger()
    for wanted in (False, True):
        qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)
        track(qtbot, window)
        assert bool(window.proposals.frames) is wanted
        window.view_state.select(frozenset(["shape-1"]))
        window.actions_by_id["proposal.ask_again"].trigger()
    assert window.view_state.message == "You will be asked about Bell again."


def test_what_was_answered_for_good_is_remembered_by_project(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    window.actions_by_id["proposal.refuse_always"].trigger()
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(tmp_path / "bell.roam")
    window.keep_settings(tmp_path / "window.ini")
    window.proposals.answers.clear()
    window.restore_settings(tmp_path / "window.ini")
    assert window.proposals.answer("shape-1") == "never"
    window.files.new()
    assert window.proposals.answer("shape-1") is None
    (tmp_path / "window.ini").write_text("[General]\nproposals=nonsense\n")
    window.restore_settings(tmp_path / "window.ini")


def test_a_new_project_is_not_answered_by_one_that_was_never_saved(qtbot: QtBot, window: MainWindow) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    window.actions_by_id["proposal.refuse_always"].trigger()
    assert window.proposals.answer("shape-1") == "never"
    window.files.new()
    assert window.proposals.answer("shape-1") is None


def test_what_was_answered_for_good_holds_for_another_clip_of_a_project_that_was_never_saved(
    qtbot: QtBot, window: MainWindow
) -> None:
    track(qtbot, window)
    window.view_state.set_frame(OFFERED[0])
    window.actions_by_id["proposal.refuse_always"].trigger()
    window.document.relink(replace(window.document.project.require_clip(), fps=30.0))
    assert window.proposals.answer("shape-1") == "never"


def test_the_sentence_tells_the_gain_in_three_figures() -> None:
    shape = RotoShape("s", "Wing", (Keyframe(FIRST, WHOLE),))
    offer = Proposal.of(TopologyChange(TopologyKind.DROP, RINGS[:1], 1234.4), shape, FIRST, 1.0)
    assert sentence_of(offer) == "Drop the part that came off Wing?  The energy falls by 1234."
