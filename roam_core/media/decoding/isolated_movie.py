"""IsolatedMovie: a movie that a process of its own decodes."""

from __future__ import annotations

import threading
import weakref
from pathlib import Path
from typing import Any

from roam_core.arrays import Image
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.decoding.answers import Answer
from roam_core.media.decoding.pool import Pool, asked_twice, refusal
from roam_core.media.decoding.process import DecoderProcess, Died, path_text
from roam_core.media.movie_plate import MoviePlate
from roam_core.media.source import DamagedFrame
from roam_core.translatable import sentence

SECONDS = 10.0
"""Of the processor, that each picture may take that a movie passes."""
MOST_FRAMES = 10_000_000
"""Of a movie: four days at 24 a second."""


class IsolatedMovie(MoviePlate):
    """A movie as a plate, as `roam_core.media.movie.Movie` gives it; its process keeps it open between pictures.

    A process that died is started again, and opens the movie anew. A copy has one of its own. It is not
    pickled (`TypeError`): elsewhere the decoding processes are others.
    """

    def __init__(self, path: Path, pool: Pool) -> None:
        require_regular(path)
        super().__init__(path)
        self._pool = pool
        self._lock = threading.Lock()
        self._process: list[DecoderProcess] = []  # one or none
        weakref.finalize(self, _end_all, self._process)
        try:
            told = self._ask("movie")
        except Died as died:
            raise RoamError(refusal(path, died)) from None
        self.size = told.size()
        self.fps, self.pixel_aspect = told.number("fps"), told.number("pixel_aspect")
        self.colour_space, self.depth = told.text("colour_space"), told.text("depth")
        self.claimed = int(told.number("claimed"))
        self._number(min(int(told.number("count")), MOST_FRAMES))

    def __copy__(self) -> IsolatedMovie:
        return IsolatedMovie(self.path, self._pool)

    def __deepcopy__(self, _memo: dict[int, Any]) -> IsolatedMovie:
        return IsolatedMovie(self.path, self._pool)

    def __reduce__(self) -> tuple[Any, ...]:
        raise TypeError(
            f"the movie {self.path} is decoded by a process of this one, and is not pickled; "
            "open it there with open_clip"
        )

    def _picture(self, index: int) -> Image | None:
        try:
            return self._ask("movie picture", frame=index + 1).picture
        except Died as died:
            raise DamagedFrame(
                sentence("Frame {frame} of {refusal}", frame=index + 1, refusal=refusal(self.path, died))
            ) from None

    def _ask(self, task: str, **words: Any) -> Answer:
        with self._lock:
            request = {"file": path_text(self.path), **words}
            return asked_twice(self._lend, self._give_back, task, request, SECONDS)

    def _lend(self) -> DecoderProcess:
        return self._process.pop() if self._process else self._pool.take()

    def _give_back(self, process: DecoderProcess | None) -> None:
        if process is not None:
            self._process.append(process)


def _end_all(processes: list[DecoderProcess]) -> None:
    while processes:
        processes.pop().close()
