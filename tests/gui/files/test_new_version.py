"""Save new version: the next number beside the project's file, over nothing, and the window goes on with that file."""

from __future__ import annotations

import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.files import files
from app.journal import recovery
from app.shell.main_window import MainWindow
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, file
from roam_core.roto.project_lock import lock_path
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


@pytest.fixture
def third(tmp_path: Path) -> Path:
    """The third version of a project, which is not there yet."""
    (tmp_path / "Maß nehmen").mkdir()
    return tmp_path / "Maß nehmen" / "shot010 für Ü_v003.roam"


def draw(window: MainWindow) -> Project:
    window.document.apply("Draw", edit.new_shape(window.document.project, SQUARE, 1)[0])
    return window.document.project


def settled(qtbot: QtBot, window: MainWindow, act: Callable[[], object]) -> None:
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        act()
    qtbot.waitUntil(lambda: window.saver.is_idle, timeout=WAIT)


def next_version(qtbot: QtBot, window: MainWindow) -> None:
    settled(qtbot, window, window.actions_by_id["file.save_version"].trigger)


class SlowSaving:
    """Holds up what is saved onto a file, or as a new version, until it goes on."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch, what: str = "save_onto") -> None:
        self.reached, self.goes_on, write = threading.Event(), threading.Event(), getattr(files, what)

        def slow(*words: Any) -> Any:
            self.reached.set()
            assert self.goes_on.wait(WAIT / 1000)
            return write(*words)

        monkeypatch.setattr(files, what, slow)


def test_the_window_goes_on_with_the_next_version(qtbot: QtBot, window: MainWindow, third: Path) -> None:
    first = draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    second, begun = draw(window), list[Path]()
    window.files.saving.connect(begun.append)  # the journal knows of it before the file is there
    next_version(qtbot, window)
    fourth = third.with_name("shot010 für Ü_v004.roam")
    assert (file.load(third), file.load(fourth)) == (first, second)
    assert [window.document.path, *begun] == [fourth, fourth]
    assert not window.document.is_modified
    assert (lock_path(third).exists(), lock_path(fourth).exists()) == (False, True)
    assert [each.path for each in window.personal.recent[:2]] == [fourth, third]
    assert fourth.name in window.windowTitle()
    assert window.status.sentence.text() == "Saved shot010 für Ü_v004.roam."
    last = draw(window)
    settled(qtbot, window, window.file_actions.save)
    assert (file.load(fourth), file.load(fourth.with_name(fourth.name + ".1"))) == (last, second)
    for _ in range(3):
        window.document.undo_stack.undo()
    assert window.document.project.shapes == ()


def test_what_is_drawn_after_it_is_recovered_as_changes_of_the_new_file(
    qtbot: QtBot, window: MainWindow, third: Path
) -> None:
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    next_version(qtbot, window)
    last = draw(window)
    assert window.journal.flush()
    window.journal.leave_for_recovery()
    window.journal.close()
    (found,) = recovery.offered(recovery.recoveries(window.journal.root))
    assert found.original == third.with_name("shot010 für Ü_v004.roam")
    assert recovery.load(found)[0] == last


def test_an_unchanged_project_has_a_new_version_too(qtbot: QtBot, window: MainWindow, third: Path) -> None:
    drawn = draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    next_version(qtbot, window)
    assert file.load(third.with_name("shot010 für Ü_v004.roam")) == drawn


def test_a_key_that_is_held_makes_one_version(qtbot: QtBot, window: MainWindow, third: Path) -> None:
    """X servers do not tell Qt that a key repeats: held for three seconds it made twenty files."""
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    fourth, fifth = (third.with_name(f"shot010 für Ü_v00{number}.roam") for number in (4, 5))
    for _ in range(3):
        window.file_actions.save_new_version()
    qtbot.waitUntil(lambda: window.document.path == fourth and window.saver.is_idle, timeout=WAIT)
    window.file_actions.save_new_version()
    assert window.saver.is_idle
    assert window.status.sentence.text() == (
        "shot010 für Ü_v004.roam is the new version already; nothing changed since it was saved."
    )
    assert not fifth.exists()
    later = draw(window)
    next_version(qtbot, window)
    assert file.load(fifth) == later
    with qtbot.waitSignal(window.files.opened, timeout=WAIT):
        window.files.open(fifth)
    next_version(qtbot, window)  # who opens it may begin the next one at once
    assert file.load(third.with_name("shot010 für Ü_v006.roam")) == later


def test_versions_that_are_there_are_told_and_kept(qtbot: QtBot, window: MainWindow, third: Path) -> None:
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    theirs = [third.with_name(f"shot010 für Ü_v{number}.roam") for number in ("004", "008")]
    for each in theirs:
        each.write_text("theirs")
    next_version(qtbot, window)
    assert window.document.path == third.with_name("shot010 für Ü_v009.roam")
    assert [each.read_text() for each in theirs] == ["theirs"] * 2
    assert window.status.sentence.text() == (
        "Saved as shot010 für Ü_v009.roam: shot010 für Ü_v004.roam exists already."
    )


def test_a_version_that_somebody_else_saves_at_the_same_time_is_not_written_over(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    theirs, encoded = third.with_name("shot010 für Ü_v004.roam"), file.contents

    def meanwhile(project: Project, folder: Path) -> Iterator[bytes]:
        theirs.exists() or theirs.write_text("theirs")
        return encoded(project, folder)

    monkeypatch.setattr(file, "contents", meanwhile)
    next_version(qtbot, window)
    assert theirs.read_text() == "theirs"
    assert file.load(third.with_name("shot010 für Ü_v005.roam")) == window.document.project
    assert "v004.roam exists already" in window.status.sentence.text()


def test_a_project_without_a_file_asks_for_one(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.dialogs.questions.choose_save", lambda *_: third)
    draw(window)
    next_version(qtbot, window)
    assert window.document.path == third


@pytest.mark.parametrize("way", ["Save as…", "Try again"])
def test_a_folder_that_cannot_be_written_to_is_told_and_tried_again(
    qtbot: QtBot, window: MainWindow, third: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    def refuse(*_: object, **__: object) -> None:
        raise RoamError("The folder is read-only.")

    elsewhere = tmp_path / "elsewhere.roam"
    monkeypatch.setattr("app.dialogs.questions.choose_save", lambda *_: elsewhere)
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    with monkeypatch.context() as closed:
        closed.setattr(file, "save", refuse)
        with qtbot.waitSignal(window.files.not_saved, timeout=WAIT):
            window.file_actions.save_new_version()
    assert window.document.path == third
    (box,) = (each for each in window.findChildren(QMessageBox) if each.isVisible())
    assert box.text() == "shot010 für Ü_v004.roam is not saved."
    (button,) = (each for each in box.buttons() if each.text() == way)
    settled(qtbot, window, button.click)
    expected = elsewhere if way == "Save as…" else third.with_name("shot010 für Ü_v004.roam")
    assert window.document.path == expected
    assert file.load(expected) == window.document.project


def test_after_a_plain_save_of_it_the_next_version_is_made(qtbot: QtBot, window: MainWindow, third: Path) -> None:
    """The file was no longer the version as it was made, and none could be made any more."""
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    next_version(qtbot, window)
    later = draw(window)
    settled(qtbot, window, window.file_actions.save)
    next_version(qtbot, window)
    assert file.load(third.with_name("shot010 für Ü_v005.roam")) == later


def test_a_save_while_a_version_is_made_goes_to_that(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It went to the file before, which was written over, and the version stood there alone."""
    first = draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    slow = SlowSaving(monkeypatch, "save_new_version")
    second = draw(window)
    window.file_actions.save_new_version()
    assert slow.reached.wait(WAIT / 1000)
    last = draw(window)
    window.file_actions.save()
    slow.goes_on.set()
    fourth = third.with_name("shot010 für Ü_v004.roam")
    qtbot.waitUntil(
        lambda: window.document.path == fourth and not window.document.is_modified and window.saver.is_idle,
        timeout=WAIT,
    )
    assert (file.load(third), file.load(fourth), file.load(fourth.with_name(fourth.name + ".1"))) == (
        first,
        last,
        second,
    )


def test_who_asks_twice_for_a_version_and_leaves_is_let_go(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The second one is none, as nothing changed; the window stayed, and closed at the next save."""
    draw(window)
    settled(qtbot, window, lambda: window.files.save(third))
    slow = SlowSaving(monkeypatch, "save_new_version")
    left = list[Path | None]()
    draw(window)
    for _ in range(2):
        window.file_actions.save_new_version()
    assert slow.reached.wait(WAIT / 1000)
    window.file_actions.leave_project(lambda: left.append(window.document.path))
    slow.goes_on.set()
    qtbot.waitUntil(lambda: left != [], timeout=WAIT)
    assert left == [third.with_name("shot010 für Ü_v004.roam")]


@pytest.mark.parametrize("asked", [1, 3])
def test_it_waits_for_a_save_that_is_under_way_and_follows_it_once(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch, asked: int
) -> None:
    """A save that the next one dropped had not reached the file: v003 would lack what was saved there."""
    slow = SlowSaving(monkeypatch)
    saved = draw(window)
    window.files.save(third)
    assert slow.reached.wait(WAIT / 1000)
    later = draw(window)
    for _ in range(asked):
        window.file_actions.save_new_version()
    slow.goes_on.set()
    fourth = third.with_name("shot010 für Ü_v004.roam")
    qtbot.waitUntil(lambda: window.document.path == fourth and window.saver.is_idle, timeout=WAIT)
    assert (file.load(third), file.load(fourth)) == (saved, later)
    assert not third.with_name("shot010 für Ü_v005.roam").exists()


def test_who_leaves_meanwhile_has_the_new_version_first(
    qtbot: QtBot, window: MainWindow, third: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    slow = SlowSaving(monkeypatch)
    left = list[Path | None]()
    drawn = draw(window)
    window.files.save(third)
    assert slow.reached.wait(WAIT / 1000)
    window.file_actions.save_new_version()
    window.file_actions.leave_project(lambda: left.append(window.document.path))
    slow.goes_on.set()
    qtbot.waitUntil(lambda: left != [], timeout=WAIT)
    fourth = third.with_name("shot010 für Ü_v004.roam")
    assert left == [fourth]
    assert file.load(fourth) == drawn
