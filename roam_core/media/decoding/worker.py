"""`python -m roam_core.media.decoding.worker SHARED`: decodes what it is asked for, line by line, until nobody asks.

`roam_core.media.decoding.process` starts it and says what passes between them.

It may die of a damaged file. Before it reads the first one it bounds its own memory; each task has bounded time of the
processor, where the system can count that.
"""

from __future__ import annotations

import json
import os
import signal
import sys
import time
import traceback
from collections.abc import Callable
from contextlib import suppress
from dataclasses import asdict
from pathlib import Path
from typing import TYPE_CHECKING, Any, BinaryIO, ClassVar

import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses

from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media.area import Area
from roam_core.media.decoding.answers import packed, write_pixels
from roam_core.media.image_file import (
    has_several_images,
    read_channels,
    read_header,
    read_image,
    size_in_areas,
    software_of,
)
from roam_core.media.scanlines import ScanlineReader
from roam_core.translatable import said_by, sentence

if TYPE_CHECKING:
    from roam_core.media.movie_plate import MoviePlate

MEMORY = 3 << 30
"""Bytes that decoding may take beyond the program itself: the largest picture that is accepted needs 1.2 GiB."""
MOST_FILE = 4 << 30
"""Bytes of the shared file."""
ALIVE_SECONDS = 1.0
"""Seconds between two words that a long task is getting on."""

Result = tuple[dict[str, Any], Image | None]


class Worker:
    """Reads requests and answers them."""

    def __init__(self, shared: BinaryIO, answers: BinaryIO) -> None:
        self._shared, self._answers = shared, answers
        self._scanlines = ScanlineReader()
        self._movies: dict[str, MoviePlate] = {}
        self._seconds, self._spoke = 0.0, 0.0

    def serve(self, requests: BinaryIO) -> None:
        """Answer every request until there are no more."""
        self.say({"alive": True})
        for line in requests:
            request = json.loads(line)
            here = request.pop("as here")
            os.environ["OCIO"] = here["OCIO"]
            oiio.attribute("threads", here["threads"])
            self._seconds, self._spoke = request.pop("seconds"), time.monotonic()
            self._allow(self._seconds)
            self.say(self._answer(request.pop("task"), request))
            self._allow(0.0)

    def say(self, answer: dict[str, Any]) -> None:
        """Write an answer."""
        self._answers.write(json.dumps(answer).encode() + b"\n")

    def getting_on(self) -> None:
        """A long task has passed another picture: it may take as long for the next one."""
        self._allow(self._seconds)
        if time.monotonic() - self._spoke > ALIVE_SECONDS:
            self._spoke = time.monotonic()
            self.say({"alive": True})

    def _answer(self, task: str, words: dict[str, Any]) -> dict[str, Any]:
        try:
            fields, picture = self._tasks[task](self, **words)
            if picture is not None:
                fields["picture"] = write_pixels(self._shared, picture)
            return fields
        except RoamError as error:
            return {"refused": packed(said_by(error)), "kind": type(error).__name__}
        except MemoryError:
            text = sentence("{file} asks for too much memory; it is damaged or too large.", file=words.get("file", ""))
            return {"refused": packed(text), "kind": "RoamError"}
        except Exception:
            return {"defect": traceback.format_exc()}

    def _allow(self, seconds: float) -> None:
        """Let the system end this process after so many more seconds of the processor; 0: never."""
        if hasattr(signal, "setitimer"):
            signal.setitimer(signal.ITIMER_PROF, seconds)

    # ---- tasks -------------------------------------------------------------------------------------------------------

    def _header(self, file: str, layer: str) -> Result:
        return asdict(read_header(Path(file), layer)), None

    def _image(self, file: str, layer: str, area: list[int] | None) -> Result:
        return {}, read_image(Path(file), layer, None if area is None else Area(*area), self._scanlines)

    def _size_in_areas(self, file: str, layer: str) -> Result:
        return {"size": size_in_areas(Path(file), layer, self._scanlines)}, None

    def _channels(self, file: str) -> Result:
        return {}, read_channels(Path(file))

    def _several_images(self, file: str) -> Result:
        return {"several": has_several_images(Path(file))}, None

    def _software(self, file: str) -> Result:
        return {"software": software_of(Path(file))}, None

    def _movie(self, file: str) -> Result:
        movie = self._opened(file)
        told = ("size", "fps", "pixel_aspect", "colour_space", "depth", "count", "claimed")
        return {name: getattr(movie, name) for name in told}, None

    def _movie_picture(self, file: str, frame: int) -> Result:
        return {}, self._opened(file).read(frame)

    def _opened(self, file: str) -> MoviePlate:
        """The movie of a path: it stays open for the next picture."""
        from roam_core.media.deep_movie import opened_movie  # large libraries

        if file not in self._movies:
            self._movies.clear()
            self._movies[file] = opened_movie(Path(file), self.getting_on)
        return self._movies[file]

    _tasks: ClassVar[dict[str, Callable[..., Result]]] = {
        "header": _header,
        "image": _image,
        "size in areas": _size_in_areas,
        "channels": _channels,
        "several images": _several_images,
        "software": _software,
        "movie": _movie,
        "movie picture": _movie_picture,
    }


def limit_memory(more: int) -> None:
    """Bound what this process may take beyond what it has, and the size of its files, where the system does so."""
    with suppress(ImportError, OSError, ValueError):
        import resource

        held = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
        resource.setrlimit(resource.RLIMIT_AS, (held + more, held + more))
        resource.setrlimit(resource.RLIMIT_FSIZE, (MOST_FILE, MOST_FILE))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def main(shared: str) -> None:
    """Serve on the standard input and output. What libraries print goes nowhere."""
    answers = os.fdopen(os.dup(sys.stdout.fileno()), "wb", buffering=0)
    nowhere = os.open(os.devnull, os.O_WRONLY)
    os.dup2(nowhere, sys.stdout.fileno())
    limit_memory(MEMORY)
    with Path(shared).open("r+b", buffering=0) as file:
        Worker(file, answers).serve(sys.stdin.buffer)


if __name__ == "__main__":
    main(sys.argv[1])
