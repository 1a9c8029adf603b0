"""The workspace: which parts of the main window are shown, and which of them float in windows of their own."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import Any

from PySide6.QtCore import QCoreApplication, QEvent, QObject, QRect, QSize, QTimer
from PySide6.QtGui import QAction, QGuiApplication
from PySide6.QtWidgets import QScrollArea, QSplitter, QWidget

from ..actions.actions import Actions
from ..widgets.floating import FloatingWindow, in_reach, monitors
from ..widgets.panel import Panel

ABOUT_VIEWER = ("timeline", "second_viewer")
"""The parts that share the window's space with the first viewer; the panels lie in a column of their own."""
STEP = 28
"""Pixels from one window that floats for the first time to the next."""


class Part(QObject):
    """One part: in its place of the main window, floating, or away.

    `show_action` and `float_action` are switched with it; `is_shown_first` says whether a new layout has it.
    """

    def __init__(
        self,
        name: str,
        title: str,
        widget: QWidget,
        main: QWidget,
        show_action: QAction,
        float_action: QAction,
        *,
        is_shown_first: bool = True,
    ) -> None:
        super().__init__(widget)
        self._main = main
        self.name, self.title, self.widget, self.is_shown_first = name, title, widget, is_shown_first
        self.show_action, self.float_action = show_action, float_action
        self.window: FloatingWindow | None = None
        self._gap = _Gap(widget, main)
        self._place: QRect | None = None
        """Where it floats, or floated last."""

    @property
    def is_shown(self) -> bool:
        return self.show_action.isChecked()

    @property
    def floats(self) -> bool:
        return self.float_action.isChecked()

    def follow(self, number: int) -> None:
        """Do what its two actions say; `number` tells apart where parts float for the first time."""
        if self.window is not None and not self.floats:
            self.window.hide()
        self._gap.fill(away=self.floats or not self.is_shown)
        if self.floats:
            self._float(number)
        elif self.window is not None:
            self._gap.take_out()
            self.window.deleteLater()
            self.window = None

    def remembered(self) -> dict[str, Any]:
        """What comes back when the window is opened again."""
        at = self._place
        place = None if at is None else [at.left(), at.top(), at.width(), at.height()]
        return {"shown": self.is_shown, "floats": self.floats, "place": place}

    def recall(self, kept: Mapping[str, Any]) -> None:
        """Take back what `remembered` gave; what makes no sense stays as it is."""
        place = kept.get("place")
        if isinstance(place, list) and len(place) == 4 and all(type(each) is int for each in place):
            left, top, width, height = place
            if width > 0 and height > 0:
                self._place = QRect(left, top, width, height)
        for name, action in (("shown", self.show_action), ("floats", self.float_action)):
            if isinstance(on := kept.get(name), bool):
                action.setChecked(on)

    @property
    def column(self) -> QScrollArea | None:
        """What scrolls where the part lies now: the column of panels may be longer than the window is high."""
        above = self.widget.parentWidget()
        while above is not None and not isinstance(above, QScrollArea):
            above = above.parentWidget()
        return above

    def come_into_sight(self) -> None:
        """Scroll to the part in its place."""
        if self.column is not None and self.widget.isVisible():
            QCoreApplication.sendPostedEvents(None, QEvent.Type.LayoutRequest.value)  # it has its place from now on
            self.column.ensureWidgetVisible(self.widget)

    def bring_into_reach(self) -> None:
        """Where its monitor is gone, come back to the main window's."""
        if self.window is not None:
            self.window.setGeometry(in_reach(self.window.geometry(), monitors(), self._main.geometry()))

    def forget_place(self) -> None:
        """Float elsewhere next time: where parts float for the first time."""
        self._place = None

    # ---- the rest is private

    def _float(self, number: int) -> None:
        if self.window is None:
            self.window = FloatingWindow(self.title, self._main)
            self.window.closed.connect(partial(self.show_action.setChecked, False))
            self.window.moved.connect(self._note)
            self.window.hold(self.widget)
            self.widget.show()
        if not self.is_shown:
            self.window.hide()
        elif self._main.isVisible() and not self.window.isVisible():
            wanted = self._place or _first_place(self._main, self.widget.sizeHint(), number)
            self.window.setGeometry(in_reach(wanted, monitors(), self._main.geometry()))
            self.window.show()

    def _note(self) -> None:
        if self.window is not None and self.window.isVisible():
            self._place = self.window.geometry()


class Workspace(QObject):
    """All parts of the main window `main` that can be shown, hidden and floated, by their names.

    `begin_anew` gives what is laid out besides its first form.
    """

    def __init__(self, main: QWidget, actions: Actions, begin_anew: Callable[[], object]) -> None:
        super().__init__(main)
        self._main, self._actions, self._begin_anew = main, actions, begin_anew
        self.parts: dict[str, Part] = {}
        self._follows: list[Callable[[], object]] = []
        application = QGuiApplication.instance()
        assert isinstance(application, QGuiApplication)
        application.screenRemoved.connect(lambda _: self._lose_monitor())
        main.installEventFilter(self)

    def add(self, name: str, title: str, widget: QWidget, *, show: str = "", is_shown_first: bool = True) -> Part:
        """A part that lies in its place of the main window; `show` is the action that shows it, if not its own."""
        show_action, float_action = self._actions[show or f"window.{name}"], self._actions[f"window.float_{name}"]
        part = Part(name, title, widget, self._main, show_action, float_action, is_shown_first=is_shown_first)
        number = len(self.parts)
        self.parts[name] = part
        show_action.setChecked(is_shown_first)
        follow = partial(part.follow, number)
        self._follows.append(follow)
        show_action.toggled.connect(lambda _: follow())
        float_action.toggled.connect(lambda on: self._float(part, follow) if on else follow())
        # Only where it was asked for: what comes back with the layout at the start leaves the column at its top.
        for action in (show_action, float_action):
            action.triggered.connect(lambda _: self._bring_in(part))
        if isinstance(widget, Panel):
            widget.float_with(float_action)
        follow()
        return part

    @property
    def at_home(self) -> Sequence[QAction]:
        """The switches of the parts about the first viewer that do not float."""
        return [part.show_action for name, part in self.parts.items() if name in ABOUT_VIEWER and not part.floats]

    @property
    def panels(self) -> Sequence[Panel]:
        """The parts with a title under which they fold away."""
        return [part.widget for part in self.parts.values() if isinstance(part.widget, Panel)]

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"window.reset_layout": self.reset}

    def reset(self) -> None:
        """Every part in its place, as in a new window."""
        for part in self.parts.values():
            part.float_action.setChecked(False)
            part.show_action.setChecked(part.is_shown_first)
            part.forget_place()
        for panel in self.panels:
            panel.fold(False)
        self._begin_anew()

    def remembered(self) -> dict[str, dict[str, Any]]:
        """What comes back when the window is opened again."""
        return {name: part.remembered() for name, part in self.parts.items()}

    def recall(self, kept: Mapping[str, Mapping[str, Any]]) -> None:
        """Take back what `remembered` gave; what makes no sense stays as it is."""
        for name, own in kept.items():
            if name in self.parts:
                self.parts[name].recall(own)

    def _float(self, part: Part, follow: Callable[[], object]) -> None:
        """What is floated is shown."""
        if part.is_shown:
            follow()
        else:
            part.show_action.setChecked(True)

    def _bring_in(self, part: Part) -> None:
        """What is asked for is seen, also where it was folded, or the column of panels away."""
        if part.is_shown and not part.floats and part.column is not None:
            if isinstance(part.widget, Panel):
                part.widget.fold(False)
            self._actions["view.panels"].setChecked(True)
            QTimer.singleShot(0, part, part.come_into_sight)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if event.type() is QEvent.Type.Show and not event.spontaneous():
            for follow in self._follows:  # what floats waits for the main window
                QTimer.singleShot(0, self, follow)
        return False

    def _lose_monitor(self) -> None:
        """Once Qt has told every window about it."""
        for part in self.parts.values():
            QTimer.singleShot(0, part, part.bring_into_reach)


class _Gap(QWidget):
    """Stands where a part would be, while that is away, and takes no place."""

    def __init__(self, part: QWidget, store: QWidget) -> None:
        super().__init__(store)
        self.hide()
        self.setMaximumHeight(0)
        self._part, self._store = part, store
        self._sizes: list[int] = []
        self._is_filled = False

    def fill(self, *, away: bool) -> None:
        """Take the part's place, or give it back; what is not in the place belongs to the store, unseen."""
        if away == self._is_filled:
            return
        self._is_filled = away
        there, by = (self._part, self) if away else (self, self._part)
        home = there.parentWidget()
        assert home is not None
        # PySide hears of `setParent` alone: a floating window that a part was left to would take with it, as it ends,
        # the viewports and actions that Qt made for the part.
        by.setParent(self._store)
        if isinstance(home, QSplitter):
            self._exchange(home, there, by)
        else:
            column = home.layout()
            assert column is not None
            column.replaceWidget(there, by)
        self._put_away(there)
        by.setVisible(not (away and isinstance(home, QSplitter)))

    def take_out(self) -> None:
        """Take the part out of the window in which it floats, unless it is in its place: that window may go."""
        if self._is_filled:
            self._put_away(self._part)

    def _put_away(self, widget: QWidget) -> None:
        widget.setParent(self._store)
        widget.hide()

    def _exchange(self, home: QSplitter, there: QWidget, by: QWidget) -> None:
        """In a splitter, where a part that comes back is as large as it was."""
        if by is self:
            self._sizes = home.sizes() if home.isVisible() else []
        index = home.indexOf(there)
        stretch = there.sizePolicy().horizontalStretch()
        home.replaceWidget(index, by)
        home.setStretchFactor(index, stretch)
        if by is not self and home.isVisible():
            by.show()
            even = [sum(home.sizes()) // home.count()] * home.count()
            known = len(self._sizes) == home.count() and self._sizes[index] > 0
            home.setSizes(self._sizes if known else even)


def _first_place(main: QWidget, size: QSize, number: int) -> QRect:
    """Where a part floats for the first time: over the main window's middle, each a little aside of the last."""
    place = QRect(main.geometry().center(), size.expandedTo(QSize(320, 240)))
    place.moveCenter(main.geometry().center())
    place.translate(STEP * (number - 3), STEP * (number - 3))
    return place
