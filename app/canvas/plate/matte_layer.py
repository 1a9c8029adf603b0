"""MatteLayer: a project's matte or cut-out on a frame, rendered beside the window's thread, the newest wish first."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import NamedTuple

import cv2
import numpy as np
from PySide6.QtCore import QObject, Signal

from roam_core.arrays import Float32, UInt8
from roam_core.roto import Project

from .picture import Picture

Render = Callable[[Project, int, tuple[int, int]], Float32]


class MatteRequest(NamedTuple):
    """What to render: `size` is (h, w). With the plate's picture of the frame, it is cut out."""

    project: Project
    frame: int
    size: tuple[int, int]
    plate: Picture | None = None

    def is_same(self, other: MatteRequest | None) -> bool:
        """Projects are immutable: the same object has the same matte."""
        return (
            other is not None
            and self.project is other.project
            and self[1:3] == other[1:3]
            and self.plate is other.plate
        )


class MatteLayer(QObject):
    """Renders mattes one at a time; a request made meanwhile waits, and replaces one that waited.

    The thread lives as long as there is something to render.
    """

    ready = Signal()
    _rendered = Signal(object, object)

    def __init__(self, render: Render | None = None) -> None:
        super().__init__()
        self._render = render or _render
        self._shown: MatteRequest | None = None
        self._running: MatteRequest | None = None
        self._waiting: MatteRequest | None = None
        self._thread: threading.Thread | None = None
        self._is_dropped = False
        """Whether what is being rendered is of a project that is shown no more."""
        self._rendered.connect(self._take)
        self.pixels: UInt8 | None = None
        """The last matte, (h, w), or the plate cut out by it, (h, w, 4); read-only. None where that failed."""
        self.plate: Picture | None = None
        """The picture that `pixels` are cut out of; None for a matte."""

    def request(self, project: Project, frame: int, size: tuple[int, int], plate: Picture | None = None) -> None:
        """Ask for a matte, or with the plate's picture for a cut-out; `ready` tells when `pixels` holds it."""
        request = MatteRequest(project, frame, size, plate)
        if self._running:
            is_coming = request.is_same(self._running) and not self._is_dropped
            self._waiting = None if is_coming else request
        elif not request.is_same(self._shown):
            self._start(request)

    def holds(self, project: Project, frame: int, plate: Picture | None) -> bool:
        """Whether this is what was rendered last."""
        shown = self._shown
        return shown is not None and MatteRequest(project, frame, shown.size, plate).is_same(shown)

    @property
    def is_busy(self) -> bool:
        """Whether one is being rendered."""
        return self._running is not None

    def forget(self) -> None:
        """Another project: what is being rendered is nobody's."""
        self._waiting = self._shown = None
        self._is_dropped = self._running is not None

    def close(self) -> None:
        """Wait for the matte under work, and forget what waits."""
        self._waiting = None
        self._join()

    def _join(self) -> None:
        if self._thread:
            self._thread.join()

    def _start(self, request: MatteRequest) -> None:
        self._join()  # what has told of its result may not have ended yet
        self._running = request
        self._thread = threading.Thread(target=self._work, args=(request,), name="matte")
        self._thread.start()

    def _work(self, request: MatteRequest) -> None:
        """On the layer's thread: the signal brings the result back to the window's."""
        pixels: UInt8 | None = None
        try:
            matte = self._render(*request[:3])
            pixels = np.rint(matte * np.float32(255.0)).astype(np.uint8)
            if request.plate is not None:
                pixels = cut_out(request.plate.pixels, pixels)
            pixels.setflags(write=False)
        finally:  # after an error, too, which goes its own way: the next request has to be rendered
            self._rendered.emit(request, pixels)

    def _take(self, request: MatteRequest, pixels: UInt8 | None) -> None:
        self._running, is_dropped, self._is_dropped = None, self._is_dropped, False
        if not is_dropped:
            self.pixels, self.plate, self._shown = pixels, request.plate, request
        waiting, self._waiting = self._waiting, None
        if waiting:
            self._start(waiting)
        if not is_dropped:
            self.ready.emit()


def cut_out(plate: UInt8, matte: UInt8) -> UInt8:
    """The plate's picture `(h, w, 3)` with the matte, brought to its size, as opacity: `(h, w, 4)`."""
    if matte.shape != plate.shape[:2]:
        matte = np.asarray(cv2.resize(matte, plate.shape[1::-1], interpolation=cv2.INTER_AREA))
    return np.asarray(cv2.merge([*cv2.split(plate), matte]))


def _render(project: Project, frame: int, size: tuple[int, int]) -> Float32:
    # Imported late: the rasteriser's kernels are compiled or loaded on first use, off the window's thread.
    from roam_core.matte import render_matte

    return render_matte(project, frame, size)
