"""Matching a picture to the texture that a surface had on a reference picture, pixel by pixel, at sub-pixel accuracy.

Corners that are found again tell where most of them went; every pixel of the texture tells more. Both pictures are made
alike in brightness and contrast about each place, and places that do not correlate count as hidden, wherever they are:
so light that changes is no motion, and what passes before the surface is not followed, even where it hides most of it.
The step is that of S. Benhimane and E. Malis, "Real-time image-based tracking of planes using efficient second-order
minimization" (IROS 2004), weighted by the local correlation.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features import Region
from roam_core.features.grid import FROM_CENTRES, TO_CENTRES
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.params.tracks import RegistrationParams, TrackConfidenceParams


@dataclass(frozen=True, eq=False)
class Fit:
    """How well a picture shows the texture under a motion.

    Attributes
    ----------
    matrix : (3, 3) from the reference picture to this one, full-size pixels.
    seen : share of the texture's pixels that are seen, in [0, 1]: in the picture, and alike.
    likeness : mean local correlation of what is seen, in [-1, 1].
    spread : expected error in pixels of this picture at each corner of the texture's box `(4,)`: it grows where few
        places are seen, or badly spread ones, or where what is seen differs, or would move otherwise.
    weights : (h, w) of the texture's pixels, in [0, 1]: how far each is seen.
    """

    matrix: Array
    seen: float
    likeness: float
    spread: Array
    weights: Float32

    @property
    def error(self) -> float:
        """The expected error at the corners, root mean square, pixels."""
        return float(np.sqrt(np.mean(self.spread**2)))


def confidence_of(error: float, seen: float, likeness: float, params: TrackConfidenceParams) -> float:
    """In [0, 1]: little where few places are seen, or badly spread, or where they do not look as they did.

    `error` is the expected error at the corners, pixels of a 480-line image.
    """
    exact = 1.0 / (1.0 + (error / params.error) ** 2)
    share = min(seen / params.seen, 1.0)
    fit = np.clip((likeness - params.no_fit) / (params.fit - params.no_fit), 0.0, 1.0)
    return float(exact * share * fit)


@dataclass(frozen=True, eq=False)
class Expected:
    """Where the surface is expected without a look: by `matrix (3, 3)` from the reference, within `within` pixels.

    It decides only what the texture that is seen leaves open.
    """

    matrix: Array
    within: float


@dataclass(frozen=True, eq=False)
class _Level:
    """The texture at one resolution: normalised values, where they are known, and the map to the reference's pixels.

    `core` is what is known without its rim: there the values' gradients are known, too.
    """

    values: Float32
    known: Float32
    core: Float32
    to_full: Array


@dataclass(frozen=True, eq=False)
class Texture:
    """What a surface looks like on a reference picture, coarse to fine.

    `area` is the number of its pixels on the finest level, `corners (4, 2)` those of its box in the reference picture,
    `pixel_aspect` how much wider than high a pixel is shown.
    """

    levels: tuple[_Level, ...]
    corners: Array
    params: RegistrationParams
    pixel_aspect: float = 1.0

    @classmethod
    def of(cls, grey: UInt8, mask: UInt8, params: RegistrationParams, pixel_aspect: float = 1.0) -> Texture | None:
        """Of `grey (h, w)` where `mask (h, w)` is not zero; None where that is too little."""
        x, y, wide, high = cv2.boundingRect(mask)
        if wide == 0 or high == 0:
            return None
        corners = np.array([(x, y), (x + wide, y), (x + wide, y + high), (x, y + high)], dtype=np.float64)
        shrunk = min(1.0, params.side / max(wide, high))
        region = Region.around(corners, params.grown * params.window / shrunk, (grey.shape[0], grey.shape[1]))
        levels = []
        for level in range(params.levels):
            factor = shrunk / 2**level
            if level > 0 and min(wide, high) * factor < params.coarsest:
                break
            levels.append(_level(grey, mask, region, factor, params))
        if np.count_nonzero(levels[0].core) < params.least_area:
            return None
        return cls(tuple(reversed(levels)), corners, params, pixel_aspect)

    @property
    def area(self) -> int:
        return int(np.count_nonzero(self.levels[-1].core))

    def matched(
        self,
        grey: UInt8,
        guess: Array,
        kind: PlaneMotion,
        hidden: UInt8 | None = None,
        expected: Expected | None = None,
        check: Callable[[], None] | None = None,
    ) -> Fit | None:
        """The motion `guess (3, 3)`, from the reference to the picture `grey (h, w)`, refined.

        `hidden (h, w)` is not zero where something else covers the picture. None where the surface leaves the picture,
        or nothing of it is alike.
        """
        matrix, fit = guess, None
        free = np.full(grey.shape, 255, np.uint8) if hidden is None else np.where(hidden > 0, 0, 255).astype(np.uint8)
        for level in self.levels:
            if check is not None:
                check()
            if not self._is_plausible(matrix):
                return None
            fit = _refined(level, _Picture.on(level, grey, free, matrix), matrix, kind, expected, self)
            if fit is None:
                return None
            matrix = fit.matrix
        return fit if self._is_plausible(matrix) else None

    def _is_plausible(self, matrix: Array) -> bool:
        """False where a motion tips the surface over, or makes a corner's surroundings many times larger or smaller."""
        if (projective.depth(matrix, self.corners) <= projective.HORIZON).any():
            return False
        sizes = [_stretch(matrix, corner) for corner in self.corners]
        return bool(max(sizes) < self.params.resized and min(sizes) * self.params.resized > 1.0)


def _level(grey: UInt8, mask: UInt8, region: Region, factor: float, params: RegistrationParams) -> _Level:
    rows, columns = region.slices
    size = max(round((region.x1 - region.x0) * factor), 1), max(round((region.y1 - region.y0) * factor), 1)
    way = cv2.INTER_AREA if factor < 1.0 else cv2.INTER_LINEAR
    small = cv2.resize(grey[rows, columns], size, interpolation=way).astype(np.float32)
    inner = cv2.resize(mask[rows, columns], size, interpolation=way) > 127
    kept = np.asarray(inner, dtype=np.float32)
    across, down = (region.x1 - region.x0) / size[0], (region.y1 - region.y0) / size[1]
    to_full = np.array([[across, 0.0, region.x0], [0.0, down, region.y0], [0.0, 0.0, 1.0]])
    return _Level(_normalised(small, kept, params), kept, _without_rim(kept), to_full)


def _normalised(values: Float32, known: Float32, params: RegistrationParams) -> Float32:
    """Values with mean 0 and spread 1 about each place, where they are `known`; what is flat stays small."""
    share = np.maximum(_local(known, params.window), 1e-3)
    mean = _local(values * known, params.window) / share
    spread = np.maximum(_local(values * values * known, params.window) / share - mean * mean, 0.0)
    return np.asarray((values - mean) / np.sqrt(spread + params.flat**2) * known, dtype=np.float32)


def _local(values: Float32, window: int) -> Float32:
    """The mean about each place."""
    return np.asarray(cv2.blur(values, (window, window), borderType=cv2.BORDER_REFLECT), dtype=np.float32)


@dataclass(frozen=True, eq=False)
class _Seen:
    """The picture, warped back to the texture: its normalised values, the weights, and their local correlation."""

    values: Float32
    weights: Float32
    likeness: Float32


@dataclass(frozen=True, eq=False)
class _Picture:
    """A picture, as soft as a level's pixels are large in it, and where nothing covers it: 255."""

    grey: UInt8
    free: UInt8

    @classmethod
    def on(cls, level: _Level, grey: UInt8, free: UInt8, matrix: Array) -> _Picture:
        """Where the level lies in it by `matrix (3, 3)` from the reference."""
        height, width = level.values.shape
        larger = _stretch(matrix @ level.to_full, np.array([width / 2, height / 2]))
        side = 2 * round((larger - 1.0) / 2.0) + 1  # an even one would move the picture by half a pixel
        return cls(grey if side < 3 else np.asarray(cv2.blur(grey, (side, side)), np.uint8), free)


def _warped(level: _Level, picture: _Picture, matrix: Array, params: RegistrationParams) -> _Seen:
    height, width = level.values.shape
    way = TO_CENTRES @ matrix @ level.to_full @ FROM_CENTRES
    flags = cv2.INTER_LINEAR | cv2.WARP_INVERSE_MAP
    warped, free = (
        cv2.warpPerspective(each, way, (width, height), flags=flags, borderMode=cv2.BORDER_CONSTANT)
        for each in (picture.grey, picture.free)
    )
    there = (free > 250).astype(np.float32) * level.known
    values = _normalised(warped.astype(np.float32), there, params)
    likeness = _correlation(level.values, values, there, params)
    above = np.clip((likeness - params.unlike) / (params.alike - params.unlike), 0.0, 1.0)
    return _Seen(values, np.asarray(above * level.core * _without_rim(there), dtype=np.float32), likeness)


def _without_rim(mask: Float32) -> Float32:
    """A mask without the pixels that touch others; what lies beyond the picture's edge counts as others."""
    return np.asarray(cv2.erode(mask, np.ones((3, 3), np.uint8), borderValue=0.0), dtype=np.float32)


def _correlation(a: Float32, b: Float32, known: Float32, params: RegistrationParams) -> Float32:
    """How alike both are about each place, in [-1, 1]; 0 where either is flat."""
    both, own, other = (_local(x * known, params.window) for x in (a * b, a * a, b * b))
    share = _local(known, params.window)
    size = np.sqrt(np.maximum(own, 0.0) * np.maximum(other, 0.0))
    return np.asarray(both / (size + params.faint * share + 1e-6), dtype=np.float32)


def _refined(
    level: _Level,
    picture: _Picture,
    matrix: Array,
    kind: PlaneMotion,
    expected: Expected | None,
    texture: Texture,
) -> Fit | None:
    params = texture.params
    equations = _Equations(level, kind, texture)
    seen, spread = _warped(level, picture, matrix, params), np.zeros(4)
    for _ in range(params.rounds):
        step = equations.step(seen, matrix, expected)
        if step is None:
            return None
        change, moved, spread = step
        back = projective.usable(np.linalg.inv(level.to_full @ change @ np.linalg.inv(level.to_full)))
        after = None if back is None else projective.usable(matrix @ back)
        if after is None or (projective.depth(after, texture.corners) <= projective.HORIZON).any():
            return None
        matrix = after
        seen = _warped(level, picture, matrix, params)
        if moved < params.enough:
            break
    wrong = 0.0 if kind is PlaneMotion.HOMOGRAPHY else _misfit(level, seen, matrix, texture)
    return _fit(level, seen, matrix, np.hypot(spread, wrong), equations.box)


def _misfit(level: _Level, seen: _Seen, matrix: Array, texture: Texture) -> float:
    """By how many of the level's pixels a perspective motion would put the corners elsewhere, beyond what noise does.

    What is too simple a motion stays a little right everywhere and is wrong at the corners.
    """
    equations = _Equations(level, PlaneMotion.HOMOGRAPHY, texture)
    step = equations.step(seen, matrix, None)
    if step is None:
        return 0.0
    change, _, spread = step
    box = equations.box
    moved = ((projective.apply(change, box) - box) ** 2).sum(axis=1).mean()
    return float(np.sqrt(max(moved - (spread**2).mean(), 0.0)))


def _fit(level: _Level, seen: _Seen, matrix: Array, spread: Array, box: Array) -> Fit:
    total = float(seen.weights.sum())
    share = total / max(float(level.core.sum()), 1.0)
    likeness = float((seen.likeness * seen.weights).sum() / max(total, 1e-6))
    larger = np.array([_stretch(matrix @ level.to_full, corner) for corner in box])
    return Fit(matrix, share, likeness, spread * larger, seen.weights)


def _inverse(matrix: Array) -> Array:
    return np.asarray(np.linalg.inv(matrix), dtype=np.float64)


def _stretch(matrix: Array, place: Array) -> float:
    """How much larger a small square about a place becomes."""
    near = np.stack([place, place + np.array([0.5, 0.0]), place + np.array([0.0, 0.5])])
    a, b, c = projective.apply(matrix, near)
    return float(np.sqrt((((b - a) ** 2).sum() + ((c - a) ** 2).sum()) / 0.5))


class _Equations:
    """What tells the change of the motion on a level. `box (4, 2)` are the texture's corners in its pixels.

    Places are measured about the middle, in halves of the longer side: so all parameters are of one size.
    """

    def __init__(self, level: _Level, kind: PlaneMotion, texture: Texture) -> None:
        self._level, self._kind, self._params, self._aspect = level, kind, texture.params, texture.pixel_aspect
        self.box = projective.apply(_inverse(level.to_full), texture.corners)
        height, width = level.values.shape
        self._half = half = max(width, height) / 2.0
        self._from_unit = np.array([[half, 0.0, width / 2], [0.0, half, height / 2], [0.0, 0.0, 1.0]])
        self._to_unit = np.linalg.inv(self._from_unit)
        along, down = (np.arange(width) + 0.5 - width / 2) / half, (np.arange(height) + 0.5 - height / 2) / half
        self._x, self._y = np.meshgrid(along, down)
        self._corners = projective.apply(self._to_unit, self.box)

    def step(self, seen: _Seen, matrix: Array, expected: Expected | None) -> tuple[Array, float, Array] | None:
        """The change of the texture's pixels `(3, 3)`, how far it moves a corner, and their expected error `(4,)`.

        None where too little is seen.
        """
        use = seen.weights > 0.0
        if np.count_nonzero(use) < 4 * self._kind.pairs:
            return None
        rows, weights = self._rows(seen, use), seen.weights[use].astype(np.float64)
        missing = (seen.values - self._level.values)[use].astype(np.float64)
        normal, right = (rows * weights[:, None]).T @ rows, rows.T @ (weights * missing)
        noise = self._params.grain * float((weights * missing**2).sum() / weights.sum())
        normal += 1e-9 * np.trace(normal) * np.eye(len(normal))
        if expected is not None:
            more, towards = self._expecting(matrix, expected, noise)
            normal, right = normal + more, right + towards
        inverse = _inverse(normal)
        unknown = inverse @ right
        spread = self._spread(inverse * noise) * self._half
        change = self._change(unknown)
        moved = float(np.hypot(*(projective.apply(change, self.box) - self.box).T).max())
        if moved > self._params.jump:
            change = self._change(unknown * self._params.jump / moved)
        return change, moved, spread

    def _rows(self, seen: _Seen, use: Bools) -> Array:
        middle = 0.5 * (self._level.values + seen.values)
        dx, dy = (
            cv2.Sobel(middle, cv2.CV_32F, *order, ksize=3, scale=0.125)[use].astype(np.float64) * self._half
            for order in ((1, 0), (0, 1))
        )
        return self._columns(self._x[use], self._y[use], dx, dy)

    def _expecting(self, matrix: Array, expected: Expected, noise: float) -> tuple[Array, Array]:
        """What draws the corners to where they are expected, as part of the normal equations.

        The less the pixels tell, the more it says.
        """
        way = matrix @ self._level.to_full
        ahead = projective.apply(expected.matrix @ self._level.to_full, self.box)
        back = projective.apply(self._to_unit @ np.linalg.inv(way), ahead)
        larger = float(np.mean([_stretch(way, corner) for corner in self.box]))
        weight = noise / (expected.within / larger / self._half) ** 2
        x, y = self._corners.T
        one, none = np.ones_like(x), np.zeros_like(x)
        rows = np.concatenate([self._columns(x, y, one, none), self._columns(x, y, none, one)])
        off = (self._corners - back).T.ravel()
        return weight * rows.T @ rows, weight * rows.T @ off

    def _change(self, unknown: Array) -> Array:
        return np.asarray(self._from_unit @ self._motion(unknown) @ self._to_unit)

    def _columns(self, x: Array, y: Array, dx: Array, dy: Array) -> Array:
        """How the values at places change with each parameter of the motion `(N, U)`.

        What is turned by little as it is shown moves by `(-y / pixel_aspect, pixel_aspect * x)` in pixels.
        """
        if self._kind is PlaneMotion.TRANSLATION:
            columns = [dx, dy]
        elif self._kind is PlaneMotion.SIMILARITY:
            columns = [dx, dy, dx * x + dy * y, dy * (self._aspect * x) - dx * (y / self._aspect)]
        else:
            columns = [dx, dy, dx * x, dx * y, dy * x, dy * y]
            if self._kind is PlaneMotion.HOMOGRAPHY:
                out = dx * x + dy * y
                columns += [-out * x, -out * y]
        return np.stack(columns, axis=1)

    def _motion(self, unknown: Array) -> Array:
        """The motion `(3, 3)` of the parameters of `_columns`."""
        matrix = np.eye(3)
        matrix[:2, 2] = unknown[:2]
        if self._kind is PlaneMotion.SIMILARITY:
            grow, turn = unknown[2:]
            matrix[:2, :2] += np.array([[grow, -turn / self._aspect], [turn * self._aspect, grow]])
        elif self._kind is not PlaneMotion.TRANSLATION:
            matrix[:2, :2] += unknown[2:6].reshape(2, 2)
            matrix[2, :2] = unknown[6:] if self._kind is PlaneMotion.HOMOGRAPHY else 0.0
        return matrix

    def _spread(self, covariance: Array) -> Array:
        """The standard deviation `(4,)` of the corners under a motion whose parameters vary so."""
        x, y = self._corners.T
        one, none = np.ones_like(x), np.zeros_like(x)
        total = np.zeros(len(x))
        for dx, dy in ((one, none), (none, one)):
            rows = self._columns(x, y, dx, dy)
            total += ((rows @ covariance) * rows).sum(axis=1)
        return np.asarray(np.sqrt(np.maximum(total, 0.0)))
