"""Mutation testing: random mutants of a room of the engine, and the tests that notice them.

A mutant changes one comparison, operator, number, condition, call, return or statement. Killed are those that a test
notices; those that survive are equivalent, or say what no test holds. Kernels run line by line. What became of each
mutant is written into the report as a line of JSON. A run that is started again goes on after the last one, with the
map from lines to tests that lies beside the report. Needs `coverage`, which the other tests do without.
"""

from __future__ import annotations

import argparse
import json
import random
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, replace
from pathlib import Path
from typing import Any

from tests.mutation import runner
from tests.mutation.coverage_map import CoverageMap, measured
from tests.mutation.operators import Mutant, sites

Key = tuple[str, int, int, str]

ROOT = Path(__file__).resolve().parents[2]
ROOMS = {
    "kernels": (
        "tests/unit/kernels", "tests/unit/appearance/test_gmm.py", "tests/unit/energy/test_curve.py",
        "tests/unit/geometry/test_skinning.py", "tests/property/test_bezier.py", "tests/property/test_curve_energy.py",
        "tests/property/test_cyclic_viterbi.py", "tests/property/test_region_sums.py",
    ),
    "energy": ("tests/unit/energy", "tests/unit/inference", "tests/property/test_curve_energy.py"),
    "roto": ("tests/unit/roto", "tests/property"),
    "interchange": (
        "tests/unit/interchange", "tests/property/test_interchange.py", "tests/property/test_import.py",
        "tests/property/test_labels.py", "tests/property/test_nuke_in_time.py", "tests/property/test_open_formats.py",
    ),
}  # fmt: skip
"""The rooms, each with the tests that are asked."""
COMPILED = ("interchange",)
"""Rooms that hold no kernels, and whose tests call those of others: they run compiled."""


def main() -> int:
    parser = argparse.ArgumentParser(prog="python -m tests.mutation", description=__doc__)
    parser.add_argument("--room", choices=sorted(ROOMS), required=True)
    parser.add_argument("--mutants", type=int, default=300, help="how many are drawn (300)")
    parser.add_argument("--seed", type=int, default=1, help="which are drawn (1)")
    parser.add_argument("--report", type=Path, required=True, help="the file of results; what stands in it is not run")
    parser.add_argument("--tests", nargs="+", help="the tests that are asked, instead of those of the room")
    parser.add_argument("--again", type=Path, help="a report of the same draw: only what survived there is run")
    given = parser.parse_args()
    given.report = given.report.resolve()
    runner.preload(compiled=given.room in COMPILED)
    drawn = draw(given.room, given.mutants, given.seed)
    with tempfile.TemporaryDirectory(prefix="roam-mutation-") as folder:
        (Path(folder) / "tree").mkdir()
        tree = runner.copy_tree(ROOT, Path(folder) / "tree")
        covering = covered(tree, given.room, given.tests or ROOMS[given.room], given.report.with_suffix(".map"))
        print(
            f"{len(covering.seconds)} tests, {len(covering.left_out)} left out: they fail or take too long",
            flush=True,
        )
        run(tree, drawn, covering, given.report, survivors(given.again) if given.again else None)
    print(summary(given.report))
    return 0


def draw(room: str, count: int, seed: int) -> list[Mutant]:
    """So many mutants of a room: places without order and without repetition, one change at each.

    Those of a smaller draw are the first ones of a larger.
    """
    paths = sorted((ROOT / "roam_core" / room).rglob("*.py"))
    places = [place for path in paths for place in sites(path.relative_to(ROOT).as_posix(), path.read_bytes())]
    generator = random.Random(f"{room} {seed}")
    generator.shuffle(places)
    return [generator.choice(place) for place in places[:count]]


def covered(tree: Path, room: str, tests: Sequence[str], kept: Path) -> CoverageMap:
    """The map of the tests, made in a process of its own and kept beside the report."""

    def measure() -> int:
        kept.write_text(measured(tree, room, tests).to_json(), encoding="utf-8")
        return 0

    if not kept.exists() and runner.forked(tree, measure, 3600.0) != 0:
        raise RuntimeError(f"the tests could not be measured: {runner.said(tree)}")
    return CoverageMap.from_json(kept.read_text(encoding="utf-8"))


def run(tree: Path, drawn: list[Mutant], covering: CoverageMap, report: Path, only: set[Key] | None) -> None:
    """Add the verdict on each mutant to the report."""
    known = {key_of(line) for line in results(report)} if report.exists() else set()
    check(tree, drawn, covering)
    for number, mutant in enumerate(drawn, 1):
        key = key_of(asdict(mutant))
        if key in known or (only is not None and key not in only):
            continue
        ended = runner.verdict(tree, mutant, covering)
        with report.open("a", encoding="utf-8") as file:
            file.write(json.dumps({"verdict": ended} | asdict(mutant)) + "\n")
        print(f"{time.strftime('%H:%M:%S')} {number:4} {ended:9} {mutant.operator:10} {mutant}", flush=True)


def check(tree: Path, drawn: list[Mutant], covering: CoverageMap) -> None:
    """Raise a RuntimeError unless the tests pass here on the tree as it is, by the example of a few mutants."""
    for mutant in drawn[:4]:
        if runner.verdict(tree, replace(mutant, after=mutant.before), covering) not in (
            runner.SURVIVED,
            runner.UNCOVERED,
        ):
            raise RuntimeError(
                f"the tests of {mutant.path}:{mutant.line} fail on the tree as it is: {runner.said(tree)}"
            )


def results(report: Path) -> list[dict[str, Any]]:
    """The lines of a report."""
    return [json.loads(line) for line in report.read_text(encoding="utf-8").splitlines()]


def key_of(line: dict[str, Any]) -> Key:
    """What tells a mutant from all others."""
    return line["path"], line["start"], line["end"], line["after"]


def survivors(report: Path) -> set[Key]:
    """The mutants of a report that no test noticed."""
    return {key_of(line) for line in results(report) if line["verdict"] in (runner.SURVIVED, runner.UNCOVERED)}


def summary(report: Path) -> str:
    """How many ended how."""
    counts = Counter(line["verdict"] for line in results(report))
    noticed = counts[runner.KILLED] + counts[runner.TIMED_OUT]
    return f"{noticed} of {counts.total()} noticed: " + ", ".join(f"{n} {name}" for name, n in counts.most_common())


if __name__ == "__main__":
    sys.exit(main())
