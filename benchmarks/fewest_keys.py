"""How many keys a tracked shape needs: straight ones and Nuke's cubics, as tracked and smoothed through time.

The shape is tracked with `best` from one key. Smoothing moves the tracked outline by at most the reach; the errors of
the keys are measured from what it gives. The IoU is with the true masks, before any key is left out.
"""

from __future__ import annotations

import argparse
from typing import Any

import numpy as np

from benchmarks import demo_shot, report, shots
from benchmarks.shots import Shot
from roam_core import track
from roam_core.errors import RoamError
from roam_core.interchange.keys.reduction import Motion, Reduction, reduced
from roam_core.interchange.keys.smoothing import smoothed
from roam_core.params import DEFAULT_CONFIG
from roam_core.roto import RotoShape

REACHES = (0.0, 1.0, 2.0, 4.0)
"""Pixels by which smoothing may move the outline."""

TOLERANCES = (0.5, 1.0)
"""Pixels by which leaving out keys may move it."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `keys` may be told."""
    parser.add_argument("--shots", metavar="A,B", default="car-turn", help="beside the demo (%(default)s)")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Track each shot, take keys out, and report."""
    names = shots.names(given.shots) if given.shots else []
    cases = [measured(shot) for shot in (demo_shot.load(), *(shots.load(name) for name in names))]
    rows = [row for case in cases for row in _rows(case)]
    head = ["shot", "smoothed", "moved, mean", "IoU", "tolerance", "Nuke: keys", "error, mean", "straight: keys"]
    text = report.table([*head, "error, mean"], rows)
    title = f"Largest and mean errors in pixels. {report.circumstances()}."
    report.write("keys", f"{title}\n\n{text}", {"shots": cases}, publish=given.publish)


def measured(shot: Shot) -> dict[str, Any]:
    """All figures of one shot, of the largest of its shapes."""
    shape = tracked(shot)
    return {"shot": shot.name, "frames": len(shot.frames), "reaches": [_reach(shot, shape, reach) for reach in REACHES]}


def tracked(shot: Shot) -> RotoShape:
    """The largest shape of the first frame, with a key of the engine's on every frame."""
    shapes = shots.first_shapes(shot)
    for result in track(shot.read, shapes, shot.frames, DEFAULT_CONFIG):
        shapes = [each.shape for each in result.results]
    if not shapes:
        raise RoamError(f"Nothing is white in the first mask of {shot.name}.")
    return shapes[0]


def _reach(shot: Shot, shape: RotoShape, reach: float) -> dict[str, Any]:
    smoothing = smoothed(shape, reach) if reach else None
    even = shape if smoothing is None else smoothing.shape
    return {
        "reach": reach,
        "moved": [0.0, 0.0] if smoothing is None else [smoothing.max_error, smoothing.mean_error],
        "iou": float(
            np.mean([shots.overlap(shots.matte([even], f, shot.size), shot.mask(f)) for f in shot.frames[1:]])
        ),
        "tolerances": [
            {"tolerance": tolerance, **{motion.value: _told(reduced(even, tolerance, motion)) for motion in Motion}}
            for tolerance in TOLERANCES
        ],
    }


def _told(reduction: Reduction) -> dict[str, Any]:
    return {"keys": len(reduction.shape.keys), "error": [reduction.max_error, reduction.mean_error]}


def _rows(case: dict[str, Any]) -> list[list[str]]:
    def pair(values: list[float]) -> str:
        return f"{values[0]:.2f}, {values[1]:.2f}"

    rows = []
    for reach in case["reaches"]:
        for at in reach["tolerances"]:
            figures = [[str(at[m]["keys"]), pair(at[m]["error"])] for m in (Motion.CUBIC.value, Motion.LINEAR.value)]
            smoothing = f"{reach['reach']:g} px" if reach["reach"] else "no"
            front = [f"{case['shot']}, {case['frames']} frames", smoothing, pair(reach["moved"]), f"{reach['iou']:.3f}"]
            rows.append([*front, f"{at['tolerance']:g} px", *figures[0], *figures[1]])
    return rows
