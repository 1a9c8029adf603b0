"""The review panel: the note of this frame, and a list to go through: notes, doubtful frames, frames that boil."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum

from PySide6.QtCore import QEvent, Qt, QTimer, Signal
from PySide6.QtGui import QFocusEvent, QKeyEvent, QShowEvent
from PySide6.QtWidgets import (
    QHeaderView,
    QPlainTextEdit,
    QToolButton,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from roam_core.review.findings import FindingKind, boiling_frames, doubtful
from roam_core.roto import timing

from .. import style
from ..actions.actions import Actions
from ..features.boil import boil_of_document
from ..model.document import Document
from ..model.view_state import ViewState, shapes_in_hand
from ..translation import N_, tr
from ..widgets.controls import ChoiceBox, tool_button, weak_label
from ..widgets.focus import KEEPS_KEYBOARD, takes_key

LIST_ROWS, NOTE_ROWS = 8, 3
"""Heights in rows of the list and of the note."""


class Listed(StrEnum):
    """Why a frame is in the list."""

    NOTE = "note"
    DOUBT = "doubt"
    BOIL = "boil"


CHOICES: dict[str, tuple[str, frozenset[Listed]]] = {
    "all": (N_("Notes, doubts and boil"), frozenset(Listed)),
    "notes": (N_("Notes"), frozenset({Listed.NOTE})),
    "doubts": (N_("Doubtful frames"), frozenset({Listed.DOUBT})),
    "boil": (N_("Boil"), frozenset({Listed.BOIL})),
}
"""What the list may show, by name: its title and kinds."""
NOTHING = N_("Nothing to list: no notes, no doubtful frames and none that boil, of the shapes in hand.")


@dataclass(frozen=True)
class Entry:
    """A row of the list: a frame, why it is there, what is said of it; `shape` is the one that is meant, by its id."""

    frame: int
    kind: Listed
    text: str
    value: str = ""
    shape: str = ""


class ReviewPanel(QWidget):
    """The list is of the shapes in hand: the selected ones, all where none is. A click on a row goes there."""

    def __init__(
        self, document: Document, view_state: ViewState, actions: Actions, parent: QWidget | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._boil = document, view_state, boil_of_document(document)
        self._entries: list[Entry] = []
        self._is_due, self._sitting = False, document.sitting
        self.note = NoteField()
        self.kinds = ChoiceBox(tr("What the list shows"))
        for name, (title, _) in CHOICES.items():
            self.kinds.addItem(tr(title), name)
        self.list = _tree()
        self.count = weak_label("")
        self.count.setWordWrap(True)
        self.tools = tuple(_worded(tool_button(actions, name)) for name in ("review.movie", "review.sheet"))
        self._lay_out()
        self.note.written.connect(self._write)
        self.kinds.currentIndexChanged.connect(lambda _: self._pull_list())
        self.list.itemClicked.connect(lambda item, _: self._go(item))
        self.list.walked.connect(self._go)
        for signal in (document.changed, document.replaced, view_state.selection_changed, self._boil.changed):
            signal.connect(self._pull_soon)
        view_state.frame_changed.connect(self._pull_frame)
        self._pull_list()

    @property
    def entries(self) -> list[Entry]:
        """What is listed, in the order of time."""
        return self._entries

    # ---- the rest is private

    def _lay_out(self) -> None:
        column = QVBoxLayout(self)
        column.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        column.setSpacing(4)
        for part in (self.note, self.kinds, self.list, self.count):
            column.addWidget(part)

    def _write(self, frame: int, text: str) -> None:
        """Put a note on a frame; an emptied one goes away with its mark."""
        project = self._document.project
        mark = timing.mark_at(project, frame)
        if text == (mark.text if mark is not None else ""):
            return
        if project.clip is None:
            self._view.say(tr("Open a clip first: notes lie on its frames."))
        elif text:
            self._document.apply(tr("Write note"), timing.set_mark(project, frame, text))
        else:
            self._document.apply(tr("Remove note"), timing.remove_mark(project, frame))

    def _go(self, item: QTreeWidgetItem) -> None:
        entry = self._entries[self.list.indexOfTopLevelItem(item)]
        self._view.set_frame(entry.frame)
        if entry.shape:
            place = {"frame": entry.frame, "text": entry.text, "value": entry.value}
            self._view.say_here(tr("Frame {frame}: {text}, {value}.", **place))

    def showEvent(self, event: QShowEvent) -> None:
        super().showEvent(event)
        self._pull_list()

    def _pull_soon(self, _ids: object = None) -> None:
        """Once for all that changes at one time, and not while nobody looks."""
        self._pull_note()
        if not self._is_due and self.isVisible():
            self._is_due = True
            QTimer.singleShot(0, self, self._pull_list)

    def _pull_list(self) -> None:
        self._is_due = False
        self._pull_note()
        _, kinds = CHOICES[self.kinds.currentData()]
        entries = [entry for entry in self._found() if entry.kind in kinds]
        self.count.setText(_summary(entries))
        if entries != self._entries:
            self._entries = entries
            self.list.clear()
            self.list.addTopLevelItems([_row(entry) for entry in entries])
        self._pull_frame()

    def _found(self) -> list[Entry]:
        project = self._document.project
        shapes = shapes_in_hand(project, self._view.selection)
        notes = (Entry(mark.frame, Listed.NOTE, _line(mark.text) or tr("marked")) for mark in project.marks)
        boiling = (each for shape, boil in self._boil.so_far(shapes) for each in boiling_frames(shape, boil))
        found = [*doubtful(shapes), *boiling]
        worth = (
            Entry(each.frame, Listed.DOUBT, each.name, tr("{value:.2f}", value=each.value), each.shape)
            if each.kind is FindingKind.DOUBT
            else Entry(
                each.frame,
                Listed.BOIL,
                tr("{name} boils", name=each.name),
                tr("{pixels:.1f} px", pixels=each.value),
                each.shape,
            )
            for each in found
        )
        return sorted([*notes, *worth], key=lambda entry: (entry.frame, list(Listed).index(entry.kind), entry.text))

    def _pull_frame(self) -> None:
        """The rows of the present frame are the chosen ones."""
        self._pull_note()
        here = [index for index, entry in enumerate(self._entries) if entry.frame == self._view.frame]
        chosen = {index.row() for index in self.list.selectedIndexes()}
        if here and not chosen & set(here):
            self.list.setCurrentIndex(self.list.model().index(here[0], 0))
        elif not here:
            self.list.clearSelection()

    def _pull_note(self) -> None:
        if self._sitting != self._document.sitting:
            self._sitting = self._document.sitting
            self.note.forget()
        mark = timing.mark_at(self._document.project, self._view.frame)
        self.note.show_note(self._view.frame, mark.text if mark is not None else "")


class NoteField(QPlainTextEdit):
    """The note of a frame while it is typed: Ctrl+Return or leaving the field keeps it, Esc leaves what was there.

    Signals
    -------
    written(frame, text) : the note of a frame is to be this.
    """

    written = Signal(int, str)

    def __init__(self) -> None:
        super().__init__()
        self._frame, self._before = 0, ""
        self.setObjectName("noteField")
        self.setProperty(KEEPS_KEYBOARD, True)
        self.setTabChangesFocus(True)
        self.setAccessibleName(tr("Note on this frame"))
        self.setFixedHeight(NOTE_ROWS * style.ROW_HEIGHT)

    def show_note(self, frame: int, text: str) -> None:
        """Show the note of another frame; what was being typed is kept first."""
        if frame != self._frame:
            self.keep()
        if (frame, text) != (self._frame, self._before):
            self._frame, self._before = frame, text
            self.setPlainText(text)
        self.setPlaceholderText(tr("Note on frame {frame}; Ctrl+Return keeps it", frame=frame))

    def forget(self) -> None:
        """What is being typed is about another project."""
        self.setPlainText(self._before)

    def keep(self) -> None:
        """Take what is typed; a note that was not touched stays as it is, also one that ends in spaces."""
        text = self.toPlainText().strip()
        if self.document().isModified() and text != self._before:
            self._before = text
            self.written.emit(self._frame, text)

    def event(self, event: QEvent) -> bool:
        return takes_key(event) or super().event(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        is_return = event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter)
        if event.key() == Qt.Key.Key_Escape:
            self.setPlainText(self._before)
            self.clearFocus()
        elif is_return and event.modifiers() & Qt.KeyboardModifier.ControlModifier:
            self.clearFocus()
        else:
            super().keyPressEvent(event)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        super().focusOutEvent(event)
        self.keep()


class FrameList(QTreeWidget):
    """The rows of frames.

    Signals
    -------
    walked(item) : the keyboard went to another row.
    """

    walked = Signal(QTreeWidgetItem)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        before = self.currentItem()
        super().keyPressEvent(event)
        item = self.currentItem()
        if item is not None and item is not before:
            self.walked.emit(item)


def _tree() -> FrameList:
    tree = FrameList()
    tree.setColumnCount(3)
    tree.setHeaderHidden(True)
    tree.setRootIsDecorated(False)
    tree.setUniformRowHeights(True)
    tree.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
    tree.setFixedHeight(LIST_ROWS * style.ROW_HEIGHT)
    tree.setAccessibleName(tr("Frames worth a look"))
    mode = QHeaderView.ResizeMode
    tree.header().setStretchLastSection(False)
    for column, resize in enumerate((mode.ResizeToContents, mode.Stretch, mode.ResizeToContents)):
        tree.header().setSectionResizeMode(column, resize)
    return tree


def _worded(button: QToolButton) -> QToolButton:
    button.setToolButtonStyle(Qt.ToolButtonStyle.ToolButtonTextOnly)
    return button


def _row(entry: Entry) -> QTreeWidgetItem:
    item = QTreeWidgetItem([str(entry.frame), entry.text, entry.value])
    item.setTextAlignment(2, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
    item.setToolTip(1, entry.text)
    return item


def _line(text: str) -> str:
    return " ".join(text.split())


def _summary(entries: Iterable[Entry]) -> str:
    """How many frames are listed of each kind; one that several shapes are listed on is one frame."""
    count = Counter(kind for kind, _ in {(entry.kind, entry.frame) for entry in entries})
    notes, doubts, boils = count[Listed.NOTE], count[Listed.DOUBT], count[Listed.BOIL]
    said = (
        tr("%n note(s)", "", notes) if notes else "",
        tr("%n doubtful frame(s)", "", doubts) if doubts else "",
        tr("%n boiling frame(s)", "", boils) if boils else "",
    )
    return ", ".join(filter(None, said)) or tr(NOTHING)
