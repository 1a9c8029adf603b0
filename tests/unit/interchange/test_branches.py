"""Layers with modes of their own in programs whose masks know no layers: their renderers show our matte."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.interchange.after_effects.exporter import mask_script
from roam_core.interchange.blender.exporter import blender_script
from roam_core.interchange.fusion.exporter import fusion_setting
from roam_core.interchange.natron import natron_script
from roam_core.matte import render_matte
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, Keyframe, Layer, Project, RotoShape, ValueKey
from tests.judges import after_effects, blender, fusion, natron
from tests.judges.coverage import overlap

SIZE = (60, 90)
CLIP = Clip(Path("plate"), 1001, 1012, (SIZE[1], SIZE[0]))
Judge = Callable[[Project, float], np.ndarray]


def block(number: int, left: float, top: float, **values: object) -> RotoShape:
    """A leaf of 40 x 30 pixels with uneven handles."""
    anchors = np.array([left, top]) + np.array([[0.0, 15.0], [20.0, 0.0], [40.0, 13.0], [22.0, 30.0]])
    into = np.array([[1.0, 9.0], [-11.0, 1.0], [-1.0, -7.0], [9.0, 0.0]])
    out = np.array([[-1.0, -8.0], [9.0, -1.0], [2.0, 9.0], [-12.0, 1.0]])
    points = np.stack([anchors, anchors + into, anchors + out], axis=1)
    return replace(RotoShape(f"shape-{number}", f"S{number}", (Keyframe(1001, points),)), **values)  # type: ignore[arg-type]


def box(number: int, left: float, top: float, right: float, bottom: float, **values: object) -> RotoShape:
    corners = [(left, top), (right, top), (right, bottom), (left, bottom)]
    key = Keyframe(1001, bezier.polygon_points(corners))
    return replace(RotoShape(f"shape-{number}", f"S{number}", (key,)), **values)  # type: ignore[arg-type]


LOW = block(21, 5.0, 5.0)
HOLE = block(22, 18.0, 12.0, blend=BlendMode.SUBTRACT)
HIGH = block(23, 35.0, 20.0)
FADE = Animated(
    (
        ValueKey(1001, 0.0),
        ValueKey(1005, 1.0, Interpolation.HOLD),
        ValueKey(1009, 0.25, Interpolation.SMOOTH),
        ValueKey(1012, 0.75),
    )
)


def inner(*children: Layer | RotoShape, **values: object) -> Layer:
    return replace(Layer("layer-1", "Inner", children), **values)  # type: ignore[arg-type]


PROJECTS: dict[str, tuple[Layer | RotoShape, ...]] = {
    "a hole in a layer above": (LOW, inner(HIGH, replace(HOLE, id="shape-9"))),
    "an inverted layer": (block(9, 2.0, 20.0), inner(LOW, HIGH, invert=True)),
    "an inverted layer alone": (inner(LOW, HIGH, invert=True),),
    "an inverted layer of nothing": (inner(invert=True),),
    "a dimmed layer": (LOW, inner(block(9, 25.0, 10.0), HIGH, opacity=0.4)),
    "a dimmed, inverted layer": (LOW, inner(block(9, 25.0, 10.0), HIGH, opacity=0.4, invert=True)),
    "a layer that fades": (LOW, inner(block(9, 25.0, 10.0), HIGH, opacity=FADE)),
    "a shape that fades": (replace(LOW, opacity=FADE), HOLE, HIGH),
    "shapes that act on a layer": (
        LOW,
        inner(HIGH, block(9, 20.0, 8.0), opacity=0.7),
        block(4, 30.0, 5.0, blend=BlendMode.DIFFERENCE, opacity=0.8),
        block(5, 10.0, 25.0, blend=BlendMode.SUBTRACT, opacity=0.5),
        block(6, 45.0, 10.0, blend=BlendMode.MAX, opacity=0.6),
        block(7, 40.0, 25.0, blend=BlendMode.PLUS, opacity=0.3),
        box(8, 3.0, 3.0, 80.0, 50.0, blend=BlendMode.INTERSECT),
    ),
    "layers in layers": (
        LOW,
        inner(
            HIGH,
            Layer("layer-2", "Deep", (block(9, 40.0, 5.0), block(8, 45.0, 10.0, blend=BlendMode.INTERSECT))),
            Layer("layer-3", "Deeper", (block(10, 50.0, 25.0), block(11, 30.0, 28.0)), invert=True, opacity=0.5),
            block(12, 25.0, 20.0, blend=BlendMode.SUBTRACT),
        ),
        block(13, 0.0, 30.0),
    ),
    **{
        f"a layer that joins by {mode}": (
            LOW,
            inner(block(9, 25.0, 10.0), HIGH, opacity=0.6 if mode is not BlendMode.SUBTRACT else FADE, blend=mode),
        )
        for mode in BlendMode
    },
    "a layer of holes": (LOW, inner(block(9, 25.0, 10.0), HIGH, blend=BlendMode.SUBTRACT)),
    "a layer that intersects for a time": (
        LOW,
        inner(block(9, 25.0, 10.0, lifetime=(1003, 1008)), blend=BlendMode.INTERSECT),
    ),
    "an inverted layer that subtracts": (LOW, inner(block(9, 8.0, 5.0), HIGH, blend=BlendMode.SUBTRACT, invert=True)),
    "an empty layer that intersects": (LOW, inner(blend=BlendMode.INTERSECT)),
    "a root that acts as one": (LOW, HOLE, HIGH),
    "all modes, flat": (
        LOW,
        block(2, 15.0, 10.0, opacity=0.6),
        block(3, 25.0, 15.0, blend=BlendMode.SUBTRACT, opacity=0.5),
        block(4, 35.0, 20.0, blend=BlendMode.DIFFERENCE),
        block(5, 45.0, 5.0, blend=BlendMode.MAX, opacity=0.3),
        box(6, 10.0, 10.0, 75.0, 50.0, blend=BlendMode.INTERSECT),
        box(7, 0.0, 0.0, 30.0, 30.0, blend=BlendMode.PLUS, opacity=0.5),
    ),
    "inverted and dimmed shapes": (LOW, block(2, 15.0, 10.0, opacity=0.6, invert=True), HOLE),
    "a lifetime that intersects": (
        LOW,
        HIGH,
        block(4, 20.0, 10.0, blend=BlendMode.INTERSECT, lifetime=(1003, 1006), opacity=0.8),
    ),
    "an inverted lifetime": (LOW, block(4, 20.0, 10.0, invert=True, lifetime=(1003, 1006))),
    "lowest shapes of other modes": (
        replace(HOLE, id="shape-8"),
        block(4, 20.0, 10.0, blend=BlendMode.DIFFERENCE),
        LOW,
        HOLE,
    ),
    "soft differences": (
        block(1, 5.0, 5.0, opacity=0.7),
        block(2, 15.0, 10.0, blend=BlendMode.DIFFERENCE, opacity=0.5),
        block(3, 25.0, 20.0, blend=BlendMode.DIFFERENCE, opacity=FADE),
    ),
    "hidden and open": (
        block(1, 5.0, 5.0, visible=False),
        block(2, 15.0, 10.0, closed=False, blend=BlendMode.INTERSECT),
        LOW,
        block(3, 15.0, 10.0, visible=False, blend=BlendMode.INTERSECT),
        inner(block(4, 0.0, 0.0, visible=False), invert=True, visible=False),
    ),
    "nothing that shows": (block(1, 5.0, 5.0, visible=False),),
}
FRAMES = (1001, 1004, 1007, 1010)


def project_of(name: str) -> Project:
    root = Layer("root", "Root", PROJECTS[name])
    if name.startswith("a root"):
        root = replace(root, opacity=0.8, invert=True)
    return Project(CLIP, root)


@pytest.mark.parametrize("name", PROJECTS)
def test_after_effects_shows_our_matte(name: str, tmp_path: Path) -> None:
    project = project_of(name)
    scene = after_effects.Scene(mask_script(project)[0], tmp_path, CLIP.fps)
    for frame in FRAMES:
        assert overlap(render_matte(project, frame, SIZE), scene.matte(frame, SIZE)) > 0.998


@pytest.mark.parametrize("name", PROJECTS)
def test_fusion_shows_our_matte(name: str) -> None:
    project = project_of(name)
    flow = fusion.Flow(fusion_setting(project)[0])
    for frame in FRAMES:
        # Where hard edges cross, Fusion's Subtract takes one share of a pixel from the other, ROAM multiplies them.
        assert overlap(render_matte(project, frame, SIZE), flow.matte(frame, SIZE)) > 0.996


@pytest.mark.parametrize("name", PROJECTS)
def test_natron_shows_our_matte(name: str) -> None:
    project = project_of(name)
    text = natron_script(project)[0]
    for frame in FRAMES:
        assert overlap(render_matte(project, frame, SIZE), natron.matte(text, frame, SIZE)) > 0.998


@pytest.mark.parametrize("name", PROJECTS)
def test_blender_shows_our_matte(name: str, tmp_path: Path) -> None:
    project = project_of(name)
    shown = blender.mattes(blender_script(project)[0], tmp_path, list(FRAMES), SIZE)
    for frame, theirs in shown.items():
        assert overlap(render_matte(project, frame, SIZE), theirs) > 0.97
