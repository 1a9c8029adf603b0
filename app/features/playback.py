"""Playing the clip at its own speed: frames are left out rather than played late."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from enum import StrEnum

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from ..model.view_state import ViewState

FASTEST, SLOWEST = 8.0, 0.125
MEASURED = 1.0
"""Seconds over which the pictures shown are counted."""
TOLD_EVERY = 0.25


class Repeat(StrEnum):
    """What happens at the end of the play range."""

    ONCE = "once"
    LOOP = "loop"
    PING_PONG = "ping-pong"


class Playback(QObject):
    """Moves the playhead through the play range at `fps`, times `speed` (negative: backward).

    The frame follows from the clock, not from the number of ticks: a slow picture costs frames, never time. `clock`
    gives seconds. It stops where the artist takes something into the hand; what was half done before goes on.

    Signals
    -------
    playing_changed() : it began, stopped, turned, or changed its speed.
    repeat_changed() : something else happens at the end of the range.
    rate_changed() : another number of pictures is shown a second; some times a second while it plays.
    """

    playing_changed = Signal()
    repeat_changed = Signal()
    rate_changed = Signal()

    def __init__(
        self, view_state: ViewState, parent: QObject | None = None, clock: Callable[[], float] = time.perf_counter
    ) -> None:
        super().__init__(parent)
        self._view, self._clock = view_state, clock
        self.fps = 24.0
        self._repeat = Repeat.LOOP
        self._speed = 0.0
        self._start_time, self._start_frame, self._last_shown = 0.0, 0, 0
        self._shown_at: deque[float] = deque()
        self._pictured, self._told = 0, 0.0
        self._was_in_use = False
        self._timer = QTimer(self, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "time.toggle_play": self.toggle,
            "time.play_back": self.play_back,
            "time.pause": self.pause,
            "time.play": self.play,
            "time.play_slowly": self.play_slowly,
            "time.play_back_slowly": self.play_back_slowly,
        }

    # ---- speed

    @property
    def speed(self) -> float:
        """1 is the clip's own speed, negative is backward, 0 stands still."""
        return self._speed

    def play(self) -> None:
        """Play forward; when it does already, twice as fast."""
        self._set_speed(min(self._speed * 2, FASTEST) if self._speed > 0 else 1.0)

    def play_back(self) -> None:
        """Play backward; when it does already, twice as fast."""
        self._set_speed(max(self._speed * 2, -FASTEST) if self._speed < 0 else -1.0)

    def play_slowly(self) -> None:
        """Play forward at half speed; when it plays forward already, half as fast."""
        self._set_speed(max(self._speed / 2, SLOWEST) if self._speed > 0 else 0.5)

    def play_back_slowly(self) -> None:
        """Play backward at half speed; when it plays backward already, half as fast."""
        self._set_speed(min(self._speed / 2, -SLOWEST) if self._speed < 0 else -0.5)

    def pause(self) -> None:
        self._set_speed(0.0)

    def toggle(self) -> None:
        """Play forward, or stand still."""
        self._set_speed(0.0 if self._speed else 1.0)

    # ---- the ends of the range

    @property
    def repeat(self) -> Repeat:
        return self._repeat

    def set_repeat(self, repeat: Repeat) -> None:
        """Choose what happens at the end of the play range, also while it plays."""
        if repeat is not self._repeat:
            self._repeat = repeat
            self._begin_here()
            self.repeat_changed.emit()

    # ---- frames

    def tick(self) -> None:
        """Show the frame that is due now; scrubbing in between starts anew from where it led.

        What the artist takes into the hand stands still: the frame on which it was grabbed stays.
        """
        was_in_use, self._was_in_use = self._was_in_use, self._view.is_in_use
        if self._was_in_use and not was_in_use:
            self.pause()
            return
        if self._view.frame != self._last_shown:
            self._begin_here()
        steps = int((self._clock() - self._start_time) * self.fps * abs(self._speed))
        self._show(self._start_frame + (steps if self._speed > 0 else -steps))

    def note_picture(self, frame: int) -> None:
        """Count a picture that has come to the screen."""
        if not self._speed or frame == self._pictured:
            return
        now, self._pictured = self._clock(), frame
        self._shown_at.append(now)
        while now - self._shown_at[0] > MEASURED:
            self._shown_at.popleft()
        if now - self._told >= TOLD_EVERY:
            self._told = now
            self.rate_changed.emit()

    @property
    def rate(self) -> float | None:
        """Pictures shown a second, over the last second; None while it stands still or has just begun."""
        if not self._speed or len(self._shown_at) < 3:
            return None
        passed = self._shown_at[-1] - self._shown_at[0]
        return (len(self._shown_at) - 1) / passed if passed > 0 else None

    # ---- the rest is private

    def _show(self, frame: int) -> None:
        first, stop = self._view.play_range
        if self._repeat is Repeat.PING_PONG:
            frame = _there_and_back(frame, first, stop)
        elif not first <= frame < stop:
            if self._repeat is Repeat.ONCE:
                self._last_shown = min(max(frame, first), stop - 1)
                self._view.set_frame(self._last_shown)
                self.pause()
                return
            frame = first + (frame - first) % (stop - first)
        self._last_shown = frame
        self._view.set_frame(frame)

    def _set_speed(self, speed: float) -> None:
        if speed == self._speed:
            return
        if not self._speed:
            self._rewind(forward=speed > 0)
            self._was_in_use = self._view.is_in_use
        self._speed, self._view.is_playing = speed, bool(speed)
        self._begin_here()
        if speed:
            self._timer.start(max(int(1000 / (self.fps * abs(speed)) / 2), 4))
        else:
            self._timer.stop()
        self.playing_changed.emit()

    def _rewind(self, *, forward: bool) -> None:
        """What was played once to its end begins again from the other one, as from beyond both."""
        first, stop = self._view.play_range
        ahead = range(first, stop - 1) if forward else range(first + 1, stop)
        if self._repeat is Repeat.ONCE and self._view.frame not in ahead:
            self._view.set_frame(first if forward else stop - 1)

    def _begin_here(self) -> None:
        self._start_time, self._start_frame, self._last_shown = self._clock(), self._view.frame, self._view.frame
        self._shown_at.clear()


def _there_and_back(frame: int, first: int, stop: int) -> int:
    """A frame beyond an end of the range, folded back into it as often as it takes."""
    last = stop - 1 - first
    if last == 0:
        return first
    offset = (frame - first) % (2 * last)
    return first + min(offset, 2 * last - offset)
