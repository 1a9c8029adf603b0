"""Where shapes and tracked layers are: by anchors or by the surface, and nothing of what is not seen."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.canvas.places import places_of
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Origin, Project, RotoShape, edit
from roam_core.roto.following import followed, matrix_of, surface_of, with_moving_layer
from roam_core.roto.layers import grouped

BOX = np.array([(0.0, 0.0), (40.0, 0.0), (40.0, 20.0), (0.0, 20.0)])
TURN = np.array([(0.8, -0.6, 30.0), (0.6, 0.8, -4.0), (0.0, 0.0, 1.0)])
LEAN = np.array([(1.1, 0.1, 5.0), (-0.2, 0.9, 3.0), (0.001, -0.002, 1.0)])


def project_of(corners: np.ndarray = BOX, count: int = 1) -> Project:
    project = Project()
    for index in range(count):
        project, _ = edit.new_shape(project, polygon_points(corners + 100.0 * index), 1)
    return project


def with_key(project: Project, frame: int, corners: np.ndarray, origin: Origin = Origin.ARTIST) -> Project:
    shape: RotoShape = project.shape("shape-1").with_key(Keyframe(frame, polygon_points(corners), origin=origin))
    return project.with_shape(shape)


def test_a_shape_is_at_the_mean_of_its_anchors() -> None:
    project = with_key(project_of(), 11, BOX + np.array((10.0, -6.0)))
    assert places_of(project, 1, {"shape-1"}) == {"shape-1": (20.0, 10.0)}
    assert places_of(project, 6, {"shape-1"})["shape-1"] == pytest.approx((25.0, 7.0))
    assert places_of(project, 99, {"shape-1"}) == {"shape-1": (30.0, 4.0)}  # the held outline
    assert places_of(project, 1, {"gone"}, {"gone"}) == {}


def test_the_place_is_the_same_spot_of_an_object_that_turns_and_one_point_hardly_moves_it() -> None:
    corners = np.array([(0.0, 0.0), (30.0, 4.0), (44.0, 20.0), (20.0, 38.0), (2.0, 25.0)])
    turned = corners @ TURN[:2, :2].T + TURN[:2, 2]
    chattering = corners.copy()
    chattering[2] += (5.0, 0.0)
    project = with_key(with_key(project_of(corners), 2, turned), 3, chattering)
    first, second, third = (np.array(places_of(project, frame, {"shape-1"})["shape-1"]) for frame in (1, 2, 3))
    assert second == pytest.approx(TURN[:2, :2] @ first + TURN[:2, 2])
    assert third - first == pytest.approx((1.0, 0.0))


def test_what_is_not_seen_has_no_place() -> None:
    project = edit.set_properties(project_of(count=3), "shape-1", visible=False)
    project = edit.set_properties(project, "shape-2", lifetime=(5, 9))
    every = {shape.id for shape in project.shapes}
    assert set(places_of(project, 1, every)) == {"shape-3"}
    assert set(places_of(project, 5, every)) == {"shape-2", "shape-3"}
    closed = with_key(project_of(), 5, np.full((4, 2), 50.0), Origin.ENGINE)
    assert places_of(closed, 5, {"shape-1"}) == {}
    assert places_of(closed, 4, {"shape-1"}) != {}


def tracked(project: Project, motion: np.ndarray) -> tuple[Project, str]:
    """The project with a layer about its first shape, which has `motion` from frame 1 to frame 4."""
    project, layer_id = with_moving_layer(project, {"shape-1"}, 1)
    return followed(project, layer_id, 1, 4, motion), layer_id


def test_a_shape_in_a_moving_layer_is_where_it_is_seen() -> None:
    project, _ = tracked(project_of(), TURN)
    assert places_of(project, 4, {"shape-1"})["shape-1"] == pytest.approx(TURN[:2, :2] @ (20.0, 10.0) + TURN[:2, 2])


def test_a_tracked_layer_is_at_the_middle_of_its_surface_whatever_its_shapes_do() -> None:
    project, layer_id = tracked(project_of(), LEAN)
    layer = project.find(layer_id)
    seen = matrix_of(project, layer_id, 4) @ (*surface_of(layer).mean(axis=0), 1.0)
    assert places_of(project, 4, {"shape-1"}, {layer_id}) == {layer_id: pytest.approx(tuple(seen[:2] / seen[2]))}
    ended = edit.set_properties(project, "shape-1", lifetime=(1, 3))
    assert set(places_of(ended, 4, {"shape-1"}, {layer_id})) == {layer_id}
    hidden = project.map_item(layer_id, lambda item: replace(item, visible=False))
    assert places_of(hidden, 4, {"shape-1"}, {layer_id}) == {}


def test_a_layer_that_does_not_move_is_where_its_shapes_are() -> None:
    project, layer = grouped(project_of(count=2), {"shape-1", "shape-2"}, "pair")
    assert set(places_of(project, 1, {"shape-1", "shape-2"}, {layer.id})) == {"shape-1", "shape-2"}
