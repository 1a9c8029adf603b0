"""Marks of the first frame of a long clip, where a frame is less than a pixel wide: whole, and nothing before them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.timeline.keys.row_painter import ROW
from app.timeline.scale import LABEL_WIDTH
from app.timeline.timeline import Timeline
from roam_core.roto import Animated, Clip, Project, ValueKey, edit, timing
from roam_core.roto.following import followed, with_moving_layer
from roam_core.roto.linking import BEHIND, set_depth
from tests.gui.timeline.places import SQUARE

CLIP = Clip(Path("shot"), 1, 2000, (64, 48))
ENDS = (1, 2000)
SHAPE = "shape-1"
KEY, DEPTH, FLAG = ROW // 2 - 1, 2, 7
"""Where the marks lie in their rows, from the top."""


@pytest.fixture
def rows(timeline: Timeline, document: Document) -> dict[str, tuple[QWidget, int]]:
    """What has marks on the first and the last frame, and at which height; the playhead is elsewhere."""
    project, shape = edit.new_shape(Project(CLIP), SQUARE, ENDS[0])
    shape = replace(edit.key_here(shape, ENDS[1]), opacity=Animated(tuple(ValueKey(frame, 0.5) for frame in ENDS)))
    project = project.with_shape(shape)
    for frame in ENDS:
        project = timing.set_mark(set_depth(project, [shape.id], frame, BEHIND if frame == 1 else 0), frame)
    project, layer_id = with_moving_layer(project, [shape.id], ENDS[0])
    project = followed(project, layer_id, ENDS[0], ENDS[1], np.eye(3), 0.9)
    document.open(project, None)
    timeline.axis.view_state.set_frame(1000)
    viewport = timeline.rows.viewport()
    return {
        "keys": (viewport, KEY),
        "depth": (viewport, DEPTH),
        "values": (timeline.value_rows, KEY),
        "marks": (timeline.marks, FLAG),
        "tracks": (timeline.tracks, KEY),
    }


def picture(widget: QWidget) -> QImage:
    return widget.grab().toImage()


@pytest.mark.parametrize("name", ["keys", "depth", "values", "marks"])
def test_marks_of_both_ends_are_whole(timeline: Timeline, rows: dict[str, tuple[QWidget, int]], name: str) -> None:
    """Of the first one the left half was cut off at the names."""
    widget, height = rows[name]
    shown, scale = picture(widget), timeline.axis.scale
    assert scale.pixels < 1.0
    bare = shown.pixelColor(LABEL_WIDTH + 20, 5 if name == "keys" else height)  # a dotted line runs between keys
    for frame in ENDS:
        x = int(scale.x(frame))
        assert all(shown.pixelColor(QPoint(x + dx, height)) != bare for dx in (-2, 2)), frame


@pytest.mark.parametrize("name", ["keys", "depth", "values", "marks"])
def test_what_is_scrolled_out_leaves_nothing_beside_the_names(
    timeline: Timeline, rows: dict[str, tuple[QWidget, int]], name: str
) -> None:
    widget, height = rows[name]
    scale = timeline.axis.scale.zoomed(4.0, LABEL_WIDTH)
    timeline.axis.set_scale(scale.panned(2.0))
    shown = picture(widget)
    colours = {shown.pixelColor(x, height).name() for x in range(LABEL_WIDTH - 8, LABEL_WIDTH)}
    assert len(colours) == 1


@pytest.mark.parametrize("name", ["keys", "values", "marks", "tracks"])
def test_a_press_on_the_left_half_of_the_first_one_means_it(
    qtbot: QtBot, timeline: Timeline, rows: dict[str, tuple[QWidget, int]], name: str
) -> None:
    """It meant the name beside it."""
    widget, height = rows[name]
    view = timeline.axis.view_state
    view.select(frozenset())
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=QPoint(LABEL_WIDTH - 2, height))
    assert view.frame == ENDS[0]
    if name == "keys":
        assert timeline.keys.places == {(SHAPE, ENDS[0])}
    elif name == "values":
        assert timeline.values.places == {(SHAPE, "opacity", ENDS[0])}


@pytest.mark.parametrize("name", ["keys", "values", "tracks"])
def test_a_press_on_the_end_of_a_name_means_the_name(
    qtbot: QtBot, timeline: Timeline, rows: dict[str, tuple[QWidget, int]], name: str
) -> None:
    widget, height = rows[name]
    timeline.axis.view_state.select(frozenset())
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=QPoint(LABEL_WIDTH - 10, height))
    assert timeline.axis.view_state.frame == 1000
    assert timeline.axis.view_state.selection.shapes == {SHAPE}


@pytest.mark.parametrize("name", ["keys", "values", "marks", "tracks"])
def test_what_is_scrolled_out_is_not_taken_hold_of(
    qtbot: QtBot, timeline: Timeline, rows: dict[str, tuple[QWidget, int]], name: str
) -> None:
    """No mark is seen there; a press beside it chose it, and went to its frame."""
    widget, height = rows[name]
    scale = timeline.axis.scale.zoomed(4.0, LABEL_WIDTH)
    timeline.axis.set_scale(scale.panned(1.0))
    assert 0.0 < LABEL_WIDTH - timeline.axis.scale.x(ENDS[0]) < 2.0
    qtbot.mouseClick(widget, Qt.MouseButton.LeftButton, pos=QPoint(LABEL_WIDTH + 1, height))
    assert ENDS[0] < timeline.axis.view_state.frame < 1000
    assert not timeline.keys.places | timeline.values.places
