"""Where the points of an outline should lie between two keys, by all estimates."""

from __future__ import annotations

from roam_core.arrays import Array
from roam_core.geometry import similarity
from roam_core.propagate.between.bridging import between
from roam_core.propagate.between.moment import Moment, apart, are_apart, mean


def _planar(moment: Moment, k: int) -> Array:
    """The two keys of an outline, each carried as one piece, and what is left of their difference in proportion."""
    assert moment.onwards is not None
    assert moment.back is not None
    first, last = moment.span.first.parts[k], moment.span.last.parts[k]
    assert first is not None
    assert last is not None
    ahead = similarity.apply(moment.onwards.carried[:2], first.points)
    behind = similarity.apply(moment.back.carried[:2], last.points)
    return (1.0 - moment.u) * ahead + moment.u * behind


def expected(moment: Moment, k: int) -> Array:
    """The points of an outline by all estimates, each weighted by how near it came to the other key."""
    there, here = moment.there.get(k), moment.here.get(k)
    if there is None or here is None or moment.span.residuals is None:
        only = here if there is None else there
        assert only is not None
        return only
    if moment.is_posed(k):
        return _seen_or_bridged(moment, k) if moment.is_lone else _by_poses(moment, k)
    planar = _planar(moment, k)
    if moment.span.is_planar:
        return planar
    if are_apart(there, here, moment.span.params.span.apart_by):
        return there if moment.u < 0.5 else here
    weights = moment.weights(*(residual.of(k) for residual in moment.span.residuals))
    return mean([weight[:, None, None] for weight in weights], [there, here, planar])


def _seen_or_bridged(moment: Moment, k: int) -> Array:
    """The points of an outline by the poses that are believed; where none is, between the nearest frames with one."""
    onwards, back = moment.span.believed[k]
    ahead, behind = moment.frame in onwards, moment.frame in back
    if ahead and behind:
        return _by_poses(moment, k)
    if ahead or behind:
        return moment.there[k] if ahead else moment.here[k]
    before = max(frame for frame in onwards | back if frame < moment.frame)
    after = min(frame for frame in onwards | back if frame > moment.frame)
    ends = [_seen_or_bridged(Moment.of(moment.span, frame), k) for frame in (before, after)]
    return between(ends[0], ends[1], (moment.frame - before) / (after - before), moment.span.params.span.places)


def _by_poses(moment: Moment, k: int) -> Array:
    """The points of an outline that was carried by its pose from either end: the mean where they agree, else the
    better.

    One that is more likely wrong than right, and the other not, does not count: it lost the part, and may have found it
    again on the other key. Each counts the more the less its pose costs, the nearer its key is, and the nearer it came
    to the other one.
    """
    there, here, params = moment.there[k], moment.here[k], moment.span.params.span
    assert moment.span.residuals is not None
    likely = moment.span.is_likely(k, moment.onwards, moment.span.first)
    if likely != moment.span.is_likely(k, moment.back, moment.span.last):
        return there if likely else here
    onwards, back = (residual.of(k) for residual in moment.span.residuals[:2])
    doubts = [params.unposed if cost is None else cost for cost in moment.costs[k]]
    ahead = (1.0 - moment.u) / (params.sure_of + onwards * moment.u) / (params.sure_cost + doubts[0])
    behind = moment.u / (params.sure_of + back * (1.0 - moment.u)) / (params.sure_cost + doubts[1])
    if apart(there, here, moment.span.scale) > params.alike:
        return there if ahead.mean() >= behind.mean() else here
    return mean([ahead[:, None, None], behind[:, None, None]], [there, here])
