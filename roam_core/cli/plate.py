"""Opening a clip for a command: the source behind a cache that decodes ahead, and pictures as the engine wants them."""

from __future__ import annotations

import argparse
import sys
import threading
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path

from tqdm import tqdm

from roam_core.arrays import Image
from roam_core.cli.environment import cache_bytes
from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, FrameCache, MissingFrame, PlateSource, declared, open_clip
from roam_core.media.colour_spaces import config_trouble, known_space
from roam_core.media.finding import is_there
from roam_core.media.partial import PartialFrames, PartialPicture
from roam_core.media.unseen import unseen
from roam_core.roto import Clip, Project, file
from roam_core.roto.relinking import numbers_now, other_content, other_size, relinked
from roam_core.system_errors import is_file

AHEAD = 4
"""Frames decoded ahead of the solver."""
CACHE_BYTES = 1 << 29


class Plate:
    """A clip being read."""

    def __init__(self, source: PlateSource, limit_bytes: int = CACHE_BYTES) -> None:
        self.source = source
        self._frames = PartialFrames(source, self._tell)
        self._cache = FrameCache(self._frames, limit_bytes)
        self._bridged: set[int] = set()
        self._lock = threading.Lock()

    def read(self, frame: int) -> Image:
        """The working picture `(h, w, 3)` of a frame, for the engine. Safe from any thread."""
        return self.parts(frame).whole

    def parts(self, frame: int) -> PartialPicture:
        """As `read`: no more is decoded and converted of the picture than is looked at."""
        return self._cache.read(frame)

    def read_or_bridge(self, frame: int) -> Image:
        """As `read`, for a run: of a frame that is there and cannot be read the user is told, once, that it is bridged.

        Raises `MissingFrame` all the same.
        """
        with self._telling(frame):
            return self.read(frame)

    def parts_or_bridge(self, frame: int) -> PartialPicture:
        """As `parts`, for a run: see `read_or_bridge`."""
        with self._telling(frame):
            return self.parts(frame)

    @contextmanager
    def _telling(self, frame: int) -> Iterator[None]:
        try:
            yield
        except MissingFrame as error:
            self._tell(frame, error)
            raise

    def _tell(self, frame: int, error: MissingFrame) -> None:
        with self._lock:
            is_news = frame in self.source.frames and frame not in self._bridged
            self._bridged.add(frame)
        if is_news:
            tqdm.write(f"roam: {error} It is bridged like a missing frame.", file=sys.stderr)

    def require_read(self) -> None:
        """Refuse, at the end of a run, that pictures were away while it went on: moved, or on a share that was out.

        Of a picture that is damaged and stays so the run is as good as it can be. One that can be read by now, or is
        not there, was passed over for nothing; who took the run for done would leave its frame out for good.
        """
        with self._lock:
            bridged = [frame for frame in self.source.frames if frame in self._bridged]
        if away := [frame for frame in bridged if self._is_sound(frame)]:
            where = f"frame {away[0]}" if len(away) == 1 else f"{len(away)} frames from {away[0]} to {away[-1]}"
            raise RoamError(
                f"The plate {self.source.path} was away for a while, and {where} had to be passed over; run it again "
                "when it is back."
            )

    def _is_sound(self, frame: int) -> bool:
        """Whether a picture can be read now, or nothing can be known of it, for it is not there."""
        if not is_file(self.source.file_of(frame)):
            return True
        try:
            self.source.read(frame)
        except DamagedFrame:
            return False
        except MissingFrame:
            return True
        return True

    def close(self) -> None:
        """End the threads that read ahead."""
        self._cache.close()

    def ahead_of(self, frame: int, frames: range) -> None:
        """Decode the frames that follow `frame` in `frames` in the background."""
        position = frames.index(frame)
        self._cache.read_ahead([f for f in frames[position + 1 : position + 1 + AHEAD] if f in self.source.frames])


def loaded(path: Path) -> Project:
    """The project of a file, with its plate where it lies now."""
    return relinked(file.load(path), path.parent)


def add_layer(parser: argparse.ArgumentParser) -> None:
    """Declare the option that chooses a layer of the plate's files."""
    parser.add_argument(
        "--layer", default="", metavar="NAME", help="layer of the EXR files (roam info CLIP names them; default: found)"
    )


def add_reading(parser: argparse.ArgumentParser) -> None:
    """Declare the options that say how the plate's files are read: which layer of them, in which colour space."""
    add_layer(parser)
    parser.add_argument(
        "--colour", default="", metavar="SPACE",
        help="colour space of the plate: sRGB, linear, log, or one of OpenColorIO's (default: found)",
    )  # fmt: skip


@contextmanager
def opened(path: str, clip: Clip | None = None, layer: str = "", colour: str = "") -> Iterator[Plate]:
    """A plate for the length of a `with` block; its reading thread ends with it.

    The layer is the one asked for, else that of the project's `clip`, else the one that is found; so is the space of
    its colours. What the clip declares of its colours and its speed holds, where that is the plate. A plate of another
    size than the project's is refused; of one with another content stderr says so, and that a studio's colour
    configuration, which would tell the space, cannot be read; without a project, what of it is not shown (`unseen`);
    of a project's plate, that it has none of the project's frames, or its pictures under other numbers.
    """
    if clip is not None and path == str(clip.path):
        require_plate(clip)
    source = open_clip(path, layer or (clip.layer if clip else ""), clip.content if clip else "")
    if clip is not None:
        _compare(clip, Clip.of(source))
    if clip is not None and clip.path == source.path:
        tell(other_frames(clip, source.frames) or numbers_now(clip))
        source = declared(source, clip.colour_space, clip.fps, clip.pixel_aspect)
    if clip is None:
        tell(unseen(source))
    if clip is None and not colour:
        tell(config_trouble())
    if colour:
        source = declared(source, known_space(colour), source.fps, source.pixel_aspect)
    plate = Plate(source, cache_bytes())
    try:
        yield plate
    finally:
        plate.close()


def require_plate(clip: Clip) -> None:
    """Refuse to go on where the plate of a project is gone: of a path that nobody typed `open_clip` says too little."""
    if not is_there(clip.path) and not _is_refused(clip.path):
        raise RoamError(
            f"The project's plate {clip.path} is not there; put it back, or near the project, where it is found by its "
            "name, or choose another in the window with File > Relink clip."
        )


def _is_refused(path: Path) -> bool:
    """Whether the system does not let this user look."""
    try:
        path.stat()
    except PermissionError:
        return True
    except (OSError, ValueError):
        return False
    return False


def _compare(clip: Clip, found: Clip) -> None:
    if refusal := other_size(clip, found):
        raise RoamError(refusal)
    tell(other_content(clip, found))


def other_frames(clip: Clip, frames: Sequence[int]) -> str:
    """That a project's plate, which has these `frames`, has none of the project's, in a sentence; "" where it has."""
    if any(clip.first <= frame <= clip.last for frame in frames):
        return ""
    return (
        f"The plate {clip.path} has none of the project's frames {clip.first} to {clip.last}, but {frames[0]} to "
        f"{frames[-1]}; where it was numbered anew, roam shift follows it."
    )


def tell(warning: str) -> None:
    """Say on stderr what is not as the project has it; "" says nothing."""
    if warning:
        print(f"roam: {warning}", file=sys.stderr)
