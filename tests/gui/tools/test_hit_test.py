"""What lies under the pointer: order, reach, what is never hit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.model.view_state import Selection
from app.tools.hit_test import REACH, OutlineHit, PointHit, hit, hit_outline, points_in_box
from roam_core.geometry.bezier import ANCHOR, IN, OUT, bernstein, polygon_points, segments
from roam_core.roto import Keyframe, Project, RotoShape, edit
from roam_core.roto.layers import moved

ONE = (1.0, 1.0)
SQUARE = [(10.0, 10.0), (110.0, 10.0), (110.0, 110.0), (10.0, 110.0)]


def project_with(*corner_lists: list[tuple[float, float]]) -> Project:
    project = Project()
    for corners in corner_lists:
        project, _ = edit.new_shape(project, polygon_points(corners), 1)
    return project


def chosen(*shapes: str, points: set[tuple[str, int]] | None = None) -> Selection:
    return Selection(frozenset(shapes), frozenset(points or ()))


def test_nothing_is_hit_on_empty_background() -> None:
    assert hit(project_with(SQUARE), 1, chosen("shape-1"), (60.0, 60.0), ONE) is None


def test_anchor_of_a_selected_shape_comes_before_its_outline() -> None:
    found = hit(project_with(SQUARE), 1, chosen("shape-1"), (108.0, 10.0), ONE)
    assert found == PointHit("shape-1", 1, ANCHOR, 2.0)


def test_anchors_of_shapes_that_are_not_selected_are_not_points_to_grab() -> None:
    found = hit(project_with(SQUARE), 1, chosen(), (110.0, 10.0), ONE)
    assert isinstance(found, OutlineHit)


def test_outline_is_hit_with_its_segment_and_parameter() -> None:
    found = hit(project_with(SQUARE), 1, chosen(), (60.0, 13.0), ONE)
    assert isinstance(found, OutlineHit)
    assert (found.segment, found.distance) == (0, pytest.approx(3.0))
    assert found.t == pytest.approx(0.5, abs=1e-3)


def test_closing_edge_of_an_open_shape_is_not_hit() -> None:
    project, shape = edit.new_shape(Project(), polygon_points(SQUARE), 1, closed=False)
    assert hit(project, 1, chosen(), (10.0, 60.0), ONE) is None
    assert hit(project.with_shape(replace(shape, closed=True)), 1, chosen(), (10.0, 60.0), ONE) is not None


@pytest.mark.parametrize("zoom", [0.25, 1.0, 8.0])
def test_hit_areas_have_one_size_on_screen(zoom: float) -> None:
    project, pixel = project_with(SQUARE), (1.0 / zoom, 1.0 / zoom)
    inside, outside = (REACH - 0.5) / zoom, (REACH + 0.5) / zoom
    assert hit(project, 1, chosen("shape-1"), (10.0 - inside, 10.0), pixel) is not None
    assert hit(project, 1, chosen("shape-1"), (10.0 - outside, 10.0), pixel) is None


def test_hit_areas_are_at_least_twelve_screen_pixels_wide() -> None:
    assert 2 * REACH >= 12.0


def test_reach_follows_the_shape_of_anamorphic_pixels() -> None:
    project = project_with(SQUARE)
    assert hit(project, 1, chosen(), (10.0 - 3.0, 60.0), (0.5, 1.0)) is not None
    assert hit(project, 1, chosen(), (10.0 - 4.0, 60.0), (0.5, 1.0)) is None


def test_selected_shape_is_hit_before_one_that_lies_above_it() -> None:
    project = project_with(SQUARE, SQUARE)
    assert hit_outline(project, 1, chosen(), (60.0, 10.0), ONE).shape_id == "shape-2"
    assert hit_outline(project, 1, chosen("shape-1"), (60.0, 10.0), ONE).shape_id == "shape-1"


def test_nearer_of_two_outlines_is_hit() -> None:
    shifted = [(x, y + 6.0) for x, y in SQUARE]
    assert hit_outline(project_with(SQUARE, shifted), 1, chosen(), (60.0, 12.0), ONE).shape_id == "shape-1"


@pytest.mark.parametrize("values", [{"locked": True}, {"visible": False}, {"lifetime": (5, 9)}])
def test_locked_hidden_and_absent_shapes_are_not_hit(values: dict[str, object]) -> None:
    project = edit.set_properties(project_with(SQUARE), "shape-1", **values)
    assert hit(project, 1, chosen("shape-1"), (10.0, 10.0), ONE) is None


@pytest.mark.parametrize("values", [{"locked": True}, {"visible": False}])
def test_shapes_of_a_locked_or_hidden_layer_are_not_hit(values: dict[str, object]) -> None:
    project, layer = edit.add_layer(project_with(SQUARE))
    project = moved(project, ["shape-1"], layer.id, 0)
    assert hit(project, 1, chosen("shape-1"), (10.0, 10.0), ONE) is not None
    assert hit(edit.set_properties(project, layer.id, **values), 1, chosen("shape-1"), (10.0, 10.0), ONE) is None


def project_with_handles() -> Project:
    points = polygon_points(SQUARE)
    points[0, IN], points[0, OUT] = (10.0, 40.0), (40.0, 10.0)
    return edit.new_shape(Project(), points, 1)[0]


def test_handles_are_hit_only_where_their_point_is_selected() -> None:
    project = project_with_handles()
    assert not isinstance(hit(project, 1, chosen("shape-1"), (10.0, 40.0), ONE), PointHit)
    found = hit(project, 1, chosen("shape-1", points={("shape-1", 0)}), (10.0, 40.0), ONE)
    assert isinstance(found, PointHit)
    assert (found.index, found.part) == (0, IN)


def test_handles_that_lie_in_their_anchor_cannot_be_hit() -> None:
    found = hit(project_with(SQUARE), 1, chosen("shape-1", points={("shape-1", 2)}), (110.0, 110.0), ONE)
    assert isinstance(found, PointHit)
    assert found.part == ANCHOR


def test_shape_is_hit_where_it_is_on_the_frame() -> None:
    moved = Keyframe(11, polygon_points(SQUARE) + 100.0)
    project = project_with(SQUARE)
    project = project.with_shape(project.shape("shape-1").with_key(moved))
    assert hit(project, 6, chosen("shape-1"), (60.0, 60.0), ONE) == PointHit("shape-1", 0, ANCHOR, 0.0)


def test_points_in_a_box_whatever_corner_it_was_begun_at() -> None:
    shapes: tuple[RotoShape, ...] = project_with(SQUARE).shapes
    right_side = frozenset({("shape-1", 1), ("shape-1", 2)})
    assert points_in_box(shapes, 1, (100.0, 0.0), (120.0, 120.0)) == right_side
    assert points_in_box(shapes, 1, (120.0, 120.0), (100.0, 0.0)) == right_side


def test_outline_search_agrees_with_a_fine_sampling_of_the_whole_curve() -> None:
    rng = np.random.default_rng(3)
    points = polygon_points(rng.uniform(0, 100, (12, 2)))
    points[:, 1:] += rng.normal(0, 8, (12, 2, 2))
    project, shape = edit.new_shape(Project(), points, 1)
    fine = shape.at(1).flatten(0.001)
    for position in rng.uniform(0, 100, (40, 2)):
        nearest = float(np.hypot(*(fine - position).T).min())
        found = hit_outline(project, 1, chosen(), tuple(position), ONE)
        if nearest < REACH - 0.05:
            assert found is not None
            assert found.distance == pytest.approx(nearest, abs=0.05)
        elif nearest > REACH + 0.05:
            assert found is None


def test_of_points_on_one_another_the_selected_one_is_meant() -> None:
    beside = [(110.0, 10.0), (210.0, 10.0), (210.0, 110.0), (110.0, 110.0)]
    project, both = project_with(SQUARE, beside), ("shape-1", "shape-2")
    for meant in (("shape-1", 1), ("shape-2", 0)):
        found = hit(project, 1, chosen(*both, points={meant}), (110.0, 10.0), ONE)
        assert isinstance(found, PointHit)
        assert (found.shape_id, found.index) == meant


def test_a_line_that_comes_back_beside_itself_is_hit_on_both_sides() -> None:
    points = polygon_points([(100.0, 60.0), (104.0, 60.0), (102.0, 70.0)])
    points[0, OUT], points[1, IN] = (110.0, -218.0), (103.0, -205.0)  # a thin finger, 200 pixels long
    project, shape = edit.new_shape(Project(), points, 1)
    finger = segments(shape.at(1).points, closed=True)[:1]
    for zoom in (4.0, 8.0, 16.0):
        for spot in (bernstein(np.linspace(0.02, 0.98, 97)) @ finger)[0]:
            found = hit_outline(project, 1, chosen(shape.id), spot, (1.0 / zoom, 1.0 / zoom))
            assert found is not None
            assert found.distance < 2.0


def test_a_selected_point_just_out_of_reach_keeps_no_other_from_being_hit() -> None:
    project, shape = edit.new_shape(Project(), polygon_points([(0.0, 10.0), (2.0 * REACH, 10.0), (0.0, 90.0)]), 1)
    found = hit(project, 1, chosen(shape.id, points={(shape.id, 0)}), (REACH + 0.1, 10.0), ONE)
    assert isinstance(found, PointHit)
    assert found.index == 1
