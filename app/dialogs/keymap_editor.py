"""The keymap editor: every action with its keys in a table, found by words, changed by pressing the new key."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QModelIndex, QSize, Qt, Signal
from PySide6.QtGui import QColor, QKeyEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QHBoxLayout,
    QHeaderView,
    QLabel,
    QLineEdit,
    QPushButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from roam_core.errors import RoamError

from .. import style
from ..actions.fuzzy import fuzzy_score, words_begin
from ..actions.key_names import NUDGES, is_modifier, key_name
from ..actions.keymaps import OwnKeymap, holder_of, keys_text, load_own, presets, press, save_own
from ..actions.menus import menu_of
from ..actions.search_words import words_for
from ..actions.specs import SPECS
from ..model.personal import Personal
from ..translation import sentence_of, tr
from ..widgets.controls import weak_label
from ..widgets.floating import resize_on_screen
from . import questions

_ID = Qt.ItemDataRole.UserRole
MENU_WIDTH, KEYS_WIDTH = 96, 220


class KeyField(QLineEdit):
    """Takes the next key that is pressed; it types nothing.

    Signals
    -------
    pressed(key) : a key with its modifiers, as keymaps write it.
    """

    pressed = Signal(str)

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setReadOnly(True)
        self.setPlaceholderText(tr("Click here, then press the new key"))
        self.setAttribute(Qt.WidgetAttribute.WA_InputMethodEnabled, False)

    def minimumSizeHint(self) -> QSize:
        """As wide as what it asks for, in every language."""
        hint, asked = super().minimumSizeHint(), self.fontMetrics().horizontalAdvance(self.placeholderText())
        return QSize(max(hint.width(), asked + 2 * style.MARGIN), hint.height())

    def event(self, event: QEvent) -> bool:
        # Tab and the dialog's own Return and Esc come here, too: every key may be wanted.
        if isinstance(event, QKeyEvent) and event.type() in (QEvent.Type.KeyPress, QEvent.Type.ShortcutOverride):
            event.accept()
            is_press = event.type() is QEvent.Type.KeyPress and not is_modifier(event)
            if is_press and (key := key_name(event)):
                self.pressed.emit(key)
            return True
        return super().event(event)


class KeymapEditor(QDialog):
    """A preset above, the table, and what can be done to the selected action's keys below.

    What is changed holds at once and is kept as the artist's own.
    """

    def __init__(self, personal: Personal, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._personal = personal
        self._asked = ""
        self.setWindowTitle(tr("Change keys"))
        resize_on_screen(self, 640, 640)
        self._build()
        self._lay_out()
        self._connect()
        self._pull()

    # ---- building

    def _build(self) -> None:
        self.preset = QComboBox()
        for name, title in presets().items():
            self.preset.addItem(title, name)
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Search"))
        self.search.setClearButtonEnabled(True)
        self.search.setAccessibleName(self.search.placeholderText())
        self.table = QTreeWidget()
        self.table.setColumnCount(3)
        self.table.setHeaderLabels([tr("Action"), tr("Menu"), tr("Keys", "of the keyboard")])
        self.table.setRootIsDecorated(False)
        self.table.setUniformRowHeights(True)
        self.table.addTopLevelItems([_row(spec.id) for spec in SPECS])
        header = self.table.header()
        header.setStretchLastSection(False)
        header.setSectionResizeMode(QHeaderView.ResizeMode.Fixed)
        header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        for column, width in ((1, MENU_WIDTH), (2, KEYS_WIDTH)):
            header.resizeSection(column, width)
        self.field = KeyField()
        self.field.setAccessibleName(self.field.placeholderText())
        self.table.setAccessibleName(tr("Actions"))
        self.word = weak_label("")
        self.word.setWordWrap(True)
        self.word.setMinimumHeight(2 * style.ROW_HEIGHT)
        self.adds = QCheckBox(tr("Add"))
        self.adds.setToolTip(tr("Keep the keys that the action has, and add the new one"))
        self.take = QPushButton(tr("Take it over"))
        self.take.setToolTip(tr("Give the key to this action; the other one goes without it"))
        self.remove = QPushButton(tr("No key"))
        self.remove.setToolTip(tr("Leave this action without a key"))
        self.reset = QPushButton(tr("Reset"))
        self.reset.setToolTip(tr("Give this action the keys of the preset again"))
        self.reset_all = QPushButton(tr("Reset all"))
        self.reset_all.setToolTip(tr("Forget all keys of your own"))
        self.read, self.write = QPushButton(tr("Import…")), QPushButton(tr("Export…"))
        self.read.setToolTip(tr("Take the preset and the keys of a file in place of your own"))
        self.write.setToolTip(tr("Write the preset and your own keys to a file, for another machine"))
        self.leave = QPushButton(tr("Close"))
        for button in (self.take, self.remove, self.reset, self.reset_all, self.read, self.write, self.leave):
            button.setAutoDefault(False)

    def _lay_out(self) -> None:
        upper, middle, lower = QHBoxLayout(), QHBoxLayout(), QHBoxLayout()
        upper.addWidget(QLabel(tr("Keys of")))
        upper.addWidget(self.preset)
        upper.addWidget(self.search, 1)
        for widget, stretch in ((self.field, 1), (self.adds, 0), (self.take, 0), (self.remove, 0), (self.reset, 0)):
            middle.addWidget(widget, stretch)
        for button in (self.reset_all, self.read, self.write):
            lower.addWidget(button)
        lower.addStretch(1)
        lower.addWidget(self.leave)
        column = QVBoxLayout(self)
        column.setSpacing(style.MARGIN)
        column.addLayout(upper)
        column.addWidget(self.table, 1)
        column.addLayout(middle)
        column.addWidget(self.word)
        column.addLayout(lower)
        self.search.setFocus()  # letters meant for it would choose other keys where these are chosen

    def _connect(self) -> None:
        self.preset.currentIndexChanged.connect(lambda _: self._push_preset())
        self.search.textChanged.connect(lambda _: self._pull_search())
        self.table.currentItemChanged.connect(lambda *_: self._pull_selected())
        self.table.itemDoubleClicked.connect(lambda *_: self.field.setFocus())
        self.field.pressed.connect(self._record)
        self.take.clicked.connect(lambda: self._give(self._asked))
        self.remove.clicked.connect(lambda: self._push_keys(()))
        self.reset.clicked.connect(lambda: self._personal.set_keys(self._own.without(self.selected)))
        self.reset_all.clicked.connect(lambda: self._personal.set_keys(OwnKeymap(self._own.preset)))
        self.read.clicked.connect(self._import)
        self.write.clicked.connect(self._export)
        self.leave.clicked.connect(self.close)
        self._personal.keys_changed.connect(self._pull)

    # ---- what is chosen

    @property
    def selected(self) -> str:
        """The id of the selected action; empty where none is."""
        item = self.table.currentItem()
        return "" if item is None else str(item.data(0, _ID))

    def select(self, action_id: str) -> None:
        """Select an action."""
        for item in self._items():
            if item.data(0, _ID) == action_id:
                self.table.setCurrentItem(item)

    @property
    def _own(self) -> OwnKeymap:
        return self._personal.keys

    def _items(self) -> list[QTreeWidgetItem]:
        items = (self.table.topLevelItem(row) for row in range(self.table.topLevelItemCount()))
        return [item for item in items if item is not None]

    # ---- pushing

    def _push_preset(self) -> None:
        self._personal.set_keys(OwnKeymap(self.preset.currentData(), self._own.keys))

    def _push_keys(self, keys: tuple[str, ...]) -> None:
        if self.selected:
            self._personal.set_keys(self._own.with_keys(self.selected, keys))

    def _record(self, key: str) -> None:
        """A key was pressed: it becomes the action's where it is free, else the artist is told whose it is."""
        if not self.selected:
            self.word.setText(tr("Select an action first."))
            return
        self.field.setText(keys_text((key,)))
        self._asked = ""
        holder = holder_of(self._own.keymap, self.selected, key)
        if key in NUDGES:
            self.word.setText(tr("{keys} moves the selected points; choose another key.", keys=keys_text((key,))))
        elif holder is not None:
            self._asked = key
            self.word.setText(tr("{keys} is the key of “{action}”.", keys=keys_text((key,)), action=_title(holder)))
        else:
            self._give(key)
        self.take.setEnabled(bool(self._asked))

    def _give(self, key: str) -> None:
        """Make a key the action's only one, or one more of its keys; whoever had it goes without it."""
        present = self._own.keymap.get(self.selected, ()) if self.adds.isChecked() else ()
        keys = (*(other for other in present if press(other) != press(key)), key)
        self._push_keys(keys)
        self.word.setText(tr("“{action}” is {keys} now.", action=_title(self.selected), keys=keys_text(keys)))
        self._asked = ""
        self.take.setEnabled(False)

    def _import(self) -> None:
        """Take the keys of a file that was exported; one that is no keymap changes nothing, and is told."""
        if (path := questions.choose_keymap(self)) is None:
            return
        try:
            self._personal.set_keys(load_own(path))
        except RoamError as error:
            self.word.setText(sentence_of(error))
        else:
            self.word.setText(tr("The keys of {name} hold now.", name=path.name))

    def _export(self) -> None:
        path = questions.choose_export(self, tr("Export keys"), Path.home() / "roam-keys.json", ".json")
        if path is None:
            return
        try:
            save_own(self._own, path)
        except RoamError as error:
            self.word.setText(sentence_of(error))
        else:
            self.word.setText(tr("Your keys are in {path}.", path=path))

    # ---- pulling

    def _pull(self) -> None:
        keymap, own = self._own.keymap, self._own.keys
        self.preset.blockSignals(True)
        self.preset.setCurrentIndex(self.preset.findData(self._own.preset))
        self.preset.blockSignals(False)
        for item in self._items():
            name = item.data(0, _ID)
            item.setText(2, keys_text(keymap.get(name, ())))
            item.setForeground(2, QColor(style.ACCENT if name in own else style.TEXT))
            item.setToolTip(2, tr("A key of your own") if name in own else "")
        self.reset_all.setEnabled(bool(own))
        self._pull_selected()

    def _pull_selected(self) -> None:
        self._asked = ""
        self.field.clear()
        self.take.setEnabled(False)
        self.remove.setEnabled(bool(self._own.keymap.get(self.selected)))
        self.reset.setEnabled(self.selected in self._own.keys)
        self.field.setEnabled(bool(self.selected))
        self.word.setText("" if self.selected else tr("Select an action to give it another key."))

    def _pull_search(self) -> None:
        query = self.search.text()
        for item in self._items():
            words = f"{item.text(0)} {item.text(1)} {item.text(2)} {words_for(item.data(0, _ID))}"
            item.setHidden(fuzzy_score(query, item.text(0)) is None and not words_begin(query, words))
        if (selected := self.table.currentItem()) is None or selected.isHidden():
            shown = [item for item in self._items() if not item.isHidden()]
            # Nothing that is out of sight is given a key.
            index = self.table.indexFromItem(shown[0]) if len(shown) == 1 else QModelIndex()
            self.table.setCurrentIndex(index)


def _title(action_id: str) -> str:
    return next(spec.name for spec in SPECS if spec.id == action_id)


def _row(action_id: str) -> QTreeWidgetItem:
    item = QTreeWidgetItem([_title(action_id), menu_of(action_id), ""])
    item.setData(0, _ID, action_id)
    item.setForeground(1, QColor(style.WEAK))
    return item
