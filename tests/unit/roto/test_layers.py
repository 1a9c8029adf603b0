"""Grouping, dissolving and restacking layers and shapes."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.matte import render_matte
from roam_core.roto import Layer, LayerTransform, Project, edit
from roam_core.roto.layers import grouped, home_for_new, moved, only, raised, top_items, ungrouped

SQUARE = polygon_points([(2.0, 2.0), (12.0, 2.0), (12.0, 9.0), (2.0, 9.0)])
TURN = np.array([[0.8, -0.6, 9.0], [0.6, 0.8, -2.0], [1e-3, 0.0, 1.0]])


@pytest.fixture
def project() -> Project:
    """`a` below layer 1 (with `b` below layer 2 (with `c`)) below `d`."""
    one, _ = edit.new_shape(Project(), SQUARE, 1, name="a")
    one, outer = edit.add_layer(one)
    one, _ = edit.new_shape(one, SQUARE, 1, name="b", layer_id=outer.id)
    one, inner = edit.add_layer(one, parent_id=outer.id)
    one, _ = edit.new_shape(one, SQUARE, 1, name="c", layer_id=inner.id)
    return edit.new_shape(one, SQUARE, 1, name="d")[0]


def told(layer: Layer) -> str:
    """Names, the lowest first, layers with their content."""
    return " ".join(f"({told(child)})" if isinstance(child, Layer) else child.name for child in layer.children)


@pytest.mark.parametrize(
    ("chosen", "tree"),
    [
        ({"shape-1", "shape-4"}, "(b (c)) (a d)"),
        ({"shape-1", "shape-3"}, "(b ()) (a c) d"),
        ({"shape-2", "shape-3"}, "a ((b c) ()) d"),
        ({"layer-1", "shape-3"}, "a ((b (c))) d"),
        ({"shape-3"}, "a (b ((c))) d"),
    ],
)
def test_a_group_takes_the_place_of_the_upper_most(project: Project, chosen: set[str], tree: str) -> None:
    after, layer = grouped(project, chosen)
    if chosen == {"shape-2", "shape-3"}:
        tree = "a (() (b c)) d"  # the inner layer holds the upper-most: the group lies above it
    assert told(after.root) == tree
    assert after.find(layer.id) is not layer
    assert told(project.root) == "a (b (c)) d"


def test_nothing_cannot_be_grouped(project: Project) -> None:
    with pytest.raises(ValueError, match="nothing to group"):
        grouped(project, [])


def test_what_lies_in_a_chosen_layer_is_left_to_it(project: Project) -> None:
    assert top_items(project, {"shape-4", "shape-3", "layer-1", "shape-1"}) == ["shape-1", "layer-1", "shape-4"]


@pytest.mark.parametrize("layer_id", ["layer-1", "layer-2"])
def test_dissolving_a_moving_layer_moves_nothing_that_is_seen(project: Project, layer_id: str) -> None:
    moving = LayerTransform.of({1: np.eye(3), 3: TURN})
    for each in ("layer-1", "layer-2"):
        project = edit.set_properties(project, each, transform=moving)
    freed = ungrouped(project, layer_id)
    assert told(freed.root) == ("a b (c) d" if layer_id == "layer-1" else "a (b c) d")
    for frame in range(5):
        for shape in project.shapes:
            seen = freed.shape(shape.id).at(frame).points
            np.testing.assert_allclose(seen, shape.at(frame).points, atol=1e-6)
        np.testing.assert_allclose(
            render_matte(freed, frame, (24, 32)), render_matte(project, frame, (24, 32)), atol=1e-4
        )


def test_what_a_dissolved_layer_hid_stays_hidden(project: Project) -> None:
    freed = ungrouped(edit.set_properties(project, "layer-1", visible=False, locked=True), "layer-1")
    assert [(each.visible, each.locked) for each in freed.root.children] == [
        (True, False), (False, True), (False, True), (True, False),
    ]  # fmt: skip
    with pytest.raises(ValueError, match="no layer"):
        ungrouped(project, "root")


@pytest.mark.parametrize(
    ("chosen", "layer_id", "index", "tree"),
    [
        (["shape-1"], "root", 3, "(b (c)) d a"),
        (["shape-4", "shape-1"], "layer-2", 0, "(b (a d c))"),
        (["shape-1", "layer-1"], "root", 0, "a (b (c)) d"),
        (["shape-3", "shape-2"], "root", 1, "a b c (()) d"),
    ],
)
def test_several_are_restacked_in_their_order(
    project: Project, chosen: list[str], layer_id: str, index: int, tree: str
) -> None:
    assert told(moved(project, chosen, layer_id, index).root) == tree


@pytest.mark.parametrize(
    ("chosen", "higher", "lower"),
    [
        (["shape-1"], "(b (c)) a d", "a (b (c)) d"),
        (["shape-4"], "a (b (c)) d", "a d (b (c))"),
        (["shape-1", "layer-1"], "d a (b (c))", "a (b (c)) d"),
        (["shape-1", "shape-4"], "(b (c)) a d", "a d (b (c))"),
        (["shape-2", "shape-4"], "a ((c) b) d", "a d (b (c))"),  # each in the layer that holds it
        (["shape-3"], "a (b (c)) d", "a (b (c)) d"),
        ([], "a (b (c)) d", "a (b (c)) d"),
    ],
)
def test_one_place_higher_or_lower_in_its_layer(project: Project, chosen: list[str], higher: str, lower: str) -> None:
    assert (told(raised(project, chosen, 1).root), told(raised(project, chosen, -1).root)) == (higher, lower)


def test_a_layer_cannot_lie_in_itself(project: Project) -> None:
    with pytest.raises(RoamError, match="cannot be moved into itself"):
        moved(project, ["layer-1"], "layer-2", 0)


def test_keys_stay_where_they_are_seen_and_then_go_with_the_layer(project: Project) -> None:
    push = np.array([[1.0, 0.0, 6.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    moving = edit.set_properties(project, "layer-1", transform=LayerTransform.of({1: TURN, 3: push @ TURN}))
    for chosen in ("shape-1", "shape-4"):
        after = moved(moving, [chosen], "layer-1", 0)
        np.testing.assert_allclose(after.shape(chosen).at(1).points, SQUARE, atol=1e-9)
        np.testing.assert_allclose(after.shape(chosen).at(3).points, SQUARE + np.array([6.0, 0.0]), atol=1e-9)
    seen = moving.shape("shape-3").at(1).points
    out = moved(moving, ["layer-2"], "root", 0)
    for frame in (1, 3):
        np.testing.assert_allclose(out.shape("shape-3").at(frame).points, seen, atol=1e-9)


def test_restacking_in_one_layer_changes_no_shape(project: Project) -> None:
    moving = edit.set_properties(project, "layer-1", transform=LayerTransform.of({1: TURN}))
    assert moved(moving, ["shape-2"], "layer-1", 2).find("shape-2") is moving.find("shape-2")


def test_an_untouched_shape_stays_the_very_same(project: Project) -> None:
    moving = edit.set_properties(project, "layer-1", transform=LayerTransform.of({1: TURN}))
    after = edit.set_properties(moving, "shape-1", name="other")
    assert after.shape("shape-3") is moving.shape("shape-3")
    assert after.shape("shape-1") is not moving.shape("shape-1")


@pytest.mark.parametrize(
    ("chosen", "tree"),
    [
        ({"shape-1", "shape-3"}, "a ((c))"),
        ({"shape-2"}, "(b)"),
        ({"layer-2", "shape-4"}, "((c)) d"),
        ({"layer-1"}, "(b (c))"),
        ({"root"}, "a (b (c)) d"),
        (set(), ""),
        ({"shape-9"}, ""),
    ],
)
def test_only_what_is_asked_for_stays_and_the_layers_around_it(project: Project, chosen: set[str], tree: str) -> None:
    assert told(only(project, chosen).root) == tree


def test_a_shape_alone_stays_where_its_layers_put_it(project: Project) -> None:
    moving = project.map_item("layer-1", lambda layer: replace(layer, transform=LayerTransform((1,), TURN[None])))
    moving = moving.map_item("layer-2", lambda layer: replace(layer, opacity=0.5))
    alone = only(moving, {"shape-3"})
    (shape,) = alone.shapes
    np.testing.assert_array_equal(shape.at(1).points, moving.shape("shape-3").at(1).points)
    assert render_matte(alone, 1, (24, 32)).max() == pytest.approx(0.5)


@pytest.mark.parametrize(
    ("chosen", "changed", "home"),
    [
        (set(), {}, "root"),
        ({"layer-1", "shape-2", "layer-2", "shape-3"}, {}, "layer-1"),
        ({"layer-2", "shape-3"}, {}, "layer-2"),
        ({"shape-3"}, {}, "layer-2"),
        ({"shape-2", "shape-3"}, {}, "layer-1"),
        ({"shape-1", "shape-3"}, {}, "root"),
        ({"shape-3"}, {"layer-2": {"locked": True}}, "layer-1"),
        ({"shape-3"}, {"layer-1": {"visible": False}}, "root"),
        ({"layer-2", "shape-3"}, {"layer-1": {"locked": True}}, "root"),
        ({"shape-3"}, {"layer-1": {"transform": LayerTransform.of({1: TURN})}}, "root"),
        ({"layer-1", "shape-3"}, {"layer-1": {"transform": LayerTransform.of({1: TURN})}}, "layer-1"),
        ({"shape-3"}, {"shape-3": {"compound": "mask-1"}}, "layer-1"),
        ({"layer-2", "shape-3"}, {"shape-3": {"compound": "mask-1"}}, "layer-2"),
    ],
)
def test_what_is_drawn_comes_into_the_layer_that_is_selected_or_whose_shapes_are(
    project: Project, chosen: set[str], changed: dict[str, dict[str, object]], home: str
) -> None:
    for item_id, values in changed.items():
        project = edit.set_properties(project, item_id, **values)
    assert home_for_new(project, chosen).id == home
