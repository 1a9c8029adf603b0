"""Movies of pictures for review, by the encoders that come with OpenCV; nothing else needs to be installed.

OpenCV's own build of FFmpeg writes MPEG-4 (part 2) and Motion JPEG. H.264 it only writes where the system brings an
encoder of its own, so that it is not counted on.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import Any

import cv2

from roam_core.arrays import UInt8
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.interchange.authorship import MARK
from roam_core.temporary import working_folder
from roam_core.translatable import sentence

ENCODERS: dict[str, tuple[str, ...]] = {".mp4": ("mp4v",), ".mov": ("mp4v", "jpeg"), ".avi": ("MJPG", "XVID")}
"""By the suffix of a movie the codecs that are tried, best first."""
SPEEDS = (0.01, 240.0)
"""Frames a second."""
FOLDER = "roam-movie"
"""Of the folder in which a movie is encoded."""
PIECE = 1 << 20
"""Bytes that are copied at once."""


def is_movie(path: Path) -> bool:
    """Whether a file of this name would be a movie that can be written."""
    return path.suffix.lower() in ENCODERS


def write_movie(path: Path, pictures: Iterable[UInt8], size: tuple[int, int], fps: float) -> int:
    """Write pictures of `size` (width, height), `(h, w, 3)` RGB uint8, as a movie; returns how many there are.

    The movie is encoded in a temporary folder, opened again and counted, and only then put at `path` as a whole.

    Raises
    ------
    RoamError
        when no encoder of this kind of movie works here, the movie cannot be read again, or the file cannot be
        written.
    """
    if not SPEEDS[0] <= fps <= SPEEDS[1]:
        raise RoamError(
            sentence(
                "A movie runs at {least:g} to {most:g} frames a second, not at {fps:g}; choose another speed.",
                least=SPEEDS[0],
                most=SPEEDS[1],
                fps=fps,
            )
        )
    with working_folder(FOLDER) as folder:
        whole = folder / f"movie{path.suffix.lower()}"
        encoder = _encoder(whole, size, fps)
        count = 0
        try:
            for picture in pictures:
                encoder.write(cv2.cvtColor(picture, cv2.COLOR_RGB2BGR))
                count += 1
        finally:
            encoder.release()
        found = movie_length(whole)
        if found != count:
            raise RoamError(
                sentence(
                    "{path} cannot be encoded: of {count} frames {found} can be read; is the disk full?",
                    path=path,
                    count=count,
                    found=found,
                )
            )
        write_atomically(path, _signed(whole))
    return count


def require_encoder(path: Path, size: tuple[int, int]) -> None:
    """Raise `RoamError` where a movie of this name and (width, height) could not be encoded."""
    with working_folder(FOLDER) as folder:
        _encoder(folder / f"movie{path.suffix.lower()}", size, SPEEDS[0]).release()


def movie_length(path: Path) -> int:
    """How many frames of a movie can be decoded, one after the other; 0 for what is no movie."""
    reader, count = cv2.VideoCapture(str(path)), 0
    try:
        while reader.grab():
            count += 1
    finally:
        reader.release()
    return count


def _encoder(path: Path, size: tuple[int, int], fps: float) -> Any:
    for name in ENCODERS[path.suffix]:
        with suppress(cv2.error):
            writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*name), fps, size)
            if writer.isOpened():
                return writer
            writer.release()
    raise RoamError(
        sentence(
            "No encoder for {suffix} movies works here; name a folder, and each frame is written as a picture.",
            suffix=path.suffix,
        )
    )


def _signed(whole: Path) -> Iterator[bytes]:
    """The movie's bytes, and behind them our mark in a part that players pass over."""
    with whole.open("rb") as file:
        while piece := file.read(PIECE):
            yield piece
    yield signature(whole.suffix)


def signature(suffix: str) -> bytes:
    """What stands at the end of a movie of ours: a `free` box of MPEG-4 and QuickTime, a `JUNK` chunk of AVI."""
    mark = MARK.encode()
    if suffix == ".avi":  # a chunk's length is even
        mark = mark.rjust(len(mark) + len(mark) % 2)
        return b"JUNK" + len(mark).to_bytes(4, "little") + mark
    return (8 + len(mark)).to_bytes(4, "big") + b"free" + mark
