"""The shapes panel: the tree of layers and shapes, the top-most on top."""

from __future__ import annotations

from collections.abc import Iterator

from PySide6.QtCore import QItemSelectionModel, QModelIndex, QPoint, QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QContextMenuEvent, QDropEvent, QFocusEvent, QKeyEvent, QMouseEvent
from PySide6.QtWidgets import (
    QAbstractItemDelegate,
    QAbstractItemView,
    QHeaderView,
    QLabel,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from roam_core.errors import RoamError
from roam_core.roto import Layer, RotoShape, edit
from roam_core.roto.layers import moved, top_items

from .. import style
from ..actions.context import IN_LIST, Place
from ..actions.keymaps import told
from ..actions.viewer_actions import ActionsById
from ..features.verbs.shapes import ALL_LOCKED, NOTHING_SELECTED, delete, toggle
from ..features.verbs.solo import switch_solo
from ..model.document import Document
from ..model.reasons import outdated_by
from ..model.view_state import ViewState
from ..translation import N_, sentence_of, tr
from .shape_rows import EYE, ID, IS_LAYER, LOCK, NAME, SOLO, dress_row, dress_solo, meant_row, summary, type_name
from .shape_search import Found, SearchField, found_in

SWITCHES = SOLO, EYE, LOCK
LEAST_ROWS, MOST_ROWS = 4, 9
EMPTY = N_("Draw a shape: press <tool.bezier> in the viewer,\nclick for corners, drag for curves.")
NO_CLIP = N_("Open a clip first: drop a folder of\nimages or a movie on the window.")


class ShapesPanel(QWidget):
    """The tree, in which the keys of `actions` on its rows work; and what to do when it is empty."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        actions: ActionsById | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view = document, view_state
        self.tree = ShapeTree(document, view_state)
        if actions is not None:
            self.tree.addActions([actions[name] for name in IN_LIST])
        self._hint = QLabel()
        self._hint.setObjectName("weak")
        self._hint.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.search, self.beside = SearchField(self.tree), QLabel()
        self.beside.setObjectName("weak")
        self.beside.setContentsMargins(style.MARGIN, 0, style.MARGIN, 0)
        self.beside.setWordWrap(True)
        self.search.textChanged.connect(self.tree.search)
        self.search.entered.connect(self.tree.enter)
        self.tree.searched.connect(self._tell_search)
        column = QVBoxLayout(self)
        column.setContentsMargins(0, 0, 0, 0)
        self.setMinimumHeight(5 * style.ROW_HEIGHT)
        column.addWidget(self.search)
        column.addWidget(self.tree)
        column.addWidget(self.beside)
        column.addWidget(self._hint, 1)
        document.changed.connect(self._pull)
        document.replaced.connect(self.search.clear)
        document.replaced.connect(self._pull)
        view_state.keymap_changed.connect(self._pull)
        self._pull()

    def rename(self) -> None:
        """Let the name of what is selected be typed in its row; of several rows it is the one that keys mean."""
        if self.tree.selected_beside:
            self.search.clear()
        if (row := meant_row(self.tree)) is None:
            self._view.say(tr(NOTHING_SELECTED))
        elif not row.flags() & Qt.ItemFlag.ItemIsEditable:
            self._view.say(tr(ALL_LOCKED))
        else:
            type_name(self.tree, row)

    def _pull(self, _ids: object = None) -> None:
        is_empty = not self._document.project.root.children
        self._hint.setVisible(is_empty)
        self._hint.setText(tr(NO_CLIP) if self._document.project.clip is None else told(tr(EMPTY), self._view.keymap))
        for part in (self.tree, self.search):
            part.setVisible(not is_empty)
        self._tell_search()

    def _tell_search(self) -> None:
        """What a search leaves out is told: that it finds nothing, or that more is selected than the list shows."""
        sentence = ""
        if self.search.text().strip() and not self._document.project.root.children:
            self.search.clear()
        elif not self.tree.found.rows and self.search.text().strip():
            sentence = tr("No shape or layer is called that.")
        elif count := len(self.tree.selected_beside):
            sentence = tr("%n selected row(s) is/are not in this list.", "", count)
        self.beside.setText(sentence)
        self.beside.setVisible(bool(sentence))


class ShapeTree(QTreeWidget):
    """Rows of the tree; selection goes both ways. Drag a row to restack it, double-click its name to rename it.

    Signals
    -------
    menu_asked(place, where) : a right click on that `Place`, at this place of the screen; its row is selected.
    searched() : another search, or what it finds or leaves out of the selection may be another.
    """

    menu_asked = Signal(object, QPoint)
    searched = Signal()

    def __init__(self, document: Document, view_state: ViewState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._view = document, view_state
        self._shown: object = None
        self._is_pushing = self._is_switching = False
        self._text, self._folded_before = "", frozenset[str]()
        self.found = Found()
        """What the search leaves in sight; all where nothing is searched for."""
        self._dress()
        self.itemSelectionChanged.connect(self._push_selection)
        self.itemChanged.connect(self._push_name)
        document.changed.connect(self._pull)
        document.replaced.connect(self._begin_anew)
        view_state.selection_changed.connect(self._follow_selection)
        view_state.solo.changed.connect(self._pull_solo)
        self._pull()

    def _dress(self) -> None:
        self.setColumnCount(4)
        self.setHeaderHidden(True)
        self.setIndentation(16)
        self.setIconSize(style.ICON_SIZE)
        self.setUniformRowHeights(True)
        self.setSelectionMode(QAbstractItemView.SelectionMode.ExtendedSelection)
        self.setDragDropMode(QAbstractItemView.DragDropMode.InternalMove)
        self.setEditTriggers(QAbstractItemView.EditTrigger.DoubleClicked | QAbstractItemView.EditTrigger.EditKeyPressed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        header = self.header()
        header.setStretchLastSection(False)
        header.setMinimumSectionSize(24)
        header.setSectionResizeMode(NAME, QHeaderView.ResizeMode.Stretch)
        for column in SWITCHES:
            header.setSectionResizeMode(column, QHeaderView.ResizeMode.Fixed)
            header.resizeSection(column, 26)

    def sizeHint(self) -> QSize:
        """As high as its rows ask for, within bounds: what the tree leaves, the panels below it need.

        A search changes no height.
        """
        count = sum(1 for _ in self._document.project.root.items())
        rows = min(max(count, LEAST_ROWS), MOST_ROWS)
        return QSize(super().sizeHint().width(), rows * style.ROW_HEIGHT)

    def item(self, item_id: str) -> QTreeWidgetItem:
        """The row of a layer or shape."""
        return next(row for row in self._rows() if row.data(NAME, ID) == item_id)

    # ---- searching

    def search(self, text: str) -> None:
        """List only what is called so, unfolded; "" lists all again, folded as it was before."""
        text = text.strip()
        if text == self._text:
            return
        if not self._text:
            self._folded_before = self._folded()
        self._text = text
        self._build(frozenset() if text else self._folded_before)
        if not text:
            self._follow_selection()

    @property
    def selected_beside(self) -> frozenset[str]:
        """What is selected, but left out by the search."""
        return (self._view.selection.shapes | self._view.layers) - self.found.rows

    def enter(self) -> None:
        """Take the keyboard, at the first row that can be selected where none is."""
        rows = [row for row in self._rows() if row.flags() & Qt.ItemFlag.ItemIsSelectable]
        if rows and not self.selectedItems():
            self.setCurrentItem(rows[0])
        if rows:
            self.setFocus(Qt.FocusReason.ShortcutFocusReason)

    def focusInEvent(self, event: QFocusEvent) -> None:
        """With the keyboard in the list keys mean its rows: what the search leaves out is let go."""
        super().focusInEvent(event)
        unasked = (
            Qt.FocusReason.MouseFocusReason,
            Qt.FocusReason.PopupFocusReason,
            Qt.FocusReason.ActiveWindowFocusReason,
        )
        if event.reason() not in unasked and self.selected_beside:
            self._push_selection()

    # ---- from the document

    def _pull(self, _ids: object = None) -> None:
        """Build the rows again, but only if what they show has changed: a tracked frame changes no row.

        While a name is being typed they stay: its field belongs to one of them.
        """
        if self.state() is QAbstractItemView.State.EditingState:
            return
        if (shown := summary(self._document.project.root)) != self._shown:
            self._shown = shown
            self._build()

    def _folded(self) -> frozenset[str]:
        return frozenset(row.data(NAME, ID) for row in self._rows() if row.childCount() and not row.isExpanded())

    def _build(self, folded: frozenset[str] | None = None) -> None:
        """Make the rows of what is searched for; `folded` are the layers that are, or those that are now."""
        self.updateGeometry()
        closed = self._folded() if folded is None else folded
        self.found = found_in(self._document.project.root, self._text)
        held = self.currentItem()
        current = None if held is None else held.data(NAME, ID)
        with QSignalBlocker(self):
            self.clear()
            self._add_rows(self.invisibleRootItem(), self._document.project.root)
            for row in self._rows():
                row.setExpanded(row.childCount() > 0 and row.data(NAME, ID) not in closed)
        self._pull_solo()
        self._pull_selection()
        self.searched.emit()
        self.setAutoScroll(False)  # where the artist looks is kept
        self._set_current(next((row for row in self._rows() if row.data(NAME, ID) == current), None))
        self.setAutoScroll(True)

    def _add_rows(self, parent: QTreeWidgetItem, layer: Layer) -> None:
        for child in reversed(layer.children):
            if child.id not in self.found.rows:
                continue
            row = QTreeWidgetItem(parent)
            dress_row(row, child)
            if self._document.project.is_locked(child.id):
                row.setFlags(row.flags() & ~Qt.ItemFlag.ItemIsEditable)
            if child.id in self.found.holders:  # selected it would stand for all in it
                row.setFlags(row.flags() & ~(Qt.ItemFlag.ItemIsSelectable | Qt.ItemFlag.ItemIsDragEnabled))
            if isinstance(child, Layer):
                self._add_rows(row, child)

    def _begin_anew(self) -> None:
        """Another project: its layers are not those that were selected, whatever they are called.

        Nor is what is being typed the name of anything in it.
        """
        self._view.select(frozenset(), layers=frozenset())
        self._shown = summary(self._document.project.root)
        self._build()

    def _pull_solo(self) -> None:
        """Rows of what is shown are as ever; those of what is hidden, or left out by solo, are dim."""
        seen, soloed = self._view.solo.seen(self._document.project), self._view.solo.ids
        with QSignalBlocker(self):
            for row in self._rows():
                item_id = row.data(NAME, ID)
                is_dim = item_id in self.found.holders or (seen.has(item_id) and not seen.find(item_id).visible)
                dress_solo(row, is_on=item_id in soloed, is_dim=is_dim)
        self.viewport().update()

    def _pull_selection(self) -> None:
        selected = self._view.selection.shapes | self._view.layers
        with QSignalBlocker(self):
            for row in self._rows():
                row.setSelected(row.data(NAME, ID) in selected)
        self.viewport().update()

    def _follow_selection(self) -> None:
        """Mark what is selected; where it was selected elsewhere, bring a row of it into sight: keys, as F2, mean it.

        A folded layer stays so: then it is the layer's row that comes into sight. Of a selected layer and what lies in
        it the layer is meant: F2 names one that was just made.
        """
        self._pull_selection()
        self.searched.emit()
        chosen = [row for row in self._rows() if row.isSelected() and not _is_in_selected(row)]
        if self._is_pushing or not chosen:
            return
        in_sight = [row for row in chosen if self.viewport().rect().intersects(self.visualItemRect(row))]
        row = (in_sight or [row for row in chosen if _folded_above(row) is None] or chosen)[0]
        folded = _folded_above(row)
        current = self.currentItem()
        if current is None or not current.isSelected() or _is_in_selected(current) or folded is not None:
            self._set_current(row if folded is None else None)
        if not in_sight:
            self.scrollToItem(folded or row)

    def _set_current(self, row: QTreeWidgetItem | None) -> None:
        """Let keys begin at a row, with what is selected as it is."""
        index = QModelIndex() if row is None else self.indexFromItem(row)
        self.selectionModel().setCurrentIndex(index, QItemSelectionModel.SelectionFlag.NoUpdate)

    # ---- to the document

    def _push_selection(self) -> None:
        rows = self.selectedItems()
        shapes = frozenset[str]().union(*(self._covered(row) for row in rows))
        self._is_pushing = True
        self._view.select(shapes, layers=frozenset(row.data(NAME, ID) for row in rows if row.data(NAME, IS_LAYER)))
        self._is_pushing = False

    def _push_name(self, row: QTreeWidgetItem, column: int) -> None:
        name, item_id = row.text(NAME).strip(), row.data(NAME, ID)
        if column == NAME and name and self._document.project.has(item_id):  # a run may take a part away meanwhile
            project = edit.set_properties(self._document.project, item_id, name=name)
            self._document.apply(tr("Rename"), project)
        self._shown = None
        self._pull()

    def closeEditor(self, editor: QWidget, hint: QAbstractItemDelegate.EndEditHint) -> None:
        super().closeEditor(editor, hint)
        self._pull()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """On solo, eye or lock: switch it, and those of all selected rows with it; what is selected stays so."""
        spot = event.position().toPoint()
        row, column = self.itemAt(spot), self.columnAt(spot.x())
        self._is_switching = row is not None and column in SWITCHES
        if row is None or column not in SWITCHES or event.button() is not Qt.MouseButton.LeftButton:
            super().mousePressEvent(event)
            if row is not None and self.selected_beside:
                self._push_selection()
            return
        pressed = row.data(NAME, ID)
        others = [item_id for item_id in self.selected_ids() if item_id != pressed] if row.isSelected() else []
        if column == SOLO:
            switch_solo(self._document, self._view, pressed, others)
        else:
            toggle(self._document, "visible" if column == EYE else "locked", [pressed, *others])

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """A press on a switch begins no drag, and selects nothing on its way."""
        if not (self._is_switching and event.buttons()):
            super().mouseMoveEvent(event)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Two quick presses on one of these are two presses."""
        if self.columnAt(event.position().toPoint().x()) in SWITCHES:
            self.mousePressEvent(event)
        else:
            super().mouseDoubleClickEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """The press before it has selected its row, unless that was selected."""
        row = self.itemAt(event.pos())
        if row is None:
            place = Place.EMPTY_LIST
        else:
            place = Place.LAYER_ROW if row.data(NAME, IS_LAYER) else Place.SHAPE_ROW
        self.menu_asked.emit(place, event.globalPos())

    def selected_ids(self) -> list[str]:
        """The ids of the selected rows, layers included, bottom first; one inside a selected layer is left to it."""
        return top_items(self._document.project, [row.data(NAME, ID) for row in self.selectedItems()])

    def delete_selected(self) -> None:
        """Delete the layers and shapes of the selected rows."""
        delete(self._document, self._view, self.selected_ids())

    def keyboardSearch(self, _search: str) -> None:
        """Letters are keys, as in the viewer: they select no row whose name begins with them."""

    def keyPressEvent(self, event: QKeyEvent) -> None:
        if event.key() in (Qt.Key.Key_Delete, Qt.Key.Key_Backspace):
            self.delete_selected()
        else:
            super().keyPressEvent(event)

    def dropEvent(self, event: QDropEvent) -> None:
        """Restack in the document; the rows follow from it."""
        target = self.itemAt(event.position().toPoint())
        event.setDropAction(Qt.DropAction.IgnoreAction)
        event.accept()
        project = self._document.project
        try:
            after = moved(project, self.selected_ids(), *self._place(target))
        except RoamError as error:
            self._view.say(sentence_of(error))
            return
        outdated = outdated_by(project, after)
        self._document.apply(tr("Restack"), after)
        if outdated:
            self._view.say(outdated)

    def _place(self, target: QTreeWidgetItem | None) -> tuple[str, int]:
        """The layer and the index in it (0 = bottom) that a drop means; below all rows: right below the last one."""
        root = self._document.project.root
        if target is None:
            last = self.topLevelItem(self.topLevelItemCount() - 1)
            lowest = "" if last is None else last.data(NAME, ID)
            return root.id, next((index for index, child in enumerate(root.children) if child.id == lowest), 0)
        item = self._document.project.find(target.data(NAME, ID))
        where = self.dropIndicatorPosition()
        if where == QAbstractItemView.DropIndicatorPosition.OnItem and isinstance(item, Layer):
            return item.id, len(item.children)
        parent = target.parent()
        layer = root if parent is None else self._document.project.find(parent.data(NAME, ID))
        assert isinstance(layer, Layer)
        below = where is QAbstractItemView.DropIndicatorPosition.BelowItem
        if below and isinstance(item, Layer) and target.isExpanded():
            return item.id, len(item.children)  # right below an open layer's row is its inside
        return layer.id, [child.id for child in layer.children].index(item.id) + (0 if below else 1)

    # ---- rows

    def _rows(self) -> Iterator[QTreeWidgetItem]:
        waiting = [self.topLevelItem(index) for index in range(self.topLevelItemCount())]
        while waiting:
            row = waiting.pop(0)
            if row is not None:
                yield row
                waiting.extend(row.child(index) for index in range(row.childCount()))

    def _covered(self, row: QTreeWidgetItem) -> frozenset[str]:
        """The shapes that a row stands for: itself, or all in the layer; none when it is about to go."""
        if not self._document.project.has(row.data(NAME, ID)):
            return frozenset()
        item = self._document.project.find(row.data(NAME, ID))
        return frozenset({item.id} if isinstance(item, RotoShape) else (shape.id for shape in item.shapes()))


def _folded_above(row: QTreeWidgetItem) -> QTreeWidgetItem | None:
    """The outermost folded layer's row that a row lies in, or None."""
    found, parent = None, row.parent()
    while parent is not None:
        found, parent = (found if parent.isExpanded() else parent), parent.parent()
    return found


def _is_in_selected(row: QTreeWidgetItem) -> bool:
    """Whether a layer around a row is selected."""
    parent = row.parent()
    return parent is not None and (parent.isSelected() or _is_in_selected(parent))
