"""Playback by the clock: frames are dropped, never late; loops, turns, stops at the end."""

from __future__ import annotations

from collections.abc import Iterator

import pytest
from pytestqt.qtbot import QtBot

from app.features.playback import Playback, Repeat
from app.model.view_state import ViewState
from tests.gui.waiting import WAIT


class Clock:
    def __init__(self) -> None:
        self.now = 0.0

    def __call__(self) -> float:
        return self.now


@pytest.fixture
def clock() -> Clock:
    return Clock()


@pytest.fixture
def playback(qtbot: QtBot, view_state: ViewState, clock: Clock) -> Iterator[Playback]:
    view_state.set_play_range(1001, 1011)
    view_state.set_frame(1001)
    playback = Playback(view_state, clock=clock)
    playback.fps = 10.0
    yield playback
    playback.pause()


def frames_at(playback: Playback, clock: Clock, view_state: ViewState, times: list[float]) -> list[int]:
    shown = []
    for time in times:
        clock.now = time
        playback.tick()
        shown.append(view_state.frame)
    return shown


def test_it_plays_at_the_clips_speed_and_drops_what_is_late(
    playback: Playback, clock: Clock, view_state: ViewState
) -> None:
    playback.play()
    assert frames_at(playback, clock, view_state, [0.0, 0.11, 0.12, 0.75]) == [1001, 1002, 1002, 1008]


def test_it_loops_both_ways(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    playback.play()
    assert frames_at(playback, clock, view_state, [0.95, 1.05]) == [1010, 1001]
    playback.play_back()
    assert frames_at(playback, clock, view_state, [1.2]) == [1010]


def test_without_loop_it_stops_on_the_last_frame(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    playback.set_repeat(Repeat.ONCE)
    playback.play()
    assert frames_at(playback, clock, view_state, [5.0]) == [1010]
    assert playback.speed == 0


def test_again_means_faster_and_the_other_way_begins_at_one(playback: Playback) -> None:
    speeds = []
    for press in (playback.play, playback.play, playback.play, playback.play, playback.play, playback.play_back):
        press()
        speeds.append(playback.speed)
    assert speeds == [1, 2, 4, 8, 8, -1]


def test_scrubbing_while_it_plays_goes_on_from_there(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    playback.play()
    frames_at(playback, clock, view_state, [0.2])
    view_state.set_frame(1007)
    assert frames_at(playback, clock, view_state, [0.3, 0.41]) == [1007, 1008]


def test_space_toggles(qtbot: QtBot, playback: Playback) -> None:
    with qtbot.waitSignal(playback.playing_changed, timeout=WAIT):
        playback.toggle()
    assert playback.speed == 1
    playback.toggle()
    assert playback.speed == 0


def test_ping_pong_turns_at_both_ends_of_the_range(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    view_state.set_play_range(1001, 1005)
    playback.set_repeat(Repeat.PING_PONG)
    playback.play()
    times = [0.05 + 0.1 * step for step in range(9)]
    assert frames_at(playback, clock, view_state, times) == [1001, 1002, 1003, 1004, 1003, 1002, 1001, 1002, 1003]
    view_state.set_play_range(1003, 1004)
    assert frames_at(playback, clock, view_state, [2.0, 2.2]) == [1003, 1003]


def test_the_end_of_the_range_is_chosen_while_it_plays(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    playback.play()
    frames_at(playback, clock, view_state, [0.85])
    playback.set_repeat(Repeat.PING_PONG)
    assert frames_at(playback, clock, view_state, [0.96, 1.06]) == [1010, 1009]


def test_what_played_once_to_its_end_begins_again(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    playback.set_repeat(Repeat.ONCE)
    view_state.set_frame(1010)
    playback.play()
    assert frames_at(playback, clock, view_state, [0.11]) == [1002]
    playback.pause()
    view_state.set_frame(1001)
    playback.play_back()
    assert view_state.frame == 1010


@pytest.mark.parametrize("frame", [990, 1002, 1006, 1030])
def test_what_is_played_once_from_beyond_in_and_out_begins_at_the_right_end(
    playback: Playback, clock: Clock, view_state: ViewState, frame: int
) -> None:
    view_state.set_play_range(1003, 1006)
    playback.set_repeat(Repeat.ONCE)
    view_state.set_frame(frame)
    playback.play()
    assert view_state.frame == 1003
    assert frames_at(playback, clock, view_state, [0.11]) == [1004]
    playback.pause()
    view_state.set_frame(frame)
    playback.play_back()
    assert view_state.frame == 1005


def test_slower_and_slower(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    speeds = []
    for press in (playback.play_slowly, playback.play_slowly, playback.play_slowly, playback.play_slowly):
        press()
        speeds.append(playback.speed)
    playback.play_back_slowly()
    assert [*speeds, playback.speed] == [0.5, 0.25, 0.125, 0.125, -0.5]
    clock.now = 0.21
    playback.tick()
    assert view_state.frame == 1010


def test_pictures_that_come_to_the_screen_are_counted(qtbot: QtBot, playback: Playback, clock: Clock) -> None:
    playback.note_picture(1001)
    assert playback.rate is None
    playback.play()
    with qtbot.waitSignal(playback.rate_changed, timeout=WAIT):
        for number in range(20):
            clock.now += 0.2
            playback.note_picture(1002 + number)
    assert playback.rate == pytest.approx(5.0)
    playback.pause()
    assert playback.rate is None


def test_what_is_taken_into_the_hand_stops_it_on_that_frame(
    playback: Playback, clock: Clock, view_state: ViewState
) -> None:
    is_busy = False
    view_state.ask_hand(lambda: is_busy)
    playback.play()
    assert frames_at(playback, clock, view_state, [0.25]) == [1003]
    is_busy = True
    assert frames_at(playback, clock, view_state, [0.55]) == [1003]
    assert not view_state.is_playing


def test_what_was_half_done_before_does_not_stop_it(playback: Playback, clock: Clock, view_state: ViewState) -> None:
    is_busy = True
    view_state.ask_hand(lambda: is_busy)
    playback.play()
    assert frames_at(playback, clock, view_state, [0.25, 0.35]) == [1003, 1004]
