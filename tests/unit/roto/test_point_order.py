"""Reverse direction and first point: the same curve on every frame, and all that is known of a point goes along."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import evaluate
from roam_core.interchange import write_shapes
from roam_core.matte import render_matte
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, Spline, edit, point_order
from roam_core.roto.animated import Interpolation
from roam_core.roto.control_points import with_spline
from roam_core.roto.pasting import copied_key, paste_key, targets
from roam_core.roto.point_order import in_order_of, is_renumbered, reversed_direction, with_first_point


def blob(closed: bool = True, feathered: bool = True) -> RotoShape:
    """Six points with handles of their own, on three keys: one of the artist's smooth, one of the engine, one held."""
    random = np.random.default_rng(7)
    angles = np.linspace(0.0, 2.0 * np.pi, 6, endpoint=False)
    anchors = np.stack([100.0 + 60.0 * np.cos(angles), 80.0 + 45.0 * np.sin(angles)], axis=1)
    keys = []
    for number, frame in enumerate((1, 5, 9)):
        points = anchors[:, None] + random.uniform(-9.0, 9.0, (6, 3, 2)) + 4.0 * number
        feather = random.uniform(-6.0, 12.0, (6, 3, 2)) if feathered else None
        keys.append(Keyframe(frame, points, feather))
    keys[0] = replace(keys[0], interpolation=Interpolation.SMOOTH, set_points=(0, 4))
    keys[1] = replace(keys[1], origin=Origin.ENGINE, vertex_confidence=np.linspace(0.0, 1.0, 6), inputs="x")
    return RotoShape("shape-1", "Blob", tuple(keys), closed=closed)


def curve(shape: RotoShape, frame: float) -> np.ndarray:
    count = shape.point_count if shape.closed else shape.point_count - 1
    segment, t = np.repeat(np.arange(count), 5), np.tile(np.linspace(0.0, 0.8, 5), count)
    return evaluate(shape.at(frame).points, segment, t, shape.closed)


@pytest.mark.parametrize("closed", [True, False])
def test_reversed_it_is_the_same_curve_the_other_way(closed: bool) -> None:
    shape = blob(closed)
    turned = reversed_direction(shape)
    assert np.array_equal(turned.keys[0].points[0], shape.keys[0].points[0 if closed else -1][[0, 2, 1]])
    for frame in (1, 2.5, 5, 7, 12):
        before, after = shape.at(frame), turned.at(frame)
        order = [0, 5, 4, 3, 2, 1] if closed else [5, 4, 3, 2, 1, 0]
        assert np.array_equal(after.points, before.points[order][:, [0, 2, 1]])
        assert np.array_equal(after.feather, before.feather[order][:, [0, 2, 1]])
        assert after.closed == closed
    assert turned.keys[0].set_points == ((0, 2) if closed else (1, 5))
    assert turned.keys[0].interpolation is Interpolation.SMOOTH
    assert turned.keys[1].vertex_confidence.tolist() == shape.keys[1].vertex_confidence[order].tolist()
    assert reversed_direction(turned) == shape


def test_another_first_point_moves_nothing() -> None:
    shape = blob()
    turned = with_first_point(shape, 4)
    for frame in (1, 2.5, 5, 7, 12):
        assert np.array_equal(turned.at(frame).points, np.roll(shape.at(frame).points, -4, axis=0))
        assert np.array_equal(curve(turned, frame), np.roll(curve(shape, frame), -20, axis=0))
    assert turned.keys[0].set_points == (0, 2)
    assert turned.keys[1].vertex_confidence[0] == shape.keys[1].vertex_confidence[4]
    assert with_first_point(turned, 2) == shape
    assert with_first_point(shape, 0) is shape


def test_an_open_shape_begins_at_its_end() -> None:
    with pytest.raises(RoamError, match="'Blob' is open and begins at one of its ends; reverse"):
        with_first_point(blob(closed=False), 2)


@pytest.mark.parametrize("closed", [True, False])
def test_a_bspline_stays_one_of_the_same_control_points(closed: bool) -> None:
    shape = with_spline(blob(closed, feathered=False), Spline.BSPLINE)
    turned = reversed_direction(shape)
    order = [0, 5, 4, 3, 2, 1] if closed else [5, 4, 3, 2, 1, 0]
    held, now = (each.at(3).control_points[:, 0] for each in (shape, turned))
    assert now == pytest.approx(held[order])
    if closed:
        assert with_first_point(shape, 3).at(3).control_points[:, 0] == pytest.approx(np.roll(held, -3, axis=0))


@pytest.mark.parametrize("width", [0.0, 8.0, -8.0])
def test_mattes_soft_edges_and_holes_stay_as_they_are(width: float) -> None:
    shape = replace(blob(), feather=width)
    hole = replace(blob(), id="shape-2", name="Hole", blend="subtract")
    hole = hole.map_points(lambda array: array * 0.5 + 45.0)
    project = Project(Clip("plate", 1, 12, (200, 160)))
    for each in (shape, hole):
        project = edit.add_shape(project, each)
    turned = project.with_shape(reversed_direction(shape)).with_shape(with_first_point(hole, 3))
    for frame in (1, 3, 9):
        before, after = (render_matte(each, frame, (160, 200)) for each in (project, turned))
        assert before.max() > 0.9
        assert np.abs(after - before).max() < 2e-3


def test_exports_follow_the_order(tmp_path) -> None:  # type: ignore[no-untyped-def]
    shape = blob(feathered=False)
    project = edit.add_shape(Project(Clip("plate", 1, 12, (200, 160))), shape)
    for name in ("nuke", "silhouette", "json"):
        texts = []
        for each in (shape, reversed_direction(shape), with_first_point(shape, 2)):
            path = tmp_path / f"{len(texts)}.{name}"
            write_shapes(project.with_shape(each), path, name)
            texts.append(path.read_bytes())
        assert len(set(texts)) == 3, name


@pytest.mark.parametrize("closed", [True, False])
def test_the_order_of_another_state_is_found_again(closed: bool) -> None:
    shape = blob(closed)
    states = [shape, reversed_direction(shape)]
    if closed:
        states += [with_first_point(state, index) for state in states[:2] for index in (1, 4)]
    for state in states:
        assert in_order_of(shape, state, 5) == state
        assert in_order_of(state, shape, 5) == shape
        assert is_renumbered(shape, state) is (state != shape)
    moved = shape.with_key(replace(shape.keys[0], points=shape.keys[0].points + 3.0))
    assert in_order_of(moved, reversed_direction(shape), 1) is moved
    assert in_order_of(moved, reversed_direction(shape), 9) == reversed_direction(moved)
    assert not is_renumbered(shape, moved)
    assert not is_renumbered(shape, replace(shape, closed=not closed))


def test_whether_points_have_other_numbers_is_told_without_putting_all_keys_in_order(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    """It was asked after each edit of each selected point, and for each changed key: seconds, of hundreds of keys."""
    shape = blob()
    turned = with_first_point(reversed_direction(shape), 2)
    moved = replace(shape, keys=tuple(replace(key, points=key.points + 3.0) for key in shape.keys))
    put_in_order: list[object] = []
    monkeypatch.setattr(point_order, "_reordered", lambda *_args, **_parts: put_in_order.append(_args))
    assert is_renumbered(shape, turned)
    assert not is_renumbered(shape, moved)
    assert not put_in_order


def test_a_copied_key_comes_back_in_the_order_that_its_shape_has_now() -> None:
    shape, other = blob(), replace(blob(), id="shape-2")
    copied = [copied_key(shape, 5)]
    turned = with_first_point(reversed_direction(shape), 2)
    project = Project(root=replace(Project().root, children=(turned, other)))
    for chosen in ([], [turned], [turned, other]):
        pasted = paste_key(turned, targets(project, copied, chosen)["shape-1"], [7])
        assert np.array_equal(pasted.at(7).points, turned.at(5).points)
    assert np.array_equal(targets(project, copied, [other])["shape-2"].points, shape.at(5).points)


@pytest.mark.parametrize("feathered", [False, True])
def test_all_keys_at_once_are_reordered_bit_by_bit_as_one_by_one(
    feathered: bool, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Each key was looked at again: seconds, where hundreds of shapes have hundreds of keys."""
    shape = blob(feathered=feathered)
    shape = shape.with_key(replace(shape.keys[2], feather=None))
    order, made = point_order.reversed_order(shape), list[object]()
    monkeypatch.setattr(Keyframe, "__post_init__", made.append)
    turned = reversed_direction(shape)
    assert made == []
    monkeypatch.undo()
    for own, key in zip(turned.keys, shape.keys, strict=True):
        trust = None if key.vertex_confidence is None else key.vertex_confidence[order]
        assert own == replace(
            key,
            points=key.points[order][:, [0, 2, 1]],
            feather=None if key.feather is None else key.feather[order][:, [0, 2, 1]],
            vertex_confidence=trust,
            set_points=tuple(sorted(np.argsort(order)[list(key.set_points)].tolist())),
        )
        assert not own.points.flags.writeable
