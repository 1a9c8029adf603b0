"""Changes of depth in the rows of the timeline: a mark where they are, and what is said of them."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import QPointF

from app.features.verbs.objects import ObjectVerbs
from app.model.document import Document
from app.model.view_state import ViewState
from app.timeline.keys.depth_marks import HALF, HEIGHT, TOP, depth_sentence
from app.timeline.timeline import Timeline
from roam_core.arrays import Int64
from roam_core.roto import Project
from roam_core.roto.linking import AS_STACKED, BEHIND, IN_FRONT, set_depth
from tests.gui.pixels import pixels_of
from tests.gui.timeline.places import place, row_middle, x_of

SHAPE, ROW_OF_IT = "shape-2", 0
"""The upper of two shapes has the upper row."""


def with_depth(project: Project, *pairs: tuple[int, int]) -> Project:
    for frame, level in pairs:
        project = set_depth(project, [SHAPE], frame, level)
    return project


def band(timeline: Timeline, row: int = ROW_OF_IT) -> Int64:
    """The red of the strip of a row in which the marks lie, above its keys."""
    red = pixels_of(timeline.rows.viewport())[:, :, 0]
    top = row_middle(row) - row_middle(0)
    return red[top + int(TOP) : top + int(TOP + HEIGHT)]


def widths(strip: Int64, before: Int64, x: int) -> list[int]:
    """How wide what is new about a column is, line by line."""
    near = slice(x - 6, x + 7)
    return (np.abs(strip[:, near] - before[:, near]) > 60).sum(axis=1).tolist()


@pytest.mark.parametrize(("level", "rising"), [(IN_FRONT, True), (BEHIND, False)])
def test_a_triangle_points_to_the_front_or_to_the_back(
    timeline: Timeline, document: Document, level: int, rising: bool
) -> None:
    plain, other = band(timeline), band(timeline, 1)
    document.apply("Depth", with_depth(document.project, (1037, level)))
    found = widths(band(timeline), plain, x_of(timeline, 1037))
    assert found == sorted(found, reverse=not rising)
    assert found[-1 if rising else 0] >= HALF
    assert found[0 if rising else -1] < found[-1 if rising else 0]
    assert (band(timeline, 1) == other).all()


def test_a_bar_says_that_it_is_as_stacked_again(timeline: Timeline, document: Document) -> None:
    plain = band(timeline)
    document.apply("Depth", with_depth(document.project, (1034, BEHIND), (1038, AS_STACKED)))
    found = widths(band(timeline), plain, x_of(timeline, 1038))
    assert max(found) >= 2 * HALF - 1
    assert 0 in found


def test_the_mark_goes_with_the_change(timeline: Timeline, document: Document, view_state: ViewState) -> None:
    plain = band(timeline)
    view_state.select(frozenset({SHAPE}))
    plain_selected = band(timeline)
    view_state.set_frame(1037)
    ObjectVerbs(document, view_state).set_depth(BEHIND)
    view_state.set_frame(1001)
    assert (band(timeline) != plain_selected).any()
    view_state.set_frame(1037)
    ObjectVerbs(document, view_state).set_depth(AS_STACKED)
    view_state.set_frame(1001)
    view_state.select(frozenset())
    assert (band(timeline)[:, 200:] == plain[:, 200:]).all()


def test_the_tip_tells_the_depth_also_a_little_beside_the_mark(timeline: Timeline, document: Document) -> None:
    document.apply("Depth", with_depth(document.project, (1035, IN_FRONT)))
    beside = QPointF(place(timeline, 1035, ROW_OF_IT)) + QPointF(4.0, 0.0)
    told = timeline.rows.tip_at(beside).splitlines()
    assert told[0].endswith("frame 1035")
    assert told[-1] == "From here on in front of the others"
    assert "depth" not in timeline.rows.tip_at(QPointF(place(timeline, 1033, ROW_OF_IT)))


def test_what_is_said_of_depth(timeline: Timeline, document: Document) -> None:
    shape = with_depth(document.project, (1010, BEHIND), (1020, AS_STACKED)).shape(SHAPE)
    assert [depth_sentence(shape, frame) for frame in (1009, 1010, 1015, 1020, 1021)] == [
        "",
        "From here on behind the others",
        "Behind the others since frame 1010",
        "From here on as stacked again",
        "",
    ]
