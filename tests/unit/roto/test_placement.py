"""Moving layers: shapes seen, edited, rendered, stored and exported in plate space."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry import affine, projective
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.interchange.flatten import branched
from roam_core.interchange.plain_json import json_document
from roam_core.matte import render_matte
from roam_core.roto import (
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    LayerTransform,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    edit,
    file,
    timing,
)
from roam_core.roto import shape as module
from roam_core.roto.baking import baked, without_transforms

SQUARE = polygon_points([(10.0, 10.0), (30.0, 10.0), (30.0, 26.0), (10.0, 26.0)])
TILT = np.array([[1.1, 0.1, 4.0], [-0.05, 0.95, 2.0], [1e-3, 5e-4, 1.0]])


def moved(x: float, y: float) -> np.ndarray:
    return np.vstack([affine.translation((x, y)), [0.0, 0.0, 1.0]])


SLIDE = LayerTransform.of({1: np.eye(3), 5: moved(8.0, 0.0)})


def project(transform: LayerTransform | None = SLIDE, outer: LayerTransform | None = None) -> Project:
    """A clip of five frames; in it a square with keys on 1 and 3 in a layer in a layer."""
    one, layer = edit.add_layer(Project(clip=Clip(Path("/plate"), 1, 5, (60, 40))), "outer")
    one, inner = edit.add_layer(one, "inner", layer.id)
    one, shape = edit.new_shape(one, SQUARE, 1, layer_id=inner.id)
    one = one.with_shape(edit.set_key(shape, 3, SQUARE + np.array([0.0, 4.0])))
    one = edit.set_properties(one, inner.id, transform=transform)
    return edit.set_properties(one, layer.id, transform=outer)


def anchor(one: Project, frame: float) -> list[float]:
    return one.shape("shape-1").at(frame).points[0, ANCHOR].tolist()


def test_a_shape_goes_where_its_layers_put_it() -> None:
    one = project()
    assert [anchor(one, frame) for frame in (1, 2, 3, 5)] == [[10, 10], [12, 12], [14, 14], [18, 14]]
    both = project(outer=LayerTransform.of({1: np.diag([2.0, 2.0, 1.0])}))
    assert anchor(both, 2) == [24, 24]


def test_a_plain_project_gives_the_very_shapes() -> None:
    one = project(transform=None)
    assert one.plate_root is one.root
    assert one.shape("shape-1") is one.find("shape-1")
    assert without_transforms(one) is one


def test_an_edit_in_plate_space_lies_where_it_was_made() -> None:
    one = project(LayerTransform.of({1: TILT, 5: TILT @ moved(3.0, 1.0)}))
    shape = one.shape("shape-1")
    target = shape.at(2).points + np.array([1.5, -2.5])
    edited = one.with_shape(edit.set_key(shape, 2, target, np.ones((4, 3, 2))))
    np.testing.assert_allclose(edited.shape("shape-1").at(2).points, target, atol=1e-9)
    np.testing.assert_allclose(edited.shape("shape-1").at(2).feather, 1.0, atol=1e-9)
    held, before = edited.find("shape-1"), one.find("shape-1")
    assert [held.key_at(1), held.key_at(3)] == [before.key_at(1), before.key_at(3)]  # bit by bit
    assert not np.allclose(held.key_at(2).points, target)


def test_putting_a_shape_back_changes_nothing() -> None:
    one = project(LayerTransform.of({1: TILT, 4: moved(1 / 3, 1 / 7)}))
    assert one.with_shape(one.shape("shape-1")) == one


def test_a_new_shape_lies_where_it_was_drawn() -> None:
    one, shape = edit.new_shape(project(), SQUARE, 5, layer_id="layer-2")
    np.testing.assert_allclose(one.shape(shape.id).at(5).points, SQUARE, atol=1e-12)
    assert one.find(shape.id).keys[0].points[0, ANCHOR].tolist() == [2, 10]


@pytest.mark.parametrize("interpolation", Interpolation)
def test_the_matte_is_that_of_the_baked_project(interpolation: Interpolation) -> None:
    one = project(LayerTransform.of({1: np.eye(3), 3: TILT, 5: moved(8.0, 0.0)}))
    shape = edit.set_interpolation(one.shape("shape-1"), [1], interpolation)
    one = edit.set_properties(one.with_shape(shape), "layer-2", opacity=0.5)
    still = without_transforms(one)
    assert all(layer.transform is None for layer in still.root.items() if isinstance(layer, Layer))
    for frame in range(1, 6):
        np.testing.assert_array_equal(render_matte(one, frame, (40, 60)), render_matte(still, frame, (40, 60)))
    by_layer = render_matte(one.root, 5, (40, 60))
    np.testing.assert_array_equal(by_layer, render_matte(one, 5, (40, 60)))


def test_motion_of_a_layer_blurs() -> None:
    one = edit.set_properties(project(), "shape-1", motion_blur=MotionBlur(1.0, 0.0, 16))
    edge = render_matte(one, 3, (40, 60))[20, 12:18]
    assert ((edge > 0.0) & (edge < 1.0)).sum() >= 2


def test_baking_keeps_the_shapes_own_keys() -> None:
    one = project()
    engine = Keyframe(4, SQUARE, origin=Origin.ENGINE, confidence=0.5, inputs="x")
    one = one.with_shape(edit.set_engine_keys(one.shape("shape-1"), [engine]))
    shape = baked(one.shape("shape-1"))
    assert shape.frames == (1, 2, 3, 4, 5)
    assert [key.origin for key in shape.keys] == [Origin.ARTIST] * 3 + [Origin.ENGINE, Origin.ARTIST]
    assert shape.key_at(4).confidence == 0.5
    still = baked(project(LayerTransform.of({1: moved(8.0, 0.0)})).shape("shape-1"))
    assert still.frames == (1, 3)  # a layer that stands still asks for no keys


@pytest.mark.parametrize("interpolation", Interpolation)
@pytest.mark.parametrize("end", [TILT, moved(8.0, 2.0)])
def test_baking_keeps_the_outline_beyond_the_motion_of_the_layer(interpolation: Interpolation, end: np.ndarray) -> None:
    one = project(LayerTransform.of({5: np.eye(3), 8: end}))
    shape = edit.set_key(one.shape("shape-1"), 14, SQUARE + np.array([20.0, 4.0]))
    shape = edit.set_interpolation(edit.set_key(shape, 20, SQUARE * 2.0), shape.frames, interpolation)
    placed = one.with_shape(shape).shape("shape-1")
    still = baked(placed)
    for frame in range(25):
        np.testing.assert_allclose(still.at(frame).points, placed.at(frame).points, atol=1e-9, err_msg=str(frame))


def test_baking_keeps_a_step_where_the_layer_moves_on() -> None:
    one = project()
    placed = one.with_shape(edit.set_interpolation(one.shape("shape-1"), [1], Interpolation.HOLD)).shape("shape-1")
    still = baked(placed)
    np.testing.assert_allclose(still.at(1.5).points, placed.at(1.5).points)
    assert [still.at(2.75).points[0, ANCHOR].tolist(), placed.at(2.75).points[0, ANCHOR].tolist()] == [
        [12, 10],
        [13.5, 10],
    ]
    same = edit.set_key(placed, 3, SQUARE + np.array([4.0, 0.0]))  # held to what it is already: nothing steps
    np.testing.assert_allclose(baked(same).at(2.75).points, same.at(2.75).points)


def test_exports_hold_the_motion() -> None:
    one = project()
    (shape,) = branched(one).shapes()
    np.testing.assert_allclose(shape.at(5).points[0, ANCHOR], [18, 14])
    assert "18.0" in json_document(one)[0]


def test_a_transform_comes_back_from_the_file(tmp_path: Path) -> None:
    one = project(LayerTransform.of({1001: TILT, 1002: np.eye(3)}))
    file.save(one, tmp_path / "one.roam")
    again = file.load(tmp_path / "one.roam")
    assert again.find("layer-2").transform == one.find("layer-2").transform
    assert file.digest(again) == file.digest(one)
    assert file.digest(edit.set_properties(one, "layer-2", transform=None)) != file.digest(one)


def test_between_frames_it_blends_and_beyond_it_stands() -> None:
    assert SLIDE.at(3)[0, 2] == 4.0
    assert SLIDE.at(2.5)[0, 2] == 3.0
    assert SLIDE.at(-7)[0, 2] == 0.0
    assert SLIDE.at(99)[0, 2] == 8.0
    assert SLIDE.with_matrices({3: np.eye(3)}).at(4)[0, 2] == 4.0
    assert SLIDE.without([5]) == LayerTransform.of({1: np.eye(3)})
    assert SLIDE.without([1, 5]) is None


@pytest.mark.parametrize(
    ("frames", "matrices"),
    [
        ((), np.empty((0, 3, 3))),
        ((1, 1), np.array([np.eye(3)] * 2)),
        ((2, 1), np.array([np.eye(3)] * 2)),
        ((1,), np.zeros((1, 3, 3))),
        ((1,), np.full((1, 3, 3), np.nan)),
        ((1,), np.diag([0.0, 1.0, 1.0])[None]),
    ],
)
def test_what_is_no_motion_is_refused(frames: tuple[int, ...], matrices: np.ndarray) -> None:
    with pytest.raises(ValueError, match="transform"):
        LayerTransform(frames, matrices)


def test_what_lies_beyond_the_horizon_stays_finite() -> None:
    matrix = projective.normalised([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.1, 0.0, 1.0]])
    assert np.isfinite(projective.apply(matrix, SQUARE)).all()


def test_a_matrix_is_told_with_one_in_its_corner() -> None:
    twice = LayerTransform((1,), np.array([np.eye(3) * 2.0]))
    assert twice == LayerTransform.of({1: np.eye(3)})
    assert hash(twice) == hash(LayerTransform.of({1: np.eye(3)}))
    assert replace(Layer("a", "a"), transform=twice) == Layer("a", "a", transform=LayerTransform.of({1: np.eye(3)}))


def test_keys_that_go_to_other_frames_stay_where_they_lie_in_a_moving_layer() -> None:
    """As seen they would come off the surface that the layer follows: with its only key the whole shape would."""
    one = project()
    held, seen = one.find("shape-1"), one.shape("shape-1").key_at(1)
    assert isinstance(held, RotoShape)
    assert seen is not None
    first = held.keys[0]
    ways = {
        "moved": timing.move_keys(one, [("shape-1", 1)], 2),
        "copied": timing.copy_keys(one, [("shape-1", 1)], 2),
        "pasted": timing.paste_keys(one, {"shape-1": [seen]}, 2, ["shape-1"]),
    }
    for way, after in ways.items():
        arrived = after.find("shape-1")
        assert isinstance(arrived, RotoShape)
        key = arrived.key_at(3)
        assert key is not None, way
        np.testing.assert_allclose(key.points, first.points, atol=1e-12, err_msg=way)
    as_seen = timing.paste_keys(one, {"shape-1": [seen]}, 2).shape("shape-1").key_at(3)
    assert as_seen is not None
    np.testing.assert_allclose(as_seen.points, seen.points, atol=1e-12)


def test_hundreds_of_shapes_in_a_moving_layer_are_carried_once() -> None:
    """Of more than 256 each edit of one carried all of them anew, with all of their keys."""
    one = project()
    for _ in range(299):
        one, _ = edit.new_shape(one, SQUARE, 1, layer_id="layer-2")
    before = one.shapes
    moved = one.with_shape(edit.set_key(before[7], 5, SQUARE))
    assert [k for k, (a, b) in enumerate(zip(before, moved.shapes, strict=True)) if a is not b] == [7]


def test_between_keys_only_those_around_are_taken_back(monkeypatch: pytest.MonkeyPatch) -> None:
    shape = project().shape("shape-1")
    for frame in (4, 5, 6):
        shape = shape.with_key(Keyframe(frame, SQUARE))
    wanted = [shape.at(frame).points.tolist() for frame in (0, 2, 4.5, 9)]
    counted, carried = list[int](), module._carried_key
    monkeypatch.setattr(module, "_carried_key", lambda key, *rest: counted.append(key.frame) or carried(key, *rest))
    assert [shape.at(frame).points.tolist() for frame in (0, 2, 4.5, 9)] == wanted
    assert counted == [1, 1, 3, 4, 5, 6]


def test_of_a_drag_only_the_keys_that_it_changes_are_carried(monkeypatch: pytest.MonkeyPatch) -> None:
    """Each step carried all keys of its shapes out of their layers and back: seconds, where there are thousands."""
    one = project(LayerTransform.of({1: TILT, 5: moved(8.0, 0.0)}))
    shape = one.shape("shape-1")
    one = one.with_shape(shape.with_keys([Keyframe(frame, SQUARE + frame) for frame in range(4, 40)]))
    held, seen = one.find("shape-1"), one.shape("shape-1")
    counted, carried = list[int](), module._carried_key
    monkeypatch.setattr(module, "_carried_key", lambda key, *rest: counted.append(key.frame) or carried(key, *rest))
    steps = [one.with_shape(edit.set_key(seen, 7, SQUARE + 50.0 + step)) for step in range(3)]
    shown = [step.shape("shape-1") for step in steps]
    assert set(counted) == {7}
    for step, now in zip(steps, shown, strict=True):
        left = step.find("shape-1")
        assert isinstance(held, RotoShape)
        assert isinstance(left, RotoShape)
        for after, before in ((now, seen), (left, held)):
            assert [key.frame for key, own in zip(after.keys, before.keys, strict=True) if key is not own] == [7]
    monkeypatch.undo()
    (fresh,) = file.loads(file.dumps(steps[-1], Path()), Path()).shapes  # with nothing known of what it was before
    assert [key.points.tolist() for key in fresh.keys] == [key.points.tolist() for key in shown[-1].keys]


@pytest.mark.parametrize("soft", [False, True])
def test_the_keys_of_a_whole_shape_are_carried_bit_by_bit_as_one_by_one(soft: bool) -> None:
    random = np.random.default_rng(3)
    turns = {frame: moved(*random.uniform(-300, 300, 2)) + (frame % 3 > 0) * TILT / 9 for frame in range(1, 30, 4)}
    placement = LayerTransform.of(turns), LayerTransform.of({1: TILT, 20: moved(8.0, 0.0)}), SLIDE
    for count in (1, 2, 3, 4, 7, 30, 101):
        keys = tuple(
            Keyframe(frame, *random.uniform(-4000.0, 4000.0, (1 + soft, count, 3, 2))) for frame in range(-2, 35)
        )
        shape = RotoShape("shape-1", "One", keys)
        there = module.placed(shape, placement)
        back = module.unplaced(there)
        for now, before, way in ((there, shape, False), (back, there, True)):
            alone = [module._carried_key(key, placement, way) for key in before.keys]
            assert [key.points.tobytes() for key in now.keys] == [key.points.tobytes() for key in alone]
            assert list(now.keys) == alone


def test_keys_that_an_edit_changed_in_all_but_their_points_lie_where_they_lay(monkeypatch: pytest.MonkeyPatch) -> None:
    """New stamps on tracked keys took their points out of the layer and back: a little off, and seconds of many."""
    one = project(LayerTransform.of({1: TILT, 5: moved(1 / 3, 1 / 7)}))
    shape = one.shape("shape-1")
    one = one.with_shape(shape.with_keys([Keyframe(f, SQUARE + f, SQUARE / 9, inputs="a") for f in range(4, 40)]))
    held, seen = one.find("shape-1"), one.shape("shape-1")
    assert isinstance(held, RotoShape)
    carried = list[int]()
    monkeypatch.setattr(module, "_carried_keys", lambda keys, *_: carried.append(len(keys)) or [])
    after = one.with_shape(seen.with_keys([key.but(inputs="b") for key in seen.keys[2:]]))
    left, now = after.find("shape-1"), after.shape("shape-1")
    assert sum(carried) == 0
    assert isinstance(left, RotoShape)
    for shown, before in ((now, seen), (left, held)):
        assert [key.inputs for key in shown.keys] == ["", "", *["b"] * 36]
        for key, old in zip(shown.keys, before.keys, strict=True):
            assert key.points is old.points
            assert key == replace(old, inputs=key.inputs)
    monkeypatch.undo()
    (fresh,) = file.loads(file.dumps(after, Path()), Path()).shapes
    assert fresh.keys == now.keys
