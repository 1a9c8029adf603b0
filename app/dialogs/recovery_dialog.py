"""The recovery dialog: what sessions left that ended without closing, with pictures and what would come back."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QIcon, QImage, QPixmap
from PySide6.QtWidgets import (
    QDialog,
    QHBoxLayout,
    QLabel,
    QListWidget,
    QListWidgetItem,
    QPushButton,
    QVBoxLayout,
    QWidget,
)

from .. import style
from ..jobs.thumbnails import empty_picture
from ..journal.recovery import Recovery
from ..translation import N_, tr
from ..widgets.controls import weak_label

PICTURE = QSize(128, 72)
FATES = {
    "saved": N_("saved"),
    "discarded": N_("thrown away"),
    "recovered": N_("recovered"),
    "declined": N_("not to be offered"),
}
"""What became of work that is settled, as a row says it."""


class RecoveryDialog(QDialog):
    """A list to choose one from. Whatever is answered, the journals stay.

    Signals
    -------
    chosen(recovery) : it is to be opened.
    declined(recovery) : it is not to be offered again by itself.
    """

    chosen = Signal(object)
    declined = Signal(object)

    def __init__(self, found: list[Recovery], parent: QWidget | None = None, *, is_asked_for: bool = False) -> None:
        super().__init__(parent)
        self._found = list(found)
        self.setWindowTitle(tr("Recover work"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(560, 400)
        self.list = QListWidget()
        self.list.setIconSize(PICTURE)
        self.list.setSpacing(2)
        self.list.setWordWrap(True)
        self.list.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.list.setResizeMode(QListWidget.ResizeMode.Adjust)
        for each in found:
            self.list.addItem(_row(each))
        self.recover, self.decline, self.later = (
            QPushButton(word) for word in (tr("Recover"), tr("Do not offer again"), "")
        )
        self.later.setText(tr("Close") if is_asked_for else tr("Later"))
        self.decline.setVisible(not is_asked_for)
        self.decline.setToolTip(tr("It stays, and is found under File > Recover work…"))
        self._lay_out(is_asked_for)
        self.recover.clicked.connect(self._choose)
        self.decline.clicked.connect(self._decline)
        self.later.clicked.connect(self.reject)
        self.list.itemActivated.connect(lambda _: self._choose())
        self.list.currentRowChanged.connect(lambda row: self.recover.setEnabled(row >= 0))
        self.recover.setEnabled(False)
        self.list.setCurrentRow(0)

    def show_picture(self, recovery: Recovery, picture: QImage) -> None:
        """Put the picture of one of them into its row."""
        if recovery in self._found:
            item = self.list.item(self._found.index(recovery))
            item.setIcon(QIcon(QPixmap.fromImage(picture)))

    # ---- the rest is private

    def _lay_out(self, is_asked_for: bool) -> None:
        title = QLabel(tr("Work that is in no file") if is_asked_for else tr("ROAM did not close properly"))
        title.setObjectName("heading")
        buttons = QHBoxLayout()
        buttons.addWidget(self.decline)
        buttons.addStretch(1)
        buttons.addWidget(self.later)
        buttons.addWidget(self.recover)
        self.recover.setDefault(True)
        column = QVBoxLayout(self)
        column.setContentsMargins(*(2 * style.MARGIN,) * 4)
        column.setSpacing(style.MARGIN)
        column.addWidget(title)
        column.addWidget(weak_label(tr("Your own files are not changed until you save. What you leave here stays.")))
        column.addWidget(self.list, 1)
        column.addLayout(buttons)

    def _choose(self) -> None:
        if (row := self.list.currentRow()) >= 0:
            recovery = self._found[row]
            self.accept()
            self.chosen.emit(recovery)

    def _decline(self) -> None:
        if (row := self.list.currentRow()) >= 0:
            self.declined.emit(self._found.pop(row))
            self.list.takeItem(row)
        if not self._found:
            self.reject()


def _row(recovery: Recovery) -> QListWidgetItem:
    """Picture, name, what would come back, and when it was."""
    fate = f" · {tr(FATES.get(recovery.settled, recovery.settled))}" if recovery.settled else ""
    item = QListWidgetItem(f"{recovery.name}\n{recovery.sentence}\n{recovery.day}{fate}")
    item.setIcon(QIcon(empty_picture(PICTURE)))
    item.setToolTip(str(recovery.original or recovery.journal))
    return item
