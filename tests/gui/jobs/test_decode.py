"""The plate reader: pictures come from another thread, the last wish counts, a missing frame is told."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.jobs import decode
from app.jobs.decode import PlateReader
from app.jobs.runner import Ending, Runner
from app.model.viewing import Viewing
from roam_core.errors import RoamError
from roam_core.media import DamagedFrame, MissingFrame
from tests.gui.waiting import WAIT


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
        assert self.gate.wait(WAIT / 1000)
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


def test_converted_pictures_beyond_their_bound_are_let_go_the_oldest_first(
    qtbot: QtBot, reader: PlateReader, monkeypatch: pytest.MonkeyPatch
) -> None:
    reader.open(Plate("linear"))
    sizes = []
    for frame in (1, 2, 3, 4):
        with qtbot.waitSignal(reader.picture, timeout=WAIT) as picture:
            reader.show(frame)
        sizes.append(picture.args[1].nbytes)
        qtbot.waitUntil(lambda: reader._runner.is_idle, timeout=WAIT)
        monkeypatch.setattr(decode, "DISPLAY_BYTES", 2 * sizes[0])
    assert list(reader._ready) == [3, 4]


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


def test_what_reads_a_plate_goes_on_with_it_when_another_one_is_open(reader: PlateReader) -> None:
    reader.open(Plate())
    read = reader.frames_of_this_plate()
    reader.open(Large())
    assert read(2).shape == (2, 4, 3)
    reader.open(None)
    assert read(2).shape == (2, 4, 3)
    with pytest.raises(RoamError, match="no plate"):
        reader.frames_of_this_plate()(2)


class Large(Plate):
    """Frames of 8 x 4 half floats, each pixel of another brightness."""

    size = (8, 4)

    def read(self, frame: int) -> np.ndarray:
        return (np.arange(96, dtype=np.float32).reshape(4, 8, 3) / 96.0 * frame).astype(np.float16)


def looked_through(reader: PlateReader) -> Viewing:
    """How another viewer looks at the plate."""
    viewing = Viewing(reader)
    reader.look_through(viewing)
    return viewing


def shown(qtbot: QtBot, reader: PlateReader, frame: int) -> np.ndarray:
    """The picture that the window is given of a frame."""
    with qtbot.waitSignal(reader.picture, timeout=WAIT) as picture:
        reader.show(frame)
    qtbot.waitUntil(lambda: reader._runner.is_idle, timeout=WAIT)
    return picture.args[1]


def test_a_proxy_is_the_mean_of_what_it_covers_and_the_engine_sees_none_of_it(
    qtbot: QtBot, reader: PlateReader
) -> None:
    viewing = looked_through(reader)
    reader.open(Large("linear"))
    full, seen_by_engine = shown(qtbot, reader, 1), reader.engine_frame(1)
    with qtbot.waitSignal(reader.picture, timeout=WAIT) as again:
        viewing.set_proxy(2)
    assert again.args[0] == 1
    assert again.args[1].shape == (2, 4, 3)
    means = full.reshape(2, 2, 4, 2, 3).mean(axis=(1, 3))
    np.testing.assert_allclose(again.args[1], means, atol=0.51)
    np.testing.assert_array_equal(reader.engine_frame(1), seen_by_engine)
    assert reader.plate(1).values.shape == (4, 8, 3)
    np.testing.assert_array_equal(reader.full_picture(1, again.args[1]), full)
    assert reader.full_picture(99, again.args[1]) is None
    with qtbot.waitSignal(reader.picture, timeout=WAIT) as whole:
        viewing.set_proxy(1)
    np.testing.assert_array_equal(whole.args[1], full)


def test_proxies_of_plates_that_are_shown_as_they_are(qtbot: QtBot, reader: PlateReader) -> None:
    reader.open(Plate())
    looked_through(reader).set_proxy(4)
    assert shown(qtbot, reader, 3).shape == (1, 1, 3)
    assert shown(qtbot, reader, 3).tolist() == [[[3, 3, 3]]]  # from what is kept ready


def test_what_a_look_is_made_of_comes_with_the_picture(qtbot: QtBot, reader: PlateReader) -> None:
    viewing, second = looked_through(reader), looked_through(reader)
    reader.open(Large("linear"))
    shown(qtbot, reader, 2)
    assert reader.plate(2).scalable is None
    second.set_proxy(4)
    second.set_look(gamma=1.2)
    assert reader._runner.is_idle
    with qtbot.waitSignal(reader.picture, timeout=WAIT):
        second.set_look(exposure=-1.0)
    assert reader.plate(2).scalable.dtype == np.float32
    assert reader.plate(2).scalable.shape == (4, 8, 3)
    with qtbot.waitSignal(reader.picture, timeout=WAIT):
        viewing.set_proxy(2)
    assert reader.plate(2).scalable.shape == (2, 4, 3)


def test_what_a_look_is_made_of_is_not_let_go_as_soon_as_it_is_made(
    qtbot: QtBot, reader: PlateReader, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With it a picture takes more room: what was converted before it makes way, not the picture itself."""
    viewing = looked_through(reader)
    reader.open(Large("linear"))
    monkeypatch.setattr(decode, "DISPLAY_BYTES", 500)
    for frame in (1, 2, 1):
        shown(qtbot, reader, frame)
    pictures: list[int] = []
    reader.picture.connect(lambda frame, _: pictures.append(frame))
    with qtbot.waitSignal(reader.picture, timeout=WAIT):
        viewing.set_look(exposure=-1.0)
    qtbot.waitUntil(lambda: reader._runner.is_idle, timeout=WAIT)
    assert pictures == [1]
    assert reader.plate(1).scalable is not None
    assert list(reader._ready) == [1]


def test_another_size_that_is_asked_for_meanwhile_is_shown_in_the_end(qtbot: QtBot, reader: PlateReader) -> None:
    plate, viewing = Plate("linear"), looked_through(reader)
    reader.open(plate)
    plate.gate.clear()
    pictures: list[tuple[int, ...]] = []
    reader.picture.connect(lambda _, picture: pictures.append(picture.shape))
    reader.show(1)
    viewing.set_proxy(2)
    plate.gate.set()
    qtbot.waitUntil(lambda: pictures[-1:] == [(1, 2, 3)], timeout=WAIT)


# ---- plates on disks that do not answer ------------------------------------------------------------------------------


def held_up(qtbot: QtBot, reader: PlateReader) -> Plate:
    """A plate of which one frame is shown; others are being read, ahead and for the screen, until its gate opens."""
    plate = Plate()
    reader.open(plate)
    plate.gate.clear()
    reader._decode(1)
    qtbot.waitUntil(lambda: reader._runner.running("decode") is not None, timeout=WAIT)
    reader._cache.read_ahead([2, 3])
    qtbot.waitUntil(lambda: len(reader._cache._decoding) >= 2, timeout=WAIT)
    return plate


def test_another_plate_is_shown_while_a_frame_of_the_one_before_does_not_come(
    qtbot: QtBot, reader: PlateReader
) -> None:
    shown: list[tuple[int, object]] = []
    slow = held_up(qtbot, reader)
    reader.picture.connect(lambda frame, picture: shown.append((frame, picture.shape)))
    reader.open(Large())  # waits for none of the other's threads
    with qtbot.waitSignal(reader.picture, timeout=WAIT):
        reader.show(2)
    slow.gate.set()
    qtbot.waitUntil(lambda: all(each.close(0.0) for each in reader._reading), timeout=WAIT)
    qtbot.wait(1)
    assert shown == [(2, (4, 8, 3))]  # nothing late of the plate before
    before = tuple(reader._reading)
    assert before
    reader.open(None)
    assert not any(each in before for each in reader._reading)

    def workers() -> list[Runner]:
        return [each for each in reader.children() if isinstance(each, Runner)]

    qtbot.waitUntil(lambda: workers() == [reader._runner], timeout=WAIT)  # one a clip would stay for good


def test_a_picture_that_takes_long_is_told_until_it_is_there(qtbot: QtBot, reader: PlateReader) -> None:
    told: list[object] = []
    reader.progress.connect(lambda _, text: told.append(text))
    reader.finished.connect(lambda ending, _: told.append(ending))
    plate = Plate()
    reader.open(plate)
    plate.gate.clear()
    reader._patience.setInterval(0)
    reader.show(2)
    qtbot.waitUntil(lambda: len(told) == 1, timeout=WAIT)
    reader.show(3)
    plate.gate.set()
    qtbot.waitUntil(lambda: Ending.DONE in told, timeout=WAIT)
    assert "frame 2" in str(told[0])
    assert "frame 3" in str(told[1])
    assert told[-1] is Ending.DONE
    assert told.count(Ending.DONE) == 1


def test_a_picture_that_does_not_come_is_given_up_and_asked_for_again(qtbot: QtBot, reader: PlateReader) -> None:
    ends: list[tuple[Ending, str]] = []
    reader.finished.connect(lambda ending, sentence: ends.append((ending, sentence)))
    plate = Plate()
    reader.open(plate)
    plate.gate.clear()
    reader.stop()  # nothing is told yet: nothing is stopped
    reader._patience.setInterval(0)
    with qtbot.waitSignal(reader.progress, timeout=WAIT):
        reader.show(2)
    reader.stop()
    assert [ending for ending, _ in ends] == [Ending.CANCELLED]
    assert "Frame 2" in ends[0][1]
    plate.gate.set()
    with qtbot.waitSignal(reader.picture, timeout=WAIT) as picture:
        reader.show(2)
    assert picture.args[0] == 2
