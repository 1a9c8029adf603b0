"""Parts that no pose fits: they go along with the whole, as it goes, and say so."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import replace

import numpy as np
import numpy.testing as npt
import pytest

from roam_core import render_matte, track
from roam_core.features import PreparedFrame
from roam_core.geometry.simple import crossing_segments
from roam_core.params import FigureParams, params_for
from roam_core.propagate import TrackMemory
from roam_core.propagate.engines.protocol import REGION
from roam_core.propagate.explain import explain
from roam_core.propagate.frame.confidence import overlap
from roam_core.propagate.frame.result import FrameResult, Part
from roam_core.propagate.parts.along import UnionMotion
from roam_core.propagate.parts.figure import FigureState, begin
from roam_core.propagate.shapes.objects import Role, Unit
from roam_core.roto import Keyframe, RotoShape
from tests.unit.propagate.figures import SIZE, Figure, body_with_arms, flame, keys_of


@pytest.fixture(scope="module")
def bending() -> Figure:
    return flame()


@pytest.fixture(scope="module")
def run(bending: Figure) -> list[FrameResult]:
    return list(track(bending.read, bending.shapes(), bending.frames, "best"))


def of_union(figure: Figure, shapes: Sequence[RotoShape], frame: int) -> float:
    """The overlap of all shapes together with the truth."""
    true = render_matte(figure.shapes(frame), frame, SIZE) > 0.5
    return overlap(render_matte(shapes, frame, SIZE) > 0.5, true)


def shapes_of(result: FrameResult) -> list[RotoShape]:
    return [each.shape for each in result.results]


def by_what(results: Iterable[FrameResult]) -> list[set[str]]:
    """For each frame by what its outlines were found."""
    return [{term for each in result.results for term in each.energies if term != "total"} for result in results]


def test_parts_of_what_bends_go_along_with_it(bending: Figure, run: list[FrameResult]) -> None:
    unions = [of_union(bending, shapes_of(run[-1]), frame) for frame in bending.frames[1:]]
    along = run[-5:]
    assert len(unions) == len(run) == 7
    assert min(unions) > 0.85  # where the parts cover as much, they still lie by their poses
    assert min(unions[-5:]) > 0.95
    assert by_what(along) == [{"region"}] * 5
    assert all(each.confidence > 0.8 for result in along for each in result.results)


def test_by_their_poses_they_would_be_lost(bending: Figure) -> None:
    params = params_for("best")
    assert params.region is not None
    figure = replace(params.region.figure, unfit=np.inf)
    *_, last = track(
        bending.read, bending.shapes(), bending.frames, replace(params, region=replace(params.region, figure=figure))
    )
    assert by_what([last]) == [{"pose"}]
    assert of_union(bending, shapes_of(last), last.frame) < 0.7
    assert all(each.confidence < 0.5 for each in last.results)


def test_parts_whose_poses_fit_keep_to_them() -> None:
    stiff = body_with_arms(5)
    assert by_what(track(stiff.read, stiff.shapes(), stiff.frames, "best")) == [{"pose"}] * 4


@pytest.mark.parametrize("remembering", [True, False], ids=["remembering", "solving again"])
def test_stops_change_nothing(bending: Figure, run: list[FrameResult], remembering: bool) -> None:
    shapes, memory = bending.shapes(), TrackMemory() if remembering else None
    for frames in (range(4), range(3, 8)):
        *_, last = track(bending.read, shapes, frames, "best", memory=memory)
        shapes = shapes_of(last)
    assert [keys_of(shape) for shape in shapes] == [keys_of(shape) for shape in shapes_of(run[-1])]


def test_what_was_not_corrected_goes_on_along(bending: Figure, run: list[FrameResult]) -> None:
    lower, upper = (
        replace(shape, keys=tuple(key for key in shape.keys if key.frame <= 3)) for shape in shapes_of(run[-1])
    )
    corrected = upper.with_key(Keyframe(3, bending.parts[1].truth(3)))
    *_, last = track(bending.read, [lower, corrected], range(3, 8), "best")
    assert min(of_union(bending, shapes_of(last), frame) for frame in range(4, 8)) > 0.95


def test_they_are_explained_by_the_cues_of_the_whole(bending: Figure, run: list[FrameResult]) -> None:
    told = explain(lambda k: PreparedFrame(bending.read(k)), shapes_of(run[-1]), 5, None)
    assert [each.apart for each in told] == [0.0, 0.0]
    assert all(REGION in each.account.terms for each in told)


@pytest.fixture(scope="module")
def on_key(bending: Figure) -> FigureState:
    region = params_for("best").region
    assert region is not None
    parts = [Part(part.truth(0)) for part in bending.parts]
    made = [Unit(Role.PART, (k,)) for k in range(2)]
    return begin(PreparedFrame(bending.read(0)), parts, made, region, (0, 1))


def test_where_the_whole_rests_its_parts_rest(on_key: FigureState) -> None:
    assert on_key.union is not None
    motion = UnionMotion.of(on_key.union, FigureParams())
    for limb in on_key.limbs:
        (found,) = motion.carried(limb.laid)
        npt.assert_allclose(found.points, limb.parts[0].points, atol=1e-6)


def test_what_shrank_away_is_lost_to_the_whole(on_key: FigureState) -> None:
    assert on_key.union is not None
    motion, laid = UnionMotion.of(on_key.union, FigureParams()), on_key.limbs[0].laid
    assert motion.keeps(laid, laid)
    for share, is_there in ((0.8, True), (0.6, False)):  # of its height and width
        assert motion.keeps([replace(part, points=share * part.points) for part in laid], laid) is is_there


def test_an_outline_that_would_cross_itself_stays_simple(on_key: FigureState) -> None:
    assert on_key.union is not None
    (outline,) = on_key.union.parts
    folded = outline.points.copy()
    folded[..., 0] = np.abs(folded[..., 0] - 70.0) + 70.0  # laid on itself
    motion = UnionMotion.of(
        replace(on_key.union, parts=(replace(outline, points=folded),), patches=None), FigureParams()
    )
    for limb in on_key.limbs:
        (found,) = motion.carried(limb.laid)
        assert np.isfinite(found.points).all()
        assert len(crossing_segments(found.points)) == 0
