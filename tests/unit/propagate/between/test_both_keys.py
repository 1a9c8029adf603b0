"""The engines of both keys of a span: a lone shape goes by what both show, anything else by what its own key shows."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.params import params_for
from roam_core.propagate.between.both_keys import as_on_another, as_on_both
from roam_core.propagate.engines.by_curves import CurveEngine
from roam_core.propagate.engines.by_regions import RegionEngine
from roam_core.propagate.frame.result import Part
from tests.unit.motion.test_agreement import MOVED, outline, own, picture
from tests.unit.motion.test_pose import box

BEST = params_for("best")


def begun(moved: Array, cover: Array | None) -> RegionEngine:
    return RegionEngine.begun(picture(moved, cover), (Part(outline(moved)),), BEST)


def count(engine: object) -> int:
    assert isinstance(engine, RegionEngine)
    assert engine.state.pose is not None
    return len(own(engine.state.pose.template))


def test_a_lone_shape_goes_by_what_both_keys_show() -> None:
    first, last = begun(np.zeros(2), box(30, 30, 40, 50)), begun(MOVED, None)
    ours, theirs = as_on_both(first, last)
    assert count(ours) < 0.7 * count(first)
    assert count(theirs) < 0.7 * count(last)


def two(moved: Array) -> tuple[Part, Part]:
    """An object of two outlines, which has no pose."""
    return Part(outline(moved)), Part(outline(moved) + np.array([0.0, 35.0]))


def test_what_has_no_pose_knows_the_textures_of_both_keys() -> None:
    first, last = begun(np.zeros(2), None), RegionEngine.begun(picture(MOVED, None), two(MOVED), BEST)
    ours, theirs = as_on_both(first, last)
    assert isinstance(theirs, RegionEngine)
    for engine, before in ((ours, first), (theirs, last)):
        assert isinstance(engine, RegionEngine)
        now, then = engine.state.texture, before.state.texture
        assert now is not None
        assert then is not None
        assert engine.state.pose is before.state.pose
        np.testing.assert_array_equal(now.bounds, then.bounds)
        assert np.abs(now.key - then.key).max() > 0.01
        np.testing.assert_allclose(now.key.sum(axis=2), 1.0, atol=1e-5)


def test_curves_stay_as_they_are() -> None:
    first = begun(np.zeros(2), None)
    curves = CurveEngine.begun(picture(MOVED, None), two(MOVED)[:1], params_for("full"))
    assert as_on_both(first, curves) == (first, curves)


def test_a_lone_shape_may_go_by_another_key_and_nothing_else_may() -> None:
    first, last = begun(np.zeros(2), box(20, 20, 72, 70)), begun(MOVED, None)
    ours = as_on_another(first, last)
    assert isinstance(ours, RegionEngine)
    assert ours.state.pose is not None
    assert not ours.state.pose.template.is_own
    assert ours.state.frame is first.state.frame
    assert as_on_another(first, None) is None
    assert as_on_another(first, RegionEngine.begun(picture(MOVED, None), two(MOVED), BEST)) is None
