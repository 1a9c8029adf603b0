"""Two passes made one: the outlines of a span on one frame between its keys."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from typing import Any

import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid, signed_distance
from roam_core.geometry import bezier, similarity
from roam_core.geometry.simple import simplified
from roam_core.kernels.diffusion import diffuse
from roam_core.params import RegionParams
from roam_core.propagate.between.bridging import between
from roam_core.propagate.between.directional_pass import Stop
from roam_core.propagate.between.endpoint_consistency import Key, Span, carried, grid_over, stop_at
from roam_core.propagate.frame.confidence import SpanFeatures, expected_overlap, overlap, vertex_confidence
from roam_core.propagate.frame.contour_fit import enclosed, fitted, spline_coverage
from roam_core.propagate.frame.covering import covered
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import SURE, Field, uncertain_band
from roam_core.proposal.cues.key_colours import key_colours
from roam_core.proposal.cues.key_view import KeyView, lab
from roam_core.proposal.segment import region as proposed


@dataclass(frozen=True, eq=False)
class Colours:
    """The picture of the frame, to be compared with both keys (`key_colours`), and how far that is heard."""

    picture: PreparedFrame
    params: RegionParams


@dataclass(frozen=True, eq=False)
class Merged:
    """One outline on one frame: its points `(P, 3, 2)`, confidence in [0, 1], and the same for each point `(P,)`.

    `features` is what speaks against the frame; None where a single pass knows of it.
    """

    points: Array
    confidence: float
    vertex_confidence: Array
    features: SpanFeatures | None = None

    @property
    def unseen(self) -> Merged:
        """The same where the picture shows nothing: whatever was found there is not to be trusted."""
        return replace(self, confidence=0.0, vertex_confidence=np.zeros_like(self.vertex_confidence))


@dataclass(frozen=True, eq=False)
class _Moment:
    """A `frame` of a span: how far along it lies, in (0, 1), where both passes stand, and their points by outline.

    `of_region` are the outlines that a pass fitted to the object's region.
    """

    span: Span
    frame: int
    u: float
    onwards: Stop | None
    back: Stop | None
    there: dict[int, Array]
    here: dict[int, Array]
    costs: dict[int, tuple[float | None, float | None]]
    of_region: frozenset[int]

    @classmethod
    def of(cls, span: Span, frame: int) -> _Moment:
        onwards, back = stop_at(span.onwards, frame), stop_at(span.back, frame)
        there = {} if onwards is None else dict(zip(span.first.members, onwards.points, strict=True))
        here = {} if back is None else dict(zip(span.last.members, back.points, strict=True))
        u = (frame - span.first.frame) / (span.last.frame - span.first.frame)
        costs_there = {} if onwards is None else dict(zip(span.first.members, onwards.motion.pose_costs, strict=True))
        costs_here = {} if back is None else dict(zip(span.last.members, back.motion.pose_costs, strict=True))
        costs = {k: (costs_there.get(k), costs_here.get(k)) for k in there.keys() | here.keys()}
        ends = ((onwards, span.first), (back, span.last))
        of_region = [np.array(key.members)[list(stop.motion.of_region)] for stop, key in ends if stop is not None]
        return cls(
            span, frame, u, onwards, back, there, here, costs, frozenset(np.concatenate([[], *of_region]).astype(int))
        )

    def is_posed(self, k: int) -> bool:
        """True where a pass carried an outline by its pose."""
        return any(cost is not None for cost in self.costs[k])

    @property
    def is_lone(self) -> bool:
        """True of a shape on its own: what hides it is not known."""
        return any(stop.motion.by_pose is not None for stop in (self.onwards, self.back) if stop is not None)

    @property
    def is_one_piece(self) -> bool:
        """True where both passes only moved what was drawn, to the same place: fitted to a region it would lose."""
        motions = [stop.motion for stop in (self.onwards, self.back) if stop is not None and stop.motion.as_one_piece]
        fields = [motion.region for motion in motions if motion.region is not None]
        if len(fields) < 2:
            return False
        grid = _common([field.grid for field in fields])
        return overlap(fields[0].on(grid) > 0.5, fields[1].on(grid) > 0.5) >= self.span.params.span.agreed

    def weights(self, onwards: Any, back: Any, planar_there: Any, planar_here: Any) -> list[Any]:
        """How much each estimate counts where it missed by so many pixels: the passes from both ends, planar motion.

        An error is taken to grow evenly on the way from a key to the other; that of planar motion, which meets both
        keys, to be the greatest in the middle. On a key only what starts there counts.
        """
        bulge, params = 2.0 * float(np.sqrt(self.u * (1.0 - self.u))), self.span.params.span
        return [
            (1.0 - self.u) / (params.sure_of + onwards * self.u),
            self.u / (params.sure_of + back * (1.0 - self.u)),
            params.planar * bulge / (params.sure_of + 0.5 * (planar_there + planar_here) * bulge),
        ]


def merged(
    span: Span, frame: int, alive: Collection[int] | None = None, colours: Colours | None = None
) -> list[Merged | None]:
    """Every outline of the span on a frame between the keys; None for one that neither pass brought there.

    `alive` are those that there are on the frame; None: all. What the others enclosed on a key belongs to the object
    all the same, and goes to these. `colours` make the frame's picture speak; None: what was drawn and carried does.
    """
    moment = _Moment.of(span, frame)
    wanted = range(len(span.first.parts)) if alive is None else sorted(alive)
    known = [k for k in wanted if k in moment.there or k in moment.here]
    result: list[Merged | None] = [None] * len(span.first.parts)
    if not known:
        return result
    parts = tuple(Part(_expected(moment, k), span.subtracts(k)) for k in known)
    outlines = _along_region(moment, dict(zip(known, parts, strict=True)), colours)
    together = [k for k in known if not moment.is_posed(k)]
    features_together = _span_features(moment, together, [outlines[k] for k in together])
    for k, part in outlines.items():
        features = _features_of_one(moment, k, part.points) if moment.is_posed(k) else features_together
        trust = span.params.confidence
        confidence = _alone(moment) if features is None else expected_overlap(features, params=trust)
        vertices = vertex_confidence(_support(moment, k, len(part.points)), confidence, trust)
        result[k] = Merged(part.points, confidence, vertices, features)
    return result


def _along_region(moment: _Moment, parts: Mapping[int, Part], colours: Colours | None) -> dict[int, Part]:
    """The outlines, simple; those of the object's region fitted to the one that the estimates agree on."""
    span, ours = moment.span, [k for k in parts if k in moment.of_region]
    covers = [bezier.flatten(part.points) for k, part in parts.items() if k not in ours]
    region = None
    if ours and not span.is_planar and not moment.is_one_piece:
        region = _region(moment, tuple(parts[k] for k in ours), covers, colours)
    begun = dict(parts)
    points = {k: part.points for k, part in parts.items()}
    if region is not None:
        begun |= {k: _where_more_is(moment, k, parts[k], region) for k in ours}
        constraints = [span.constraints(k, moment.u) for k in ours]
        placed = fitted(tuple(begun[k] for k in ours), constraints, region, span.scale, span.params)
        points |= {k: each for k, (each, _) in zip(ours, placed, strict=True)}
    untying = span.params.contour_fit.untying
    return {
        k: replace(part, points=simplified(points[k], part.points, span.scale, untying)) for k, part in begun.items()
    }


def _planar(moment: _Moment, k: int) -> Array:
    """The two keys of an outline, each carried as one piece, and what is left of their difference in proportion."""
    assert moment.onwards is not None
    assert moment.back is not None
    first, last = moment.span.first.parts[k], moment.span.last.parts[k]
    assert first is not None
    assert last is not None
    ahead = similarity.apply(moment.onwards.carried[:2], first.points)
    behind = similarity.apply(moment.back.carried[:2], last.points)
    return (1.0 - moment.u) * ahead + moment.u * behind


def _mean(weights: Sequence[Any], values: Sequence[Any]) -> Array:
    return np.asarray(sum(w * v for w, v in zip(weights, values, strict=True)) / sum(weights))


def _expected(moment: _Moment, k: int) -> Array:
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
    if _are_apart(there, here, moment.span.params.span.apart_by):
        return there if moment.u < 0.5 else here
    weights = moment.weights(*(residual.of(k) for residual in moment.span.residuals))
    return _mean([weight[:, None, None] for weight in weights], [there, here, planar])


def _seen_or_bridged(moment: _Moment, k: int) -> Array:
    """The points of an outline by the poses that are believed; where none is, between the nearest frames with one."""
    onwards, back = moment.span.believed[k]
    ahead, behind = moment.frame in onwards, moment.frame in back
    if ahead and behind:
        return _by_poses(moment, k)
    if ahead or behind:
        return moment.there[k] if ahead else moment.here[k]
    before = max(frame for frame in onwards | back if frame < moment.frame)
    after = min(frame for frame in onwards | back if frame > moment.frame)
    ends = [_seen_or_bridged(_Moment.of(moment.span, frame), k) for frame in (before, after)]
    return between(ends[0], ends[1], (moment.frame - before) / (after - before), moment.span.params.span.places)


def _by_poses(moment: _Moment, k: int) -> Array:
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
    apart = np.hypot(*(there - here)[:, bezier.ANCHOR].T).mean() / moment.span.scale
    if apart > params.alike:
        return there if ahead.mean() >= behind.mean() else here
    return _mean([ahead[:, None, None], behind[:, None, None]], [there, here])


def _where_more_is(moment: _Moment, k: int, part: Part, region: Field) -> Part:
    """An outline that the passes took to different components of an object goes to the greater of them."""
    places = [points[k] for points in (moment.there, moment.here) if k in points]
    if len(places) < 2 or not _are_apart(places[0], places[1], moment.span.params.span.apart_by):
        return part
    shares = [float(spline_coverage(points, region.grid)[region.inside].sum()) for points in places]
    return replace(part, points=places[int(np.argmax(shares))])


def _are_apart(there: Array, here: Array, by: float) -> bool:
    """True where the passes followed different components of an object: between them lies nothing."""
    middles = [points[:, bezier.ANCHOR].mean(axis=0) for points in (there, here)]
    size = np.sqrt(min(float(np.prod(np.ptp(points[:, bezier.ANCHOR], axis=0))) for points in (there, here)))
    return bool(np.hypot(*(middles[0] - middles[1])) > by * size)


def _region(moment: _Moment, parts: tuple[Part, ...], covers: Sequence[Array], colours: Colours | None) -> Field | None:
    """The region that the estimates agree on, and the picture where no `covers` lie before it.

    None where the engine works without regions.
    """
    span = moment.span
    motions = [stop.motion for stop in (moment.onwards, moment.back) if stop is not None]
    fields = [motion.region for motion in motions if motion.region is not None]
    if not fields:
        return None
    grid = _common([field.grid for field in fields])
    if len(fields) == 1 or span.residuals is None:
        nats = np.mean([field.nats_on(grid) for field in fields], axis=0)
        return Field(grid, nats.astype(np.float32))
    assert moment.onwards is not None
    assert moment.back is not None
    to_first, to_last = moment.onwards.carried, moment.back.carried
    onwards, back, planar_there, planar_here = span.residuals
    weights = moment.weights(
        onwards.on(grid, to_last),
        back.on(grid, to_first),
        planar_there.on(grid, to_last),
        planar_here.on(grid, to_first),
    )
    coverages = [
        _coverage(moment, key, stop, grid) for key, stop in ((span.first, moment.onwards), (span.last, moment.back))
    ]
    values = _mean(weights, [*(field.nats_on(grid) for field in fields), _depth(moment, coverages, grid)])
    sides = [field.on(grid) > 0.5 for field in fields]
    known_inside = sides[0] | sides[1] | (enclosed(parts, grid) > 0.5)
    found = proposed.cleaned(Field(grid, values.astype(np.float32)), known_inside, 0.0, span.params.components.speck)
    return found if colours is None else _compared(moment, found, sides, coverages, covers, colours)


def _compared(
    moment: _Moment,
    found: Field,
    sides: Sequence[Bools],
    coverages: Sequence[Float32],
    covers: Sequence[Array],
    colours: Colours,
) -> Field:
    """The region when the picture has spoken, too: near its border, and wherever the passes disagree."""
    span, grid, params = moment.span, found.grid, colours.params
    picture = grid.colours_of(colours.picture)
    now = lab(picture)
    views = [
        (KeyView(_in_this_light(directional_pass.picture, stop), stop.carried, coverage), away)
        for directional_pass, stop, coverage, away in zip(
            (span.onwards, span.back), (moment.onwards, moment.back), coverages, (moment.u, 1.0 - moment.u), strict=True
        )
        if directional_pass is not None and stop is not None
    ]
    near = uncertain_band(found.inside, found.inside, params.band)
    wanted = near | uncertain_band(sides[0] & sides[1], sides[0] | sides[1], params.span.beside)
    hidden = covered(covers, grid)
    if hidden is not None:
        wanted &= ~hidden
    carried_here = np.where(sides[0] ^ sides[1], np.float32(params.span.disputed) * found.values, found.values)
    values = carried_here + np.float32(params.keys_weight) * key_colours(
        picture, grid, views, wanted, params.span.key_colours
    )
    values += _backgrounds(moment, grid, colours.picture, ~(sides[0] | sides[1]), params)
    rough = np.where(wanted, values, found.values)
    smooth = diffuse(rough, now, wanted, params.diffusion, params.contrast, params.sweeps)
    return proposed.cleaned(Field(grid, smooth), found.inside, 0.0, params.components.speck)


def _in_this_light(key: PreparedFrame, stop: Stop) -> PreparedFrame:
    """The picture of a key as it would be in the light of the frame where a pass from it stands."""
    return key if stop.motion.key is None else key.multiplied(stop.motion.key.light.gains)


def _backgrounds(moment: _Moment, grid: Grid, picture: PreparedFrame, outside: Bools, params: RegionParams) -> Float32:
    """What the backgrounds of both keys say of each cell, nats; where both know it, the nearer key the more.

    `picture` is the frame's, `outside (rows, columns)` the cells that neither pass has in the object.
    """
    told, known = np.zeros(grid.shape, np.float32), np.zeros(grid.shape, np.float32)
    if params.background is None:
        return told
    for stop, nearness in ((moment.onwards, 1.0 - moment.u), (moment.back, moment.u)):
        if stop is None or stop.motion.key is None:
            continue
        background = stop.motion.key.background(grid)
        now = lab(grid.colours_of(stop.motion.key.in_its_light(picture)))
        weight = np.float32(nearness) * background.known
        told += weight * background.log_ratio(now, outside, params.background)
        known += weight
    return np.asarray(told / np.maximum(known, np.finfo(np.float32).tiny), dtype=np.float32)


def _coverage(moment: _Moment, key: Key, stop: Stop | None, grid: Grid) -> Float32:
    """The share of each cell that the region of a key encloses, carried as one piece to where a pass stands."""
    assert stop is not None
    there = zip(key.members, carried(key, stop.carried), strict=True)
    ours = [Part(points, moment.span.subtracts(k)) for k, points in there if k in moment.of_region]
    return enclosed(ours, grid)


def _depth(moment: _Moment, coverages: Sequence[Float32], grid: Grid) -> Float32:
    """Nats of planar motion: the depth inside both keys' regions, each carried as one piece."""
    cells, params = float(grid.factor.mean()) * moment.span.scale, moment.span.params.span
    depths = [signed_distance(coverage > 0.5, params.depth * cells) / np.float32(cells) for coverage in coverages]
    depth = (1.0 - moment.u) * depths[0] + moment.u * depths[1]
    return np.asarray(np.clip(params.slope * depth, -SURE, SURE), dtype=np.float32)


def _common(grids: list[Grid]) -> Grid:
    """A grid over all of these, as fine as the finest."""
    areas = [grid.region for grid in grids]
    region = Region(
        min(area.x0 for area in areas),
        min(area.y0 for area in areas),
        max(area.x1 for area in areas),
        max(area.y1 for area in areas),
    )
    return Grid.over(region, max(float(grid.factor.max()) for grid in grids))


def _span_features(moment: _Moment, known: list[int], outlines: list[Part]) -> SpanFeatures | None:
    """What speaks against the merged outlines; None where a pass did not arrive, and nothing can be compared."""
    span = moment.span
    if not known or span.residuals is None or moment.onwards is None or moment.back is None:
        return None
    onwards, back, _, _ = span.residuals
    return _features(moment, known, outlines, 0.5 * (onwards.loss + back.loss))


def _features_of_one(moment: _Moment, k: int, points: Array) -> SpanFeatures | None:
    """What speaks against one outline that was carried by its pose; None where only one pass knows of it."""
    if k not in moment.span.losses or k not in moment.there or k not in moment.here:
        return None
    return _features(moment, [k], [Part(points)], moment.span.losses[k])


def _features(moment: _Moment, known: list[int], outlines: list[Part], missed: float) -> SpanFeatures:
    """What speaks against outlines, beside what each pass says of them; `missed` is by how much the keys were."""
    span = moment.span
    ends = ((moment.onwards, span.first, moment.there), (moment.back, span.last, moment.here))
    sides, trusts = [], []
    for stop, key, points in ends:
        ours = [k for k in known if k in points]
        if stop is not None and ours:
            sides.append([Part(points[k], span.subtracts(k)) for k in ours])
            trusts.append(float(np.mean([stop.confidence[key.members.index(k)] for k in ours])))
    splines = [part.points for side in (outlines, *sides) for part in side]
    grid = grid_over(splines, span.size, span.params.span.endpoint_consistency.look, span.scale)
    merged, *theirs = (enclosed(side, grid) > 0.5 for side in (outlines, *sides))
    overlaps = [overlap(merged, each) for each in theirs]
    nearer = int(np.argmax(overlaps))
    return SpanFeatures.of(missed, overlaps[nearer], trusts[nearer], span.params.confidence)


def _alone(moment: _Moment) -> float:
    """Where one pass only speaks: what it was trusted there."""
    stops = [stop.confidence for stop in (moment.onwards, moment.back) if stop is not None]
    return float(np.mean(np.concatenate(stops))) if stops else 0.0


def _support(moment: _Moment, k: int, count: int) -> Array:
    """For each point of an outline, in [0, 1]: how near the points of the two passes are to each other."""
    there, here = moment.there.get(k), moment.here.get(k)
    if there is None or here is None:
        return np.full(count, 0.5)
    apart = np.hypot(*(there - here)[:, bezier.ANCHOR].T) / moment.span.scale
    return np.asarray(1.0 / (1.0 + apart / moment.span.params.span.apart))
