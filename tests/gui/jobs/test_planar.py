"""The planar track: a layer around the shapes moves, one undo step a run, shapes stay editable, Stop keeps frames."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.canvas.view import CanvasView
from app.features.planar_tracking import PlanarTracking
from app.features.tracking import NO_CLIP, Tracking
from app.jobs.planar import PlanarTrack
from app.jobs.propagation import Propagation
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.planar import PlanarPanel
from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.params import DOUBTFUL
from roam_core.roto import BlendMode, Clip, Layer, Project, edit
from roam_core.roto.following import pinned, still, surface_at
from roam_core.roto.layers import grouped
from roam_core.roto.surfaces import LeaveOut, covering, legs_of
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT
from tests.unit.motion import test_plane_track as board

LAST = 6
KIND = PlaneMotion.SIMILARITY


class Plate:
    """Pictures of the board, one for each `allow`; `None` of them is held back at first."""

    def __init__(self) -> None:
        self.gate = threading.Semaphore(1000)

    def hold(self, frames: int) -> None:
        """Let only so many more frames be read."""
        self.gate = threading.Semaphore(frames)

    def read(self, frame: int) -> np.ndarray:
        assert self.gate.acquire(timeout=WAIT / 1000)
        return board.picture(KIND, frame - 1)


@pytest.fixture
def plate() -> Plate:
    return Plate()


@pytest.fixture
def track(document: Document, view_state: ViewState, runner: Runner, plate: Plate) -> PlanarTrack:
    """A selected shape on the board on frame 1, and nothing under way."""
    project = Project(clip=Clip(board.__file__, 1, LAST, (board.WIDTH, board.HEIGHT)))
    project, shape = edit.new_shape(project, board.BOARD, 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    view_state.set_play_range(1, LAST + 1)
    return PlanarTrack(document, view_state, runner, plate.read)


@pytest.fixture
def verbs(document: Document, view_state: ViewState, track: PlanarTrack) -> PlanarTracking:
    return PlanarTracking(document, view_state, track)


def finish(qtbot: QtBot, track: PlanarTrack, begin: Callable[[], object]) -> tuple[Ending, str]:
    with qtbot.waitSignal(track.finished, timeout=WAIT) as signal:
        begin()
    return tuple(signal.args)


def miss(document: Document, frame: int) -> float:
    """By how many pixels the shape misses the board."""
    true = projective.apply(board.true_motion(KIND, frame - 1), board.BOARD[:, ANCHOR])
    return float(np.abs(document.project.shape("shape-1").at(frame).anchors - true).max())


def layer(document: Document) -> Layer:
    item = document.project.find("layer-1")
    assert isinstance(item, Layer)
    return item


def test_the_shape_follows_in_one_undo_step(
    qtbot: QtBot, document: Document, view_state: ViewState, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    before = document.project
    ending, sentence = finish(qtbot, track, verbs.forward)
    assert ending is Ending.DONE
    assert sentence.startswith(f"Followed the plane to frame {LAST}: {LAST - 1} frames")
    assert layer(document).name == "Planar 1"
    assert layer(document).transform.frames == tuple(range(1, LAST + 1))
    assert max(miss(document, frame) for frame in range(1, LAST + 1)) < 0.5
    assert view_state.frame == LAST
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project is before


def test_what_turns_on_wide_pixels_is_followed_as_it_is_shown(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner
) -> None:
    clip = Clip(board.__file__, 1, LAST, (board.WIDTH // 2, board.HEIGHT), pixel_aspect=2.0)
    project, shape = edit.new_shape(Project(clip=clip), board.NARROW, 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    track = PlanarTrack(document, view_state, runner, lambda frame: board.squeezed(KIND, frame - 1))
    finish(qtbot, track, lambda: track.start([shape.id], range(1, LAST + 1), KIND))
    corners = document.project.shape(shape.id).at(LAST).anchors
    assert np.abs(corners - board.squeezed_corners(KIND, LAST - 1)).max() < 0.5


def test_backward_goes_on_with_the_same_layer(
    qtbot: QtBot, document: Document, view_state: ViewState, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    view_state.set_frame(3)
    here = projective.apply(board.true_motion(KIND, 2), board.BOARD)
    document.open(document.project.with_shape(edit.set_key(document.project.shape("shape-1"), 3, here)), None)
    document.apply("Delete", document.project.with_shape(edit.delete_keys(document.project.shape("shape-1"), [1])))
    view_state.select(frozenset({"shape-1"}))
    finish(qtbot, track, verbs.backward)
    view_state.set_frame(3)
    finish(qtbot, track, verbs.forward)
    assert [item.id for item in document.project.root.items()] == ["layer-1", "shape-1"]
    assert max(miss(document, frame) for frame in range(1, LAST + 1)) < 0.5


@pytest.mark.parametrize("way", ["locked", "deleted"])
def test_locking_or_deleting_the_shape_ends_the_track(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking, plate: Plate, way: str
) -> None:
    plate.hold(3)
    verbs.forward()
    qtbot.waitUntil(lambda: document.project.has("layer-1") and layer(document).transform.frames[-1] == 3, timeout=WAIT)
    with qtbot.waitSignal(track.finished, timeout=WAIT) as finished:
        if way == "locked":
            document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
        else:
            document.apply("Delete", edit.remove_items(document.project, ["shape-1"]))
    said = f"Planar track stopped at frame 3; the finished frames stay. Shape 1 was {way} meanwhile."
    assert (finished.args, track.is_running) == ([Ending.CANCELLED, said], False)
    plate.gate.release(10)
    qtbot.waitUntil(lambda: track._runner.is_idle, timeout=WAIT)
    assert layer(document).transform.frames == (1, 2, 3)


def test_stop_keeps_what_is_finished(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking, plate: Plate
) -> None:
    plate.hold(3)
    verbs.forward()
    qtbot.waitUntil(lambda: document.project.has("layer-1") and layer(document).transform.frames[-1] == 3, timeout=WAIT)

    def stop() -> None:
        track.stop()
        plate.gate.release(5)

    ending, sentence = finish(qtbot, track, stop)
    assert ending is Ending.CANCELLED
    assert sentence == "Planar track stopped at frame 3; the finished frames stay."
    assert layer(document).transform.frames == (1, 2, 3)
    assert not track.is_running


def test_shapes_are_edited_while_it_runs(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking, plate: Plate
) -> None:
    plate.hold(2)
    verbs.forward()
    qtbot.waitUntil(lambda: document.project.has("layer-1"), timeout=WAIT)
    shape = document.project.shape("shape-1")
    edited = shape.at(2).points + np.array([5.0, 0.0])
    document.apply("Move", document.project.with_shape(edit.set_key(shape, 2, edited)))
    assert track.is_running
    ending, _ = finish(qtbot, track, lambda: plate.gate.release(50))
    assert ending is Ending.DONE
    np.testing.assert_allclose(document.project.shape("shape-1").at(2).points, edited, atol=1e-9)
    off = document.project.shape("shape-1").at(LAST).anchors - projective.apply(
        board.true_motion(KIND, LAST - 1), board.BOARD[:, ANCHOR]
    )
    np.testing.assert_allclose(np.hypot(*off.T), 5.0, atol=0.8)  # the correction goes along, turned with the plane
    assert document.undo_stack.count() == 2  # the whole run, and the correction on top of it
    document.undo_stack.undo()
    assert layer(document).transform.frames[-1] == LAST
    assert miss(document, LAST) < 0.5
    document.undo_stack.undo()
    assert not document.project.has("layer-1")


def test_undo_ends_the_run(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking, plate: Plate
) -> None:
    before = document.project
    plate.hold(2)
    verbs.forward()
    qtbot.waitUntil(lambda: document.project.has("layer-1"), timeout=WAIT)
    document.undo_stack.undo()
    assert not track.is_running
    plate.gate.release(50)
    assert document.project is before


def test_a_group_that_is_done_again_after_a_run_does_not_move_in_its_place(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking, plate: Plate
) -> None:
    """It has the id that the layer of the run has without it, and holds another shape, too."""
    document.apply("Draw", edit.new_shape(document.project, 0.1 * board.BOARD, 1)[0])
    document.apply("Group", grouped(document.project, ["shape-1", "shape-2"])[0])
    plate.hold(1)
    verbs.forward()
    document.undo_stack.undo()
    ending, _ = finish(qtbot, track, lambda: plate.gate.release(50))
    assert ending is Ending.DONE
    document.undo_stack.redo()
    assert layer(document).transform is None
    assert max(miss(document, frame) for frame in range(1, LAST + 1)) < 0.5


def test_a_run_after_the_motion_was_removed_moves_the_same_layer(
    qtbot: QtBot, document: Document, view_state: ViewState, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    finish(qtbot, track, verbs.forward)
    document.apply("Remove", still(document.project, "layer-1"))
    removed = document.project
    view_state.set_frame(1)
    finish(qtbot, track, verbs.forward)
    assert [item.id for item in document.project.root.items()] == ["layer-1", "shape-1"]
    assert max(miss(document, frame) for frame in range(1, LAST + 1)) < 0.5
    document.undo_stack.undo()
    assert document.project is removed


def test_a_lost_plane_is_told_and_the_frames_before_stay(
    qtbot: QtBot, document: Document, runner: Runner, view_state: ViewState, track: PlanarTrack
) -> None:
    def read(frame: int) -> np.ndarray:
        return board.picture(KIND, frame - 1) if frame < 4 else np.full((board.HEIGHT, board.WIDTH, 3), 80, np.uint8)

    blind = PlanarTrack(document, view_state, runner, read)
    ending, sentence = finish(qtbot, blind, lambda: blind.start(["shape-1"], range(1, LAST + 1), KIND))
    assert ending is Ending.FAILED
    assert "lost on frame 4" in sentence
    assert layer(document).transform.frames == (1, 2, 3)


def test_what_cannot_be_tracked_says_why(
    document: Document, view_state: ViewState, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    view_state.set_frame(LAST)
    verbs.forward()
    assert view_state.message == "The clip ends here: there is no frame to track to."
    view_state.set_play_range(2, LAST)
    for verb, frame, word in ((verbs.forward, LAST - 1, "The out point is here"), (verbs.backward, 2, "The in point")):
        view_state.set_frame(frame)
        verb()
        assert view_state.message.startswith(word)
    view_state.set_frame(1)
    document.open(edit.set_properties(document.project, "shape-1", closed=False), None)
    verbs.forward()
    assert "is open" in view_state.message
    document.open(edit.set_properties(document.project, "shape-1", locked=True), None)
    verbs.forward()
    assert "is locked" in view_state.message
    document.open(Project(clip=document.project.clip), None)
    verbs.forward()
    assert view_state.message.startswith("Draw a shape first")
    document.open(Project(), None)
    verbs.forward()
    assert view_state.message == NO_CLIP
    assert not track.is_running


def test_confidence_is_kept_and_told(
    qtbot: QtBot, document: Document, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    _, sentence = finish(qtbot, track, verbs.forward)
    told = dict(layer(document).transform.confidence)
    assert sorted(told) == list(range(2, LAST + 1))
    assert min(told.values()) > DOUBTFUL
    assert f"Confidence is {min(told.values()):.2f} at least." in sentence


def test_it_warns_once_while_it_runs_and_n_goes_there(
    qtbot: QtBot, document: Document, runner: Runner, view_state: ViewState, track: PlanarTrack
) -> None:
    """A motion that is too simple: the board turns and grows."""
    track = PlanarTrack(document, view_state, runner, lambda frame: board.picture(KIND, frame - 1))
    said: list[str] = []
    track.doubted.connect(said.append)
    finish(qtbot, track, lambda: track.start(["shape-1"], range(1, LAST + 1), PlaneMotion.TRANSLATION))
    told = dict(layer(document).transform.confidence)
    first = min(frame for frame, trust in told.items() if trust < DOUBTFUL)
    assert said == [f"Planar track: look at frame {first}, the confidence is {told[first]:.2f} there."]
    view_state.set_frame(1)
    tracking = Tracking(document, view_state, Propagation(document, view_state, runner, lambda frame: None))
    tracking.next_doubtful()
    assert view_state.frame == first
    assert view_state.message == f"Frame {first}: the confidence of the track Planar 1 is {told[first]:.2f}."


def test_a_run_over_an_adjust_key_is_drawn_to_it_and_begins_anew_there(
    qtbot: QtBot, document: Document, view_state: ViewState, track: PlanarTrack, verbs: PlanarTracking
) -> None:
    finish(qtbot, track, verbs.forward)
    drawn = surface_at(document.project, "layer-1", 4) + 1.5
    document.apply("Adjust", pinned(document.project, "layer-1", 4, drawn))
    view_state.set_frame(1)
    finish(qtbot, track, verbs.forward)
    np.testing.assert_allclose(surface_at(document.project, "layer-1", 4), drawn, atol=1e-6)
    assert layer(document).transform.adjusted == (1, 4)
    off = [miss(document, frame) for frame in range(1, LAST + 1)]
    assert off[0] < 0.1
    assert off[1] < off[2] < off[3]  # the artist's word weighs the more the nearer
    assert min(off[4:]) > 1.0  # from there the track goes on from what the artist said


def test_what_lies_above_is_left_out(document: Document, track: PlanarTrack) -> None:
    project, above = edit.new_shape(document.project, board.BOARD * 0.5, 1)
    project, hidden = edit.new_shape(project, board.BOARD * 0.5, 1)
    project = edit.set_properties(project, hidden.id, visible=False)

    def left_out(chosen: str, which: LeaveOut) -> list[str]:
        return [shape.id for shape in covering(project, [chosen], 1, which)]

    assert left_out("shape-1", LeaveOut.ABOVE) == [above.id]
    assert left_out(above.id, LeaveOut.ABOVE) == []
    assert left_out(above.id, LeaveOut.OTHERS) == ["shape-1"]
    assert left_out("shape-1", LeaveOut.NOTHING) == []
    project = edit.set_properties(project, "shape-1", depth=((1, 1),))
    assert left_out("shape-1", LeaveOut.ABOVE) == []  # brought before all


def test_legs_end_on_adjust_keys() -> None:
    assert legs_of(range(1, 8), (1, 4, 7, 20)) == (range(1, 5), range(4, 8))
    assert legs_of(range(7, 0, -1), (4,)) == (range(7, 3, -1), range(4, 0, -1))
    assert legs_of(range(1, 4), ()) == (range(1, 4),)


def test_holes_and_shapes_that_are_gone_are_told_apart(document: Document, track: PlanarTrack) -> None:
    from roam_core.roto.surfaces import outlines_at

    project, hole = edit.new_shape(document.project, board.BOARD * 0.5, 1)
    project, gone = edit.new_shape(project, board.BOARD, 1)
    project = edit.set_properties(project, hole.id, blend=BlendMode.SUBTRACT)
    project = edit.set_properties(project, gone.id, lifetime=(5, 9))
    outlines, holes = outlines_at(project.shapes, 1)
    assert [len(outlines), len(holes)] == [1, 1]
    np.testing.assert_array_equal(holes[0], board.BOARD * 0.5)


def test_the_panel_chooses_the_motion_and_the_keys_start_it(
    qtbot: QtBot, canvas: CanvasView, hand: Hand, document: Document, view_state: ViewState, runner: Runner
) -> None:
    verbs = PlanarTracking(document, view_state, PlanarTrack(document, view_state, runner, lambda frame: None))
    actions = Actions(canvas, canvas, load_keymap())
    panel = PlanarPanel(document, verbs, actions)
    qtbot.addWidget(panel)
    panel.kind.setCurrentIndex(panel.kind.findData(PlaneMotion.HOMOGRAPHY))
    assert verbs.kind is PlaneMotion.HOMOGRAPHY
    calls: list[str] = []
    actions.connect_all({name: lambda name=name: calls.append(name) for name in verbs.handlers()})
    actions["planar.forward"].trigger()
    actions["planar.backward"].trigger()
    assert calls == ["planar.forward", "planar.backward"]
    panel.leave_out.setCurrentIndex(panel.leave_out.findData(LeaveOut.OTHERS))
    assert verbs.leave_out is LeaveOut.OTHERS
    assert panel.kind.focusPolicy() is Qt.FocusPolicy.TabFocus


def test_shapes_are_left_out_one_by_one(
    qtbot: QtBot, canvas: CanvasView, document: Document, view_state: ViewState, track: PlanarTrack,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    project, names = document.project, {}
    for name in ("screen", "hand", "cup"):
        project, shape = edit.new_shape(project, board.BOARD, 1)
        project = edit.set_properties(project, shape.id, name=name)
        names[name] = shape.id
    document.apply("Draw", project)
    view_state.select(frozenset({names["screen"]}))
    verbs = PlanarTracking(document, view_state, track)
    panel = PlanarPanel(document, verbs, Actions(canvas, canvas, load_keymap()))
    qtbot.addWidget(panel)
    panel.chosen.aboutToShow.emit()
    listed = {action.text(): action for action in panel.chosen.actions()}
    assert list(listed)[:3] == ["cup", "hand", "screen"]
    listed["hand"].trigger()
    assert verbs.leave_out is LeaveOut.CHOSEN
    panel.chosen.aboutToShow.emit()
    assert [action.text() for action in panel.chosen.actions() if action.isChecked()] == ["hand"]
    started: list[tuple[object, ...]] = []
    monkeypatch.setattr(track, "start", lambda *given: started.append(given))
    verbs.forward()
    assert started[0][0] == [names["screen"]]
    assert started[0][3] == [names["hand"]]
    document.open(Project(clip=document.project.clip), None)
    assert verbs.left_out == frozenset()
