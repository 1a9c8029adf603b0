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
from app.features.tracking import NO_CLIP
from app.jobs.planar import PlanarTrack
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.planar import PlanarPanel
from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.roto import BlendMode, Clip, Layer, Project, edit
from tests.gui.hand import Hand
from tests.unit.motion import test_plane_track as board

WAIT = 20_000
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
    assert sentence == "The planar track stopped at frame 3; the finished frames stay."
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


def test_holes_and_shapes_that_are_gone_are_told_apart(document: Document, track: PlanarTrack) -> None:
    from app.jobs.planar import outlines_at

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
    panel = PlanarPanel(verbs, actions)
    qtbot.addWidget(panel)
    panel.kind.setCurrentIndex(panel.kind.findData(PlaneMotion.HOMOGRAPHY))
    assert verbs.kind is PlaneMotion.HOMOGRAPHY
    calls: list[str] = []
    actions.connect_all({name: lambda name=name: calls.append(name) for name in verbs.handlers()})
    actions["planar.forward"].trigger()
    actions["planar.backward"].trigger()
    assert calls == ["planar.forward", "planar.backward"]
    assert panel.kind.focusPolicy() is Qt.FocusPolicy.NoFocus
