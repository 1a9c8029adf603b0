"""Projects: finding, replacing and naming what is in the tree of layers."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape, timing

POINTS = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (0.0, 10.0)])


def shape(number: int) -> RotoShape:
    return RotoShape(f"shape-{number}", f"Shape {number}", (Keyframe(1, POINTS),))


@pytest.fixture
def project() -> Project:
    """shape-1 at the bottom, a layer with shape-2 and an inner layer with shape-3, shape-4 on top."""
    inner = Layer("layer-2", "Inner", (shape(3),))
    outer = Layer("layer-1", "Outer", (shape(2), inner))
    return Project(root=Layer("root", "Root", (shape(1), outer, shape(4))))


def test_shapes_come_bottom_first(project: Project) -> None:
    assert [each.id for each in project.shapes] == ["shape-1", "shape-2", "shape-3", "shape-4"]


def test_items_come_with_parents_before_children(project: Project) -> None:
    ids = [item.id for item in project.root.items()]
    assert ids == ["shape-1", "layer-1", "shape-2", "layer-2", "shape-3", "shape-4"]


@pytest.mark.parametrize("item_id", ["root", "layer-2", "shape-3"])
def test_everything_is_found_by_its_id(project: Project, item_id: str) -> None:
    assert project.find(item_id).id == item_id


def test_what_is_not_there_is_not_found(project: Project) -> None:
    assert not project.has("shape-9")
    with pytest.raises(KeyError):
        project.find("shape-9")
    with pytest.raises(KeyError):
        project.shape("layer-1")
    with pytest.raises(KeyError):
        project.with_shape(shape(9))


def test_a_deep_shape_is_replaced_and_the_rest_is_shared(project: Project) -> None:
    wider = replace(shape(3), name="Wider")
    changed = project.with_shape(wider)
    assert changed.shape("shape-3") is wider
    assert project.shape("shape-3").name == "Shape 3"
    assert changed.shape("shape-2") is project.shape("shape-2")
    assert changed.root.children[0] is project.root.children[0]


def test_the_root_is_mapped_too(project: Project) -> None:
    changed = project.map_item("root", lambda layer: replace(layer, name="All"))
    assert changed.root.name == "All"
    assert changed.shapes == project.shapes


def test_free_ids_are_unused_and_the_same_every_time(project: Project) -> None:
    assert project.free_id("shape") == "shape-5"
    assert project.free_id("layer") == "layer-3"
    gap = Project(root=Layer("root", "Root", (shape(1), shape(3))))
    assert not gap.has(gap.free_id("shape"))
    assert gap.free_id("shape") == gap.free_id("shape")


def test_free_names(project: Project) -> None:
    assert project.free_name("Shape") == "Shape 5"
    assert project.free_name("Layer") == "Layer 1"


def test_a_project_without_a_clip_says_what_to_do() -> None:
    with pytest.raises(RoamError, match="open a folder of images or a movie"):
        Project().require_clip()
    clip = Clip(Path("/plates/a"), 1001, 1048, (960, 540))
    assert Project(clip).require_clip() is clip
    assert clip.frame_range == range(1001, 1049)
    assert clip.name == "a"


def test_equal_projects_are_equal_values(project: Project) -> None:
    again = project.with_shape(shape(3))
    assert again == project
    assert np.array_equal(again.shape("shape-3").keys[0].points, POINTS)


def test_what_is_not_there_cannot_be_replaced() -> None:
    with pytest.raises(KeyError, match="nobody"):
        Project().map_item("nobody", lambda item: item)


def test_several_shapes_are_replaced_at_once(project: Project) -> None:
    wider = [replace(shape(number), name="Wider") for number in (3, 1)]
    changed = project.with_shapes(wider)
    assert [each.name for each in changed.shapes] == ["Wider", "Shape 2", "Wider", "Shape 4"]
    assert changed == project.with_shape(wider[0]).with_shape(wider[1])
    assert changed.root.children[2] is project.root.children[2]
    assert project.with_shapes([]) is project
    with pytest.raises(KeyError):
        project.with_shapes([wider[0], shape(9)])


def test_of_two_with_one_id_the_lower_one_is_meant() -> None:
    twice = Project(root=Layer("root", "Root", (Layer("layer-1", "L", (shape(1),)), replace(shape(1), name="Upper"))))
    assert [layer.id for layer in twice.layers_above("shape-1")] == ["root", "layer-1"]
    changed = twice.with_shape(replace(shape(1), name="Lower"))
    assert [each.name for each in changed.shapes] == ["Lower", "Upper"]


def test_hundreds_of_questions_go_through_the_tree_once(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    walks, items = list[str](), Layer.items
    monkeypatch.setattr(Layer, "items", lambda layer: walks.append(layer.id) or items(layer))
    for _ in range(300):
        assert not project.is_locked("shape-3")
        assert project.has("shape-4")
    assert len(walks) <= 1


def test_many_shapes_are_put_into_their_layers_at_once(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    """A drag of all keys of the timeline built the tree anew for each of its shapes."""
    ids = ["shape-3", "shape-1", "shape-2"]
    wanted = project
    for shape_id in ids:
        wanted = wanted.map_item(shape_id, lambda held: replace(held, name="New"))
    made, after = list[str](), Layer.__post_init__
    monkeypatch.setattr(Layer, "__post_init__", lambda layer: made.append(layer.id) or after(layer))
    given = [replace(project.find(shape_id), name="New") for shape_id in ids]
    assert project.with_held(given) == wanted
    assert sorted(made) == ["layer-1", "layer-2", "root"]
    assert project.with_held([]) is project
    places = [("shape-1", 1), ("shape-2", 1), ("shape-3", 1)]
    made.clear()
    assert [shape.frames for shape in timing.move_keys(project, places, 2).shapes] == [(3,), (3,), (3,), (1,)]
    assert sorted(made) == ["layer-1", "layer-2", "root"]
