"""Kinds of edge: what is free, a seam or hidden along an outline, on pictures of which that is known."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array, Bools
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.media.source import MissingFrame
from roam_core.params import EdgesParams
from roam_core.propagate.parts.edges import Edge, Edges, edges, edges_on_key
from roam_core.roto import Keyframe, Origin, RotoShape
from roam_core.roto.linking import BEHIND
from tests.unit.propagate.figures import Figure, body_with_arms, subtracting

Box = tuple[float, float, float, float]
SIZE = 120, 160
BODY, ARM = (40.0, 30.0, 90.0, 100.0), (70.0, 50.0, 130.0, 64.0)
GREY, DARK, LIGHT = 110, 20, 230


def shape(name: str, box: Box, frame: int = 1) -> RotoShape:
    left, top, right, bottom = box
    corners = [(left, top), (right, top), (right, bottom), (left, bottom)]
    return RotoShape(name, name, (Keyframe(frame, bezier.polygon_points(corners)),))


def picture(*boxes: tuple[Box, int], size: tuple[int, int] = SIZE) -> PreparedFrame:
    """Boxes of one grey each, bottom first, on a dark background."""
    image = np.full((*size, 3), DARK, dtype=np.uint8)
    for (left, top, right, bottom), level in boxes:
        image[int(top) : int(bottom), int(left) : int(right)] = level
    return PreparedFrame(image)


def within(places: Array, box: Box, margin: float) -> Bools:
    """Which places lie inside a box, deeper than `margin`; farther out where that is negative."""
    left, top, right, bottom = box
    inside = (places >= (left + margin, top + margin)) & (places <= (right - margin, bottom - margin))
    return np.asarray(inside.all(axis=1))


def kinds_in(found: Edges, box: Box, margin: float) -> set[Edge]:
    return {Edge(kind) for kind in found.kinds[within(found.places, box, margin)].tolist()}


def kinds_off(found: Edges, box: Box, margin: float) -> set[Edge]:
    return {Edge(kind) for kind in found.kinds[~within(found.places, box, -margin)].tolist()}


@pytest.fixture(scope="module")
def parts() -> dict[str, Edges]:
    """A grey body, and a light arm that lies over it."""
    return edges(picture((BODY, GREY), (ARM, LIGHT)), [shape("body", BODY), shape("arm", ARM)], 1)


def test_an_outline_is_hidden_under_a_nearer_part_and_free_elsewhere(parts: dict[str, Edges]) -> None:
    assert kinds_in(parts["body"], ARM, 1.5) == {Edge.HIDDEN}
    assert kinds_off(parts["body"], ARM, 6.0) == {Edge.FREE}


def test_an_outline_over_a_farther_part_is_a_seam(parts: dict[str, Edges]) -> None:
    assert kinds_in(parts["arm"], BODY, 4.0) == {Edge.SEAM}
    assert kinds_off(parts["arm"], BODY, 4.0) == {Edge.FREE}


def test_samples_lie_along_the_outline_and_stand_for_all_of_it(parts: dict[str, Edges]) -> None:
    body, drawn = parts["body"], shape("body", BODY).at(1).points
    npt.assert_allclose(body.places, bezier.evaluate(drawn, body.segment, body.t))
    assert body.lengths.sum() == pytest.approx(2 * (50 + 70))
    assert body.lengths.max() <= 1.5 * EdgesParams().step  # the middle of a straight side runs faster than its ends
    assert set(body.segment[body.t == 0.0].tolist()) == {0, 1, 2, 3}
    assert sum(body.shares.values()) == pytest.approx(1.0)
    assert body.share(Edge.HIDDEN) == pytest.approx(14 / 240, abs=0.03)


def test_where_the_picture_does_not_change_an_edge_is_a_seam() -> None:
    half = (0.0, 0.0, 90.0, 120.0)
    (found,) = edges(picture((half, GREY)), [shape("body", BODY)], 1).values()
    right = np.abs(found.places[:, 0] - BODY[2]) < 0.5
    middle = right & (np.abs(found.places[:, 1] - 65.0) < 25.0)
    assert set(found.kinds[middle].tolist()) == {Edge.FREE}
    assert set(found.kinds[~right].tolist()) == {Edge.SEAM}
    assert found.contrast[middle].min() > 0.9
    assert np.median(found.contrast[~right]) < 0.1


def test_depth_on_a_frame_says_what_hides_what() -> None:
    arm = replace(shape("arm", ARM), depth=((3, BEHIND),))
    shapes, drawn = [shape("body", BODY), arm], picture((ARM, LIGHT), (BODY, GREY))
    assert edges(drawn, shapes, 2)["body"].share(Edge.HIDDEN) > 0.0
    found = edges(drawn, shapes, 3)
    assert found["body"].share(Edge.HIDDEN) == 0.0
    assert kinds_in(found["arm"], BODY, 1.5) == {Edge.HIDDEN}


def test_an_occluder_hides_and_belongs_to_nothing() -> None:
    post = (60.0, 0.0, 72.0, 120.0)
    found = edges(picture((BODY, GREY), (post, LIGHT)), [shape("body", BODY), subtracting(shape("post", post))], 1)
    assert kinds_in(found["body"], (*post[:1], 1.0, post[2], 119.0), 0.5) == {Edge.HIDDEN}
    assert kinds_off(found["body"], post, 5.0) == {Edge.FREE}
    inner = within(found["post"].places, BODY, 6.0)
    assert set(found["post"].kinds[inner].tolist()) == {Edge.FREE}


def test_the_object_lies_around_a_hole() -> None:
    hole = (55.0, 50.0, 75.0, 80.0)
    shapes = [shape("body", BODY), subtracting(shape("hole", hole))]
    found = edges(picture((BODY, GREY), (hole, LIGHT)), shapes, 1)
    assert {name: each.share(Edge.FREE) for name, each in found.items()} == {"body": 1.0, "hole": 1.0}
    through = [shape("behind", (50.0, 40.0, 110.0, 90.0)), *shapes]
    assert edges(picture((BODY, GREY), (hole, LIGHT)), through, 1)["hole"].share(Edge.SEAM) == 1.0


def test_outside_the_picture_nothing_is_known() -> None:
    box = (-40.0, 30.0, 60.0, 90.0)
    (found,) = edges(picture(((0.0, *box[1:]), GREY)), [shape("body", box)], 1).values()
    outside = found.places[:, 0] < -1.0
    assert set(found.kinds[outside].tolist()) == {Edge.UNKNOWN}
    assert np.isnan(found.contrast[outside]).all()
    assert set(found.kinds[found.places[:, 0] > 5.0].tolist()) == {Edge.FREE}
    (away,) = edges(picture(), [shape("body", (-90.0, -90.0, -50.0, -50.0))], 1).values()
    assert away.share(Edge.UNKNOWN) == 1.0


def test_a_part_of_three_pixels_has_edges_too() -> None:
    thin = (40.0, 50.0, 120.0, 53.0)
    (found,) = edges(picture((thin, LIGHT)), [shape("thin", thin)], 1).values()
    along = np.abs(found.places[:, 0] - 80.0) < 30.0
    assert set(found.kinds[along].tolist()) == {Edge.FREE}


def test_only_closed_shapes_that_are_there_and_were_asked_for() -> None:
    shapes = [shape("body", BODY), shape("arm", ARM), replace(shape("line", ARM), closed=False)]
    drawn = picture((BODY, GREY), (ARM, LIGHT))
    assert set(edges(drawn, shapes, 1)) == {"body", "arm"}
    assert set(edges(drawn, shapes, 1, only={"body"})) == {"body"}
    gone = [shapes[0], replace(shapes[1], lifetime=(5, 9))]
    assert edges(drawn, gone, 1)["body"].share(Edge.HIDDEN) == 0.0
    assert set(edges(drawn, gone, 1)) == {"body"}


def test_on_the_key_the_same_samples_are_measured_again() -> None:
    """The body stands before its own grey on frame 1 and is free on frame 4."""
    tracked = Keyframe(4, shape("body", BODY).keys[0].points, origin=Origin.ENGINE, inputs="forward:best:0")
    shapes = [shape("body", BODY).with_key(tracked)]
    read = {1: picture(((0.0, 0.0, 160.0, 120.0), GREY)), 4: picture((BODY, GREY))}.__getitem__
    now = edges(read(4), shapes, 4)
    ((frame, before),) = edges_on_key(read, shapes, 4, now).values()
    assert frame == 1
    npt.assert_array_equal(before.t, now["body"].t)
    assert (now["body"].share(Edge.FREE), before.share(Edge.SEAM)) == (1.0, 1.0)
    assert edges_on_key(read, shapes, 1, edges(read(1), shapes, 1))["body"][0] == 1


def test_a_key_without_a_picture_takes_nothing_from_the_others() -> None:
    """The body goes back to frame 1, of which there is no picture; the arm to frame 2."""
    drawn = {2: picture((ARM, LIGHT)), 4: picture((BODY, GREY), (ARM, LIGHT))}

    def read(frame: int) -> PreparedFrame:
        if frame not in drawn:
            raise MissingFrame("gone")
        return drawn[frame]

    def tracked(name: str, box: Box, key: int) -> RotoShape:
        points = shape(name, box).keys[0].points
        keys = Keyframe(key, points), Keyframe(4, points, origin=Origin.ENGINE, inputs="forward:best:0")
        return replace(shape(name, box), keys=keys)

    shapes = [tracked("body", BODY, 1), tracked("arm", ARM, 2)]
    found = edges_on_key(read, shapes, 4, edges(read(4), shapes, 4))
    assert {name: frame for name, (frame, _) in found.items()} == {"arm": 2}


@pytest.fixture(scope="module")
def figure() -> Figure:
    return body_with_arms()


def test_on_a_textured_figure_what_lies_over_the_body_is_no_free_edge(figure: Figure) -> None:
    found = edges(PreparedFrame(figure.read(0)), figure.shapes(), 0)
    for part in found.values():
        assert part.share(Edge.FREE) > 0.5
    assert found["body"].share(Edge.HIDDEN) > 0.1
    assert found["head"].share(Edge.SEAM) > 0.3
    assert found["arm"].share(Edge.HIDDEN) < 0.01
