"""Every check and every test, in parts that keep two processors at work; `make test` runs this.

Ends with what was left out and why, and with a status that is not 0 when anything failed.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path
from threading import Event
from xml.etree import ElementTree

ROOT = Path(__file__).resolve().parent.parent


@dataclass(frozen=True)
class Part:
    """Words for pytest, and what the environment has besides; without words it is that target of `make`.

    One that `stands_back` takes what time the others of its stage leave.
    """

    name: str
    words: tuple[str, ...] = ()
    environment: dict[str, str] = field(default_factory=dict)
    stands_back: bool = False

    def command(self, reports: Path) -> list[str]:
        """What runs it; pytest reports to a file in `reports`."""
        if not self.words:
            return ["make", "--no-print-directory", self.name]
        polite = ["nice", "-n", "15"] if self.stands_back and shutil.which("nice") else []
        return [
            *polite,
            sys.executable,
            "-m",
            "pytest",
            "--quiet",
            f"--junitxml={reports / self.name}.xml",
            *self.words,
        ]


TRACKING = Part("tracking", ("tests/golden",))
"""Whole shots, in one process: it compiles most kernels, once, and the others load what it keeps."""
LINT = Part("lint")
KERNELS = Part("kernels", ("tests/unit/kernels",), {"NUMBA_DISABLE_JIT": "1"})
"""Once more, line by line: what runs here must not hang on what the compiler makes of it (types, bounds)."""
ENGINE = Part(
    "engine", ("--ignore=tests/gui", "--ignore=tests/golden", "-n", "2", "--dist", "loadfile"), stands_back=True
)
"""In two processes: each loads for itself, so more of them would gain less and less. The window is not kept waiting."""
WINDOW = Part("window", ("tests/gui", "-m", "not xvfb"))
"""In one process, without a screen."""
SCREEN = Part("screen", ("tests/gui", "-m", "xvfb"))
"""The program itself in a real window, under a virtual X server where there is one (else skipped, saying so)."""

STAGES = (((TRACKING,), (LINT, KERNELS)), ((ENGINE,), (WINDOW, SCREEN)))
"""One after another. The lanes of a stage run at the same time, the parts of a lane do not. Window and screen wait, for
timers and for programs that they start: the engine computes meanwhile."""


def main() -> int:
    """Run all stages; the status for the shell."""
    with tempfile.TemporaryDirectory() as folder:
        failed = [name for lanes in STAGES for name in run_stage(lanes, Path(folder))]
        print("\n".join(left_out(Path(folder))))
    print(f"== failed: {' '.join(failed)}" if failed else "== all passed")
    return int(bool(failed))


def run_stage(lanes: tuple[tuple[Part, ...], ...], reports: Path) -> list[str]:
    """Run lanes side by side; the names of the parts that failed."""
    stopped = Event()
    with ThreadPoolExecutor(len(lanes)) as pool:
        running = [pool.submit(run_lane, lane, reports, stopped, is_live=lane is lanes[0]) for lane in lanes]
        try:
            return [name for lane in running for name in lane.result()]
        except KeyboardInterrupt:
            stopped.set()  # the shell has told the programs that run
            raise


def run_lane(lane: tuple[Part, ...], reports: Path, stopped: Event, is_live: bool) -> list[str]:
    """Run parts one after another; the names of those that failed. What a lane says is printed live or at its end."""
    failed = []
    for part in lane:
        if stopped.is_set():
            break
        title = f"== {' '.join((part.name, *part.words))}"
        print(title if is_live else f"{title} (beside the others)", flush=True)
        status, said = run(part, reports, is_live)
        if not is_live:
            print(f"\n{title}\n{said}", flush=True)
        if status:
            failed.append(part.name)
    return failed


def run(part: Part, reports: Path, is_live: bool) -> tuple[int, str]:
    """A part's status, and what it said where that is not live."""
    environment = os.environ | {"QT_QPA_PLATFORM": "offscreen"} | part.environment
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # every program that a test starts would compile all modules
    out, err = (None, None) if is_live else (subprocess.PIPE, subprocess.STDOUT)
    done = subprocess.run(part.command(reports), cwd=ROOT, env=environment, check=False, stdout=out, stderr=err)
    return done.returncode, (done.stdout or b"").decode(errors="replace")


def left_out(reports: Path) -> Iterator[str]:
    """How many tests there were, and each that was skipped with its reason."""
    cases = [case for report in sorted(reports.glob("*.xml")) for case in ElementTree.parse(report).iter("testcase")]
    skipped = [(case, skip) for case in cases if (skip := case.find("skipped")) is not None]
    yield f"== {len(cases)} tests, {len(skipped)} of them skipped"
    for case, skip in skipped:
        yield f"   skipped {case.get('classname')}.{case.get('name')}: {skip.get('message')}"


if __name__ == "__main__":
    sys.exit(main())
