"""Planar and point tracks that undo ends: nothing of them comes after it, and none of their frames is said to stay."""

from __future__ import annotations

import threading

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs.planar import PlanarTrack
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.track_points import TrackPoints
from app.model.view_state import ViewState
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, edit
from roam_core.roto.point_order import reversed_direction
from tests.gui.waiting import WAIT
from tests.unit.motion import test_plane_track as board

KIND, LAST = PlaneMotion.SIMILARITY, 6
TAKEN_BACK = "stopped at frame 3; its frames were taken back."


@pytest.fixture
def gate() -> threading.Semaphore:
    """One picture of the board for each release."""
    return threading.Semaphore(0)


@pytest.fixture
def track(document: Document, view_state: ViewState, runner: Runner, gate: threading.Semaphore) -> PlanarTrack:
    """A shape on the board, with a tracked key on every frame."""

    def read(frame: int) -> np.ndarray:
        assert gate.acquire(timeout=WAIT / 1000)
        return board.picture(KIND, frame - 1)

    project = Project(clip=Clip(board.__file__, 1, LAST, (board.WIDTH, board.HEIGHT)))
    project, shape = edit.new_shape(project, board.BOARD, 1)
    tracked = [Keyframe(frame, board.BOARD, origin=Origin.ENGINE) for frame in range(2, LAST + 1)]
    document.open(project.with_shape(edit.set_engine_keys(shape, tracked)), None)
    return PlanarTrack(document, view_state, runner, read)


def origin(document: Document, frame: int) -> Origin:
    key = document.project.shape("shape-1").key_at(frame)
    assert key is not None
    return key.origin


def test_undo_ends_a_track_of_points_over_tracked_frames(
    qtbot: QtBot, document: Document, track: PlanarTrack, gate: threading.Semaphore
) -> None:
    """These lie on the frame as before; the track went on, and laid the rest of it above what was undone."""
    before = document.project
    points = TrackPoints.on(1, (board.WIDTH, board.HEIGHT)).with_place((100.0, 80.0))
    gate.release(3)
    track.start(["shape-1"], range(1, LAST + 1), KIND, points=points, vertices=frozenset({("shape-1", 0)}))
    qtbot.waitUntil(lambda: origin(document, 3) is Origin.ARTIST, timeout=WAIT)
    with qtbot.waitSignal(track.finished, timeout=WAIT) as finished:
        document.undo_stack.undo()
    assert finished.args == [Ending.CANCELLED, f"Point track {TAKEN_BACK}"]
    gate.release(10)
    qtbot.waitUntil(lambda: track._runner.is_idle, timeout=WAIT)
    assert document.project is before
    assert document.undo_stack.canRedo()


@pytest.mark.parametrize("goes_on", [False, True])
def test_frames_of_a_planar_track_that_was_undone_are_not_said_to_stay(
    qtbot: QtBot, document: Document, track: PlanarTrack, gate: threading.Semaphore, goes_on: bool
) -> None:
    def moves_to(frame: int) -> bool:
        layers = [item for item in document.project.root.items() if isinstance(item, Layer)]
        return bool(layers) and layers[0].transform is not None and frame in layers[0].transform.frames

    gate.release(3 if not goes_on else 5)
    if goes_on:  # over the frames of a track before it
        with qtbot.waitSignal(track.finished, timeout=WAIT):
            track.start(["shape-1"], range(1, 3), PlaneMotion.TRANSLATION)
    count = document.undo_stack.count()
    track.start(["shape-1"], range(1, LAST + 1), KIND)
    qtbot.waitUntil(lambda: document.undo_stack.count() > count and moves_to(3), timeout=WAIT)
    with qtbot.waitSignal(track.finished, timeout=WAIT) as finished:
        document.undo_stack.undo()
    assert finished.args == [Ending.CANCELLED, f"Planar track {TAKEN_BACK}"]
    gate.release(10)


def test_what_the_artist_moves_meanwhile_leaves_a_track_of_points_alone(
    qtbot: QtBot, document: Document, track: PlanarTrack, gate: threading.Semaphore
) -> None:
    points = TrackPoints.on(1, (board.WIDTH, board.HEIGHT)).with_place((100.0, 80.0))
    gate.release(3)
    track.start(["shape-1"], range(1, LAST + 1), KIND, points=points, vertices=frozenset({("shape-1", 0)}))
    qtbot.waitUntil(lambda: origin(document, 3) is Origin.ARTIST, timeout=WAIT)
    moved = edit.set_key(document.project.shape("shape-1"), 3, board.BOARD + 9.0)
    document.apply("Move", document.project.with_shape(moved))
    assert track.is_running
    document.undo_stack.undo()
    assert track.is_running
    gate.release(10)
    with qtbot.waitSignal(track.finished, timeout=WAIT) as finished:
        pass
    assert finished.args is not None
    assert finished.args[0] is Ending.DONE


@pytest.mark.parametrize("comes_back", ["undo", "redo"])
def test_a_track_of_points_ends_where_undo_gives_them_other_numbers(
    qtbot: QtBot, document: Document, track: PlanarTrack, gate: threading.Semaphore, comes_back: str
) -> None:
    """Before its first frame nothing of it can be undone: it went on, and moved other points than were chosen."""
    shape = document.project.shape("shape-1")
    document.apply("Reverse direction", document.project.with_shape(reversed_direction(shape)))
    if comes_back == "redo":
        document.undo_stack.undo()
    points = TrackPoints.on(1, (board.WIDTH, board.HEIGHT)).with_place((100.0, 80.0))
    track.start(["shape-1"], range(1, LAST + 1), KIND, points=points, vertices=frozenset({("shape-1", 1)}))
    with qtbot.waitSignal(track.finished, timeout=WAIT) as finished:
        getattr(document.undo_stack, comes_back)()
    assert finished.args is not None
    assert finished.args[0] is Ending.CANCELLED
    there = document.project
    gate.release(10)
    qtbot.waitUntil(lambda: track._runner.is_idle, timeout=WAIT)
    assert document.project is there
