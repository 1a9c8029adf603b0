"""A project in which every field of every object is away from its default: what golden files hold."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np

from roam_core.geometry import bezier
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
)
from roam_core.roto.project import PALETTE

POINTS = bezier.polygon_points([(0.1, 0.2), (10.0, 1 / 3), (-7.25, 1e-17)])
CURVE = POINTS + np.linspace(-1.0, 1.0, 18).reshape(3, 3, 2) / 7.0
LATER = {"number": 4, "list": [1, [2.5, None]], "text": "ä"}
"""A field that a later program might write."""
RUN = 12
"""Tracked keys in a row: enough to be packed."""


def first_project(folder: Path) -> Project:
    """What a file of version 1 could hold, its clip beside `folder`."""
    tracked = tuple(
        Keyframe(
            1002 + k,
            CURVE + k / 3.0,
            CURVE * 0.1 + k,
            origin=Origin.ENGINE,
            interpolation=Interpolation.HOLD,
            confidence=0.75 + k / 100.0,
            vertex_confidence=np.array([0.1, 0.2, 0.3]) + k / 10.0,
            inputs=f"forward:baseline:{k // 5}",
        )
        for k in range(RUN)
    )
    drawn = Keyframe(1001, POINTS, POINTS + 3.0, interpolation=Interpolation.SMOOTH, extra={"later": LATER})
    last = Keyframe(1030, CURVE, origin=Origin.ENGINE, confidence=0.5, inputs="forward:lean:0")
    shape = RotoShape(
        "shape-1", 'Füße "links"', (drawn, *tracked, last), False, (0.1, 0.2, 0.3), BlendMode.DIFFERENCE, 0.25, True,
        -2.5, MotionBlur(0.7, -0.1, 12), (1001, 1049), False, True, Spline.BSPLINE, "body", False,
        ((1001, 1), (1010, -1)), extra={"later": LATER},
    )  # fmt: skip
    box = tuple(Keyframe(k, POINTS + k / 7.0, None, Origin.ENGINE) for k in range(RUN))
    polygon = RotoShape("shape-2", "Box", box, colour=PALETTE[0], blend=BlendMode.PLUS)  # "add" in versions 1 and 2
    turn = np.array([[0.9, -0.1, 12.5], [0.1, 0.9, 1 / 3], [1e-5, 0.0, 1.0]])
    moves = LayerTransform.of({1001: np.eye(3), 1003: turn})
    inner = Layer("layer-1", "Inner", (shape, polygon), False, True, 0.5, True, transform=moves, extra={"later": LATER})
    clip = Clip(
        folder / "plates" / "plate.%04d.exr", 1001, 1048, (960, 540), 23.976, 2.0, "linear", extra={"later": LATER}
    )
    marks = (Mark(1003, "Füße"), Mark(1010))
    return Project(clip, Layer("root", "Root", (inner,), extra={"later": LATER}), marks, {"later": LATER})


def second_project(folder: Path) -> Project:
    """What a file of version 2 may hold: fields of a later program in every object, and keys in both forms."""
    first = first_project(folder)
    inner = first.root.children[0]
    assert isinstance(inner, Layer)
    assert inner.transform is not None
    shape = next(inner.shapes())
    assert shape.motion_blur is not None
    shape = replace(shape, motion_blur=replace(shape.motion_blur, extra={"later": LATER}))
    all_told = tuple(replace(key, frame=key.frame + 100, extra={"later": LATER}) for key in shape.keys[1 : RUN + 1])
    last = replace(all_told[0], frame=1200, interpolation=Interpolation.SMOOTH)
    tracked = RotoShape("shape-3", "Tracked", (*all_told, last), colour=PALETTE[0], blend=BlendMode.PLUS)
    moves = replace(inner.transform, extra={"later": LATER})
    inner = replace(inner, children=(shape, *inner.children[1:], tracked), transform=moves)
    return replace(
        first,
        clip=replace(first.require_clip(), content="0123456789abcdef0123456789abcdef"),
        root=replace(first.root, children=(inner,)),
        marks=(replace(first.marks[0], extra={"later": LATER}), *first.marks[1:]),
    )


def third_project(folder: Path) -> Project:
    """What a file of version 3 may hold: values that vary with time, and layers that join by a mode."""
    second = second_project(folder)
    inner = second.root.children[0]
    assert isinstance(inner, Layer)
    hold = ValueKey(1010, 0.125, Interpolation.HOLD, extra={"later": LATER})
    fades = Animated((ValueKey(1001, 1 / 3), hold, ValueKey(1020, 1.0, Interpolation.SMOOTH)))
    soft = Animated((ValueKey(1001, -2.5), ValueKey(1040, 12.0)))
    shape, *others = inner.shapes()
    faded = RotoShape("shape-4", "Faded", (Keyframe(1001, POINTS),), colour=PALETTE[0], opacity=fades, feather=soft)
    shape = replace(shape, opacity=fades, feather=soft)
    inner = replace(inner, children=(shape, *others, faded), opacity=fades, blend=BlendMode.SUBTRACT)
    return replace(second, root=replace(second.root, children=(inner,)))


def present_project(folder: Path) -> Project:
    """What a file of this program may hold beyond the stored one of version 3: tangents, the plate's layer, a track's
    figures, keys of some points, a compound, fields of a later program in a value that varies.

    A field that older files of the version do without stands here, not in the project that is stored.
    """
    third = third_project(folder)
    inner = third.root.children[0]
    assert isinstance(inner, Layer)
    assert inner.transform is not None
    told = replace(
        inner.transform,
        confidence=((1001, 1 / 3), (1003, 0.875)),
        adjusted=(1001,),
        points=((1 / 3, -4.0), (7.0, 1e-17)),
        areas=(13.5, 31.0),
        surface=((0.1, 0.2), (10.0, 1 / 3), (9.0, 8.0), (-1e-17, 7.0)),
    )
    clip = replace(third.require_clip(), layer="beauty")
    tracked = inner.children[2]
    assert isinstance(tracked, RotoShape)
    in_part = replace(tracked, keys=tuple(replace(key, set_points=(0, 2)) for key in tracked.keys))
    bent = Animated((ValueKey(1001, 0.5, slopes=(0.0, 1 / 30)), ValueKey(1010, 0.75, slopes=(-1e-17, 0.0))))
    bent = replace(bent, extra={"later": LATER})
    in_part = replace(in_part, compound="mask-0123456789ab")
    children = (*inner.children[:2], in_part, *inner.children[3:])
    inner = replace(inner, transform=told, opacity=bent, children=children)
    return replace(third, clip=clip, root=replace(third.root, children=(inner,)))
