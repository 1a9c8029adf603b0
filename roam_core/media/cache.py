"""FrameCache: the decoded frames of a plate in memory, bounded in bytes, filled ahead by threads."""

from __future__ import annotations

import os
import threading
import time
from collections import OrderedDict, deque
from collections.abc import Callable, Sequence
from typing import Generic, Protocol, TypeVar

import numpy as np

from roam_core.cancel import CancelToken
from roam_core.media.source import DamagedFrame

DEFAULT_LIMIT = 1 << 30
"""Bytes: some 40 frames of 4K in 8 bits."""
SHARE_OF_MEMORY = 0.25
POLL_SECONDS = 0.05
"""How often a reader that waits for another thread's decoding looks at its token."""


def fair_limit() -> int:
    """The bytes of a quarter of this machine's memory; `DEFAULT_LIMIT` where it does not tell."""
    try:
        return round(SHARE_OF_MEMORY * os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES"))
    except (AttributeError, OSError, ValueError):  # Windows has no sysconf
        return DEFAULT_LIMIT


class Sized(Protocol):
    """A picture, or parts of one, of so many bytes."""

    @property
    def nbytes(self) -> int: ...


Held = TypeVar("Held", bound=Sized)
HeldNow = TypeVar("HeldNow", bound=Sized, covariant=True)


class Frames(Protocol[HeldNow]):
    """What a cache needs of a plate; see `PlateSource`."""

    @property
    def readers(self) -> int: ...

    def read(self, frame: int) -> HeldNow: ...


class FrameCache(Generic[Held]):
    """Decoded frames of one plate. Safe from any thread; the pictures are read-only and shared.

    What was used longest ago goes first. The bytes held stay within the limit, except where the frame just asked for is
    larger than all of it: then it is held alone. A frame is decoded by one thread at a time; others wait for it.

    Parameters
    ----------
    source : the plate.
    limit_bytes : the most that is held.
    """

    def __init__(self, source: Frames[Held], limit_bytes: int = DEFAULT_LIMIT) -> None:
        self.source = source
        self.limit_bytes = limit_bytes
        self._listeners: tuple[Callable[[], None], ...] = ()
        self._lock = threading.Lock()
        self._wake = threading.Condition(self._lock)
        self._images: OrderedDict[int, Held] = OrderedDict()  # longest unused first
        self._frame_bytes = 0  # of the frame held last: what the next one will need
        self._decoding: dict[int, _Decoding[Held]] = {}
        self._damaged: set[int] = set()
        self._shown: int | None = None  # the frame read last: reading ahead does not push it out
        self._ahead: deque[int] = deque()
        self._wanted_ahead: frozenset[int] = frozenset()
        self._readers: list[threading.Thread] = []
        self._closed = False

    def on_change(self, listener: Callable[[], None]) -> None:
        """Have `listener()` called after the set of cached frames, or of damaged ones, changed.

        It runs on the thread that changed it (a reader's, or the one that reads ahead) with no lock held; it must not
        block. `close` does not call it.
        """
        with self._lock:
            self._listeners = (*self._listeners, listener)

    @property
    def used_bytes(self) -> int:
        """The bytes of all frames held now."""
        with self._lock:
            return self._held_bytes()

    def read(self, frame: int, token: CancelToken | None = None) -> Held:
        """The picture `(h, w, 3)` of a frame, decoded now where it is not held. Read-only.

        Raises
        ------
        RoamError
            what the source raises: a missing frame, a damaged file.
        Cancelled
            when `token` was cancelled before the picture was there.
        """
        while True:
            if token:
                token.check()
            with self._lock:
                self._shown = frame
                held = self._images.get(frame)
                if held is not None:
                    self._images.move_to_end(frame)
                    grown = [old for old in self._leaving_for(0, frozenset()) or () if old != frame]
                    for old in grown:  # parts have grown since they were held
                        del self._images[old]
                else:
                    decoding, is_ours = self._claim(frame)
            if held is not None:
                if grown:
                    self._tell()
                return held
            if is_ours:
                changed = self._decode(frame, decoding, frozenset())
            else:
                decoding.wait(token)
                # What was read ahead is not held where there was no room; now that it is asked for, it is.
                changed = decoding.image is not None and self._hold(frame, decoding.image, frozenset())
            if changed:
                self._tell()
            if decoding.image is not None:
                return decoding.image
            # The other thread failed: this one tries for itself, so that the error is raised here too.

    def get(self, frame: int) -> Held | None:
        """The picture of a frame where it is held, else None; never waits for decoding."""
        with self._lock:
            if frame in self._images:
                self._images.move_to_end(frame)
            return self._images.get(frame)

    def cached_frames(self) -> frozenset[int]:
        """The frames that are held."""
        with self._lock:
            return frozenset(self._images)

    def damaged_frames(self) -> frozenset[int]:
        """The frames that were there and could not be used when they were last decoded, in vain."""
        with self._lock:
            return frozenset(self._damaged)

    def read_ahead(self, frames: Sequence[int]) -> None:
        """Decode these frames in the background, in this order, in place of what an earlier call asked for.

        Ends early where the limit would push out one of these frames or the one read last. Errors stay silent: `read`
        of such a frame raises them.
        """
        with self._lock:
            if self._closed:
                return
            self._ahead = deque(frames)
            self._wanted_ahead = frozenset(frames)
            if not self._readers and self._ahead:
                self._readers = [
                    threading.Thread(target=self._run_ahead, name="read-ahead", daemon=True)
                    for _ in range(self.source.readers)
                ]
                for reader in self._readers:
                    reader.start()
            self._wake.notify_all()

    def close(self, wait: float | None = None) -> bool:
        """Stop reading ahead, wait for its threads, and let go of all frames. Later reads decode and hold nothing.

        False where a thread still reads after `wait` seconds (None: as long as it takes), as from a disk that does not
        answer: it ends with that frame, and may be waited for by another call.
        """
        with self._lock:
            self._closed = True
            self._ahead.clear()
            self._images.clear()
            readers = [reader for reader in self._readers if reader is not threading.current_thread()]
            self._wake.notify_all()
        until = None if wait is None else time.monotonic() + wait
        for reader in readers:
            reader.join(None if until is None else max(0.0, until - time.monotonic()))
        return not any(reader.is_alive() for reader in readers)

    # ---- decoding ----------------------------------------------------------------------------------------------------

    def _claim(self, frame: int) -> tuple[_Decoding[Held], bool]:
        """The decoding of a frame, and whether it is the caller's to do. The lock is held."""
        running = self._decoding.get(frame)
        if running:
            return running, False
        self._decoding[frame] = _Decoding()
        return self._decoding[frame], True

    def _decode(self, frame: int, decoding: _Decoding[Held], kept: frozenset[int]) -> bool:
        """Decode a claimed frame, and hold it where none of `kept` has to go for it; whether it is held now."""
        is_damaged = False
        try:
            image = self.source.read(frame)
            if isinstance(image, np.ndarray):
                image.setflags(write=False)
            decoding.image = image
            # Held before the claim ends: at no moment is the frame neither held nor on its way.
            return self._hold(frame, image, kept)
        except DamagedFrame:
            is_damaged = True
            raise
        finally:
            with self._lock:
                del self._decoding[frame]
                is_news = is_damaged != (frame in self._damaged)
                self._damaged ^= {frame} if is_news else set()
            decoding.done.set()
            if is_news:
                self._tell()

    def _hold(self, frame: int, image: Held, kept: frozenset[int]) -> bool:
        """Hold a picture in place of those longest unused; False where it is held already, or has no room."""
        with self._lock:
            leaving = self._leaving_for(image.nbytes, kept)
            if self._closed or leaving is None or frame in self._images:
                return False
            for old in leaving:
                del self._images[old]
            self._images[frame] = image
            self._frame_bytes = image.nbytes
            return True

    def _leaving_for(self, nbytes: int, kept: frozenset[int]) -> list[int] | None:
        """The frames, longest unused first, that have to go before `nbytes` fit; None where `kept` ones had to.

        With nothing to keep there is always room: a frame above the limit is then held alone. The lock is held.
        """
        surplus = self._held_bytes() + nbytes - self.limit_bytes
        leaving = []
        for frame, image in self._images.items():
            if surplus <= 0:
                break
            if frame not in kept:
                leaving.append(frame)
                surplus -= image.nbytes
        return None if surplus > 0 and kept else leaving

    def _held_bytes(self) -> int:
        """The bytes of all that is held: added up, for parts grow while they are held. The lock is held."""
        return sum(image.nbytes for image in self._images.values())

    def _tell(self) -> None:
        for listener in self._listeners:
            listener()

    # ---- reading ahead: its threads ----------------------------------------------------------------------------------

    def _run_ahead(self) -> None:
        while claimed := self._next_ahead():
            try:
                changed = self._decode(*claimed)
            except Exception:
                # A frame that nobody asked for yet must not disturb; whoever reads it gets the error.
                continue
            if changed:
                self._tell()

    def _next_ahead(self) -> tuple[int, _Decoding[Held], frozenset[int]] | None:
        """Wait for a frame to read ahead and claim it, with the frames to keep for it; None when the cache closes."""
        with self._lock:
            while not self._closed:
                if not self._ahead:
                    self._wake.wait()
                    continue
                frame = self._ahead.popleft()
                if frame in self._images or frame in self._decoding:
                    continue
                kept = self._wanted_ahead | ({self._shown} if self._shown is not None else frozenset())
                on_their_way = len(self._decoding) + 1
                if self._leaving_for(on_their_way * self._frame_bytes, kept) is None:
                    self._ahead.clear()
                    continue
                decoding, _ = self._claim(frame)
                return frame, decoding, kept
            return None


class _Decoding(Generic[Held]):
    """One frame on its way: `image` stays None where the source failed."""

    def __init__(self) -> None:
        self.done = threading.Event()
        self.image: Held | None = None

    def wait(self, token: CancelToken | None) -> None:
        """Wait for the end, or raise `Cancelled`."""
        while not self.done.wait(POLL_SECONDS if token else None):
            if token:
                token.check()
