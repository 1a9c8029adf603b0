"""Which shape becomes which part of a mask."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt

from roam_core.arrays import Array
from roam_core.geometry import bezier, polyline
from roam_core.geometry.bezier import polygon_points
from roam_core.proposal.mask_keys.pairing import centre, paired
from tests.golden.shots import blob

SIZE = (200, 300)


def box(left: float, top: float, right: float, bottom: float) -> Array:
    return polygon_points([(left, top), (right, top), (right, bottom), (left, bottom)])


def ring(*corners: float) -> Array:
    return bezier.flatten(box(*corners))


def test_all_that_moved_together_is_paired_where_the_nearest_would_be_wrong() -> None:
    row = [box(20 + 40 * k, 50, 45 + 40 * k, 90) for k in range(4)]
    moved = [ring(52 + 40 * k, 53, 77 + 40 * k, 93) for k in (2, 0, 3, 1)]
    pairing = paired(row, moved, SIZE)
    assert [next(j for j, each in enumerate(moved) if each is found) for found in pairing.rings] == [1, 3, 0, 2]
    npt.assert_allclose(pairing.pose[:, 2], (32.0, 3.0), atol=0.5)


def test_what_has_no_partner_has_no_ring() -> None:
    pairing = paired(
        [box(20, 20, 60, 60), box(200, 20, 204, 24)], [ring(24, 20, 64, 60), ring(150, 150, 190, 190)], SIZE
    )
    assert pairing.rings[1] is None
    assert pairing.owners == {0: 0}
    assert paired([], [ring(1, 1, 5, 5)], SIZE).owners == {}
    assert paired([box(1, 1, 5, 5)], [], SIZE).rings == [None]


def test_neighbours_of_like_size_that_grew_together_divide_the_part() -> None:
    first, second = box(20, 20, 70, 60), box(74, 20, 120, 60)
    pairing = paired([first, second], [ring(20, 20, 120, 60)], SIZE)
    assert sorted(pairing.sharing[0]) == [0, 1]
    left, right = pairing.rings
    assert left is not None
    assert right is not None
    assert abs(left[:, 0].max() - 72.0) < 2.0
    assert abs(right[:, 0].min() - 72.0) < 2.0


def test_what_the_division_cuts_off_goes_to_the_neighbour_that_it_touches() -> None:
    """The toe of the left one's foot lies nearer to the right one, which it does not touch."""
    foot = [(66.0, 60.0), (66.0, 90.0), (110.0, 90.0), (110.0, 110.0), (50.0, 110.0), (50.0, 60.0)]
    part = np.array([(20.0, 20.0), (120.0, 20.0), (120.0, 60.0), *foot, (20.0, 60.0)])
    left, right = paired([box(20, 20, 70, 60), box(74, 20, 120, 60)], [part], SIZE).rings
    assert left is not None
    assert right is not None
    npt.assert_allclose(left.max(axis=0), (110.0, 110.0), atol=1.0)
    npt.assert_allclose(right.max(axis=0), (120.0, 60.0), atol=1.0)
    whole = abs(polyline.signed_area(part))
    assert abs(polyline.signed_area(left)) + abs(polyline.signed_area(right)) > 0.99 * whole


def test_a_crumb_inside_another_part_ends() -> None:
    assert paired([box(20, 20, 120, 60), box(124, 30, 130, 36)], [ring(20, 20, 134, 60)], SIZE).rings[1] is None


def test_a_speck_that_outgrew_its_points_takes_no_large_part_that_needs_more() -> None:
    star, beside = bezier.flatten(blob([60.0, 25.0] * 6) + np.array([150.0, 100.0])), box(20, 20, 60, 60)
    speck, rings = box(165, 80, 205, 120), [star, bezier.flatten(beside)]
    assert paired([speck, beside], rings, SIZE).rings[0] is star
    assert paired([speck, beside], rings, SIZE, smallest=[1600.0, 1600.0]).rings[0] is star
    assert paired([speck, beside], rings, SIZE, smallest=[12.0, 1600.0]).rings[0] is None
    plain = ring(90, 48, 210, 152)
    assert paired([speck, beside], [plain, rings[1]], SIZE, smallest=[12.0, 1600.0]).rings[0] is plain


def test_the_centre_is_that_of_the_area() -> None:
    there, area = centre([ring(0, 0, 10, 10), ring(20, 0, 30, 20)[::-1]])
    npt.assert_allclose(there, (55.0 / 3.0, 25.0 / 3.0))
    assert area == 300.0
    assert centre([bezier.flatten(blob([5.0] * 6)) * 0.0 + 3.0])[0].tolist() == [3.0, 3.0]
