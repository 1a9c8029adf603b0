"""The compiled kernels, each on a case of the size that a 480-line picture gives it, timed by pytest-benchmark."""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

from benchmarks import report
from roam_core.errors import RoamError

CASES = Path(__file__).with_name("kernel_cases.py")


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `kernels` may be told."""
    parser.add_argument("--only", metavar="WORD", default="", help="kernels whose name holds the word")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Time the kernels in a process of their own, with one thread, and report."""
    timed = _timed(given.only)
    rows = [
        [name, *(f"{1e6 * stats[what]:.1f}" for what in ("min", "median", "stddev")), str(stats["rounds"])]
        for name, stats in sorted(timed.items())
    ]
    head = ["kernel", "least, us", "median, us", "spread, us", "rounds"]
    text = f"Compiled kernels, one thread. {report.circumstances()}.\n\n{report.table(head, rows)}"
    report.write("kernels", text, {"seconds": timed}, publish=given.publish and not given.only)


def _timed(word: str) -> dict[str, dict[str, Any]]:
    """What pytest-benchmark says of every kernel, by name."""
    with tempfile.TemporaryDirectory() as folder:
        result = Path(folder) / "kernels.json"
        # -p no:xdist: pytest-benchmark measures nothing in several processes. -c: the settings of the tests are not
        # wanted, a benchmark is no test.
        words = ["-q", "-p", "no:xdist", "-p", "no:cacheprovider", "-c", os.devnull, f"--rootdir={report.ROOT}"]
        words += [f"--benchmark-json={result}", "--benchmark-max-time=0.5", "-k", word or "kernel", str(CASES)]
        command = [sys.executable, "-m", "pytest", *words]
        threads = {"OMP_NUM_THREADS": "1", "NUMBA_NUM_THREADS": "1"}
        ran = subprocess.run(
            command, cwd=report.ROOT, env=os.environ | threads, capture_output=True, text=True, check=False
        )
        if not result.exists() or not (found := json.loads(result.read_text(encoding="utf-8") or "{}")):
            raise RoamError(f"The kernels could not be timed: {(ran.stdout + ran.stderr).strip()[-600:]}")
    if ran.returncode != 0:
        raise RoamError(f"Not every kernel could be timed: {ran.stdout.strip()[-600:]}")
    return {each["params"]["name"]: _in_short(each["stats"]) for each in found["benchmarks"]}


def _in_short(stats: dict[str, Any]) -> dict[str, Any]:
    return {what: stats[what] for what in ("min", "median", "mean", "stddev", "rounds")}
