"""The way from another program to ROAM and back: by ROAM's own commands, each in a process of its own.

Shipped with the scripts for Nuke, Natron and Blender, whose Python runs it: it needs the standard library alone.
"""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

PROGRAM = "ROAM_PROGRAM"
"""The variable that names ROAM's program, where it is not `roam` on the path."""
BESIDE = "program.txt"
"""The file beside this one that names the program which wrote the scripts (`roam plugin`)."""
FOREIGN = (
    "PYTHONHOME", "PYTHONPATH", "LD_LIBRARY_PATH", "DYLD_LIBRARY_PATH", "QT_PLUGIN_PATH", "QT_QPA_PLATFORM_PLUGIN_PATH",
)  # fmt: skip
"""Variables that the other program sets for libraries of its own, and that ROAM must not see."""


class Trouble(Exception):
    """What went wrong, in a sentence for the artist."""


def program(chosen: str = "") -> str:
    """ROAM's program: the one that was chosen, that the variable names, that wrote this script, or of the path."""
    beside = Path(__file__).with_name(BESIDE)
    writer = beside.read_text(encoding="utf-8").strip() if beside.exists() else ""
    found = chosen or os.environ.get(PROGRAM) or (writer if Path(writer).is_file() else None) or shutil.which("roam")
    if not found:
        raise Trouble(f"ROAM was not found; put its folder on the PATH, or name its program in the variable {PROGRAM}.")
    return found


def run(*arguments: object, chosen: str = "") -> str:
    """Run a command of ROAM's and wait for it. Returns what it says; a refusal is `Trouble` in its own words."""
    command = [program(chosen), *map(str, arguments)]
    try:
        done = subprocess.run(
            command,
            capture_output=True,
            encoding="utf-8",
            errors="replace",
            env=_environment(),
            creationflags=_windows_flags(),
            check=False,
        )
    except OSError as error:
        raise Trouble(f"{command[0]} cannot be started: {error}.") from None
    if done.returncode != 0:
        raise Trouble(done.stderr.strip() or f"roam {arguments[0]} ended with {done.returncode}.")
    return (done.stdout + done.stderr).strip()


def open_window(path: object, chosen: str = "") -> None:
    """Open ROAM's window on a clip or project, and do not wait for it."""
    new_session: dict[str, Any] = {} if sys.platform == "win32" else {"start_new_session": True}
    try:
        subprocess.Popen(
            [program(chosen), str(path)], env=_environment(), creationflags=_windows_flags(), **new_session
        )
    except OSError as error:
        raise Trouble(f"ROAM's window cannot be opened: {error}.") from None


def send(project: Path, clip: str, shapes: Path | None, offset: int = 0, chosen: str = "") -> None:
    """Make a project on a clip, with the shapes of a file, and open it; without shapes the clip alone is opened.

    `offset` is what the other program's frame numbers have more than the plate's own.
    """
    if shapes is None:
        open_window(clip, chosen)
        return
    run("import", shapes, "--into", project, "--clip", clip, "--frame-offset", offset, chosen=chosen)
    open_window(project, chosen)


def bring(project: Path, target: Path, kind: str, offset: int = 0, chosen: str = "") -> str:
    """Write a project's shapes as a file of the other program's kind; what that cannot hold is said, not refused."""
    return run(
        "export", project, target, "--to", kind, "--frame-offset", offset, "--lossy", "--overwrite", chosen=chosen
    )


def first_frame(clip: str, chosen: str = "") -> int:
    """The number of a clip's first frame, as ROAM counts."""
    return _ends(clip, chosen)[0]


def frame_of_file(clip: str, chosen: str = "") -> int:
    """The number of the picture that is named, of a sequence of which ROAM takes all; of what has none the first."""
    first, last = _ends(clip, chosen)
    found = re.search(r"(\d+)\D*$", Path(clip).stem)
    return int(found[1]) if found is not None and first <= int(found[1]) <= last else first


def project_of(name: str) -> Path:
    """The project of a name from a dialog, in which `.roam` may be left out; `shot.v002` has no suffix to give up."""
    if not name or name.endswith(("/", os.sep)):
        raise Trouble("Give the project a name.")
    return Path(name if name.lower().endswith(".roam") else f"{name}.roam")


def document(shapes: Sequence[dict[str, Any]], size: tuple[int, int]) -> str:
    """ROAM's plain JSON of shapes, bottom first; `size` is the plate's width and height."""
    kinds = [{"kind": "shape", **shape} for shape in shapes]
    return json.dumps({"format": "roam-shapes", "version": 2, "width": size[0], "height": size[1], "items": kinds})


def keys_of(rows: dict[int, list[list[float]]], tolerance: float = 1e-3) -> list[dict[str, Any]]:
    """Keys of an outline that was read on every frame: those between which it moves straight, within `tolerance`.

    `tolerance` is in pixels; `rows` are the points by frame: x, y, and those of the handles before and after it.
    """
    frames = sorted(rows)
    kept = [frames[0]]
    last = 1
    while kept[-1] != frames[-1]:
        last = frames.index(kept[-1]) + 1
        while last + 1 < len(frames) and _is_straight(rows, kept[-1], frames[last + 1], tolerance):
            last += 1
        kept.append(frames[last])
    return [{"frame": frame, "interpolation": "linear", "points": rows[frame]} for frame in kept]


def _is_straight(rows: dict[int, list[list[float]]], first: int, last: int, tolerance: float) -> bool:
    for frame in (frame for frame in rows if first < frame < last):
        share = (frame - first) / (last - first)
        for start, middle, end in zip(rows[first], rows[frame], rows[last]):  # noqa: B905 - also for Python 3.9
            if any(abs(a + share * (b - a) - m) > tolerance for a, m, b in zip(start, middle, end)):  # noqa: B905
                return False
    return True


def _ends(clip: str, chosen: str) -> tuple[int, int]:
    found = re.search(r"^frames\s+(-?\d+)-(-?\d+)", run("info", clip, chosen=chosen), flags=re.MULTILINE)
    if found is None:
        raise Trouble(f"{clip} has no frames.")
    return int(found[1]), int(found[2])


def _windows_flags() -> int:
    """No console window, which Windows opens for ROAM's program, and whose end would end ROAM's window."""
    return int(getattr(subprocess, "CREATE_NO_WINDOW", 0))


def _environment() -> dict[str, str]:
    """What ROAM's process gets: what is read from it is UTF-8, whatever the machine's language."""
    kept = {name: value for name, value in os.environ.items() if name not in FOREIGN}
    kept["PYTHONIOENCODING"] = "utf-8:backslashreplace"
    return kept
