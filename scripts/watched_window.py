"""A program that opens ROAM's window on a virtual display, watched from outside: when it is there, and what it took.

Needs Xvfb and xdotool.
"""

from __future__ import annotations

import subprocess
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from time import monotonic, sleep

import psutil

from scripts.virtual_display import virtual_display

SIZE = (1500, 940)
PATIENCE = 180.0
"""Seconds after which nothing comes any more."""
PAUSE = 0.05


class NotShown(Exception):
    """The window, or what was waited for, did not come."""


class WatchedWindow:
    """A program that was started on a display; seconds count from its start."""

    def __init__(self, display: str, running: subprocess.Popen[bytes]) -> None:
        self._display, self._running, self._began = display, running, monotonic()
        self._window = ""

    def seconds(self) -> float:
        """Seconds by the clock since the start."""
        return monotonic() - self._began

    def processor_seconds(self) -> float:
        """Seconds of processors that the program and what it started have taken so far; ended processes left out."""
        here = psutil.Process(self._running.pid)
        times = [each.cpu_times() for each in (here, *here.children(recursive=True))]
        return float(sum(each.user + each.system for each in times))

    def shown(self) -> float:
        """Wait for the window; the seconds until it was there. Raises `NotShown`."""
        self.until(self._found)
        return self.seconds()

    def press(self, key: str) -> None:
        """Press a key in the window, by its X name."""
        self._tool("windowfocus", self._window)
        self._tool("key", key)

    def until(self, what: Callable[[], bool]) -> None:
        """Wait until it is so. Raises `NotShown` when the program ended, or nothing comes any more."""
        began = monotonic()
        while not what():
            if self._running.poll() is not None or monotonic() - began > PATIENCE:
                raise NotShown("What was waited for did not come: the program ended, or is at a loss.")
            sleep(PAUSE)

    def _found(self) -> bool:
        lines = self._tool("search", "--onlyvisible", "--name", "ROAM").splitlines()
        self._window = lines[-1] if lines else ""
        return bool(self._window)

    def _tool(self, *words: str) -> str:
        environment = {"DISPLAY": self._display, "PATH": "/usr/bin:/bin"}
        return subprocess.run(["xdotool", *words], env=environment, capture_output=True, text=True, check=False).stdout


@contextmanager
def watched_window(
    command: Callable[[str], tuple[Sequence[str], Mapping[str, str]]], folder: Path
) -> Iterator[tuple[WatchedWindow, str]]:
    """Start a program in a folder, on a display of its own, for the length of a `with` block; also gives the display.

    `command` is given the display, and gives the command and its environment.
    """
    with virtual_display(*SIZE) as display:
        words, environment = command(display)
        running = subprocess.Popen(list(words), cwd=folder, env=dict(environment), stderr=subprocess.DEVNULL)
        try:
            yield WatchedWindow(display, running), display
        finally:
            running.terminate()
            running.wait(60)
