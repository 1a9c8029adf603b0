"""Plates on disk: the first picture, playback, memory, and tracking with the decoding in it, from 480p to 4K.

Ten pictures of a drawn shot, scene-linear half floats in ZIP-compressed EXR, linked as 300 frames. Each case runs in a
process of its own. Tracking is timed in seconds of the processor, over all threads and with what is decoded ahead;
the first picture in seconds of the clock too, which a busy machine lengthens.
"""

from __future__ import annotations

import argparse
import os
import resource
import sys
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from multiprocessing import get_context
from pathlib import Path
from typing import TypeVar

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from benchmarks import report
from benchmarks.scaling import drawn
from roam_core.cli.plate import AHEAD, opened
from roam_core.media import FrameCache, open_clip
from roam_core.media.cache import DEFAULT_LIMIT
from roam_core.media.colour import to_display
from roam_core.media.curves import LINEAR, linear_from_srgb
from roam_core.propagate import track, warm_up
from roam_core.roto import RotoShape

SIZES = {"480p": (854, 480), "1080p": (1920, 1080), "4K": (3840, 2160)}
PICTURES, FRAMES = 10, 300
READ = 40
"""Frames: of 4K more than the cache holds."""
STILL = 60
"""Pixels across the object that does not grow with the picture."""
SHARE = 0.2
"""Of the picture's height: the radius of the object that does."""
T = TypeVar("T")


@dataclass(frozen=True)
class Opened:
    """The first picture of a plate: seconds of clock and processor; pictures a second from the cache; MiB at most."""

    clock: float
    processor: float
    from_cache: float
    memory: float


@dataclass(frozen=True)
class Tracked:
    """Tracking from files: processor seconds a frame, and MiB at most."""

    seconds: float
    memory: float


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `plates` may be told."""
    parser.add_argument("--frames", type=int, default=12, metavar="N", help="frames that are tracked and timed")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Write the plates, time every case, and report."""
    opening, tracking = {}, {}
    with tempfile.TemporaryDirectory() as place:
        for name, size in SIZES.items():
            for kind, radius in (("grows with it", SHARE * size[1]), (f"of {STILL} px", STILL / 2)):
                folder = Path(place) / f"{name} {kind}"
                shape = write_plate(folder, size, radius)
                if kind == "grows with it":
                    opening[name] = alone(first_picture, folder)
                tracking[name, kind] = alone(tracked, folder, shape, given.frames)
    base = tracking["1080p", f"of {STILL} px"].seconds
    rows = [
        [name, kind, f"{1000 * each.seconds:.0f}", f"{each.seconds / base:.2f}", f"{each.memory:.0f}"]
        for (name, kind), each in tracking.items()
    ]
    first = [
        [
            name,
            f"{1000 * each.clock:.0f}",
            f"{1000 * each.processor:.0f}",
            f"{each.from_cache:.0f}",
            f"{each.memory:.0f}",
        ]
        for name, each in opening.items()
    ]
    opened_head = ["plate", "first picture, ms", "of the processor", "pictures/s from cache", "most MiB"]
    tracked_head = ["plate", "object", "ms a frame", f"times 1080p of {STILL} px", "most MiB"]
    text = (
        f"Budget of the cache: {DEFAULT_LIMIT >> 20} MiB. {report.circumstances()}.\n\n"
        f"{report.table(opened_head, first)}\n\n"
        f"Tracking with `best`, decoding included.\n\n{report.table(tracked_head, rows)}"
    )
    result = {
        "opened": {name: vars(each) for name, each in opening.items()},
        "tracked": {" ".join(case): vars(each) for case, each in tracking.items()},
    }
    report.write("plates", text, result, publish=given.publish)


def write_plate(folder: Path, size: tuple[int, int], radius: float) -> RotoShape:
    """The drawn shot as files; its pictures come again backwards, so that the object never jumps. Its outline."""
    folder.mkdir(parents=True)
    shot, shape = drawn(size, radius, PICTURES)
    for number, picture in enumerate(shot.pictures):
        write_half(folder / f"picture{number}.tmp.exr", linear_from_srgb(picture / 255.0).astype(np.float16))
    there_and_back = [*range(PICTURES), *range(PICTURES - 2, 0, -1)]
    for frame in range(FRAMES):
        source = folder / f"picture{there_and_back[frame % len(there_and_back)]}.tmp.exr"
        os.link(source, folder / f"plate.{frame:04d}.exr")
    for source in folder.glob("*.tmp.exr"):
        source.unlink()
    return shape


def write_half(path: Path, picture: np.ndarray[tuple[int, ...], np.dtype[np.float16]]) -> None:
    """One scene-linear picture `(h, w, 3)` as a ZIP-compressed EXR."""
    spec = oiio.ImageSpec(picture.shape[1], picture.shape[0], 3, "half")
    spec.attribute("compression", "zip")
    output = oiio.ImageOutput.create(str(path))
    output.open(str(path), spec)
    output.write_image(picture)
    output.close()


def alone(function: Callable[..., T], *words: object) -> T:
    """`function(*words)` in a process of its own."""
    with ProcessPoolExecutor(1, mp_context=get_context("spawn")) as pool:
        return pool.submit(function, *words).result()


def peak_mebibytes() -> float:
    """The most memory that this process held."""
    unit = 1.0 if sys.platform == "darwin" else 1024.0
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * unit / (1 << 20)


def first_picture(folder: Path) -> Opened:
    """From the path to a picture for the screen; then more than the cache holds, and what it holds again."""
    clock, processor = time.perf_counter(), time.process_time()
    source = open_clip(folder)
    cache = FrameCache(source, DEFAULT_LIMIT)
    to_display(cache.read(source.frames[0]), source.colour_space)
    clock, processor = time.perf_counter() - clock, time.process_time() - processor
    for frame in source.frames[:READ]:
        cache.read(frame)
    held = sorted(cache.cached_frames())[-PICTURES:]
    began = time.process_time()
    for frame in held:
        to_display(cache.read(frame), source.colour_space)
    from_cache = len(held) / (time.process_time() - began)
    cache.close()
    return Opened(clock, processor, from_cache, peak_mebibytes())


def tracked(folder: Path, shape: RotoShape, count: int) -> Tracked:
    """The command's own way from files to curves, after those frames that are read ahead before anything is known."""
    warm_up()
    with opened(str(folder)) as plate:
        assert plate.source.colour_space == LINEAR
        frames = range(plate.source.frames[0], plate.source.frames[0] + AHEAD + 2 + count)
        plate.ahead_of(frames[0], frames)
        began = 0.0
        for solved in track(plate.parts_or_bridge, [shape], frames):
            plate.ahead_of(solved.frame, frames)
            if solved.frame == frames[AHEAD + 1]:
                began = time.process_time()
        seconds = (time.process_time() - began) / count
    return Tracked(seconds, peak_mebibytes())
