"""Marked differences between curve and segmentation: which there are, and which are taken."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core.energy import total
from roam_core.geometry import bezier, polyline
from roam_core.kernels.coverage import coverage
from roam_core.params import ProposalParams
from roam_core.proposal.reshaping.reparametrise import cells_in, differences, energy_of, reshaped, untouched
from roam_core.proposal.segment.segmentation import Segmentation, segmented
from tests.unit.proposal.scenes import GRID, PARAMS, SIZE, Bools, context, drawn, picture, spline, with_price

BODY = (40, 30, 90, 90)
LIMB = (86, 50, 108, 66)
PROPOSALS = ProposalParams()


def halved(mask: Bools) -> Bools:
    return np.asarray(mask[::2, ::2])


def proposal(mask: Bools, expected: Bools) -> Segmentation:
    return Segmentation(GRID, halved(mask), halved(expected))


def overlap(line: np.ndarray, mask: Bools) -> float:
    inside = coverage(line, SIZE) > 0.5
    return np.count_nonzero(inside & mask) / np.count_nonzero(inside | mask)


def test_the_energy_is_the_oracles_at_even_spacing_whichever_way_the_line_runs() -> None:
    here = context(drawn(BODY))
    line = bezier.flatten(spline(drawn(BODY)))
    count = round(polyline.length(line) / here.spacing)
    clockwise = line if polyline.signed_area(line) > 0 else line[::-1]
    expected = total.energies(polyline.resample(clockwise, count), here, PARAMS)["total"]
    assert energy_of(clockwise, here, with_price(0.0)) == expected
    assert energy_of(clockwise, here, with_price(0.5)) == pytest.approx(expected + 0.5 * count)
    assert energy_of(clockwise[::-1], here, with_price(0.0)) == pytest.approx(expected, abs=0.5)


def test_a_segmentation_finds_what_the_colours_show_near_the_curve_and_nothing_else() -> None:
    body, far = drawn(BODY), drawn((4, 4, 20, 20))
    truth = drawn(BODY, LIMB)
    colours = context(truth | far).colours
    assert colours is not None
    found = segmented(picture(truth), spline(body), colours, replace(PROPOSALS, reach=80.0), 1.0)
    differs = np.argwhere(found.inside != halved(truth))
    assert len(differs) < 0.05 * np.count_nonzero(found.inside)
    near = segmented(picture(truth), spline(body), colours, replace(PROPOSALS, reach=8.0), 1.0)
    assert not near.inside[:, 50:].any()
    npt.assert_array_equal(near.expected, found.expected)


def test_marked_differences_are_large_deep_and_not_stray() -> None:
    body = drawn(BODY)
    speck, stray = drawn((92, 36, 96, 40)), drawn((116, 80, 146, 100))
    threaded = body.copy()
    threaded[90:112, 60:62] = True
    proposed = threaded | speck | drawn(BODY, LIMB) | stray
    components = differences(halved(body), proposal(proposed, body), PROPOSALS)
    assert [piece.added for piece in components] == [True]
    assert components[0].cells[29, 48]
    gone = differences(halved(proposed), proposal(body, body), PROPOSALS)
    assert {piece.added for piece in gone} == {False}
    assert [p.cells.sum() for p in gone] == sorted((p.cells.sum() for p in gone), reverse=True)
    assert len(differences(halved(proposed), proposal(body, body), replace(PROPOSALS, most=1))) == 1


@pytest.mark.parametrize("grows", [True, False])
def test_a_piece_that_the_colours_want_is_taken_with_the_energy_of_what_comes_of_it(grows: bool) -> None:
    body, whole = drawn(BODY), drawn(BODY, LIMB)
    start, truth = (body, whole) if grows else (whole, body)
    here = context(truth)
    line = bezier.flatten(spline(start))
    new = reshaped(line, proposal(truth, whole), here, PARAMS)
    assert new.is_new
    assert new.energy < new.energy_before == energy_of(line, here, PARAMS)
    assert new.energy == pytest.approx(energy_of(new.ring, here, PARAMS), abs=0.5)
    assert overlap(new.ring, truth) > 0.94 > overlap(line, truth)
    assert polyline.is_simple(new.ring)
    assert polyline.signed_area(new.ring) * polyline.signed_area(line) > 0


def test_a_piece_that_the_energy_does_not_want_is_left() -> None:
    body, whole = drawn(BODY), drawn(BODY, LIMB)
    line = bezier.flatten(spline(body))
    new = reshaped(line, proposal(whole, whole), context(body), PARAMS)
    assert not new.is_new
    npt.assert_array_equal(new.ring, line)
    assert new.energy == new.energy_before


@pytest.mark.parametrize("least", [0.0, 3100.0, 3300.0])
def test_what_would_leave_too_little_is_held(least: float) -> None:
    body, whole = drawn(BODY), drawn(BODY, LIMB)
    line = bezier.flatten(spline(whole))
    assert 3200.0 < abs(polyline.signed_area(line)) < 3400.0
    shrunk = reshaped(line, proposal(body, whole), context(body), PARAMS, least)
    assert shrunk.is_new == (least < 3000.0)
    grown = reshaped(bezier.flatten(spline(body)), proposal(whole, whole), context(whole), PARAMS, least)
    assert grown.is_new


def test_away_from_the_piece_the_outline_stays() -> None:
    body, whole = drawn(BODY), drawn(BODY, LIMB)
    line = bezier.flatten(spline(body))
    new = reshaped(line, proposal(whole, whole), context(whole), PARAMS)
    old = polyline.resample(line, 400)
    old = old[old[:, 0] < 80]
    gap = np.hypot(*(old[:, None] - polyline.resample(new.ring, 1200)[None]).transpose(2, 0, 1)).min(axis=1)
    assert gap.max() < 1.0


def test_a_piece_that_holds_two_parts_together_is_left() -> None:
    dumbbell = drawn((20, 40, 60, 80), (58, 56, 92, 64), (90, 40, 130, 80))
    apart = drawn((20, 40, 60, 80), (90, 40, 130, 80))
    line = bezier.flatten(spline(dumbbell))
    new = reshaped(line, proposal(apart, dumbbell), context(apart), PARAMS)
    assert not new.is_new
    assert new.energy == new.energy_before


def test_points_far_from_a_change_are_untouched() -> None:
    points = spline(drawn(BODY))
    changed = np.zeros(GRID.shape, dtype=bool)
    changed[25:33, 44:56] = True
    keep = untouched(points, changed, GRID, 24)
    assert keep.any()
    assert not keep.all()
    assert keep[points[:, 0, 0].argmin()]
    assert not untouched(points, np.ones(GRID.shape, dtype=bool), GRID, 24).any()
    assert untouched(points, np.zeros(GRID.shape, dtype=bool), GRID, 24).all()


def test_the_area_of_a_ring_in_cells() -> None:
    assert cells_in(np.array([[0.0, 0.0], [20.0, 0.0], [20.0, 10.0], [0.0, 10.0]]), GRID) == pytest.approx(50.0)
