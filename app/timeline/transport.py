"""The transport: step, play and loop buttons, the frame as a number to type, the play range, the speed."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from .. import style
from ..actions.actions import Actions
from ..features.navigation import Navigation
from ..features.playback import Playback, Repeat
from ..model.view_state import ViewState
from ..translation import number, tr
from ..widgets.controls import number_field, tool_button, weak_label

BUTTONS = (
    "time.first",
    "time.previous_key",
    "time.play_back",
    "time.pause",
    "time.play",
    "time.next_key",
    "time.last",
)
AFTER_RANGE = ("time.loop", "time.ping_pong")


class Transport(QWidget):
    """One row of controls under the picture."""

    def __init__(self, navigation: Navigation, view_state: ViewState, playback: Playback, actions: Actions) -> None:
        super().__init__()
        self._navigation, self._view, self._playback = navigation, view_state, playback
        self.setObjectName("transport")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(32)
        self._frame, self._in, self._out = (
            number_field(tr("Frame")),
            number_field(tr("First frame")),
            number_field(tr("Last frame")),
        )
        self._speed = QLabel()
        self._build(actions)
        self._frame.valueChanged.connect(view_state.set_frame)
        self._in.valueChanged.connect(lambda first: self._set_range(first, max(view_state.play_range[1], first + 1)))
        self._out.valueChanged.connect(lambda last: self._set_range(min(view_state.play_range[0], last), last + 1))
        view_state.frame_changed.connect(self._pull)
        view_state.range_changed.connect(self._pull)
        playback.playing_changed.connect(self._pull)
        playback.rate_changed.connect(self._pull_speed)
        self._connect_repeat(actions)
        self._pull()

    def _build(self, actions: Actions) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(style.MARGIN, 0, style.MARGIN, 0)
        row.setSpacing(2)
        for action_id in BUTTONS:
            row.addWidget(tool_button(actions, action_id))
        row.addSpacing(10)
        row.addWidget(self._frame)
        row.addStretch(1)
        for text, field in ((tr("in"), self._in), (tr("out"), self._out)):
            row.addWidget(weak_label(text))
            row.addSpacing(2)
            row.addWidget(field)
            row.addSpacing(10)
        self._speed.setObjectName("weak")
        self._speed.setMinimumWidth(self._speed.fontMetrics().horizontalAdvance(tr("24 of 23.976 fps × 0.125")))
        self._speed.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._speed.setToolTip(tr("The clip's frames a second; while it plays, those that are shown, and the speed"))
        row.addWidget(self._speed)
        row.addSpacing(6)
        for action_id in AFTER_RANGE:
            row.addWidget(tool_button(actions, action_id))

    def _connect_repeat(self, actions: Actions) -> None:
        """Two switches of which one at most is on: with neither, it plays once."""
        switches = {Repeat.LOOP: actions["time.loop"], Repeat.PING_PONG: actions["time.ping_pong"]}

        def choose(repeat: Repeat, is_on: bool) -> None:
            if is_on:
                self._playback.set_repeat(repeat)
            elif self._playback.repeat is repeat:
                self._playback.set_repeat(Repeat.ONCE)

        def pull() -> None:
            for repeat, switch in switches.items():
                switch.setChecked(self._playback.repeat is repeat)

        pull()
        self._playback.repeat_changed.connect(pull)
        for repeat, switch in switches.items():
            switch.toggled.connect(partial(choose, repeat))

    def _set_range(self, first: int, stop: int) -> None:
        """Take a range of which one end was typed; the other end goes along with one that passes it."""
        self._view.set_play_range(first, stop)
        self._pull()

    def _pull(self) -> None:
        first, stop = self._navigation.clip_range
        play_first, play_stop = self._view.play_range
        for field, value, low, high in (
            (self._frame, self._view.frame, first, stop - 1),
            (self._in, play_first, first, stop - 1),
            (self._out, play_stop - 1, first, stop - 1),
        ):
            field.show_frame(value, low, high)
        self._pull_speed()

    def _pull_speed(self) -> None:
        """The clip's speed; while it plays also how many pictures a second come to the screen, and how fast."""
        speed, rate = abs(self._playback.speed), self._playback.rate
        shown = "" if rate is None else tr("{rate:.0f} of ", rate=rate)
        times = "" if speed in (0, 1) else f" × {number(speed)}"
        self._speed.setText(tr("{shown}{fps:g} fps{times}", shown=shown, fps=self._playback.fps, times=times))
