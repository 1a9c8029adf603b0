"""Holes: what shows the background is carried with its object's region, what is cut out of the object by itself."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core import fill_span, render_matte, track
from roam_core.features import PreparedFrame
from roam_core.params import params_for
from roam_core.propagate.frame.result import Part
from roam_core.propagate.parts.holes import set_apart
from roam_core.propagate.shapes.objects import Role, Unit
from roam_core.roto import BlendMode, RotoShape
from tests.unit.propagate.figures import SIZE, Figure, arm_like_its_body, box, subtracting

WHOLE = Unit(Role.WHOLE, (0, 1))


def body_with_its_arm_cut_out(figure: Figure, *frames: int) -> list[RotoShape]:
    body, arm = figure.shapes(*frames)
    return [body, subtracting(arm)]


def overlap_of_hole(figure: Figure, found: RotoShape, frame: int) -> float:
    solid = replace(found, blend=BlendMode.ADD)
    ours = render_matte([solid], frame, SIZE) > 0.5
    true = render_matte([figure.shapes(*figure.frames)[1]], frame, SIZE) > 0.5
    return float((ours & true).sum() / (ours | true).sum())


@pytest.mark.parametrize("is_seen_through", [False, True])
def test_a_hole_is_set_apart_where_the_object_itself_is_seen_in_it(is_seen_through: bool) -> None:
    params = params_for("best").region
    assert params is not None
    figure = arm_like_its_body(2)
    body, hole = (shape.at(0).points for shape in figure.shapes())
    image = figure.pictures[0].copy()
    if is_seen_through:
        there = render_matte([figure.shapes()[1]], 0, SIZE) > 0.5
        around = render_matte([figure.shapes()[0]], 0, SIZE) <= 0.0
        image[there] = image[around][: int(there.sum())]
    units = set_apart([WHOLE], PreparedFrame(image), [Part(body, False), Part(hole, True)], params)
    assert units == ((WHOLE,) if is_seen_through else (Unit(Role.WHOLE, (0,)), Unit(Role.OCCLUDER, (1,))))


def test_a_hole_too_small_to_be_known_stays_one() -> None:
    params = params_for("best").region
    assert params is not None
    figure = arm_like_its_body(2)
    body = figure.shapes()[0].at(0).points
    speck = box(2, 2) + np.array([88.0, 60.0])
    parts = [Part(body, False), Part(speck, True)]
    assert set_apart([WHOLE], PreparedFrame(figure.pictures[0]), parts, params) == (WHOLE,)


def test_what_is_cut_out_of_an_object_goes_by_itself() -> None:
    figure = arm_like_its_body()
    *_, last = track(figure.read, body_with_its_arm_cut_out(figure), figure.frames, "best")
    body, hole = (result.shape for result in last.results)
    assert overlap_of_hole(figure, hole, last.frame) > 0.9
    alone = render_matte([body], last.frame, SIZE) > 0.5
    true = render_matte([figure.shapes(*figure.frames)[0]], last.frame, SIZE) > 0.5
    assert (alone & true).sum() / (alone | true).sum() > 0.95


def test_between_two_keys_it_does_too() -> None:
    figure = arm_like_its_body()
    first, last = figure.frames[0], figure.frames[-1]
    shapes = body_with_its_arm_cut_out(figure, first, last)
    _, hole = fill_span(dict(enumerate(figure.pictures)), shapes, first, last, "best")
    for frame in range(first + 1, last):
        assert overlap_of_hole(figure, hole, frame) > 0.9
