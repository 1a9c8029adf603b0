"""What the rows of the list of shapes show: a mark, the name, and the switches solo, eye and lock."""

from __future__ import annotations

from PySide6.QtCore import QItemSelectionModel, Qt
from PySide6.QtGui import QBrush, QColor, QIcon
from PySide6.QtWidgets import QAbstractItemView, QTreeWidget, QTreeWidgetItem

from roam_core.roto import Layer, RotoShape

from .. import style
from ..translation import tr

NAME, SOLO, EYE, LOCK = 0, 1, 2, 3
ID, IS_LAYER = Qt.ItemDataRole.UserRole, Qt.ItemDataRole.UserRole + 1


def dress_row(row: QTreeWidgetItem, item: Layer | RotoShape) -> None:
    row.setText(NAME, item.name)
    row.setData(NAME, ID, item.id)
    row.setData(NAME, IS_LAYER, isinstance(item, Layer))
    row.setIcon(NAME, _mark(item))
    # What is usual is quiet; what keeps a shape from being seen or edited stands out.
    row.setIcon(EYE, _drawing("eye", style.WEAK) if item.visible else _drawing("eye-off", style.TEXT))
    row.setIcon(LOCK, _drawing("lock", style.TEXT) if item.locked else _drawing("lock-open", style.WEAK))
    row.setToolTip(EYE, tr("Show or hide"))
    row.setToolTip(SOLO, tr("Show alone, or with the others again"))
    row.setToolTip(LOCK, tr("Lock or unlock"))
    flag = Qt.ItemFlag
    drops = flag.ItemIsDropEnabled if isinstance(item, Layer) else flag.NoItemFlags
    row.setFlags(flag.ItemIsSelectable | flag.ItemIsEnabled | flag.ItemIsEditable | flag.ItemIsDragEnabled | drops)


def dress_solo(row: QTreeWidgetItem, *, is_on: bool, is_dim: bool) -> None:
    """Whether a row is soloed, and whether its name is dim: of what is hidden, not soloed or not searched for."""
    row.setForeground(NAME, QBrush(QColor(style.DISABLED if is_dim else style.TEXT)))
    row.setIcon(SOLO, _drawing("solo", style.ACCENT) if is_on else _drawing("solo-off", style.DISABLED))


def _mark(item: Layer | RotoShape) -> QIcon:
    """What stands before a name: a shape's colour, a folder, a folder that moves."""
    if isinstance(item, RotoShape):
        return style.swatch(item.colour)
    return _drawing("layer", style.WEAK) if item.transform is None else _drawing("layer-moving", style.TEXT)


def _drawing(name: str, colour: str) -> QIcon:
    """An icon that looks the same on open and closed rows."""
    return style.icon(name, colour, lit=colour)


def summary(layer: Layer) -> tuple[object, ...]:
    """Everything that the rows show of a layer."""
    plain = (layer.id, layer.name, layer.visible, layer.locked, layer.transform is None)
    children = (
        summary(child)
        if isinstance(child, Layer)
        else (child.id, child.name, child.visible, child.locked, child.colour)
        for child in layer.children
    )
    return (plain, *children)


def meant_row(tree: QTreeWidget) -> QTreeWidgetItem | None:
    """The selected row that keys mean, or None."""
    current = tree.currentItem()
    return current if current is not None and current.isSelected() else next(iter(tree.selectedItems()), None)


def type_name(tree: QTreeWidget, row: QTreeWidgetItem) -> None:
    """Open the field for the name of a row, as a double click does; selected stays what is."""
    tree.setFocus(Qt.FocusReason.ShortcutFocusReason)
    tree.scrollToItem(row)  # unfolds what it lies in
    tree.setCurrentItem(row, NAME, QItemSelectionModel.SelectionFlag.NoUpdate)
    if tree.state() is not QAbstractItemView.State.EditingState:
        tree.editItem(row, NAME)
