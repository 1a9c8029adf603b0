"""Autosave: unsaved work is kept, five snapshots of it, a crash is found, the artist's file is never touched."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.document import Document
from app.jobs import autosave
from app.jobs.autosave import BACKUPS, Autosave
from app.jobs.runner import Runner
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, file

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def keeper(document: Document, runner: Runner, tmp_path: Path) -> Iterator[Autosave]:
    keeper = Autosave(document, runner, tmp_path / "autosave")
    yield keeper
    keeper.close()


def draw(document: Document) -> None:
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1)[0])


def snapshots(root: Path) -> list[Path]:
    return sorted(root.glob("autosave/*/*.roam"))


def test_unsaved_work_is_written_on_the_worker(
    qtbot: QtBot, document: Document, keeper: Autosave, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    threads: list[threading.Thread] = []
    write = file.save
    monkeypatch.setattr(file, "save", lambda *args: (threads.append(threading.current_thread()), write(*args)))
    draw(document)
    keeper.save()
    qtbot.waitUntil(lambda: len(snapshots(tmp_path)) == 1, timeout=5000)
    assert file.load(snapshots(tmp_path)[0]) == document.project
    assert threading.main_thread() not in threads


def test_a_snapshot_that_cannot_be_written_is_told_and_tried_again(
    qtbot: QtBot, document: Document, keeper: Autosave, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    def refuse(*_: object) -> None:
        raise RoamError("The disk is full.")

    draw(document)
    with monkeypatch.context() as full:
        full.setattr(file, "save", refuse)
        with qtbot.waitSignal(keeper.refused, timeout=5000) as refused:
            keeper.save()
    assert refused.args == ["Your work could not be autosaved; save it yourself. The disk is full."]
    keeper.save()
    qtbot.waitUntil(lambda: len(snapshots(tmp_path)) == 1, timeout=5000)


def test_nothing_is_written_without_news(document: Document, keeper: Autosave, tmp_path: Path) -> None:
    keeper.save_now()
    assert snapshots(tmp_path) == []
    draw(document)
    keeper.save_now()
    keeper.save_now()
    assert len(snapshots(tmp_path)) == 1
    document.save(tmp_path / "mine.roam")
    keeper.save_now()
    assert len(snapshots(tmp_path)) == 1


def test_five_snapshots_are_kept_and_the_artists_file_is_not_touched(
    document: Document, keeper: Autosave, tmp_path: Path
) -> None:
    mine = tmp_path / "mine.roam"
    document.save(mine)
    before = mine.read_bytes()
    for _ in range(BACKUPS + 3):
        draw(document)
        keeper.save_now()
    kept = snapshots(tmp_path)
    assert [path.stem for path in kept] == ["0004", "0005", "0006", "0007", "0008"]
    assert file.load(kept[-1]) == document.project
    assert mine.read_bytes() == before


def test_a_crash_is_found_with_its_last_snapshot(tmp_path: Path) -> None:
    folder, project = tmp_path / "20260101-1", edit.new_shape(Project(), SQUARE, 1)[0]
    folder.mkdir()
    autosave.write_snapshot(folder, Project(), tmp_path / "mine.roam")
    autosave.write_snapshot(folder, project, tmp_path / "mine.roam")
    (found,) = autosave.recoveries(tmp_path)
    assert found.original == tmp_path / "mine.roam"
    assert "mine.roam" in found.title
    assert autosave.load_recovery(found) == project
    autosave.dismiss(found)
    assert autosave.recoveries(tmp_path) == []
    assert len(list(folder.glob("*.roam"))) == 2


def test_a_session_that_is_open_or_was_closed_is_no_crash(document: Document, runner: Runner, tmp_path: Path) -> None:
    keeper = Autosave(document, runner, tmp_path)
    draw(document)
    keeper.save_now()
    assert autosave.recoveries(tmp_path) == []
    keeper.close()
    assert autosave.recoveries(tmp_path) == []


def test_work_that_nobody_could_be_asked_about_waits_for_recovery(
    document: Document, runner: Runner, tmp_path: Path
) -> None:
    keeper = Autosave(document, runner, tmp_path)
    draw(document)
    keeper.save_for_recovery()
    keeper.close()
    (found,) = autosave.recoveries(tmp_path)
    assert autosave.load_recovery(found) == document.project


def test_closed_sessions_are_pruned_and_those_to_recover_are_not(
    document: Document, runner: Runner, tmp_path: Path
) -> None:
    for number in range(BACKUPS + 3):
        folder = tmp_path / f"2020010{number}-1"
        folder.mkdir()
        autosave.write_snapshot(folder, Project(), None)
        if number:
            (folder / "session.json").unlink()
    Autosave(document, runner, tmp_path).close()
    left = sorted(folder.name for folder in tmp_path.iterdir())
    assert left == ["20200100-1", *(f"2020010{number}-1" for number in range(3, BACKUPS + 3))]


def test_a_damaged_snapshot_is_refused_in_a_sentence(tmp_path: Path) -> None:
    folder = tmp_path / "20260101-1"
    folder.mkdir()
    autosave.write_snapshot(folder, Project(), None).write_text("{", encoding="utf-8")
    (found,) = autosave.recoveries(tmp_path)
    with pytest.raises(RoamError, match="cannot be recovered"):
        autosave.load_recovery(found)


@pytest.mark.parametrize("session", ["", "[]", "{}", "no json"])
def test_a_session_file_that_makes_no_sense_is_passed_over(tmp_path: Path, session: str) -> None:
    folder = tmp_path / "20260101-1"
    folder.mkdir()
    autosave.write_snapshot(folder, Project(), None)
    (folder / "session.json").write_text(session, encoding="utf-8")
    assert autosave.recoveries(tmp_path) == []
