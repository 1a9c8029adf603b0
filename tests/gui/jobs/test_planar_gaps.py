"""Planar tracks that begin in a gap of the plate: they go on from the frame before it, as tracks of the engine do."""

from __future__ import annotations

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.features.planar_tracking import PlanarTracking, points_at
from app.jobs.planar import PlanarTrack
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.track_points import TrackPoints
from app.model.view_state import ViewState
from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.media.source import MissingFrame
from roam_core.roto import Clip, Project, edit
from tests.gui.waiting import WAIT
from tests.unit.motion import test_plane_track as board

KIND, LAST = PlaneMotion.SIMILARITY, 8
GAP = 4, 5


def read(frame: int) -> np.ndarray:
    if frame in GAP:
        raise MissingFrame(f"Frame {frame} is missing.")
    return board.picture(KIND, frame - 1)


@pytest.fixture
def verbs(document: Document, view_state: ViewState, runner: Runner) -> PlanarTracking:
    """A selected shape on the board on frame 1, tracked up to the gap."""
    project = Project(clip=Clip(board.__file__, 1, LAST, (board.WIDTH, board.HEIGHT)))
    project, shape = edit.new_shape(project, board.BOARD, 1)
    document.open(project, None)
    view_state.select(frozenset({shape.id}))
    view_state.set_play_range(1, LAST + 1)
    return PlanarTracking(document, view_state, PlanarTrack(document, view_state, runner, read), lambda: GAP)


def run(qtbot: QtBot, verbs: PlanarTracking) -> Ending:
    with qtbot.waitSignal(verbs._track.finished, timeout=WAIT) as finished:
        verbs.forward()
    assert finished.args is not None
    ending: Ending = finished.args[0]
    return ending


@pytest.mark.parametrize("frame", GAP)
def test_a_track_from_within_a_gap_goes_on_from_before_it(
    qtbot: QtBot, verbs: PlanarTracking, document: Document, view_state: ViewState, frame: int
) -> None:
    view_state.set_play_range(1, 4)
    assert run(qtbot, verbs) is Ending.DONE
    view_state.set_play_range(1, LAST + 1)
    view_state.set_frame(frame)
    assert run(qtbot, verbs) is Ending.DONE
    for later in (6, LAST):
        true = projective.apply(board.true_motion(KIND, later - 1), board.BOARD[:, ANCHOR])
        assert np.abs(document.project.shape("shape-1").at(later).anchors - true).max() < 0.7


def test_backward_it_begins_behind_the_gap(
    verbs: PlanarTracking, view_state: ViewState, monkeypatch: pytest.MonkeyPatch
) -> None:
    started: list[tuple[object, ...]] = []
    monkeypatch.setattr(verbs._track, "start", lambda *given: started.append(given))
    view_state.set_frame(4)
    verbs.backward()
    assert started[0][1] == range(6, 0, -1)


def test_one_whose_key_lies_in_the_gap_begins_on_it(
    verbs: PlanarTracking, document: Document, view_state: ViewState, monkeypatch: pytest.MonkeyPatch
) -> None:
    """On another frame it lies elsewhere: that the plate lacks this one is said."""
    started: list[tuple[object, ...]] = []
    monkeypatch.setattr(verbs._track, "start", lambda *given: started.append(given))
    document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("shape-1"), 4)))
    view_state.set_frame(5)
    verbs.forward()
    assert started[0][1] == range(5, LAST + 1)


def test_points_begin_where_the_surface_carries_them(
    qtbot: QtBot, verbs: PlanarTracking, document: Document, view_state: ViewState
) -> None:
    view_state.set_play_range(1, 4)
    run(qtbot, verbs)
    view_state.track_points = TrackPoints.on(1, (board.WIDTH, board.HEIGHT)).with_place((100.0, 80.0))
    before = points_at(document.project, view_state, ["shape-1"], 3)
    true = projective.apply(board.true_motion(KIND, 2), np.array([(100.0, 80.0)]))
    assert before.frame == 3
    np.testing.assert_allclose(before.places, true, atol=0.7)
