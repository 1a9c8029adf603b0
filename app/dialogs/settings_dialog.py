"""The settings dialog: what holds for all projects; every change holds at once, or from the next start on."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt, Signal
from PySide6.QtGui import QKeyEvent, QKeySequence, QShowEvent
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QFormLayout,
    QHBoxLayout,
    QLabel,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from roam_core.params import CONFIGS

from .. import style
from ..actions.keymaps import OwnKeymap, presets
from ..model.personal import Personal
from ..model.preferences import (
    LEAST_CACHE,
    LEAST_UNDO,
    MOST_BACKUPS,
    MOST_CACHE,
    MOST_PROCESSES,
    MOST_THREADS,
    MOST_UNDO,
    SCALES,
    Preferences,
)
from ..translation import LANGUAGES, SYSTEM, tr
from ..widgets.controls import dense_form, weak_label
from ..widgets.number_boxes import DecimalBox, WholeBox

LABEL_WIDTH, FIELD_WIDTH = 150, 150


class SettingsDialog(QDialog):
    """One form. Each control is a pair: what it pulls from the preferences, and what it pushes into them.

    Signals
    -------
    keys_asked() : the artist wants to change single keys.
    """

    keys_asked = Signal()

    def __init__(self, personal: Personal, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._personal = personal
        self.setWindowTitle(tr("Settings"))
        self._build()
        self._lay_out()
        self._pull()
        self._connect()

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self.cache.setFocus()
        self.cache.selectAll()  # what is typed at once replaces the number

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.matches(QKeySequence.StandardKey.Cancel):
            self._pull()  # a number that is half typed is dropped; losing the focus would take it
        super().keyPressEvent(event)

    # ---- building

    def _build(self) -> None:
        self.cache = DecimalBox()
        self.cache.setRange(LEAST_CACHE, MOST_CACHE)
        self.cache.setSingleStep(0.5)
        self.cache.setDecimals(2)
        self.cache.setSuffix(tr(" GB"))
        self.threads, self.processes, self.backups, self.undo = (WholeBox() for _ in range(4))
        self.threads.setRange(0, MOST_THREADS)
        self.threads.setSpecialValueText(tr("As many as there are"))
        self.processes.setRange(0, MOST_PROCESSES)
        self.processes.setSpecialValueText(tr("One for two cores"))
        self.backups.setRange(0, MOST_BACKUPS)
        self.backups.setSpecialValueText(tr("None"))
        self.undo.setRange(LEAST_UNDO, MOST_UNDO)
        self.undo.setSingleStep(64)
        self.undo.setSuffix(tr(" MB"))
        self.config, self.preset, self.scale, self.language = (QComboBox() for _ in range(4))
        self.config.addItem(tr("The one used last"), "")
        for name in CONFIGS:
            self.config.addItem(name.replace("_", " ").capitalize(), name)
        for name, title in presets().items():
            self.preset.addItem(title, name)
        for scale in SCALES:
            self.scale.addItem(f"{100 * scale:.0f} %", scale)
        self.language.addItem(tr("As the desktop"), SYSTEM)
        for code, name in LANGUAGES.items():
            self.language.addItem(name, code)
        self.change_keys = QPushButton(tr("Change keys…"))
        self.change_keys.setAutoDefault(False)
        self.asks = QCheckBox(tr("Show what was found before a clip opens"))
        self.asks.setToolTip(tr("Holding Alt while dropping a clip opens it without a question"))
        self.reset, self.leave = QPushButton(tr("Defaults")), QPushButton(tr("Close"))
        self.reset.setToolTip(tr("All settings as they were at first; keys stay"))
        for button in (self.reset, self.leave):
            button.setAutoDefault(False)
        lists = self.config, self.preset, self.scale, self.language
        for widget in (self.cache, self.threads, self.processes, self.backups, self.undo, *lists):
            widget.setFixedWidth(FIELD_WIDTH)
        for number in (self.cache, self.threads, self.processes, self.backups, self.undo):
            number.setAlignment(Qt.AlignmentFlag.AlignRight)
            number.setKeyboardTracking(False)  # a number that is half typed is none, and is not written over

    def _lay_out(self) -> None:
        form = dense_form()
        _row(form, tr("Memory for frames"), self.cache, tr("More keeps more of a clip ready to play"))
        _row(form, tr("Threads"), self.threads, tr("For decoding pictures and for the engine"))
        _row(form, tr("Processes"), self.processes, tr("For filling many frames; 1: ROAM itself does it all"))
        _row(form, tr("Memory for undo"), self.undo, tr("The oldest steps go first"))
        _row(form, tr("Backups"), self.backups, tr("Older versions of a project, kept beside it when you save"))
        _row(form, tr("Mode at the start"), self.config, tr("How the engine works"))
        _row(form, tr("Keys", "of the keyboard"), self.preset, None, self.change_keys)
        _row(form, tr("Size on the screen"), self.scale, tr("From the next start on"))
        _row(form, tr("Language"), self.language, tr("From the next start on"))
        _row(form, tr("Clips"), self.asks, None)
        buttons = QHBoxLayout()
        buttons.addWidget(self.reset)
        buttons.addStretch(1)
        buttons.addWidget(self.leave)
        column = QVBoxLayout(self)
        column.setContentsMargins(2 * style.MARGIN, 2 * style.MARGIN, 2 * style.MARGIN, style.MARGIN)
        column.setSpacing(2 * style.MARGIN)
        column.addLayout(form)
        column.addStretch(1)
        column.addLayout(buttons)

    def _connect(self) -> None:
        self.cache.valueChanged.connect(lambda value: self._push(cache_gigabytes=value))
        self.threads.valueChanged.connect(lambda value: self._push(threads=value))
        self.processes.valueChanged.connect(lambda value: self._push(processes=value))
        self.backups.valueChanged.connect(lambda value: self._push(backups=value))
        self.undo.valueChanged.connect(lambda value: self._push(undo_megabytes=value))
        self.config.currentIndexChanged.connect(lambda _: self._push(config=self.config.currentData()))
        self.scale.currentIndexChanged.connect(lambda _: self._push(scale=self.scale.currentData()))
        self.language.currentIndexChanged.connect(lambda _: self._push(language=self.language.currentData()))
        self.asks.toggled.connect(lambda on: self._push(asks_about_clips=on))
        self.preset.currentIndexChanged.connect(lambda _: self._push_preset())
        self.change_keys.clicked.connect(self.keys_asked)
        self.reset.clicked.connect(lambda: self._personal.set_preferences(Preferences()))
        self.leave.clicked.connect(self.close)
        self._personal.preferences_changed.connect(self._pull)
        self._personal.keys_changed.connect(self._pull)

    # ---- pushing and pulling

    def _push(self, **changes: Any) -> None:
        self._personal.set_preferences(replace(self._personal.preferences, **changes))

    def _push_preset(self) -> None:
        self._personal.set_keys(OwnKeymap(self.preset.currentData(), self._personal.keys.keys))

    def _pull(self) -> None:
        held = self._personal.preferences
        numbers = self.cache, self.threads, self.processes, self.backups, self.undo
        fields = (*numbers, self.config, self.scale, self.language, self.preset, self.asks)
        for field in fields:
            field.blockSignals(True)
        self.cache.setValue(held.cache_gigabytes)
        self.threads.setValue(held.threads)
        self.processes.setValue(held.processes)
        self.backups.setValue(held.backups)
        self.undo.setValue(held.undo_megabytes)
        self.config.setCurrentIndex(self.config.findData(held.config))
        self.scale.setCurrentIndex(_nearest(held.scale))
        self.language.setCurrentIndex(self.language.findData(held.language))
        self.preset.setCurrentIndex(self.preset.findData(self._personal.keys.preset))
        self.asks.setChecked(held.asks_about_clips)
        for field in fields:
            field.blockSignals(False)


def _nearest(scale: float) -> int:
    """The place of the scale that comes closest."""
    return min(range(len(SCALES)), key=lambda place: abs(SCALES[place] - scale))


def _row(form: QFormLayout, title: str, field: QWidget, word: str | None, *more: QWidget) -> None:
    """A label, a field, and a weak word about it."""
    label = QLabel(title)
    field.setAccessibleName(title)
    label.setMinimumWidth(LABEL_WIDTH)
    row = QHBoxLayout()
    row.setSpacing(style.MARGIN)
    for widget in (field, *more, *([] if word is None else [weak_label(word)])):
        row.addWidget(widget)
    row.addStretch(1)
    form.addRow(label, row)
