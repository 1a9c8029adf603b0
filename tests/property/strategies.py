"""What hypothesis draws from: point arrays, keys, shapes, layers, whole projects."""

from __future__ import annotations

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roam_core.arrays import Array
from roam_core.roto import (
    Animated,
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    LayerTransform,
    Mark,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    Spline,
    ValueKey,
    control_points,
    edit,
)
from roam_core.roto.animated import Animatable
from roam_core.roto.sight import is_point
from roam_core.roto.value_curves import bounded

FOLDER = Path("/shots/project")
"""Where a drawn project's clip lies, and its file would: absolute, as the program keeps them."""


@cache
def coordinates(limit: float = 2000.0) -> st.SearchStrategy[float]:
    """Pixels, also far outside of any picture."""
    return st.floats(-limit, limit, allow_subnormal=False)


@cache
def point_arrays(least: int = 2, most: int = 7) -> st.SearchStrategy[Array]:
    """Spline points `(P, 3, 2)`."""
    return st.integers(least, most).flatmap(points_of)


@cache
def points_of(count: int) -> st.SearchStrategy[Array]:
    """Spline points `(count, 3, 2)`."""
    return arrays(np.float64, (count, 3, 2), elements=coordinates())


@cache
def shares() -> st.SearchStrategy[float]:
    return st.floats(0.0, 1.0)


@cache
@st.composite
def animatables(draw: st.DrawFn, values: st.SearchStrategy[float], *, extra: bool = True) -> Animatable:
    """A value that stays, or one with keys, which may hold fields of a later program."""
    if draw(st.booleans()):
        return draw(values)
    frames = draw(st.lists(st.integers(-50, 2000), min_size=1, max_size=4, unique=True))
    modes = st.sampled_from(Interpolation)
    later = unknown_fields() if extra else st.just({})
    slopes = st.none() | st.tuples(st.floats(-1.0, 1.0), st.floats(-1.0, 1.0))
    return Animated(tuple(ValueKey(frame, draw(values), draw(modes), draw(slopes), draw(later)) for frame in frames))


@cache
def opacities(least: float = 0.0, *, extra: bool = True) -> st.SearchStrategy[Animatable]:
    """An opacity from `least` on at its keys, whose tangents keep it between none and full, as the verbs do."""
    return animatables(st.floats(least, 1.0), extra=extra).map(lambda value: bounded(value, "opacity"))


@cache
def unknown_fields() -> st.SearchStrategy[dict[str, Any]]:
    """Fields that a later version of the program might write."""
    plain = st.none() | st.booleans() | st.integers(-(2**40), 2**40) | st.floats(allow_nan=False, allow_infinity=False)
    values = st.recursive(
        plain | st.text(max_size=8),
        lambda inner: st.lists(inner, max_size=3) | st.dictionaries(st.text(max_size=5), inner, max_size=3),
        max_leaves=5,
    )
    return st.dictionaries(st.text(max_size=6).map(lambda name: f"later.{name}"), values, max_size=2)


@cache
@st.composite
def keyframes(draw: st.DrawFn, frame: int, count: int, origin: Origin | None = None) -> Keyframe:
    """A key of `count` points at `frame`; one of an engine is in sight: exports tell by opacity which are not."""
    origin = origin or draw(st.sampled_from(Origin))
    made: dict[str, Any] = {}
    points = points_of(count)
    if origin is Origin.ENGINE:
        points = points.filter(lambda drawn: not is_point(drawn))
        made = {
            "confidence": draw(st.none() | shares()),
            "vertex_confidence": draw(st.none() | arrays(np.float64, count, elements=shares())),
            "inputs": draw(st.text(max_size=12)),
        }
    return Keyframe(
        frame=frame,
        points=draw(points),
        feather=draw(st.none() | points_of(count)),
        origin=origin,
        interpolation=draw(st.sampled_from(Interpolation)),
        extra=draw(unknown_fields()),
        **made,
    )


@cache
@st.composite
def roto_shapes(draw: st.DrawFn, shape_id: str = "shape-1", interpolation: Interpolation | None = None) -> RotoShape:
    """A Bezier shape of 1-4 keys, closed or open."""
    closed = draw(st.booleans())
    count = draw(st.integers(3 if closed else 2, 6))
    frames = draw(st.lists(st.integers(-50, 2000), min_size=1, max_size=4, unique=True))
    keys = tuple(draw(keyframes(frame, count)) for frame in frames)
    if draw(st.booleans()):  # so many alike that a file packs them
        keys += tuple(replace(keys[0], frame=3000 + k, points=keys[0].points + k / 3.0) for k in range(20))
    start = draw(st.integers(-50, 2000))
    shape = RotoShape(
        id=shape_id,
        name=draw(st.text(max_size=10)),
        keys=keys,
        closed=closed,
        colour=draw(st.tuples(shares(), shares(), shares())),
        blend=draw(st.sampled_from(BlendMode)),
        opacity=draw(opacities()),
        invert=draw(st.booleans()),
        feather=draw(animatables(st.floats(-50.0, 50.0))),
        motion_blur=draw(st.none() | motion_blurs()),
        lifetime=draw(st.none() | st.integers(1, 500).map(lambda length: (start, start + length))),
        visible=draw(st.booleans()),
        locked=draw(st.booleans()),
        extra=draw(unknown_fields()),
    )
    return shape if interpolation is None else edit.set_interpolation(shape, shape.frames, interpolation)


@cache
def motion_blurs() -> st.SearchStrategy[MotionBlur]:
    """Motion blur of any kind."""
    return st.builds(MotionBlur, shares(), st.floats(-1.0, 1.0), st.integers(2, 64), unknown_fields())


@cache
@st.composite
def bspline_shapes(draw: st.DrawFn, shape_id: str = "shape-1") -> RotoShape:
    """A shape of 1-4 keys, each of them a uniform B-spline."""
    return control_points.with_spline(draw(roto_shapes(shape_id)), Spline.BSPLINE)


@cache
def any_shapes(shape_id: str) -> st.SearchStrategy[RotoShape]:
    """A shape of either kind."""
    return roto_shapes(shape_id) | bspline_shapes(shape_id)


@cache
@st.composite
def transforms(draw: st.DrawFn) -> LayerTransform:
    """A motion of a layer: 1-3 matrices that turn, scale, shear, move and tilt a little."""
    frames = draw(st.lists(st.integers(-100, 2000), min_size=1, max_size=3, unique=True))
    small = st.floats(-0.4, 0.4)

    def matrix() -> np.ndarray:
        linear = np.eye(2) + np.array([[draw(small), draw(small)], [draw(small), draw(small)]])
        tilt = [draw(st.floats(-1e-5, 1e-5)), draw(st.floats(-1e-5, 1e-5)), 1.0]
        return np.vstack([np.column_stack([linear, [draw(coordinates()), draw(coordinates())]]), tilt])

    moves = LayerTransform.of({frame: matrix() for frame in frames})
    return replace(moves, extra=draw(unknown_fields()))


@cache
@st.composite
def projects(draw: st.DrawFn) -> Project:
    """A clip or none, and layers nested up to three deep with shapes between them."""
    number = iter(range(1, 1000))

    def layer(depth: int, layer_id: str) -> Layer:
        kinds = draw(st.lists(st.sampled_from(["shape", "layer"] if depth < 3 else ["shape"]), max_size=2))
        children = tuple(
            draw(any_shapes(f"shape-{next(number)}")) if kind == "shape" else layer(depth + 1, f"layer-{next(number)}")
            for kind in kinds
        )
        return Layer(
            layer_id,
            draw(st.text(max_size=10)),
            children,
            visible=draw(st.booleans()),
            locked=draw(st.booleans()),
            opacity=draw(shares()),
            invert=draw(st.booleans()),
            transform=draw(st.none() | transforms()),
            extra=draw(unknown_fields()),
        )

    return Project(
        clip=draw(st.none() | clips()), root=layer(0, "root"), marks=draw(marks()), extra=draw(unknown_fields())
    )


@cache
def marks() -> st.SearchStrategy[tuple[Mark, ...]]:
    """Marks of the timeline, at most one a frame, in order."""
    told = st.tuples(st.text(max_size=8), unknown_fields())
    found = st.dictionaries(st.integers(-50, 2000), told, max_size=3)
    return found.map(lambda marks: tuple(Mark(frame, *marks[frame]) for frame in sorted(marks)))


@cache
@st.composite
def clips(draw: st.DrawFn) -> Clip:
    """A reference to a plate beside, above or below the project."""
    name = draw(st.sampled_from(["plate", "plate.%04d.exr", "Bäume und Äste.mov", "a b"]))
    place = draw(st.sampled_from([FOLDER, FOLDER / "plates", FOLDER.parent, Path("/elsewhere")]))
    first = draw(st.integers(-100, 2000))
    return Clip(
        path=place / name,
        first=first,
        last=first + draw(st.integers(0, 500)),
        size=(draw(st.integers(1, 8192)), draw(st.integers(1, 8192))),
        fps=draw(st.floats(1.0, 120.0)),
        pixel_aspect=draw(st.floats(0.5, 2.0)),
        colour_space=draw(st.sampled_from(["sRGB", "linear", "log"])),
        content=draw(st.sampled_from(["", "0123456789abcdef"])),
        extra=draw(unknown_fields()),
    )
