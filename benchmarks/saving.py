"""Saving and opening large projects: seconds, size and memory, beside what plain JSON takes for the same numbers.

Processor time: how busy the machine happened to be shows in it little. Each step runs in a process of its own; memory
is what that process held at most, beyond what it held when the step began. Plain JSON is `json.dumps` of the points as
nested lists, written to a file and read back by `json.loads`, in the same run; for the large project it is taken from a
tenth of its shapes, times ten.
"""

from __future__ import annotations

import argparse
import json
import multiprocessing
import sys
import tempfile
import time
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import numpy as np

from benchmarks import report
from roam_core.roto import Keyframe, Layer, Origin, Project, RotoShape, file

POINTS = 10
"""Points of a shape."""
CASES = {"100 x 500": (100, 500), "1,000 x 500": (1000, 500)}
"""Shapes, and keys of each."""
PEAK = Path("/proc/self/status")
"""Where Linux tells the most memory of a process."""
PLAIN_SHAPES = 100
"""Shapes of which plain JSON is measured."""


@dataclass(frozen=True)
class Step:
    """What one step took: seconds of the processor, and MiB of memory at most."""

    seconds: float
    memory: float


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `saving` may be told."""
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Save and open each project, and report."""
    measured = {name: _case(*case) for name, case in CASES.items()}
    rows = [
        [
            name,
            f"{each['megabytes']:.0f}",
            f"{each['save_seconds']:.2f}",
            f"{each['load_seconds']:.2f}",
            f"{each['save_memory']:.0f}",
            f"{each['load_memory']:.0f}",
            f"{each['plain_megabytes'] / each['megabytes']:.1f}",
            f"{each['plain_save_seconds'] / each['save_seconds']:.1f}",
            f"{each['plain_load_seconds'] / each['load_seconds']:.1f}",
        ]
        for name, each in measured.items()
    ]
    head = ["shapes x keys", "MB", "save, s", "open, s", "save, MiB", "open, MiB"]
    head += ["plain JSON, times larger", "times longer to save", "times longer to open"]
    title = f"Bezier shapes of {POINTS} points, a key on every frame; processor time. {report.circumstances()}."
    report.write("saving", f"{title}\n\n{report.table(head, rows)}", {"projects": measured}, publish=given.publish)


def project_of(shapes: int, keys: int) -> Project:
    """A project of that many tracked Bezier shapes, always the same: numbers with all their digits, as tracks have."""
    rng = np.random.default_rng(0)
    return Project(root=Layer("root", "Root", tuple(_shape(number, keys, rng) for number in range(shapes))))


def _shape(number: int, keys: int, rng: np.random.Generator) -> RotoShape:
    start = rng.uniform(0.0, 2000.0, (1, POINTS, 1, 2)) + rng.uniform(-20.0, 20.0, (1, POINTS, 3, 2))
    moved = np.cumsum(rng.normal(0.0, 1.0, (keys, 1, 1, 2)), axis=0)
    points = start + moved + rng.normal(0.0, 0.1, (keys, POINTS, 3, 2))
    doubts = rng.uniform(0.5, 1.0, (keys, POINTS + 1))
    made = tuple(
        Keyframe(
            1001 + k,
            points[k],
            origin=Origin.ENGINE if k else Origin.ARTIST,
            confidence=float(doubts[k, -1]) if k else None,
            vertex_confidence=doubts[k, :-1] if k else None,
            inputs="forward:best:0123456789abcdef from=1001" if k else "",
        )
        for k in range(keys)
    )
    return RotoShape(f"shape-{number}", f"Shape {number}", made)


def _case(shapes: int, keys: int) -> dict[str, float]:
    with tempfile.TemporaryDirectory() as folder:
        path, plain = Path(folder) / "a.roam", Path(folder) / "plain.json"
        saved, loaded = _alone(_save, (shapes, keys), path), _alone(_load, (shapes, keys), path)
        part = min(shapes, PLAIN_SHAPES)
        plain_saved, plain_loaded = _alone(_plain_save, (part, keys), plain), _alone(_plain_load, (part, keys), plain)
        share = shapes / part
        return {
            "megabytes": path.stat().st_size / 1e6,
            "save_seconds": saved.seconds,
            "load_seconds": loaded.seconds,
            "save_memory": saved.memory,
            "load_memory": loaded.memory,
            "plain_megabytes": share * plain.stat().st_size / 1e6,
            "plain_save_seconds": share * plain_saved.seconds,
            "plain_load_seconds": share * plain_loaded.seconds,
        }


def _alone(step: Callable[[tuple[int, int], Path], Step], case: tuple[int, int], path: Path) -> Step:
    """A step in a process of its own, so that its memory is its own."""
    with multiprocessing.get_context("spawn").Pool(1) as pool:
        return pool.apply(step, (case, path))


def _timed(work: Callable[[], object]) -> Step:
    _forget_peak()
    before, began = _held(), time.process_time()
    result = work()
    step = Step(time.process_time() - began, _held() - before)
    del result
    return step


def _forget_peak() -> None:
    """Count the most memory from now on, where the system can."""
    if PEAK.exists():
        PEAK.with_name("clear_refs").write_text("5")


def _held() -> float:
    """The most memory that the process held, MiB."""
    if PEAK.exists():
        return next(int(line.split()[1]) / 1024.0 for line in PEAK.read_text().splitlines() if "VmHWM" in line)
    import resource  # Windows has no such module, and what counts the benchmarks runs there

    most = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    return most / 1024.0 / (1024.0 if sys.platform == "darwin" else 1.0)


def _save(case: tuple[int, int], path: Path) -> Step:
    project = project_of(*case)
    return _timed(lambda: file.save(project, path))


def _load(case: tuple[int, int], path: Path) -> Step:
    return _timed(lambda: file.load(path))


def _plain_save(case: tuple[int, int], path: Path) -> Step:
    shapes = project_of(*case).shapes
    return _timed(lambda: path.write_text(json.dumps([[key.points.tolist() for key in s.keys] for s in shapes])))


def _plain_load(case: tuple[int, int], path: Path) -> Step:
    return _timed(lambda: [np.array(shape) for shape in json.loads(path.read_text())])
