"""Measures a bundle from the double click on a project to a tracked frame, in a window on a virtual display.

    python -m bundle.first_track dist/roam-VERSION-linux-MACHINE.tar.gz [PICTURE.png]

The bundle is unpacked, its home is empty but for a project on the demo's frames with a shape on the first, and no file
of it was read before by this run alone: the second number is that of a second start. Seconds of processors tell of a
machine that does other work too. Needs Xvfb and xdotool.
"""

from __future__ import annotations

import subprocess
import sys
import tempfile
from pathlib import Path
from time import sleep

from bundle import check
from scripts.watched_window import NotShown, watched_window

ONE_FRAME, ALL_FRAMES = "shift+bracketright", "bracketright"
PAUSE = 0.5
"""Seconds between two presses of a key: the project may still be on its way, and a key that comes too early is lost."""


def measured(made: Path, home: Path, picture: Path | None) -> str:
    """What it took from the start to the window, and to the first tracked frames in the journal of edits."""
    before = _size_of_journals(home)
    with watched_window(lambda display: check.confined(made, home, ["start.roam"], display), home) as (window, display):
        shown, spent = window.shown(), window.processor_seconds()

        def is_tracked() -> bool:
            window.press(ONE_FRAME)
            sleep(PAUSE)
            return _size_of_journals(home) > before

        window.until(is_tracked)
        tracked, spent_then = window.seconds(), window.processor_seconds()
        if picture is not None:
            window.press(ALL_FRAMES)
            sleep(20.0)
            _photograph(display, picture)
    return (
        f"the window after {shown:.1f} s ({spent:.1f} s of processors), "
        f"the first tracked frames after {tracked:.1f} s ({spent_then:.1f} s of processors)"
    )


def _size_of_journals(home: Path) -> int:
    """Bytes of all journals of edits: more than before is an edit, which is the tracked frame."""
    return sum(path.stat().st_size for path in home.glob(".local/state/roam/journal/**/*.journal"))


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
            try:
                print(f"The {start} start: {measured(made, home, picture)}.")
            except NotShown as error:
                print(error, file=sys.stderr)
                return 1
    return 0


if __name__ == "__main__":
    sys.exit(main())
