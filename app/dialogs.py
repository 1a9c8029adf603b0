"""The few questions that need a decision, and the file choosers."""

from __future__ import annotations

from collections.abc import Sequence
from enum import Enum
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QDialog,
    QFileDialog,
    QHeaderView,
    QMessageBox,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from app import style
from app.action_specs import SPECS
from app.actions import Keymap, keys_text
from app.files import PROJECT_SUFFIX

GESTURES = (
    ("Ctrl+Alt+click", "Insert a point on the outline"),
    ("Ctrl+drag", "Break a tangent"),
    ("Shift+drag", "Equalise the handles"),
    ("Alt+arrows", "Nudge points by a pixel, with Shift by ten"),
    ("Return, Esc", "Close a shape being drawn, leave it open"),
    ("Middle button, Alt+left", "Pan"),
    ("Wheel", "Zoom at the pointer"),
)
MOVIES = "Movies (*.mov *.mp4 *.avi *.mkv *.m4v *.mxf *.webm);;All files (*)"
PROJECTS = f"ROAM projects (*{PROJECT_SUFFIX})"


class Unsaved(Enum):
    """What to do with unsaved changes."""

    SAVE = "save"
    DISCARD = "discard"
    CANCEL = "cancel"


def ask_unsaved(parent: QWidget, name: str) -> Unsaved:
    """Ask what shall become of unsaved changes."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(f"Save the changes to {name}?")
    box.setInformativeText("They are lost if you do not.")
    button = QMessageBox.StandardButton
    box.setStandardButtons(button.Save | button.Discard | button.Cancel)
    box.setDefaultButton(button.Save)
    answers = {button.Save: Unsaved.SAVE, button.Discard: Unsaved.DISCARD}
    return answers.get(button(box.exec()), Unsaved.CANCEL)


def ask_recover(parent: QWidget, title: str) -> bool:
    """Offer the work of a session that ended without closing."""
    box = QMessageBox(parent)
    box.setWindowTitle("ROAM")
    box.setText(f"ROAM did not close properly. Recover {title}?")
    box.setInformativeText("Your own file is not changed until you save.")
    recover = box.addButton("Recover", QMessageBox.ButtonRole.AcceptRole)
    box.addButton("Leave it", QMessageBox.ButtonRole.RejectRole)
    box.setDefaultButton(recover)
    box.exec()
    return box.clickedButton() is recover


def choose_clip_folder(parent: QWidget, start: Path) -> Path | None:
    return _path(QFileDialog.getExistingDirectory(parent, "Open clip: the folder of its frames", str(start)))


def choose_movie(parent: QWidget, start: Path) -> Path | None:
    return _path(QFileDialog.getOpenFileName(parent, "Open movie", str(start), MOVIES)[0])


def choose_project(parent: QWidget, start: Path) -> Path | None:
    return _path(QFileDialog.getOpenFileName(parent, "Open project", str(start), PROJECTS)[0])


def choose_save(parent: QWidget, start: Path) -> Path | None:
    """Where to save the project; the suffix is added when it was left out."""
    path = _path(QFileDialog.getSaveFileName(parent, "Save project", str(start), PROJECTS)[0])
    return path if path is None or path.suffix else path.with_suffix(PROJECT_SUFFIX)


def choose_export(parent: QWidget, title: str, start: Path, suffix: str) -> Path | None:
    path = _path(QFileDialog.getSaveFileName(parent, title, str(start), f"*{suffix}")[0])
    return path if path is None or path.suffix else path.with_suffix(suffix)


def choose_shapes(parent: QWidget, start: Path, suffixes: Sequence[str]) -> Path | None:
    kinds = " ".join(f"*{suffix}" for suffix in suffixes)
    return _path(QFileDialog.getOpenFileName(parent, "Import shapes", str(start), f"Shapes ({kinds})")[0])


def choose_folder(parent: QWidget, title: str, start: Path) -> Path | None:
    return _path(QFileDialog.getExistingDirectory(parent, title, str(start)))


class KeysDialog(QDialog):
    """All keys and gestures, in the groups of the menus."""

    def __init__(self, keymap: Keymap, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle("Keys")
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self.resize(420, 620)
        tree = QTreeWidget()
        tree.setColumnCount(2)
        tree.setHeaderHidden(True)
        tree.setRootIsDecorated(False)
        tree.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        groups: dict[str, QTreeWidgetItem] = {}
        for spec in SPECS:
            if spec.id in keymap:
                group = _group(tree, groups, spec.id.split(".")[0].capitalize())
                QTreeWidgetItem(group, [spec.title, keys_text(keymap[spec.id])])
        group = _group(tree, groups, "In the viewer")
        for keys, meaning in GESTURES:
            QTreeWidgetItem(group, [meaning, keys])
        tree.expandAll()
        tree.header().setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
        tree.header().setSectionResizeMode(1, QHeaderView.ResizeMode.ResizeToContents)
        column = QVBoxLayout(self)
        column.addWidget(tree)


def _group(tree: QTreeWidget, groups: dict[str, QTreeWidgetItem], title: str) -> QTreeWidgetItem:
    if title not in groups:
        groups[title] = QTreeWidgetItem(tree, [title])
        groups[title].setForeground(0, QColor(style.ACCENT))
    return groups[title]


def _path(chosen: str) -> Path | None:
    return Path(chosen) if chosen else None
