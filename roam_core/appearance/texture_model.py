"""What tells the texture of an object from that of its surroundings: randomized trees, learned on the artist's key.

Beyond the paper, whose global model p_0 knows single colours. Trees are oblivious: each asks the same few questions of
every cell, so what is seen later is learned by counting it in the leaves that the key made (after extremely randomized
trees, Geurts, Ernst and Wehenkel 2006, and random ferns, Ozuysal, Calonder, Lepetit and Fua 2010). The key's own counts
are never forgotten.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Bools, Float32, Int32
from roam_core.kernels import oblivious_trees
from roam_core.params import TextureParams


@dataclass(frozen=True, eq=False)
class TextureModel:
    """Trees over the texture of cells (`features.texture`), and what lay in their leaves.

    Attributes
    ----------
    features, bounds : (trees, levels) the test of each level: which feature, and above what.
    key : (2, trees, 2**levels) shares of the key's cells outside and inside, by leaf. since : the same of later
        frames, what is older counting less.
    """

    features: Int32
    bounds: Float32
    key: Float32
    since: Float32
    params: TextureParams

    @classmethod
    def learned(cls, texture: Float32, inside: Bools, outside: Bools, params: TextureParams) -> TextureModel | None:
        """From the texture `(F, rows, columns)` of a key, and which of its cells lie inside and outside for sure.

        None where there is nothing on one of the sides.
        """
        sides = _sampled(texture, inside, outside, params.samples)
        if not all(each.size for each in sides):
            return None
        samples = np.concatenate(sides, axis=1)
        is_inside = np.arange(samples.shape[1]) >= sides[0].shape[1]
        tests = oblivious_trees.grown(samples, is_inside, *_offered(samples, params))
        key = _shares(sides, *tests)
        return cls(*tests, key, np.zeros_like(key), params)

    def adapted(self, texture: Float32, inside: Bools, outside: Bools, rate: float) -> TextureModel:
        """After a later frame of which these cells lie inside and outside (exponential forgetting by `rate`)."""
        sides = _sampled(texture, inside, outside, self.params.samples)
        if not all(each.size for each in sides):
            return self
        keep, gain = np.float32(1.0 - rate), np.float32(rate)
        return replace(self, since=keep * self.since + gain * _shares(sides, self.features, self.bounds))

    def on_both(self, texture: Float32, inside: Bools, outside: Bools) -> TextureModel:
        """As if half of the key's cells had come from another key, of which these lie inside and outside."""
        sides = _sampled(texture, inside, outside, self.params.samples)
        if not all(each.size for each in sides):
            return self
        return replace(self, key=np.float32(0.5) * (self.key + _shares(sides, self.features, self.bounds)))

    def as_on_key(self) -> TextureModel:
        """As it was when only the key was known."""
        return replace(self, since=np.zeros_like(self.since))

    def log_ratio(self, texture: Float32, wanted: Bools, clip: float) -> Float32:
        """ln p(inside) / p(outside) of the wanted cells `(rows, columns)`, clipped to +-`clip` nats; else 0."""
        unseen = np.float32(self.params.unseen)
        outside, inside = np.float32(self.params.key) * self.key + self.since
        tables = (inside + unseen) / (inside + outside + 2.0 * unseen)
        p = oblivious_trees.mean_of_leaves(texture[:, wanted], self.features, self.bounds, tables)
        surest = np.float32(1.0 / (1.0 + np.exp(-clip)))
        p = np.clip(p, np.float32(1.0) - surest, surest)
        ratio = np.zeros(wanted.shape, np.float32)
        ratio[wanted] = np.log(p / (np.float32(1.0) - p))
        return ratio


def _offered(samples: Float32, params: TextureParams) -> tuple[Int32, Float32]:
    """The tests among which each level of each tree chooses, `(trees, levels, tests)`: features and bounds.

    A bound lies anywhere between the values of two samples drawn at random, so more of them lie where samples do.
    """
    rng = np.random.default_rng(0)
    shape = params.trees, params.levels, params.tests
    features = rng.integers(len(samples), size=shape, dtype=np.int32)
    low, high = samples[features, rng.integers(samples.shape[1], size=(2, *shape))]
    return features, np.asarray(low + rng.random(shape, dtype=np.float32) * (high - low), dtype=np.float32)


def _sampled(texture: Float32, inside: Bools, outside: Bools, most: int) -> tuple[Float32, Float32]:
    """The texture `(F, n)` of cells outside and of cells inside, at most so many of each, evenly spread."""
    cells = texture.reshape(len(texture), -1)

    def some(side: Bools) -> Float32:
        chosen = np.flatnonzero(side)
        return np.asarray(cells[:, chosen[:: max(1, -(-len(chosen) // most))]])

    return some(outside), some(inside)


def _shares(sides: tuple[Float32, Float32], features: Int32, bounds: Float32) -> Float32:
    return np.stack([oblivious_trees.shares(each, features, bounds) for each in sides])
