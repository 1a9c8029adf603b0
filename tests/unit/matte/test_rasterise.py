"""One shape's matte: coverage, feather on both sides, motion blur, lifetime, invert and opacity."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.matte import Patch, render_matte, shape_matte, shape_patch
from roam_core.roto import Interpolation, Keyframe, MotionBlur, Origin, RotoShape
from tests.reference.coverage import comp_coverage_by_rows, ref_coverage
from tests.unit.matte.conftest import rectangle

SIZE = (20, 24)


def circle(centre: tuple[float, float], radius: float, count: int = 8) -> Array:
    """Spline points `(count, 3, 2)` of a circle, to about 1e-5 of its radius."""
    angle = np.arange(count) * 2.0 * np.pi / count
    radial = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    tangent = np.stack([-radial[:, 1], radial[:, 0]], axis=1) * (4.0 / 3.0) * np.tan(np.pi / count / 2.0)
    return np.asarray(centre) + radius * np.stack([radial, radial - tangent, radial + tangent], axis=1)


def test_a_square_on_pixel_borders_is_sharp(square: RotoShape) -> None:
    expected = np.zeros(SIZE, dtype=np.float32)
    expected[5:15, 5:15] = 1.0
    matte = shape_matte(square, 1, SIZE)
    assert matte.dtype == np.float32
    np.testing.assert_array_equal(matte, expected)


def test_a_circle_has_the_area_of_a_circle() -> None:
    shape = RotoShape("a", "Circle", (Keyframe(1, circle((50.0, 40.0), 30.0)),))
    assert shape_matte(shape, 1, (80, 100)).sum() == pytest.approx(np.pi * 30.0**2, rel=1e-3)


@pytest.mark.parametrize("seed", range(3))
def test_random_shapes_have_their_exact_area_in_every_pixel(seed: int) -> None:
    """A wobbly leaf: each pixel to 1/256 of a far finer polygon clipped to it, with and without 16 x 16 samples."""
    rng = np.random.default_rng(seed)
    points = 12.0 + (circle((0.0, 0.0), 8.0, 6) + rng.uniform(-1.5, 1.5, (6, 3, 2)))
    matte = shape_matte(RotoShape("a", "Leaf", (Keyframe(1, points),)), 1, (24, 24))
    fine = bezier.flatten(points, tolerance=1e-5)
    exact = comp_coverage_by_rows(fine, (24, 24))
    np.testing.assert_allclose(matte, exact, atol=1 / 256)
    samples = ref_coverage(bezier.flatten(points, tolerance=2e-3), (24, 24), samples=16)
    assert (np.abs(matte - samples) <= np.abs(samples - exact) + 1 / 256).all()


def test_the_matte_follows_the_keys(square: RotoShape) -> None:
    moving = square.with_key(Keyframe(11, square.keys[0].points + np.array([4.0, 0.0])))
    np.testing.assert_allclose(
        shape_matte(moving, 6, SIZE), shape_matte(rectangle(7.0, 5.0, 17.0, 15.0), 1, SIZE), atol=1e-6
    )


@pytest.mark.parametrize("invert", [False, True])
def test_an_open_shape_has_no_area(square: RotoShape, invert: bool) -> None:
    assert shape_matte(replace(square, closed=False, invert=invert), 1, SIZE).max() == 0.0


def test_a_shape_exists_in_its_lifetime_only(square: RotoShape) -> None:
    shape = replace(square, lifetime=(3, 5), invert=True)
    assert [bool(shape_matte(shape, frame, SIZE).any()) for frame in (2, 3, 4, 5)] == [False, True, True, False]


def test_invert_comes_before_opacity(square: RotoShape) -> None:
    matte = shape_matte(replace(square, invert=True, opacity=0.5), 1, SIZE)
    assert matte[10, 10] == 0.0
    assert matte[0, 0] == 0.5


# ---- uniform feather -------------------------------------------------------------------------------------------------


def test_feather_is_a_ramp_over_the_distance_outwards(square: RotoShape) -> None:
    matte = shape_matte(replace(square, feather=4.0), 1, SIZE)
    # The centres of the pixels right of the edge lie 0.5, 1.5, ... pixels away from it.
    np.testing.assert_allclose(matte[10, 14:20], [1.0, 0.875, 0.625, 0.375, 0.125, 0.0], atol=1e-6)
    # Around a corner the ramp is round.
    assert matte[16, 16] == pytest.approx(1.0 - np.hypot(1.5, 1.5) / 4.0, abs=1e-6)


def test_negative_feather_is_a_ramp_inwards(square: RotoShape) -> None:
    matte = shape_matte(replace(square, feather=-2.0), 1, SIZE)
    np.testing.assert_allclose(matte[10, 4:9], [0.0, 0.25, 0.75, 1.0, 1.0], atol=1e-6)


@pytest.mark.parametrize("feather", [0.7, 5.3, 29.0, -0.7, -5.3, -29.0])
@pytest.mark.parametrize("invert", [False, True])
def test_a_soft_matte_lies_in_its_bounds(feather: float, invert: bool) -> None:
    """A difference of two large integrals left them by a few rounding errors, which EXR files of 32 bits keep."""
    for shift in np.random.default_rng(7).uniform(0.0, 1.0, (20, 2)):
        points = circle((12.0, 10.0), 8.0) + shift
        shape = RotoShape("a", "Circle", (Keyframe(1, points),), feather=feather, invert=invert)
        matte = shape_matte(shape, 1, SIZE)
        assert 0.0 <= matte.min() <= matte.max() <= 1.0


def test_a_wide_soft_edge_falls_evenly() -> None:
    shape = rectangle(-2e4, -2e4, -5e3, 2e4, feather=8e3)
    [row] = np.unique(shape_matte(shape, 1, SIZE), axis=0)
    np.testing.assert_allclose(row, 1.0 - (np.arange(SIZE[1]) + 5000.5) / 8e3, atol=1e-6)


def test_the_soft_edge_of_a_shape_outside_the_image_reaches_into_it() -> None:
    matte = shape_matte(rectangle(-10.0, -5.0, -1.0, 30.0, feather=4.0), 1, SIZE)
    np.testing.assert_allclose(matte[10, :4], [1.0 - 1.5 / 4.0, 1.0 - 2.5 / 4.0, 1.0 - 3.5 / 4.0, 0.0], atol=1e-6)


@pytest.mark.parametrize("degrees", [10.0, 40.0, 90.0])
@pytest.mark.parametrize("width", [-4.0, -1.0, 1.0, 4.0])
def test_the_soft_edge_of_a_sharp_corner_glides_without_a_jump(degrees: float, width: float) -> None:
    """A pixel at a corner went over by a quarter at once, when the corner had covered half of it."""
    half, step = 50.0 * np.tan(np.radians(degrees / 2.0)), 0.005
    ways = [(x, 0.37 * x) for x in np.arange(0.0, 1.5, step)]
    tips = [np.array([(40.0 + x, 20.0 + y), (x - 10.0, 20.0 + y + half), (x - 10.0, 20.0 + y - half)]) for x, y in ways]
    shapes = [RotoShape("a", "a", (Keyframe(1, bezier.polygon_points(tip)),), feather=width) for tip in tips]
    mattes = np.stack([shape_matte(shape, 1, (40, 50)) for shape in shapes])
    assert 0.0 < np.abs(np.diff(mattes, axis=0)).max() < 3.0 * step


# ---- feather curve ---------------------------------------------------------------------------------------------------


def test_a_feather_curve_is_an_even_ramp_between_the_outlines() -> None:
    points = circle((50.0, 50.0), 20.0)
    feather = circle((50.0, 50.0), 32.0) - points
    matte = shape_matte(RotoShape("a", "Soft", (Keyframe(1, points, feather),)), 1, (100, 100))
    radius = np.hypot(*(np.stack(np.meshgrid(np.arange(100) + 0.5, np.arange(100) + 0.5)) - 50.0))
    expected = np.clip((32.0 - radius) / 12.0, 0.0, 1.0)
    np.testing.assert_allclose(matte, expected, atol=0.06)
    outwards = matte[50, 50:]
    assert (np.diff(outwards) <= 1e-6).all()


@pytest.mark.parametrize("gap", [100.0, 300.0, 1500.0])
def test_a_wide_feather_curve_shows_no_bands(gap: float) -> None:
    """However wide it was, it fell in 128 steps: beyond as many pixels each of them was a band."""
    inner, outer = (rectangle(-50.0, -5000.0, right, 5000.0).keys[0].points for right in (0.0, gap))
    shape = RotoShape("a", "Soft", (Keyframe(1, inner, outer - inner),))
    row = shape_matte(shape, 1, (1, 1600))[0]
    np.testing.assert_allclose(row, np.clip(1.0 - (np.arange(1600) + 0.5) / gap, 0.0, 1.0), atol=1e-5)


def test_a_feather_curve_inside_its_outline_softens_inwards() -> None:
    points = circle((50.0, 50.0), 30.0)
    matte = shape_matte(
        RotoShape("a", "Soft", (Keyframe(1, points, circle((50.0, 50.0), 18.0) - points),)), 1, (100,) * 2
    )
    assert matte[50, 50] == 1.0
    assert matte[50, 74] == pytest.approx(0.46, abs=0.05)
    assert matte[50, 82] == 0.0


def test_a_feather_curve_softens_only_where_it_leaves_the_outline(square: RotoShape) -> None:
    feather = np.zeros((4, 3, 2))
    feather[1:3, :, 0] = 6.0  # the right side
    matte = shape_matte(replace(square, keys=(Keyframe(1, square.keys[0].points, feather),)), 1, SIZE)
    np.testing.assert_allclose(matte[10, 3:6], [0.0, 0.0, 1.0], atol=1e-6)
    np.testing.assert_allclose(matte[10, 15:21], (5.5 - np.arange(6)) / 6.0, atol=0.07)


def test_a_feather_of_zeros_is_none(square: RotoShape) -> None:
    key = Keyframe(1, square.keys[0].points, np.zeros((4, 3, 2)))
    np.testing.assert_array_equal(shape_matte(replace(square, keys=(key,)), 1, SIZE), shape_matte(square, 1, SIZE))


@pytest.mark.parametrize(("curve", "width"), [(20.0, 4.0), (20.0, 10.0), (4.0, 20.0), (20.0, 0.0), (0.0, 20.0)])
def test_a_shape_with_both_feathers_is_as_soft_as_the_wider_of_the_two(curve: float, width: float) -> None:
    inner, outer = rectangle(30.0, 30.0, 70.0, 70.0), rectangle(30.0 - curve, 30.0 - curve, 70.0 + curve, 70.0 + curve)
    feather = outer.keys[0].points - inner.keys[0].points
    soft = replace(inner, keys=(Keyframe(1, inner.keys[0].points, feather),), feather=width)
    row = shape_matte(soft, 1, (100, 100))[50, 50:]
    np.testing.assert_allclose(row, np.clip(1.0 - (np.arange(50) - 19.5) / 20.0, 0.0, 1.0), atol=0.04)


@pytest.mark.parametrize("curve", [-10.0, 20.0])
@pytest.mark.parametrize("width", [-14.0, -4.0, 4.0, 14.0])
def test_both_feathers_fall_from_the_inside_to_the_outside(curve: float, width: float) -> None:
    inner, outer = rectangle(30.0, 30.0, 70.0, 70.0), rectangle(30.0 - curve, 30.0 - curve, 70.0 + curve, 70.0 + curve)
    feather = outer.keys[0].points - inner.keys[0].points
    soft = replace(inner, keys=(Keyframe(1, inner.keys[0].points, feather),), feather=width)
    row = shape_matte(soft, 1, (100, 100))[50, 50:]
    assert np.diff(row).max() <= 1e-6
    assert np.diff(row).min() > -0.3, "no step"


@pytest.mark.parametrize("width", [1e-300, 1e-42, -1e-42, 1e-9])
def test_a_feather_of_next_to_nothing_is_none(square: RotoShape, width: float) -> None:
    np.testing.assert_array_equal(shape_matte(replace(square, feather=width), 1, SIZE), shape_matte(square, 1, SIZE))


# ---- motion blur -----------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("samples", [2, 4, 16, 32])
@pytest.mark.parametrize("travel", [0.75, 8.0, 13.3])
def test_a_square_that_glides_leaves_the_analytic_ramp(samples: int, travel: float) -> None:
    """The share of the shutter during which a column is covered, averaged over the column's width."""
    start = rectangle(4.0, 4.0, 8.0, 16.0)
    moving = start.with_key(Keyframe(2, start.keys[0].points + np.array([travel, 0.0])))
    blurred = replace(moving, motion_blur=MotionBlur(shutter=1.0, phase=0.0, samples=samples))
    x = np.linspace(0.0, 24.0, 24 * 256, endpoint=False) + 1.0 / 512.0
    earliest, latest = np.clip((x - 8.0) / travel, 0.0, 1.0), np.clip((x - 4.0) / travel, 0.0, 1.0)
    expected = (latest - earliest).reshape(24, 256).mean(axis=1)
    matte = shape_matte(blurred, 1, SIZE)
    np.testing.assert_allclose(matte[5:15], np.tile(expected, (10, 1)), atol=1.0 / 512.0)
    assert matte[:4].max() == matte[16:].max() == 0.0


def test_a_soft_shape_is_filled_once_for_every_part_of_the_shutter() -> None:
    start = rectangle(4.0, 4.0, 8.0, 16.0, feather=2.0)
    moving = start.with_key(Keyframe(2, start.keys[0].points + np.array([8.0, 0.0])))
    blurred = replace(moving, motion_blur=MotionBlur(shutter=1.0, phase=0.0, samples=4))
    # Sub-frames at 1/8, 3/8, 5/8, 7/8: the rectangle's left side at 5, 7, 9, 11.
    still = [shape_matte(rectangle(x, 4.0, x + 4.0, 16.0, feather=2.0), 1, SIZE) for x in (5, 7, 9, 11)]
    np.testing.assert_allclose(shape_matte(blurred, 1, SIZE), np.mean(still, axis=0), atol=1e-6)


def test_a_jump_from_a_held_key_is_no_motion() -> None:
    start = rectangle(4.0, 4.0, 8.0, 16.0)
    held = replace(start.keys[0], interpolation=Interpolation.HOLD)
    moving = replace(start, keys=(held, Keyframe(2, start.keys[0].points + np.array([8.0, 0.0]))))
    matte = shape_matte(replace(moving, motion_blur=MotionBlur(shutter=1.0, phase=-0.5, samples=4)), 2, SIZE)
    np.testing.assert_allclose(matte[10, :24], [0] * 4 + [0.5] * 4 + [0] * 4 + [0.5] * 4 + [0] * 8, atol=1e-6)


@pytest.mark.parametrize("phase", [0.0, -0.25])
def test_a_jump_while_the_shutter_is_closed_leaves_the_ramp_even(phase: float) -> None:
    start = rectangle(4.0, 4.0, 8.0, 16.0)
    moving = start.with_key(Keyframe(2, start.keys[0].points + np.array([8.0, 0.0])))
    last = Keyframe(9, start.keys[0].points, interpolation=Interpolation.HOLD)
    blur = MotionBlur(shutter=0.5, phase=phase, samples=2)
    even = shape_matte(replace(moving.with_key(last), motion_blur=blur), 1, SIZE)
    np.testing.assert_array_equal(even, shape_matte(replace(moving, motion_blur=blur), 1, SIZE))
    held = last.points + np.array([0.0, 2.0])
    earlier = Keyframe(0, held, interpolation=Interpolation.HOLD)
    before = shape_matte(replace(moving.with_key(earlier), motion_blur=blur), 1, SIZE)
    assert np.array_equal(before, even) == (phase == 0.0)  # else the jump onto frame 1 is in the open shutter


@pytest.mark.parametrize(
    "blur", [MotionBlur(), MotionBlur(1.0, -0.5, 3), MotionBlur(2.0, -1.0, 4), MotionBlur(-0.5, 0.25)]
)
@pytest.mark.parametrize("feather", [0.0, 2.0])
def test_motion_blur_does_not_show_how_an_engine_closes_a_shape(blur: MotionBlur, feather: float) -> None:
    """On the frames beside it was out of sight the edge of a shape that holds still fell over an eighth of its size."""
    square = rectangle(4.0, 4.0, 16.0, 16.0, feather=feather)
    points = square.keys[0].points
    shut = 10.0 + 1e-3 * (points - 10.0)
    keys = [
        Keyframe(frame, shut if frame in (3, 4) else points, origin=Origin.ENGINE, interpolation=way)
        for frame, way in enumerate([Interpolation.LINEAR, Interpolation.SMOOTH] * 4)
    ]
    blurred = replace(square, keys=tuple(keys), motion_blur=blur)
    for frame in range(8):
        expected = np.zeros(SIZE) if frame in (3, 4) else shape_matte(square, 1, SIZE)
        np.testing.assert_allclose(shape_matte(blurred, frame, SIZE), expected, atol=1e-6)


def test_the_shutter_opens_at_its_phase() -> None:
    start = rectangle(8.0, 4.0, 12.0, 16.0, frame=1)
    moving = start.with_key(Keyframe(3, start.keys[0].points + np.array([8.0, 0.0])))
    centred = shape_matte(replace(moving, motion_blur=MotionBlur(1.0, -0.5, 8)), 2, SIZE)
    np.testing.assert_allclose(centred, np.roll(centred[:, ::-1], 4, axis=1), atol=1e-6)


def test_a_shape_that_holds_still_has_no_blur(square: RotoShape) -> None:
    blurred = replace(square, motion_blur=MotionBlur())
    np.testing.assert_allclose(shape_matte(blurred, 1, SIZE), shape_matte(square, 1, SIZE), atol=1e-6)


def test_polygon_points_fill_like_their_polygon() -> None:
    triangle = bezier.polygon_points([(2.0, 2.0), (18.0, 2.0), (2.0, 18.0)])
    matte = shape_matte(RotoShape("a", "Triangle", (Keyframe(1, triangle),)), 1, SIZE)
    assert matte.sum() == pytest.approx(128.0, abs=1e-3)


# ---- patches ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("corner", [(-30.0, 2.0), (-4.0, -6.0), (7.3, 5.1), (16.0, 14.0), (40.0, 2.0), (3.0, -40.0)])
@pytest.mark.parametrize("invert", [False, True])
def test_a_patch_holds_all_that_is_not_alike(corner: tuple[float, float], invert: bool) -> None:
    """Filled in a picture with a wide border, which the patch's rectangle does not reach, everything is the same."""
    x, y = corner
    shape = rectangle(x, y, x + 9.0, y + 7.0, feather=2.5, invert=invert, opacity=0.75)
    wide = replace(shape, keys=(Keyframe(1, shape.keys[0].points + 64.0),))
    expected = shape_matte(wide, 1, (20 + 128, 24 + 128))[64:-64, 64:-64]
    patch = shape_patch(shape, 1, SIZE)
    np.testing.assert_allclose(patch.whole(SIZE), expected, atol=1e-6)
    assert patch.values.size <= 18 * 16
    assert patch.outside == (0.75 if invert else 0.0)


def test_the_shapes_that_a_matte_joins_may_be_filled_by_who_asks(square: RotoShape) -> None:
    asked: list[str] = []

    def drawn(shape: RotoShape, frame: float, size: tuple[int, int]) -> Patch:
        asked.append(shape.name)
        return shape_patch(shape, frame, size)

    np.testing.assert_array_equal(render_matte([square], 1, SIZE, drawn), shape_matte(square, 1, SIZE))
    assert asked == ["Rectangle"]


@pytest.mark.parametrize("angle", [0.0, 10.0, 45.0, 77.0])
@pytest.mark.parametrize("shift", [0.0, 0.3, 0.5, 0.9])
def test_a_ramp_of_one_pixel_falls_evenly(angle: float, shift: float) -> None:
    """Along rows, columns and diagonals that leave the shape the matte never rises again."""
    turn = np.deg2rad(angle)
    corners = np.array([[-12.0, -9.0], [12.0, -9.0], [12.0, 9.0], [-12.0, 9.0]])
    rotation = np.array([[np.cos(turn), np.sin(turn)], [-np.sin(turn), np.cos(turn)]])
    points = bezier.polygon_points(corners @ rotation + 24.0 + shift)
    matte = shape_matte(RotoShape("a", "Soft", (Keyframe(1, points),), feather=1.0), 1, (48, 48))
    middle = 24
    runs = [matte[middle, middle:], matte[middle, middle::-1], matte[middle:, middle], matte[middle::-1, middle]]
    runs += [np.diagonal(part) for part in (matte[middle:, middle:], matte[middle::-1, middle::-1])]
    for run in runs:
        assert run[0] == 1.0
        assert run[-1] == 0.0
        assert (np.diff(run) <= 1e-6).all()
    assert ((matte > 0.0) & (matte < 1.0)).any()
