"""A batch on this machine's cores beside the same steps one after another on one core; what tiny jobs cost.

Seconds by the clock mean something on a machine that does nothing else (the load is told); those of the processors say
what a batch costs on any. Each single run is a process of its own, as `roam track` and `roam render` are. With `--kill`
a worker is killed halfway, and the batch is given again afterwards: what was done is kept. The results of both ways are
compared byte by byte.

    python -m benchmarks batch --frames 8 --kill --tiny 0     # the shared shots, less than ten minutes
    python -m benchmarks batch --shots none                   # 1,000 tiny jobs
"""

from __future__ import annotations

import argparse
import json
import os
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import psutil

from benchmarks import processes, report, shots
from roam_core import Clip, Keyframe, Project, RotoShape, edit, open_clip, save_project
from roam_core.cli.performing import perform
from roam_core.geometry.primitives import ellipse
from roam_core.params import DEFAULT_CONFIG, params_for
from roam_core.studio.jobs import read_jobs
from roam_core.studio.tasks import tasks_of

TINY = (64, 48)
"""Width and height of the pictures of tiny jobs."""
ALONE = 100
"""Tiny jobs that are carried out without a batch, to know what a step itself takes."""
AIMS = {"ratio": 0.6, "overhead": 50, "memory": 500}
ROAM = [sys.executable, "-m", "roam_core"]


@dataclass(frozen=True)
class Batch:
    """A batch that was carried out: seconds by the clock and of processors, MiB of its process at most, its lines."""

    seconds: float
    spent: float
    memory: float
    lines: list[dict[str, Any]]


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `batch` may be told."""
    parser.add_argument("--shots", metavar="A,B", help="only these shots (default: all; none: only tiny jobs)")
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help="default: %(default)s")
    parser.add_argument("--frames", type=int, metavar="N", help="frames of each shot (default: all)")
    parser.add_argument("--tiny", type=int, metavar="N", default=1000, help="tiny jobs (%(default)s; 0: none)")
    parser.add_argument("--kill", action="store_true", help="kill a worker halfway, and give the batch again")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Carry out both ways, compare, and report."""
    params_for(given.config)
    processes.adopt()
    names = [] if given.shots == "none" else shots.names(given.shots)
    rows: list[list[str]] = []
    result: dict[str, Any] = {}
    with tempfile.TemporaryDirectory() as place:
        folder = Path(place)
        if names:
            result["shots"] = _shots(folder, names, given.config, given.frames, given.kill, rows)
        if given.tiny:
            result["tiny"] = _tiny(folder, given.tiny, rows)
    text = f"{report.circumstances()}.\n\n{report.table(['what', 'measured', 'aim'], rows)}"
    report.write("batch", text, result, publish=given.publish)


def _shots(
    folder: Path, names: Sequence[str], config: str, frames: int | None, kill: bool, rows: list[list[str]]
) -> dict[str, Any]:
    """Every shot tracked from its first true mask and rendered, by single runs and as a batch."""
    alone, jobs = folder / "alone", []
    alone.mkdir()
    began, spent = time.perf_counter(), processes.spent()
    for name in names:
        plate = shots.FOLDER / "JPEGImages" / name
        source = open_clip(plate)
        init = shots.FOLDER / "Annotations" / name / f"{source.frame_name(source.frames[0])}.png"
        last = source.frames[-1] if frames is None else min(source.frames[0] + frames - 1, source.frames[-1])
        (alone / name).mkdir()
        project = alone / name / f"{name}.roam"
        _single("track", plate, "--init", init, "--config", config, "--end", last, "--save", project)
        _single("render", project, "--out", alone / name / "mattes", "--end", last)
        steps = [{"track": {"config": config, "end": last}}, {"render": {"end": last}}]
        jobs.append({"name": name, "clip": str(plate), "init": str(init), "steps": steps})
    sequential, spent = time.perf_counter() - began, processes.spent() - spent
    batch = _batch(folder, "shots", jobs, kill_at=len(names) // 2 if kill else None)
    differing = [
        str(path.relative_to(alone))
        for path in sorted(alone.rglob("*"))
        if path.is_file() and not _is_same(path, folder / "shots" / path.relative_to(alone))
    ]
    again = _batch(folder, "shots", jobs)
    killed = sum(line["attempts"] > 1 for line in batch.lines)
    ratio, aim = batch.seconds / sequential, str(AIMS["ratio"])
    rows += [
        [f"{len(names)} shots one after another, one core, s", f"{sequential:.1f}", "-"],
        ["of processors, s", f"{spent:.1f}", "-"],
        [f"as a batch on {os.cpu_count()} cores, s", f"{batch.seconds:.1f}", "-"],
        ["of processors, s", f"{batch.spent:.1f}", "-"],
        ["batch by sequence", f"{ratio:.2f}", aim],
        ["of processors, batch by sequence", f"{batch.spent / spent:.2f}", "-"],
        ["files that differ", f"{len(differing)}", "0"],
        ["steps done twice" + (" (a worker was killed)" if kill else ""), f"{killed}", "-"],
        ["the batch given again, s", f"{again.seconds:.1f}", "-"],
        ["steps kept then", f"{sum(line['status'] == 'kept' for line in again.lines)} of {len(again.lines)}", "all"],
    ]
    return {
        "sequential": [sequential, spent],
        "batch": [batch.seconds, batch.spent],
        "again": again.seconds,
        "differing": differing,
    }


def _tiny(folder: Path, count: int, rows: list[list[str]]) -> dict[str, Any]:
    """Jobs of one small matte each: what the batch takes beyond the step itself."""
    import cv2
    import numpy as np

    plate = folder / "tiny-plate"
    plate.mkdir()
    cv2.imwrite(str(plate / "p.0001.png"), np.full((TINY[1], TINY[0], 3), 90, dtype=np.uint8))
    shape = RotoShape("a", "A", (Keyframe(1, ellipse((12.0, 9.0), (52.0, 39.0))),))
    save_project(edit.add_shape(Project(Clip.of(open_clip(plate))), shape), folder / "tiny.roam")
    jobs = [{"name": f"t{k}", "init": str(folder / "tiny.roam"), "steps": ["render"]} for k in range(count)]
    few = _batch(folder, "few", jobs[:1])
    batch = _batch(folder, "tiny", jobs)
    inside = sum(line["seconds"] for line in batch.lines)
    workers, more = os.cpu_count() or 1, count - 1
    overhead = max(0.0, (batch.seconds - few.seconds) * workers - inside) / more
    alone = _alone(folder, jobs[:ALONE])
    spent = (batch.spent - few.spent) / more - alone
    rows += [
        [f"{count} tiny jobs, s", f"{batch.seconds:.1f}", "-"],
        ["of that starting and ending, s", f"{few.seconds:.1f}", "-"],
        ["a step itself, ms", f"{1000 * inside / count:.1f}", "-"],
        ["overhead a job, ms of a worker", f"{1000 * overhead:.1f}", str(AIMS["overhead"])],
        ["a step itself, ms of a processor", f"{1000 * alone:.1f}", "-"],
        ["overhead a job, ms of a processor", f"{1000 * spent:.1f}", "-"],
        ["scheduler and client at most, MiB", f"{batch.memory:.0f}", str(AIMS["memory"])],
    ]
    done = sum(line["status"] == "done" for line in batch.lines)
    return {
        "seconds": batch.seconds,
        "start": few.seconds,
        "overhead": [overhead, spent],
        "memory": batch.memory,
        "done": done,
    }


def _alone(folder: Path, jobs: Sequence[dict[str, Any]]) -> float:
    """Processor seconds of a step when it is carried out in this process, without a batch."""
    path = folder / "alone.json"
    path.write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": jobs}))
    tasks = [task.plain() for (task,) in tasks_of(read_jobs(path))]
    perform("alone", tasks[0])  # what is loaded and made once
    began = time.process_time()
    for task in tasks[1:]:
        perform("alone", task)
    return (time.process_time() - began) / max(1, len(tasks) - 1)


def _is_same(one: Path, other: Path) -> bool:
    return other.is_file() and one.read_bytes() == other.read_bytes()


def _single(*words: object) -> None:
    environment = os.environ | {"ROAM_THREADS": "1"}
    command = [*ROAM, *(str(word) for word in words)]
    subprocess.run(command, env=environment, cwd=report.ROOT, check=True, capture_output=True)


def _batch(folder: Path, name: str, jobs: Sequence[dict[str, Any]], kill_at: int | None = None) -> Batch:
    """`roam batch` on these jobs; when so many steps have ended one of its workers at work is killed."""
    path = folder / f"{name}.json"
    path.write_text(json.dumps({"type": "roam.Jobs", "version": 1, "jobs": jobs}))
    began, spent = time.perf_counter(), processes.spent()
    with (folder / f"{name}.lines").open("w+b") as lines:
        command = [*ROAM, "batch", str(path), "--json", "--no-dashboard"]
        running = subprocess.Popen(command, cwd=report.ROOT, stdout=lines, stderr=subprocess.DEVNULL)
        if kill_at is not None:
            while _runs(running.pid) and (folder / f"{name}.lines").read_bytes().count(b"\n") < kill_at:
                time.sleep(0.05)
            _kill_a_worker(running.pid)
        _, status, usage = os.wait4(running.pid, 0)
        running.returncode = os.waitstatus_to_exitcode(status)
        seconds = time.perf_counter() - began
        lines.seek(0)
        told = [json.loads(line) for line in lines]
    return Batch(seconds, processes.spent() - spent, usage.ru_maxrss / 1024, told)


def _runs(process: int) -> bool:
    """Whether a child of ours has not ended; it is waited for elsewhere."""
    return os.waitid(os.P_PID, process, os.WEXITED | os.WNOHANG | os.WNOWAIT) is None


def _kill_a_worker(process: int) -> None:
    """End the busiest of the processes that a batch started."""
    workers = psutil.Process(process).children(recursive=True)
    for worker in workers:
        worker.cpu_percent()
    time.sleep(0.5)
    busiest = max(workers, key=lambda worker: worker.cpu_percent(), default=None)
    if busiest is not None:
        os.kill(busiest.pid, signal.SIGKILL)
