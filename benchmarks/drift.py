"""Points stay put: drift along the outline on the demo shot, whose truth is known, and crossings on every shot.

Drift: each control point of a tracked outline is projected onto the true outline of the frame; how far along the
outline that place lies from the true point is its offset. Its change from frame to frame is the drift.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from benchmarks import demo_shot, processes, report, shots, variants
from benchmarks.contact_sheet import GREEN, ORANGE, tenths, tile, write_sheet
from benchmarks.shots import first_shapes
from resources import demo
from roam_core import track
from roam_core.arrays import Array, Indices, UInt8
from roam_core.geometry import bezier, polyline
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.roto import RotoShape

AIM_FRAME, AIM_SHOT = 2.0, 6.0
"""Pixels asked for: the mean drift a frame, and the mean offset of the points, on every frame of the shot."""
DENSITY = 0.25
"""Pixels between the places of the true outline that points are projected onto."""
PICTURE = report.ROOT / "docs" / "images" / "demo-tracked.jpg"
"""Every tenth frame of the demo: the true outline green, the tracked one and its points orange."""
EDGES = 0.1
"""Pixels by which the polyline that is searched for crossings may stray from the spline."""


@dataclass(frozen=True, eq=False)
class Drift:
    """`offsets (F, P)`: pixels along the true outline from the true point to the tracked one, frame by frame."""

    offsets: Array

    @property
    def a_frame(self) -> float:
        """Mean pixels by which an offset changes from one frame to the next."""
        return float(np.abs(np.diff(self.offsets, axis=0, prepend=0.0)).mean())

    @property
    def at_the_end(self) -> float:
        """The mean offset of all points on the last frame."""
        return float(np.abs(self.offsets[-1]).mean())

    @property
    def worst_frame(self) -> float:
        """The mean offset of all points on the frame on which it is greatest."""
        return float(np.abs(self.offsets).mean(axis=1).max())

    @property
    def worst_point(self) -> float:
        """The greatest offset of any point on any frame."""
        return float(np.abs(self.offsets).max())


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `drift` may be told."""
    parser.add_argument("--config", metavar="A,B", default=DEFAULT_CONFIG, help=f"of {', '.join(CONFIGS)}")
    parser.add_argument("--frames", type=int, default=demo_shot.LONGEST - 1, metavar="N", help="frames of the demo")
    parser.add_argument("--shots", metavar="A,B", help="crossings on these shots only; '' for none")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Measure both, and report."""
    configs = variants.chosen(given.config)
    chosen = [] if given.shots == "" or not shots.is_present() else shots.names(given.shots)
    shot = demo_shot.load(count=min(given.frames + 1, demo_shot.LONGEST))
    rows, result = [], dict[str, Any]()
    for config in configs:
        drift, carried = tracked(shot, demo_shot.true_shape(shot.first), demo.true_points, config)
        pictures = [report.OUT / f"demo-{config}.jpg"]
        if given.publish and config == DEFAULT_CONFIG:
            pictures.append(PICTURE)
        for path in pictures:
            path.parent.mkdir(parents=True, exist_ok=True)
            write_sheet([_drawn(shot, carried, frame) for frame in tenths(shot.frames[1:])], path)
        found = processes.each(crossings, [(name, config) for name in chosen])
        crossed, outlines = (sum(each[k] for each in found) for k in (0, 1))
        cells = [f"{value:.2f}" for value in (drift.a_frame, drift.at_the_end, drift.worst_frame, drift.worst_point)]
        rows.append([f"`{config}`", *cells, f"{crossed} of {outlines}" if chosen else "-"])
        by_shot = dict(zip(chosen, found, strict=True))
        result[config] = {"offsets": np.round(drift.offsets, 2).tolist(), "crossed": by_shot}
    rows.append(["asked for", f"{AIM_FRAME:g}", *2 * [f"{AIM_SHOT:g}"], "-", "0"])
    head = ["configuration", "px a frame", "px at the end", "px, worst frame", "px, worst point"]
    head.append("outlines that cross themselves")
    title = f"Drift along the true outline on {len(shot.frames) - 1} frames of the demo, and crossings on "
    title += f"{len(chosen)} shots. {report.circumstances()}."
    text = f"{title}\n\n{report.table(head, rows)}"
    whole = given.shots is None
    report.write("drift" if whole else "drift some", text, result, publish=given.publish and whole)


def tracked(shot: shots.Shot, given: RotoShape, truth: Callable[[int], Array], config: str) -> tuple[Drift, RotoShape]:
    """Track a shape whose first key is its true outline; compare its points with the true ones of every frame."""
    rows, shape = [], given
    for result in track(shot.read, [given], shot.frames, config):
        shape = result.results[0].shape
        rows.append(offsets(shape.at(result.frame).points, truth(result.frame)))
    return Drift(np.array(rows)), shape


def _drawn(shot: shots.Shot, shape: RotoShape, frame: int) -> UInt8:
    """A frame of the demo with the true outline, the tracked one over it, and its points."""
    outline = shape.at(frame)
    lines = [np.round(line).astype(np.int32) for line in (bezier.flatten(demo.true_points(frame)), outline.flatten())]
    picture = shot.read(frame)[..., ::-1].copy()
    for x, y in outline.anchors:
        cv2.circle(picture, (round(x), round(y)), 5, ORANGE, -1, cv2.LINE_AA)
    return tile(picture, str(frame), [([lines[0]], GREEN), ([lines[1]], ORANGE)])


def offsets(found: Array, true: Array) -> Array:
    """Pixels `(P,)` along the closed spline `true (P, 3, 2)` from its points to where the points of `found` lie.

    A place is that of the true outline nearest to the tracked point; positive in the direction of the outline.
    """
    line = bezier.flatten(true)
    total = polyline.length(line)
    count = max(int(total / DENSITY), 8)
    places = polyline.resample(line, count)
    own, theirs = (_nearest(places, points[:, bezier.ANCHOR]) for points in (true, found))
    apart = (theirs - own) * (total / count)
    return np.asarray((apart + total / 2.0) % total - total / 2.0)


def _nearest(places: Array, positions: Array) -> Indices:
    apart = (positions[:, :1] - places[:, 0]) ** 2 + (positions[:, 1:] - places[:, 1]) ** 2
    return np.asarray(apart.argmin(axis=1))


def crossings(job: tuple[str, str]) -> tuple[int, int]:
    """How many tracked outlines of a shot cross themselves, and how many there are."""
    name, config = job
    shot = shots.load(name)
    crossed = outlines = 0
    for result in track(shot.read, first_shapes(shot), shot.frames, config):
        for each in result.results:
            line = bezier.flatten(each.shape.at(result.frame).points, True, EDGES)
            crossed += not polyline.is_simple(line)
            outlines += 1
    return crossed, outlines
