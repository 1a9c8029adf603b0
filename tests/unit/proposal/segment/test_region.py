"""The proposed region: what belongs to the object, and to which of its shapes."""

from __future__ import annotations

import numpy as np
import numpy.testing as npt

from roam_core.params import RegionParams
from roam_core.proposal.cues.evidence import uncertain_band
from roam_core.proposal.cues.motion_cue import MotionMisfit
from roam_core.proposal.segment.region import cleaned, outlines
from tests.unit.proposal.cells import box, field_of


def test_a_part_on_the_background_is_dropped_and_one_where_the_object_was_is_kept() -> None:
    body, stray = box((40, 60), slice(5, 25), slice(5, 25)), box((40, 60), slice(10, 20), slice(40, 55))
    assert (cleaned(field_of(body | stray), body, 0.3, 6).inside == body).all()
    assert (cleaned(field_of(body | stray), body | stray, 0.3, 6).inside == (body | stray)).all()


def test_specks_go_and_pinholes_close() -> None:
    body = box((40, 40), slice(5, 30), slice(5, 30))
    noisy = body.copy()
    noisy[10, 10] = False
    noisy[35, 35] = True
    assert (cleaned(field_of(noisy), np.ones_like(body), 0.3, 6).inside == body).all()


def test_outlines_come_in_image_coordinates_with_holes_after_their_part() -> None:
    body = box((40, 40), slice(5, 30), slice(5, 30))
    body[12:20, 12:20] = False
    ((outer, hole),) = outlines(field_of(body))
    npt.assert_allclose([outer.min(axis=0), outer.max(axis=0)], [(20, 30), (70, 80)], atol=0.1)
    npt.assert_allclose([hole.min(axis=0), hole.max(axis=0)], [(34, 44), (50, 60)], atol=0.1)


def test_the_band_lies_around_the_border_and_not_along_the_image_edge() -> None:
    inside = box((30, 30), slice(0, 30), slice(0, 15))
    band = uncertain_band(inside, inside, 3)
    assert band[10, 12:18].all()
    assert not band[:, :10].any()
    assert not band[:, 20:].any()


def test_the_motion_cue_tells_what_moves_with_the_object() -> None:
    backward = np.zeros((10, 20, 2), dtype=np.float32)
    backward[:, :10] = (-4.0, 1.0)
    with_object, still = np.eye(3), np.eye(3)
    with_object[:2, 2] = (-4.0, 1.0)
    misfit = MotionMisfit.of(backward, with_object, still, 1.5)
    ratio = misfit.log_ratio(3.0)
    npt.assert_allclose(ratio[:, :10], 3.0)
    npt.assert_allclose(ratio[:, 10:], -3.0)
    left_behind = misfit.left_behind(0.9, RegionParams())
    assert left_behind[:, 10:].all()
    assert not left_behind[:, :10].any()
    assert not misfit.left_behind(0.3, RegionParams()).any()  # too little of the object moves as one
    together = MotionMisfit.of(backward, still, still, 1.5)
    npt.assert_allclose(together.log_ratio(3.0), 0.0)
    assert not together.left_behind(0.9, RegionParams()).any()


def test_what_moves_as_neither_is_not_left_behind() -> None:
    backward = np.full((4, 4, 2), 9.0, dtype=np.float32)
    with_object = np.eye(3)
    with_object[:2, 2] = (-4.0, 1.0)
    assert not MotionMisfit.of(backward, with_object, np.eye(3), 1.5).left_behind(0.9, RegionParams()).any()
