"""The cache of frames: its bound, its order, one decoding a frame, reading ahead, errors, cancelling, closing."""

from __future__ import annotations

import os
import threading
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, FrameCache, MissingFrame
from roam_core.media.cache import DEFAULT_LIMIT, fair_limit
from roam_core.media.source import Image

FRAME_BYTES = 12
PATIENCE = 120.0
"""Seconds after which a test gives up on another thread; none of them waits that long."""


class Plate:
    """A plate of 1 x 4 pixels that counts decodings; a frame in `held` waits until it is let go."""

    path, size, fps, pixel_aspect, colour_space = Path("plate"), (4, 1), 24.0, 1.0, "sRGB"
    frames, missing, readers = tuple(range(100)), (), 1

    def __init__(self) -> None:
        self.decoded: Counter[int] = Counter()
        self.order: list[int] = []
        self.broken: set[int] = set()
        self.damaged: set[int] = set()
        self.large: dict[int, int] = {}
        self.started = {frame: threading.Event() for frame in self.frames}
        self.held: dict[int, threading.Event] = {}

    def hold(self, frame: int) -> threading.Event:
        self.held[frame] = threading.Event()
        return self.held[frame]

    def frame_name(self, frame: int) -> str:
        return f"{frame:04d}"

    def read(self, frame: int) -> Image:
        self.decoded[frame] += 1
        self.order.append(frame)
        if frame not in self.started:
            raise MissingFrame(f"frame {frame} is missing")
        self.started[frame].set()
        if frame in self.held:
            assert self.held[frame].wait(PATIENCE)
        if frame in self.damaged:
            raise DamagedFrame(f"frame {frame} is cut short")
        if frame in self.broken:
            raise RoamError(f"frame {frame} is damaged")
        return np.full((1, self.large.get(frame, 4), 3), frame, np.uint8)


class Changes:
    """Listens to a cache, and waits for what it should come to hold."""

    def __init__(self, cache: FrameCache) -> None:
        self.count = 0
        self._cache = cache
        self._changed = threading.Condition()
        cache.on_change(self._listen)

    def _listen(self) -> None:
        with self._changed:
            self.count += 1
            self._changed.notify_all()

    def wait_for(self, *frames: int) -> None:
        with self._changed:
            assert self._changed.wait_for(lambda: self._cache.cached_frames() >= set(frames), PATIENCE)


@pytest.fixture
def plate() -> Plate:
    return Plate()


@pytest.fixture
def cache(plate: Plate) -> Iterator[FrameCache]:
    """A cache with room for three frames."""
    cache = FrameCache(plate, limit_bytes=3 * FRAME_BYTES + 1)
    yield cache
    for event in plate.held.values():
        event.set()
    cache.close()


def in_thread(function: object, *arguments: object) -> threading.Thread:
    thread = threading.Thread(target=function, args=arguments)  # type: ignore[arg-type]
    thread.start()
    return thread


def test_a_frame_is_decoded_once_and_read_only(plate: Plate, cache: FrameCache) -> None:
    image = cache.read(5)
    assert np.all(image == 5)
    assert cache.read(5) is image
    assert cache.get(5) is image
    assert plate.decoded == {5: 1}
    with pytest.raises(ValueError, match="read-only"):
        image[0] = 0


def test_get_never_decodes(plate: Plate, cache: FrameCache) -> None:
    assert cache.get(1) is None
    assert plate.order == []


def test_what_was_used_longest_ago_goes_first(cache: FrameCache) -> None:
    for frame in (1, 2, 3):
        cache.read(frame)
    cache.read(1)
    cache.read(4)
    assert cache.cached_frames() == {1, 3, 4}
    cache.get(3)
    cache.read(5)
    assert cache.cached_frames() == {3, 4, 5}
    assert cache.used_bytes == 3 * FRAME_BYTES


def test_the_bytes_never_pass_the_limit_but_for_a_frame_that_is_larger_alone(plate: Plate, cache: FrameCache) -> None:
    rng = np.random.default_rng(0)
    plate.large = {frame: int(rng.integers(1, 18)) for frame in plate.frames}
    for frame in rng.integers(0, 100, 400).tolist():
        image = cache.read(frame)
        held = [picture for f in cache.cached_frames() if (picture := cache.get(f)) is not None]
        assert frame in cache.cached_frames()
        assert cache.used_bytes == sum(picture.nbytes for picture in held)
        assert cache.used_bytes <= cache.limit_bytes or (len(held) == 1 and held[0] is image)


def test_listeners_hear_of_every_change_and_of_nothing_else(cache: FrameCache) -> None:
    one, other = Changes(cache), Changes(cache)
    for frame in (1, 2, 1, 3, 3, 4):
        cache.read(frame)
        cache.get(frame)
    assert one.count == other.count == 4


def test_errors_come_through_and_leave_nothing_behind(plate: Plate, cache: FrameCache) -> None:
    plate.broken = {7}
    for _ in range(2):
        with pytest.raises(RoamError, match="frame 7 is damaged"):
            cache.read(7)
    with pytest.raises(MissingFrame):
        cache.read(1000)
    plate.broken = set()
    assert np.all(cache.read(7) == 7)
    assert cache.cached_frames() == {7}


def test_a_frame_under_decoding_is_waited_for_and_not_decoded_twice(plate: Plate, cache: FrameCache) -> None:
    gate = plate.hold(3)
    images: list[Image] = []
    first = in_thread(lambda: images.append(cache.read(3)))
    assert plate.started[3].wait(PATIENCE)
    others = [in_thread(lambda: images.append(cache.read(3))) for _ in range(3)]
    assert cache.get(3) is None
    cache.read(4)
    gate.set()
    for thread in (first, *others):
        thread.join(PATIENCE)
    assert len(images) == 4
    assert all(image is images[0] for image in images)
    assert plate.decoded[3] == 1


def test_who_waits_for_a_decoding_that_fails_gets_the_error_too(plate: Plate, cache: FrameCache) -> None:
    gate = plate.hold(3)
    plate.broken = {3}
    errors: list[str] = []

    def read() -> None:
        try:
            cache.read(3)
        except RoamError as error:
            errors.append(str(error))

    first = in_thread(read)
    assert plate.started[3].wait(PATIENCE)
    second = in_thread(read)
    gate.set()
    first.join(PATIENCE)
    second.join(PATIENCE)
    assert errors == ["frame 3 is damaged"] * 2


def test_a_cancelled_reader_does_not_decode_and_does_not_wait(plate: Plate, cache: FrameCache) -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        cache.read(1, token)
    assert plate.order == []
    plate.hold(2)
    reader = in_thread(cache.read, 2)
    assert plate.started[2].wait(PATIENCE)
    late = CancelToken()
    timer = threading.Timer(0.02, late.cancel)
    timer.start()
    with pytest.raises(Cancelled):
        cache.read(2, late)
    plate.held[2].set()
    reader.join(PATIENCE)
    timer.join(PATIENCE)


def test_frames_are_read_ahead_in_order_by_one_thread(plate: Plate, cache: FrameCache) -> None:
    changes = Changes(cache)
    before = threading.active_count()
    cache.read_ahead([])
    assert threading.active_count() == before
    cache.read_ahead([6, 5, 4])
    cache.read_ahead([6, 5, 4])
    assert threading.active_count() == before + 1
    changes.wait_for(4, 5, 6)
    assert plate.order == [6, 5, 4]
    assert np.all(cache.read(5) == 5)
    assert plate.decoded[5] == 1


def test_a_plate_that_gains_by_it_is_read_ahead_by_several(plate: Plate) -> None:
    plate.readers = 2
    cache = FrameCache(plate, 10 * FRAME_BYTES)
    changes = Changes(cache)
    cache.read(0)
    gates = [plate.hold(frame) for frame in (6, 5)]
    before = threading.active_count()
    cache.read_ahead([6, 5, 4])
    assert threading.active_count() == before + 2
    for frame in (6, 5):
        assert plate.started[frame].wait(PATIENCE)
    assert not plate.started[4].is_set()
    gates[1].set()
    changes.wait_for(5, 4)
    gates[0].set()
    changes.wait_for(6)
    cache.close()
    assert [plate.decoded[frame] for frame in (6, 5, 4)] == [1, 1, 1]


def test_what_is_on_its_way_counts_for_the_bound(plate: Plate) -> None:
    """Two frames fit beside the one that is shown: no third is decoded in vain while two are on their way."""
    plate.readers = 2
    cache = FrameCache(plate, 3 * FRAME_BYTES)
    changes = Changes(cache)
    cache.read(0)
    gates = [plate.hold(frame) for frame in (1, 2)]
    cache.read_ahead([1, 2, 3, 4])
    for frame in (1, 2):
        assert plate.started[frame].wait(PATIENCE)
    for gate in gates:
        gate.set()
    changes.wait_for(0, 1, 2)
    cache.close()
    assert (plate.decoded[3], plate.decoded[4]) == (0, 0)


def test_a_newer_request_drops_the_older(plate: Plate, cache: FrameCache) -> None:
    changes = Changes(cache)
    gate = plate.hold(10)
    cache.read_ahead([10, 11, 12])
    assert plate.started[10].wait(PATIENCE)
    cache.read_ahead([20, 21])
    gate.set()
    changes.wait_for(20, 21)
    assert plate.order == [10, 20, 21]


def test_reading_ahead_keeps_the_frame_on_screen_and_its_own(plate: Plate, cache: FrameCache) -> None:
    changes = Changes(cache)
    cache.read(1)
    cache.read(2)
    cache.read_ahead(range(3, 50))
    changes.wait_for(2, 3, 4)
    cache.read_ahead([30])
    changes.wait_for(30)
    assert plate.order == [1, 2, 3, 4, 30]
    assert cache.cached_frames() == {2, 4, 30}


def test_a_frame_larger_than_its_room_is_not_held_until_it_is_asked_for(plate: Plate, cache: FrameCache) -> None:
    cache.read(1)
    plate.large = {2: 1000}
    gate = plate.hold(2)
    cache.read_ahead([2])
    assert plate.started[2].wait(PATIENCE)
    waiting = in_thread(cache.read, 2)
    gate.set()
    waiting.join(PATIENCE)
    assert cache.cached_frames() == {2}


def test_errors_of_reading_ahead_stay_silent_until_the_frame_is_read(plate: Plate, cache: FrameCache) -> None:
    changes = Changes(cache)
    plate.broken = {1}
    cache.read_ahead([1, 1000, 2])
    changes.wait_for(2)
    assert plate.order == [1, 1000, 2]
    with pytest.raises(RoamError, match="frame 1 is damaged"):
        cache.read(1)
    with pytest.raises(MissingFrame):
        cache.read(1000)


def test_close_ends_the_thread_and_lets_go_of_all(plate: Plate) -> None:
    cache = FrameCache(plate)
    before = threading.active_count()
    changes = Changes(cache)
    cache.read_ahead([1, 2])
    changes.wait_for(1, 2)
    cache.close()
    assert threading.active_count() == before
    assert cache.cached_frames() == frozenset()
    assert cache.used_bytes == 0
    cache.read_ahead([3])
    assert threading.active_count() == before
    assert np.all(cache.read(4) == 4)
    assert cache.cached_frames() == frozenset()
    cache.close()


def test_close_waits_for_the_frame_under_way_and_drops_the_rest(plate: Plate) -> None:
    cache = FrameCache(plate)
    gate = plate.hold(1)
    cache.read_ahead([1, 2, 3])
    assert plate.started[1].wait(PATIENCE)
    closing = in_thread(cache.close)
    gate.set()
    closing.join(PATIENCE)
    assert not closing.is_alive()
    assert set(plate.order) <= {1, 2, 3}
    assert cache.cached_frames() == frozenset()


def test_close_may_leave_a_thread_that_reads_to_itself_and_wait_for_it_later(plate: Plate) -> None:
    cache = FrameCache(plate)
    gate = plate.hold(1)
    cache.read_ahead([1, 2, 3])
    assert plate.started[1].wait(PATIENCE)
    assert not cache.close(0.0)
    gate.set()
    assert cache.close(PATIENCE)
    assert set(plate.order) == {1}
    assert cache.cached_frames() == frozenset()


def test_a_listener_may_ask_and_even_close(plate: Plate) -> None:
    cache = FrameCache(plate)
    seen: list[frozenset[int]] = []
    ended = threading.Event()

    def listen() -> None:
        seen.append(cache.cached_frames())
        cache.close()
        ended.set()

    cache.on_change(listen)
    cache.read_ahead([1, 2])
    assert ended.wait(PATIENCE)
    for thread in threading.enumerate():
        if thread.name == "read-ahead":
            thread.join(PATIENCE)
    assert seen == [frozenset({1})]
    assert plate.order == [1]


def test_many_threads_at_once(plate: Plate, cache: FrameCache) -> None:
    wrong: list[int] = []

    def work(seed: int) -> None:
        rng = np.random.default_rng(seed)
        for frame in rng.integers(0, 12, 150).tolist():
            cache.read_ahead(range(frame + 1, frame + 4))
            if not np.all(cache.read(frame) == frame) or cache.used_bytes > cache.limit_bytes:
                wrong.append(frame)

    threads = [in_thread(work, seed) for seed in range(4)]
    for thread in threads:
        thread.join(PATIENCE)
    assert wrong == []
    assert cache.used_bytes == FRAME_BYTES * len(cache.cached_frames())


def test_the_fair_limit_is_a_quarter_of_what_the_machine_has(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(os, "sysconf", {"SC_PAGE_SIZE": 4096, "SC_PHYS_PAGES": 8 << 18}.__getitem__, raising=False)
    assert fair_limit() == 2 << 30
    monkeypatch.delattr(os, "sysconf")
    assert fair_limit() == DEFAULT_LIMIT


def test_damaged_frames_are_known_and_told_until_they_can_be_read(plate: Plate, cache: FrameCache) -> None:
    changes = Changes(cache)
    plate.damaged = {3}
    for _ in range(2):
        with pytest.raises(DamagedFrame):
            cache.read(3)
    with pytest.raises(MissingFrame):
        cache.read(100)
    assert (cache.damaged_frames(), changes.count) == ({3}, 1)
    plate.damaged = set()
    cache.read(3)
    assert cache.damaged_frames() == frozenset()
