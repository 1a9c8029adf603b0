"""Grips on whatever shape: they give back its outline, and a shape turned into a B-spline stays one."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.geometry import bspline
from roam_core.roto import RotoShape, Spline, control_points
from tests.property.strategies import bspline_shapes, roto_shapes

FEW = settings(max_examples=25)
"""The maps are linear: what holds for a few shapes holds for all."""


@FEW
@given(bspline_shapes())
def test_to_bezier_changes_no_outline(shape: RotoShape) -> None:
    after = control_points.with_spline(shape, Spline.BEZIER)
    assert after == replace(shape, spline=Spline.BEZIER)


@FEW
@given(roto_shapes())
def test_to_bspline_and_again_is_once(shape: RotoShape) -> None:
    once = control_points.with_spline(shape, Spline.BSPLINE)
    assert all(bspline.is_bspline(key.points, once.closed) for key in once.keys)
    again = control_points.with_spline(once, Spline.BSPLINE)
    for key, same in zip(once.keys, again.keys, strict=True):
        np.testing.assert_allclose(same.points, key.points, atol=1e-6)


@FEW
@given(bspline_shapes(), st.floats(-100.0, 2100.0))
def test_control_points_give_back_the_outline_at_any_time(shape: RotoShape, frame: float) -> None:
    outline = shape.at(frame)
    np.testing.assert_allclose(
        control_points.points_of(outline.control_points, shape.spline, shape.closed), outline.points, atol=1e-6
    )
