"""From which frame to which: the fields that dialogs ask by."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QPushButton

from roam_core.roto import Clip

from ..model.view_state import ViewState
from ..translation import tr
from ..widgets.controls import number_field


class FrameRange:
    """The fields `first` and `last`, within the clip, and a button that takes the frames from in to out."""

    def __init__(self, view_state: ViewState, first_tip: str, last_tip: str) -> None:
        self.first, self.last = number_field(first_tip), number_field(last_tip)
        for number in (self.first, self.last):
            number.setFocusPolicy(Qt.FocusPolicy.StrongFocus)  # Tab goes through the dialog
        self.in_out = QPushButton(tr("In to out"))
        self.in_out.clicked.connect(lambda: self.take(range(*view_state.play_range)))

    @property
    def chosen(self) -> range:
        """The frames as they stand in the fields."""
        return range(self.first.value(), self.last.value() + 1)

    def pull(self, clip: Clip | None) -> None:
        """Another clip: all of its frames, and no others."""
        if clip is not None:
            for number in (self.first, self.last):
                number.setRange(clip.first, clip.last)
        self.take(range(1, 2) if clip is None else clip.frame_range)

    def take(self, frames: range) -> None:
        """Put the first and the last of these frames into the fields."""
        self.first.setValue(frames.start)
        self.last.setValue(frames.stop - 1)
