"""Which shapes are in sight and which may be edited."""

from __future__ import annotations

import numpy as np

from app.model.shown import editable_shapes, selection_bounds, shown_shapes
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from roam_core.roto.layers import moved

TRIANGLE = polygon_points([(0.0, 0.0), (10.0, 0.0), (0.0, 20.0)])


def project_of(count: int) -> Project:
    project = Project()
    for index in range(count):
        project, _ = edit.new_shape(project, TRIANGLE + 100.0 * index, 1)
    return project


def ids(project: Project, frame: int = 1) -> list[tuple[str, bool]]:
    return [(shown.shape.id, shown.locked) for shown in shown_shapes(project, frame)]


def test_shapes_come_bottom_first() -> None:
    assert ids(project_of(2)) == [("shape-1", False), ("shape-2", False)]


def test_hidden_and_absent_shapes_are_not_in_sight() -> None:
    project = edit.set_properties(project_of(3), "shape-1", visible=False)
    project = edit.set_properties(project, "shape-2", lifetime=(5, 9))
    assert ids(project) == [("shape-3", False)]
    assert ids(project, 5) == [("shape-2", False), ("shape-3", False)]


def test_a_layer_hides_and_locks_what_it_holds_however_deep() -> None:
    project, outer = edit.add_layer(project_of(1))
    project, inner = edit.add_layer(project, parent_id=outer.id)
    project = moved(project, ["shape-1"], inner.id, 0)
    assert ids(edit.set_properties(project, outer.id, locked=True)) == [("shape-1", True)]
    assert not editable_shapes(edit.set_properties(project, outer.id, locked=True), 1)
    assert ids(edit.set_properties(project, outer.id, visible=False)) == []


def test_bounds_of_the_selected_points_and_of_shapes() -> None:
    project, chosen = project_of(2), frozenset({"shape-2"})
    assert selection_bounds(project, 1, chosen, frozenset()) == (100.0, 100.0, 110.0, 120.0)
    points = frozenset({("shape-2", 0), ("shape-2", 1)})
    assert selection_bounds(project, 1, chosen, points) == (100.0, 100.0, 110.0, 100.0)
    assert selection_bounds(project, 1, frozenset(), frozenset()) is None


def test_bounds_hold_the_bulge_of_a_curve_but_not_its_handles() -> None:
    points = polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0)])
    points[0, 2], points[1, 1] = (0.0, -40.0), (10.0, -40.0)
    project, shape = edit.new_shape(Project(), points, 1)
    box = selection_bounds(project, 1, frozenset({shape.id}), frozenset())
    assert box is not None
    np.testing.assert_allclose(box, (0.0, -30.0, 10.0, 10.0), atol=1.0)
