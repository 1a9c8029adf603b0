"""Little shots of objects in parts: textured shapes over each other, each with a known motion of its own."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from functools import cache, cached_property
from pathlib import Path

import cv2
import numpy as np

from roam_core.arrays import Array, UInt8
from roam_core.geometry import bezier, polyline, similarity
from roam_core.matte import shape_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape, file
from tests.golden.shots import Texture, blob, inverse, pose, texture

SIZE = 120, 160


@dataclass(frozen=True, eq=False)
class Moving:
    """A part `rest (P, 3, 2)`, drawn at the origin: by frame it lies at `start + k * step`, turned by `k * turn`."""

    name: str
    rest: Array
    start: tuple[float, float]
    step: tuple[float, float] = (0.0, 0.0)
    turn: float = 0.0
    look: Texture | None = None

    def where(self, k: int) -> Array:
        return pose(self.start[0] + k * self.step[0], self.start[1] + k * self.step[1], k * self.turn)

    def truth(self, k: int) -> Array:
        """Its outline `(P, 3, 2)` on frame k."""
        return similarity.apply(self.where(k), self.rest)


@dataclass(frozen=True, eq=False)
class Figure:
    """Parts, bottom first, on frames 0 to `count - 1`."""

    parts: tuple[Moving, ...]
    count: int = 8

    @property
    def frames(self) -> range:
        return range(self.count)

    def shapes(self, *frames: int) -> list[RotoShape]:
        """All parts with the true outlines as artist keys on `frames`; on the first one for none."""
        return [
            RotoShape(part.name, part.name, tuple(Keyframe(k, part.truth(k)) for k in frames or (0,)))
            for part in self.parts
        ]

    def read(self, frame: int) -> UInt8:
        return self.pictures[frame]

    @cached_property
    def pictures(self) -> list[UInt8]:
        return [self._drawn(k) for k in self.frames]

    def _drawn(self, k: int) -> UInt8:
        image = background().copy()
        for part in self.parts:
            shape = RotoShape(part.name, part.name, (Keyframe(k, part.truth(k)),))
            matte = shape_matte(shape, k, SIZE)
            covered = np.nonzero(matte)
            places = similarity.apply(inverse(part.where(k)), centres()[covered])
            cover, look = matte[covered][:, None], 0.6 if part.look is None else part.look.at(places)
            image[covered] = cover * look + (1.0 - cover) * image[covered]
        return np.asarray(np.round(255.0 * image), dtype=np.uint8)


def centres() -> Array:
    """The centre of each pixel `(h, w, 2)`."""
    height, width = SIZE
    return np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)


@cache
def background() -> Array:
    """What lies behind all parts `(h, w, 3)`."""
    return texture(90, 0.0, 0.35).at(centres())


def box(width: float, height: float) -> Array:
    """A polygon `(4, 3, 2)` around the origin."""
    w, h = width / 2.0, height / 2.0
    return bezier.polygon_points([(-w, -h), (w, -h), (w, h), (-w, h)])


def body_with_arms(count: int = 8) -> Figure:
    """A body, an arm that turns over it and a head that nods: three parts that overlap."""
    return Figure(
        (
            Moving("body", box(34, 50), (80, 70), (0.8, 0.2), 0.4, texture(11, 0.5, 0.9)),
            Moving("arm", box(52, 13), (104, 62), (0.8, 0.6), 2.0, texture(12, 0.6, 1.0)),
            Moving("head", box(22, 24), (80, 40), (1.2, 0.1), -1.0, texture(13, 0.4, 1.0)),
        ),
        count,
    )


def body_behind_a_post(count: int = 8) -> Figure:
    """A body, and a post that passes before it."""
    body = Moving("body", box(40, 50), (80, 64), (0.5, 0.0), 0.0, texture(11, 0.5, 0.9))
    return Figure((body, Moving("post", box(20, 110), (114, 60), (-4.0, 0.0), 0.0, texture(12, 0.6, 1.0))), count)


def turning_head_behind_a_post(count: int = 13, turned: int = 4) -> tuple[Figure, Callable[[int], UInt8]]:
    """A body and a head, before which a post passes, and their pictures: from `turned` on the head looks otherwise.

    Nothing shows where the head is while the post is before both.
    """
    body = Moving("body", box(34, 44), (110, 80), (-1.0, 0.0), 0.0, texture(11, 0.5, 0.9))
    post = Moving("post", box(30, 118), (70, 60), (4.0, 0.0), 0.0, texture(15, 0.3, 1.0))
    face, neck = (
        Moving("head", box(22, 22), (110, 50), (-1.0, 0.0), 0.0, texture(seed, *range_))
        for seed, range_ in ((13, (0.4, 1.0)), (29, (0.0, 0.5)))
    )
    before, after = (Figure((body, head, post), count) for head in (face, neck))
    return before, lambda frame: (before if frame < turned else after).pictures[frame]


def arm_like_its_body(count: int = 6) -> Figure:
    """A body, and an arm over it of the same colours: alone it is carried by its pose."""
    body = Moving("body", box(60, 80), (80, 64), (-0.5, 0.0), 0.0, texture(11, 0.55, 0.7))
    return Figure((body, Moving("arm", box(14, 44), (88, 60), (1.5, 0.0), 2.0, texture(13, 0.55, 0.7))), count)


def arm_that_comes_in(count: int = 6) -> Figure:
    """A body and an arm of the same cloth over it, both cut off by the lower edge at first: they move up."""
    body = Moving("body", box(60, 200), (80, 150), (0.0, -3.0), 0.0, texture(11, 0.58, 0.66))
    return Figure((body, Moving("arm", box(16, 50), (84, 108), (0.0, -3.0), 4.0, texture(13, 0.58, 0.66))), count)


def body_and_sleeve(count: int = 6) -> Figure:
    """A large body, and a sleeve of the same cloth that turns before its edge: alone it is held to its pose."""
    body = Moving("body", box(100, 76), (72, 62), (0.8, -0.3), 0.6, texture(11, 0.56, 0.66))
    return Figure((body, Moving("sleeve", box(56, 22), (120, 58), (0.3, 0.6), 7.0, texture(13, 0.56, 0.66))), count)


def two_shins(count: int = 10) -> Figure:
    """Two shins of one cloth that swing past each other, near and apart on the first frame; nothing joins them."""
    far = Moving("far", box(14, 56), (64, 60), (3.4, 0.0), -2.0, texture(11, 0.5, 0.8))
    return Figure((far, Moving("near", box(16, 58), (88, 62), (-3.0, 0.2), 2.0, texture(13, 0.5, 0.8))), count)


@dataclass(frozen=True, eq=False)
class Licking(Moving):
    """A part of a flame: what lies higher above its `foot` goes farther to the side."""

    foot: float = 0.0

    def truth(self, k: int) -> Array:
        points = similarity.apply(self.where(0), self.rest)
        height = self.foot - points[..., 1]
        points[..., 0] += k * height * np.abs(height) / 900.0
        return points


@dataclass(frozen=True, eq=False)
class Flame(Figure):
    """Parts of one thing whose surface is another one on every frame: no pose fits them."""

    def _drawn(self, k: int) -> UInt8:
        image = background().copy()
        for n, part in enumerate(self.parts):
            matte = shape_matte(RotoShape(part.name, part.name, (Keyframe(k, part.truth(k)),)), k, SIZE)
            covered = np.nonzero(matte)
            cover, look = matte[covered][:, None], texture(100 + 10 * k + n, 0.55, 1.0).at(centres()[covered])
            image[covered] = cover * look + (1.0 - cover) * image[covered]
        return np.asarray(np.round(255.0 * image), dtype=np.uint8)


def flame(count: int = 8) -> Flame:
    """A lower and an upper half that bend to the side; they overlap."""
    half = bezier.polygon_points(polyline.resample(box(26, 50)[:, bezier.ANCHOR], 32))
    return Flame(
        tuple(Licking(name, half, (70, middle), foot=111) for name, middle in (("lower", 86), ("upper", 46))), count
    )


def hazy(pictures: Sequence[UInt8], most: float = 0.6) -> list[UInt8]:
    """Pictures over which bluish haze comes up: `most` of the last one is haze, nothing of the first."""
    haze = np.array([170.0, 180.0, 200.0])
    return [
        np.asarray(np.round((1.0 - share) * picture + share * haze), dtype=np.uint8)
        for share, picture in zip(np.linspace(0.0, most, len(pictures)), pictures, strict=True)
    ]


def subtracting(shape: RotoShape) -> RotoShape:
    return replace(shape, blend=BlendMode.SUBTRACT)


def keys_of(shape: RotoShape) -> list[tuple[int, bytes, float | None, str]]:
    """All that a run says of a shape, bit by bit."""
    return [(key.frame, key.points.tobytes(), key.confidence, key.inputs) for key in shape.keys]


def laid(shapes: Sequence[RotoShape], found: RotoShape) -> list[RotoShape]:
    """The shapes with one of them as it was found."""
    return [found if shape.id == found.id else shape for shape in shapes]


# ---- parts of which little is to be seen


BODY = Moving("body", box(40, 50), (80, 64), (0.5, 0.0), 0.0, texture(11, 0.5, 0.9))
ODD = {
    "three pixels wide": Moving("odd", box(3, 40), (95, 60), (0.6, 0.3), 1.0, texture(12, 0.6, 1.0)),
    "without texture": Moving("odd", box(30, 20), (100, 60), (1.0, 0.0)),
    "leaves the picture": Moving("odd", box(30, 20), (100, 50), (16.0, 0.0), 0.0, texture(12, 0.6, 1.0)),
    "out of the picture": Moving("odd", box(60, 20), (110, -11), (0.0, -2.0), 0.0, texture(12, 0.6, 1.0)),
    "a speck": Moving("odd", box(1.2, 1.2), (95, 60), (0.6, 0.3), 0.0, texture(12, 0.6, 1.0)),
    "without an area": Moving("odd", box(30, 0.0), (95, 60), (0.6, 0.3), 0.0, texture(12, 0.6, 1.0)),
    "wholly behind": Moving("odd", box(20, 20), (80, 64), (1.0, 0.0), 0.0, texture(12, 0.6, 1.0)),
}
"""Parts over a body, or under it, that have no look of their own, hardly any extent, or are not to be seen."""


def odd_objects() -> dict[str, tuple[Figure, list[RotoShape]]]:
    """Objects that must break nothing, and how an artist would draw them: keys on frame 0."""
    post = Moving("post", box(12, 90), (70, 60), (3.0, 0.0), 0.0, texture(15, 0.3, 1.0))
    found: dict[str, tuple[Figure, list[RotoShape]]] = {}
    for name, part in ODD.items():
        figure = Figure((part, BODY) if name == "wholly behind" else (BODY, part), 3)
        found[name] = figure, figure.shapes()
    behind = Figure((BODY, post), 3)
    found["an occluder"] = behind, [behind.shapes()[0], subtracting(behind.shapes()[1])]
    crowd = many_parts(20)
    found["many"] = crowd, crowd.shapes()
    return found


def many_parts(count: int) -> Figure:
    """Small boxes over each other, on two frames."""
    places = np.random.default_rng(0).uniform((50.0, 30.0), (110.0, 90.0), (count, 2))
    parts = [
        Moving(f"p{k}", box(9, 9), (float(x), float(y)), (0.5, 0.2), 0.0, texture(k, 0.3, 1.0, 4))
        for k, (x, y) in enumerate(places)
    ]
    return Figure(tuple(parts), 2)


def written(figure: Figure, shapes: Sequence[RotoShape], folder: Path) -> Path:
    """A figure as a plate in `folder`, and a project of its shapes beside it; the path of the project."""
    plate = folder / "plate"
    plate.mkdir()
    for frame in figure.frames:
        cv2.imwrite(str(plate / f"plate.{frame:04}.png"), figure.read(frame)[..., ::-1])
    path = folder / "odd.roam"
    height, width = SIZE
    clip = Clip(plate, 0, figure.count - 1, (width, height))
    file.save(Project(clip, Layer("root", "Root", tuple(shapes))), path)
    return path


def bending_body_on_a_pan(count: int) -> tuple[list[UInt8], UInt8]:
    """Pictures of a body that bends, while the camera goes along a wall by 10 pixels a frame, and its first mask."""
    height, width = SIZE
    places = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
    from_middle = places - np.array([70.0, 60.0])
    angle, distance = np.arctan2(from_middle[..., 1], from_middle[..., 0]), np.hypot(*np.moveaxis(from_middle, 2, 0))
    wall, cloth, noise = texture(11, 40.0, 210.0), texture(12, 60.0, 190.0), np.random.default_rng(3)
    pictures, masks = [], []
    for k in range(count):
        inside = distance < 26.0 + 9.0 * np.sin(2.0 * angle + 0.12 * k) + 5.0 * np.cos(3.0 * angle - 0.1 * k)
        picture = np.where(inside[..., None], cloth.at(places), wall.at(places + np.array([10.0 * k, 0.0])))
        pictures.append(np.uint8(np.clip(picture + noise.normal(0.0, 2.0, picture.shape), 0.0, 255.0)))
        masks.append(np.uint8(255) * inside)
    return pictures, masks[0]


def disc_that_comes_in(radius: float, speed: float, count: int = 5) -> tuple[list[UInt8], list[UInt8]]:
    """Pictures and masks of a disc that comes in over the left edge, beyond which half of it lies at first."""
    disc = Moving("disc", blob([radius] * 10), (0.0, 60.0), (speed, 0.0), 0.0, texture(7, 0.7, 1.0))
    figure = Figure((disc,), count)
    (shape,) = figure.shapes(*figure.frames)
    masks = [np.uint8(255) * (shape_matte(shape, k, SIZE) > 0.5) for k in figure.frames]
    return figure.pictures, masks


def ball_hidden_while_the_camera_pulls_out(count: int = 13) -> tuple[list[UInt8], list[UInt8]]:
    """Pictures and masks of a ball that passes behind a post, seen at three times its size at first and 1 at last."""
    height, width = 2 * SIZE[0], 2 * SIZE[1]
    places = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
    ground, ball = texture(21, 40.0, 150.0).at(places), np.array([225.0, 120.0, 40.0])
    post = (places[..., 0] > 148.0) & (places[..., 0] < 192.0)
    pictures, masks = [], []
    for k, zoom in enumerate(np.geomspace(1.2, 0.4, count)):
        inside = (np.hypot(places[..., 0] - 122.0 - 8.0 * k, places[..., 1] - 0.5 * height) < 14.0) & ~post
        scene = np.where(inside[..., None], ball, np.where(post[..., None], 0.5 * ground + 90.0, ground))
        view = np.array([[zoom, 0.0, 0.5 * (SIZE[1] - zoom * width)], [0.0, zoom, 0.5 * (SIZE[0] - zoom * height)]])
        pictures.append(np.uint8(np.clip(cv2.warpAffine(scene, view, SIZE[::-1]), 0.0, 255.0)))
        masks.append(np.uint8(255) * (cv2.warpAffine(inside.astype(np.float32), view, SIZE[::-1]) > 0.5))
    return pictures, masks


def card_that_comes_out(count: int = 13) -> tuple[list[UInt8], list[UInt8]]:
    """Pictures and masks of a card with a texture of its own that passes behind a board wider than itself."""
    height, width = 2 * SIZE[0], 2 * SIZE[1]
    places = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
    ground, face = texture(23, 60.0, 110.0), texture(24, 120.0, 230.0)
    board = (places[..., 0] > 110.0) & (places[..., 0] < 190.0)
    pictures, masks = [], []
    for k in range(count):
        on_card = places - (50.0 + 14.0 * k, 0.5 * height)
        inside = (np.abs(on_card) < (34.0, 42.0)).all(axis=-1) & ~board
        scene = np.where(inside[..., None], face.at(on_card), np.where(board[..., None], 90.0, ground.at(places)))
        pictures.append(np.uint8(np.clip(scene, 0.0, 255.0)))
        masks.append(np.uint8(255) * inside)
    return pictures, masks


def card_behind_a_pole(count: int = 13) -> tuple[list[UInt8], list[UInt8]]:
    """Pictures and masks of a card that passes behind a pole, on whose both sides some of it is seen in the middle."""
    height, width = 480, 640
    places = np.stack(np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5), axis=-1)
    ground, face, bark = texture(31, 60.0, 120.0), texture(32, 110.0, 240.0), texture(33, 60.0, 100.0)
    pole = (places[..., 0] > 270.0) & (places[..., 0] < 370.0)
    behind, pictures, masks = np.where(pole[..., None], bark.at(places), ground.at(places)), [], []
    for k in range(count):
        on_card = places - (184.0 + 16.0 * k, 240.0)
        inside = (np.abs(on_card) < (80.0, 80.0)).all(axis=-1) & ~pole
        scene = np.where(inside[..., None], face.at(on_card), behind)
        pictures.append(np.uint8(np.clip(scene, 0.0, 255.0)))
        masks.append(np.uint8(255) * inside)
    return pictures, masks
