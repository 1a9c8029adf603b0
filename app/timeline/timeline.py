"""Timeline: ruler, tracks, key rows and confidence plot over each other, on one time axis."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping

from PySide6.QtCore import QEvent, QObject, QSize, QTimer
from PySide6.QtGui import QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from ..actions.actions import Actions
from ..model.document import Document
from ..model.view_state import ViewState
from ..translation import tr
from ..widgets.controls import tool_button
from ..widgets.panel import Panel
from .axis import TimeAxis
from .boil_band import BoilBand
from .confidence import LEAST_HEIGHT, ConfidencePlot
from .curves.editor import CurveEditor
from .keys.row_painter import ROW
from .keys.rows import KeyRows
from .keys.selection import KeySelection
from .keys.verbs import KeyVerbs
from .mark_band import MarkBand
from .mark_verbs import MarkVerbs
from .marks import MarksOf
from .panning import PanHand, TimeBar
from .row_band import BandRoom
from .ruler import Ruler
from .tracks import MOST as MOST_TRACKS
from .tracks import TrackBand
from .values.rows import MOST as MOST_VALUES
from .values.rows import ValueRows
from .values.selection import ValueSelection
from .values.shown import items_in_hand
from .values.stretching import Stretching

KEY_WAYS = ("key.linear", "key.smooth", "key.hold")
KEY_MENU = KEY_WAYS, ("edit.copy", "edit.cut", "edit.paste"), ("key.stretch", "points.delete")
"""What a right click on the key rows offers, in groups."""

VALUE_MENU = (*KEY_WAYS, "key.tangents"), KEY_MENU[1], ("key.stretch", "points.delete", "points.select_all")
"""What one offers on the rows of values and on curves."""

SHARED = ("edit.copy", "edit.cut", "edit.paste", "points.delete", "points.select_all", "key.set", "key.delete")
"""Actions of the viewer whose keys work in the key rows too, when these have the keyboard."""


LEAST_ROWS = 2
"""Key rows that have room in the lowest timeline."""


class Timeline(QWidget):
    """Shows the document's keys over the clip's frames.

    Marks, tracks and values have rows that come and go: they take their room from the plot, and scroll where that is
    not enough. The least height is the same with and without them, so that the viewer above keeps its own.

    `cached` gives the frames that are decoded, `missing` those that the plate should have and does not.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        cached: Callable[[], Iterable[int]],
        missing: Callable[[], Iterable[int]],
        actions: Actions,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document = document
        marks = MarksOf(document)
        self.axis = TimeAxis(view_state, self)
        self.keys = KeySelection(document, self)
        self.ruler = Ruler(self.axis, cached, missing)
        self.marks = MarkBand(document, self.axis)
        self.mark_verbs = MarkVerbs(document, view_state, self.marks.edit)
        self.rows = KeyRows(document, self.axis, marks, self.keys)
        self.verbs = KeyVerbs(document, view_state, self.keys, self.rows.hasFocus)
        self.rows.nudged.connect(self.verbs.nudge)
        self.tracks = TrackBand(document, self.axis)
        self.values = ValueSelection(document, self)
        self.value_rows = ValueRows(document, self.axis, self.values)
        self.value_rows.verbs.takes_paste = self.rows.hasFocus
        self.stretching = Stretching(self, document, view_state, self.keys, self.values, self.value_rows.verbs)
        self.curves = CurveEditor(document, self.axis, self.values)
        curve_tools = tuple(tool_button(actions, name) for name in VALUE_MENU[0])
        self.curve_panel = Panel("curves", tr("Curve editor"), self.curves, curve_tools)
        self.curve_panel.hide()  # the workspace shows it
        for name in ("view.curves", "window.float_curves"):
            actions[name].toggled.connect(lambda _: self._pull_curves(actions))
        self.confidence = ConfidencePlot(document, self.axis, marks)
        self.boil = BoilBand(document, self.axis)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        column.setSpacing(0)
        self.bar = TimeBar(self.axis)
        self.band_rooms = BandRoom(self.tracks, MOST_TRACKS), BandRoom(self.value_rows, MOST_VALUES)
        keyed = self.band_rooms[0], self.rows, self.band_rooms[1]
        for part in (self.ruler, self.marks, *keyed, self.curve_panel, self.confidence, self.boil, self.bar):
            column.addWidget(part)
        plots = self.confidence.lines.viewport(), self.boil, self.curves.plot.viewport()
        hand = PanHand(self.axis, self.ruler, self.marks, self.tracks, self.rows.viewport(), self.value_rows, *plots)
        hand.dragged.connect(lambda over, down: self.curves.plot.pan(down) if over is plots[-1] else None)
        column.setStretchFactor(self.rows, 1)  # the rows come first; the plot takes what they do not need
        column.setStretchFactor(self.curve_panel, 4)
        self.keys.changed.connect(lambda: self.values.clear() if self.keys.places else None)
        self.values.changed.connect(lambda: self.keys.clear() if self.values.places else None)
        view_state.selection_changed.connect(self._keep_chosen_in_hand)
        for part in (self.marks, self.bar, *self.band_rooms):
            part.installEventFilter(self)
        self._share()
        self._offer(actions)
        document.replaced.connect(self._pull_clip)
        for signal in (document.changed, document.replaced, self.tracks.pulled, self.value_rows.pulled):
            signal.connect(lambda *_: self._share_rows())

    def minimumSizeHint(self) -> QSize:
        # What comes and goes has no part in it: Qt asks for this before `_share` has taken its room from the plot.
        plots = 0 if self.confidence.isHidden() else LEAST_HEIGHT
        if self.isAncestorOf(self.curve_panel) and not self.curve_panel.isHidden():
            plots += self.curve_panel.minimumSizeHint().height() + (0 if self.curve_panel.is_folded else self._given)
        height = self.ruler.height() + LEAST_ROWS * ROW + plots + self.boil.height()
        return QSize(super().minimumSizeHint().width(), height)

    def resizeEvent(self, event: QResizeEvent) -> None:
        super().resizeEvent(event)
        self._share_rows()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() in (QEvent.Type.ShowToParent, QEvent.Type.HideToParent):
            self._share()
        return False

    @property
    def wanted_rows(self) -> int:
        """The rows of keys that the project would fill: of shapes, of values and of layers that move."""
        return len(self._document.project.shapes) + sum(band.wanted_rows for band in self.band_rooms)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        own = self.axis.handlers() | self.verbs.handlers() | self.mark_verbs.handlers()
        return own | self.value_rows.verbs.handlers() | self.stretching.handlers()

    def taking_over(self, handlers: Mapping[str, Callable[[], object]]) -> dict[str, Callable[[], object]]:
        """Handlers that mean keys while the rows or the curves have the keyboard, and elsewhere what they meant."""
        taken = {**handlers, **self.handlers(), **self.verbs.taking_over(handlers)}
        for verbs in (self.value_rows.verbs, self.curves.plot.verbs):
            taken |= verbs.taking_over(taken)
        return taken

    def _keep_chosen_in_hand(self) -> None:
        """Keys of values whose rows and curves are gone are chosen no more: what is done next means others."""
        owners = {item.id for item in items_in_hand(self._document.project, self.axis.view_state)}
        self.values.select(frozenset(place for place in self.values.places if place[0] in owners))

    def _share(self) -> None:
        """Give what comes and goes its least height, out of that of the plot."""
        left = LEAST_HEIGHT - sum(part.height() for part in (self.marks, self.bar) if not part.isHidden())
        shown = [room for room in self.band_rooms if not room.isHidden()]
        for room in shown:
            room.setMinimumHeight(min(ROW, left // len(shown)))
        self._given = LEAST_HEIGHT - left + sum(room.minimumHeight() for room in shown)
        self._share_rows()
        self.confidence.give(self._given)
        self.curves.give(self._given)

    def _share_rows(self) -> None:
        """Leave half of the rows that have room to the keys of shapes, or as many as there are shapes."""
        fixed = (self.ruler, self.marks, self.boil, self.bar)
        taken = sum(part.height() for part in fixed if not part.isHidden())
        taken += 0 if self.confidence.isHidden() else self.confidence.minimumHeight()
        room = max(self.height() - taken, 0) // ROW
        left = max(room - len(self._document.project.shapes), room // 2)
        for band in self.band_rooms:
            left -= band.limit(max(left, 1))

    def _pull_curves(self, actions: Actions) -> None:
        """In the timeline the curve editor has the place of the confidence plot; it takes the keyboard."""
        is_shown = actions["view.curves"].isChecked()
        self.confidence.setVisible(not is_shown or actions["window.float_curves"].isChecked())
        if is_shown and self.isVisible():
            QTimer.singleShot(0, self, self.curves.plot.setFocus)

    def _offer(self, actions: Actions) -> None:
        for group in KEY_MENU:
            self.rows.menu.addSeparator()
            self.rows.menu.addActions([actions[name] for name in group])
        self.rows.addActions([actions[name] for name in SHARED])
        for part in (self.value_rows, self.curves.plot):
            for names in VALUE_MENU:
                part.menu.addSeparator()
                part.menu.addActions([actions[name] for name in names])
            part.addActions([actions[name] for name in SHARED])

    def _pull_clip(self) -> None:
        clip = self._document.project.clip
        self.axis.set_clip(None if clip is None else (clip.first, clip.last + 1))
