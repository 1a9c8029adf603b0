"""The view bar at the window's upper right: what the plate is, and which view of it is shown."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt
from PySide6.QtGui import QActionGroup, QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QVBoxLayout, QWidget, QWidgetAction

from ... import style
from ...actions.actions import Actions
from ...canvas.view import CanvasView
from ...folders import called
from ...model.document import Document
from ...model.viewing import PROXIES, ViewMode
from ...translation import tr
from ...widgets.controls import tool_button
from ...widgets.more import MoreButton, least_width
from .look_controls import ChannelButton, DisplayButton, exposure_slider, gamma_slider
from .view_options import BackgroundForm, OnionForm, options_button

PLATE_GAP, GAP, END = 12, 2, 6
"""Between the plate's name and the controls; between the buttons of views; right of them: in widget units."""
MOST_WORDS = 280
"""The room that what the plate is may take from the numbers, in widget units."""
NUMBERS = 2
"""How many of the controls that give way are numbers."""


class ViewBar(QWidget):
    """`plate_v003 . 1001-1048 . 960x540 . sRGB`, how it is looked at, then a button for each view.

    Where there is little room the numbers of looking are put behind a button, then what the plate is is cut, then the
    other controls of looking go (`fit`).
    """

    def __init__(self, document: Document, canvas: CanvasView, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._canvas, self._actions = document, canvas, actions
        self._plate = PlateLabel()
        self.channel = ChannelButton(canvas.viewing, actions)
        self.display = DisplayButton(canvas.viewing)
        self.exposure, self.gamma = exposure_slider(canvas.viewing), gamma_slider(canvas.viewing)
        self.background, self.onion = BackgroundForm(canvas.viewing), OnionForm(canvas.viewing)
        self._looks = self.exposure, self.gamma, self.channel, self.display
        # Numbers are rarely changed; channel and display tell what is seen, and stay for longer.
        self._giving_way = self.gamma, self.exposure, self.display, self.channel
        self._put_away: tuple[QWidget, ...] = ()
        self.more = MoreButton(tr("More controls of how the plate is looked at"))
        self._lay_out()
        canvas.view_changed.connect(self._pull_view)
        self._pull_view()
        document.replaced.connect(self._pull)
        document.changed.connect(self._pull)

    def _lay_out(self) -> None:
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 1, END, 1)
        row.setSpacing(0)
        row.addWidget(self._plate, 1)
        row.addSpacing(PLATE_GAP)
        self._in_sight, self._tail = QWidget(), QWidget()
        for part in (self._in_sight, self.more, self._tail):
            row.addWidget(part)
        self._sight_row = sight = QHBoxLayout(self._in_sight)
        sight.setContentsMargins(0, 0, style.MARGIN, 0)
        sight.setSpacing(style.MARGIN)
        for look in self._looks:
            sight.addWidget(look)
        self._page = QWidget()
        self._away_column = QVBoxLayout(self._page)
        self._away_column.setContentsMargins(style.MARGIN, 4, style.MARGIN, 4)
        self._holder = QWidgetAction(self.more.menu())
        self._holder.setDefaultWidget(self._page)
        self.more.menu().addAction(self._holder)
        self._lay_out_views(QHBoxLayout(self._tail))

    def _lay_out_views(self, row: QHBoxLayout) -> None:
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(GAP)
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

    def least_width(self) -> int:
        """The width in which everything that cannot be put away has room."""
        return self._width_without(self._giving_way)

    def fit(self, width: int) -> None:
        """Put away what does not fit in a width, and no more; numbers also where the plate's words would not fit."""
        ways = [self._giving_way[:count] for count in range(len(self._giving_way) + 1)]
        words = min(self._plate.sizeHint().width(), MOST_WORDS)
        needed = [self._width_without(away) + (words if len(away) < NUMBERS else 0) for away in ways]
        away = next((away for away, room in zip(ways, needed, strict=True) if room <= width), self._giving_way)
        self._plate.setMinimumWidth(words if len(away) < NUMBERS else 0)  # sliders would rather be wider than they need
        if away != self._put_away:
            self._put_away = away
            for look in self._looks:
                (self._away_column if look in away else self._sight_row).addWidget(look)
            self.more.setVisible(bool(away))
            self._page.adjustSize()
            self._holder.setData(len(away))  # tells the menu that it has another size

    def _width_without(self, away: tuple[QWidget, ...]) -> int:
        looks = sum(least_width(look) + style.MARGIN for look in self._looks if look not in away)
        more = least_width(self.more) if away else 0
        return PLATE_GAP + looks + more + least_width(self._tail) + END

    def _pull_view(self) -> None:
        self._actions[f"view.{self._canvas.mode}"].setChecked(True)
        self._actions["view.hide_overlays"].setChecked(self._canvas.viewing.are_shapes_hidden)
        for name, step in PROXIES.items():
            self._actions[name].setChecked(self._canvas.viewing.proxy == step)
        self._pull()
        self._actions["view.joints"].setChecked(self._canvas.viewing.shows_joints)
        self._actions["view.edges"].setChecked(self._canvas.viewing.shows_edges)
        self._actions["view.stabilise"].setChecked(self._canvas.viewing.is_stabilised)
        self._actions["view.magnifier"].setChecked(self._canvas.viewing.shows_magnifier)
        self._actions["view.wipe"].setChecked(self._canvas.wipe.pinned is not None)

    def _pull(self, _ids: object = None) -> None:
        clip = self._document.project.clip
        if clip is None:
            self._plate.setText("")
            return
        width, height = clip.size
        parts = [called(clip.path), f"{clip.first}–{clip.last}", f"{width}×{height}", clip.colour_space]
        for name, step in PROXIES.items():
            if step > 1 and step == self._canvas.viewing.proxy:
                parts.append(self._actions[name].text())
        self._plate.setText("  ·  ".join(parts))
        self._plate.setToolTip(f"{self._plate.text()}\n{clip.path}")


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
