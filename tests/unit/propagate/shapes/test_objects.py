"""Which shapes are one object, and what each of them is in it."""

from __future__ import annotations

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.geometry.bezier import polygon_points
from roam_core.kernels import coverage
from roam_core.params import OBJECTS
from roam_core.propagate.shapes import objects as module
from roam_core.propagate.shapes.objects import Role, Unit, cuts, near, objects, stacked, units
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape, edit

CORNERS = np.array([(0, 0), (1, 0), (1, 1), (0, 1)])


def box(x: float, y: float, width: float, height: float) -> Array:
    return polygon_points(CORNERS * (width, height) + (x, y))


def square(
    x: float, y: float, side: float, *, hole: bool = False, frame: int = 1, link: str = "", of: str = ""
) -> RotoShape:
    """A square with its upper left corner at (x, y); `of` is its compound."""
    blend = BlendMode.SUBTRACT if hole else BlendMode.ADD
    return RotoShape("s", "S", (Keyframe(frame, box(x, y, side, side)),), blend=blend, link=link, compound=of)


def whole(*members: int) -> Unit:
    return Unit(Role.WHOLE, members)


def part(*members: int) -> Unit:
    return Unit(Role.PART, members)


def occluder(*members: int) -> Unit:
    return Unit(Role.OCCLUDER, members)


def test_shapes_that_overlap_or_abut_are_one_object_and_others_their_own() -> None:
    shapes = [square(0, 0, 40), square(300, 0, 40), square(30, 0, 40), square(71, 10, 40)]
    assert objects(shapes, 20.0) == [[0, 2, 3], [1]]
    assert objects([square(0, 0, 40), square(45, 0, 40)], 20.0) == [[0], [1]]
    assert objects([square(0, 0, 40), square(45, 0, 40)], 80.0) == [[0, 1]]  # four times as fine a picture
    assert objects([square(0, 0, 40), square(40, 39, 40)], 20.0) == [[0], [1]]  # corner to corner


def test_near_outlines_of_one_compound_are_one_object_and_far_ones_their_own() -> None:
    pieces = [square(x, 0, 40, of="a") for x in (0, 300, 55, 110)]
    assert objects(pieces, 20.0) == [[0, 2, 3], [1]]
    assert objects([replace(piece, compound="") for piece in pieces], 20.0) == [[0], [1], [2], [3]]
    assert objects([replace(piece, compound=name) for piece, name in zip(pieces, "abab", strict=True)], 20.0) == [
        [0, 2], [1], [3]
    ]  # fmt: skip
    assert objects([square(0, 0, 200, of="a"), square(80, 80, 40, of="a")], 20.0) == [[0, 1]]


def test_a_hole_in_the_middle_of_a_large_shape_belongs_to_it() -> None:
    shapes = [square(0, 0, 400), square(180, 180, 20, hole=True), square(900, 0, 10, hole=True)]
    assert objects(shapes, 20.0) == [[0, 1], [2]]


def test_one_shape_is_one_object() -> None:
    assert objects([square(0, 0, 10)], 20.0) == [[0]]
    assert objects([], 20.0) == []


def test_links_say_what_belongs_together_whatever_the_outlines_do() -> None:
    shapes = [square(0, 0, 40, link="a"), square(20, 0, 40), square(500, 0, 40, link="a"), square(30, 0, 40, link="b")]
    assert objects(shapes, 20.0) == [[0, 2], [1], [3]]


def test_shapes_belong_together_where_the_artist_first_keyed_both() -> None:
    a = square(0, 0, 40).with_key(Keyframe(5, box(200, 0, 40, 40)))
    b = square(200, 0, 40, frame=5)
    assert objects([a, b], 20.0) == [[0, 1]]
    assert objects([a, b.with_key(Keyframe(1, box(200, 0, 40, 40)))], 20.0) == [[0], [1]]


def test_what_subtracts_belongs_to_all_that_it_may_come_to_cut() -> None:
    post = square(300, 0, 10, hole=True)
    assert objects([square(0, 0, 40), post], 20.0) == [[0], [1]]
    passing = post.with_key(Keyframe(9, box(-50, 0, 10, 10)))
    assert objects([square(0, 0, 40), passing], 20.0) == [[0, 1]]
    led = edit.set_engine_keys(post, [Keyframe(9, box(-50, 0, 10, 10), origin=Origin.ENGINE)])
    assert objects([square(0, 0, 40), led], 20.0) == [[0], [1]]


def test_what_only_an_occluder_holds_together_is_apart_behind_it() -> None:
    shapes = [square(0, 0, 40), square(200, 0, 40), square(30, 10, 190, hole=True)]
    assert objects(shapes, 20.0) == [[0, 1, 2]]
    assert units(shapes, 20.0) == [whole(0), whole(1), occluder(2)]
    assert units([*shapes, square(215, 0, 40)], 20.0) == [whole(0), part(1), occluder(2), part(3)]


def test_no_key_of_the_engines_changes_what_belongs_together() -> None:
    a, b = square(0, 0, 40), square(100, 0, 40, frame=5)
    assert objects([a, b], 20.0) == [[0], [1]]
    led = edit.set_engine_keys(a, [Keyframe(k, box(25.0 * k, 0, 40, 40), origin=Origin.ENGINE) for k in range(2, 7)])
    assert objects([led, b], 20.0) == [[0], [1]]


def test_near_goes_with_the_size_of_the_pictures() -> None:
    assert near(None) == near((480, 854)) == OBJECTS.near
    assert near((960, 1708)) == pytest.approx(2.0 * OBJECTS.near)


@pytest.mark.parametrize(
    ("shapes", "expected"),
    [
        ([square(0, 0, 40)], [whole(0)]),
        ([square(0, 0, 40), square(20, 0, 40)], [part(0), part(1)]),
        ([square(0, 0, 40), square(55, 0, 40)], [whole(0), whole(1)]),
        ([square(0, 0, 40, of="a"), square(55, 0, 40, of="a")], [whole(0, 1)]),
        ([square(0, 0, 40, of="a"), square(55, 0, 40, of="b")], [whole(0), whole(1)]),
        ([square(0, 0, 40, of="a"), square(20, 0, 40, of="a")], [whole(0, 1)]),
        ([square(0, 0, 40), square(40, 0, 40)], [part(0), part(1)]),
        ([square(0, 0, 40, of="a"), square(40, 0, 40, of="a")], [whole(0, 1)]),
        ([square(0, 0, 40), square(20, 0, 40), square(70, 0, 40)], [part(0), part(1), whole(2)]),
        ([square(0, 0, 40, of="a"), square(20, 0, 40), square(70, 0, 40, of="a")], [part(0), part(1), whole(2)]),
        ([square(0, 0, 40, of="a"), square(30, 0, 9), square(55, 0, 40, of="a")], [whole(0, 2), part(1)]),
        ([square(0, 0, 40, of="a"), square(10, 10, 9, hole=True, of="a"), square(55, 0, 9)], [whole(0, 1), whole(2)]),
        ([square(0, 0, 40), square(10, 10, 20)], [whole(0), part(1)]),
        ([square(0, 0, 40), square(10, 10, 20, hole=True)], [whole(0, 1)]),
        ([square(0, 0, 40), square(30, 10, 20, hole=True)], [whole(0), occluder(1)]),
        ([square(0, 0, 40), square(60, 0, 20, hole=True)], [whole(0), occluder(1)]),
        ([square(0, 0, 40), square(20, 0, 40), square(2, 2, 10, hole=True)], [part(0, 2), part(1)]),
        ([square(0, 0, 40), square(20, 0, 40), square(50, 0, 40, hole=True)], [part(0), part(1), occluder(2)]),
        ([square(0, 0, 90), square(20, 20, 40, hole=True), square(30, 30, 10)], [whole(0, 1), whole(2)]),
        (
            [square(0, 0, 90, of="a"), square(20, 20, 40, hole=True, of="a"), square(30, 30, 10, of="a")],
            [whole(0, 1, 2)],
        ),
        ([square(0, 0, 90), square(20, 20, 40, hole=True), square(10, 30, 20)], [whole(0, 1), part(2)]),
        ([square(0, 0, 9, hole=True), square(2, 2, 9, hole=True)], [whole(0, 1)]),
        ([square(0, 0, 40, link="a"), square(20, 0, 40, link="a")], [whole(0, 1)]),
        ([square(0, 0, 40, link="a"), square(30, 0, 40, hole=True, link="a")], [whole(0, 1)]),
    ],
    ids=[
        "one", "overlap", "near", "pieces", "pieces of two", "pieces that overlap", "abutting", "pieces that abut",
        "two overlap, the third is near", "far pieces, one overlapped", "pieces, one overlapped", "hole, another near",
        "inside another", "hole", "crossing", "subtracts beside", "hole in a part", "crosses a part",
        "in a hole", "island of one mask", "reaches out of a hole", "only holes", "linked", "linked and crossing",
    ],
)  # fmt: skip
def test_what_the_shapes_of_an_object_are(shapes: list[RotoShape], expected: list[Unit]) -> None:
    assert units(shapes, 20.0) == expected


def test_outlines_that_were_fitted_to_one_mask_touch_and_do_not_overlap() -> None:
    large = square(0, 0, 160, of="a")
    for beside in (square(159.4, 40, 12, of="a"), square(157.0, 40, 12, of="a")):
        assert units([large, beside], 20.0) == [whole(0, 1)]
        assert units([large, replace(beside, compound="b")], 20.0) == [part(0), part(1)]


def test_what_is_drawn_on_a_shape_and_before_it_is_a_part_and_leaves_that_whole() -> None:
    car, window, badge = square(0, 0, 200), square(50, 50, 40), square(120, 60, 20)
    assert units([car, window, badge], 20.0) == [whole(0), part(1), part(2)]
    assert units([window, car], 20.0) == [part(0), part(1)]  # it lies behind
    assert units([car, window, square(190, 0, 40)], 20.0) == [part(0), part(1), part(2)]


def test_what_subtracts_cuts_a_hole_where_there_is_something_to_cut() -> None:
    hole = square(10, 10, 10, hole=True)
    assert cuts([square(0, 0, 40), hole]) == [False, True]
    assert cuts([hole, hole]) == [False, False]


def test_a_hole_belongs_to_the_nearest_shape_below_it() -> None:
    hole = square(22, 10, 10, hole=True)
    assert units([square(0, 0, 40), square(20, 0, 40), hole], 20.0) == [part(0), part(1, 2)]
    assert units([square(0, 0, 40), hole, square(20, 0, 40)], 20.0) == [part(0, 1), part(2)]
    assert units([hole, square(0, 0, 40), square(20, 0, 40)], 20.0) == [part(1, 0), part(2)]


def test_shapes_without_an_area_belong_somewhere_all_the_same() -> None:
    flat = RotoShape("f", "F", (Keyframe(1, box(5, 5, 30, 0)),))
    dot = RotoShape("d", "D", (Keyframe(1, box(5, 5, 0, 0)),))
    shapes = [square(0, 0, 40), flat, dot, replace(dot, blend=BlendMode.SUBTRACT)]
    assert objects(shapes, 20.0) == [[0, 1, 2, 3]]
    found = units(shapes, 20.0)
    assert sorted(k for unit in found for k in unit.members) == [0, 1, 2, 3]


@pytest.mark.parametrize(("width", "height"), [(0, 0), (20, 0), (0, 20)])
def test_a_hole_drawn_in_to_a_point_or_a_line_belongs_to_the_shape_around_it(width: float, height: float) -> None:
    left, right = square(0, 0, 40), square(38, 0, 40)
    drawn_in = RotoShape("h", "H", (Keyframe(1, box(5, 10, width, height)),), blend=BlendMode.SUBTRACT)
    assert units([left, right, drawn_in], 20.0) == [part(0, 2), part(1)]
    across = RotoShape("h", "H", (Keyframe(1, box(30, 10, 20, 0)),), blend=BlendMode.SUBTRACT)
    assert units([left, right, across], 20.0) == [part(0), part(1), occluder(2)]


def test_depth_comes_before_the_stack() -> None:
    shapes = [square(k, 0, 40) for k in range(3)]
    assert stacked(shapes, 1) == [0, 1, 2]
    front = replace(shapes[0], depth=((10, 1), (20, 0)))
    behind = replace(shapes[2], depth=((15, -1),))
    shapes = [front, shapes[1], behind]
    assert [stacked(shapes, frame) for frame in (9, 10, 15, 19, 20)] == [
        [0, 1, 2], [1, 2, 0], [2, 1, 0], [2, 1, 0], [2, 0, 1]
    ]  # fmt: skip


@pytest.mark.parametrize("seed", range(4))
def test_many_shapes_are_grouped_as_their_pairs_are(seed: int) -> None:
    """What boxes alone say of all pairs at once is what each pair says by itself."""
    draw = np.random.default_rng(seed)
    shapes = [
        square(
            *draw.uniform(0, 300, 2), draw.uniform(10, 60), hole=draw.random() < 0.2, frame=int(draw.integers(1, 3)),
            link=draw.choice(["", "", "", "", "figure"]), of=draw.choice(["", "", "mask"]),
        )
        for _ in range(25)
    ]  # fmt: skip
    place = list(range(len(shapes)))
    for i, j in combinations(range(len(shapes)), 2):
        if len(objects([shapes[i], shapes[j]], 20.0)) == 1:
            place = [place[i] if each == place[j] else each for each in place]
    wanted = sorted([k for k, each in enumerate(place) if each == one] for one in set(place))
    assert objects(shapes, 20.0) == wanted


def test_of_shapes_that_never_come_near_each_other_no_outline_is_asked(monkeypatch: pytest.MonkeyPatch) -> None:
    """Hundreds of shapes in a long shot are drawn on frames of their own: each pair of them was flattened anew."""
    shapes = [
        square(100 * k, 0, 40, frame=1 + k).with_key(Keyframe(1000 + k, box(100 * k + 5, 0, 40, 40))) for k in range(9)
    ]
    shapes[8] = shapes[8].with_key(Keyframe(500, box(0, 0, 40, 40)))
    asked = list[tuple[str, str]]()
    belong = module._belong
    monkeypatch.setattr(module, "_belong", lambda a, b, gap: asked.append((a.id, b.id)) or belong(a, b, gap))
    assert objects(shapes, 20.0) == [[k] for k in range(9)]
    assert asked == [(shape.id, shapes[8].id) for shape in shapes[:8]]


def test_an_edit_measures_no_pair_again_that_it_left_alone(monkeypatch: pytest.MonkeyPatch) -> None:
    """Of hundreds of shapes that overlap, every pair was measured anew with each edit of one of them."""
    shapes = [square(30 * k, 0, 40) for k in range(9)]
    measured = list[object]()
    cover = coverage.coverage
    monkeypatch.setattr(coverage, "coverage", lambda *given: measured.append(given) or cover(*given))
    assert objects(shapes, 20.0) == [list(range(9))]
    assert len(measured) == 2 * 8  # both of each two that overlap
    measured.clear()
    moved = [*shapes[:8], edit.set_key(shapes[8], 1, box(241, 0, 40, 40))]
    assert objects(moved, 20.0) == [list(range(9))]
    assert len(measured) == 2


def test_pairs_that_abut_or_are_near_are_measured_once(monkeypatch: pytest.MonkeyPatch) -> None:
    shapes = [square(40 * k, 0, 40, of=name) for k, name in enumerate(("", "", "a"))]
    shapes.append(square(130, 0, 40, of="a"))
    planted = list[object]()
    tree = module._tree
    monkeypatch.setattr(module, "_tree", lambda places: planted.append(places) or tree(places))
    assert objects(shapes, 20.0) == [[0, 1, 2, 3]]
    assert planted
    planted.clear()
    assert objects([*shapes, square(900, 0, 40)], 20.0) == [[0, 1, 2, 3], [4]]
    assert not planted
