"""DeepMovie: a movie of more than 8 bits, decoded with FFmpeg through PyAV, where the artist has installed that.

PyAV is none of ROAM's libraries: its packages hold encoders under the GPL. Without it such a movie is read as 8 bits.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from importlib import import_module
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Image
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.edit_list import shown_of
from roam_core.media.interlacing import PROBED, interlaced, is_combed, thinned
from roam_core.media.measure import plain_name, require_size
from roam_core.media.movie import LONGEST_STEP, Movie
from roam_core.media.movie_plate import MoviePlate, turned_aspect
from roam_core.media.source import likely_speed
from roam_core.translatable import sentence

LIBRARY = "av"
USUAL_DEPTH = 8
BT601, BT709 = 5, 1
"""FFmpeg's numbers for the matrices from YUV to RGB."""
UNSPECIFIED = 2
HD_HEIGHT = 720
"""Rows from which a movie that does not name its matrix has that of Rec. 709."""


def opened_movie(path: Path, passed: Callable[[], None] = lambda: None) -> MoviePlate:
    """A movie, with all its bits where PyAV is installed. `passed` is called after each frame that is passed.

    Raises
    ------
    RoamError
        as `Movie` does.
    """
    if find_spec(LIBRARY) is not None and _depth_of(path) > USUAL_DEPTH:
        return DeepMovie(path, passed)
    return Movie(path, passed)


class DeepMovie(MoviePlate):
    """A movie as a plate, with pictures of 16 bits for each colour.

    Its packets are gone through when it is opened, without decoding them: each has the time of one frame, evenly spaced
    or not, and by that time frames are sought. A frame is the same picture however it was reached.
    """

    def __init__(self, path: Path, passed: Callable[[], None] = lambda: None) -> None:
        super().__init__(path)
        self._passed = passed
        self._lock = threading.Lock()
        self._container, self._stream = _opened(path)
        self.depth = f"{_bits(self._stream)} bits"
        self.fps = likely_speed(float(self._stream.average_rate or self._stream.guessed_rate or 0.0))
        self._times = self._times_of_packets()
        self.claimed = shown_of(path, int(self._stream.frames), self.fps)
        self._number(len(self._times))
        self._frames: Iterator[Any] = iter(())
        self._next = 0
        self._rewind()
        self.size = self._first_size()
        self.pixel_aspect = self._aspect()

    def _picture(self, index: int) -> Image | None:
        with self._lock:
            frame = self._frame(index)
            return None if frame is None else _rgb(frame)

    def _times_of_packets(self) -> list[int]:
        """When each frame is shown, in units of the stream's clock, in order.

        What a trim without encoding anew leaves in the file is decoded for what comes after it, and never shown.
        """
        times: set[int] = set()
        try:
            for packet in self._container.demux(self._stream):
                if packet.pts is not None and not packet.is_discard:
                    times.add(packet.pts)
                    self._passed()
        except _errors():
            pass  # what comes before the damage is there
        return sorted(times)

    def _aspect(self) -> float:
        """The pixels' width over their height, as the pictures are turned."""
        frame = self._frame(0)
        aspect = float(self._stream.sample_aspect_ratio or 1.0)
        return turned_aspect(aspect, 0.0 if frame is None else frame.rotation)

    def _first_size(self) -> tuple[int, int]:
        """(width, height) of the first picture; the first ones must not be interlaced."""
        pictures: list[Image] = []
        for index in range(min(PROBED, self.count)):
            frame = self._frame(index)
            if frame is None:
                break
            if frame.interlaced_frame:
                raise interlaced(self.path)
            pictures.append((_rgb(frame) >> 8).astype(np.uint8))
        if not pictures:
            raise RoamError(
                sentence("{path} holds no picture that can be decoded; convert it to images.", path=self.path)
            )
        if is_combed([thinned(picture) for picture in pictures if picture.shape == pictures[0].shape]):
            raise interlaced(self.path)
        height, width = pictures[0].shape[:2]
        return width, height

    def _frame(self, index: int) -> Any:
        """The decoded frame `index`, from 0: by going on where it lies close ahead, else sought; None without it."""
        if 0 <= index - self._next <= LONGEST_STEP and (frame := self._gone_on_to(index)) is not None:
            return frame
        for seek in (self._seek, self._rewind):
            seek(index)
            if (frame := self._gone_on_to(index)) is not None:
                return frame
        return None

    def _gone_on_to(self, index: int) -> Any:
        """Decode up to the frame whose time is that of `index`; None where that does not come, or is damaged."""
        try:
            for frame in self._frames:
                self._passed()
                if frame.pts == self._times[index]:
                    self._next = index + 1
                    return None if frame.is_corrupt else frame
                if frame.pts is None or frame.pts > self._times[index]:
                    return None
        except _errors():
            return None
        return None

    def _seek(self, index: int) -> None:
        try:
            self._container.seek(self._times[index], stream=self._stream)
        except _errors():
            return
        self._frames = self._container.decode(self._stream)

    def _rewind(self, _: int = 0) -> None:
        """Begin again from the file: unlike a seek to the first frame this depends on nothing in the container."""
        self._container.close()
        self._container, self._stream = _opened(self.path)
        self._frames, self._next = self._container.decode(self._stream), 0


def _opened(path: Path) -> tuple[Any, Any]:
    """The container of a movie and its first stream of pictures. Raises `RoamError`."""
    require_regular(path)
    try:
        with plain_name(path) as name:
            container = import_module(LIBRARY).open(name)
    except _errors() as error:
        raise RoamError(
            sentence(
                "{path} is no movie that can be decoded ({reason}); convert it to images.",
                path=path,
                reason=str(error),
            )
        ) from None
    if not container.streams.video:
        container.close()
        raise RoamError(sentence("{path} holds no picture that can be decoded; convert it to images.", path=path))
    stream = container.streams.video[0]
    stream.thread_type = "AUTO"
    require_size(path, stream.codec_context.width, stream.codec_context.height)
    return container, stream


def _depth_of(path: Path) -> int:
    """Bits of a movie's colours; 0 for what PyAV cannot open."""
    try:
        container, stream = _opened(path)
    except RoamError:
        return 0
    bits = _bits(stream)
    container.close()
    return bits


def _bits(stream: Any) -> int:
    """Bits of the first component of the pictures."""
    components = stream.codec_context.format.components if stream.codec_context.format is not None else ()
    return max((component.bits for component in components), default=0)


def _rgb(frame: Any) -> NDArray[np.uint16]:
    """A frame as RGB `(h, w, 3)`, turned as the camera was held; the matrix is the one that it names, or the usual."""
    usual = BT709 if frame.height >= HD_HEIGHT else BT601
    named = int(frame.colorspace)
    converted = frame.reformat(format="rgb48le", src_colorspace=usual if named == UNSPECIFIED else named)
    picture = converted.to_ndarray()
    turned = np.rot90(picture, round(frame.rotation / 90.0) % 4)
    return np.ascontiguousarray(turned, dtype=np.uint16)


def _errors() -> tuple[type[Exception], ...]:
    """What PyAV raises of a damaged movie."""
    return (import_module(LIBRARY).error.FFmpegError, ValueError, OverflowError)
