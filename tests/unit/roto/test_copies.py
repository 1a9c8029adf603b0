"""Copies of layers and shapes: beside their originals, and taken out of what is around them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Layer, LayerTransform, Project, RotoShape, edit, file, linking
from roam_core.roto import shape as shape_module
from roam_core.roto.copies import duplicated, joined, taken_out
from roam_core.roto.shape import NO_COLOUR

SQUARE = polygon_points([(2.0, 2.0), (12.0, 2.0), (12.0, 9.0), (2.0, 9.0)])
FRAMES = range(1, 5)


def moving(x: float) -> LayerTransform:
    """So many pixels to the right on each frame."""
    return LayerTransform.of({frame: np.array([[1, 0, x * frame], [0, 1, 0], [0, 0, 1]], float) for frame in FRAMES})


@pytest.fixture
def project() -> Project:
    """`Arm` below the moving layer `Body`, which holds `Leg 9` below the moving layer `Foot` with `Toe`."""
    project, _ = edit.new_shape(Project(), SQUARE, 1, name="Arm")
    project, body = edit.add_layer(project, "Body")
    project, _ = edit.new_shape(project, SQUARE, 1, name="Leg 9", layer_id=body.id)
    project, foot = edit.add_layer(project, "Foot", body.id)
    project, _ = edit.new_shape(project, SQUARE, 1, name="Toe", layer_id=foot.id)
    project = edit.set_properties(project, body.id, transform=moving(3.0), opacity=0.5)
    project = edit.set_properties(project, foot.id, transform=moving(-1.0))
    return linking.linked(project, ["shape-2", "shape-3"])


def told(layer: Layer) -> str:
    """Names, the lowest first, layers with their content."""
    return " ".join(
        f"{child.name}({told(child)})" if isinstance(child, Layer) else child.name for child in layer.children
    )


def places(project: Project, shape_id: str) -> np.ndarray:
    return np.array([project.shape(shape_id).at(frame).points for frame in FRAMES])


def test_a_layer_is_duplicated_with_what_lies_in_it(project: Project) -> None:
    """Its motion and its look, too; the copies are linked with each other."""
    after, copies = duplicated(project, {"layer-1", "shape-2", "shape-1"})
    assert told(after.root) == "Arm Body(Leg 9 Foot(Toe)) Arm 1 Body 1(Leg 10 Foot 1(Toe 1))"
    arm, body = (after.find(item_id) for item_id in copies)
    assert isinstance(body, Layer)
    assert (body.opacity, body.transform) == (0.5, moving(3.0))
    leg, toe = body.shapes()
    assert leg.link == toe.link != after.shape("shape-2").link
    assert np.array_equal(places(after, toe.id), places(project, "shape-3"))
    ids = [item.id for item in after.root.items()]
    assert len(ids) == len(set(ids)) == 10
    assert arm.id in ids


def test_a_duplicate_lies_in_the_layer_of_its_original(project: Project) -> None:
    after, copies = duplicated(project, ["shape-3", "shape-2"])
    assert told(after.root) == "Arm Body(Leg 9 Foot(Toe Toe 1) Leg 10)"
    for original, copy in zip(("shape-2", "shape-3"), copies, strict=True):
        assert np.array_equal(places(after, copy), places(project, original))
    assert len({after.shape(copy).link for copy in copies}) == 1


@pytest.mark.parametrize(
    ("locked", "chosen", "tree"),
    [
        ("layer-2", "shape-3", "Arm Body(Leg 9 Foot(Toe) Toe 1)"),
        ("layer-1", "shape-3", "Arm Body(Leg 9 Foot(Toe)) Toe 1"),
        ("layer-1", "layer-2", "Arm Body(Leg 9 Foot(Toe)) Foot 1(Toe 1)"),
    ],
)
def test_nothing_is_duplicated_into_a_locked_layer(project: Project, locked: str, chosen: str, tree: str) -> None:
    """It comes beside it, where it is seen; it became a part of what nobody may change, and could not be moved."""
    project = edit.set_properties(project, locked, locked=True)
    after, (copy,) = duplicated(project, [chosen])
    assert told(after.root) == tree
    assert told(after.find(locked)) == told(project.find(locked))
    assert not after.is_locked(copy)
    shapes = after.find(copy).shapes() if isinstance(after.find(copy), Layer) else [after.shape(copy)]
    assert np.allclose(places(after, next(iter(shapes)).id), places(project, "shape-3"))


def test_what_is_taken_out_is_seen_where_it_was(project: Project) -> None:
    """Through the text of a project, as by a clipboard; a layer keeps its own motion where none is around it."""
    for chosen, tree in (("layer-1", "Body(Leg 9 Foot(Toe))"), ("layer-2", "Foot(Toe)"), ("shape-3", "Toe")):
        text = file.dumps(Project(root=Layer("root", "Root", tuple(taken_out(project, [chosen])))), Path())
        items = file.loads(text, Path(), "text").root.children
        after, (copy,) = joined(Project(), items)
        assert told(after.root) == tree
        toe = after.shapes[-1]
        assert np.allclose(places(after, toe.id), places(project, "shape-3"))
        kept = after.find(copy)
        assert not isinstance(kept, Layer) or (kept.transform is not None) == (chosen == "layer-1")


def test_what_joins_without_a_colour_gets_one_of_its_own(project: Project) -> None:
    plain = [replace(shape, colour=NO_COLOUR) for shape in project.root.shapes()]
    after, copies = joined(project, [Layer("layer-1", "New", tuple(plain))])
    assert copies == ["layer-3"]
    assert len({shape.colour for shape in after.shapes}) == 6


def test_a_copy_in_a_moving_layer_has_the_very_keys(project: Project, monkeypatch: pytest.MonkeyPatch) -> None:
    """They were taken out of the layer and back, and placed once more: seconds, where there are hundreds of shapes."""
    shape = project.shape("shape-3")
    project = project.with_shape(shape.with_keys([Keyframe(frame, SQUARE + frame / 3.0) for frame in (2, 3, 4)]))
    own, seen = project.find("shape-3"), project.shape("shape-3")
    carried = list[int]()
    monkeypatch.setattr(shape_module, "_carried_keys", lambda keys, *_: carried.append(len(keys)) or [])
    after, (copy,) = duplicated(project, ["shape-3"])
    held, placed = after.find(copy), after.shape(copy)
    assert sum(carried) == 0
    for one, original in ((held, own), (placed, seen)):
        assert isinstance(one, RotoShape)
        assert isinstance(original, RotoShape)
        assert [key is old for key, old in zip(one.keys, original.keys, strict=True)] == [True] * 4
    assert told(after.root) == "Arm Body(Leg 9 Foot(Toe Toe 1))"
