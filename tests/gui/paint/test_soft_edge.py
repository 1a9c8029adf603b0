"""The end of an even soft edge: as far away as its width, rounded, without what another part covers; and painted."""

from __future__ import annotations

import tracemalloc

import numpy as np
import pytest
from PySide6.QtGui import QImage

from app.canvas.view import CanvasView
from app.model.document import Document
from app.paint import soft_edge as module
from app.paint.soft_edge import NEARER, soft_edge
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit

SQUARE = polygon_points([(40.0, 40.0), (120.0, 40.0), (120.0, 100.0), (40.0, 100.0)])
HOOK = polygon_points(
    [(0.0, 0.0), (80.0, 0.0), (80.0, 80.0), (50.0, 80.0), (50.0, 30.0), (30.0, 30.0), (30.0, 80.0), (0, 80)]
)


def away(points: np.ndarray, places: np.ndarray) -> np.ndarray:
    """How far places lie from a polygon."""
    a = points[:, 0]
    along = np.roll(a, -1, axis=0) - a
    share = ((places[:, None] - a) * along).sum(axis=2) / (along**2).sum(axis=1)
    return np.hypot(*np.moveaxis(places[:, None] - a - np.clip(share, 0, 1)[..., None] * along, -1, 0)).min(axis=1)


@pytest.mark.parametrize("points", [SQUARE, SQUARE[::-1], HOOK])
@pytest.mark.parametrize("width", [6.0, -6.0, 12.0])
def test_it_lies_the_width_away_on_every_place(points: np.ndarray, width: float) -> None:
    found = soft_edge(points, width)
    assert len(found) > 40
    np.testing.assert_allclose(away(points, found), abs(width), rtol=0.02)


def test_outwards_and_inwards() -> None:
    assert soft_edge(SQUARE, 10.0).min(axis=0).tolist() == pytest.approx([30.0, 30.0])
    assert soft_edge(SQUARE, -10.0).min(axis=0).tolist() == pytest.approx([50.0, 50.0], abs=0.5)
    assert soft_edge(SQUARE, -10.0).max(axis=0).tolist() == pytest.approx([110.0, 90.0], abs=0.5)


def test_a_corner_is_rounded() -> None:
    found = soft_edge(SQUARE, 10.0)
    corner = found[(found < [40.0, 40.0]).all(axis=1)]
    assert len(corner) >= 4
    np.testing.assert_allclose(np.hypot(*(corner - [40.0, 40.0]).T), 10.0, rtol=1e-6)


def test_where_all_is_soft_there_is_no_end() -> None:
    assert len(soft_edge(SQUARE, -40.0)) == 0


@pytest.mark.parametrize("width", [24.0, -24.0])
def test_an_outline_of_many_points_keeps_the_places_that_no_part_covers(
    width: float, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As many as those of which each is compared with the whole outline, without a table of all of these."""
    angles = np.linspace(0.0, 2 * np.pi, 400, endpoint=False)
    radii = 900.0 + 60.0 * np.sin(angles * 400 / 6)
    corners = polygon_points(np.stack([2000.0 + radii * np.cos(angles), 1000.0 + radii * np.sin(angles)], axis=1))
    line = bezier.flatten(edit.smooth_points(corners, range(400)), True, module.FLATTENED)
    module.offset(SQUARE[:, 0], width)  # what is loaded for it is loaded
    tracemalloc.start()
    found = module.offset(line, width)
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert most < 50e6
    monkeypatch.setattr(module, "NEARER", 0.0)
    outline = module._divided(line, max(polyline.length(line) / module.MOST_PLACES, module.LEAST_STEP))
    every = module.offset(line, width)
    gaps = np.array([((place - outline) ** 2).sum(axis=1).min() for place in every])
    expected = every[gaps >= (NEARER * width) ** 2]
    assert 0 < len(expected) < len(every)
    np.testing.assert_array_equal(found, expected)


def test_an_outline_of_no_size_has_none() -> None:
    assert len(soft_edge(polygon_points([(5.0, 5.0)] * 3), 4.0)) == 0


@pytest.mark.parametrize(
    ("width", "inside", "outside"), [(16.0, False, True), (-16.0, True, False), (0.0, False, False)]
)
def test_the_number_draws_its_edge_in_the_overlay(
    canvas: CanvasView, document: Document, width: float, inside: bool, outside: bool
) -> None:
    """Between the outline and where the softness ends the plate is tinted, on that side alone."""
    project, shape = edit.new_shape(document.project, SQUARE, 1)
    document.open(edit.set_properties(project, shape.id, feather=width), None)

    def is_tinted(image: QImage, at: tuple[float, float]) -> bool:
        colour = image.pixelColor(canvas.image_to_widget(*at).toPoint())
        return len({colour.red(), colour.green(), colour.blue()}) > 1

    image = canvas.grab().toImage()
    assert is_tinted(image, (80.0, 48.0)) is inside
    assert is_tinted(image, (80.0, 32.0)) is outside
    assert not is_tinted(image, (80.0, 70.0))
    assert not is_tinted(image, (80.0, 16.0))
