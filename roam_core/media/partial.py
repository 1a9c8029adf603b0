"""Pictures of which parts are read by themselves: a small object on a large plate costs what its size demands."""

from __future__ import annotations

import threading
from collections.abc import Callable, Mapping
from functools import partial

import numpy as np

from roam_core.arguments import shown
from roam_core.arrays import Image
from roam_core.errors import RoamError
from roam_core.media.area import Area
from roam_core.media.colour import ROWS_AT_ONCE, to_engine
from roam_core.media.curves import COLOUR_SPACES
from roam_core.media.source import Areas, MissingFrame, PlateSource
from roam_core.translatable import sentence

ReadFrame = Callable[[int], "Image | PartialPicture"]
"""Gives the picture `(h, w, 3)` of a frame by its number, or its parts; raises `MissingFrame` in a gap."""
Images = ReadFrame | Mapping[int, "Image | PartialPicture"]
"""The pictures of a shot, from a function or in a mapping."""


COLUMNS_AT_ONCE = 128
"""Columns are read in whole multiples of so many, and at least as many beyond those that are looked at on either side:
otherwise each frame in which an object has moved would be read twice."""


class LookedAt:
    """The area of a frame that was looked at: the least around all of it, None while there was nothing."""

    def __init__(self) -> None:
        self.area: Area | None = None

    def grow(self, area: Area) -> None:
        """An area is looked at."""
        self.area = area if self.area is None else self.area.joined(area)


class PartialPicture:
    """The working picture of a frame, of which no more is decoded and converted than is asked for.

    A part is the same as that part of the whole, bit by bit. Safe from any thread.

    Parameters
    ----------
    size : (h, w). colour_space : of the plate's values. areas : where its areas are read; None where all is held.
    corner, held : the area `(rows, columns, 3)` that is there already, and the row and column of its first pixel.
    looked_at : is told which areas are looked at. failed : is told when one could not be read.
    """

    def __init__(
        self,
        size: tuple[int, int],
        colour_space: str,
        areas: Areas | None,
        corner: tuple[int, int],
        held: Image,
        looked_at: LookedAt | None = None,
        failed: Callable[[MissingFrame], None] | None = None,
    ) -> None:
        self.size = size
        self._colour_space, self._areas, self._failed = colour_space, areas, failed
        self._looked_at = LookedAt() if looked_at is None else looked_at
        self._top, self._left = corner
        self._held = held
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
            where it cannot be read.
        """
        area = Area(top, end, left, right)
        with self._lock:
            self._looked_at.grow(area)
            strips = whole_strips(area, self.size, self._colour_space)
            try:
                self._hold(strips)
            except MissingFrame as error:
                if self._failed is not None:
                    self._failed(error)
                raise
            if self._colour_space in COLOUR_SPACES:
                return to_engine(area.of(self._held, self._top, self._left), self._colour_space)
            # OpenColorIO is given the very strips that it is given of the whole: it computes several pixels at a time.
            converted = to_engine(strips.of(self._held, self._top, self._left), self._colour_space)
            return area.of(converted, strips.top, strips.left)

    def _hold(self, area: Area) -> None:
        """Have this area at hand, and all between it and what is."""
        if self._areas is None:
            return
        held = Area(self._top, self._top + self._held.shape[0], self._left, self._left + self._held.shape[1])
        if held.is_empty or not held.spans(area):
            wanted = with_columns_beside(area, self.size)
            wanted = wanted if held.is_empty else wanted.joined(held)
            self._held = self._areas.read(wanted)
            self._top, self._left = wanted.top, wanted.left
            return
        parts = [self._held]
        if area.top < held.top:
            parts.insert(0, self._areas.read(held._replace(top=area.top, end=held.top)))
        if area.end > held.end:
            parts.append(self._areas.read(held._replace(top=held.end, end=area.end)))
        if len(parts) > 1:
            self._held = np.concatenate(parts)
            self._top = min(area.top, held.top)


def whole_strips(area: Area, size: tuple[int, int], colour_space: str) -> Area:
    """The area of the strips, `ROWS_AT_ONCE` rows each, that hold `area` of a picture (h, w).

    Of a colour space that is converted by OpenColorIO they have the picture's whole width.
    """
    top, end = area.top - area.top % ROWS_AT_ONCE, min(area.end + -area.end % ROWS_AT_ONCE, size[0])
    left, right = (area.left, area.right) if colour_space in COLOUR_SPACES else (0, size[1])
    return Area(top, end, left, right)


def with_columns_beside(area: Area, size: tuple[int, int]) -> Area:
    """What is read of a picture (h, w) for an area: see `COLUMNS_AT_ONCE`."""
    left, right = max(area.left - COLUMNS_AT_ONCE, 0), area.right + COLUMNS_AT_ONCE
    left, right = left - left % COLUMNS_AT_ONCE, min(right + -right % COLUMNS_AT_ONCE, size[1])
    return area._replace(left=left, right=right)


class PartialFrames:
    """A plate for a `FrameCache`: of each frame the area is decoded that it will probably be asked for.

    It is around that which was looked at of it before, or of the frame nearest to it. All is decoded while nothing was
    looked at yet, and where the plate does not give its areas (`PlateSource.areas`). `failed` is told of a frame of
    which more was wanted and could not be read.
    """

    def __init__(self, source: PlateSource, failed: Callable[[int, MissingFrame], None]) -> None:
        self.readers = source.readers
        self._source, self._failed = source, failed
        self._looked_at: dict[int, LookedAt] = {}

    def read(self, frame: int) -> PartialPicture:
        """A frame, with the area that it will probably be asked for.

        Raises
        ------
        MissingFrame, DamagedFrame
            as `PlateSource.read` does.
        """
        size, space = self._source.size[::-1], self._source.colour_space
        expected = self._expected(frame)
        areas = self._source.areas(frame) if expected else None
        if areas is None or expected is None:
            whole = self._source.read(frame)
            return PartialPicture(size, space, None, (0, 0), whole, self._kept(frame))
        area = with_columns_beside(whole_strips(expected, size, space), size)
        held, failed = areas.read(area), partial(self._failed, frame)
        return PartialPicture(size, space, areas, (area.top, area.left), held, self._kept(frame), failed)

    def _kept(self, frame: int) -> LookedAt:
        """What is looked at of a frame that could be read: of the many that a long gap lacks nothing is kept."""
        return self._looked_at.setdefault(frame, LookedAt())

    def _expected(self, frame: int) -> Area | None:
        """What was looked at of the frame nearest to one, or of itself; None where of no frame anything was."""
        seen = [(abs(other - frame), other) for other, each in tuple(self._looked_at.items()) if each.area]
        return self._looked_at[min(seen)[1]].area if seen else None


def reading(images: Images) -> ReadFrame:
    """The pictures of a shot from a function, which raises a `RoamError` for a frame that a mapping lacks.

    Raises
    ------
    ValueError
        when they are neither given by a function nor in a mapping.
    """
    look_up = images if callable(images) else getattr(images, "__getitem__", None)
    if look_up is None or isinstance(images, str | bytes | list | tuple | np.ndarray):
        raise ValueError(
            "images are a mapping from frames to pictures, or a function that reads one, as the method `read` of a "
            f"plate, not {shown(images)}"
        )

    def read(frame: int) -> Image | PartialPicture:
        try:
            return look_up(frame)
        except KeyError as error:
            if error.args != (frame,):
                raise
            raise RoamError(
                sentence(
                    "There is no image of frame {frame}; give one, or raise MissingFrame where the plate has none.",
                    frame=frame,
                )
            ) from None

    return read
