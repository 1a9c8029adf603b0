"""Writes the demo shot to a folder as an image sequence, once."""

from __future__ import annotations

import hashlib
import os
from collections.abc import Callable
from pathlib import Path

import cv2

from .shot import render_frame
from .timing import FIRST, LAST

VERSION = "manta-2"
"""Changes with every change of the picture or the true outline, so that no old frames are taken for new ones."""

_END_OF_PNG = bytes.fromhex("0000000049454e44ae426082")


def cache_name() -> str:
    """Name of the folder for this version's frames: `demo-` and a short hash."""
    return "demo-" + hashlib.sha256(VERSION.encode()).hexdigest()[:8]


def frame_path(folder: Path, frame: int) -> Path:
    """Where `write_frames` puts a frame: `demo.1001.png` and so on."""
    return folder / f"demo.{frame}.png"


def missing_frames(folder: Path) -> list[Path]:
    """The files that `write_frames` would write: those that are not there, or not complete."""
    return [path for f in range(FIRST, LAST + 1) if not _is_complete(path := frame_path(folder, f))]


def write_frames(folder: Path, progress: Callable[[float, str], None] | None = None) -> None:
    """Render the shot into `folder` as 8-bit PNG; frames that lie there complete are kept.

    Parameters
    ----------
    folder : made when it is missing. A folder named by `cache_name` never mixes two versions.
    progress : called with the finished share in [0, 1] and a few words; what it raises stops the work, and the frames
        finished by then stay.

    Raises
    ------
    OSError
        when the folder cannot be made or written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    count = LAST + 1 - FIRST
    for done, frame in enumerate(range(FIRST, LAST + 1)):
        if progress is not None:
            progress(done / count, f"rendering the demo shot, frame {frame}")
        if not _is_complete(frame_path(folder, frame)):
            _write(frame_path(folder, frame), _encoded(frame))
    if progress is not None:
        progress(1.0, "the demo shot is rendered")


def _encoded(frame: int) -> bytes:
    ok, data = cv2.imencode(".png", render_frame(frame)[..., ::-1], [cv2.IMWRITE_PNG_COMPRESSION, 2])
    if not ok:
        raise OSError(f"frame {frame} of the demo shot could not be encoded as PNG")
    return data.tobytes()


def _is_complete(path: Path) -> bool:
    """True when a file is there and ends as a PNG ends."""
    try:
        with path.open("rb") as file:
            file.seek(-len(_END_OF_PNG), os.SEEK_END)
            return file.read() == _END_OF_PNG
    except OSError:
        return False


def _write(path: Path, data: bytes) -> None:
    """Put `data` in place in one step: another process that reads the folder sees a whole frame or none."""
    unfinished = path.with_name(f".{path.name}.{os.getpid()}")
    try:
        unfinished.write_bytes(data)
        unfinished.replace(path)
    finally:
        unfinished.unlink(missing_ok=True)
