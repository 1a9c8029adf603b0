"""The region of an object between two keys: what both passes and the keys say of each cell, and the picture."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid, signed_distance
from roam_core.kernels.diffusion import diffuse
from roam_core.params import RegionParams
from roam_core.propagate.between.directional_pass import Stop
from roam_core.propagate.between.endpoint_consistency import Key, carried
from roam_core.propagate.between.moment import Moment, common, mean
from roam_core.propagate.frame.contour_fit import enclosed
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


def merged_region(
    moment: Moment, parts: tuple[Part, ...], covers: Sequence[Array], colours: Colours | None
) -> Field | None:
    """The region that the estimates agree on, and the picture where no `covers` lie before it.

    None where the engine works without regions.
    """
    span = moment.span
    motions = [stop.motion for stop in (moment.onwards, moment.back) if stop is not None]
    fields = [motion.region for motion in motions if motion.region is not None]
    if not fields:
        return None
    grid = common([field.grid for field in fields])
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
    values = mean(weights, [*(field.nats_on(grid) for field in fields), _depth(moment, coverages, grid)])
    sides = [field.on(grid) > 0.5 for field in fields]
    known_inside = sides[0] | sides[1] | (enclosed(parts, grid) > 0.5)
    found = proposed.cleaned(Field(grid, values.astype(np.float32)), known_inside, 0.0, span.params.components.speck)
    return found if colours is None else _compared(moment, found, sides, coverages, covers, colours)


def _compared(
    moment: Moment,
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
        (KeyView(_in_this_light(directional_pass.picture, stop), stop.carried, grid, coverage), away)
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
        picture, views, wanted, params.span.key_colours
    )
    values += _backgrounds(moment, grid, colours.picture, ~(sides[0] | sides[1]), params)
    rough = np.where(wanted, values, found.values)
    smooth = diffuse(rough, now, wanted, params.diffusion, params.contrast, params.sweeps)
    return proposed.cleaned(Field(grid, smooth), found.inside, 0.0, params.components.speck)


def _in_this_light(key: PreparedFrame, stop: Stop) -> PreparedFrame:
    """The picture of a key as it would be in the light of the frame where a pass from it stands."""
    return key if stop.motion.key is None else stop.motion.key.light.cast(key)


def _backgrounds(moment: Moment, grid: Grid, picture: PreparedFrame, outside: Bools, params: RegionParams) -> Float32:
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


def _coverage(moment: Moment, key: Key, stop: Stop | None, grid: Grid) -> Float32:
    """The share of each cell that the region of a key encloses, carried as one piece to where a pass stands."""
    assert stop is not None
    there = zip(key.members, carried(key, stop.carried), strict=True)
    ours = [Part(points, moment.span.subtracts(k)) for k, points in there if k in moment.of_region]
    return enclosed(ours, grid)


def _depth(moment: Moment, coverages: Sequence[Float32], grid: Grid) -> Float32:
    """Nats of planar motion: the depth inside both keys' regions, each carried as one piece."""
    cells, params = float(grid.factor.mean()) * moment.span.scale, moment.span.params.span
    depths = [signed_distance(coverage > 0.5, params.depth * cells) / np.float32(cells) for coverage in coverages]
    depth = (1.0 - moment.u) * depths[0] + moment.u * depths[1]
    return np.asarray(np.clip(params.slope * depth, -SURE, SURE), dtype=np.float32)
