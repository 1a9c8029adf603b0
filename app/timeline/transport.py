"""The transport: step, play and loop buttons, the frame as a number to type, the play range, the speed."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from app import style
from app.actions import Actions
from app.navigation import Navigation
from app.panels.controls import number_field, tool_button, weak_label
from app.playback import Playback
from app.view_state import ViewState

BUTTONS = (
    "time.first",
    "time.previous_key",
    "time.play_back",
    "time.pause",
    "time.play",
    "time.next_key",
    "time.last",
)
AFTER_RANGE = ("time.loop",)


class Transport(QWidget):
    """One row of controls under the picture."""

    def __init__(self, navigation: Navigation, view_state: ViewState, playback: Playback, actions: Actions) -> None:
        super().__init__()
        self._navigation, self._view, self._playback = navigation, view_state, playback
        self.setObjectName("transport")
        self.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        self.setFixedHeight(32)
        self._frame, self._in, self._out = (
            number_field("Frame"),
            number_field("First frame"),
            number_field("Last frame"),
        )
        self._speed = QLabel()
        self._build(actions)
        self._frame.valueChanged.connect(view_state.set_frame)
        self._in.valueChanged.connect(lambda first: self._set_range(first, view_state.play_range[1]))
        self._out.valueChanged.connect(lambda last: self._set_range(view_state.play_range[0], last + 1))
        view_state.frame_changed.connect(self._pull)
        view_state.range_changed.connect(self._pull)
        playback.playing_changed.connect(self._pull)
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
        for text, field in (("in", self._in), ("out", self._out)):
            row.addWidget(weak_label(text))
            row.addSpacing(2)
            row.addWidget(field)
            row.addSpacing(10)
        self._speed.setObjectName("weak")
        row.addWidget(self._speed)
        row.addSpacing(6)
        for action_id in AFTER_RANGE:
            row.addWidget(tool_button(actions, action_id))

    def _set_range(self, first: int, stop: int) -> None:
        self._view.set_play_range(first, stop)
        self._pull()

    def _pull(self) -> None:
        first, stop = self._navigation.clip_range
        play_first, play_stop = self._view.play_range
        for field, value, low, high in (
            (self._frame, self._view.frame, first, stop - 1),
            (self._in, play_first, first, play_stop - 1),
            (self._out, play_stop - 1, play_first, stop - 1),
        ):
            field.blockSignals(True)
            field.setRange(low, high)
            field.setValue(value)
            field.blockSignals(False)
        speed = abs(self._playback.speed)
        faster = f" × {speed:g}" if speed > 1 else ""
        self._speed.setText(f"{self._playback.fps:g} fps{faster}")
