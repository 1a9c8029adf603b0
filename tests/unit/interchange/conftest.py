"""A project with everything in it that a format may have to carry."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.interchange.nuke.exporter import roto_document
from roam_core.interchange.protocol import STANDARD, ExportOptions
from roam_core.roto import BlendMode, Clip, Interpolation, Keyframe, Layer, MotionBlur, Origin, Project, RotoShape

CLIP = Clip(Path("/plates/shot.%04d.exr"), 1001, 1040, (1920, 1080), pixel_aspect=1.0)


def points(seed: int, count: int = 5) -> Array:
    """Random spline points `(count, 3, 2)` around the image, handles up to 80 pixels long."""
    rng = np.random.default_rng(seed)
    anchors = rng.uniform([-100.0, -100.0], [2000.0, 1200.0], (count, 2))
    return anchors[:, None] + np.concatenate([np.zeros((count, 1, 2)), rng.uniform(-80, 80, (count, 2, 2))], axis=1)


def animated(name: str, interpolation: Interpolation = Interpolation.LINEAR, seed: int = 0) -> RotoShape:
    """Keys at 1001, 1011 (the engine's), 1012 and 1030, all of one interpolation."""
    frames = (1001, 1011, 1012, 1030)
    keys = tuple(
        Keyframe(
            frame,
            points(seed + frame),
            origin=Origin.ENGINE if frame == 1011 else Origin.ARTIST,
            interpolation=interpolation,
        )
        for frame in frames
    )
    return RotoShape(id=f"shape-{name}", name=name, keys=keys)


@pytest.fixture
def project() -> Project:
    """Nested layers; animated, feathered, blurred, open, locked and invisible shapes."""
    soft = RotoShape(
        id="shape-soft",
        name="Soft",
        keys=(
            Keyframe(1001, points(1), np.random.default_rng(2).uniform(-20, 20, (5, 3, 2))),
            Keyframe(1021, points(3)),
        ),
        blend=BlendMode.SUBTRACT,
        opacity=0.25,
        invert=True,
        feather=12.5,
        motion_blur=MotionBlur(shutter=0.75, phase=-0.375, samples=32),
        lifetime=(1005, 1015),
    )
    still = RotoShape("shape-still", "Still", (Keyframe(1001, points(4, 3)),), colour=(0.25, 0.5, 0.75), locked=True)
    stroke = RotoShape("shape-open", "Open", (Keyframe(1001, points(5, 4)),), closed=False, visible=False)
    deep = Layer("layer-2", "Deep", (animated("Held", Interpolation.HOLD, 10),), locked=True)
    body = Layer("layer-1", "Body", (animated("Arm"), deep, soft), visible=False, opacity=0.5, invert=True)
    root = Layer("root", "Root", (still, body, stroke, animated("Smooth", Interpolation.SMOOTH, 20)))
    return Project(CLIP, root)


def roto_script(project: Project, options: ExportOptions = STANDARD) -> str:
    """The text of what the Nuke exporter writes."""
    return roto_document(project, options)[0]
