"""Help: all keys and gestures, found by a word; and what ROAM is, its version and its libraries' licences."""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass
from importlib import metadata

from PySide6.QtCore import Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import (
    QDialog,
    QHeaderView,
    QLabel,
    QLineEdit,
    QTreeWidget,
    QTreeWidgetItem,
    QVBoxLayout,
    QWidget,
)

from roam_core import __version__

from .. import style
from ..actions.actions import Actions
from ..actions.fuzzy import fuzzy_score, words_begin
from ..actions.menus import menu_of
from ..actions.specs import SPECS
from ..translation import N_, tr
from ..widgets.controls import weak_label
from ..widgets.floating import resize_on_screen

DISTRIBUTION = "roam-roto"
UNNAMED = {"OpenEXR": "BSD-3-Clause"}
"""The licences of libraries whose packages hold its text and not its name."""
GESTURES = (
    (N_("Ctrl+Alt+click"), N_("Insert a point on the outline")),
    (N_("Ctrl+drag"), N_("Break a tangent; from an anchor: pull its handles out")),
    (N_("Shift+drag"), N_("Equalise the handles")),
    (N_("Ctrl+Alt+drag"), N_("Select points with a lasso")),
    (
        N_("Shift+drag, Ctrl+drag"),
        N_("On empty background: add points to the selection, take them away"),
    ),
    (
        N_("Shift+click, Ctrl+click"),
        N_("With the object tool: mark more of the object, mark what is not it"),
    ),
    (N_("Ctrl+wheel"), N_("Change the reach of soft selection, of the brush")),
    (N_("Alt+arrows"), N_("Nudge points by a pixel, with Shift by ten")),
    (N_("Return, Esc"), N_("Close a shape being drawn, leave it open")),
    (N_("Middle button, Alt+left"), N_("Pan")),
    (N_("Wheel"), N_("Zoom at the pointer")),
)


class KeysDialog(QDialog):
    """All keys and gestures, in the groups of the menus, with a field to search for a title or a key."""

    def __init__(self, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("Keys", "of the keyboard"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        resize_on_screen(self, 440, 680)
        self.search = QLineEdit()
        self.search.setPlaceholderText(tr("Search for an action or a key"))
        self.search.setClearButtonEnabled(True)
        self.search.setAccessibleName(self.search.placeholderText())
        self.search.textChanged.connect(self._pull)
        self.tree = _tree(2)
        self.tree.setAccessibleName(tr("Keys", "of the keyboard"))
        for title, rows in _groups(actions).items():
            group = QTreeWidgetItem(self.tree, [title])
            group.setForeground(0, QColor(style.ACCENT))
            for meaning, keys in rows:
                QTreeWidgetItem(group, [meaning, keys])
        self.tree.expandAll()
        column = QVBoxLayout(self)
        column.addWidget(self.search)
        column.addWidget(self.tree)

    def _pull(self, query: str) -> None:
        """Show what fits the query; a group without anything that fits is left out."""
        for place in range(self.tree.topLevelItemCount()):
            group = self.tree.topLevelItem(place)
            assert group is not None
            rows = [row for row in map(group.child, range(group.childCount())) if row is not None]
            for row in rows:
                row.setHidden(not _fits(query, row.text(0), row.text(1)))
            group.setHidden(all(row.isHidden() for row in rows))


@dataclass(frozen=True)
class Library:
    """A library that ROAM stands on."""

    name: str
    version: str
    licence: str


class AboutDialog(QDialog):
    """Name, version, what it is for, its licence, and its libraries with theirs."""

    def __init__(self, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setWindowTitle(tr("About ROAM"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        resize_on_screen(self, 600, 480)
        name = QLabel(f"ROAM {__version__}")
        name.setObjectName("heading")
        what = QLabel(tr("Rotoscoping with a Rich Online Appearance Model: editable curves carried through a shot."))
        what.setWordWrap(True)
        self.libraries = _tree(3)
        self.libraries.setAccessibleName(tr("Libraries"))
        self.libraries.header().setSectionResizeMode(0, QHeaderView.ResizeMode.ResizeToContents)
        self.libraries.header().setStretchLastSection(True)
        for library in libraries():
            item = QTreeWidgetItem(self.libraries, [library.name, f"  {library.version}  ", library.licence])
            item.setForeground(1, QColor(style.WEAK))
            item.setToolTip(2, library.licence)
        column = QVBoxLayout(self)
        column.setSpacing(style.MARGIN)
        column.addWidget(name)
        column.addWidget(what)
        column.addWidget(
            weak_label(tr("BSD 3-Clause licence, copyright the ROAM developers. The libraries beneath it:"))
        )
        column.addWidget(self.libraries, 1)


def libraries() -> Iterator[Library]:
    """What ROAM and its window need to run, with the versions that are installed here, in alphabetical order."""
    try:
        needed = metadata.requires(DISTRIBUTION) or []
    except metadata.PackageNotFoundError:
        return
    for requirement in sorted(needed, key=str.casefold):
        extra = re.search(r"extra == .(\w+)", requirement)
        if extra is not None and extra[1] != "window":
            continue
        name = requirement.split(";")[0].strip()
        for mark in "<>=!~ [":
            name = name.split(mark)[0]
        try:
            yield _library(name)
        except metadata.PackageNotFoundError:
            yield Library(name, "–", tr("not installed"))


def _library(name: str) -> Library:
    """A library as its own package describes it: in a short expression, a classifier, or a text's first line."""
    about = metadata.metadata(name)
    if "License-Expression" in about:
        return Library(about["Name"], about["Version"], about["License-Expression"])
    if about["Name"] in UNNAMED:
        return Library(about["Name"], about["Version"], UNNAMED[about["Name"]])
    classified = [line.split(" :: ")[-1] for line in about.get_all("Classifier") or [] if line.startswith("License ::")]
    texts = about.get_all("License") or [tr("see its package")]
    licence = ", ".join(classified) or texts[0].strip().splitlines()[0]
    return Library(about["Name"], about["Version"], licence)


def _groups(actions: Actions) -> dict[str, list[tuple[str, str]]]:
    """Titles and keys of all actions that have any, by menu, then the gestures of the viewer."""
    groups: dict[str, list[tuple[str, str]]] = {}
    for spec in SPECS:
        if keys := actions.keys_of(spec.id):
            groups.setdefault(menu_of(spec.id) or tr("More"), []).append((spec.name, keys))
    groups[tr("In the viewer")] = [(tr(meaning), tr(keys)) for keys, meaning in GESTURES]
    return groups


def _fits(query: str, meaning: str, keys: str) -> bool:
    if query.strip().casefold() in (key.casefold() for key in keys.split(tr(" or "))):
        return True
    return fuzzy_score(query, meaning) is not None or words_begin(query, f"{meaning} {keys}")


def _tree(columns: int) -> QTreeWidget:
    tree = QTreeWidget()
    tree.setColumnCount(columns)
    tree.setHeaderHidden(True)
    tree.setRootIsDecorated(False)
    tree.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    header = tree.header()
    header.setStretchLastSection(False)
    header.setSectionResizeMode(0, QHeaderView.ResizeMode.Stretch)
    for column in range(1, columns):
        header.setSectionResizeMode(column, QHeaderView.ResizeMode.ResizeToContents)
    return tree
