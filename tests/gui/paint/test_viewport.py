"""The map between image and widget."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPointF, QRectF, QSizeF

from app.paint.viewport import LARGEST, MARGIN, OVERLAP, SMALLEST, Viewport

coordinates = st.floats(-5000.0, 5000.0)
viewports = st.builds(Viewport, st.floats(0.05, 40.0), coordinates, coordinates, st.floats(0.5, 2.0))


def near(a: QPointF, b: QPointF, tolerance: float = 1e-6) -> bool:
    return abs(a.x() - b.x()) < tolerance and abs(a.y() - b.y()) < tolerance


@given(viewports, coordinates, coordinates)
def test_there_and_back_again(viewport: Viewport, x: float, y: float) -> None:
    assert viewport.to_image(viewport.to_widget(x, y)) == pytest.approx((x, y), abs=1e-6)


@given(viewports, coordinates, coordinates)
def test_transform_is_the_same_map(viewport: Viewport, x: float, y: float) -> None:
    assert near(viewport.transform.map(QPointF(x, y)), viewport.to_widget(x, y), 1e-5)


@given(viewports, coordinates, coordinates, st.floats(0.2, 5.0))
def test_zoom_keeps_the_spot_under_the_pointer(viewport: Viewport, x: float, y: float, factor: float) -> None:
    at = QPointF(x, y)
    spot = viewport.to_image(at)
    assert near(viewport.zoomed(factor, at).to_widget(*spot), at, 1e-5)


def test_zoom_has_limits() -> None:
    assert Viewport().zoomed(1e9, QPointF()).scale == LARGEST
    assert Viewport().zoomed(1e-9, QPointF()).scale == SMALLEST


@given(viewports, st.floats(10.0, 4000.0), st.floats(10.0, 4000.0))
def test_fit_shows_the_whole_area_in_the_middle(viewport: Viewport, width: float, height: float) -> None:
    widget, area = QSizeF(1200.0, 700.0), QRectF(30.0, 40.0, width, height)
    shown = viewport.fitted(area, widget).transform.mapRect(area)
    assert near(shown.center(), QPointF(600.0, 350.0), 1e-4)
    assert shown.width() <= 1200.0 - 2 * MARGIN + 1e-6
    assert shown.height() <= 700.0 - 2 * MARGIN + 1e-6


def test_wide_pixels_are_shown_wide() -> None:
    shown = Viewport(scale=2.0, pixel_aspect=2.0).transform.mapRect(QRectF(0.0, 0.0, 10.0, 10.0))
    assert (shown.width(), shown.height()) == (40.0, 20.0)


@given(viewports)
def test_a_rim_of_the_picture_stays_in_sight(viewport: Viewport) -> None:
    image, widget = QSizeF(400.0, 300.0), QSizeF(800.0, 600.0)
    kept = viewport.kept_in_sight(image, widget)
    shown = kept.transform.mapRect(QRectF(QPointF(), image))
    slack = 1e-6
    assert shown.right() >= OVERLAP - slack
    assert shown.left() <= widget.width() - OVERLAP + slack
    assert shown.bottom() >= OVERLAP - slack
    assert shown.top() <= widget.height() - OVERLAP + slack


@pytest.mark.parametrize("ratio", [1.0, 1.5, 2.0])
def test_corner_on_whole_device_pixels(ratio: float) -> None:
    placed = Viewport(1.0, 10.37, -4.81).on_whole_pixels(ratio)
    assert (placed.x * ratio) % 1.0 == pytest.approx(0.0, abs=1e-9)
    assert abs(placed.x - 10.37) <= 0.5 / ratio
