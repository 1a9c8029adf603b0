"""A rigid mode: as long as an object's inside looks as on the artist's key, moved as a plane moves, so do its curves.

Beyond the paper. Curves that are fitted to a region anew on every frame lose what is thinner than its cells, and what
is lost does not come back; a motion that is matched to the key itself adds nothing up. It is believed where most of the
key's corners are found where it says (`RegionParams.rigid`), so each object, on each frame, chooses for itself.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier, projective, similarity
from roam_core.geometry.plane_motion import PlaneMotion, fit
from roam_core.motion.planar import Match, Reference
from roam_core.params import RigidityParams, scale_for
from roam_core.propagate.frame.confidence import ConfidenceFeatures
from roam_core.propagate.frame.result import Part
from roam_core.propagate.whole.cut_off import CutOff


@dataclass(frozen=True, eq=False)
class PlanePose:
    """Where the object lies as one piece: the motion of a plane `matrix (3, 3)` from the key, and what it rests on."""

    matrix: Array
    match: Match
    params: RigidityParams

    @property
    def similarity(self) -> Array:
        """The similarity `(3, 3)` from the key that comes nearest to it."""
        fitted = similarity.fit(self.match.agreeing, projective.apply(self.matrix, self.match.agreeing))
        return np.vstack([fitted, [0.0, 0.0, 1.0]])

    def carried(self, drawn: tuple[Part, ...]) -> tuple[Part, ...]:
        """The parts as `drawn` on the key, where they lie now."""
        return tuple(replace(part, points=projective.apply(self.matrix, part.points)) for part in drawn)

    def support(self, drawn: Part) -> Array:
        """For each anchor `(P,)` of a part as drawn, the share of the corners around it that agree, in [0, 1]."""
        anchors, match = drawn.points[:, bezier.ANCHOR], self.match
        away = _distances(anchors, match.sought)
        reach = np.sort(away, axis=1)[:, min(self.params.nearest, away.shape[1]) - 1]
        all_of = np.exp(-((away / reach[:, None]) ** 2)).sum(axis=1)
        agreeing = np.exp(-((_distances(anchors, match.agreeing) / reach[:, None]) ** 2)).sum(axis=1)
        return np.asarray(np.clip(agreeing / all_of, 0.0, 1.0))

    def features(self, inside: Bools, frames: int) -> ConfidenceFeatures:
        """What speaks against it, so many frames after the key, where it covers the cells `inside (rows, columns)`."""
        return ConfidenceFeatures.of_one_piece(1.0 - self.match.agreement, inside, frames)


@dataclass(frozen=True, eq=False)
class Rigidity:
    """The key's corners, where the object was expected as one piece on the last frame, and since when in vain.

    `cut_off` is where the edge of the key's picture cut the object off.
    """

    reference: Reference
    cut_off: CutOff
    matrix: Array
    params: RigidityParams
    missed: int = 0
    held: bool = False

    @classmethod
    def learned(cls, key: PreparedFrame, parts: tuple[Part, ...], params: RigidityParams) -> Rigidity:
        """From the key's picture and its outlines."""
        solid, holes = ([part.points for part in parts if part.subtracts is cut] for cut in (False, True))
        reference = Reference.of(key, solid, holes, params=params.planar, count=params.corners)
        return cls(reference, CutOff.of(solid, key.size, params), projective.IDENTITY, params)

    def at(self, matrix: Array) -> Rigidity:
        """The same with the object elsewhere, by `matrix (3, 3)` from the key."""
        return replace(self, matrix=matrix, missed=0, held=False)

    def step(self, frame: PreparedFrame, moved: Array, least: float) -> tuple[Rigidity, PlanePose | None]:
        """Look for the object as one piece on `frame`, to which it `moved (3, 3)`; None where it is not to be seen.

        `least` is the share of the corners that must agree.
        """
        if self.missed >= self.params.given_up:
            return self, None
        guess = projective.usable(moved @ self.matrix)
        if guess is None:
            return replace(self, missed=self.params.given_up, held=False), None
        match = self.reference.matched(
            frame, guess, PlaneMotion.HOMOGRAPHY, self.params.tolerance * scale_for(frame.size)
        )
        least *= self.params.still if self.held else 1.0
        if match is None or not self._is_believed(match, guess, least) or self._is_opened(match, frame.size):
            return replace(self, matrix=guess, missed=self.missed + 1, held=False), None
        matrix = _simplest(match, self.params.simpler)
        return replace(self, matrix=matrix, missed=0, held=True), PlanePose(matrix, match, self.params)

    def _is_believed(self, match: Match, guess: Array, least: float) -> bool:
        corners = self.reference.corners
        if match.agreement < least or len(match.agreeing) < max(
            self.params.fewest, self.params.as_one * match.followed
        ):
            return False
        if (
            len(match.sought) < self.params.least_seen * len(corners)
            or (projective.depth(match.matrix, corners) <= 0.0).any()
        ):
            return False
        before, after = (_extent(projective.apply(way, corners)) for way in (guess, match.matrix))
        return before / self.params.resized < after < before * self.params.resized

    def _is_opened(self, match: Match, size: tuple[int, int]) -> bool:
        """True where more of the object has come into the picture than the key knows of."""
        return self.cut_off.is_in_sight(lambda places: projective.apply(match.matrix, places), size)


def _simplest(match: Match, simpler: float) -> Array:
    """The simplest motion `(3, 3)` that says nearly as well as the matched one where the agreeing corners are.

    It may miss them `simpler` times as far.
    """
    least = _missed(match.matrix, match)
    for kind in (PlaneMotion.SIMILARITY, PlaneMotion.AFFINE):
        matrix = fit(kind, match.agreeing, match.there)
        if matrix is not None and _missed(matrix, match) <= simpler * least:
            return matrix
    return match.matrix


def _missed(matrix: Array, match: Match) -> float:
    """Root mean square, in pixels, of how far a motion misses where the agreeing corners are."""
    return float(np.sqrt(np.mean((projective.apply(matrix, match.agreeing) - match.there) ** 2)))


def _extent(corners: Array) -> float:
    """How far points spread, as an area."""
    return float(np.prod(np.std(corners, axis=0)))


def _distances(a: Array, b: Array) -> Array:
    return np.asarray(np.hypot(a[:, None, 0] - b[:, 0], a[:, None, 1] - b[:, 1]))
