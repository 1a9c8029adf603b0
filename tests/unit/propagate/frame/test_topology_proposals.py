"""What the artist is offered: shapes as they would be, the old one keeping its points, and nothing done meanwhile."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import bezier, polyline
from roam_core.propagate.frame.topology_proposals import Proposal
from roam_core.proposal.reshaping.topology import TopologyChange, TopologyKind
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Origin, Project, RotoShape
from tests.unit.proposal.scenes import drawn, spline

LEFT, RIGHT = (16, 30, 76, 90), (100, 44, 130, 70)
POINTS = spline(drawn(LEFT, (74, 52, 102, 60), RIGHT))
SHAPE = RotoShape(
    id="s", name="Wing", keys=(Keyframe(1001, POINTS), Keyframe(1002, POINTS, origin=Origin.ENGINE)), colour="#ff8800"
)
RINGS = tuple(bezier.flatten(spline(drawn(box))) for box in (LEFT, RIGHT))


@pytest.mark.parametrize("kind", list(TopologyKind))
def test_the_old_shape_keeps_its_points_and_gets_the_larger_part(kind: TopologyKind) -> None:
    rings = RINGS if kind is TopologyKind.SPLIT else RINGS[:1]
    offer = Proposal.of(TopologyChange(kind, rings, 3.0), SHAPE, 1002, 1.0)
    assert (offer.kind, offer.frame, offer.gain, offer.before) == (kind, 1002, 3.0, (SHAPE,))
    assert len(offer.after) == len(rings)
    stays = offer.after[0]
    assert (stays.id, stays.name, stays.point_count) == (SHAPE.id, SHAPE.name, SHAPE.point_count)
    npt.assert_array_equal(stays.at(1001).points, POINTS)
    key = stays.key_at(1002)
    assert key is not None
    assert key.origin is Origin.ENGINE
    area = abs(polyline.signed_area(bezier.flatten(key.points)))
    assert area == pytest.approx(abs(polyline.signed_area(RINGS[0])), rel=0.1)


def test_a_part_becomes_a_shape_that_begins_there() -> None:
    offer = Proposal.of(TopologyChange(TopologyKind.SPLIT, RINGS, 3.0), SHAPE, 1002, 1.0)
    part = offer.after[1]
    assert part.id != SHAPE.id
    assert [(key.frame, key.origin) for key in part.keys] == [(1002, Origin.ENGINE)]
    assert (part.colour, part.blend) == (SHAPE.colour, BlendMode.ADD)
    outline = bezier.flatten(part.keys[0].points)
    assert abs(polyline.signed_area(outline)) == pytest.approx(abs(polyline.signed_area(RINGS[1])), rel=0.03)
    assert outline[:, 0].min() > 95


def test_taking_nothing_changes_nothing() -> None:
    before = [key.points.copy() for key in SHAPE.keys]
    assert len(Proposal.of(TopologyChange(TopologyKind.SPLIT, RINGS, 3.0), SHAPE, 1002, 1.0).after) == 2
    assert all(np.array_equal(key.points, points) for key, points in zip(SHAPE.keys, before, strict=True))


@pytest.mark.parametrize(("step", "lifetime"), [(1, (1002, 1011)), (-1, (1001, 1003))])
def test_what_the_artist_takes_is_the_artists(step: int, lifetime: tuple[int, int]) -> None:
    below, above = replace(SHAPE, id="below"), replace(SHAPE, id="above")
    layer = Layer("layer", "Layer", (below, SHAPE, above))
    project = Project(Clip(Path("shot"), 1001, 1010, (160, 120)), Layer("root", "Root", (layer,)))
    offer = Proposal.of(TopologyChange(TopologyKind.SPLIT, RINGS, 3.0), SHAPE, 1002, 1.0)
    after, ids = offer.accepted(project, step)
    assert [shape.id for shape in after.shapes] == ["below", *ids, "above"]
    stays, part = (after.shape(shape_id) for shape_id in ids)
    assert stays.artist_frames == (1001, 1002)
    assert part.artist_frames == part.frames == (1002,)
    assert (stays.lifetime, part.lifetime) == (None, lifetime)
    npt.assert_array_equal(stays.at(1002).points, offer.after[0].at(1002).points)
    assert project.shape("s") is SHAPE


def test_the_parts_of_a_shape_are_outlines_of_one_thing() -> None:
    offer = Proposal.of(TopologyChange(TopologyKind.SPLIT, RINGS, 3.0), SHAPE, 1002, 1.0)
    for before, name in (("", "compound-2"), ("mask-1", "mask-1")):
        other = replace(SHAPE, id="other", compound="compound-1")
        project = Project(root=Layer("root", "Root", (replace(SHAPE, compound=before), other)))
        after, ids = offer.accepted(project, 1)
        assert [after.shape(shape_id).compound for shape_id in ids] == [name, name]


def test_a_dropped_part_leaves_one_shape() -> None:
    project = Project(None, Layer("root", "Root", (SHAPE,)))
    offer = Proposal.of(TopologyChange(TopologyKind.DROP, RINGS[:1], 3.0), SHAPE, 1002, 1.0)
    after, ids = offer.accepted(project, 1)
    assert ids == ("s",)
    assert [shape.artist_frames for shape in after.shapes] == [(1001, 1002)]
