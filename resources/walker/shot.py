"""The shot: a seeded figure that walks along a street while the camera pans, with the truth of every part.

Positions are in pixels of the picture, y down, the centre of pixel [row, col] at (col + .5, row + .5). A frame is the
mean of its open shutter; the truth is that of its middle.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from ..demo.coverage import coverage
from ..demo.noise import Image
from ..demo.outline import polyline
from ..demo.timing import Array
from . import cloth
from .body import ORDER, Gait, kind_of, pose, rest_points

Mask = NDArray[np.bool_]

FIRST, LAST = 1001, 1036
SIZE = (960, 540)
"""Width and height of the picture in pixels."""
SHUTTER, MOMENTS = 0.5, 5
"""Share of a frame for which the shutter is open, and the moments at which it is sampled."""
GRAIN = 2.2
"""Standard deviation of the grain, in levels."""
ROOM = 0.34
"""How far the street reaches past the picture on either side, in widths and heights: the room for the camera."""

SHOD, CUFF, HAIR = 22.6, 14.5, 13.0
"""Where along a lower leg the shoe begins, along a lower arm the hand, and along the head the hair."""


@dataclass(frozen=True)
class Course:
    """How figure and camera go.

    Attributes
    ----------
    start : where the hips begin, in widths of the picture. grows : by how much the figure has grown by the last frame.
    pan : share of the walk by which the camera follows. zoom : of the camera, by the last frame. sway : phase of its
        unrest.
    """

    start: float
    grows: float
    pan: float
    zoom: float
    sway: float

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> Course:
        """One that keeps the figure in the picture."""
        low, high = (0.30, -0.06, 0.25, -0.04, 0.0), (0.38, 0.08, 0.6, 0.06, 6.0)
        return cls(*rng.uniform(low, high).tolist())


@dataclass(frozen=True)
class Look:
    """A part's own picture `(h, w, 3)` and coverage `(h, w)`; `placed (3, 3)` maps their pixels to its coordinates."""

    colour: Image
    alpha: Image
    placed: Array


class Walker:
    """One walk, the same for the same seed and size. Frames are `FIRST` to `LAST`.

    Parameters
    ----------
    seed : chooses the gait, the garments, the street, the camera, and whether the figure walks to the left.
    size : (w, h) of the picture.
    """

    order = ORDER
    """The names of the parts as they are stacked, the farthest first."""

    def __init__(self, seed: int = 0, size: tuple[int, int] = SIZE) -> None:
        self.seed, self.size = seed, size
        rng = np.random.default_rng([seed, 77])
        self.gait = Gait.drawn(rng)
        self.unit = size[1] * rng.uniform(0.0070, 0.0076)
        """Pixels of a hundredth of the figure's height."""
        self.mirrored = bool(rng.random() < 0.5)
        self.course = Course.drawn(rng)
        self._garments = rng.integers(1 << 30, size=4)
        self._sleeved = bool(rng.random() < 0.5)
        self._offsets = {part: rng.integers(0, cloth.TILE, 2) for part in ORDER}
        self._street_seed = int(rng.integers(1 << 30))

    # ---- the truth

    def affine(self, part: str, frame: float) -> Array:
        """The motion `(2, 3)` of a part: its own coordinates to the picture. Fractions of a frame are allowed."""
        return self._poses(frame)[part][:2]

    def points(self, part: str, frame: float) -> Array:
        """The outline `(P, 3, 2)` of the whole part, seen or hidden: anchor, in- and out-handle."""
        matrix = self.affine(part, frame)
        return rest_points(kind_of(part)) @ matrix[:, :2].T + matrix[:, 2]

    def line(self, part: str, frame: float) -> Array:
        """The same as a polyline `(K, 2)`, vertex by vertex the same place of the part on every frame."""
        return polyline(self.points(part, frame))

    def mask(self, part: str, frame: float) -> Mask:
        """The pixels `(h, w)` of the whole part, seen or hidden."""
        return np.asarray(coverage(self.line(part, frame), 0, 0, *self.size) > 0.5)

    def seen(self, part: str, frame: float) -> Mask:
        """The pixels `(h, w)` in which the part is seen: no nearer one covers it."""
        found = self.mask(part, frame)
        for nearer in ORDER[ORDER.index(part) + 1 :]:
            found &= ~self.mask(nearer, frame)
        return found

    def figure(self, frame: float) -> Mask:
        """The pixels `(h, w)` of the whole figure."""
        return np.asarray(np.any([self.mask(part, frame) for part in ORDER], axis=0))

    def _poses(self, frame: float) -> dict[str, Array]:
        """The motion `(3, 3)` of every part."""
        since, width = frame - FIRST, self.size[0]
        done = since / (LAST - FIRST)
        walked = self.gait.speed * self.unit * since
        bob = 1.1 * np.cos(2.0 * (self.gait.phase + 2.0 * np.pi * since / self.gait.period))
        scale = self.unit * (1.0 + self.course.grows * done)
        x = self.course.start * width + (1.0 - self.course.pan) * walked
        y = 0.565 * self.size[1] + bob * self.unit
        root = np.array([[scale, 0.0, x], [0.0, scale, y], [0.0, 0.0, 1.0]])
        if self.mirrored:
            root = np.array([[-1.0, 0.0, width], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]) @ root
        return {part: root @ matrix for part, matrix in pose(self.gait, since).items()}

    # ---- the picture

    def render(self, frame: int) -> NDArray[np.uint8]:
        """The picture `(h, w, 3)` of a frame, RGB.

        Raises
        ------
        ValueError
            when the shot has no such frame.
        """
        if not FIRST <= frame <= LAST:
            raise ValueError(f"the walk has the frames {FIRST} to {LAST}, not {frame}")
        moments = frame + SHUTTER * ((np.arange(MOMENTS) + 0.5) / MOMENTS - 0.5)
        image = np.mean([self._exposed(moment) for moment in moments], axis=0, dtype=np.float32)
        image = cv2.GaussianBlur(image, (0, 0), 0.55)
        rng = np.random.default_rng([self.seed, frame])
        image += rng.normal(0.0, GRAIN, image.shape).astype(np.float32)
        return np.asarray(np.clip(np.rint(image), 0, 255), dtype=np.uint8)

    def _exposed(self, moment: float) -> Image:
        """The picture of one moment: the street, and the parts over it in their order."""
        poses = self._poses(moment)
        image = cv2.warpAffine(self._street, self._view(moment), self.size, flags=cv2.INTER_LINEAR)
        image *= self._shadow(poses["torso"])[..., None]
        for part in ORDER:
            self._laid(image, self._looks[part], poses[part])
        return np.asarray(image)

    def _laid(self, image: Image, look: Look, matrix: Array) -> None:
        """Put a part into the picture."""
        height, width = look.alpha.shape
        whole = matrix @ look.placed
        corners = whole[:2] @ np.array([[0, width, 0, width], [0, 0, height, height], [1, 1, 1, 1]])
        low = np.maximum(np.floor(corners.min(axis=1)).astype(int) - 1, 0)
        high = np.minimum(np.ceil(corners.max(axis=1)).astype(int) + 1, self.size)
        if (high <= low).any():
            return
        # From indices of one raster to those of the other: a pixel's centre lies half a pixel behind its index.
        map_ = whole @ [[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, 0.0, 1.0]]
        map_[:2, 2] -= 0.5 + low
        extent = (int(high[0] - low[0]), int(high[1] - low[1]))
        colour = cv2.warpAffine(look.colour, map_[:2], extent, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REPLICATE)
        alpha = cv2.warpAffine(look.alpha, map_[:2], extent, flags=cv2.INTER_LINEAR)[..., None]
        place = image[low[1] : high[1], low[0] : high[0]]
        place += alpha * (colour - place)

    def _view(self, moment: float) -> Array:
        """The map `(2, 3)` from the street's pixels to the picture's: the camera pans with the figure, not as far."""
        since = moment - FIRST
        done, turn = since / (LAST - FIRST), since / 11.0 + self.course.sway
        panned = self.course.pan * self.gait.speed * self.unit * since * (-1.0 if self.mirrored else 1.0)
        middle = np.array(self.size) / 2.0
        zoom = 1.0 + self.course.zoom * done
        at = (
            middle * (1.0 + 2.0 * ROOM) + (panned, 0.0) + self.unit * np.array([np.sin(turn), 0.6 * np.cos(1.3 * turn)])
        )
        return np.column_stack([zoom * np.eye(2), middle - zoom * at])

    def _shadow(self, torso: Array) -> Image:
        """Light `(h, w)` left on the street under the figure."""
        y, x = np.mgrid[: self.size[1], : self.size[0]].astype(np.float32)
        apart = ((x - torso[0, 2]) / (26.0 * self.unit)) ** 2 + (
            (y - torso[1, 2] - 51.0 * self.unit) / (4.0 * self.unit)
        ) ** 2
        return np.asarray(1.0 - 0.4 * np.exp(-apart), dtype=np.float32)

    @cached_property
    def _street(self) -> Image:
        width, height = (round(side * (1.0 + 2.0 * ROOM)) for side in self.size)
        kerb = (0.5 + ROOM + 0.34) * self.size[1]
        return cloth.street((width, height), kerb, np.random.default_rng(self._street_seed))

    @cached_property
    def _looks(self) -> dict[str, Look]:
        """What each part looks like: one garment may cover several."""
        rng = np.random.default_rng(self._street_seed + 1)
        shirts, trousers, skins = cloth.SHIRTS, cloth.TROUSERS, cloth.SKINS
        top = cloth.shirt(shirts[rng.integers(len(shirts))], int(self._garments[0]))
        legs = cloth.trousers(trousers[rng.integers(len(trousers))], int(self._garments[1]))
        bare = cloth.skin(skins[rng.integers(len(skins))], int(self._garments[2]))
        dark = cloth.trousers((58, 46, 40), int(self._garments[3]))
        worn = {
            "torso": (top, top, 99.0),
            "upper arm": (top, top, 99.0),
            "lower arm": (top if self._sleeved else bare, bare, CUFF),
            "upper leg": (legs, legs, 99.0),
            "lower leg": (legs, dark, SHOD),
            "head": (bare, dark, HAIR),
        }
        return {part: self._look(part, *worn[kind_of(part)]) for part in ORDER}

    def _look(self, part: str, first: Image, second: Image, edge: float) -> Look:
        """A part's picture: the first cloth, the second from `edge` along it, with the shade of a round limb."""
        line = polyline(rest_points(kind_of(part)))
        low = line.min(axis=0) - 1.0
        width, height = np.ceil((line.max(axis=0) + 1.0 - low) * self.unit).astype(int)
        row, column = np.mgrid[:height, :width]
        dx, dy = self._offsets[part]
        tile = (row + dy) % cloth.TILE, (column + dx) % cloth.TILE
        x, y = (column + 0.5) / self.unit + low[0], (row + 0.5) / self.unit + low[1]
        if kind_of(part) == "head":  # hair covers the back of the head, too
            x = x - 1.3 * y
        other = np.clip((x - edge) * self.unit + 0.5, 0.0, 1.0)[..., None]
        colour = (1.0 - other) * first[tile] + other * second[tile]
        colour = colour * cloth.shade(y / np.abs(line[:, 1]).max(), part.startswith("far "))[..., None]
        alpha = coverage((line - low) * self.unit, 0, 0, int(width), int(height))
        placed = np.array([[1.0 / self.unit, 0.0, low[0]], [0.0, 1.0 / self.unit, low[1]], [0.0, 0.0, 1.0]])
        return Look(np.asarray(colour, dtype=np.float32), alpha, placed)


def write_frames(folder: Path, walker: Walker, progress: Callable[[float, str], None] | None = None) -> None:
    """Write the whole walk into `folder` as 8-bit PNG, `walker.1001.png` and so on; what lies there is replaced.

    `progress` is called with the finished share in [0, 1] and a few words; what it raises stops the work.
    """
    folder.mkdir(parents=True, exist_ok=True)
    for frame in range(FIRST, LAST + 1):
        if progress is not None:
            progress((frame - FIRST) / (LAST + 1 - FIRST), f"rendering the walker, frame {frame}")
        path = folder / f"walker.{frame}.png"
        if not cv2.imwrite(str(path), cv2.cvtColor(walker.render(frame), cv2.COLOR_RGB2BGR)):
            raise OSError(f"{path} cannot be written")
