"""A rendered plane in perspective: blurred, with grain, before a ground that goes its own way, an occluder crossing it.

Rendered by NumPy and OpenCV alone; every place of the plane is known on every frame. Positions are the engine's: the
centre of pixel `[row, col]` is `(col + 0.5, row + 0.5)`.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import cv2
import numpy as np

from roam_core.geometry import projective
from roam_core.geometry.bezier import polygon_points

WIDTH, HEIGHT = 480, 320
TO_OPENCV = np.array([[1.0, 0.0, -0.5], [0.0, 1.0, -0.5], [0.0, 0.0, 1.0]])
SIDES = 260.0, 180.0
"""Width and height of the plane, in pixels of its texture."""
OVER = 2
"""Samples of a pixel's side."""
MOMENTS = np.linspace(-0.25, 0.25, 3)
"""Moments of the shutter, of half a frame about the frame itself: so motion blur moves nothing."""


def noise(seed: int, size: tuple[int, int], sigmas: tuple[float, ...]) -> np.ndarray:
    """Grain of several sizes `(h, w)`, mean 0, spread 1."""
    random = np.random.default_rng(seed)
    layers = []
    for sigma in sigmas:
        soft = cv2.GaussianBlur(random.standard_normal(size).astype(np.float32), (0, 0), sigma)
        layers.append(soft / soft.std())
    return np.asarray(sum(layers) / np.sqrt(len(layers)), dtype=np.float32)


@dataclass(frozen=True)
class Scene:
    """A plane that turns, tilts and comes nearer for `count` frames.

    `crossing` are the frames at which an occluder half as wide as the plane, or `covers` times that, enters and leaves;
    it stops at the share `stops` of its way. `dim` is the share of the light that is lost until the end.
    """

    count: int = 60
    crossing: tuple[int, int] = (12, 48)
    covers: float = 1.0
    stops: float = 1.0
    dim: float = 0.2
    grain: float = 3.0
    seed: int = 5

    def motion(self, frame: float) -> np.ndarray:
        """From the texture's pixels to the picture on a frame, `(3, 3)`: a camera sees the plane in space."""
        u = frame / max(self.count - 1, 1)
        tilt, turn, roll = 0.75 * np.sin(2.2 * u), 0.5 * u - 0.1 * np.sin(5.0 * u), 0.22 * np.sin(3.0 * u)
        rotation = _about(0, 0.4 * tilt) @ _about(1, turn + 0.35 * tilt) @ _about(2, roll)
        middle = np.array([12.0 * np.sin(4.0 * u), -10.0 * u, 430.0 - 90.0 * u])
        flat = np.column_stack([rotation[:, 0], rotation[:, 1], middle])
        centred = np.array([[1.0, 0.0, -SIDES[0] / 2], [0.0, 1.0, -SIDES[1] / 2], [0.0, 0.0, 1.0]])
        camera = np.array([[400.0, 0.0, WIDTH / 2], [0.0, 400.0, HEIGHT / 2], [0.0, 0.0, 1.0]])
        return projective.normalised(camera @ flat @ centred)

    @property
    def corners(self) -> np.ndarray:
        """The plane's corners `(4, 2)` in its texture."""
        return np.array([(0.0, 0.0), (SIDES[0], 0.0), SIDES, (0.0, SIDES[1])])

    def seen(self, places: np.ndarray, frame: float) -> np.ndarray:
        """Where places `(K, 2)` of the texture are in the picture."""
        return projective.apply(self.motion(frame), places)

    def since(self, start: int, frame: int) -> np.ndarray:
        """The plane's motion `(3, 3)` from one frame's picture to another's."""
        return projective.normalised(self.motion(frame) @ np.linalg.inv(self.motion(start)))

    def outline(self, frame: int, inset: float = 6.0) -> np.ndarray:
        """A closed polygon `(4, 3, 2)` on the plane, a little inside of it."""
        inner = self.corners + inset * np.array([(1, 1), (-1, 1), (-1, -1), (1, -1)])
        return polygon_points(self.seen(inner, frame))

    def occluder(self, frame: float) -> np.ndarray:
        """The outline `(K, 2)` of what crosses the plane, from the left to the right; far away before and after."""
        first, last = self.crossing
        u = min((frame - first) / max(last - first, 1), self.stops)
        wide = 0.25 * SIDES[0] * self.covers
        x = self.seen(self.corners, frame)[:, 0]
        left, right = x.min() - wide, x.max() + wide
        at = np.array([left + u * (right - left), HEIGHT / 2 + 6.0 * np.sin(frame / 3.0)])
        angles = np.linspace(0.0, 2 * np.pi, 40, endpoint=False)
        return np.asarray(at + np.stack([wide * np.cos(angles), 0.6 * SIDES[1] * np.sin(angles)], axis=1))

    def picture(self, frame: int) -> np.ndarray:
        """The frame `(h, w, 3)`, uint8."""
        exposed = np.mean([self._moment(frame + moment) for moment in MOMENTS], axis=0, dtype=np.float32)
        soft = cv2.GaussianBlur(exposed, (0, 0), 0.7 * OVER)
        small = cv2.resize(soft, (WIDTH, HEIGHT), interpolation=cv2.INTER_AREA)
        light = 1.0 - self.dim * frame / max(self.count - 1, 1)
        grain = np.random.default_rng((self.seed, frame)).normal(0.0, self.grain, small.shape)
        grey = np.clip(small * light + grain, 0, 255).astype(np.uint8)
        return np.repeat(grey[..., None], 3, axis=2)

    # ---- the rest is private

    @cached_property
    def _texture(self) -> np.ndarray:
        """Of the plane, with room for its borders: soft structure of several sizes, no lattice."""
        return 128.0 + 34.0 * noise(self.seed, (int(SIDES[1]), int(SIDES[0])), (1.5, 4.0, 12.0))

    @cached_property
    def _ground(self) -> np.ndarray:
        return 100.0 + 30.0 * noise(self.seed + 1, (OVER * HEIGHT + 200, OVER * WIDTH + 200), (3.0, 10.0))

    @cached_property
    def _cloth(self) -> np.ndarray:
        return 140.0 + 36.0 * noise(self.seed + 2, (OVER * HEIGHT, OVER * WIDTH), (3.0, 9.0))

    def _moment(self, moment: float) -> np.ndarray:
        shift = int(100 + 1.2 * moment)
        image = self._ground[shift : shift + OVER * HEIGHT, shift : shift + OVER * WIDTH]
        size = OVER * WIDTH, OVER * HEIGHT
        larger = np.diag([OVER, OVER, 1.0])
        way = TO_OPENCV @ larger @ self.motion(moment) @ np.linalg.inv(TO_OPENCV)
        plane = cv2.warpPerspective(self._texture, way, size, flags=cv2.INTER_CUBIC)
        image = _over(image, plane, self.seen(self.corners, moment))
        occluder = self.occluder(moment)
        cloth = np.roll(self._cloth, round(OVER * occluder[:, 0].mean()), axis=1)
        return _over(image, cloth, occluder)


def _over(image: np.ndarray, top: np.ndarray, outline: np.ndarray) -> np.ndarray:
    mask = np.zeros(image.shape[:2], np.uint8)
    cv2.fillPoly(mask, [np.round((outline * OVER - 0.5) * 16).astype(np.int32)], 255, shift=4)
    return np.where(mask > 0, top, image)


def _about(axis: int, angle: float) -> np.ndarray:
    """A turn in space about an axis."""
    a, b = [each for each in range(3) if each != axis]
    matrix = np.eye(3)
    matrix[a, a] = matrix[b, b] = np.cos(angle)
    matrix[a, b], matrix[b, a] = -np.sin(angle), np.sin(angle)
    return matrix
