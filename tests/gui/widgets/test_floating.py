"""Windows on a small screen: their first size leaves everything within reach."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtCore import QSize
from PySide6.QtGui import QScreen
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app import style
from app.dialogs.export_dialog import ExportDialog
from app.dialogs.keymap_editor import KeymapEditor
from app.jobs.export import Export
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.personal import Personal
from app.model.view_state import ViewState
from app.widgets.floating import TITLE_HEIGHT, resize_on_screen
from tests.gui.waiting import WAIT

SMALL = QSize(960, 540)
"""What a screen of 1920 x 1080 has at 200 %."""


@pytest.fixture
def small_screen(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(QScreen, "availableSize", lambda _screen: SMALL)


def test_a_window_is_no_larger_than_its_screen(qtbot: QtBot, small_screen: None) -> None:
    window = QWidget()
    qtbot.addWidget(window)
    resize_on_screen(window, 640, 480)
    assert window.size() == QSize(640, 480)
    resize_on_screen(window, 1500, 940)
    assert window.size() == QSize(960, 540 - TITLE_HEIGHT)


def test_the_buttons_of_high_dialogs_are_on_the_screen(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, small_screen: None
) -> None:
    dialogs = (
        ExportDialog(document, view_state, Export(document, runner), lambda suffix: Path(f"shot{suffix}")),
        KeymapEditor(Personal()),
    )
    for dialog in dialogs:
        qtbot.addWidget(dialog)
        dialog.setStyleSheet(style.style_sheet())
        with qtbot.waitExposed(dialog, timeout=WAIT):
            dialog.show()
        assert dialog.height() <= SMALL.height() - TITLE_HEIGHT
