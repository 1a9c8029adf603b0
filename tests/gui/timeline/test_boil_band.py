"""The lane of boil: there with tracked frames, as high as outlines jitter, and a way to the frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QPointF, Qt
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app import style
from app.features.boil import BoilOf, boil_of_document
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.boil_band import HEIGHT
from app.timeline.keys.tips import TOLD
from app.timeline.marks import on_each_frame
from app.timeline.scale import TimeScale
from app.timeline.timeline import Timeline
from roam_core.review.boil import BOILING, boil
from roam_core.roto import Project, RotoShape, edit
from tests.gui.timeline.places import x_of
from tests.gui.waiting import WAIT

BENT = 1006


def bent(shape: RotoShape, by: float = 40.0) -> RotoShape:
    """The shape with one point out of place on one frame."""
    keys = []
    for key in shape.keys:
        points = key.points.copy()
        points[0] += by
        keys.append(replace(key, points=points) if key.frame == BENT else key)
    return replace(shape, keys=tuple(keys))


def test_the_lane_shows_the_most_of_the_shapes_in_hand(
    timeline: Timeline, document: Document, view_state: ViewState
) -> None:
    first, second = document.project.shapes
    assert timeline.boil.isVisible()
    assert timeline.boil.most[:, 1].max() < BOILING
    document.apply("Bend", document.project.with_shape(bent(first)))
    frame, value = timeline.boil.most[np.argmax(timeline.boil.most[:, 1])]
    assert frame == BENT
    assert value == pytest.approx(boil(document.project.shape(first.id))[:, 1].max())
    assert f"Frame {BENT}\n{value:.1f} px  {first.name}, boils" in timeline.boil.tip_at(
        QPointF(x_of(timeline, BENT), 1.0)
    )
    view_state.select(frozenset([second.id]))
    assert timeline.boil.most[:, 1].max() < BOILING, "of the other shape alone"


def test_of_more_shapes_than_a_tip_names_their_number_is_told(timeline: Timeline, document: Document) -> None:
    shapes = [bent(document.project.shapes[0], float(by)) for by in range(40, 40 + TOLD + 2)]
    document.open(edit.add_items(Project(document.project.clip), shapes)[0], None)
    lines = timeline.boil.tip_at(QPointF(x_of(timeline, BENT), 1.0)).splitlines()
    assert len(lines) == 1 + TOLD + 1
    assert lines[-1] == "and 2 more"


def test_a_bar_beyond_the_line_has_the_colour_of_doubt(timeline: Timeline, document: Document) -> None:
    document.apply("Bend", document.project.with_shape(bent(document.project.shapes[0])))
    picture = timeline.boil.grab().toImage()
    assert picture.pixelColor(x_of(timeline, BENT), HEIGHT - 4) == QColor(style.DOUBT)
    assert picture.pixelColor(x_of(timeline, BENT + 8), HEIGHT - 4) != QColor(style.DOUBT)


def test_a_press_goes_to_the_frame(qtbot: QtBot, timeline: Timeline, view_state: ViewState) -> None:
    qtbot.mousePress(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1012), 10))
    assert view_state.frame == 1012
    qtbot.mouseMove(timeline.boil, QPoint(x_of(timeline, 1020), 10))
    qtbot.mouseRelease(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1020), 10))


def test_the_lane_keeps_its_place_without_tracked_frames(timeline: Timeline, document: Document) -> None:
    place = timeline.boil.geometry()
    document.open(Project(document.project.clip), None)
    assert timeline.boil.isVisible()
    assert timeline.boil.geometry() == place, "what is above does not jump when frames are tracked"
    assert len(timeline.boil.most) == 0


def test_boil_is_measured_anew_only_around_a_key_that_changed(
    document: Document, timeline: Timeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    measured, shape = BoilOf(document), document.project.shapes[0]
    assert measured(shape) == pytest.approx(boil(shape))
    counts: list[int] = []
    from app.features import boil as room

    counted = room.boil_of
    monkeypatch.setattr(room, "boil_of", lambda keys, closed: counts.append(len(keys)) or counted(keys, closed))
    changed = replace(
        shape, keys=tuple(replace(key, points=key.points + 3.0) if key.frame == BENT else key for key in shape.keys)
    )
    assert measured(changed) == pytest.approx(boil(changed))
    assert counts == [3]
    assert measured(changed) is measured(changed)


def test_an_undo_brings_the_boil_back_that_was_measured(
    document: Document, timeline: Timeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """After each undo and redo of an edit of hundreds of shapes all were measured anew, for seconds."""
    measured, shape = boil_of_document(document), document.project.shapes[0]
    before = measured(shape)
    document.apply("Bend", document.project.with_shape(bent(shape, 60.0)))
    after = measured(document.project.shapes[0])
    assert not np.array_equal(before, after)
    from app.features import boil as room

    monkeypatch.setattr(room, "boil_of", lambda keys, closed: pytest.fail("measured anew"))
    for step, told in ((document.undo_stack.undo, before), (document.undo_stack.redo, after)):
        step()
        assert measured.so_far(document.project.shapes)[0][1] is told
        assert measured(document.project.shapes[0]) is told


def test_of_several_shapes_each_frame_has_the_greatest() -> None:
    measured = [np.array([[1.0, 0.5], [3.0, 2.0]]), np.empty((0, 2)), np.array([[3.0, 1.0], [2.0, 0.1]])]
    assert on_each_frame(np.maximum, measured).tolist() == [[1.0, 0.5], [2.0, 0.1], [3.0, 2.0]]
    assert on_each_frame(np.maximum, []).shape == (0, 2)


def test_what_was_measured_by_the_picture_stands_until_its_keys_change(document: Document, timeline: Timeline) -> None:
    shape = document.project.shapes[0]
    shared = boil_of_document(document)
    assert boil_of_document(document) is shared
    frames = boil(shape)[:, 0]
    shared.take({shape.id: shape}, {shape.id: np.column_stack([frames, np.full(len(frames), 1.5)])})
    shown = dict(timeline.boil.most.tolist())
    assert {shown[frame] for frame in frames} == {1.5}
    document.apply("Bend", document.project.with_shape(bent(shape)))
    shown = dict(timeline.boil.most.tolist())
    assert {frame for frame in frames if shown[frame] != 1.5} == {BENT - 1, BENT, BENT + 1}


def test_what_was_measured_by_the_picture_stands_between_two_places_that_change(
    document: Document, timeline: Timeline
) -> None:
    shape, shared = document.project.shapes[0], boil_of_document(document)
    frames = boil(shape)[:, 0]
    shared.take({shape.id: shape}, {shape.id: np.column_stack([frames, np.full(len(frames), 1.5)])})
    ends = frames[2], frames[-3]
    moved = replace(
        shape, keys=tuple(replace(key, points=key.points + 3.0) if key.frame in ends else key for key in shape.keys)
    )
    changed = {frame + step for frame in ends for step in (-1, 0, 1)}
    assert {frame for frame, pixels in shared(moved).tolist() if pixels != 1.5} == changed
    closed = replace(moved, closed=not moved.closed)
    assert shared(closed) == pytest.approx(boil(closed))


def test_of_frames_that_share_a_pixel_the_one_that_boils_most_is_seen(timeline: Timeline, document: Document) -> None:
    """Thousands of bars were painted over each other; the last one of a pixel hid the others."""
    document.apply("Bend", document.project.with_shape(bent(document.project.shapes[0])))
    band = timeline.boil
    bars = band._bars(TimeScale(first=1001, pixels=0.1, clip=(1001, 1049)))
    assert len(bars) <= 5 < len(band.most)
    assert bars[:, 1].max() == band.most[:, 1].max()


def test_the_boil_of_many_shapes_is_measured_in_idle_moments(
    qtbot: QtBot, document: Document, timeline: Timeline, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A project of 300 shapes on 2000 frames held the window for a minute as it was opened."""
    from app.features import boil as room

    counts: list[int] = []
    counted = room.boil_of
    monkeypatch.setattr(room, "boil_of", lambda keys, closed: counts.append(len(keys)) or counted(keys, closed))
    monkeypatch.setattr(room, "AT_ONCE", 1)
    project, shared = document.project, boil_of_document(document)
    many = [replace(shape, id=f"{shape.id}-{k}") for k in range(3) for shape in project.shapes]
    document.open(replace(project, root=replace(project.root, children=tuple(many))), None)
    assert len(counts) == 1
    assert " px " in timeline.boil.tip_at(QPointF(x_of(timeline, BENT), 1.0))
    assert len(counts) == 2
    with qtbot.waitSignal(shared.changed, timeout=WAIT):
        pass
    assert len(counts) == len(many), "each once"
    wanted = on_each_frame(np.maximum, [boil(shape) for shape in document.project.shapes])
    assert timeline.boil.most == pytest.approx(wanted)
    assert not shared._later.isActive()


def test_a_press_on_the_name_that_is_dragged_into_the_frames_does_not_scrub(
    qtbot: QtBot, timeline: Timeline, view_state: ViewState
) -> None:
    view_state.set_frame(1005)
    qtbot.mousePress(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(20, 10))
    qtbot.mouseMove(timeline.boil, QPoint(x_of(timeline, 1020), 10))
    qtbot.mouseRelease(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1020), 10))
    assert view_state.frame == 1005
    qtbot.mousePress(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1012), 10))
    qtbot.mouseMove(timeline.boil, QPoint(x_of(timeline, 1020), 10))
    qtbot.mouseRelease(timeline.boil, Qt.MouseButton.LeftButton, pos=QPoint(x_of(timeline, 1020), 10))
    assert view_state.frame == 1020
