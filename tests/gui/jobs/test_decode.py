"""The plate reader: pictures come from another thread, the last wish counts, a missing frame is told."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs.decode import PlateReader
from roam_core.media import DamagedFrame, MissingFrame

WAIT = 5000


class Plate:
    """A source of three grey frames; `gate` holds decoding back."""

    path, frames, missing, size = Path("plate"), (1, 2, 3, 4, 6), (5,), (4, 2)
    fps, pixel_aspect, readers = 24.0, 1.0, 1

    def __init__(self, colour_space: str = "sRGB") -> None:
        self.colour_space = colour_space
        self.gate = threading.Event()
        self.gate.set()
        self.threads: set[threading.Thread] = set()
        self.damaged: set[int] = set()

    def read(self, frame: int) -> np.ndarray:
        self.gate.wait(5)
        self.threads.add(threading.current_thread())
        if frame not in self.frames:
            raise MissingFrame(f"Frame {frame} is missing.")
        if frame in self.damaged:
            raise DamagedFrame(f"Frame {frame} is damaged.")
        return np.full((2, 4, 3), frame, dtype=np.uint8)

    def frame_name(self, frame: int) -> str:
        return str(frame)


@pytest.fixture
def reader(qtbot: QtBot) -> Iterator[PlateReader]:
    reader = PlateReader()
    yield reader
    reader.close()


def test_a_picture_is_decoded_on_another_thread(qtbot: QtBot, reader: PlateReader) -> None:
    plate = Plate()
    reader.open(plate)
    with qtbot.waitSignal(reader.picture, timeout=WAIT) as picture:
        reader.show(2)
    assert picture.args[0] == 2
    assert (picture.args[1] == 2).all()
    assert threading.main_thread() not in plate.threads


def test_of_many_wishes_only_the_last_is_decoded(qtbot: QtBot, reader: PlateReader) -> None:
    plate, shown = Plate(), []
    reader.open(plate)
    reader.picture.connect(lambda frame, _: shown.append(frame))
    plate.gate.clear()
    for frame in (1, 2, 3, 4):
        reader.show(frame)
    plate.gate.set()
    qtbot.waitUntil(lambda: shown == [1, 4], timeout=WAIT)


def test_a_missing_frame_is_told_and_shows_nothing(qtbot: QtBot, reader: PlateReader) -> None:
    news: list[object] = []
    reader.picture.connect(lambda frame, picture: news.append((frame, picture)))
    reader.refused.connect(news.append)
    reader.open(Plate())
    reader.show(5)
    qtbot.waitUntil(lambda: news == [(5, None), "Frame 5 is missing."], timeout=WAIT)


def test_a_damaged_frame_is_known_among_the_missing_until_it_can_be_read(qtbot: QtBot, reader: PlateReader) -> None:
    plate, news = Plate(), []
    reader.cache_changed.connect(lambda: news.append(reader.frames_without_picture()))
    reader.open(plate)
    assert reader.frames_without_picture() == (5,)
    plate.damaged = {2}
    reader.show(2)
    qtbot.waitUntil(lambda: (2, 5) in news, timeout=WAIT)
    plate.damaged = set()
    reader.show(1)
    reader.show(2)
    qtbot.waitUntil(lambda: news[-1] == (5,), timeout=WAIT)
    reader.open(None)
    assert reader.frames_without_picture() == ()


def test_frames_ahead_of_the_playhead_are_decoded_too(qtbot: QtBot, reader: PlateReader) -> None:
    reader.open(Plate())
    with qtbot.waitSignal(reader.cache_changed, timeout=WAIT):
        reader.show(1)
    qtbot.waitUntil(lambda: len(reader.cached_frames()) == 5, timeout=WAIT)
    used, limit = reader.memory()
    assert used == 5 * 24
    assert limit > used


def test_the_engine_sees_its_own_colours(qtbot: QtBot, reader: PlateReader) -> None:
    reader.open(Plate())
    assert reader.engine_frame(3).dtype == np.uint8
    reader.open(Plate("linear"))
    assert reader.engine_frame(3).dtype == np.float32


def test_converted_pictures_are_kept(qtbot: QtBot, reader: PlateReader) -> None:
    reader.open(Plate("linear"))
    pictures = []
    for frame in (1, 2, 1):
        with qtbot.waitSignal(reader.picture, timeout=WAIT) as picture:
            reader.show(frame)
        pictures.append(picture.args[1])
        qtbot.waitUntil(lambda: reader._runner.is_idle, timeout=WAIT)
    assert pictures[0] is pictures[2]


def test_what_is_at_hand_is_told_at_once(qtbot: QtBot, reader: PlateReader) -> None:
    shown: list[int] = []
    reader.open(Plate())
    reader.picture.connect(lambda frame, _: shown.append(frame))
    reader.show(1)
    qtbot.waitUntil(lambda: len(reader.cached_frames()) == 5 and reader._runner.is_idle, timeout=WAIT)
    shown.clear()
    for frame in (2, 3, 2):
        reader.show(frame)
    assert shown == [2, 3, 2]


def test_what_is_at_hand_waits_for_what_is_being_decoded(qtbot: QtBot, reader: PlateReader) -> None:
    shown: list[int] = []
    plate = Plate()
    reader.open(plate)
    reader.show(4)  # what is read ahead lies behind it
    qtbot.waitUntil(lambda: 4 in reader.cached_frames() and reader._runner.is_idle, timeout=WAIT)
    reader.picture.connect(lambda frame, _: shown.append(frame))
    plate.gate.clear()
    reader.show(1)
    reader.show(4)
    assert shown == []
    plate.gate.set()
    qtbot.waitUntil(lambda: shown == [1, 4], timeout=WAIT)


def test_the_plates_own_values_are_given_where_they_are_held(qtbot: QtBot, reader: PlateReader) -> None:
    assert reader.plate(1) is None
    reader.open(Plate("linear"))
    with qtbot.waitSignal(reader.picture, timeout=WAIT):
        reader.show(3)
    held = reader.plate(3)
    assert held is not None
    assert (held.values.dtype, held.colour_space) == (np.uint8, "linear")


def test_another_plate_lets_the_old_one_go(qtbot: QtBot, reader: PlateReader) -> None:
    reader.open(Plate())
    with qtbot.waitSignal(reader.plate_changed, timeout=WAIT):
        reader.open(None)
    assert reader.source is None
    assert reader.cached_frames() == frozenset()
    reader.show(2)  # no plate, no picture, no error
