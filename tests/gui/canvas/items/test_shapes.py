"""How shapes look: outline, points, rings, locked, hovered; and that paths are built once."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest
from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QImage, QPainter

from app.canvas.items.shapes import ShapePainter
from app.model.view_state import Selection
from app.paint import marks
from app.paint.outline_paths import OutlinePaths, outline_path
from app.paint.viewport import Viewport
from roam_core.arrays import Bools, Int64
from roam_core.geometry.bezier import IN, OUT, polygon_points
from roam_core.params import DOUBTFUL
from roam_core.roto import Keyframe, Origin, Project, RotoShape, Spline
from roam_core.roto.point_order import reversed_direction

CORNERS = [(20.0, 20.0), (80.0, 20.0), (80.0, 80.0), (20.0, 80.0)]
ORANGE = (1.0, 0.5, 0.0)
SHAPE = RotoShape("s", "S", (Keyframe(1, polygon_points(CORNERS)),), colour=ORANGE)
NOTHING = Selection()
SELECTED = Selection(frozenset({"s"}))


def painted(
    shape: RotoShape,
    selection: Selection = NOTHING,
    *,
    hover: tuple[str, int, int] | None = None,
    scale: float = 1.0,
) -> Int64:
    """The shape on mid grey, (h, w, 3)."""
    side = round(100 * scale)
    background = QImage(side, side, QImage.Format.Format_RGB32)
    background.fill(QColor(128, 128, 128))
    painter = QPainter(background)
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    project = Project(root=replace(Project().root, children=(shape,)))
    ShapePainter().paint(painter, Viewport(scale), project, 1, selection, hover)
    painter.end()
    pixels = np.frombuffer(background.constBits(), dtype=np.uint8).reshape(side, side, 4)
    return pixels[:, :, 2::-1].astype(np.int64)


def marked(pixels: Int64) -> Bools:
    return (pixels != 128).any(axis=2)


def orange(pixels: Int64) -> Bools:
    return pixels[:, :, 0] - pixels[:, :, 2] > 60


def ink(pixels: Int64) -> int:
    """How much the marks differ from the background."""
    return int(np.abs(pixels - 128).sum())


def with_key(**values: object) -> RotoShape:
    return replace(SHAPE, keys=(replace(SHAPE.keys[0], origin=Origin.ENGINE, **values),))


def test_path_runs_along_the_spline() -> None:
    points = polygon_points(CORNERS)
    points[0, OUT], points[1, IN] = (30.0, 0.0), (70.0, 0.0)
    path = outline_path(points, closed=True)
    for element, expected in ((0, (20.0, 20.0)), (1, (30.0, 0.0)), (2, (70.0, 0.0)), (3, (80.0, 20.0))):
        assert (path.elementAt(element).x, path.elementAt(element).y) == expected
    # Its highest spot is (50, 5).
    assert path.contains(QPointF(50.0, 6.0))
    assert not path.contains(QPointF(50.0, 4.0))


def test_open_path_does_not_return() -> None:
    assert outline_path(polygon_points(CORNERS), closed=False).elementCount() == 1 + 3 * 3
    assert outline_path(polygon_points(CORNERS), closed=True).currentPosition() == QPointF(20.0, 20.0)


def test_path_is_kept_for_shape_and_frame() -> None:
    paths = OutlinePaths()
    kept = paths.whole(SHAPE, 1)
    assert paths.whole(SHAPE, 1) is kept
    assert paths.whole(SHAPE, 2) is not kept
    moved = SHAPE.with_key(Keyframe(1, polygon_points(CORNERS) + 5.0))
    assert paths.whole(moved, 1).elementAt(0).x == 25.0


def test_only_what_is_in_sight_of_a_path_is_made() -> None:
    paths, corners = OutlinePaths(), np.array(CORNERS)
    around = corners.min(axis=0) - 9.0, corners.max(axis=0) + 9.0
    assert paths.in_sight(SHAPE, 1, around) is paths.whole(SHAPE, 1)
    assert paths.in_sight(SHAPE, 1, (corners.max(axis=0) + 5.0, corners.max(axis=0) + 9.0)) is None
    (x, y), (_, bottom) = corners[0], corners.max(axis=0)
    cut = paths.in_sight(SHAPE, 1, (np.array([x - 9.0, y - 9.0]), np.array([x + 1.0, bottom + 9.0])))
    assert cut is not None
    assert 0 < cut.elementCount() <= paths.whole(SHAPE, 1).elementCount()


@pytest.mark.parametrize("scale", [0.5, 1.0, 4.0])
def test_outline_is_as_thick_at_every_zoom(scale: float) -> None:
    pixels = painted(SHAPE, scale=scale)
    column = marked(pixels)[:, round(50 * scale)]
    upper = np.flatnonzero(column[: round(50 * scale)])
    assert 2 <= len(upper) <= 4
    assert abs(upper.mean() + 0.5 - 20 * scale) <= 0.5


def test_outline_has_the_colour_and_a_dark_edge() -> None:
    column = painted(SHAPE)[15:26, 50]
    assert (column[:, 0] - column[:, 2]).max() > 150
    assert column.sum(axis=1).min() < 3 * 128 - 60


def test_selected_shape_is_thicker_and_shows_points() -> None:
    plain, chosen = painted(SHAPE), painted(SHAPE, SELECTED)
    assert ink(chosen[10:30, 45:55]) > 1.2 * ink(plain[10:30, 45:55])
    corner = np.s_[14:27, 14:27]
    assert marked(chosen)[corner].sum() > marked(plain)[corner].sum() + 10


def test_selected_points_are_bright_and_filled() -> None:
    chosen = painted(SHAPE, Selection(frozenset({"s"}), frozenset({("s", 0)})))
    assert chosen[20, 20].min() > 240
    assert chosen[20, 80].max() < 120


def test_handles_of_selected_points_are_shown() -> None:
    points = polygon_points(CORNERS)
    points[0, IN], points[0, OUT] = (20.0, 50.0), (50.0, 50.0)
    shape = replace(SHAPE, keys=(Keyframe(1, points),))
    without, with_point = painted(shape, SELECTED), painted(shape, Selection(frozenset({"s"}), frozenset({("s", 0)})))
    assert not orange(without)[48:53, 48:53].any()
    assert orange(with_point)[49:52, 49:52].all()
    assert orange(with_point)[33:37, 33:37].any()


def test_the_first_point_of_a_selected_shape_is_larger_and_an_arrow_tells_its_direction() -> None:
    chosen = painted(SHAPE, SELECTED)

    def width(x: int, y: int) -> int:
        """How far the anchor of a corner reaches into the outside of the shape, in a row just beside the outline."""
        return int(marked(chosen[y - 4 : y + 5, x - 8 : x + 9])[1 if y < 50 else -2].sum())

    for x, y in ((80, 80), (20, 80), (80, 20)):
        assert width(20, 20) > width(x, y)
    beside = [marked(chosen)[23, 30:40].any(), marked(chosen)[30:40, 23].any()]
    assert beside == [True, False]  # below the upper side, not beside the left one
    turned = painted(reversed_direction(SHAPE), SELECTED)
    assert [marked(turned)[23, 30:40].any(), marked(turned)[30:40, 23].any()] == [False, True]
    assert not marked(painted(SHAPE))[23, 30:40].any()


def test_a_first_side_too_short_for_an_arrow_has_none() -> None:
    points = polygon_points([(20.0, 20.0), (40.0, 20.0), (80.0, 80.0)])
    pixels = marked(painted(replace(SHAPE, keys=(Keyframe(1, points),)), SELECTED))
    assert not pixels[16, 28:35].any()


@pytest.mark.parametrize("spline", list(Spline))
def test_an_open_shape_of_any_kind_has_its_arrow_at_its_beginning(spline: Spline) -> None:
    points = polygon_points([(20.0, 50.0), (80.0, 50.0), (80.0, 90.0)])
    pixels = marked(painted(replace(SHAPE, keys=(Keyframe(1, points),), closed=False, spline=spline), SELECTED))
    assert pixels[46:48, 31:34].any()


def test_smooth_anchors_are_round() -> None:
    points = polygon_points(CORNERS)
    points[0, IN], points[0, OUT] = (20.0, 20.3), (20.0, 19.7)
    corner, smooth = (
        marked(painted(SHAPE, SELECTED)),
        marked(painted(replace(SHAPE, keys=(Keyframe(1, points),)), SELECTED)),
    )
    box = np.s_[14:27, 14:27]
    assert corner[box].sum() > smooth[box].sum()


def test_hovered_anchor_is_larger() -> None:
    calm, hovered = painted(SHAPE, SELECTED), painted(SHAPE, SELECTED, hover=("s", 0, 0))
    size = marks.ANCHOR_SIZE + marks.FIRST_GROWTH + marks.HOVER_GROWTH
    assert marked(hovered)[10:30, 10:20].sum() > marked(calm)[10:30, 10:20].sum()
    outside = np.flatnonzero(marked(hovered)[17])
    assert abs(outside.min() - (20 - size / 2)) <= 1.5


def test_doubtful_vertices_get_rings_that_grow_with_doubt() -> None:
    def ring_width(confidence: float) -> int:
        doubted = with_key(vertex_confidence=np.array([confidence, 1.0, 1.0, 1.0]))
        extra = (painted(doubted) != painted(SHAPE)).any(axis=2)
        columns = np.flatnonzero(extra.any(axis=0))
        return int(np.ptp(columns) + 1) if len(columns) else 0

    smallest, largest = marks.RING_SIZES
    assert ring_width(DOUBTFUL + 0.05) == 0
    doubts = [ring_width(share * DOUBTFUL) for share in (0.9, 0.4, 0.0)]
    assert smallest <= doubts[0] < doubts[1] < doubts[2] <= largest + 4


def test_locked_shape_is_dimmer_and_shows_no_points() -> None:
    locked = replace(SHAPE, locked=True)
    contrast = [np.abs(painted(shape)[15:26, 50] - 128).max() for shape in (SHAPE, locked)]
    assert 0 < contrast[1] < 0.7 * contrast[0]
    assert not (painted(locked, SELECTED)[14:27, 14:27].max(axis=2) > 240).any()


@pytest.mark.parametrize("values", [{"visible": False}, {"lifetime": (2, 5)}])
def test_hidden_and_absent_shapes_are_not_painted(values: dict[str, object]) -> None:
    assert not marked(painted(replace(SHAPE, **values), SELECTED)).any()
