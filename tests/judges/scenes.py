"""Projects that each ask one thing of a format: modes, layers, holes, soft edges, holds, names, sizes."""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from roam_core.arrays import Array
from roam_core.geometry import bezier
from roam_core.roto import (
    Animated,
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    Origin,
    Project,
    RotoShape,
    Spline,
    ValueKey,
    control_points,
)

SIZE = (321, 243)
"""Width and height: neither even, nor one a multiple of the other."""
FIRST, LAST = 1001, 1012
WHOLE = (1001, 1004, 1007, 1012)
BETWEEN = (1003.5, 1005.25, 1005.75, 1008.5)
"""Moments that motion blur and retimes see."""


@dataclass(frozen=True)
class Scene:
    """A project and the moments at which its matte is compared."""

    project: Project
    moments: tuple[float, ...] = WHOLE


def _clip(size: tuple[int, int] = SIZE, pixel_aspect: float = 1.0) -> Clip:
    return Clip(Path("/shots/plate.%04d.exr"), FIRST, LAST, size, 24.0, pixel_aspect)


def _project(*items: Layer | RotoShape, clip: Clip | None = None) -> Project:
    """The items with ids of their own."""
    return Project(clip or _clip(), _numbered(Layer("root", "Root", items), []))


def _numbered(layer: Layer, seen: list[str]) -> Layer:
    children: list[Layer | RotoShape] = []
    for child in layer.children:
        seen.append(child.name)
        kind = "layer" if isinstance(child, Layer) else "shape"
        named = replace(child, id=f"{kind}-{len(seen)}")
        children.append(_numbered(named, seen) if isinstance(named, Layer) else named)
    return replace(layer, children=tuple(children))


def ellipse(x: float, y: float, wide: float, high: float, turn: float = 0.0) -> Array:
    """Four points `(4, 3, 2)` about (x, y), turned by `turn` degrees."""
    k = 0.5522847498
    corners = np.array([[0, -1], [1, 0], [0, 1], [-1, 0]], dtype=np.float64)
    along = np.array([[k, 0], [0, k], [-k, 0], [0, -k]])
    points = np.stack([corners, corners - along, corners + along], axis=1) * (wide, high)
    angle = np.deg2rad(turn)
    turned: Array = points @ np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]]) + (x, y)
    return turned


def blob(name: str, x: float, y: float, wide: float = 60.0, high: float = 45.0, **fields: object) -> RotoShape:
    """A turning, moving ellipse with keys on three frames."""
    keys = (
        Keyframe(FIRST, ellipse(x, y, wide, high)),
        Keyframe(1006, ellipse(x + 14.0, y - 9.0, wide * 1.1, high, 20.0)),
        Keyframe(LAST, ellipse(x + 3.0, y + 12.0, wide, high * 0.9, 45.0)),
    )
    return RotoShape("shape", name, keys, **fields)  # type: ignore[arg-type]


def _still(name: str, points: Array, **fields: object) -> RotoShape:
    return RotoShape("shape", name, (Keyframe(FIRST, points),), **fields)  # type: ignore[arg-type]


def _held(interpolation: Interpolation) -> RotoShape:
    keys = (
        Keyframe(FIRST, ellipse(90.0, 120.0, 50.0, 40.0), interpolation=interpolation),
        Keyframe(1006, ellipse(150.0, 110.0, 60.0, 40.0), interpolation=interpolation),
        Keyframe(LAST, ellipse(210.0, 130.0, 50.0, 50.0)),
    )
    return RotoShape("shape", "Moves", keys)


def _modes() -> Project:
    return _project(
        blob("Base", 120.0, 120.0, 90.0, 80.0),
        blob("Add", 220.0, 100.0, 50.0, 40.0, opacity=0.6),
        blob("Cut", 90.0, 100.0, 30.0, 25.0, blend=BlendMode.SUBTRACT),
        blob("Apart", 180.0, 150.0, 50.0, 35.0, blend=BlendMode.DIFFERENCE),
        blob("Most", 60.0, 60.0, 45.0, 30.0, blend=BlendMode.MAX, opacity=0.75),
        blob("Keep", 140.0, 115.0, 130.0, 90.0, blend=BlendMode.INTERSECT),
        blob("Sum", 250.0, 180.0, 40.0, 40.0, blend=BlendMode.PLUS),
    )


def _layers() -> Project:
    """Layers with modes of their own inside, inverted, dimmed, in one another, and joined by a mode."""
    ring = Layer(
        "l", "Ring", (blob("Outer", 90.0, 90.0), blob("Hole", 90.0, 90.0, 30.0, 20.0, blend=BlendMode.SUBTRACT))
    )
    both = Layer(
        "l", "Both", (blob("One", 200.0, 90.0), blob("Two", 230.0, 100.0, blend=BlendMode.INTERSECT)), opacity=0.8
    )
    apart = Layer("l", "Apart", (blob("Left", 120.0, 170.0), blob("Right", 150.0, 175.0, blend=BlendMode.DIFFERENCE)))
    out = Layer("l", "Out", (blob("Window", 160.0, 120.0, 120.0, 90.0),), invert=True, opacity=0.7)
    held = Layer("l", "Held out", (blob("Post", 160.0, 120.0, 12.0, 140.0),), blend=BlendMode.SUBTRACT)
    return _project(blob("Ground", 100.0, 110.0, 50.0, 80.0), ring, both, Layer("l", "Nest", (apart, out)), held)


def _inverted() -> Project:
    return _project(
        blob("Out", 160.0, 120.0, 120.0, 80.0, invert=True),
        blob("Island", 150.0, 120.0, 50.0, 40.0),
        blob("Frame", 160.0, 120.0, 140.0, 100.0, blend=BlendMode.INTERSECT, invert=True, opacity=0.5),
    )


def _feathers() -> Project:
    wavy = ellipse(230.0, 120.0, 50.0, 60.0)
    outwards = (wavy - (230.0, 120.0)) * np.array([0.35, 0.1, 0.35, 0.2])[:, None, None]
    return _project(
        blob("Soft", 90.0, 120.0, feather=14.0),
        _still("Points", wavy).with_key(Keyframe(FIRST, wavy, outwards)),
    )


def _in_time() -> Project:
    fades = Animated(
        (ValueKey(FIRST, 0.2), ValueKey(1006, 1.0, Interpolation.HOLD), ValueKey(1010, 0.5), ValueKey(LAST, 0.8))
    )
    softens = Animated((ValueKey(FIRST, 2.0), ValueKey(LAST, 24.0)))
    dims = Animated((ValueKey(FIRST, 1.0), ValueKey(LAST, 0.4)))
    layer = Layer("l", "Dims", (blob("Within", 230.0, 120.0, 40.0, 50.0),), opacity=dims)
    return _project(
        blob("Fades", 60.0, 60.0, 40.0, 35.0, opacity=fades),
        blob("Softens", 90.0, 170.0, 50.0, 40.0, feather=softens),
        blob("Comes", 160.0, 60.0, 30.0, 30.0, lifetime=(1004, 1010)),
        layer,
    )


def _held_life() -> Project:
    return _project(_held(Interpolation.HOLD), blob("Comes", 240.0, 60.0, 30.0, 30.0, lifetime=(1004, 1009)))


def _splines() -> Project:
    hull = bezier.polygon_points([(40.0, 40.0), (140.0, 30.0), (150.0, 130.0), (90.0, 200.0), (30.0, 150.0)])
    round_one = control_points.with_spline(_still("B-spline", hull), Spline.BSPLINE)
    polygon = bezier.polygon_points([(180.0, 40.0), (300.0, 60.5), (280.25, 200.0), (200.0, 220.0)])
    return _project(round_one, _still("Polygon", polygon), blob("Curve", 170.0, 130.0))


NAMES = ("Shape 1", "Füße", "左手", "a\"b'c", "back\\slash", "{curly} [square] $dollar", "Рука", "x" * 70, "")
"""What artists, and those who wish harm, call a shape."""


def _names() -> Project:
    shapes = [_still(name, ellipse(30.0 + 30.0 * index, 120.0, 12.0, 60.0)) for index, name in enumerate(NAMES)]
    return _project(*shapes)


def tracked() -> RotoShape:
    """A shape with a key on every frame that shivers: what keys are reduced of."""
    rng = np.random.default_rng(7)
    keys = [
        Keyframe(
            FIRST + k,
            ellipse(100.0 + 6.0 * k, 120.0 - 0.3 * k * k, 60.0, 45.0, 4.0 * k) + rng.normal(0.0, 0.15, (4, 1, 2)),
            origin=Origin.ENGINE if k % 11 else Origin.ARTIST,
        )
        for k in range(LAST - FIRST + 1)
    ]
    return RotoShape("shape", "Tracked", tuple(keys))


SCENES: dict[str, Scene] = {
    "curves": Scene(_project(blob("Curve", 150.0, 120.0))),
    "splines, polygons": Scene(_splines()),
    "modes": Scene(_modes()),
    "holes": Scene(
        _project(
            blob("Outer", 150.0, 120.0, 100.0, 80.0), blob("Hole", 150.0, 120.0, 50.0, 40.0, blend=BlendMode.SUBTRACT)
        )
    ),
    "layers": Scene(_layers()),
    "inverted": Scene(_inverted()),
    "soft edges": Scene(_feathers()),
    "in time": Scene(_in_time()),
    "linear, between frames": Scene(_project(_held(Interpolation.LINEAR)), BETWEEN),
    "smooth": Scene(_project(_held(Interpolation.SMOOTH))),
    "holds, between frames": Scene(_held_life(), BETWEEN),
    "names": Scene(_names()),
    "odd size": Scene(_project(blob("Curve", 60.0, 200.0), clip=_clip((133, 401)))),
    "pixel aspect .5": Scene(_project(blob("Curve", 150.0, 120.0), clip=_clip(pixel_aspect=0.5))),
    "pixel aspect 2": Scene(_project(blob("Curve", 150.0, 120.0), clip=_clip(pixel_aspect=2.0))),
}
"""By what each asks. A format that shows one frame is asked for whole frames only."""
