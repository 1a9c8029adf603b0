"""The command palette: every action by a few letters of its name, with its keys, run by Return."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QEvent, QObject, Qt
from PySide6.QtGui import QBrush, QColor, QFocusEvent, QKeyEvent
from PySide6.QtWidgets import (
    QApplication,
    QFrame,
    QHeaderView,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)
from shiboken6 import isValid

from .. import style
from ..actions.actions import Actions
from ..actions.fuzzy import fuzzy_score, words_begin
from ..actions.menus import menu_of
from ..actions.search_words import words_for
from ..actions.specs import SPECS, ActionSpec
from ..model.view_state import ViewState
from ..translation import tr
from ..widgets.focus import KEEPS_KEYBOARD

WIDTH, MOST_ROWS = 560, 14
MENU_WIDTH, KEYS_WIDTH = 70, 170
WORD_BONUS = 100.0
"""Words of the title that begin so come first, then further words, then letters that lie scattered in the title."""
LATELY_RUN = 5
"""Actions that an empty search shows first: those run last."""

_WEAK, _DISABLED = QBrush(QColor(style.WEAK)), QBrush(QColor(style.DISABLED))
_STEPS = {Qt.Key.Key_Up: -1, Qt.Key.Key_Down: 1, Qt.Key.Key_PageUp: -MOST_ROWS, Qt.Key.Key_PageDown: MOST_ROWS}
_OWN_KEYS = {*_STEPS, Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Escape}


@dataclass(frozen=True)
class Entry:
    """One action as the search sees it."""

    id: str
    title: str
    words: str

    def score(self, query: str) -> float | None:
        """How well a query fits; None where it does not."""
        in_title = fuzzy_score(query, self.title)
        if words_begin(query, self.words):
            return (in_title or 0.0) + WORD_BONUS * (1 + words_begin(query, self.title))
        return in_title


def found(entries: list[Entry], query: str, lately: list[str]) -> list[Entry]:
    """The entries that fit, best first; without a query all, those run lately first."""
    if not query.strip():
        rank = {name: place for place, name in enumerate(lately)}
        return sorted(entries, key=lambda entry: rank.get(entry.id, len(rank)))
    scored = [(score, entry) for entry in entries if (score := entry.score(query)) is not None]
    return [entry for _, entry in sorted(scored, key=lambda pair: -pair[0])]


class Palette(QFrame):
    """A field over a list, in the middle of the window's upper half. It leaves when anything else takes the keyboard.

    What cannot be done at the moment is shown dim, and says so when it is asked for.
    """

    def __init__(self, window: QWidget, actions: Actions, view_state: ViewState) -> None:
        super().__init__(window)
        self._actions, self._view = actions, view_state
        self._entries: list[Entry] = []
        self._lately: list[str] = []
        self._focus_before: QWidget | None = None
        self.setObjectName("palette")
        self.field, self.list = QLineEdit(), QTreeWidget()
        self.field.setPlaceholderText(tr("Do what?"))
        self.field.setAccessibleName(self.field.placeholderText())
        self.list.setAccessibleName(tr("Actions"))
        self.field.setProperty(KEEPS_KEYBOARD, True)
        self.field.installEventFilter(self)
        self.field.textChanged.connect(lambda _: self._pull())
        self._build_list()
        column = QVBoxLayout(self)
        column.setContentsMargins(6, 6, 6, 6)
        column.setSpacing(6)
        column.addWidget(self.field)
        column.addWidget(self.list)
        self.hide()

    def _build_list(self) -> None:
        tree = self.list
        tree.setColumnCount(3)
        tree.setHeaderHidden(True)
        tree.setRootIsDecorated(False)
        tree.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        tree.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        tree.setUniformRowHeights(True)
        tree.header().setStretchLastSection(False)
        tree.header().setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, width in ((1, MENU_WIDTH), (2, KEYS_WIDTH)):
            tree.header().resizeSection(column, width)
        tree.itemClicked.connect(lambda item: self._run(item))

    def open(self) -> None:
        """Show it empty, ready to type; or put it away where it is open."""
        if self.isVisible():
            self.leave()
            return
        self._focus_before = QApplication.focusWidget()
        self._entries = [self._entry(spec) for spec in SPECS]  # some titles change: `Undo Draw`
        self.field.clear()
        self._pull()
        parent = self.parentWidget()
        assert parent is not None
        width = min(WIDTH, parent.width() - 2 * style.MARGIN)
        self.setGeometry((parent.width() - width) // 2, parent.height() // 8, width, self.sizeHint().height())
        self.show()
        self.raise_()
        self.field.setFocus()

    def leave(self) -> None:
        """Put it away and give the keyboard back to whoever had it."""
        before, self._focus_before = self._focus_before, None
        self.hide()
        if before is not None and isValid(before):  # a field over a row of a list ends as it loses the keyboard
            before.setFocus()

    @property
    def shown(self) -> list[str]:
        """The ids of the actions in the list, best first."""
        items = (self.list.topLevelItem(row) for row in range(self.list.topLevelItemCount()))
        named = (item.data(0, Qt.ItemDataRole.UserRole) for item in items if item is not None)
        return [name for name in named if name]

    # ---- the rest is private

    def _pull(self) -> None:
        self.list.clear()
        items = [self._item(entry) for entry in found(self._entries, self.field.text(), self._lately)]
        if items:
            self.list.addTopLevelItems(items)
            self.list.setCurrentItem(items[0])
        else:
            self._say_nothing()
        self.list.setFixedHeight(min(max(len(items), 1), MOST_ROWS) * style.ROW_HEIGHT)
        self.resize(self.width(), self.sizeHint().height())

    def _entry(self, spec: ActionSpec) -> Entry:
        title = self._actions[spec.id].text()
        return Entry(spec.id, title, f"{title} {menu_of(spec.id)} {spec.sentence} {words_for(spec.id)}")

    def _item(self, entry: Entry) -> QTreeWidgetItem:
        action = self._actions[entry.id]
        state = tr("  (on)") if action.isChecked() else ""
        item = QTreeWidgetItem([entry.title + state, menu_of(entry.id), self._actions.keys_of(entry.id)])
        item.setData(0, Qt.ItemDataRole.UserRole, entry.id)
        item.setToolTip(0, action.toolTip())
        item.setTextAlignment(2, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        if action.isEnabled():
            item.setForeground(1, _WEAK)
            item.setForeground(2, _WEAK)
        else:
            for column in range(3):
                item.setForeground(column, _DISABLED)
        return item

    def _say_nothing(self) -> None:
        """Show a row that says that nothing was found; it can be neither chosen nor run."""
        item = QTreeWidgetItem([tr("No action is called that; try another word, or fewer letters.")])
        item.setFlags(Qt.ItemFlag.NoItemFlags)
        self.list.addTopLevelItem(item)
        item.setFirstColumnSpanned(True)

    def _step(self, rows: int) -> None:
        if (current := self.list.currentItem()) is None:
            return
        row = self.list.indexOfTopLevelItem(current) + rows
        item = self.list.topLevelItem(min(max(row, 0), self.list.topLevelItemCount() - 1))
        if item is not None:
            self.list.setCurrentItem(item)

    def _run(self, item: QTreeWidgetItem | None) -> None:
        if item is None or not item.flags() & Qt.ItemFlag.ItemIsEnabled:
            return
        name = item.data(0, Qt.ItemDataRole.UserRole)
        action = self._actions[name]
        if not action.isEnabled():
            self._view.say(tr("{action} cannot be done at the moment.", action=action.text().rstrip("…")))
            return
        self._lately = [name, *(other for other in self._lately if other != name)][:LATELY_RUN]
        self.leave()
        action.trigger()

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        if isinstance(event, QKeyEvent) and event.key() in _OWN_KEYS:
            if event.type() is QEvent.Type.ShortcutOverride:
                event.accept()  # these are the palette's while it is open, whatever they mean in the window
                return True
            if event.type() is QEvent.Type.KeyPress:
                self._press(Qt.Key(event.key()))
                return True
        if event.type() is QEvent.Type.FocusOut and isinstance(event, QFocusEvent):
            self.hide()
        return False

    def _press(self, key: Qt.Key) -> None:
        if key in _STEPS:
            self._step(_STEPS[key])
        elif key is Qt.Key.Key_Escape:
            self.leave()
        else:
            self._run(self.list.currentItem())
