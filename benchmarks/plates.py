"""Plates on disk: the first picture, playback, memory, and tracking with the decoding in it, from 480p to 4K.

Ten pictures of a drawn shot, scene-linear half floats in ZIP-compressed EXR, linked as 300 frames, and decoded by other
processes as in the program. Each case runs in a process of its own. Tracking is timed in seconds of the processor, over
all threads and processes and with what is decoded ahead; the first picture in seconds of the clock too, which a busy
machine lengthens.
"""

from __future__ import annotations

import argparse
import os
import tempfile
import time
from collections.abc import Callable
from concurrent.futures import ProcessPoolExecutor
from dataclasses import dataclass
from functools import partial
from multiprocessing import get_context
from pathlib import Path
from typing import TypeVar

import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from benchmarks import report
from benchmarks.scaling import drawn
from roam_core import edit
from roam_core.arrays import Image
from roam_core.cli.plate import AHEAD, opened
from roam_core.media import FrameCache, decoding, open_clip
from roam_core.media.cache import DEFAULT_LIMIT
from roam_core.media.colour import to_display
from roam_core.media.curves import LINEAR, linear_from_srgb
from roam_core.media.proxies import STEPS, reduced
from roam_core.propagate import fill_span, track, warm_up
from roam_core.roto import RotoShape

SIZES = {"480p": (854, 480), "1080p": (1920, 1080), "4K": (3840, 2160)}
PICTURES, FRAMES, MANY = 10, 300, 20_000
READ = 40
"""Frames: of 4K more than the cache holds."""
STILL = 60
"""Pixels across the object that does not grow with the picture."""
SHARE = 0.2
"""Of the picture's height: the radius of the object that does."""
T = TypeVar("T")


@dataclass(frozen=True)
class Opened:
    """The first picture of a plate, in seconds of the clock and the processor, from a process that is there or is
    started for it; pictures a second of the processor from the cache, by proxy; MiB at most, here and there.
    """

    clock: float
    processor: float
    started: float
    from_cache: tuple[float, ...]
    memory: float
    decoding: float


@dataclass(frozen=True)
class Carried:
    """Tracking or filling from files: processor seconds a frame, and MiB at most."""

    seconds: float
    memory: float


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `plates` may be told."""
    parser.add_argument("--frames", type=int, default=12, metavar="N", help="frames that are tracked and timed")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Write the plates, time every case, and report."""
    opening: dict[str, Opened] = {}
    tracking: dict[tuple[str, str], Carried] = {}
    filling: dict[tuple[str, str], Carried] = {}
    with tempfile.TemporaryDirectory() as place:
        for name, size in SIZES.items():
            for kind, radius in (("grows with it", SHARE * size[1]), (f"of {STILL} px", STILL / 2)):
                folder = Path(place) / f"{name} {kind}"
                shape = write_plate(folder, size, radius)
                if kind == "grows with it":
                    opening[name] = alone(first_picture, folder)
                tracking[name, kind] = alone(tracked, folder, shape, given.frames)
                filling[name, kind] = alone(filled, folder, shape, given.frames)
        many = alone(opened_many, Path(place) / "many")
    still = f"of {STILL} px"
    rows = [
        [
            *case,
            f"{1000 * each.seconds:.0f}",
            f"{each.seconds / tracking['1080p', still].seconds:.2f}",
            f"{1000 * filling[case].seconds:.0f}",
            f"{filling[case].seconds / filling['1080p', still].seconds:.2f}",
            f"{each.memory:.0f}",
        ]
        for case, each in tracking.items()
    ]
    first = [
        [
            name,
            f"{1000 * each.clock:.0f}",
            f"{1000 * each.processor:.0f}",
            f"{1000 * each.started:.0f}",
            *(f"{speed:.0f}" for speed in each.from_cache),
            f"{each.memory:.0f}",
            f"{each.decoding:.0f}",
        ]
        for name, each in opening.items()
    ]
    opened_head = [
        "plate", "first picture, ms", "of the processor", "process started too",
        "pictures/s from cache", "proxy 1/2", "1/4", "most MiB", "of what decodes",
    ]  # fmt: skip
    times = f"times 1080p {still}"
    carried_head = ["plate", "object", "tracked, ms a frame", times, "filled, ms", times, "most MiB"]
    text = (
        f"Budget of the cache: {DEFAULT_LIMIT >> 20} MiB. {report.circumstances()}.\n\n"
        f"{report.table(opened_head, first)}\n\n"
        f"A sequence of {MANY:,} frames opens in {1000 * many:.0f} ms of the processor.\n\n"
        f"With `best`, decoding included:\n\n{report.table(carried_head, rows)}"
    )
    result = {
        "opened": {name: vars(each) for name, each in opening.items()},
        "tracked": {" ".join(case): vars(each) for case, each in tracking.items()},
        "filled": {" ".join(case): vars(each) for case, each in filling.items()},
        "many": many,
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
    """The most memory that this process held; what it began as, a copy of another one, does not count."""
    return most_mebibytes("self")


def most_mebibytes(process: int | str) -> float:
    """The most memory that a process held, on Linux."""
    lines = Path(f"/proc/{process}/status").read_text().splitlines()
    return max(int(line.split()[1]) / 1024.0 for line in lines if line.startswith("VmHWM"))


def decoders() -> list[int]:
    """The processes that decode for this one, on Linux."""
    told = (path.read_text() for path in Path("/proc/self/task").glob("*/children"))
    return [int(each) for line in told for each in line.split()]


def processor_seconds() -> float:
    """What this process and those that decode for it have taken of the processor."""
    seconds = time.process_time()
    for process in decoders():
        fields = Path(f"/proc/{process}/stat").read_text().rpartition(")")[2].split()
        seconds += (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")
    return seconds


def decoding_mebibytes() -> float:
    """The most memory that a process which decodes for this one held."""
    return max(map(most_mebibytes, decoders()), default=0.0)


def first_picture(folder: Path) -> Opened:
    """From the path to a picture for the screen; then more than the cache holds, and what it holds again."""
    decoding.isolate()
    decoding.software_of(folder / "none")  # the window has started a process by now
    clock, processor, cache = shown_first(folder)
    source = open_clip(folder)
    for frame in source.frames[:READ]:
        cache.read(frame)
    held = sorted(cache.cached_frames())[-PICTURES:]
    speeds = []
    for step in STEPS:
        began = time.process_time()
        for frame in held:
            reduced(to_display(cache.read(frame), source.colour_space), step)
        speeds.append(len(held) / (time.process_time() - began))
    cache.close()
    memory, others = peak_mebibytes(), decoding_mebibytes()
    decoding.trust()
    decoding.isolate()
    started, _, again = shown_first(folder)
    again.close()
    return Opened(clock, processor, started, tuple(speeds), memory, others)


def shown_first(folder: Path) -> tuple[float, float, FrameCache[Image]]:
    """Seconds of the clock and of the processor until there is a first picture; the cache that holds it."""
    clock, processor = time.perf_counter(), processor_seconds()
    source = open_clip(folder)
    cache = FrameCache(source, DEFAULT_LIMIT)
    to_display(cache.read(source.frames[0]), source.colour_space)
    return time.perf_counter() - clock, processor_seconds() - processor, cache


def tracked(folder: Path, shape: RotoShape, count: int) -> Carried:
    """The command's own way from files to curves, after those frames that are read ahead before anything is known."""
    decoding.isolate()
    warm_up()
    with opened(str(folder)) as plate:
        assert plate.source.colour_space == LINEAR
        first, timed = plate.source.frames[0], AHEAD + 1
        frames = range(first, first + timed + count + AHEAD + 1)  # as many lie ahead at the end as at the beginning
        began = 0.0
        ahead = partial(plate.ahead_of, frames=frames)
        for solved in track(plate.parts_or_bridge, [shape], frames, begun=lambda begun: ahead(begun.frame)):
            ahead(solved.frame)
            if solved.frame == first + timed:
                began = processor_seconds()
            if solved.frame == first + timed + count:
                break
        seconds = (processor_seconds() - began) / count
    return Carried(seconds, peak_mebibytes())


def filled(folder: Path, shape: RotoShape, count: int) -> Carried:
    """Between two keys, from files: all of it, with the frames that are decoded before anything is known."""
    decoding.isolate()
    warm_up()
    with opened(str(folder)) as plate:
        first = plate.source.frames[0]
        last = first + count + 1
        both = edit.set_key(shape, last, shape.at(first).points)
        began = processor_seconds()
        fill_span(plate.parts_or_bridge, [both], first, last)
        seconds = (processor_seconds() - began) / count
    return Carried(seconds, peak_mebibytes())


def opened_many(folder: Path) -> float:
    """Processor seconds to open a sequence of `MANY` frames."""
    decoding.isolate()
    write_half(folder.parent / "one.exr", np.zeros((48, 64, 3), np.float16))
    folder.mkdir()
    for frame in range(MANY):
        os.link(folder.parent / "one.exr", folder / f"plate.{frame:05d}.exr")
    began = processor_seconds()
    open_clip(folder)
    return processor_seconds() - began
