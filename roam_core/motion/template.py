"""Template: what a part looks like on its key, as sample places with their colours, on bones."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import polyline
from roam_core.geometry.skinning import Chain
from roam_core.kernels.posing import Samples
from roam_core.params import PoseParams


@dataclass(frozen=True, eq=False)
class Template:
    """What a part looks like on its key.

    Attributes
    ----------
    chain : its bones. pyramid : the key's picture around it, for the colours under motion blur.
    levels : the samples of each level of a pyramid, finest first; the coarsest has fewer.
    scale : `params.scale_for` of the picture. seam : share of its outline beside which nothing changes, in [0, 1].
    densest_seam : the same of the stretch of it, `params.stretch` long, that has most. A limb hangs on there; what has
        its ground's colours here and there all around does not.
    area : what the outline encloses, square pixels. params : by which it was made.
    is_own : the look is that of its own key; else of another one (`laid_on`), and is not blurred by motion.
    """

    chain: Chain
    pyramid: Pyramid
    levels: tuple[Samples, ...]
    scale: float
    seam: float
    densest_seam: float
    area: float
    params: PoseParams
    is_own: bool = True

    @classmethod
    def of(
        cls, pyramid: Pyramid, line: Array, params: PoseParams, scale: float, covers: Sequence[Array] = ()
    ) -> Template | None:
        """Of the part inside the closed polyline `line (K, 2)`, without what `covers`, other polylines, hide of it.

        None where too little of it is seen.
        """
        chain = Chain.of(line, params.joints, params.bones)
        inside = _seen_places(pyramid, line, params.least_samples, covers)
        if len(inside) < params.least_samples:
            return None
        fine, coarse = (_chosen(inside, most) for most in (params.samples, params.samples // 4))
        beside, within = _beside(pyramid, line, params.beside_at * scale, covers)
        count = len(pyramid.levels)
        levels = [
            _samples(pyramid, level, fine if level < count - 1 else coarse, beside, within, chain, params)
            for level in range(count)
        ]
        flat = contrasts(levels[0], params) < 0.5
        seam = float(np.mean(flat)) if len(flat) else 1.0
        area = abs(float(polyline.signed_area(line)))
        return cls(chain, pyramid, tuple(levels), scale, seam, _densest(flat, params.stretch), area, params)

    def where(self, is_own: Callable[[Array], Bools]) -> Template | None:
        """The template without those places `(N, 2)` inside the outline that `is_own` says are not the part's.

        None where too few are left.
        """
        levels = [_kept(samples, is_own(samples.places) | (samples.weights <= 0)) for samples in self.levels]
        if any(np.count_nonzero(samples.weights > 0) < self.params.least_samples for samples in levels):
            return None
        return replace(self, levels=tuple(levels))

    def laid_on(self, other: Template, pose: Array) -> Template:
        """The template of another key of the part, on which it lies under `pose (P,)`, with the look of this one."""
        levels = []
        for samples in self.levels:
            places = self.chain.carried(pose, samples.places, samples.skin)
            levels.append(samples._replace(places=places, skin=other.chain.skin(places)))
        return replace(other, levels=tuple(levels), seam=self.seam, densest_seam=self.densest_seam, is_own=False)

    @property
    def coarsest(self) -> int:
        """The number of the last level."""
        return len(self.levels) - 1

    def blurred(self, pose: Array, velocity: Array) -> Template:
        """The template as it looks while it moves through `pose (P,)` with `velocity (P,)` a frame.

        The very same one where no streak is longer than a cell, or the look is another key's.
        """
        if not self.is_own:
            return self
        levels = tuple(self._streaked(level, pose, velocity) for level in range(self.coarsest))
        if all(streaked is sharp for streaked, sharp in zip(levels, self.levels, strict=False)):
            return self
        return replace(self, levels=(*levels, self.levels[self.coarsest]))

    def _streaked(self, level: int, pose: Array, velocity: Array) -> Samples:
        samples = self.levels[level]
        ends = [
            self.chain.carried(pose + side * 0.5 * self.params.shutter * velocity, samples.places, samples.skin)
            for side in (1.0, -1.0)
        ]
        way = ends[0] - ends[1]
        if float(np.hypot(*way.T).max()) * float(self.pyramid.scale_at(0).mean()) < 1.0:
            return samples
        back = np.linalg.inv(self.chain.root(pose))
        on_key = way @ back.T
        taps = [
            self.pyramid.colours(samples.places - moment * on_key, level)
            for moment in np.linspace(-0.5, 0.5, self.params.taps)
        ]
        own = samples.weights > 0
        return samples._replace(colours=np.where(own[:, None], np.mean(taps, axis=0), samples.colours))


def _seen_places(pyramid: Pyramid, line: Array, least: int, covers: Sequence[Array]) -> Array:
    """The centres `(N, 2)` of the finest cells inside an outline, away from its edge where it is wide enough."""
    (mask, *_), (hidden, *_) = pyramid.outlined([line]), pyramid.outlined(list(covers))
    seen = (mask > 0) & (hidden == 0)
    core = _eroded(seen)
    rows, columns = np.nonzero(core if np.count_nonzero(core) >= 3 * least else seen)
    cells = np.stack([columns, rows], axis=1) + 0.5
    return np.asarray(cells / pyramid.scale_at(0) + pyramid.corner)


def _eroded(mask: Bools) -> Bools:
    """A mask without its rim."""
    core = mask.copy()
    core[1:] &= mask[:-1]
    core[:-1] &= mask[1:]
    core[:, 1:] &= mask[:, :-1]
    core[:, :-1] &= mask[:, 1:]
    return core


def _chosen(places: Array, most: int) -> Array:
    """At most so many of `places (N, 2)`, without a pattern; the same ones every time."""
    if len(places) <= most:
        return places
    return places[np.random.default_rng(0).permutation(len(places))[:most]]


def _beside(pyramid: Pyramid, line: Array, away: float, covers: Sequence[Array]) -> tuple[Array, Array]:
    """Places `(M, 2)` outside an outline, so many pixels away, and those as far inside; without what is covered."""
    rim = polyline.resample(line, max(8, round(polyline.length(line) / away)))
    normals = polyline.outward_normals(rim)
    outside, inside = rim + away * normals, rim - away * normals
    (hidden, *_) = pyramid.outlined(list(covers))
    height, width = hidden.shape
    free = np.ones(len(rim), dtype=bool)
    for places in (outside, inside):
        column, row = np.round(pyramid.to_level(places, 0)).astype(int).T
        free &= (column >= 0) & (row >= 0) & (column < width) & (row < height)
        free &= hidden[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)] == 0
    return outside[free], inside[free]


def _densest(ring: Bools, stretch: float) -> float:
    """The greatest share of True in a `stretch`, a share itself, of a closed `ring (M,)`; 1 for an empty one."""
    count = max(1, round(stretch * len(ring)))
    sums = np.cumsum(np.concatenate([[0], ring, ring[:count]]))
    return float((sums[count:] - sums[:-count]).max()) / count if len(ring) else 1.0


def _samples(
    pyramid: Pyramid, level: int, inside: Array, beside: Array, within: Array, chain: Chain, params: PoseParams
) -> Samples:
    own, there = pyramid.colours(within, level), pyramid.colours(beside, level)
    unlike = contrast(own, there, params)
    places = np.vstack([inside, beside])
    weights = np.concatenate([np.full(len(inside), 1.0 / len(inside)), -params.beside * unlike / max(len(beside), 1)])
    return Samples(places, np.vstack([pyramid.colours(inside, level), own]), weights, chain.skin(places))


def contrast(own: Array, there: Array, params: PoseParams) -> Array:
    """How much colours `own (M, 3)` inside an outline differ from those beside it, in [0, 1] each `(M,)`."""
    return np.asarray(1.0 - np.exp(-((own - there) ** 2).sum(axis=1) / (2.0 * params.beside_like**2)))


def _kept(samples: Samples, keep: Bools) -> Samples:
    """Those samples that are to be kept; the weights of the part's own add up to one again."""
    places, colours, weights, skin = (each[keep] for each in samples)
    total = float(weights[weights > 0].sum())
    return Samples(places, colours, np.where(weights > 0, weights / max(total, 1e-9), weights), skin)


def one_in(count: int, samples: Samples) -> Samples:
    """One of so many samples, with as many times the weight."""
    places, colours, weights, skin = (each[::count] for each in samples)
    return Samples(places, colours, count * weights, skin)


def contrasts(samples: Samples, params: PoseParams) -> Array:
    """For each place beside the outline `(M,)`, in [0, 1], how much it differed from the inside on the key."""
    weights = samples.weights[samples.weights <= 0]
    return np.asarray(-weights * len(weights) / max(params.beside, 1e-9))
