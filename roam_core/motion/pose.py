"""The pose of a part: where it lies, how it is turned, stretched and bent, matched on every frame to its key itself.

Nothing is carried from frame to frame but the pose and its velocity, so nothing drifts. A part that looks as it did on
its key, however it moved, is found by direct alignment (Lucas and Kanade, 1981; Baker and Matthews, "Lucas-Kanade 20
years on", 2004) of a template of sample places, in a coarse search and then ever more closely; see `kernels.posing` for
what a pose costs.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.spatial import cKDTree

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features.pyramid import Pyramid
from roam_core.kernels.posing import Costs, Prior, Samples, Ties, View, energies, refined
from roam_core.motion.template import Template, contrasts, one_in
from roam_core.params import PoseParams


@dataclass(frozen=True, eq=False)
class Surroundings:
    """What is known of a frame around a part.

    Attributes
    ----------
    pyramid : the picture. hidden : for each level where nearer parts lie.
    needs : for each level, in [0, 1], what belongs to the object and to no other part; None where that is not known.
    ties : springs to other parts. is_complete : no more than `hidden` can lie before the part. is_sought : a part that
        is lost is looked for wherever it can have gone.
    drift : how what is seen around a place `(2,)` of the last frame moved to this one, `(2,)`; None where that is not
        known.
    """

    pyramid: Pyramid
    hidden: tuple[UInt8, ...]
    needs: tuple[Float32, ...] | None = None
    ties: Ties | None = None
    is_complete: bool = True
    is_sought: bool = True
    drift: Callable[[Array], Array] | None = None


@dataclass(frozen=True, eq=False)
class Look:
    """What is seen of a part under its pose.

    Attributes
    ----------
    places : (n, 2) of the template, those in the picture and not hidden. own : (n,) which of them are the part's own.
    apart : (n,) difference of colour, of those beside it from its inside. wrong : (n,) what speaks against, in [0, 1].
    seen : share of the part's own places that are seen.
    """

    places: Array
    own: Bools
    apart: Array
    wrong: Array
    seen: float

    @property
    def unlike(self) -> float:
        """Mean share, in [0, 1], by which what is seen of the part is unlike its key; 1 where nothing is seen."""
        return float(self.wrong[self.own].mean()) if self.own.any() else 1.0

    @property
    def difference(self) -> float:
        """The median difference of colour to the key of what is seen of the part; infinite where nothing is seen."""
        return float(np.median(np.sqrt(self.apart[self.own]))) if self.own.any() else float("inf")

    @property
    def closest(self) -> float:
        """The difference of colour to the key of which a quarter of what is seen of the part stays under."""
        return float(np.quantile(np.sqrt(self.apart[self.own]), 0.25)) if self.own.any() else float("inf")

    @property
    def beside(self) -> float:
        """Mean share by which what lies outside is like the inside, in [0, 1], though it was not on the key."""
        return float(self.wrong[~self.own].mean()) if not self.own.all() else 0.0

    def against(self, inside: Bools) -> float:
        """What speaks against the pose, in [0, 1], where a region that has `inside (n,)` of the places disputes it."""
        lacking, beyond = self.own & ~inside, ~self.own & inside
        shares = [
            weight * np.count_nonzero(disputed) / max(int(np.count_nonzero(all_of)), 1)
            for weight, disputed, all_of in ((1.0, lacking, self.own), (0.5, beyond, ~self.own))
        ]
        if sum(shares) == 0:
            return 0.0
        wrong = [self.wrong[disputed].mean() if disputed.any() else 0.0 for disputed in (lacking, beyond)]
        return float(np.dot(shares, wrong) / sum(shares))


@dataclass(frozen=True, eq=False)
class Pose:
    """Where a part lies on a frame.

    Attributes
    ----------
    template : what it looks like on its key. values : (P,) as in `kernels.posing`. velocity : (P,) a frame.
    like : difference of colour at which a sample is half unlike the key: it grows with how unlike the part has been.
    cost : what the pose costs, mostly in [0, 1]. since : frames since it was no longer good.
    look : what was seen; None on the key. unclear : frames since what was seen looked clearly as on the key. is_gone :
        the part was not to be seen, and is only carried along.
    """

    template: Template
    values: Array
    velocity: Array
    like: float
    cost: float = 0.0
    since: int = 0
    look: Look | None = None
    unclear: int = 0
    is_gone: bool = False

    @classmethod
    def on_key(cls, template: Template, params: PoseParams) -> Pose:
        rest = template.chain.rest
        return cls(template, rest, rest, params.like[0])

    @property
    def unlike(self) -> float:
        """How unlike its key what is seen of the part is, in [0, 1]."""
        return 0.0 if self.look is None else self.look.unlike

    @property
    def seen(self) -> float:
        """The share of the template that is in the picture and not hidden."""
        return 1.0 if self.look is None else self.look.seen

    def spline(self, points: Array) -> Array:
        """A spline `(P, 3, 2)` of the key as it lies here."""
        return self.template.chain.spline(self.values, points)

    def carried(self, places: Array) -> Array:
        """Places `(N, 2)` of the key as they lie here."""
        return self.template.chain.carried(self.values, places)

    def support(self, places: Array) -> Array:
        """For places `(N, 2)` of the frame, in [0, 1], how well what is seen around them speaks for the pose."""
        if self.look is None or not self.look.own.any():
            return np.zeros(len(places))
        tree = cKDTree(self.look.places[self.look.own])
        nearest = tree.query(places, k=min(self.template.params.around, tree.n))[1].reshape(len(places), -1)
        return np.asarray(1.0 - self.look.wrong[self.look.own][nearest].mean(axis=1))

    def expected(self, params: PoseParams) -> Array:
        """The pose `(P,)` that the velocity leads to on the next frame; less so once it is in doubt."""
        share = params.momentum if self.since == 0 else 0.5 * params.momentum
        return np.asarray(self.values + share * self.velocity)

    def reach(self, params: PoseParams) -> float:
        """By how much farther than usual is looked on the next frame, for a part that has been in doubt."""
        return min(1.0 + self.since, params.widened)

    def step(self, around: Surroundings, params: PoseParams) -> Pose:
        """The pose on the next frame."""
        search = Search(self, around, params)
        values, cost = search.best()
        look = search.look(values)
        if around.drift is not None and look.closest >= params.gone and (self.is_gone or self.unclear < params.recent):
            return self._carried_along(search, around.drift)
        velocity = values - self.values
        velocity[2 + self.template.chain.count :] = 0.0
        since = 0 if cost <= params.lost else self.since + 1
        # What hides a part unknown must not pass for a new look of it: a pose in doubt teaches nothing there.
        is_learned = around.is_complete or since == 0
        like = self._likened(look, params) if is_learned else self.like
        unclear = 0 if look.closest < params.clear else self.unclear + 1
        return Pose(self.template, values, velocity, like, cost, since, look, unclear)

    def _carried_along(self, search: Search, drift: Callable[[Array], Array]) -> Pose:
        """On a frame where the part is not to be seen: its own motion dies away into that of what lies before it."""
        velocity = search.params.momentum * self.velocity
        places = search.template.chain.carried(self.values, search.template.levels[0].places)
        velocity[:2] += (1.0 - search.params.momentum) * drift(places)
        return self._unseen(self.values + velocity, search)

    def _unseen(self, values: Array, search: Search) -> Pose:
        """On a frame that does not show the part, taken to be under a pose `(P,)`."""
        velocity = values - self.values
        velocity[2 + self.template.chain.count :] = 0.0
        look, since = search.look(values), self.since + 1
        return replace(self, values=values, velocity=velocity, cost=1.0, since=since, look=look, is_gone=True)

    def hung(self, around: Surroundings, ties: Ties | None, params: PoseParams) -> Pose:
        """On a frame where the part is hidden: its own motion dies away, and `ties` to other parts say where it is."""
        values = self.values + params.momentum * self.velocity
        if ties is not None and ties.weights.any():
            pulls = ties.targets - self.template.chain.carried(values, ties.places)
            values[:2] += np.average(pulls, axis=0, weights=ties.weights)
        return self._unseen(values, Search(self, around, params))

    def missed(self) -> Pose:
        """After a frame that showed nothing of the part."""
        return replace(
            self, velocity=np.zeros_like(self.velocity), cost=1.0, since=self.since + 1, look=NOTHING, is_gone=True
        )

    def _likened(self, look: Look, params: PoseParams) -> float:
        if np.count_nonzero(look.own) < params.least_samples:
            return self.like
        least, most = params.like
        return min(max(0.5 * (self.like + params.like_times * look.difference), least), most)


NOTHING = Look(np.zeros((0, 2)), np.zeros(0, bool), np.zeros(0), np.zeros(0), 0.0)
"""What is seen of a part where there is nothing to be seen."""


def _cost(found: tuple[Array, float]) -> float:
    return found[1]


@dataclass(frozen=True, eq=False)
class Search:
    """The search for a part's pose on one frame, from where it was on the frame before.

    Where it `is_wide`, the part may have gone anywhere since it was last good.
    """

    before: Pose
    around: Surroundings
    params: PoseParams
    is_wide: bool = False

    @property
    def template(self) -> Template:
        return self.before.template

    @cached_property
    def reach(self) -> float:
        return self.before.reach(self.params)

    @cached_property
    def prior(self) -> Prior:
        params, count = self.params, self.template.chain.count
        reach = 1.0 + self.before.since if self.is_wide else self.reach
        move = params.expect_move * self.template.scale * reach
        turn = params.expect_turn * reach * (1.0 if count == 1 else 2.0)
        sigma = np.array([move, move, *[turn] * count, *params.expect_strain])
        most = np.array([np.inf] * (2 + count) + list(params.most_strain))
        weight = params.prior
        return Prior(
            self.before.expected(params),
            weight / sigma**2,
            weight / most**2,
            weight / params.bend**2,
            weight / params.straight**2,
        )

    def best(self) -> tuple[Array, float]:
        """The pose `(P,)` of least cost, and its cost.

        A part that is in doubt and not clearly seen is looked for wherever it can have gone meanwhile.
        """
        values, cost = self._near()
        if self.before.since == 0 or not self.around.is_sought or self.is_seen(values):
            return values, cost
        return replace(self, is_wide=True)._found_again(cost) or (values, cost)

    def is_seen(self, values: Array) -> bool:
        """Whether enough of the part is seen under a pose `(P,)`, and looks clearly as on its key."""
        look = self.look(values)
        return look.seen >= self.params.glimpse and look.closest < self.params.clear

    def _found_again(self, cost: float) -> tuple[Array, float] | None:
        """The best pose `(P,)` that costs less and under which a part that was lost is clearly seen, and its cost."""
        rough = [values for values, roughly in self._closer(self._anywhere()) if roughly < cost]
        found = [each for each in (self._refined(values, 0) for values in rough) if each[1] < cost]
        return min((each for each in found if self.is_seen(each[0])), key=_cost, default=None)

    def _near(self) -> tuple[Array, float]:
        """The pose `(P,)` of least cost near the expected one, and its cost; without and with the blur of its motion.

        Far away is looked only where the pose is not found, as sure as can be, where it is expected.
        """
        rough = self._closer([self.prior.expected, self.before.values])
        if rough[0][1] > self._sure(rough[0][0]):
            rough = sorted([*rough, *self._closer(self._coarse())], key=_cost)
        values, cost = min((self._refined(start, 0) for start, _ in self._distinct(rough, 2)), key=_cost)
        blurred = self.template.blurred(values, values - self.before.values)
        if blurred is self.template:
            return values, cost
        again, cost_again = self._refined(self._refined(values, 1, blurred)[0], 0, blurred)
        return (again, cost_again) if cost_again < cost else (values, cost)

    def settled(self, start: Array) -> Array:
        """The pose `(P,)` that is found from one that is nearly right already."""
        for level in range(self.template.coarsest - 1, -1, -1):
            start = self._refined(start, level)[0]
        return start

    def _closer(self, starts: Sequence[Array]) -> list[tuple[Array, float]]:
        """The poses that these lead to before the last level, and their costs; the best first."""
        rough = sorted((self._refined(start, self.template.coarsest) for start in starts), key=_cost)
        return sorted(
            (
                self._refined(start, self.template.coarsest - 1)
                for start, _ in self._distinct(rough, self.params.followed)
            ),
            key=_cost,
        )

    def _distinct(self, found: Sequence[tuple[Array, float]], most: int) -> list[tuple[Array, float]]:
        """The first ones of poses, the best first, that are not the same as a better one."""
        kept: list[tuple[Array, float]] = []
        for each in found:
            if len(kept) < most and all(self._is_apart(each[0], other) for other, _ in kept):
                kept.append(each)
        return kept

    def _sure(self, values: Array) -> float:
        """What a pose `(P,)` may cost to be taken without a search; what is hidden of a found part asks none."""
        if self.before.since > 0:
            return self.params.sure
        seen = self.look(values).seen
        return self.params.sure * seen + self._costs[0].hidden * (1.0 - seen)

    def look(self, values: Array) -> Look:
        """What is seen of the part under a pose `(P,)`."""
        samples, pyramid, hidden = self.template.levels[0], self.around.pyramid, self.around.hidden[0]
        own = samples.weights > 0
        places = self.template.chain.carried(values, samples.places, samples.skin)
        column, row = np.round(pyramid.to_level(places, 0)).astype(int).T
        height, width = hidden.shape
        seen = (column >= 0) & (row >= 0) & (column < width) & (row < height)
        seen &= hidden[np.clip(row, 0, height - 1), np.clip(column, 0, width - 1)] == 0
        apart = ((pyramid.colours(places, 0) - samples.colours) ** 2).sum(axis=1)
        wrong = apart / (apart + self.params.like[0] ** 2)
        alike = np.exp(-apart[~own] / (2.0 * self.params.beside_like**2))
        wrong[~own] = contrasts(samples, self.params) * alike
        share = np.count_nonzero(seen & own) / np.count_nonzero(own)
        return Look(places[seen], own[seen], apart[seen], wrong[seen], share)

    def _coarse(self) -> list[Array]:
        """The best few of a grid of poses around the expected one, well apart from each other."""
        params, scale = self.params, self.template.scale
        steps = np.arange(-params.search_move, params.search_move + 1e-6, params.search_step) * scale * self.reach
        turns = np.linspace(-params.search_turn, params.search_turn, params.search_turns) * self.reach
        return self._best_of(self._grid(steps, turns))

    def _anywhere(self) -> list[Array]:
        """The best few of a grid of poses as far around as the part can have gone since it was no longer good."""
        params, since = self.params, 1.0 + self.before.since
        length = float(np.hypot(*np.ptp(self.template.levels[0].places, axis=0)))
        step = params.search_step * self.template.scale * params.widened
        most = min(params.astray * length, params.search_move * self.template.scale * since)
        far = min(params.turned, params.search_turn * since)
        k, m = round(most / step), round(far / params.search_turn)
        poses = self._grid(step * np.arange(-k, k + 1), params.search_turn * np.arange(-m, m + 1))
        return self._best_of(poses[np.hypot(*(poses - self.prior.expected)[:, :2].T) <= step * k])

    def _grid(self, steps: NDArray[Any], turns: NDArray[Any]) -> Array:
        """Poses `(m, P)` around the expected one, with all `steps` along x and y, and all `turns`."""
        x, y, turn = (each.ravel() for each in np.meshgrid(steps, steps, turns, indexing="ij"))
        poses = np.repeat(self.prior.expected[None], len(x), axis=0)
        poses[:, 0] += x
        poses[:, 1] += y
        poses[:, 2 : 2 + self.template.chain.count] += turn[:, None]
        return poses

    def _best_of(self, poses: Array) -> list[Array]:
        """The best few of `poses (m, P)` on the coarsest level, well apart from each other."""
        params, samples = self.params, self.template.levels[self.template.coarsest]
        if self.is_wide:
            poses = self._likely(poses, params.glanced_at**2, params.glanced_at * params.looked_at)
        poses = self._likely(poses, params.glanced_at, params.looked_at)
        chosen: list[Array] = []
        for k in np.argsort(self._energies(poses, samples), kind="stable"):
            if all(self._is_apart(poses[k], other) for other in chosen):
                chosen.append(poses[k])
            if len(chosen) == params.candidates:
                break
        return chosen

    def _likely(self, poses: Array, among: int, most: int) -> Array:
        """The best of `poses (m, P)`, at most so many, by one sample `among` so many."""
        glance = self._energies(poses, one_in(among, self.template.levels[self.template.coarsest]))
        return poses[np.argsort(glance, kind="stable")[:most]]

    def _energies(self, poses: Array, samples: Samples) -> Array:
        """What `poses (m, P)` cost on the coarsest level, by some samples."""
        level = self.template.coarsest
        bones, costs = self.template.chain.bones, self._costs[level]
        if self.is_wide:  # a pose under which nothing is seen is none to find the part by
            costs = costs._replace(hidden=1.0, beyond=1.0)
        return energies(self._views[level], samples, bones, poses, costs, self.prior, self._ties)

    def _is_apart(self, a: Array, b: Array) -> bool:
        step = self.params.search_step * self.template.scale
        turn = 0.5 * self.params.search_turn / max(self.params.search_turns // 2, 1)
        return bool(
            np.hypot(*(a[:2] - b[:2])) > self.params.apart_step * step
            or abs(a[2] - b[2]) > turn * self.params.apart_turn
        )

    def _refined(self, start: Array, level: int, template: Template | None = None) -> tuple[Array, float]:
        template = self.template if template is None else template
        rounds = self.params.rounds // 2 if level == self.template.coarsest else self.params.rounds
        return refined(
            self._views[level], template.levels[level], template.chain.bones, start, self._costs[level], self.prior,
            self._ties, rounds,
        )  # fmt: skip

    @cached_property
    def _ties(self) -> Ties:
        count = self.template.chain.count
        return self.around.ties or Ties(np.zeros((0, 2)), np.zeros((0, count)), np.zeros((0, 2)), np.zeros(0), 1.0)

    @cached_property
    def _views(self) -> tuple[View, ...]:
        """The picture at each level."""
        return tuple(self._view_at(level) for level in range(len(self.template.levels)))

    def _view_at(self, level: int) -> View:
        pyramid, needs = self.around.pyramid, self.around.needs
        scale, corner = pyramid.scale_at(level), pyramid.corner
        return View(
            pyramid.levels[level], float(scale[0]), float(scale[1]), float(corner[0]), float(corner[1]),
            self.around.hidden[level], (pyramid.blank if needs is None else needs)[level],
        )  # fmt: skip

    @cached_property
    def _costs(self) -> tuple[Costs, ...]:
        """What a pose is charged at each level."""
        return tuple(self._costs_at(level) for level in range(len(self.template.levels)))

    def _costs_at(self, level: int) -> Costs:
        params = self.params
        like = max(params.like_roughly, self.before.like) if level == self.template.coarsest else self.before.like
        costs = Costs(like, params.beside_like, params.unseen, params.unseen)
        if self.around.needs is None:
            return costs
        beside = max(int(np.count_nonzero(self.template.levels[level].weights <= 0)), 1)
        return costs._replace(
            hidden=params.unseen + 0.5 * params.needless, needless=params.needless, needed=params.needed / beside
        )
