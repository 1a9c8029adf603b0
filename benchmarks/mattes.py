"""Seconds a frame for rendering and writing mattes: twenty moving shapes at 4K, as EXR and PNG files.

Processor time of all threads: how many of the machine's cores happened to be free does not show in it.
"""

from __future__ import annotations

import argparse
import tempfile
import time
from pathlib import Path

import numpy as np

from benchmarks import report
from roam_core.interchange.matte_style import DataWindow, Gathering, MatteFile, MatteStyle, Parts
from roam_core.interchange.mattes.exporter import write_mattes
from roam_core.matte import render_matte
from roam_core.roto import Keyframe, Layer, MotionBlur, RotoShape

SIZE = (4096, 2160)
"""Width and height of the pictures."""

SHAPES, POINTS, FRAMES = 20, 24, 5

FIRST_SECONDS = {
    "EXR, joint matte": 0.955,
    "EXR, a channel a shape": 12.17,
    "EXR, a channel a shape, feathered": 10.75,
    "sharp, rendered only": 0.736,
    "feathered by 20 px, rendered only": 1.677,
    "blurred, 16 samples, rendered only": 2.575,
}
"""Processor seconds a frame of the first version (0.1.0), which filled whole pictures for every shape; its mattes
written by OpenImageIO in the plainest way. Measured beside the first figures of the present one, on one machine."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `mattes` may be told."""
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Measure each kind of file and report."""
    measured = {name: _seconds(layer, style) for name, (layer, style) in _cases().items()}
    measured |= {f"{name}, rendered only": _rendering(layer) for name, layer in _layers().items()}
    rows = [
        [name, f"{seconds:.3f}", f"{FIRST_SECONDS[name] / seconds:.1f}" if name in FIRST_SECONDS else "-"]
        for name, seconds in measured.items()
    ]
    title = (
        f"{SHAPES} shapes, {SIZE[0]}x{SIZE[1]}, processor time, medians of {FRAMES} frames. {report.circumstances()}."
    )
    head = ["mattes", "s a frame", "times faster than at first"]
    report.write("mattes", f"{title}\n\n{report.table(head, rows)}", {"seconds": measured}, publish=given.publish)


def _layers() -> dict[str, Layer]:
    sharp = scene()
    return {
        "sharp": sharp,
        "feathered by 20 px": scene(feather=20.0),
        "blurred, 16 samples": scene(motion_blur=MotionBlur()),
    }


def _cases() -> dict[str, tuple[Layer, MatteStyle]]:
    layers = _layers()
    channels = MatteStyle(MatteFile.EXR, parts=Parts.SHAPE, gathering=Gathering.CHANNELS, window=DataWindow.TIGHT)
    return {
        "EXR, joint matte": (layers["sharp"], MatteStyle(MatteFile.EXR)),
        "EXR, a channel a shape": (layers["sharp"], channels),
        "EXR, a channel a shape, feathered": (layers["feathered by 20 px"], channels),
        "EXR, a channel a shape, blurred": (layers["blurred, 16 samples"], channels),
        "PNG, joint matte": (layers["sharp"], MatteStyle()),
    }


def scene(feather: float = 0.0, motion_blur: MotionBlur | None = None) -> Layer:
    """Twenty stars of different sizes that glide through the picture, always the same ones."""
    rng = np.random.default_rng(0)
    shapes = []
    for number in range(SHAPES):
        centre = rng.uniform(0.15, 0.85, 2) * SIZE
        angle = np.arange(POINTS) * 2.0 * np.pi / POINTS
        radius = rng.uniform(80.0, 420.0) * rng.uniform(0.7, 1.0, POINTS)
        outward = np.stack([np.cos(angle), np.sin(angle)], axis=1)
        along = np.stack([-outward[:, 1], outward[:, 0]], axis=1) * (2.0 / POINTS)
        points = centre + radius[:, None, None] * np.stack([outward, outward - along, outward + along], axis=1)
        keys = (Keyframe(1, points), Keyframe(FRAMES + 1, points + rng.uniform(-60.0, 60.0, 2)))
        shapes.append(RotoShape(f"shape-{number}", f"Shape {number}", keys, feather=feather, motion_blur=motion_blur))
    return Layer("root", "Root", tuple(shapes))


def _seconds(layer: Layer, style: MatteStyle) -> float:
    """The median time of a frame, rendered and written."""
    laps = []
    with tempfile.TemporaryDirectory() as folder:
        for frame in range(FRAMES + 1):  # the first one warms up
            began = time.process_time()
            write_mattes(layer, [frame], Path(folder), lambda f: f"m.{f:04d}{style.suffix}", SIZE[::-1], style=style)
            laps.append(time.process_time() - began)
    return float(np.median(laps[1:]))


def _rendering(layer: Layer) -> float:
    """The median time of a frame that is rendered only."""
    laps = []
    for frame in range(FRAMES + 1):
        began = time.process_time()
        render_matte(layer, frame, SIZE[::-1])
        laps.append(time.process_time() - began)
    return float(np.median(laps[1:]))
