"""Pictures of which parts are read by themselves: a small object on a large plate costs what its size demands."""

from __future__ import annotations

import threading
from collections.abc import Callable
from functools import partial

import numpy as np

from roam_core.arrays import Image
from roam_core.media.colour import ROWS_AT_ONCE, to_engine
from roam_core.media.curves import COLOUR_SPACES
from roam_core.media.source import MissingFrame, PlateSource, Rows

ReadFrame = Callable[[int], "Image | PartialPicture"]
"""Gives the picture `(h, w, 3)` of a frame by its number, or its parts; raises `MissingFrame` in a gap."""


class Band:
    """The rows of a frame that were looked at: from the first to before the last, None while there are none."""

    def __init__(self) -> None:
        self.rows: tuple[int, int] | None = None

    def grow(self, top: int, end: int) -> None:
        """Some rows are looked at."""
        first, last = self.rows or (top, end)
        self.rows = min(first, top), max(last, end)


class PartialPicture:
    """The working picture of a frame, of which no more is decoded and converted than is asked for.

    A part is the same as that part of the whole, bit by bit. Safe from any thread.

    Parameters
    ----------
    size : (h, w). colour_space : of the plate's values. rows : where its rows are read; None where all are held.
    top, held : the rows `(k, w, 3)` that are there already, and which is the first of them.
    band : is told which rows are looked at. failed : is told when rows could not be read.
    """

    def __init__(
        self,
        size: tuple[int, int],
        colour_space: str,
        rows: Rows | None,
        top: int,
        held: Image,
        band: Band | None = None,
        failed: Callable[[MissingFrame], None] | None = None,
    ) -> None:
        self.size = size
        self._colour_space, self._rows, self._failed = colour_space, rows, failed
        self._band = Band() if band is None else band
        self._top, self._held = top, held
        self._lock = threading.Lock()

    @property
    def nbytes(self) -> int:
        """The bytes of what is decoded of it."""
        return self._held.nbytes

    @property
    def whole(self) -> Image:
        """All of the working picture `(h, w, 3)`."""
        return self.within(0, self.size[0], 0, self.size[1])

    def within(self, top: int, end: int, left: int, right: int) -> Image:
        """The part `(end - top, right - left, 3)` of the working picture (`roam_core.media.colour.to_engine`).

        Raises
        ------
        MissingFrame
            where its rows cannot be read.
        """
        with self._lock:
            self._band.grow(top, end)
            try:
                self._hold(*whole_strips(top, end, self.size[0]))
            except MissingFrame as error:
                if self._failed is not None:
                    self._failed(error)
                raise
            if self._colour_space in COLOUR_SPACES:
                return to_engine(self._held[top - self._top : end - self._top, left:right], self._colour_space)
            # OpenColorIO is given the very strips that it is given of the whole: it computes several pixels at a time.
            above, below = whole_strips(top, end, self.size[0])
            strips = to_engine(self._held[above - self._top : below - self._top], self._colour_space)
            return strips[top - above : end - above, left:right]

    def _hold(self, top: int, end: int) -> None:
        """Have these rows at hand, and all between them and those that are."""
        if len(self._held) == 0:
            self._top = top
        bottom = self._top + len(self._held)
        parts = [self._held]
        if self._rows is not None and top < self._top:
            parts.insert(0, self._rows.read(top, self._top))
        if self._rows is not None and end > bottom:
            parts.append(self._rows.read(bottom, end))
        if len(parts) > 1:
            self._held = np.concatenate(parts)
            self._top = min(top, self._top)


def whole_strips(top: int, end: int, height: int) -> tuple[int, int]:
    """The rows of the strips, `ROWS_AT_ONCE` each, that hold the rows from `top` to before `end`."""
    return top - top % ROWS_AT_ONCE, min(end + -end % ROWS_AT_ONCE, height)


class PartialFrames:
    """A plate for a `FrameCache`: of each frame the rows are decoded that it will probably be asked for.

    They are those which were looked at of it before, or of the frame nearest to it. All are decoded while nothing was
    looked at yet, and where the plate does not give its rows (`PlateSource.rows`). `failed` is told of a frame more of
    whose rows were wanted and could not be read.
    """

    def __init__(self, source: PlateSource, failed: Callable[[int, MissingFrame], None]) -> None:
        self.readers = source.readers
        self._source, self._failed = source, failed
        self._bands: dict[int, Band] = {}

    def read(self, frame: int) -> PartialPicture:
        """A frame, with the rows that it will probably be asked for.

        Raises
        ------
        MissingFrame, DamagedFrame
            as `PlateSource.read` does.
        """
        size, space = self._source.size[::-1], self._source.colour_space
        expected = self._expected(frame)
        band = self._bands.setdefault(frame, Band())
        rows = self._source.rows(frame) if expected else None
        if rows is None or expected is None:
            return PartialPicture(size, space, None, 0, self._source.read(frame), band)
        top, end = whole_strips(*expected, size[0])
        return PartialPicture(size, space, rows, top, rows.read(top, end), band, partial(self._failed, frame))

    def _expected(self, frame: int) -> tuple[int, int] | None:
        """The rows that were looked at of the frame nearest to one, or of itself; None where of no frame any were."""
        seen = [(abs(other - frame), other) for other, band in tuple(self._bands.items()) if band.rows]
        return self._bands[min(seen)[1]].rows if seen else None
