"""What is seen of each shape: shares of the joint matte, whatever blends, inverts, hides or softens."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.matte import Matte, Patch, render_matte, shape_matte, shape_patch
from roam_core.matte.visible import Visible, visible_shares
from roam_core.roto import BlendMode, Keyframe, Layer, MotionBlur, RotoShape
from tests.unit.matte.conftest import rectangle

SIZE = (40, 48)
LEFT, BOTH, RIGHT = (20, 6), (20, 10), (20, 16)
"""Pixels under the lower shape only, under both, under the upper shape only."""


def root(*children: Layer | RotoShape, **values: object) -> Layer:
    return Layer("root", "Root", children, **values)  # type: ignore[arg-type]


def by_id(shares: list[Visible]) -> dict[str, Matte]:
    return {share.item.id: share.patch.whole(SIZE) for share in shares}


@pytest.mark.parametrize(
    ("blend", "lower", "upper"),
    [
        (BlendMode.ADD, (0.75, 0.375, 0.0), (0.0, 0.5, 0.5)),
        (BlendMode.PLUS, (0.75, 0.5, 0.0), (0.0, 0.5, 0.5)),
        (BlendMode.SUBTRACT, (0.75, 0.375, 0.0), (0.0, 0.0, 0.0)),
        (BlendMode.INTERSECT, (0.0, 0.375, 0.0), (0.0, 0.0, 0.0)),
        (BlendMode.DIFFERENCE, (0.75, 0.25, 0.0), (0.0, 0.0, 0.5)),
        (BlendMode.MAX, (0.75, 0.25, 0.0), (0.0, 0.5, 0.5)),
    ],
)
def test_the_upper_of_two_shapes_hides_the_lower(
    blend: BlendMode, lower: tuple[float, ...], upper: tuple[float, ...]
) -> None:
    below = replace(rectangle(5.0, 5.0, 13.0, 35.0), opacity=0.75)
    above = replace(rectangle(9.0, 5.0, 18.0, 35.0), id="shape-2", blend=blend, opacity=0.5)
    found = by_id(visible_shares(root(below, above), 1, SIZE)[0])
    nothing = np.zeros(SIZE, dtype=np.float32)
    for shape, wanted in ((below, lower), (above, upper)):
        assert [found.get(shape.id, nothing)[at] for at in (LEFT, BOTH, RIGHT)] == pytest.approx(list(wanted))


def test_a_shape_that_nothing_hides_is_its_own_matte() -> None:
    blurred = replace(rectangle(5.3, 5.1, 15.2, 15.7), feather=4.0, opacity=0.5, motion_blur=MotionBlur(), invert=True)
    (share,) = visible_shares(root(blurred), 1, SIZE)[0]
    np.testing.assert_array_equal(share.patch.whole(SIZE), shape_matte(blurred, 1, SIZE))


def test_what_is_hidden_wholly_or_absent_has_no_share() -> None:
    lower, upper = rectangle(8.0, 8.0, 12.0, 12.0), replace(rectangle(5.0, 5.0, 20.0, 20.0), id="shape-2")
    absent = [replace(lower, id=f"off-{k}", **off) for k, off in enumerate(({"visible": False}, {"closed": False}))]
    shares, _ = visible_shares(root(lower, upper, *absent), 1, SIZE)
    assert [share.item.id for share in shares] == ["shape-2"]
    assert visible_shares(root(lower, visible=False), 1, SIZE)[0] == []


def test_a_layer_scales_its_shapes_and_hides_what_lies_under_it() -> None:
    floor, inner = rectangle(0.0, 0.0, 48.0, 40.0), replace(rectangle(5.0, 5.0, 13.0, 35.0), id="shape-2")
    layer = Layer("layer-1", "Half", (inner,), opacity=0.5)
    found = by_id(visible_shares(root(floor, layer), 1, SIZE)[0])
    assert (found["shape-1"][LEFT], found["shape-2"][LEFT]) == (0.5, 0.5)
    assert (found["shape-1"][RIGHT], found["shape-2"][RIGHT]) == (1.0, 0.0)


def test_what_is_white_of_an_inverted_layer_is_the_layers_own() -> None:
    layer = Layer("layer-1", "Around", (rectangle(5.0, 5.0, 13.0, 35.0),), invert=True)
    (share,) = visible_shares(root(layer), 1, SIZE)[0]
    assert (share.item, share.layer) == (layer, layer)
    np.testing.assert_array_equal(share.patch.whole(SIZE), render_matte(layer, 1, SIZE))


@pytest.mark.parametrize("seed", range(40))
def test_shares_add_up_to_the_joint_matte(seed: int) -> None:
    """Of trees of every mode, soft, blurred, inverted and half transparent, drawn by chance."""
    random = np.random.default_rng(seed)
    count = iter(range(1000))

    def shape() -> RotoShape:
        corners = random.uniform((-8.0, -8.0), (56.0, 48.0), (4, 2))
        corners += random.choice([0.0, 0.0, 0.0, -90.0, 90.0], 2)  # some have left the picture
        keys = (
            Keyframe(1, bezier.polygon_points(corners)),
            Keyframe(3, bezier.polygon_points(corners + random.normal(0.0, 6.0, 2))),
        )
        return RotoShape(
            f"shape-{next(count)}",
            "S",
            keys,
            blend=random.choice(list(BlendMode)),
            opacity=float(random.choice([1.0, 1.0, 0.3, 0.0])),
            feather=float(random.choice([0.0, 0.0, 5.0, -3.0])),
            invert=bool(random.random() < 0.15),
            motion_blur=MotionBlur() if random.random() < 0.2 else None,
        )

    def layer(depth: int) -> Layer:
        children = [
            layer(depth - 1) if depth and random.random() < 0.4 else shape() for _ in range(int(random.integers(1, 6)))
        ]
        return Layer(
            f"layer-{next(count)}",
            "L",
            tuple(children),
            blend=random.choice(list(BlendMode)),
            opacity=float(random.choice([1.0, 0.6])),
            invert=bool(random.random() < 0.15),
            visible=bool(random.random() < 0.9),
        )

    tree = layer(3)
    shares, joint = visible_shares(tree, 2, SIZE)
    np.testing.assert_array_equal(joint, render_matte(tree, 2, SIZE))
    total = np.zeros(SIZE, dtype=np.float64)
    for share in shares:
        assert share.patch.values.min() >= 0.0
        total += share.patch.whole(SIZE)
    np.testing.assert_allclose(total, joint, atol=2e-6)


def test_what_is_filled_and_remembered_is_left_as_it_is() -> None:
    shapes = [rectangle(5.0, 5.0, 13.0, 35.0), replace(rectangle(9.0, 5.0, 18.0, 35.0), id="shape-2")]
    filled: dict[str, Patch] = {}

    def drawn(shape: RotoShape, frame: float, size: tuple[int, int]) -> Patch:
        return filled.setdefault(shape.id, shape_patch(shape, frame, size))

    visible_shares(root(*shapes, opacity=0.5), 1, SIZE, drawn)
    for shape in shapes:
        np.testing.assert_array_equal(filled[shape.id].whole(SIZE), shape_matte(shape, 1, SIZE))
