"""Measures a bundle from the double click on a project to a tracked frame, in a window on a virtual display.

    python -m bundle.first_track dist/roam-VERSION-linux-MACHINE.tar.gz [PICTURE.png]

The bundle is unpacked, its home is empty but for a project on the demo's frames with a shape on the first, and no file
of it was read before by this run alone: the second number is that of a second start. Needs Xvfb and xdotool.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from collections.abc import Callable
from pathlib import Path
from time import monotonic, sleep

from bundle import check
from scripts.virtual_display import virtual_display

PATIENCE = 180.0
"""Seconds after which nothing comes any more."""
ONE_FRAME, ALL_FRAMES = "shift+bracketright", "bracketright"


def measured(made: Path, home: Path, picture: Path | None) -> tuple[float, float]:
    """Seconds from the start to the window, and to the first tracked frames in the journal of edits."""
    before = {path: path.stat().st_size for path in _journals(home)}
    with virtual_display(1500, 940) as display:
        command, environment = check.confined(made, home, ["start.roam"], display)
        began = monotonic()
        running = subprocess.Popen(command, cwd=home, env=environment)
        try:
            window = _until(lambda: _window(display), running)
            shown = monotonic() - began
            # The project may still be on its way; a key that comes too early does nothing.
            _until(lambda: _press(display, window, ONE_FRAME) and _grown(home, before), running)
            tracked = monotonic() - began
            if picture is not None:
                _press(display, window, ALL_FRAMES)
                sleep(20.0)
                _photograph(display, picture)
        finally:
            running.terminate()
            running.wait(30)
    return shown, tracked


def _press(display: str, window: str, key: str) -> bool:
    _tool(display, "windowfocus", window)
    _tool(display, "key", key)
    sleep(0.5)
    return True


def _journals(home: Path) -> list[Path]:
    return list(home.glob(".local/state/roam/journal/**/*.journal"))


def _grown(home: Path, before: dict[Path, int]) -> bool:
    """Whether the journals hold more than before: an edit, which is the tracked frame."""
    return sum(path.stat().st_size for path in _journals(home)) > sum(before.values())


def _window(display: str) -> str:
    done = _tool(display, "search", "--onlyvisible", "--name", "ROAM")
    return done.splitlines()[-1] if done.strip() else ""


def _tool(display: str, *words: str) -> str:
    command, environment = ["xdotool", *words], {"DISPLAY": display, "PATH": "/usr/bin:/bin"}
    return subprocess.run(command, env=environment, capture_output=True, text=True, check=False).stdout


def _until(what: Callable[[], str | bool], running: subprocess.Popen[bytes]) -> str:
    began = monotonic()
    while not (found := what()):
        if running.poll() is not None or monotonic() - began > PATIENCE:
            raise check.Failed("the window did not come to a tracked frame")
        sleep(0.05)
    return str(found)


def _photograph(display: str, picture: Path) -> None:
    program = "import sys; from PySide6.QtGui import QGuiApplication; a = QGuiApplication([]); "
    program += "a.primaryScreen().grabWindow(0).save(sys.argv[1])"
    environment = {"DISPLAY": display, "QT_QPA_PLATFORM": "xcb"}
    subprocess.run([sys.executable, "-c", program, str(picture)], env=environment, check=True)


def main() -> int:
    """Measure two starts and say how long they took."""
    picture = Path(sys.argv[2]).absolute() if len(sys.argv) > 2 else None
    with tempfile.TemporaryDirectory() as folder:
        made = check.unpacked(Path(sys.argv[1]), Path(folder) / "unpacked")
        home = Path(folder) / "home"
        home.mkdir()
        # Tracked, and cut back to the artist's key: the project as it is when the first shape has been drawn.
        check.heard(made, home, ["demo", "--headless", "--frames", "shot", "--save", "demo.roam"])
        check.heard(made, home, ["export", "demo.roam", "start.json", "--to", "json", "--keys", "artist"])
        check.heard(made, home, ["import", "start.json", "--into", "start.roam", "--clip", "shot"])
        for start in ("first", "second"):
            shown, tracked = measured(made, home, picture)
            print(f"The {start} start: the window after {shown:.1f} s, the first tracked frames after {tracked:.1f} s.")
    return 0


if __name__ == "__main__":
    sys.exit(main())
