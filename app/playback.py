"""Playing the clip at its own speed: frames are left out rather than played late."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, QTimer, Signal

from app.view_state import ViewState

FASTEST = 8.0


class Playback(QObject):
    """Moves the playhead through the play range at `fps`, times `speed` (negative: backward).

    The frame follows from the clock, not from the number of ticks: a slow picture costs frames, never time. `clock`
    gives seconds.

    Signals
    -------
    playing_changed() : it began, stopped, turned, or changed its speed.
    """

    playing_changed = Signal()

    def __init__(
        self, view_state: ViewState, parent: QObject | None = None, clock: Callable[[], float] = time.perf_counter
    ) -> None:
        super().__init__(parent)
        self._view, self._clock = view_state, clock
        self.fps = 24.0
        self.is_looping = True
        self._speed = 0.0
        self._start_time, self._start_frame, self._last_shown = 0.0, 0, 0
        self._timer = QTimer(self, timerType=Qt.TimerType.PreciseTimer)
        self._timer.timeout.connect(self.tick)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "time.toggle_play": self.toggle,
            "time.play_back": self.play_back,
            "time.pause": self.pause,
            "time.play": self.play,
        }

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

    def pause(self) -> None:
        self._set_speed(0.0)

    def toggle(self) -> None:
        """Play forward, or stand still."""
        self._set_speed(0.0 if self._speed else 1.0)

    def tick(self) -> None:
        """Show the frame that is due now; scrubbing in between starts anew from where it led."""
        if self._view.frame != self._last_shown:
            self._begin_here()
        steps = int((self._clock() - self._start_time) * self.fps * abs(self._speed))
        self._show(self._start_frame + (steps if self._speed > 0 else -steps))

    def _show(self, frame: int) -> None:
        first, stop = self._view.play_range
        if not first <= frame < stop:
            if not self.is_looping:
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
        self._speed = speed
        self._begin_here()
        if speed:
            self._timer.start(max(int(1000 / (self.fps * abs(speed)) / 2), 4))
        else:
            self._timer.stop()
        self.playing_changed.emit()

    def _begin_here(self) -> None:
        self._start_time, self._start_frame, self._last_shown = self._clock(), self._view.frame, self._view.frame
