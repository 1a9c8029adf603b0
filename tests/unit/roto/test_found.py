"""Shapes found in a picture join a project."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.matte import render_matte, shapes_from_mask
from roam_core.roto import BlendMode, Layer, Project, edit
from roam_core.roto.found import add_found


def mask() -> np.ndarray:
    """A square with a hole, and a smaller square."""
    picture = np.zeros((80, 120), dtype=bool)
    picture[10:60, 10:60] = True
    picture[25:45, 25:45] = False
    picture[20:50, 80:110] = True
    return picture


def test_they_get_free_ids_names_and_colours() -> None:
    project, first = edit.new_shape(Project(), polygon_points([(0.0, 0.0), (5.0, 0.0), (5.0, 5.0)]), 1)
    project, ids = add_found(project, [shape for shape in shapes_from_mask(mask(), 3) if shape.name == "Shape 2"])
    (new,) = (project.shape(each) for each in ids)
    assert new.id != first.id
    assert new.name == "Shape 2"
    assert new.colour != first.colour
    assert new.frames == (3,)
    assert project.root.children[-1] is new


def test_holes_cut_their_own_object_only() -> None:
    """The hole lies over a shape that was there before; it is not cut."""
    under, _ = edit.new_shape(Project(), polygon_points([(20.0, 20.0), (50.0, 20.0), (50.0, 50.0), (20.0, 50.0)]), 3)
    project, ids = add_found(under, shapes_from_mask(mask(), 3))
    assert len(ids) == 3
    layer = project.root.children[1]
    assert isinstance(layer, Layer)
    assert layer.name == "Object 1"
    assert [shape.blend for shape in layer.shapes()] == [BlendMode.ADD, BlendMode.SUBTRACT]
    assert [shape.name for shape in layer.shapes()] == ["Shape 2", "Hole 1"]
    assert render_matte(project, 3, (80, 120))[35, 35] == 1.0
    alone = replace(project, root=replace(project.root, children=project.root.children[1:]))
    assert render_matte(alone, 3, (80, 120))[35, 35] == 0.0
    assert render_matte(alone, 3, (80, 120))[35, 95] == 1.0


def test_nothing_found_changes_nothing() -> None:
    assert add_found(Project(), []) == (Project(), ())


def test_the_pieces_of_a_mask_stay_one_thing_and_are_another_each_time() -> None:
    project, first = add_found(Project(), shapes_from_mask(mask(), 3))
    project, second = add_found(project, shapes_from_mask(mask(), 3))
    of_first, of_second = ({project.shape(each).compound for each in ids} for ids in (first, second))
    assert len(of_first) == len(of_second) == 1
    assert of_first != of_second


def test_they_come_into_the_layer_that_is_named() -> None:
    project, home = edit.add_layer(Project(), "Home")
    project, ids = add_found(project, shapes_from_mask(mask(), 3), home_id=home.id)
    assert [child.id for child in project.root.children] == [home.id]
    assert all(project.layers_above(shape_id)[1].id == home.id for shape_id in ids)
