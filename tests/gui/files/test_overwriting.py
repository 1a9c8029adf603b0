"""The window asks, naming the files, before it writes over what ROAM did not make; the plate it never touches."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from roam_core.roto import file
from tests.gui.test_artist_path import draw_disc
from tests.gui.windows import WAIT, opened_window, write_clip


@pytest.mark.parametrize("answer", ["Write over", "Cancel"])
def test_the_question_names_the_files(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: str
) -> None:
    shown: list[str] = []

    def click(box: QMessageBox) -> int:
        shown.extend((box.text(), box.detailedText()))
        next(button for button in box.buttons() if button.text().replace("&", "") == answer).click()
        return 0

    monkeypatch.setattr(QMessageBox, "exec", click)
    theirs = tmp_path / "mattes" / "matte.1002.png"
    theirs.parent.mkdir()
    theirs.write_text("my own work")
    monkeypatch.setattr(questions, "choose_folder", lambda parent, title, start: theirs.parent)
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        with qtbot.waitSignal(window.export.finished, timeout=WAIT):
            window.actions_by_id["file.export_mattes"].trigger()
    assert shown == ["Write over matte.1002.png?", str(theirs)]
    assert (theirs.read_bytes() == b"my own work") is (answer == "Cancel")
    assert len(list(theirs.parent.iterdir())) == (1 if answer == "Cancel" else 3)


def test_a_project_is_not_saved_onto_the_plate_nor_unasked_onto_what_is_no_project(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    plate, notes = write_clip(tmp_path / "plate", 3), tmp_path / "notes.roam"
    notes.write_text("my own work")
    chosen = iter([plate / "plate.1002.png", notes, notes])
    answers = iter([False, True])
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: next(chosen))
    monkeypatch.setattr(questions, "ask_overwrite", lambda parent, paths: list(paths) == [notes] and next(answers))
    frame = (plate / "plate.1002.png").read_bytes()
    with opened_window(qtbot, plate, tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        window.file_actions.save_as()
        assert "is never written over" in window.view_state.message
        assert (plate / "plate.1002.png").read_bytes() == frame
        window.file_actions.save_as()
        assert notes.read_text() == "my own work"
        with qtbot.waitSignal(window.files.saved, timeout=WAIT):
            window.file_actions.save_as()
    assert len(file.load(notes).shapes) == 1
