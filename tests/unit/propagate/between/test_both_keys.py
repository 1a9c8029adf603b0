"""The engines of both keys of a span: a lone shape goes by what both show, anything else by what its own key shows."""

from __future__ import annotations

import numpy as np

from roam_core.arrays import Array
from roam_core.params import params_for
from roam_core.propagate.between.both_keys import as_on_both
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


def test_what_has_no_pose_stays_as_it_is() -> None:
    first = begun(np.zeros(2), None)
    two = (Part(outline(MOVED)), Part(outline(MOVED) + np.array([0.0, 35.0])))
    several = RegionEngine.begun(picture(MOVED, None), two, BEST)
    curves = CurveEngine.begun(picture(MOVED, None), two[:1], params_for("full"))
    for other in (several, curves):
        assert as_on_both(first, other) == (first, other)
