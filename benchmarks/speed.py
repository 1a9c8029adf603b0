"""What an artist waits for: milliseconds a frame by the clock on two threads, and the first frame after a key press.

Each frame is timed from asking for it to having its keys, all shapes of the shot, without decoding and without the
matte. The yardstick, OpenCV's fastest DIS flow over the whole picture, runs on the same frames in the same minute with
as many threads.
"""

from __future__ import annotations

import argparse
import time
from dataclasses import dataclass
from typing import Any

import cv2
import numpy as np

from benchmarks import demo_shot, report, shots
from benchmarks.shots import Shot, first_shapes
from benchmarks.yardstick import flow_seconds
from roam_core import track
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.propagate import warm_up
from roam_core.roto import RotoShape

THREADS = 2
AIMS = {"ms a frame at 480p": "42 (under 70)", "1080p against 480p": "2.5", "first frame, s": "0.3"}
"""What was asked for."""


@dataclass(frozen=True)
class Timed:
    """One shot: milliseconds of every frame by the clock, the processor's and the yardstick's; the first in seconds."""

    clock: tuple[float, ...]
    processor: tuple[float, ...]
    flow: tuple[float, ...]
    first: float

    @property
    def ratio(self) -> float:
        """The median frame in medians of the yardstick."""
        return float(np.median(self.clock) / np.median(self.flow))


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `speed` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument("--shots", metavar="A,B", help="only these shots")
    parser.add_argument("--frames", type=int, default=1000, metavar="N", help="at most so many of each shot")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Time every shot and the demo at two sizes, one after the other, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    threads = cv2.getNumThreads()
    cv2.setNumThreads(THREADS)
    try:
        warm_up(given.config)
        measured = {name: _of_shot(shots.load(name), given) for name in chosen}
        for name, size in demo_shot.SIZES.items():
            shot = demo_shot.load(size, min(given.frames + 1, demo_shot.LONGEST))
            measured[f"demo {name}"] = timed(shot, [demo_shot.true_shape(shot.first, size)], given.config)
    finally:
        cv2.setNumThreads(threads)
    name = f"speed {given.config}" if given.shots is None else f"speed {given.config} some"
    result = {shot: each.__dict__ for shot, each in measured.items()}
    text = _table(measured, chosen, given.config)
    report.write(name, text, {"shots": result}, publish=given.publish and given.shots is None)


def timed(shot: Shot, shapes: list[RotoShape], config: str) -> Timed:
    """Track a shot that lies in memory, with a stopwatch."""
    clock, processor = [], []
    asked, spent = time.perf_counter(), time.process_time()
    for _ in track(shot.read, shapes, shot.frames, config):
        clock.append(1000.0 * (time.perf_counter() - asked))
        processor.append(1000.0 * (time.process_time() - spent))
        asked, spent = time.perf_counter(), time.process_time()
    # The first frame holds the learning from the key, too: it is told apart.
    flow = [1000.0 * seconds for seconds in flow_seconds(shot.pictures, time.perf_counter)]
    return Timed(tuple(clock[1:]), tuple(processor[1:]), tuple(flow), clock[0] / 1000.0)


def _of_shot(shot: Shot, given: argparse.Namespace) -> Timed:
    count = min(given.frames + 1, len(shot.frames))
    part = Shot(shot.name, shot.first, shot.pictures[:count], shot.masks[:count])
    return timed(part, first_shapes(part), given.config)


def _table(measured: dict[str, Timed], chosen: list[str], config: str) -> str:
    rows: list[list[str]] = [_row(name, each) for name, each in measured.items()]
    every = [measured[name] for name in chosen]
    whole = Timed(
        tuple(ms for each in every for ms in each.clock),
        tuple(ms for each in every for ms in each.processor),
        tuple(ms for each in every for ms in each.flow),
        float(np.median([each.first for each in every])),
    )
    small, large = (measured[f"demo {name}"] for name in demo_shot.SIZES)
    growth = float(np.median(large.clock) / np.median(small.clock))
    rows.append([f"**all frames of {len(chosen)} shots**", *(f"**{cell}**" for cell in _row("", whole)[1:])])
    head = ["shot", "frames", "median, ms", "90 %, ms", "processor, ms", "DIS, ms", "times DIS", "first frame, s"]
    aims = "; ".join(f"{what} {aim}" for what, aim in AIMS.items())
    title = f"Configuration `{config}`, {THREADS} threads, without decoding. {report.circumstances()}."
    summary = f"The demo at 1080p takes {growth:.2f} times as long as at 480p. Aims: {aims}."
    return f"{title}\n\n{report.table(head, rows)}\n\n{summary}"


def _row(name: str, each: Timed) -> list[str]:
    numbers: list[Any] = [np.median(each.clock), np.percentile(each.clock, 90), np.median(each.processor)]
    cells = [f"{value:.1f}" for value in (*numbers, np.median(each.flow))]
    return [name, str(len(each.clock)), *cells, f"{each.ratio:.2f}", f"{each.first:.3f}"]
