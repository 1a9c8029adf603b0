"""Pieces of a region: whose they are, and how those of one shape hang together."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.geometry import polyline
from roam_core.params import ComponentsParams
from roam_core.proposal.segment.components import joined, opened, ring_around, shares
from tests.unit.proposal.cells import box, field_of

SHAPE = (40, 120)
LEFT, RIGHT = box(SHAPE, slice(5, 35), slice(5, 45)), box(SHAPE, slice(8, 30), slice(60, 100))
"""A body with a post before it."""
EVERYWHERE = np.ones(SHAPE, dtype=bool)
BAY = box(SHAPE, slice(12, 30), slice(15, 36))
"""What lies between an arm and the body: to the right of it the arm, four cells wide, and then the outside."""
BODY = box(SHAPE, slice(5, 35), slice(5, 40)) & ~BAY
SPECK = box(SHAPE, slice(20, 23), slice(108, 111))


def covered(cells: np.ndarray) -> np.ndarray:
    """The claim of a shape that is expected there."""
    return np.asarray(cells, dtype=np.float32)


def test_shapes_that_claim_one_part_divide_it_and_others_get_their_own() -> None:
    whole = box((20, 60), slice(5, 15), slice(2, 40)) | box((20, 60), slice(5, 15), slice(48, 58))
    claims = [
        box((20, 60), slice(5, 15), slice(2, 20)).astype(np.float32),
        box((20, 60), slice(5, 15), slice(22, 40)).astype(np.float32),
        box((20, 60), slice(5, 15), slice(48, 58)).astype(np.float32),
        box((20, 60), slice(17, 19), slice(2, 8)).astype(np.float32),
    ]
    left, right, alone, none = shares(whole, claims, np.ones_like(whole), ComponentsParams())
    assert (left | right | alone == whole).all()
    assert not (left & right).any()
    assert left[10, 5]
    assert right[10, 35]
    assert alone[10, 50]
    assert not alone[10, 5]
    assert not none.any()


def test_a_piece_that_nobody_wants_most_goes_to_who_claims_most_of_it_or_is_nearest() -> None:
    far = box(SHAPE, slice(2, 6), slice(104, 118))
    one = (LEFT | box(SHAPE, slice(10, 20), slice(60, 70))).astype(np.float32)
    other = box(SHAPE, slice(33, 38), slice(112, 118)).astype(np.float32)
    mine, lost = shares(LEFT | RIGHT | far, [one, other], EVERYWHERE, ComponentsParams())
    assert (mine == LEFT | RIGHT).all()
    assert (lost == far).all()


def test_a_stray_is_left_alone_where_the_object_is_not_likely_to_be() -> None:
    (mine,) = shares(LEFT | RIGHT, [LEFT.astype(np.float32)], LEFT, ComponentsParams())
    assert (mine == LEFT).all()


def test_what_a_shape_claims_most_of_is_its_own_wherever_it_lies() -> None:
    body, hand = shares(LEFT | RIGHT, [LEFT.astype(np.float32), RIGHT.astype(np.float32)], LEFT, ComponentsParams())
    assert (body == LEFT).all()
    assert (hand == RIGHT).all()


def test_rivals_divide_evenly_up_to_the_border_of_the_grid() -> None:
    whole = box((20, 80), slice(0, 20), slice(0, 80))
    claims = [box((20, 80), slice(0, 20), columns).astype(np.float32) for columns in (slice(0, 50), slice(30, 80))]
    left, right = shares(whole, claims, whole, ComponentsParams())
    assert (left[:, :39]).all()
    assert (right[:, 41:]).all()


def test_pieces_hang_together_by_the_shortest_way() -> None:
    body, threads = joined(LEFT | RIGHT, 2.0, ComponentsParams())
    assert (body == LEFT | RIGHT).all()
    rows, columns = np.nonzero(threads)
    assert (np.sort(columns) == np.arange(45, 60)).all()
    assert np.ptp(rows) == 0
    assert 8 <= rows[0] < 30


@pytest.mark.parametrize("apart", [SPECK, box((40, 300), slice(5, 15), slice(250, 260))], ids=["speck", "far"])
def test_specks_and_what_is_far_off_do_not_hang_on(apart: np.ndarray) -> None:
    near = np.zeros(apart.shape, dtype=bool)
    near[:, :120] = LEFT
    body, threads = joined(near | apart, 2.0, ComponentsParams())
    assert (body == near).all()
    assert not threads.any()


def test_a_speck_on_the_way_does_not_cut_the_thread() -> None:
    nose = box(SHAPE, slice(18, 22), slice(44, 48)) | box(SHAPE, slice(18, 22), slice(57, 61))
    speck = box(SHAPE, slice(18, 22), slice(51, 54))
    field = field_of(LEFT | RIGHT | nose | speck)
    ring = ring_around(field, field.inside, covered(field.inside), 2.0, ComponentsParams())
    assert ring is not None
    assert abs(polyline.signed_area(ring)) / 4.0 > 0.97 * (LEFT | RIGHT | nose).sum()


def test_one_outline_goes_around_all_pieces_and_does_not_cross_itself() -> None:
    field = field_of(LEFT | RIGHT)
    ring = ring_around(field, field.inside, covered(field.inside), 2.0, ComponentsParams())
    assert ring is not None
    assert len(polyline.crossings(ring)) == 0
    cell = 4.0  # square pixels
    npt.assert_allclose(abs(polyline.signed_area(ring)) / cell, LEFT.sum() + RIGHT.sum(), rtol=0.02)


def test_around_nothing_there_is_no_outline() -> None:
    assert ring_around(field_of(LEFT), np.zeros_like(LEFT), covered(LEFT), 2.0, ComponentsParams()) is None


def test_without_threads_an_outline_has_one_piece() -> None:
    body, threads = joined(LEFT | RIGHT, 0.0, ComponentsParams())
    assert (body == LEFT).all()
    assert not threads.any()


def test_a_bay_that_closed_is_kept_open_along_the_shortest_way() -> None:
    slits = opened(BODY, covered(BODY), 2.0, ComponentsParams())
    rows, columns = np.nonzero(slits)
    assert (np.sort(columns) == np.arange(36, 40)).all()
    assert np.ptp(rows) == 0
    assert 12 <= rows[0] < 30


def test_an_outline_goes_around_in_a_bay_that_closed_and_does_not_cross_itself() -> None:
    field, cell = field_of(BODY), 4.0
    ring = ring_around(field, BODY, covered(BODY), 2.0, ComponentsParams())
    assert ring is not None
    assert len(polyline.crossings(ring)) == 0
    npt.assert_allclose(abs(polyline.signed_area(ring)) / cell, BODY.sum(), rtol=0.02)


@pytest.mark.parametrize(
    ("expected", "longest"), [(BODY | BAY, 2.0), (BODY, 0.1)], ids=["inside before", "a thick wall"]
)
def test_a_hole_that_is_new_or_lies_deep_inside_is_no_bay(expected: np.ndarray, longest: float) -> None:
    assert not opened(BODY, covered(expected), longest, ComponentsParams()).any()


def test_ground_that_a_leak_encloses_is_no_bay() -> None:
    """Most of what lies around it is not expected to be the shape's, as between a leg and the other, leaked into."""
    own = box(SHAPE, slice(5, 35), slice(5, 15))
    assert not opened(BODY, covered(own), 2.0, ComponentsParams()).any()
    assert opened(BODY, covered(own | box(SHAPE, slice(5, 12), slice(15, 40))), 2.0, ComponentsParams()).any()


def test_specks_of_outside_stay_closed() -> None:
    body = box(SHAPE, slice(5, 35), slice(5, 40)) & ~box(SHAPE, slice(10, 13), slice(35, 38))
    assert not opened(body, covered(body), 2.0, ComponentsParams()).any()


def test_a_bay_behind_another_opens_through_it() -> None:
    behind = box(SHAPE, slice(14, 28), slice(8, 13))
    body = BODY & ~behind
    slits = opened(body, covered(body), 2.0, ComponentsParams())
    assert np.count_nonzero(slits) == (8 - 5) + (15 - 13)  # to the left, where that is nearest, and then through it
