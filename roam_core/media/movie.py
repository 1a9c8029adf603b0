"""Movie: a plate inside a movie file, decoded with FFmpeg through OpenCV; any frame, exactly, in any order."""

from __future__ import annotations

import math
import threading
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import cv2
import numpy as np

from roam_core.arrays import Image
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.edit_list import shown_of
from roam_core.media.interlacing import PROBED, require_progressive, thinned
from roam_core.media.measure import plain_name, require_size
from roam_core.media.movie_plate import MoviePlate, turned_aspect
from roam_core.media.source import likely_speed
from roam_core.translatable import sentence

LONGEST_STEP = 24
"""Frames that are decoded one by one rather than sought: about the distance between key frames."""
SAME_TIME = 0.25
"""Two time stamps closer than this part of a frame are one frame's (Matroska rounds them to milliseconds)."""


class Movie(MoviePlate):
    """A movie as a plate, decoded in this process.

    Pictures are 8-bit RGB, whatever the movie's own depth. A seek is believed only where the time stamp it lands on is
    the wanted frame's; else the movie is decoded from its start. So a frame is the same picture however it was
    reached. Opening looks at the first frames, whether they are interlaced, and at the last one; a movie whose stamps
    are uneven, or whose container is wrong about its length, is gone through once when it is opened.

    Parameters
    ----------
    passed : is called after each frame that is decoded on the way to another one.
    """

    def __init__(self, path: Path, passed: Callable[[], None] = lambda: None) -> None:
        super().__init__(path)
        self._passed = passed
        self._lock = threading.Lock()
        self._capture = self._opened()
        self._next = 0  # index of the frame that the next grab gives
        self._times: list[float] = []  # stamps in ms of the frames 0, 1, ... reached by counting
        self.fps = likely_speed(float(self._capture.get(cv2.CAP_PROP_FPS)))
        self._period = 1000.0 / self.fps  # ms
        self.size = self._first_size()
        require_progressive(path, self._first_pictures())
        self.pixel_aspect = self._aspect()
        self._number(self._verified_count())

    def _picture(self, index: int) -> Image | None:
        with self._lock:
            picture = self._retrieved() if self._go_to(index) else None
        return None if picture is None else np.asarray(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB))

    # ---- moving through the file; `_lock` is held, except while opening ----------------------------------------------

    def _go_to(self, index: int) -> bool:
        """Grab the frame `index` (from 0): step where it lies close ahead, else seek, else count from the start."""
        if 0 <= index - self._next <= LONGEST_STEP and self._step_to(index):
            return True
        if self._seek(index):
            return True
        self._rewind()
        return self._step_to(index)

    def _step_to(self, index: int) -> bool:
        """Grab frame after frame up to `index`; False at the end of the movie."""
        while self._next <= index:
            if not self._capture.grab():
                return False
            self._passed()
            if self._next == len(self._times):
                self._times.append(self._stamp())
            self._next += 1
        return True

    def _seek(self, index: int) -> bool:
        """Jump to `index`; False where it cannot be known by its time stamp that this is where the jump led."""
        wanted = self._time_of(index)
        if wanted is None:
            return False
        self._capture.set(cv2.CAP_PROP_POS_FRAMES, index)
        # A jump may land early (the container's clock starts elsewhere); what follows is then decoded up to the frame.
        while self._capture.grab():
            distance = self._stamp() - wanted
            if abs(distance) <= self._tolerance:
                self._next = index + 1
                return True
            if distance > 0.0:
                break
        return False

    def _rewind(self) -> None:
        """Start again from the file: unlike a seek to 0 this depends on nothing in the container."""
        self._capture.release()
        self._capture = self._opened()
        self._next = 0

    def _time_of(self, index: int) -> float | None:
        """The stamp of a frame in ms: as met, or as an even clock gives it; None where a neighbour's is too close."""
        if index >= len(self._times):
            return self._times[0] + index * self._period
        near = self._times[max(index - 1, 0) : index + 2]
        if any(later - earlier <= 2.0 * self._tolerance for earlier, later in pairwise(near)):
            return None
        return self._times[index]

    @property
    def _tolerance(self) -> float:
        """By how many ms the stamps of one frame may differ."""
        return SAME_TIME * self._period

    def _stamp(self) -> float:
        return float(self._capture.get(cv2.CAP_PROP_POS_MSEC))

    def _retrieved(self) -> Image | None:
        found, picture = self._capture.retrieve()
        return picture if found else None

    # ---- opening -----------------------------------------------------------------------------------------------------

    def _opened(self) -> cv2.VideoCapture:
        require_regular(self.path)
        with plain_name(self.path) as name:
            capture = cv2.VideoCapture(name, cv2.CAP_FFMPEG)
        if not capture.isOpened():
            raise RoamError(
                sentence(
                    "{path} is no movie that can be decoded, or it is damaged; convert it to images.", path=self.path
                )
            )
        # Before the first frame is decoded: what the header claims is what a decoder would take memory for.
        size = (capture.get(key) for key in (cv2.CAP_PROP_FRAME_WIDTH, cv2.CAP_PROP_FRAME_HEIGHT))
        require_size(self.path, *(int(side) if math.isfinite(side) else 0 for side in size))
        return capture

    def _first_size(self) -> tuple[int, int]:
        """(width, height) of the first picture; the header's may be before the camera's rotation is applied."""
        picture = self._retrieved() if self._step_to(0) else None
        if picture is None:
            raise RoamError(
                sentence("{path} holds no picture that can be decoded; convert it to images.", path=self.path)
            )
        return int(picture.shape[1]), int(picture.shape[0])

    def _first_pictures(self) -> list[Image]:
        """Of the pictures from the first one on what tells whether the movie is interlaced; nothing is sought."""
        pictures: list[Image] = []
        while len(pictures) < PROBED and (picture := self._retrieved()) is not None:
            if picture.shape[1::-1] != self.size:
                break
            pictures.append(thinned(picture))
            if not self._step_to(self._next):
                break
        return pictures

    def _aspect(self) -> float:
        """The pixels' width over their height, as the pictures are turned."""
        keys = (cv2.CAP_PROP_SAR_NUM, cv2.CAP_PROP_SAR_DEN, cv2.CAP_PROP_ORIENTATION_META)
        over, under, degrees = (float(self._capture.get(key)) for key in keys)
        return turned_aspect(over / under if under > 0.0 else 1.0, degrees)

    def _verified_count(self) -> int:
        """The number of frames: the container's where the last frame bears it out, else counted."""
        claimed = self._capture.get(cv2.CAP_PROP_FRAME_COUNT)
        claimed = self.claimed = int(claimed) if math.isfinite(claimed) else 0
        if claimed > 1 and self._ends_with(claimed - 1):
            return claimed
        self._rewind()
        while self._step_to(self._next):
            pass
        self.claimed = shown_of(self.path, claimed, self.fps)
        return self._next

    def _ends_with(self, last: int) -> bool:
        """Whether the movie ends with `last` at the time that an even clock gives it.

        Then the other frames' stamps follow from their numbers, and a seek to any of them can be checked.
        """
        if not self._seek(last) or self._capture.grab():
            return False
        self._rewind()
        return True
