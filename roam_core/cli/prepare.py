"""`roam prepare`: compile the engine's kernels now, so that neither the first track nor the first export waits."""

from __future__ import annotations

import argparse
import sys
import tempfile
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path
from time import perf_counter

import cv2
import numpy as np

from roam_core import propagate
from roam_core.cli.bar import bar
from roam_core.cli.lines import print_json
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import ExportOptions, KeyChoice, MaskOptions, read_shapes, write_shapes
from roam_core.interchange.reading import ImportOptions
from roam_core.matte import render_matte
from roam_core.params import CONFIGS
from roam_core.roto import Clip, Interpolation, Keyframe, MotionBlur, Project, RotoShape, edit

FRAMES = range(4)
SIZE = (96, 72)
"""Width and height of the pictures that are worked on."""

Step = tuple[str, Callable[[], object]]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("--json", action="store_true", help="print a line of JSON: the steps, with seconds")


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    seconds: dict[str, float] = {}
    steps = work()
    with bar(len(steps)) as progress:
        for name, step in steps:
            began = perf_counter()
            progress.set_description(name)
            step()
            seconds[name] = round(perf_counter() - began, 3)
            progress.update()
    if arguments.json:
        print_json({"seconds": seconds})
    print(f"The engine is prepared ({sum(seconds.values()):.0f} s).", file=sys.stderr)
    return 0


def work() -> list[Step]:
    """All that has to be done once for every kernel to be compiled, with a name each."""
    tracking: list[Step] = [(f"tracking ({config})", partial(propagate.warm_up, config)) for config in CONFIGS]
    parts = ("filling, a figure in parts", propagate.warm_up_parts)
    return [*tracking, parts, ("keys and mattes", _exported), ("masks", _imported)]


def _exported() -> None:
    box = np.array([(14, 24), (46, 24), (46, 40), (14, 40)], dtype=np.float64)
    moved = tuple(Keyframe(frame, polygon_points(box + 2.0 * frame)) for frame in (FRAMES[0], FRAMES[-1]))
    soft = RotoShape("warm-up", "warm-up", moved, motion_blur=MotionBlur(), feather=3.0)
    render_matte([soft, replace(soft, feather=0.0)], FRAMES[1], (SIZE[1], SIZE[0]))
    # A key on every frame, by which fewer can be found.
    dense = replace(soft, motion_blur=None, feather=0.0)
    keys = tuple(Keyframe(frame, dense.at(frame).points, interpolation=Interpolation.LINEAR) for frame in FRAMES)
    clip = Clip(Path("warm-up"), FRAMES[0], FRAMES[-1], SIZE)
    project = edit.add_shape(Project(clip), replace(dense, keys=keys))
    with tempfile.TemporaryDirectory() as folder:
        for smoothing in (0.0, 0.5):
            options = ExportOptions(keys=KeyChoice.REDUCED, tolerance=0.5, smoothing=smoothing)
            write_shapes(project, Path(folder) / f"shapes{smoothing}.nk", "nuke", options)


def _imported() -> None:
    from roam_core.proposal.mask_keys.keys import keys_from_mask  # numba: a command's help must not wait for it

    clip = Clip(Path("warm-up"), FRAMES[0], FRAMES[-1], SIZE)
    with tempfile.TemporaryDirectory() as folder:
        mask = np.zeros((SIZE[1], SIZE[0]), dtype=np.uint8)
        for frame in FRAMES:
            mask[:] = 0
            cv2.ellipse(mask, (40 + 2 * frame, 36), (22, 14), 20.0 * frame, 0, 360, 255, -1)
            # OpenCV itself writes to no folder of Windows whose name has accents, as that of a user may.
            (Path(folder) / f"mask.{frame:04d}.png").write_bytes(cv2.imencode(".png", mask)[1].tobytes())
        read = read_shapes(folder, clip, ImportOptions(masks=MaskOptions(keys=KeyChoice.REDUCED)))
    keys_from_mask(list(read.layer.shapes()), mask > 0, FRAMES[1])
