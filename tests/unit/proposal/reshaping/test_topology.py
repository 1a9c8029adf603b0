"""A part that hangs by a thread: two shapes, one, or as it is - by the energy, and for the artist to say."""

from __future__ import annotations

import pytest

from roam_core.geometry import bezier, polyline
from roam_core.proposal.reshaping.reparametrise import energy_of
from roam_core.proposal.reshaping.topology import TopologyKind, topology_changes
from roam_core.proposal.segment.segmentation import Segmentation
from tests.unit.proposal.scenes import GRID, PARAMS, context, drawn, spline

LEFT, BRIDGE, RIGHT = (16, 30, 76, 90), (74, 52, 102, 60), (100, 44, 130, 70)
WHOLE = drawn(LEFT, BRIDGE, RIGHT)
APART = Segmentation(GRID, drawn(LEFT, RIGHT)[::2, ::2], WHOLE[::2, ::2])


def test_parts_that_both_look_like_the_object_make_two_shapes() -> None:
    here, line = context(drawn(LEFT, RIGHT)), bezier.flatten(spline(WHOLE))
    (change,) = topology_changes(line, APART, here, PARAMS)
    assert change.kind is TopologyKind.SPLIT
    left, right = change.rings
    assert abs(polyline.signed_area(left)) > abs(polyline.signed_area(right)) > 500
    assert left[:, 0].max() < right[:, 0].min()
    after = energy_of(left, here, PARAMS) + energy_of(right, here, PARAMS)
    assert change.gain == pytest.approx(energy_of(line, here, PARAMS) - after)
    assert change.gain > 0


def test_a_part_that_looks_like_the_background_is_to_go() -> None:
    here, line = context(drawn(LEFT)), bezier.flatten(spline(WHOLE))
    (change,) = topology_changes(line, APART, here, PARAMS)
    assert change.kind is TopologyKind.DROP
    (left,) = change.rings
    assert left[:, 0].max() < 90
    assert change.gain == pytest.approx(energy_of(line, here, PARAMS) - energy_of(left, here, PARAMS))


def test_what_would_raise_the_energy_is_not_proposed() -> None:
    line = bezier.flatten(spline(WHOLE))
    assert topology_changes(line, APART, context(WHOLE), PARAMS) == ()


@pytest.mark.parametrize("width", [3, 6])
def test_a_thread_however_thin_is_seen(width: int) -> None:
    line = bezier.flatten(spline(drawn(LEFT, (74, 55, 102, 55 + width), RIGHT)))
    assert line[:, 0].max() > 120
    (change,) = topology_changes(line, APART, context(drawn(LEFT, RIGHT)), PARAMS)
    assert change.kind is TopologyKind.SPLIT


def test_one_part_with_its_dust_is_no_change_of_topology() -> None:
    dusty = drawn(LEFT, BRIDGE, (100, 52, 108, 60))
    line = bezier.flatten(spline(dusty))
    proposed = Segmentation(GRID, (dusty & ~drawn((80, 40, 98, 70)))[::2, ::2], dusty[::2, ::2])
    assert topology_changes(line, proposed, context(drawn(LEFT)), PARAMS) == ()
