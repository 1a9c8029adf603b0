"""Objects in parts: what comes out does not depend on what was asked for, nor on where a run was stopped."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

import numpy as np
import pytest

from roam_core import RoamError, fill_span, track
from roam_core.features import PreparedFrame
from roam_core.params import OBJECTS
from roam_core.propagate import TrackMemory
from roam_core.propagate.engines.protocol import POSE, REGION
from roam_core.propagate.explain import explain
from roam_core.propagate.frame.result import FrameResult, Termination
from roam_core.propagate.shapes.objects import Role, near, objects, units
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.roto import Keyframe, Origin, RotoShape, edit
from tests.golden.shots import outline_distance, texture
from tests.unit.propagate.figures import (
    BODY,
    ODD,
    SIZE,
    Figure,
    Moving,
    arm_like_its_body,
    body_behind_a_post,
    body_with_arms,
    box,
    keys_of,
    many_parts,
    subtracting,
    turning_head_behind_a_post,
    two_shins,
)

LAST = 7


@pytest.fixture(scope="module")
def figure() -> Figure:
    return body_with_arms()


def tracked(
    figure: Figure,
    shapes: Sequence[RotoShape],
    frames: range | None = None,
    only: Collection[str] | None = None,
    memory: TrackMemory | None = None,
    config: str = "best",
    alone: bool = False,
) -> list[RotoShape]:
    """All shapes, those that were asked for with the keys of a run."""
    found = {shape.id: shape for shape in shapes}

    def take(result: FrameResult) -> None:
        found.update({each.shape.id: each.shape for each in result.results})

    for result in track(
        figure.read, shapes, frames or figure.frames, config, memory=memory, begun=take, only=only, alone=alone
    ):
        take(result)
    return list(found.values())


def stale_frames(shapes: Sequence[RotoShape], index: int) -> list[int]:
    stamps = Stamps(shapes, "", SIZE)
    return [key.frame for key in shapes[index].keys if stamps.is_stale(shapes[index], key)]


def same(ours: Sequence[RotoShape], theirs: Sequence[RotoShape]) -> bool:
    return [keys_of(shape) for shape in ours] == [keys_of(shape) for shape in theirs]


@pytest.fixture(scope="module")
def whole(figure: Figure) -> list[RotoShape]:
    """The whole figure in one run."""
    return tracked(figure, figure.shapes())


def test_the_figure_is_one_object_in_parts(figure: Figure) -> None:
    assert objects(figure.shapes(), 20.0 * 120 / 480) == [[0, 1, 2]]
    assert [unit.role for unit in units(figure.shapes(), OBJECTS.near)] == [Role.PART] * 3


def test_each_part_is_found_with_its_own_motion(figure: Figure, whole: list[RotoShape]) -> None:
    for part, shape in zip(figure.parts, whole, strict=True):
        assert shape.frames == tuple(figure.frames)
        for k in figure.frames:
            assert outline_distance(shape.at(k).points, part.truth(k)) < 1.5
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]


@pytest.mark.parametrize("order", [("body", "arm", "head"), ("head", "body", "arm")])
def test_one_by_one_is_as_in_one_run(figure: Figure, whole: list[RotoShape], order: Sequence[str]) -> None:
    shapes = figure.shapes()
    for name in order:
        shapes = tracked(figure, shapes, only=[name])
    assert same(shapes, whole)


STOPS = [
    [(("body", "arm", "head"), range(4)), (("body", "arm", "head"), range(3, 8))],
    [(("arm",), range(3)), (("body", "head"), range(6)), (("arm",), range(2, 8)), (("head", "body"), range(5, 8))],
    [(("head",), range(8)), (("arm", "body"), range(5)), (("arm",), range(4, 8)), (("body",), range(4, 8))],
]


@pytest.mark.parametrize("remembering", [True, False], ids=["remembering", "solving again"])
@pytest.mark.parametrize("runs", STOPS, ids=["together", "arm first", "head first"])
def test_stops_change_nothing(
    figure: Figure, whole: list[RotoShape], runs: list[tuple[tuple[str, ...], range]], remembering: bool
) -> None:
    shapes, memory = figure.shapes(), TrackMemory() if remembering else None
    for names, frames in runs:
        shapes = tracked(figure, shapes, frames, names, memory)
    assert same(shapes, whole)


def test_backward_is_independent_of_stops_too(figure: Figure) -> None:
    shapes, frames = figure.shapes(LAST), figure.frames[::-1]
    whole = tracked(figure, shapes, frames)
    stopped = tracked(figure, tracked(figure, shapes, frames[:5], ["arm"]), frames[4:], ["arm"])
    for name in ("head", "body"):
        stopped = tracked(figure, stopped, frames, [name])
    assert same(stopped, whole)
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]


@pytest.mark.parametrize("names", [("body",), ("arm", "head")])
def test_a_key_of_one_part_on_the_way_is_taken_over_by_any_run(figure: Figure, names: tuple[str, ...]) -> None:
    """The artist gave the arm anew on a frame: the others go on, with what they were, and a stop there is no stop."""
    shapes = figure.shapes()
    shapes[1] = edit.set_key(shapes[1], 4, figure.parts[1].truth(4) + 0.5)
    whole = tracked(figure, shapes)
    assert whole[1].artist_frames == (0, 4)
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]
    for stop in (3, 4, 5):
        part = tracked(figure, shapes, range(stop + 1), names)
        part = tracked(figure, part, range(stop, 8), names)
        rest = tracked(figure, part, only={"body", "arm", "head"} - set(names))
        assert same(rest, whole)


def test_an_edit_of_a_neighbour_makes_stale_what_it_led_to(figure: Figure, whole: list[RotoShape]) -> None:
    moved = edit.set_key(whole[2], 0, whole[2].at(0).points + 1.0)
    shapes = [*whole[:2], moved]
    assert stale_frames(shapes, 0) == stale_frames(shapes, 1) == list(range(1, 8))
    keyed = [*whole[:2], edit.set_key(whole[2], 5, whole[2].at(5).points + 1.0)]
    assert stale_frames(keyed, 0) == stale_frames(keyed, 1) == [5, 6, 7]
    again = tracked(figure, keyed, range(4, 8))
    assert [stale_frames(again, k) for k in range(3)] == [[], [], []]
    fresh = figure.shapes()
    fresh[2] = edit.set_key(fresh[2], 5, whole[2].at(5).points + 1.0)
    assert same(again, tracked(figure, fresh))


@pytest.mark.parametrize("names", [("body", "arm", "head"), ("body",)], ids=["all", "another"])
def test_a_run_from_a_correction_solves_anew_what_it_made_stale_there(
    figure: Figure, whole: list[RotoShape], names: tuple[str, ...]
) -> None:
    """The other parts do not begin with what they were on that frame: they are as in one run past the correction."""
    corrected = [*whole[:2], edit.set_key(whole[2], 4, whole[2].at(4).points + 1.0)]
    fresh = figure.shapes()
    fresh[2] = edit.set_key(fresh[2], 4, whole[2].at(4).points + 1.0)
    expected = tracked(figure, fresh)
    on = tracked(figure, corrected, range(4, 8), names)
    for k, shape in enumerate(on):
        is_asked = shape.id in names
        assert stale_frames(on, k) == ([] if is_asked else list(range(4 if k < 2 else 5, 8)))
        assert same([shape], [expected[k]]) == is_asked


def at_depth(shape: RotoShape, *pairs: tuple[int, int]) -> RotoShape:
    return replace(shape, depth=pairs)


@pytest.mark.parametrize(("first", "stale"), [(0, [4, 5, 6, 7]), (LAST, [0, 1, 2, 3])], ids=["forward", "backward"])
def test_a_change_of_depth_makes_stale_what_comes_after_it(figure: Figure, first: int, stale: list[int]) -> None:
    """The arm lies behind from frame 4 on; a run backward meets that when it goes on to frame 3."""
    frames, shapes = figure.frames[:: 1 if first == 0 else -1], figure.shapes(first)
    behind = [((4, -1),), ((0, -1), (4, 0))][first == LAST]
    whole = tracked(figure, shapes, frames)
    restacked = [whole[0], at_depth(whole[1], *behind), whole[2]]
    assert [stale_frames(restacked, k) for k in range(3)] == [stale] * 3
    again = tracked(figure, restacked, range(3, 8) if first == 0 else range(4, -1, -1))
    assert [stale_frames(again, k) for k in range(3)] == [[], [], []]
    fresh = tracked(figure, [shapes[0], at_depth(shapes[1], *behind), shapes[2]], frames)
    assert same(again, fresh)


def test_alone_is_as_if_there_were_no_others(figure: Figure) -> None:
    shapes = figure.shapes()
    found = tracked(figure, shapes, only=["arm"], alone=True)
    (lone,) = tracked(figure, [shapes[1]])
    assert [key.points.tobytes() for key in found[1].keys] == [key.points.tobytes() for key in lone.keys]
    assert [shape.frames for shape in (found[0], found[2])] == [(0,), (0,)]
    assert all(Stamp.read(key.inputs).alone for key in found[1].keys[1:])
    assert stale_frames([replace(shapes[0], link="x"), found[1]], 1) == []
    stopped = tracked(figure, tracked(figure, shapes, range(4), ["arm"], alone=True), range(3, 8), ["arm"], alone=True)
    assert same(stopped, found)
    together = tracked(figure, found, only=["arm"])
    assert keys_of(together[1]) == keys_of(tracked(figure, shapes, only=["arm"])[1])


# ---- shapes that the artist draws later


@pytest.fixture(scope="module")
def late(figure: Figure) -> list[RotoShape]:
    """The head is drawn on frame 3 only."""
    body, arm, _ = figure.shapes()
    return [body, arm, figure.shapes(3)[2]]


def test_a_shape_that_comes_later_is_fresh_and_leaves_the_run_before_as_it_was(
    figure: Figure, late: list[RotoShape]
) -> None:
    whole = tracked(figure, late)
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]
    assert same(whole[:2], tracked(figure, late[:2]))


@pytest.mark.parametrize("stop", [2, 3, 5])
def test_a_run_with_a_shape_that_comes_later_may_be_stopped_anywhere(
    figure: Figure, late: list[RotoShape], stop: int
) -> None:
    whole = tracked(figure, late)
    stopped = tracked(figure, tracked(figure, late, range(stop + 1)), range(stop, 8))
    assert same(stopped, whole)
    part = tracked(figure, tracked(figure, late, range(stop + 1), ["arm"]), range(stop, 8), ["arm"])
    assert keys_of(part[1]) == keys_of(whole[1])


def test_where_all_are_given_anew_those_that_came_meanwhile_take_part(figure: Figure, late: list[RotoShape]) -> None:
    shapes = [edit.set_key(shape, 5, part.truth(5)) for shape, part in zip(late, figure.parts, strict=True)]
    whole = tracked(figure, shapes)
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]
    assert {Stamp.read(whole[k].keys[-1].inputs).begun for k in range(3)} == {5}
    from_there = tracked(figure, shapes, range(5, 8))
    assert [keys_of(shape)[-2:] for shape in whole] == [keys_of(shape)[-2:] for shape in from_there]


def test_a_run_that_begins_between_keys_is_fresh_and_may_be_stopped(figure: Figure) -> None:
    shapes = figure.shapes(0, LAST)
    whole = tracked(figure, shapes, range(2, 7))
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]
    assert same(tracked(figure, tracked(figure, shapes, range(2, 5)), range(4, 7)), whole)


# ---- filling


def test_filling_one_by_one_is_as_all_at_once(figure: Figure) -> None:
    images = dict(enumerate(figure.pictures))
    shapes = figure.shapes(0, 5)
    whole = fill_span(images, shapes, 0, 5)
    some = list(shapes)
    for name in ("arm", "body", "head"):
        some = fill_span(images, some, 0, 5, only=[name])
    assert same(some, whole)
    assert [stale_frames(whole, k) for k in range(3)] == [[], [], []]
    for part, shape in zip(figure.parts, whole, strict=True):
        assert max(outline_distance(shape.at(k).points, part.truth(k)) for k in range(6)) < 1.5
    moved = [whole[0], edit.set_key(whole[1], 5, whole[1].at(5).points + 1.0), whole[2]]
    assert stale_frames(moved, 0) == stale_frames(moved, 2) == [1, 2, 3, 4]


def test_a_whole_object_is_filled_along_its_region_behind_an_occluder() -> None:
    figure = body_behind_a_post(9)
    body, post = figure.shapes(0, 8)
    found = fill_span(dict(enumerate(figure.pictures)), [body, subtracting(post)], 0, 8)
    for frame in range(1, 8):
        for shape, part in zip(found, figure.parts, strict=True):
            assert outline_distance(shape.at(frame).points, part.truth(frame)) < 1.5


def test_filling_alone_is_as_if_there_were_no_others(figure: Figure) -> None:
    images, shapes = dict(enumerate(figure.pictures)), figure.shapes(0, 5)
    found = fill_span(images, shapes, 0, 5, only=["arm"], alone=True)
    (lone,) = fill_span(images, [shapes[1]], 0, 5)
    assert [key.points.tobytes() for key in found[1].keys] == [key.points.tobytes() for key in lone.keys]
    assert [shape.frames for shape in (found[0], found[2])] == [(0, 5), (0, 5)]
    assert all(Stamp.read(key.inputs).alone for key in found[1].keys[1:-1])
    moved = edit.set_key(found[0], 5, found[0].at(5).points + 1.0)
    assert stale_frames([moved, found[1]], 1) == []


# ---- taking keys apart


@pytest.mark.parametrize("only", [None, {"arm"}])
def test_an_explanation_comes_to_the_same_points(
    figure: Figure, late: list[RotoShape], whole: list[RotoShape], only: set[str] | None
) -> None:
    alone = tracked(figure, figure.shapes(), range(5), alone=True)
    filled = fill_span(dict(enumerate(figure.pictures)), figure.shapes(0, 5), 0, 5)
    runs = [(whole, 1), (whole, 6), (alone, 4), (tracked(figure, late), 6), (filled, 2)]
    for shapes, frame in runs:
        told = explain(lambda k: PreparedFrame(figure.read(k)), shapes, frame, None, only=only)
        assert [each.shape.id for each in told] == [s.id for s in shapes if only is None or s.id in only]
        for each in told:
            assert each.apart < (3.0 if shapes is filled else 1e-9)
            assert all(
                len(term) == len(each.account.nodes) and np.isfinite(term).all() for term in each.account.terms.values()
            )


def test_a_whole_behind_an_occluder_is_explained_by_its_cues() -> None:
    figure = body_behind_a_post()
    body, post = figure.shapes()
    solved = tracked(figure, [body, subtracting(post)], config="best+region.pose_edged=0.05")
    told = explain(lambda k: PreparedFrame(figure.read(k)), solved, 5, None)
    assert [each.apart for each in told] == [0.0, 0.0]
    assert (REGION in told[0].account.terms, set(told[1].account.terms)) == (True, {POSE})


def test_a_frame_that_a_lone_pose_laid_is_explained_by_the_pose() -> None:
    figure = arm_like_its_body()
    *_, last = track(figure.read, [figure.shapes()[1]], figure.frames)
    (result,) = last.results
    assert "pose" in result.energies
    (told,) = explain(lambda k: PreparedFrame(figure.read(k)), [result.shape], 5, None)
    assert (set(told.account.terms), told.apart) == ({POSE}, 0.0)


def test_a_stale_key_is_not_explained(figure: Figure, whole: list[RotoShape]) -> None:
    moved = [*whole[:2], edit.set_key(whole[2], 0, whole[2].at(0).points + 1.0)]
    with pytest.raises(RoamError, match="out of date"):
        explain(lambda k: PreparedFrame(figure.read(k)), moved, 4, None, only={"arm"})


# ---- nothing breaks


def require_sound(shapes: Sequence[RotoShape], frames: range) -> None:
    for shape in shapes:
        assert set(frames) <= set(shape.frames)
        for key in shape.keys:
            assert np.isfinite(key.points).all()
            assert key.confidence is None or 0.0 <= key.confidence <= 1.0
        assert all(key.confidence is not None for key in shape.keys if key.origin is Origin.ENGINE)


@pytest.mark.parametrize(
    ("name", "below"), [(name, below) for name in ODD for below in (False, True) if below or name != "wholly behind"]
)
@pytest.mark.parametrize("attached", [True, False])
def test_odd_parts_break_nothing(name: str, below: bool, attached: bool) -> None:
    figure = Figure((ODD[name], BODY) if below else (BODY, ODD[name]), 5)
    shapes = [replace(shape, attached=attached) for shape in figure.shapes()]
    require_sound(tracked(figure, shapes), figure.frames)
    filled = fill_span(dict(enumerate(figure.pictures)), figure.shapes(0, 4), 0, 4)
    require_sound(filled, figure.frames)


def test_what_left_the_picture_says_so() -> None:
    figure = Figure((BODY, Moving("odd", box(30, 20), (110, 50), (16.0, 0.0), 0.0, texture(12, 0.6, 1.0))), 6)
    ends = [result.results[1].termination for result in track(figure.read, figure.shapes(), figure.frames)]
    assert ends[:2] == [Termination.CONVERGED] * 2
    assert ends[-1] is Termination.LEFT_FRAME


@pytest.mark.parametrize("parts", [1, 2], ids=["a whole", "in parts"])
def test_an_occluder_that_crosses_an_object_moves_by_itself(parts: int) -> None:
    post = Moving("post", box(12, 90), (70, 60), (3.0, 0.0), 0.0, texture(15, 0.3, 1.0))
    figure = Figure((*(BODY, replace(ODD["without texture"], look=texture(12, 0.6, 1.0)))[:parts], post), 6)
    shapes = [*figure.shapes()[:-1], subtracting(figure.shapes()[-1])]
    assert units(shapes, OBJECTS.near)[-1].role is Role.OCCLUDER
    found = tracked(figure, shapes)
    require_sound(found, figure.frames)
    assert outline_distance(found[-1].at(5).points, post.truth(5)) < 1.5
    assert outline_distance(found[0].at(5).points, BODY.truth(5)) < 1.5
    last = [shape.with_keys([Keyframe(5, part.truth(5))]) for shape, part in zip(shapes, figure.parts, strict=True)]
    require_sound(fill_span(dict(enumerate(figure.pictures)), last, 0, 5), figure.frames)


def test_what_an_occluder_hides_goes_on_with_what_it_hangs_on() -> None:
    """The head no longer looks as on its key, and would stay with the post that nothing speaks against.

    Behind the post the body goes on as it went before; seen again it lies where it should, and the head on it.
    """
    figure, read = turning_head_behind_a_post()
    body, head, post = figure.shapes()
    for solved in track(read, [body, head, subtracting(post)], figure.frames, "best"):
        frame = solved.frame
        found = [
            outline_distance(each.shape.at(frame).points, part.truth(frame))
            for each, part in zip(solved.results, figure.parts, strict=True)
        ]
        assert max(found) < (0.5 if not 6 < frame < 11 else 4.0), frame
        if frame >= 5:
            assert solved.results[1].confidence < 0.3


@pytest.mark.parametrize("holes", [1, 3])
def test_holes_alone_break_nothing(holes: int) -> None:
    figure = Figure((BODY, *(replace(BODY, name=f"b{k}", start=(70 + k, 60)) for k in range(holes - 1))), 3)
    require_sound(tracked(figure, [subtracting(shape) for shape in figure.shapes()]), figure.frames)


def test_a_hole_goes_with_its_part() -> None:
    hole = replace(BODY, name="hole", rest=box(10, 10))
    figure = Figure((BODY, ODD["without texture"], hole), 4)
    shapes = [*figure.shapes()[:2], subtracting(figure.shapes()[2])]
    assert units(shapes, OBJECTS.near)[0].members == (0, 2)
    found = tracked(figure, shapes)
    assert outline_distance(found[2].at(3).points, hole.truth(3)) < 1.0


def test_a_hundred_small_parts_break_nothing() -> None:
    figure = many_parts(100)
    assert max(map(len, objects(figure.shapes(), 5.0))) > 90
    require_sound(tracked(figure, figure.shapes()), figure.frames)


def test_near_limbs_that_nothing_joins_stay_themselves_when_they_cross() -> None:
    """As outlines of one compound they are carried by one region, and are drawn into each other: 39 and 15 px."""
    figure = two_shins()
    assert objects(figure.shapes(), near(SIZE)) == [[0], [1]]
    far, close = tracked(figure, figure.shapes())
    last = figure.frames[-1]
    assert outline_distance(far.at(last).points, figure.parts[0].truth(last)) < 2.0
    assert max(outline_distance(close.at(k).points, figure.parts[1].truth(k)) for k in figure.frames) < 2.0
