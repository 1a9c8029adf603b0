"""A real window under a virtual X server, driven by keys and mouse: for gestures that no synthetic event proves.

A file of such tests has `pytestmark = NEEDS_SCREEN` and imports the fixture `screen`; without the tools it is skipped.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager, suppress
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import psutil
import pytest

from scripts.virtual_display import virtual_display

NEEDED = ("Xvfb", "xdotool")
MISSING = [tool for tool in NEEDED if shutil.which(tool) is None]
WINDOW = (1200, 760)
"""The size that `settled` gives a window, at the screen's corner."""
PATIENCE = 120.0
"""Seconds after which the program is thought to be stuck; the first track may compile kernels."""

NEEDS_SCREEN = [
    pytest.mark.xvfb,
    pytest.mark.skipif(bool(MISSING), reason=f"needs {' and '.join(MISSING)} to drive a real window"),
]


@dataclass
class Screen:
    """A virtual screen and the hands before it."""

    environment: dict[str, str]

    def do(self, *arguments: object) -> str:
        """Run xdotool; gives what it prints."""
        command = ["xdotool", *map(str, arguments)]
        result = subprocess.run(
            command, env=self.environment, capture_output=True, text=True, timeout=PATIENCE, check=False
        )
        return result.stdout.strip()

    def windows(self, name: str) -> list[str]:
        """The visible windows whose title holds `name`."""
        return self.do("search", "--onlyvisible", "--name", name).split()

    def click(self, x: float, y: float) -> None:
        self.do("mousemove", round(x), round(y), "click", 1)
        time.sleep(0.05)

    def drag(self, *spots: np.ndarray | tuple[float, float]) -> None:
        """The left button held down through all places."""
        for index, (x, y) in enumerate(spots):
            self.do("mousemove", round(x), round(y), *(("mousedown", 1) if index == 0 else ()))
            rest()  # of several moves that wait, Qt hands on the last
        self.do("mouseup", 1)

    def key(self, *keys: str) -> None:
        self.do("key", "--delay", 60, *keys)


def rest() -> None:
    """Wait until all that was started here, server and program, has done what came so far: no thread works any more."""
    deadline, calm = time.monotonic() + PATIENCE, 0
    while calm < 5 and time.monotonic() < deadline:
        calm = 0 if _is_any_at_work() else calm + 1
        time.sleep(0.01)


def _is_any_at_work() -> bool:
    for each in psutil.Process().children(recursive=True):
        for stat in Path(f"/proc/{each.pid}/task").glob("*/stat"):
            with suppress(OSError):
                if stat.read_text().rpartition(")")[2].split()[0] in "RD":
                    return True
    return False


def until(condition: Callable[[], bool], what: str, program: subprocess.Popen[bytes]) -> None:
    """Wait for a condition; fail when the program ended or took too long."""
    deadline = time.monotonic() + PATIENCE
    while not condition():
        assert program.poll() is None, f"the program ended while waiting for {what}"
        assert time.monotonic() < deadline, f"waited in vain for {what}"
        time.sleep(0.1)


@pytest.fixture
def screen(tmp_path: Path) -> Iterator[Screen]:
    """An X server on a display number of its own choosing."""
    with virtual_display(1280, 800) as display:
        environment = {name: value for name, value in os.environ.items() if name != "QT_QPA_PLATFORM"}
        folders = {f"XDG_{kind}_HOME": str(tmp_path / kind.lower()) for kind in ("STATE", "CACHE", "CONFIG")}
        yield Screen(environment | folders | {"DISPLAY": display, "QT_QPA_PLATFORM": "xcb"})


@contextmanager
def program_on(screen: Screen, project: Path) -> Iterator[subprocess.Popen[bytes]]:
    """The program with a project open, its window settled; killed at the end if it still runs."""
    program = subprocess.Popen([sys.executable, "-m", "app", str(project)], env=screen.environment)
    try:
        until(lambda: bool(screen.windows(project.name)), "the window", program)
        settled(screen, screen.windows(project.name)[-1])
        yield program
    finally:
        program.kill()
        program.wait(PATIENCE)


def settled(screen: Screen, window: str) -> None:
    """Put a window of the program at the screen's corner, in the size `WINDOW`, and give it the keyboard."""
    screen.do("windowmove", "--sync", window, 0, 0, "windowsize", "--sync", window, *WINDOW, "windowfocus", window)
