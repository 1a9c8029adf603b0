"""Help: keys are listed and found, libraries named with their licences; messages are kept with their times."""

from __future__ import annotations

from collections.abc import Iterator
from importlib import metadata
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QDialog, QTreeWidget
from pytestqt.qtbot import QtBot

from app.dialogs.help_dialogs import AboutDialog, KeysDialog, libraries
from app.shell.main_window import MainWindow
from tests.gui.windows import opened_window


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


def rows(tree: QTreeWidget) -> dict[str, dict[str, str]]:
    """What is shown: keys by meaning, by group."""
    shown: dict[str, dict[str, str]] = {}
    for group in (tree.topLevelItem(place) for place in range(tree.topLevelItemCount())):
        if group is not None and not group.isHidden():
            items = [row for row in map(group.child, range(group.childCount())) if not row.isHidden()]
            shown[group.text(0)] = {row.text(0): row.text(1) for row in items}
    return shown


@pytest.mark.parametrize("key", [Qt.Key.Key_F1, Qt.Key.Key_Question])
def test_its_key_shows_all_keys_in_groups(qtbot: QtBot, window: MainWindow, key: Qt.Key) -> None:
    qtbot.keyClick(window.canvas, key)
    (dialog,) = window.findChildren(KeysDialog)
    shown = rows(dialog.tree)
    assert shown["Track"]["Track forward"] == "] or F7"
    assert shown["In the viewer"]["Pan"] == "Middle button, Alt+left"
    dialog.close()


@pytest.mark.parametrize(("query", "meaning"), [("f7", "Track forward"), ("trk for", "Track forward"), ("pan", "Pan")])
def test_keys_are_found_by_title_and_by_key(qtbot: QtBot, window: MainWindow, query: str, meaning: str) -> None:
    dialog = KeysDialog(window.actions_by_id, window)
    qtbot.keyClicks(dialog.search, query)
    found = {name for group in rows(dialog.tree).values() for name in group}
    assert meaning in found
    assert "Save as" not in found
    dialog.close()
    dialog.deleteLater()


def test_about_tells_the_version_and_every_librarys_licence(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["help.about"].trigger()
    (dialog,) = window.findChildren(AboutDialog)
    assert dialog.libraries.topLevelItemCount() == len(list(libraries()))
    dialog.close()
    named = {library.name.casefold(): library for library in libraries()}
    requirements = metadata.requires("roam-roto") or []
    needed = [line for line in requirements if "extra ==" not in line or "extra == 'window'" in line.replace('"', "'")]
    assert len(named) == len(needed)
    assert "LGPL" in named["pyside6_essentials"].licence
    assert named["openexr"].licence == "BSD-3-Clause"
    assert named["numpy"].version == metadata.version("numpy")
    assert all(library.licence for library in named.values())


@pytest.mark.parametrize(("action", "kind"), [("help.keys", KeysDialog), ("help.about", AboutDialog)])
def test_a_dialog_that_is_open_comes_to_the_front_and_a_closed_one_is_made_anew(
    qtbot: QtBot, window: MainWindow, action: str, kind: type[QDialog]
) -> None:
    for _ in range(2):
        window.actions_by_id[action].trigger()
    (first,) = window.findChildren(kind)
    assert first.isVisible()
    first.close()
    window.actions_by_id[action].trigger()
    (second,) = [dialog for dialog in window.findChildren(kind) if dialog.isVisible()]
    assert second is not first
    second.close()


def test_messages_are_kept_with_their_times(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["help.log"].trigger()
    assert not window.services.log_panel.isHidden()
    window.view_state.say("First.")
    window.view_state.say("Second.")
    text = window.services.log.text.toPlainText().splitlines()
    assert [line[10:] for line in text[-2:]] == ["First.", "Second."]
    assert text[-1][2::3].startswith("::")
    qtbot.mouseClick(window.services.log.copy_button, Qt.MouseButton.LeftButton)
    assert QGuiApplication.clipboard().text().splitlines()[-2:] == text[-2:]
