"""How the time of a frame grows: with nodes, moves, landmarks, the size of the shape and of the picture.

N, D and M are varied on the demo shot at 480p, sizes on a drawn shot. Each row gives its ratio to the first row of its
group and to OpenCV's fastest DIS flow over the whole of the same pictures, in the same run.
"""

from __future__ import annotations

import argparse
import time
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from benchmarks import demo_shot, processes, report
from benchmarks.shots import Shot, matte
from benchmarks.variants import Variant
from benchmarks.yardstick import flow_seconds
from roam_core import track
from roam_core.arrays import Array, UInt8
from roam_core.params import DEFAULT_CONFIG, params_for
from roam_core.propagate import warm_up
from roam_core.roto import Keyframe, RotoShape

SETTLING = 2
"""Frames at the beginning that are solved but not counted."""
POINTS = 12
"""Control points of the drawn shape."""
RADII = (8, 16, 32, 64, 128, 192)
"""Pixels of a picture of 854x480."""
WIDTHS = (427, 854, 1280, 1920, 2880, 3840)
"""Pixels across pictures of 16:9 whose shape grows with them, and of those whose shape stays as it is."""
STILL = 60
"""Radius in pixels of the shape that does not grow with the picture."""


@dataclass(frozen=True)
class Case:
    """One row: what is varied and how far, the configuration, and the shot with its shape."""

    group: str
    value: str
    variant: Variant
    shot: Shot
    shape: RotoShape


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `scaling` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help="for the sizes (default: %(default)s)")
    parser.add_argument("--frames", type=int, default=8, metavar="N", help="frames that are timed")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Time every case on one thread, and report."""
    params_for(given.config)
    threads = cv2.getNumThreads()
    processes.one_thread()
    try:
        warm_up()
        count = given.frames + SETTLING + 1
        cases = [*_of_parameters(count), *_of_sizes(given.config, count)]
        measured = [(case, *seconds(case)) for case in cases]
    finally:
        cv2.setNumThreads(threads)
    rows, first = [], dict[str, float]()
    for case, ours, flow in measured:
        base = first.setdefault(case.group, ours)
        rows.append([case.group, case.value, f"{1000 * ours:.1f}", f"{ours / base:.2f}", f"{ours / flow:.2f}"])
    head = ["what", "value", "ms a frame", "times the first", "times DIS"]
    title = f"Medians of {given.frames} frames, processor time of one thread. {report.circumstances()}."
    result = {"rows": [[case.group, case.value, ours, flow] for case, ours, flow in measured]}
    report.write("scaling", f"{title}\n\n{report.table(head, rows)}", result, publish=given.publish)


def seconds(case: Case) -> tuple[float, float]:
    """The median processor seconds of a frame, and of the yardstick on the same pictures."""
    laps, params = [], case.variant.params
    began = time.thread_time()
    for _ in track(case.shot.read, [case.shape], case.shot.frames, params):
        laps.append(time.thread_time() - began)
        began = time.thread_time()
    flow = flow_seconds(case.shot.pictures)
    return float(np.median(laps[SETTLING:])), float(np.median(flow))


def _of_parameters(count: int) -> list[Case]:
    """N and D under `lean`, M under `medium`, on the demo."""
    size = demo_shot.SIZES["480p"]
    shot = demo_shot.load(size, min(count, demo_shot.LONGEST))
    shape = demo_shot.true_shape(shot.first, size)

    def case(group: str, value: object, config: str, changes: Mapping[str, Any]) -> Case:
        return Case(group, str(value), Variant(f"{group} {value}", config, changes), shot, shape)

    return [
        *(case("nodes N", n, "lean", {"min_nodes": n, "max_nodes": n}) for n in (25, 50, 100, 200, 400)),
        *(case("moves D", f"{w}x{w}", "lean", {"window": w}) for w in (3, 5, 7, 9, 11, 13)),
        *(case("landmarks M", m, "medium", {"landmarks.count": m}) for m in (5, 10, 20, 40, 80)),
    ]


def _of_sizes(config: str, count: int) -> list[Case]:
    """The size of the shape, of the picture with its shape, and of the picture alone."""
    cases = []
    for radius in RADII:
        cases.append(_drawn("shape, radius in px at 480p", f"{radius}", config, (854, 480), radius, count))
    for width in WIDTHS:
        size = (width, round(width * 9 / 16))
        cases.append(_drawn("picture and shape", f"{size[0]}x{size[1]}", config, size, 0.2 * size[1], count))
    for width in WIDTHS:
        size = (width, round(width * 9 / 16))
        name = f"picture alone, shape of {STILL} px"
        cases.append(_drawn(name, f"{size[0]}x{size[1]}", config, size, STILL, count))
    return cases


def _drawn(group: str, value: str, config: str, size: tuple[int, int], radius: float, count: int) -> Case:
    shot, shape = drawn(size, radius, count)
    return Case(group, value, Variant(f"{config} {value}", config), shot, shape)


def drawn(size: tuple[int, int], radius: float, count: int) -> tuple[Shot, RotoShape]:
    """A textured blob of a `radius` that glides over a textured background, in pictures of `size` (w, h), and its
    outline.

    It moves by a fifteenth of its radius a frame, so that every size has the same picture but for its scale.
    """
    width, height = size
    background = _texture(size, radius, 1) // 3
    body = _texture((int(2.6 * radius) + 4, int(2.6 * radius) + 4), radius, 2) // 3 * 2 + 60
    pictures, masks = [], []
    start = np.array([0.4 * width, 0.45 * height])
    rest = _blob(radius)
    for frame in range(count):
        centre = start + np.array([2.0, 1.0]) * radius / 30.0 * frame
        shape = RotoShape("shape-1", "Drawn", (Keyframe(0, rest + centre),))
        mask = matte([shape], 0, (height, width))
        shift = np.array([[1.0, 0.0, centre[0] - body.shape[1] / 2], [0.0, 1.0, centre[1] - body.shape[0] / 2]])
        moved = cv2.warpAffine(body, shift, size, borderMode=cv2.BORDER_REFLECT)
        pictures.append(np.where(mask[..., None], moved, background))
        masks.append(mask)
    return Shot("drawn", 0, pictures, masks), RotoShape("shape-1", "Drawn", (Keyframe(0, rest + start),))


def _texture(size: tuple[int, int], radius: float, seed: int) -> UInt8:
    """Smooth coloured noise `(h, w, 3)` whose grain is a tenth of the shape's radius."""
    grain = max(radius / 10.0, 1.0)
    coarse = max(int(size[1] / grain), 2), max(int(size[0] / grain), 2), 3
    noise = np.random.default_rng(seed).integers(0, 256, coarse, dtype=np.uint8)
    return np.asarray(cv2.resize(noise, size, interpolation=cv2.INTER_CUBIC), dtype=np.uint8)


def _blob(radius: float) -> Array:
    """A wavy closed spline `(POINTS, 3, 2)` around the origin."""
    angle = np.arange(POINTS) * 2.0 * np.pi / POINTS
    around = np.stack([np.cos(angle), np.sin(angle)], axis=1)
    anchors = radius * (1.0 + 0.15 * np.cos(3.0 * angle))[:, None] * around
    tangent = (np.roll(anchors, -1, axis=0) - np.roll(anchors, 1, axis=0)) / 6.0
    return np.stack([anchors, anchors - tangent, anchors + tangent], axis=1)
