"""Marks of the first frame of a long clip, where a frame is less than a pixel wide: whole, and nothing before them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint
from PySide6.QtGui import QImage
from PySide6.QtWidgets import QWidget

from app.model.document import Document
from app.timeline.keys.row_painter import ROW
from app.timeline.scale import LABEL_WIDTH
from app.timeline.timeline import Timeline
from roam_core.roto import Animated, Clip, Project, ValueKey, edit, timing
from roam_core.roto.linking import BEHIND, set_depth
from tests.gui.timeline.places import SQUARE

CLIP = Clip(Path("shot"), 1, 2000, (64, 48))
ENDS = (1, 2000)
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
    document.open(project, None)
    timeline.axis.view_state.set_frame(1000)
    viewport = timeline.rows.viewport()
    return {
        "keys": (viewport, KEY),
        "depth": (viewport, DEPTH),
        "values": (timeline.value_rows, KEY),
        "marks": (timeline.marks, FLAG),
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
