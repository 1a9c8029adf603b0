"""The window asks, naming the files, before it writes over what ROAM did not make; the plate it never touches."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QFileDialog, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, file
from tests.gui.test_artist_path import draw_disc
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


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
    frame_link = tmp_path / "frame.roam"
    frame_link.symlink_to(plate / "plate.1002.png")
    chosen = iter([frame_link, notes, notes])
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


@pytest.mark.parametrize(
    ("named", "written", "is_asked"),
    [
        ("foo", "foo.roam", True),
        ("foo.roam", "foo.roam", False),  # the file chooser asked
        ("shot_010.v003", "shot_010.v003.roam", False),
        ("own", "own.roam", False),
    ],
)
@pytest.mark.parametrize("is_allowed", [True, False])
def test_a_name_without_its_suffix_gets_it_and_takes_no_other_projects_place_unasked(
    qtbot: QtBot,
    tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
    named: str,
    written: str,
    is_asked: bool,
    is_allowed: bool,
) -> None:
    asked: list[Path] = []
    monkeypatch.setattr(questions, "ask_replace", lambda parent, path: asked.append(path) or is_allowed)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / named), ""))
    file.save(Project(), tmp_path / "foo.roam")
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        window.document.save(tmp_path / "own.roam")
        window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, 1)[0])
        window.file_actions.save_as()
        qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)
    assert asked == ([tmp_path / written] if is_asked else [])
    assert len(file.load(tmp_path / "foo.roam").shapes) == (written == "foo.roam" and (is_allowed or not is_asked))
    if written != "foo.roam":
        assert len(file.load(tmp_path / written).shapes) == 1
    assert not (tmp_path / "shot_010.v003").exists()


@pytest.mark.parametrize("answer", ["Write over", "Cancel"])
def test_an_export_whose_suffix_was_left_out_takes_no_place_unasked(
    tmp_path: Path, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, answer: str
) -> None:
    shown: list[str] = []

    def click(box: QMessageBox) -> int:
        shown.append(box.text())
        assert box.defaultButton().text().replace("&", "") == "Cancel"
        next(button for button in box.buttons() if button.text().replace("&", "") == answer).click()
        return 0

    named = iter(["shot", "shot.nk", "shot_010.v003", "shot.NK", "shot.mov"])
    monkeypatch.setattr(QMessageBox, "exec", click)
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / next(named)), ""))
    (tmp_path / "shot.nk").write_text("Roto")
    parent = QWidget()
    qtbot.addWidget(parent)
    assert questions.choose_export(parent, "Export", tmp_path, ".nk") == (
        tmp_path / "shot.nk" if answer == "Write over" else None
    )
    assert shown == ["Write over shot.nk?"]
    chosen = [questions.choose_export(parent, "Export", tmp_path, ".nk", {".mov"}) for _ in range(4)]
    assert [path.name for path in chosen if path] == ["shot.nk", "shot_010.v003.nk", "shot.NK", "shot.mov"]
    assert len(shown) == 1


def test_a_name_that_is_too_long_is_told_and_nothing_is_written(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: tmp_path / ("n" * 300))
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        window.file_actions.save_as()
        assert window.view_state.message == f"The name {'n' * 40}… is too long; choose a shorter one."
        assert window.saver.is_idle
        longest = tmp_path / f"{'n' * 250}.roam"
        with qtbot.waitSignal(window.files.saved, timeout=WAIT):
            window.files.save(longest)
        window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, 1)[0])
        with qtbot.waitSignal(window.files.saved, timeout=WAIT):
            window.files.save(longest)
    assert len(file.load(longest).shapes) == 1
