"""The first `make run` after the install: until the window is there, and until the demo is rendered behind it.

The checkout's last commit is copied to a folder of its own, without compiled modules and kernels, and started with an
empty home by the libraries that are installed; so its modules are compiled, its kernels too, and the demo is rendered,
as on a machine on which the install has just ended. A second start follows. Needs Xvfb and xdotool.
"""

from __future__ import annotations

import argparse
import io
import os
import subprocess
import sys
import tarfile
import tempfile
from collections.abc import Mapping, Sequence
from pathlib import Path

from benchmarks import report
from resources import demo
from roam_core.errors import RoamError
from scripts.watched_window import NotShown, watched_window

AIM_SECONDS = 15
START = "import sys; from roam_core.cli.program import main; sys.exit(main(['demo']))"


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `first_start` may be told."""
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Measure two starts, and report."""
    with tempfile.TemporaryDirectory() as folder:
        tree, home = Path(folder) / "tree", Path(folder) / "home"
        home.mkdir()
        packed = subprocess.run(["git", "archive", "HEAD"], cwd=report.ROOT, capture_output=True, check=True).stdout
        with tarfile.open(fileobj=io.BytesIO(packed)) as archive:
            archive.extractall(tree, filter="data")
        try:
            starts = [_measured(tree, home) for _ in range(2)]
        except NotShown as error:
            raise RoamError(str(error)) from None
    rows = [
        [f"{which} start: {what}", f"{start[key]:.1f}", str(aim)]
        for which, start in zip(("first", "second"), starts, strict=True)
        for what, key, aim in (
            ("window, s", "shown", AIM_SECONDS),
            ("window, s of processors", "spent", "-"),
            ("the demo is rendered, s", "rendered", "-"),
            ("the demo is rendered, s of processors", "spent_then", "-"),
        )
    ]
    text = f"{report.circumstances()}.\n\n{report.table(['the first start', 'measured', 'aim'], rows)}"
    report.write("first start", text, {"starts": starts}, publish=given.publish)


def _measured(tree: Path, home: Path) -> dict[str, float]:
    def command(display: str) -> tuple[Sequence[str], Mapping[str, str]]:
        environment = {name: value for name, value in os.environ.items() if not name.startswith("XDG_")}
        environment |= {"HOME": str(home), "PYTHONPATH": str(tree), "DISPLAY": display}
        return [sys.executable, "-c", START], environment

    with watched_window(command, tree) as (window, _):
        shown, spent = window.shown(), window.processor_seconds()
        window.until(lambda: len(list(home.glob(".cache/roam/demo-*/*.png"))) > demo.LAST - demo.FIRST)
        rendered, spent_then = window.seconds(), window.processor_seconds()
    return {"shown": shown, "spent": spent, "rendered": rendered, "spent_then": spent_then}
