"""Artist keys fitted to a mask: same points, in correspondence, parts that begin, end, divide and go on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core import RoamError, RotoShape, keys_from_mask, render_matte, shapes_from_mask
from roam_core.arrays import Bools
from roam_core.geometry import bezier, bspline, polyline
from roam_core.geometry.bezier import polygon_points
from roam_core.proposal.mask_keys import outline_match
from roam_core.roto import BlendMode, Keyframe, Origin, Spline, control_points
from tests.golden.shots import Shot, blob, dense, overlap, pose

RADII = [40.0, 52.0, 38.0, 45.0, 60.0, 43.0, 30.0]
SIZE = (240, 280)
STAR = Shot(blob(RADII), (pose(90.0, 90.0), pose(170.0, 130.0, 25.0, 1.2)), size=SIZE)


def solid(*boxes: tuple[int, int, int, int]) -> Bools:
    """A mask of (left, top, right, bottom) boxes."""
    mask = np.zeros((120, 160), dtype=bool)
    for left, top, right, bottom in boxes:
        mask[top:bottom, left:right] = True
    return mask


def require_matte(shapes: list[RotoShape], frame: int, mask: Bools, least: float = 0.97) -> None:
    assert overlap(render_matte(shapes, frame, mask.shape) > 0.5, mask) > least


@pytest.mark.parametrize(
    ("x", "y", "degrees", "scale"),
    [(92.0, 91.0, 0.0, 1.0), (170.0, 130.0, 25.0, 1.2), (150.0, 110.0, -70.0, 0.8), (90.0, 90.0, 4.0, 1.0)],
)
def test_a_key_anywhere_has_the_same_points_in_their_places(x: float, y: float, degrees: float, scale: float) -> None:
    shot = Shot(STAR.rest, (STAR.poses[0], pose(x, y, degrees, scale)), size=SIZE)
    start = shot.shape()
    (shape,) = keys_from_mask([start], shot.matte(1002), 1002)
    key = shape.key_at(1002)
    assert key is not None
    assert key.origin is Origin.ARTIST
    assert shape.key_at(1001) == start.key_at(1001)
    require_matte([shape], 1002, shot.matte(1002) > 0.5, 0.985)
    assert np.hypot(*(key.points - shot.truth(1002))[:, 0].T).mean() < 2.5


@pytest.mark.parametrize("scale", [0.15, 8.0])
def test_small_and_large_shapes_are_fitted_alike(scale: float) -> None:
    size = (int(240 * scale), int(280 * scale))
    shot = Shot(STAR.rest, tuple(pose(scale * x, scale * 100, 0.0, scale) for x in (90.0, 130.0)), size=size)
    (shape,) = keys_from_mask([shot.shape()], shot.matte(1002), 1002)
    require_matte([shape], 1002, shot.matte(1002) > 0.5, 0.96 if scale < 1 else 0.985)
    assert np.hypot(*(shape.at(1002).points - shot.truth(1002))[:, 0].T).mean() < max(2.5 * scale, 1.0)


def test_shapes_far_larger_than_any_picture_are_fitted(monkeypatch: pytest.MonkeyPatch) -> None:
    """A node every seven pixels, and a cell for every one of them, would be more than memory holds."""
    monkeypatch.setattr(outline_match, "OUTLINE_MATCH", replace(outline_match.OUTLINE_MATCH, most=60))
    huge = 1e5 * polygon_points([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    shapes = [RotoShape(name, name, (Keyframe(1, huge + shift),)) for name, shift in (("a", 0.0), ("b", 50.0))]
    mask = solid((30, 20, 120, 90))
    keyed = keys_from_mask(shapes, mask, 2)
    assert [shape.frames for shape in keyed] == [(1, 2), (1, 2)]
    require_matte(keyed, 2, mask, 0.9)


def test_an_engine_key_is_the_expectation_and_gives_way() -> None:
    shape = STAR.shape().with_key(Keyframe(1002, STAR.truth(1002) + 2.0, origin=Origin.ENGINE, inputs="x"))
    (fitted,) = keys_from_mask([shape], STAR.matte(1002), 1002)
    key = fitted.key_at(1002)
    assert key is not None
    assert (key.origin, key.inputs) == (Origin.ARTIST, "")
    assert np.hypot(*(key.points - STAR.truth(1002))[:, 0].T).mean() < 2.0


def test_a_polygon_stays_a_polygon_and_no_key_crosses_itself() -> None:
    square = RotoShape("shape-1", "Box", (Keyframe(1, polygon_points([(20, 20), (60, 20), (60, 60), (20, 60)])),))
    (shape,) = keys_from_mask([square], solid((50, 40, 92, 84)), 5)
    points = shape.at(5).points
    npt.assert_array_equal(points[:, 1], points[:, 0])
    npt.assert_array_equal(points[:, 2], points[:, 0])
    npt.assert_allclose(points[:, 0], [(50, 40), (92, 40), (92, 84), (50, 84)], atol=1.5)
    rng = np.random.default_rng(1)
    for _ in range(4):
        wild = Shot(blob(rng.uniform(12.0, 60.0, 11)), (pose(120.0, 110.0),), size=SIZE)
        (wild_shape,) = keys_from_mask([STAR.shape()], wild.matte(1001), 1010)
        assert polyline.is_simple(bezier.flatten(wild_shape.at(1010).points))


def test_parts_begin_and_end_with_their_holes() -> None:
    first, second = solid((20, 20, 70, 60), (110, 80, 140, 100)), solid((23, 22, 73, 62), (100, 10, 150, 50))
    first[30:45, 35:50] = False
    second[20:35, 110:130] = False
    second[25:30, 115:125] = True
    shapes = keys_from_mask(shapes_from_mask(first, 1), second, 11)
    assert [shape.exists_at(1) for shape in shapes] == [True, True, True, False, False, False]
    assert [shape.exists_at(11) for shape in shapes] == [True, False, False, True, True, True]
    assert [shape.blend for shape in shapes[3:]] == [BlendMode.ADD, BlendMode.SUBTRACT, BlendMode.ADD]
    assert len({shape.id for shape in shapes}) == len(shapes)
    require_matte(shapes, 1, first)
    require_matte(shapes, 11, second)


def test_a_part_begins_as_shapes_from_mask_makes_it() -> None:
    """Its outline is followed as closely, also in a picture of few lines."""
    mask = solid((20, 20, 100, 90)) ^ solid((50, 40, 70, 60)) ^ (STAR.matte(1001) > 0.5)[:120, :160]
    begun, made = keys_from_mask([], mask, 3), shapes_from_mask(mask, 3)
    assert len(begun) == len(made) > 2
    for shape in made:
        assert any(np.array_equal(shape.keys[0].points, each.keys[0].points) for each in begun)


def test_what_is_no_image_is_refused_by_both() -> None:
    for function in (lambda mask: keys_from_mask([], mask, 1), shapes_from_mask):
        with pytest.raises(RoamError, match="is no image"):
            function(np.ones(5))


def test_a_hole_and_two_parts_keep_their_shapes() -> None:
    first, second = solid((10, 20, 70, 60), (80, 30, 130, 80)), solid((30, 32, 90, 72), (103, 44, 153, 94))
    first[30:50, 20:40] = False
    second[42:62, 40:60] = False
    shapes = shapes_from_mask(first, 1)
    moved = keys_from_mask(shapes, second, 2)
    assert [shape.id for shape in moved] == [shape.id for shape in shapes]
    assert all(shape.frames == (1, 2) for shape in moved)
    require_matte(moved, 2, second)
    for shape in moved:
        step = (shape.at(2).points - shape.at(1).points)[:, 0].mean(axis=0)
        npt.assert_allclose(step, (21.0, 13.0), atol=4.0)


def test_a_shape_with_later_keys_goes_on_behind_a_mask_without_it() -> None:
    shape = STAR.shape().with_key(Keyframe(1020, STAR.truth(1002)))
    before, after = keys_from_mask([shape], np.zeros(SIZE, dtype=np.uint8), 1010)
    assert before.keys == shape.keys
    assert [before.exists_at(frame) for frame in (0, 1009, 1010, 1020)] == [True, True, False, False]
    assert [after.exists_at(frame) for frame in (1010, 1011, 1020)] == [False, True, True]
    assert after.key_at(1020) == shape.key_at(1020)
    assert after.id != before.id
    (earlier,) = keys_from_mask([STAR.shape()], np.zeros(SIZE, dtype=np.uint8), 1000)
    assert [earlier.exists_at(frame) for frame in (1000, 1001)] == [False, True]


def test_a_shape_that_ends_there_anyway_has_no_twin_behind_a_mask_without_it() -> None:
    shape = replace(STAR.shape().with_key(Keyframe(1020, STAR.truth(1002))), lifetime=(1000, 1011))
    (ended,) = keys_from_mask([shape], np.zeros(SIZE, dtype=np.uint8), 1010)
    assert (ended.keys, ended.lifetime) == (shape.keys, (1000, 1010))


def test_shapes_that_overlap_divide_the_part_they_make() -> None:
    first = solid((20, 40, 80, 80))
    body, arm = (shapes_from_mask(solid(box), 1)[0] for box in ((20, 40, 80, 80), (70, 50, 120, 60)))
    arm = replace(arm, id="shape-2")
    second = solid((25, 43, 85, 83), (75, 53, 125, 63))
    moved = keys_from_mask([body, arm], second, 2)
    assert [shape.frames for shape in moved] == [(1, 2), (1, 2)]
    require_matte(moved, 2, second)
    only = render_matte([moved[1]], 2, second.shape) > 0.5
    assert overlap(only, solid((75, 53, 125, 63))) > 0.8
    assert first.any()


def discs(*drawn: tuple[int, int, int]) -> Bools:
    """A mask of discs (x, y, radius)."""
    rows, columns = np.mgrid[:160, :200]
    return np.any([np.hypot(columns - x, rows - y) < radius for x, y, radius in drawn], axis=0)


BOTH = discs((75, 80, 35), (127, 80, 25)) & ~discs((131, 80, 9))


@pytest.mark.parametrize("hole", [(500, 80, 9), (145, 80, 9), (70, 80, 9)], ids=["new", "upper", "lower"])
def test_a_hole_of_parts_that_have_grown_together_shows(hole: tuple[int, int, int]) -> None:
    """It lies in the territory of the smaller part, the shape of which lies above the other."""
    shapes = shapes_from_mask(discs((50, 80, 35), (145, 80, 25)) & ~discs(hole), 1)
    keyed = keys_from_mask(shapes, BOTH, 10)
    drawn = [shape for shape in shapes if shape.blend is BlendMode.ADD]
    assert [shape.id for shape in keyed if shape.frames == (1, 10) and shape.blend is BlendMode.ADD] == [
        shape.id for shape in drawn
    ]
    assert render_matte(keyed, 10, BOTH.shape)[80, 131] == 0.0
    require_matte(keyed, 10, BOTH)
    known = {shape.id for shape in shapes}
    assert [shape.id for shape in keyed if shape.id in known] == [shape.id for shape in shapes]


def test_a_hole_stays_where_another_shape_of_its_part_passes_beside_it() -> None:
    body = shapes_from_mask(solid((10, 20, 90, 100)) & ~solid((30, 40, 50, 60)), 1)
    arm = replace(shapes_from_mask(solid((80, 50, 140, 70)), 1)[0], id="arm")
    mask = solid((10, 20, 90, 100), (70, 50, 130, 70)) & ~solid((30, 40, 50, 60))
    keyed = keys_from_mask([*body, arm], mask, 5)
    assert [shape.id for shape in keyed] == [*(shape.id for shape in body), "arm"]
    assert all(shape.frames == (1, 5) for shape in keyed)
    require_matte(keyed, 5, mask)


def test_shapes_that_take_no_part_stay_as_they_are() -> None:
    mask = STAR.matte(1002)
    hidden, opened = replace(STAR.shape(), visible=False), replace(STAR.shape(), closed=False)
    clipping = replace(STAR.shape(), blend=BlendMode.INTERSECT)
    for shape in (hidden, opened, clipping):
        kept, new = keys_from_mask([shape], mask, 1002)
        assert kept == shape
        assert new.frames == (1002,)
    locked = replace(STAR.shape(), locked=True)
    assert keys_from_mask([locked], mask, 1002) == [locked]


def test_no_shape_and_no_mask() -> None:
    (new,) = keys_from_mask([], STAR.matte(1001), 1001)
    assert new.lifetime is not None
    assert new.lifetime[0] == 1001
    assert keys_from_mask([], np.zeros((8, 8)), 1) == []
    with pytest.raises(RoamError, match="no image"):
        keys_from_mask([], np.zeros((0, 8)), 1)


def test_what_began_on_a_frame_is_gone_again_when_the_mask_there_is_black() -> None:
    first = shapes_from_mask(solid((20, 20, 60, 70)), 1)
    white, black = solid((90, 60, 140, 110)), solid()
    ended = keys_from_mask(first, black, 5)
    for _ in range(2):
        begun = keys_from_mask(ended, white, 5)
        assert [shape.frames for shape in begun] == [(1,), (5,)]
        assert keys_from_mask(begun, black, 5) == ended
    (later,) = keys_from_mask(keys_from_mask([begun[1]], white, 9), black, 5)
    assert later.frames == (5, 9)
    assert later.lifetime is not None
    assert later.lifetime[0] == 6
    (other,) = keys_from_mask([begun[1]], solid((2, 2, 12, 12)), 5)
    assert other.frames == (5,)


def test_two_runs_give_the_same_bits() -> None:
    a, b = (keys_from_mask([STAR.shape()], STAR.matte(1002), 1002) for _ in range(2))
    assert a == b
    assert len(dense(a[0].at(1002).points)) == 800


def test_a_bspline_stays_one() -> None:
    shape = control_points.with_spline(shapes_from_mask(solid((20, 20, 60, 70)), 1)[0], Spline.BSPLINE)
    (keyed,) = keys_from_mask([shape], solid((30, 24, 74, 78)), 5)
    assert keyed.frames == (1, 5)
    assert bspline.is_bspline(keyed.at(5).points)
    npt.assert_allclose(keyed.at(5).control_points[:, 0].mean(axis=0), (52.0, 51.0), atol=3.0)


def closed(shape: RotoShape, frame: int) -> RotoShape:
    """The shape as an engine leaves it on a frame on which it is out of sight."""
    points = shape.keys[0].points
    middle = points[:, 0].mean(axis=0)
    return shape.with_key(Keyframe(frame, middle + 0.02 * (points - middle), origin=Origin.ENGINE, inputs="x"))


def test_a_shape_that_was_out_of_sight_takes_its_part_again() -> None:
    body, hand = (20, 20, 80, 100), (100, 40, 130, 80)
    shapes = shapes_from_mask(solid(body, hand), 1)
    assert len(shapes) == 2
    shapes = [shapes[0].with_key(replace(shapes[0].keys[0], frame=9)), closed(shapes[1], 9)]
    moved = solid(body, (104, 42, 134, 82))
    keyed = keys_from_mask(shapes, moved, 9)
    assert [shape.id for shape in keyed] == [shape.id for shape in shapes]
    assert keyed[1].exists_at(9)
    assert np.hypot(*(keyed[1].at(9).points - shapes[1].at(1).points - (4.0, 2.0))[:, 0].T).max() < 1.5
    require_matte(keyed, 9, moved)


def test_a_shape_that_stays_out_of_sight_takes_nothing_from_another() -> None:
    body, hand = (20, 20, 80, 100), (40, 40, 70, 80)
    whole, part = (shapes_from_mask(solid(box), 1, tolerance=1.0)[0] for box in (body, hand))
    shapes = [whole, closed(replace(part, id="hand"), 9)]
    keyed = keys_from_mask(shapes, solid(body), 9)
    assert not keyed[1].exists_at(9)
    assert np.hypot(*(keyed[0].at(9).points - whole.at(1).points)[:, 0].T).max() < 1.0
    require_matte(keyed, 9, solid(body))


def test_what_was_a_speck_gives_way_to_a_shape_of_enough_points() -> None:
    """A shape as coarse all along keeps its part."""
    star, size = blob([60.0, 25.0] * 6) + np.array([150.0, 100.0]), (200, 300)
    beside = polygon_points([(20, 20), (60, 20), (60, 60), (20, 60)])
    mask = sum(render_matte([RotoShape("x", "x", (Keyframe(9, each),))], 9, size) for each in (star, beside)) > 0.5
    coarse = polygon_points([(165, 80), (205, 80), (205, 120), (165, 120)])
    drawn = [RotoShape(f"shape-{n}", "", (Keyframe(5, each),)) for n, each in enumerate((coarse, beside), start=1)]
    assert keys_from_mask(drawn, mask, 9)[0].frames == (5, 9)
    speck = drawn[0].with_key(Keyframe(1, 0.1 * coarse))
    ended, kept, new = keys_from_mask([speck, drawn[1]], mask, 9)
    assert (ended.frames, ended.exists_at(9)) == ((1, 5), False)
    assert (kept.frames, new.frames) == ((5, 9), (9,))
    require_matte([ended, kept, new], 9, mask)


HERE, THERE = (20, 20, 60, 70), (90, 30, 130, 80)


def test_what_begins_on_a_later_mask_is_of_the_compound_of_the_others() -> None:
    keyed = keys_from_mask(shapes_from_mask(solid(HERE), 1), solid(HERE, THERE), 5)
    assert [shape.frames for shape in keyed] == [(1, 5), (5,)]
    assert {shape.compound for shape in keyed} == {shapes_from_mask(solid(HERE), 1)[0].compound}
    again = keys_from_mask(keyed, solid(HERE, THERE, (100, 90, 120, 110)), 9)
    assert {shape.compound for shape in again} == {keyed[0].compound}


def test_what_begins_beside_shapes_of_several_compounds_is_of_the_masks() -> None:
    drawn = [
        replace(shape, compound=name) for shape, name in zip(shapes_from_mask(solid(HERE, THERE)), "ab", strict=True)
    ]
    mask = solid(HERE, THERE, (20, 85, 50, 110))
    keyed = keys_from_mask(drawn, mask, 5)
    assert [shape.compound for shape in keyed] == ["a", "b", shapes_from_mask(mask, 5)[0].compound]


def test_a_lone_outline_and_what_begins_beside_it_are_one_thing() -> None:
    (drawn,) = (replace(shape, compound="") for shape in shapes_from_mask(solid(HERE)))
    assert [shape.compound for shape in keys_from_mask([drawn], solid(HERE), 5)] == [""]
    mask = solid(HERE, THERE)
    assert [shape.compound for shape in keys_from_mask([drawn], mask, 5)] == 2 * [shapes_from_mask(mask, 5)[0].compound]
    assert {shape.compound for shape in keys_from_mask([], mask, 5)} == {shapes_from_mask(mask, 5)[0].compound}


@pytest.mark.parametrize("frame", [1004, 1_789_237, 123_456_789, -123_456_789])
def test_a_part_that_begins_is_there_from_then_on_whatever_the_frames_number(frame: int) -> None:
    """Plates are numbered by the time of day, too: seven digits and more."""
    shapes = shapes_from_mask(solid((20, 20, 60, 60)), frame - 3)
    shapes = keys_from_mask(shapes, solid((20, 20, 60, 60), (90, 20, 130, 60)), frame)
    assert [shape.exists_at(frame + 5) for shape in shapes] == [True, True]
    ended = keys_from_mask(shapes, solid((20, 20, 60, 60)), frame + 3)
    assert [shape.exists_at(frame + 2) for shape in ended] == [True, True]
    assert [shape.exists_at(frame + 3) for shape in ended] == [True, False]


def test_shapes_of_one_id_are_keyed_each_by_itself() -> None:
    """Of masks made apart each has a `shape-1`: one took the place of the other, which was lost."""
    boxes = [(10, 20, 40, 60), (80, 20, 110, 60)]
    apart = [shape for box in boxes for shape in shapes_from_mask(solid(box), 1)]
    moved = solid((14, 24, 44, 64), (84, 24, 114, 64), (60, 80, 90, 110))
    result = keys_from_mask(apart, moved, 5)
    assert [shape.id for shape in result[:2]] == [shape.id for shape in apart] == ["shape-1", "shape-1"]
    assert [shape.frames for shape in result] == [(1, 5), (1, 5), (5,)]
    assert result[2].id != "shape-1"
    require_matte(result, 1, solid(*boxes))
    require_matte(result, 5, moved)
