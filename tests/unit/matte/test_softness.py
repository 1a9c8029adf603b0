"""How soft an edge is in a picture: discs of known softness, moving and hard ones, and those that cannot be seen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array, UInt8
from roam_core.cancel import Cancelled, CancelToken
from roam_core.geometry import bspline
from roam_core.matte import render_matte, shape_matte
from roam_core.matte.edge_profile import edge
from roam_core.matte.softening import matched, softened, told
from roam_core.matte.softness import Softness, measured
from roam_core.media import MissingFrame
from roam_core.params.softness import SOFTNESS
from roam_core.roto import BlendMode, Keyframe, Layer, MotionBlur, Origin, RotoShape, Spline
from tests.unit.matte.test_rasterise import circle

SIZE = (120, 140)
CENTRE, RADIUS = np.array([68.0, 60.0]), 34.0


def disc(
    name: str = "disc", radius: float = RADIUS, step: float = 0.0, frames: Sequence[int] = (1,), count: int = 12
) -> RotoShape:
    """A disc with keys on frames, which moves to the right by `step` pixels a frame."""
    keys = [Keyframe(frame, circle((CENTRE[0] + step * (frame - 2), CENTRE[1]), radius, count)) for frame in frames]
    return RotoShape(name, name, tuple(keys))


def soft_disc(width: float) -> RotoShape:
    """A disc whose coverage falls from 1 to 0 over `width` pixels, about the outline of `disc`."""
    inner, outer = (circle((CENTRE[0], CENTRE[1]), RADIUS + side * width / 2.0, 12) for side in (-1.0, 1.0))
    return RotoShape("true", "true", (Keyframe(1, inner, outer - inner),))


def picture(matte: Array, contrast: float = 90.0, seed: int = 0) -> UInt8:
    """An object with this matte on a ground that differs by `contrast` grey values, both with grain."""
    rng = np.random.default_rng(seed)
    ground, cloth = (rng.normal(grey, 2.0, (*SIZE, 3)) for grey in (80.0, 80.0 + contrast))
    return np.clip(ground + matte[..., None] * (cloth - ground), 0, 255).astype(np.uint8)


def seen(
    pictures: Callable[[int], UInt8], asked: Sequence[RotoShape], shapes: Sequence[Layer | RotoShape] | None = None
) -> Softness:
    return measured(pictures, asked, root_of(shapes or asked), SOFTNESS, CancelToken(), lambda *_: None)


def root_of(items: Sequence[Layer | RotoShape]) -> Layer:
    return Layer("root", "Root", tuple(items))


def soft(shape: RotoShape, found: Softness, *, blur: bool = True, feather: bool = True) -> RotoShape:
    return matched(shape, found, SOFTNESS, blur=blur, feather=feather)


def test_it_tells_of_the_shapes_and_stops_between_them() -> None:
    """Of many shapes with many keys it stood still for minutes, with a full bar, and did not hear Ctrl-C."""
    frames = (1, 2, 3)
    shapes = [disc(name, frames=frames) for name in "ab"]
    images = {frame: picture(shape_matte(shapes[0], frame, SIZE)) for frame in frames}
    fractions: list[float] = []
    token = CancelToken()

    def progress(done: float, _: str) -> None:
        fractions.append(done)

    found, made = softened(images.__getitem__, shapes, root_of(shapes), SOFTNESS, token, progress)
    assert made == [soft(shape, found) for shape in shapes]
    assert fractions == sorted(fractions)
    assert fractions[len(frames) :] == [0.5, 0.75]

    def stopping(done: float, _: str) -> None:
        fractions.append(done)
        if done == 0.5:
            token.cancel()

    fractions.clear()
    with pytest.raises(Cancelled):
        softened(images.__getitem__, shapes, root_of(shapes), SOFTNESS, token, stopping)
    assert fractions[-1] == 0.5


@pytest.mark.parametrize("width", [0.0, 1.5, 5.0])
def test_an_edge_is_a_ramp_seen_through_a_gaussian(width: float) -> None:
    u, fine = np.linspace(-6.0, 6.0, 13), np.linspace(-12.0, 12.0, 24001)
    bell = np.exp(-0.5 * (fine / 0.6) ** 2) / (0.6 * np.sqrt(2.0 * np.pi))
    ramp = [np.clip(0.5 - (each - fine) / max(width, 1e-6), 0.0, 1.0) for each in u]
    np.testing.assert_allclose(edge(u, width, 0.6), [np.trapezoid(r * bell, fine) for r in ramp], atol=2e-3)


@pytest.mark.parametrize("width", [4.0, 6.0, 9.0])
def test_a_disc_of_known_softness_gives_its_width(width: float) -> None:
    truth = shape_matte(soft_disc(width), 1, SIZE)
    shape = disc()
    found = seen(lambda _: picture(truth), [shape])
    assert found.shutter is None
    assert found.typical(found.total) == pytest.approx(0.8 * np.hypot(width, 1.0), rel=0.2)
    after = soft(shape, found)
    assert after.motion_blur is None
    assert np.abs(shape_matte(after, 1, SIZE) - truth).sum() < 0.25 * np.abs(shape_matte(shape, 1, SIZE) - truth).sum()
    # Coverage is a half where it was, and looking again changes nothing.
    key = after.keys[0]
    assert key.feather is not None
    np.testing.assert_allclose((key.points + 0.5 * key.feather)[:, 0], shape.keys[0].points[:, 0], atol=1e-6)
    again = soft(after, seen(lambda _: picture(truth), [after])).keys[0]
    assert again.feather is not None
    np.testing.assert_allclose(again.points, key.points, atol=0.05)
    np.testing.assert_allclose(again.feather, key.feather, atol=0.1)


def test_the_softer_half_gets_the_wider_feather() -> None:
    left = np.arange(SIZE[1]) < CENTRE[0]
    truth = np.where(left, shape_matte(soft_disc(9.0), 1, SIZE), shape_matte(soft_disc(3.0), 1, SIZE))
    shape = disc(count=24)
    widths = seen(lambda _: picture(truth), [shape]).total["disc", 1]
    away = shape.keys[0].points[:, 0, 0] - CENTRE[0]
    assert widths[away < -12.0].min() > 6.0
    assert widths[away > 12.0].max() < 5.0


def test_a_hard_edge_stays_hard() -> None:
    shape = disc()
    found = seen(lambda _: picture(shape_matte(shape, 1, SIZE)), [shape])
    assert soft(shape, found) == shape
    assert told(found, [shape], [shape]).endswith("0 shapes changed, 0 with feather.")


def test_floats_say_what_bytes_say() -> None:
    image = picture(shape_matte(soft_disc(6.0), 1, SIZE))
    one, other = (seen(lambda _, kind=kind: kind, [disc()]) for kind in (image, image.astype(np.float32) / 255.0))
    np.testing.assert_array_equal(one.total["disc", 1], other.total["disc", 1])


def test_low_contrast_says_nothing() -> None:
    shape = replace(disc(), motion_blur=MotionBlur(shutter=0.3))
    found = seen(lambda _: picture(shape_matte(soft_disc(6.0), 1, SIZE), contrast=1.0), [shape])
    assert (found.shutter, found.typical(found.total)) == (None, None)
    assert soft(shape, found) == shape
    assert told(found, [shape], [shape]) == "No edge of these shapes could be read in the plate; nothing was changed."


@pytest.mark.parametrize("shutter", [0.3, 0.5, 0.9])
def test_motion_gives_the_shutter(shutter: float) -> None:
    shape = disc(step=9.0, frames=range(1, 4))
    truth = replace(shape, motion_blur=MotionBlur(shutter, -shutter / 2.0, 32))
    images = {frame: picture(shape_matte(truth, frame, SIZE), seed=frame) for frame in (2,)}

    def read(frame: int) -> UInt8:
        if frame not in images:
            raise MissingFrame("gone")
        return images[frame]

    found = seen(read, [shape])
    assert found.shutter == pytest.approx(shutter, abs=0.06)
    after = soft(shape, found)
    assert after.keys == shape.keys  # motion explains it all: no feather
    assert after.motion_blur is not None
    assert (after.motion_blur.shutter, after.motion_blur.phase) == pytest.approx(
        (found.shutter, -found.shutter / 2.0), abs=0.01
    )
    by_feather = soft(shape, found, blur=False)
    assert by_feather.motion_blur is None
    true, hard = shape_matte(truth, 2, SIZE), shape_matte(shape, 2, SIZE)
    for better in (after, by_feather) if shutter > 0.4 else (after,):  # a softness of 3 pixels at least is feather
        assert np.abs(shape_matte(better, 2, SIZE) - true).sum() < 0.6 * np.abs(hard - true).sum()


def test_motion_without_blur_takes_motion_blur_away() -> None:
    shape = replace(disc(step=9.0, frames=range(1, 4)), motion_blur=MotionBlur())
    hard = replace(shape, motion_blur=None)
    found = seen(lambda frame: picture(shape_matte(hard, frame, SIZE), seed=frame), [shape])
    assert found.shutter == 0.0
    assert soft(shape, found) == hard


def test_a_seam_is_not_read() -> None:
    """A disc in a greater one of another colour: only the outer outline is an edge of the whole."""
    inner, outer = disc("inner", 18.0), disc("outer")
    blurred = replace(soft_disc(9.0), id="blurred")
    image = picture(render_matte([blurred], 1, SIZE))
    found = seen(lambda _: image, [inner, outer])
    assert not found.seen["inner", 1].any()
    assert found.seen["outer", 1].all()


def test_a_shape_of_which_nothing_can_be_read_keeps_its_feather() -> None:
    """Beside another one that is read, and alone: the sentence says then that nothing was changed."""
    key = Keyframe(1, circle((20.0, 20.0), 9.0, 12), feather=np.full((12, 3, 2), 1.5))
    drawn = RotoShape("faint", "faint", (key,), feather=4.0)
    told_apart = picture(shape_matte(soft_disc(6.0), 1, SIZE))
    for asked in ([drawn], [disc(), drawn]):
        found = seen(lambda _: told_apart, asked)
        after = [soft(shape, found) for shape in asked]
        assert after[-1] == drawn
    assert after[0] != asked[0]
    assert told(seen(lambda _: told_apart, [drawn]), [drawn], [drawn]).endswith("nothing was changed.")


def test_a_b_spline_stays_one() -> None:
    count = 12
    points = bspline.bezier_points(circle((CENTRE[0], CENTRE[1]), RADIUS * 1.04, count)[:, 0])
    shape = RotoShape("disc", "disc", (Keyframe(1, points),), spline=Spline.BSPLINE)
    after = soft(shape, seen(lambda _: picture(shape_matte(soft_disc(7.0), 1, SIZE)), [shape]))
    assert after.keys[0].feather is not None
    assert bspline.is_bspline(after.keys[0].points)


def test_nothing_is_read_without_a_picture() -> None:
    def missing(frame: int) -> UInt8:
        raise MissingFrame(f"no frame {frame}")

    shape = disc()
    found = seen(missing, [shape])
    assert (found.shutter, found.total) == (None, {})
    assert soft(shape, found) == shape


def test_a_single_point_has_no_edge_and_stays_as_it_is() -> None:
    point = RotoShape("point", "point", (Keyframe(1, np.full((1, 3, 2), 60.0)),), feather=2.0)
    found = seen(lambda _: picture(shape_matte(soft_disc(6.0), 1, SIZE)), [point, disc()])
    assert set(found.total) == {("disc", 1)}
    assert soft(point, found) == point


def closed_on(shape: RotoShape, frames: Sequence[int]) -> RotoShape:
    """The shape, closed to a point in its middle by an engine on some frames."""
    points = shape.keys[0].points
    shut = points.mean(axis=(0, 1)) + 1e-3 * (points - points.mean(axis=(0, 1)))
    return shape.with_keys(Keyframe(frame, shut, origin=Origin.ENGINE) for frame in frames)


def test_what_is_out_of_sight_stays_so() -> None:
    """A point got an edge, and its outline, pushed inwards, came out on the other side: a spot of three pixels."""
    shape = closed_on(disc(frames=(1, 2)), (3, 4))
    image, ground = picture(shape_matte(soft_disc(6.0), 1, SIZE)), picture(np.zeros(SIZE))
    after = soft(shape, seen(lambda frame: image if frame < 3 else ground, [shape]))
    assert after.keys[0].feather is not None
    assert after.keys[2:] == shape.keys[2:]
    assert [shape_matte(after, frame, SIZE).max() for frame in (1, 2, 3, 4)] == [1.0, 1.0, 0.0, 0.0]


def test_closing_to_a_point_is_no_motion() -> None:
    shape = replace(closed_on(disc(frames=(2, 3)), (1, 4)), motion_blur=MotionBlur())
    found = seen(lambda _: picture(shape_matte(soft_disc(6.0), 1, SIZE)), [shape])
    assert found.shutter is None
    assert soft(shape, found).motion_blur == shape.motion_blur


@pytest.mark.parametrize("visible", [False, True])
@pytest.mark.parametrize("blend", [BlendMode.ADD, BlendMode.SUBTRACT])
@pytest.mark.parametrize("invert", [False, True])
def test_what_a_layer_hides_or_takes_away_makes_no_seam(visible: bool, blend: BlendMode, invert: bool) -> None:
    image, other = picture(shape_matte(soft_disc(6.0), 1, SIZE)), disc("other")
    for visible_child in (True, False):
        inner = Layer("inner", "inner", (replace(other, visible=visible_child),), invert=invert)
        layer = Layer("layer", "layer", (inner,), visible=visible, blend=blend)
        is_seam = visible and visible_child and blend is BlendMode.ADD and not invert
        found = seen(lambda _: image, [disc()], [layer, disc()])
        assert bool(found.seen["disc", 1].any()) is not is_seam


def test_seams_within_a_layer_that_takes_away_are_not_read() -> None:
    image, pieces = picture(shape_matte(soft_disc(6.0), 1, SIZE)), [disc("one"), disc("other")]
    layer = Layer("layer", "layer", tuple(pieces), blend=BlendMode.SUBTRACT)
    found = seen(lambda _: image, pieces, [disc("below", 50.0), layer])
    assert not any(found.seen[piece.id, 1].any() for piece in pieces)


def test_feather_for_all_softness_leaves_no_motion_blur() -> None:
    """With both, an edge that moves was softened twice."""
    shape = disc(step=9.0, frames=range(1, 4))
    blurred = replace(shape, motion_blur=MotionBlur(0.9, -0.45, 32))
    wide = replace(blurred, keys=disc(step=9.0, frames=range(5)).keys)
    true = shape_matte(wide, 2, SIZE)
    found = seen(lambda frame: picture(shape_matte(wide, frame, SIZE), seed=frame), [blurred])
    after = soft(blurred, found, blur=False)
    twice = replace(after, motion_blur=blurred.motion_blur)
    once_off, twice_off = (np.abs(shape_matte(each, 2, SIZE) - true).sum() for each in (after, twice))
    assert once_off < 0.6 * twice_off
    assert after == soft(shape, found, blur=False)
