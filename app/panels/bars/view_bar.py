"""The view bar at the window's upper right: what the plate is, and which view of it is shown."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QActionGroup, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from roam_core.roto import Clip

from ... import style
from ...actions.actions import Actions
from ...canvas.view import CanvasView
from ...folders import cache_folder
from ...model.document import Document
from ...model.viewing import PROXIES, ViewMode
from ...translation import tr
from ...widgets.controls import tool_button
from .look_controls import ChannelButton, DisplayButton, exposure_slider, gamma_slider
from .view_options import BackgroundForm, OnionForm, options_button


class ViewBar(QWidget):
    """`plate_v003 . 1001-1048 . 960x540 . sRGB`, how it is looked at, then a button for each view."""

    def __init__(self, document: Document, canvas: CanvasView, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._canvas, self._actions = document, canvas, actions
        self._plate = PlateLabel()
        self.channel = ChannelButton(canvas.viewing, actions)
        self.display = DisplayButton(canvas.viewing)
        self.exposure, self.gamma = exposure_slider(canvas.viewing), gamma_slider(canvas.viewing)
        self.background, self.onion = BackgroundForm(canvas.viewing), OnionForm(canvas.viewing)
        self._lay_out()
        canvas.view_changed.connect(self._pull_view)
        self._pull_view()
        document.replaced.connect(self._pull)
        document.changed.connect(self._pull)

    def _lay_out(self) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 1, 6, 1)
        row.setSpacing(2)
        row.addWidget(self._plate, 1)
        row.addSpacing(12)
        for part in (self.exposure, self.gamma, self.channel, self.display):
            row.addWidget(part)
            row.addSpacing(style.MARGIN)
        row.addWidget(tool_button(self._actions, "view.wipe"))
        row.addSpacing(style.MARGIN)
        options = {
            ViewMode.CUTOUT: options_button(self.background, tr("What the cut-out lies on")),
            ViewMode.ONION: options_button(self.onion, tr("Which frames the onion skin shows")),
        }
        self._group = QActionGroup(self)
        for mode in ViewMode:
            self._group.addAction(self._actions[f"view.{mode}"])
            row.addWidget(tool_button(self._actions, f"view.{mode}"))
            if mode in options:
                row.addWidget(options[mode])

    def _pull_view(self) -> None:
        self._actions[f"view.{self._canvas.mode}"].setChecked(True)
        self._actions["view.hide_overlays"].setChecked(self._canvas.viewing.are_shapes_hidden)
        for name, step in PROXIES.items():
            self._actions[name].setChecked(self._canvas.viewing.proxy == step)
        self._pull()
        self._actions["view.joints"].setChecked(self._canvas.viewing.shows_joints)
        self._actions["view.edges"].setChecked(self._canvas.viewing.shows_edges)
        self._actions["view.wipe"].setChecked(self._canvas.wipe.pinned is not None)

    def _pull(self, _ids: object = None) -> None:
        clip = self._document.project.clip
        if clip is None:
            self._plate.setText("")
            return
        width, height = clip.size
        parts = [_name(clip), f"{clip.first}–{clip.last}", f"{width}×{height}", clip.colour_space]
        for name, step in PROXIES.items():
            if step > 1 and step == self._canvas.viewing.proxy:
                parts.append(self._actions[name].text())
        self._plate.setText("  ·  ".join(parts))
        self._plate.setToolTip(str(clip.path))


class PlateLabel(QLabel):
    """A weak label that gives way where the window is narrow; what does not fit ends in three dots."""

    def __init__(self) -> None:
        super().__init__()
        self.setObjectName("weak")
        self.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)

    def minimumSizeHint(self) -> QSize:
        return QSize(0, super().minimumSizeHint().height())

    def paintEvent(self, event: QPaintEvent) -> None:
        painter = QPainter(self)
        painter.setPen(QColor(style.WEAK))
        fitting = self.fontMetrics().elidedText(self.text(), Qt.TextElideMode.ElideRight, self.width())
        painter.drawText(self.rect(), self.alignment(), fitting)
        painter.end()


def _name(clip: Clip) -> str:
    """The clip's name as the artist knows it.

    A folder of the application's own cache, such as the demo's, is a name and a hash of its version; the hash says
    nothing to an artist.
    """
    return clip.name.rpartition("-")[0] or clip.name if clip.path.parent == cache_folder() else clip.name
