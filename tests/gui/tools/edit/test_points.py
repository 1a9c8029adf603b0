"""The points tool: up to four points with their areas; a track follows them, and the shapes in hand go along."""

from __future__ import annotations

import threading
from collections.abc import Callable

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.features.planar_tracking import PlanarTracking, points_at
from app.jobs.planar import PlanarTrack
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.track_points import TrackPoints
from app.model.view_state import ViewState
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.params import DOUBTFUL
from roam_core.roto import Clip, Layer, Project, Spline, edit
from roam_core.roto.control_points import is_of_its_kind
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT
from tests.unit.motion import test_plane_track as board

KIND, LAST = PlaneMotion.SIMILARITY, 6
MARKS = ((120.0, 100.0), (185.0, 140.0))
"""On the board on frame 1."""


@pytest.fixture
def pointed(document: Document, view_state: ViewState, canvas: CanvasView) -> None:
    """An open line beside the board, in the hand; the tool, too."""
    project = Project(clip=Clip(board.__file__, 1, LAST, (board.WIDTH, board.HEIGHT)))
    project, shape = edit.new_shape(project, board.BOARD, 1, closed=False)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    view_state.set_play_range(1, LAST + 1)
    view_state.set_tool("points")


def places(view_state: ViewState) -> np.ndarray:
    assert view_state.track_points is not None
    return np.array(view_state.track_points.places)


def finish(qtbot: QtBot, track: PlanarTrack, begin: Callable[[], object]) -> tuple[Ending, str]:
    with qtbot.waitSignal(track.finished, timeout=WAIT) as signal:
        begin()
    return tuple(signal.args)


def test_clicks_put_points_and_drags_move_them(
    hand: Hand, view_state: ViewState, document: Document, pointed: None
) -> None:
    for spot in ((120, 100), (180, 100), (180, 150), (120, 150), (60, 60)):
        hand.click(spot)
    assert len(places(view_state)) == 4
    assert "Four points are enough" in view_state.message
    assert not hand.canvas.tool.is_busy
    hand.drag((180, 150), (190, 158))
    np.testing.assert_allclose(places(view_state)[2], (190, 158), atol=0.8)
    hand.key(Qt.Key.Key_Backspace)
    assert len(places(view_state)) == 3
    hand.key(Qt.Key.Key_Delete)  # it deleted the selected shape
    assert len(places(view_state)) == 2
    hand.key(Qt.Key.Key_Escape)
    assert len(places(view_state)) == 0
    assert document.undo_stack.count() == 0


def test_esc_in_a_drag_leaves_the_point(hand: Hand, view_state: ViewState, pointed: None) -> None:
    hand.click((120, 100))
    before = view_state.track_points
    hand.press((120, 100))
    hand.move((150, 120))
    hand.key(Qt.Key.Key_Escape)
    hand.release((150, 120))
    assert view_state.track_points == before


def test_the_areas_grow_together() -> None:
    points = TrackPoints.on(1, (1920, 1080))
    assert points.pattern == 12.0 * 1080 / 480
    larger = points.grown(1.5)
    assert larger.pattern == 1.5 * points.pattern
    assert larger.search == 1.5 * points.search
    assert points.grown(1e-6).pattern == 5.0


def test_shapes_go_with_two_points(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, runner: Runner, pointed: None
) -> None:
    for spot in MARKS:
        hand.click(spot)
    begun = places(view_state)
    track = PlanarTrack(document, view_state, runner, lambda frame: board.picture(KIND, frame - 1))
    verbs = PlanarTracking(document, view_state, track)
    ending, sentence = finish(qtbot, track, verbs.forward)
    assert ending is Ending.DONE
    assert sentence.startswith(f"Followed the points to frame {LAST}: {LAST - 1} frames.")
    layer = document.project.find("layer-1")
    assert isinstance(layer, Layer)
    assert min(dict(layer.transform.confidence).values()) > DOUBTFUL
    true = board.true_motion(KIND, LAST - 1)
    shape = document.project.shape("shape-1")
    np.testing.assert_allclose(shape.at(LAST).anchors, projective.apply(true, board.BOARD[:, 0]), atol=0.8)
    assert document.undo_stack.count() == 1
    # The project keeps them, so that they can be taken up again.
    view_state.track_points = None
    kept = points_at(document.project, view_state, ["shape-1"])
    np.testing.assert_allclose(kept.places, projective.apply(true, begun), atol=0.5)
    assert (kept.pattern, kept.search) == (12.0, 28.0)
    # The points have gone along: a press takes one where it is now.
    assert view_state.frame == LAST
    here = projective.apply(true, begun)
    hand.drag(tuple(here[0]), tuple(here[0] + 6.0))
    assert view_state.track_points.frame == LAST
    np.testing.assert_allclose(places(view_state)[1], here[1], atol=0.5)
    document.open(document.project, None)
    assert view_state.track_points is None


def test_selected_points_alone_go_along(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, runner: Runner, pointed: None
) -> None:
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 0), ("shape-1", 3)}))
    hand.click(MARKS[0])
    begun = places(view_state)
    track = PlanarTrack(document, view_state, runner, lambda frame: board.picture(PlaneMotion.TRANSLATION, frame - 1))
    verbs = PlanarTracking(document, view_state, track)
    ending, _ = finish(qtbot, track, verbs.forward)
    assert ending is Ending.DONE
    assert not document.project.has("layer-1")
    shape = document.project.shape("shape-1")
    assert shape.artist_frames == tuple(range(1, LAST + 1))
    moved = board.true_motion(PlaneMotion.TRANSLATION, LAST - 1)
    corners = board.BOARD[:, 0]
    np.testing.assert_allclose(shape.at(LAST).anchors[[0, 3]], projective.apply(moved, corners[[0, 3]]), atol=0.3)
    np.testing.assert_array_equal(shape.at(LAST).anchors[[1, 2]], corners[[1, 2]])
    np.testing.assert_allclose(places(view_state), projective.apply(moved, begun), atol=0.3)
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project.shape("shape-1").artist_frames == (1,)


@pytest.mark.parametrize("way", ["grown", "undone"])
def test_a_point_that_comes_and_undo_end_a_track_of_points_by_their_numbers(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, runner: Runner, pointed: None, way: str
) -> None:
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 3)}))
    hand.click(MARKS[0])
    gate = threading.Semaphore(3)

    def read(frame: int) -> np.ndarray:
        assert gate.acquire(timeout=WAIT / 1000)
        return board.picture(PlaneMotion.TRANSLATION, frame - 1)

    track = PlanarTrack(document, view_state, runner, read)
    PlanarTracking(document, view_state, track).forward()
    qtbot.waitUntil(lambda: 2 in document.project.shape("shape-1").frames, timeout=WAIT)
    if way == "undone":
        document.undo_stack.undo()
    else:
        grown = edit.insert_point(document.project.shape("shape-1"), 0, 0.5)
        document.apply("Insert point", document.project.with_shape(grown))
    left = document.project.shape("shape-1")
    assert not track.is_running
    gate.release(LAST)
    qtbot.waitUntil(lambda: runner.is_idle, timeout=WAIT)
    assert document.project.shape("shape-1") == left


def test_of_a_b_spline_the_chosen_control_points_alone_go_along(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, runner: Runner, pointed: None
) -> None:
    """The curve's own points of the same numbers were moved: no B-spline was left, and what was not chosen moved."""
    project = Project(clip=document.project.clip)
    document.open(edit.new_shape(project, board.BOARD, 1, spline=Spline.BSPLINE)[0], None)
    before = document.project.shape("shape-1").at(1).control_points
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1)}))
    hand.click(MARKS[0])
    track = PlanarTrack(document, view_state, runner, lambda frame: board.picture(PlaneMotion.TRANSLATION, frame - 1))
    assert finish(qtbot, track, PlanarTracking(document, view_state, track).forward)[0] is Ending.DONE
    shape = document.project.shape("shape-1")
    after, moved = shape.at(LAST).control_points, board.true_motion(PlaneMotion.TRANSLATION, LAST - 1)
    np.testing.assert_allclose(after[1], projective.apply(moved, before[1]), atol=0.3)
    np.testing.assert_allclose(after[[0, 2, 3]], before[[0, 2, 3]], atol=1e-6)
    assert is_of_its_kind(shape)


@pytest.mark.parametrize("way", ["put", "cleared"])
def test_points_that_are_put_or_cleared_during_a_run_stay(
    qtbot: QtBot, hand: Hand, document: Document, view_state: ViewState, runner: Runner, pointed: None, way: str
) -> None:
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 3)}))
    hand.click(MARKS[0])
    gate = threading.Semaphore(3)

    def read(frame: int) -> np.ndarray:
        assert gate.acquire(timeout=WAIT / 1000)
        return board.picture(PlaneMotion.TRANSLATION, frame - 1)

    track = PlanarTrack(document, view_state, runner, read)
    PlanarTracking(document, view_state, track).forward()
    qtbot.waitUntil(lambda: 3 in document.project.shape("shape-1").frames, timeout=WAIT)
    if way == "put":
        hand.click(MARKS[1])
    else:
        hand.key(Qt.Key.Key_Backspace)
    kept = view_state.track_points
    assert len(places(view_state)) == (2 if way == "put" else 0)
    ending, _ = finish(qtbot, track, lambda: gate.release(LAST))
    assert ending is Ending.DONE
    assert LAST in document.project.shape("shape-1").frames
    assert view_state.track_points == kept


def test_esc_is_left_to_the_track_while_points_are_followed(
    qtbot: QtBot,
    hand: Hand,
    canvas: CanvasView,
    document: Document,
    view_state: ViewState,
    runner: Runner,
    pointed: None,
) -> None:
    hand.click(MARKS[0])
    gate = threading.Event()

    def read(frame: int) -> np.ndarray:
        assert gate.wait(WAIT / 1000)
        return board.picture(PlaneMotion.TRANSLATION, frame - 1)

    track = PlanarTrack(document, view_state, runner, read)
    PlanarTracking(document, view_state, track).forward()
    assert "Esc" not in canvas.tool.claimed_keys
    assert "Backspace" in canvas.tool.claimed_keys
    hand.key(Qt.Key.Key_Escape)
    assert len(places(view_state)) == 1
    track.stop()
    finish(qtbot, track, gate.set)
    hand.key(Qt.Key.Key_Escape)
    assert len(places(view_state)) == 0


def test_points_on_one_another_are_refused(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, pointed: None
) -> None:
    view_state.track_points = TrackPoints(1, (MARKS[0], MARKS[0]))
    track = PlanarTrack(document, view_state, runner, lambda frame: board.picture(KIND, frame - 1))
    ending, sentence = finish(qtbot, track, PlanarTracking(document, view_state, track).forward)
    assert ending is Ending.FAILED
    assert "put them apart" in sentence
    assert not document.project.has("layer-1")
