"""Each chooser opens where the last one of its kind was used, also in the next window."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.model.last_folders import LastFolders, Purpose
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

PLACES = {
    "choose_save": 1, "choose_project": 1, "choose_clip_folder": 1,
    "choose_shapes": 1, "choose_mask": 1, "choose_export": 2, "choose_folder": 2,
}  # fmt: skip
"""Which argument of each chooser says where it opens."""


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "show" / "plate"), tmp_path / "journal") as window:
        yield window


@pytest.fixture
def starts(monkeypatch: pytest.MonkeyPatch) -> dict[str, list[Path]]:
    """Where each chooser opened; each is left without a choice."""
    asked: dict[str, list[Path]] = {}

    def left(name: str, place: int) -> None:
        def ask(*arguments: Any) -> None:
            asked.setdefault(name, []).append(arguments[place])

        monkeypatch.setattr(questions, name, ask)

    for name, place in PLACES.items():
        left(name, place)
    return asked


def test_at_first_they_open_beside_the_clip(window: MainWindow, starts: dict[str, list[Path]], tmp_path: Path) -> None:
    actions, show = window.file_actions, tmp_path / "show"
    for choose in (actions.save_as, actions.export_nuke, actions.import_shapes, actions.export_mattes):
        choose()
    assert starts["choose_save"] == [show / "plate.roam"]
    assert starts["choose_export"] == [show / "plate.nk"]
    assert starts["choose_shapes"] == starts["choose_folder"] == [show]


def test_no_place_of_a_frame_number_is_proposed_as_a_name(
    qtbot: QtBot, starts: dict[str, list[Path]], tmp_path: Path
) -> None:
    plates = write_clip(tmp_path / "plates")
    with opened_window(qtbot, plates / "plate.####.png", tmp_path / "journal") as window:
        for choose in (window.file_actions.save_as, window.file_actions.export_nuke):
            choose()
    assert starts["choose_save"] == [plates / "plate.roam"]
    assert starts["choose_export"] == [plates / "plate.nk"]


def test_a_folder_that_cannot_be_looked_at_is_gone() -> None:
    folders = LastFolders()
    folders.note(Purpose.EXPORT, Path("a" * 300) / "plate.nk")
    assert folders.of(Purpose.EXPORT) is None


def test_then_where_the_last_of_their_kind_was_used(
    qtbot: QtBot, window: MainWindow, starts: dict[str, list[Path]], tmp_path: Path
) -> None:
    project, _ = edit.new_shape(window.document.project, polygon_points([(4, 3), (8, 3), (8, 7)]), FIRST)
    window.document.apply("Draw", project)
    saves, renders = tmp_path / "saves", tmp_path / "renders"
    for folder in (saves, renders):
        folder.mkdir()
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(saves / "hero.roam")
    with qtbot.waitSignal(window.export.written, timeout=WAIT):
        window.export.start("nuke", renders / "first.nk")
    actions = window.file_actions
    for choose in (actions.export_nuke, actions.export_mattes, actions.save_as, actions.open_project):
        choose()
    assert starts["choose_export"] == [renders / "hero.nk"]
    assert starts["choose_folder"] == [renders]
    assert starts["choose_save"] == [saves / "hero.roam"]
    assert starts["choose_project"] == [saves]


def test_a_mask_is_looked_for_where_the_last_one_lay(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    starts: list[Path] = []

    def choose(_parent: object, start: Path) -> Path:
        starts.append(start)
        return tmp_path / "masks" / "hero.1001.png"

    (tmp_path / "masks").mkdir()
    monkeypatch.setattr(questions, "choose_mask", choose)
    for _ in range(2):
        window.actions_by_id["shape.from_mask"].trigger()
    assert starts == [tmp_path / "show", tmp_path / "masks"]


def test_the_next_window_knows_them(
    qtbot: QtBot, window: MainWindow, starts: dict[str, list[Path]], tmp_path: Path
) -> None:
    window.file_actions.folders.note(Purpose.EXPORT, tmp_path)
    window.keep_settings(tmp_path / "window.ini")
    with opened_window(qtbot, tmp_path / "show" / "plate", tmp_path / "other") as other:
        other.restore_settings(tmp_path / "window.ini")
        other.file_actions.export_mattes()
    assert starts["choose_folder"] == [tmp_path]


def test_a_folder_that_is_gone_is_passed_over(tmp_path: Path) -> None:
    folders = LastFolders()
    folders.note(Purpose.EXPORT, tmp_path / "gone")
    assert folders.of(Purpose.EXPORT) is None


@pytest.mark.parametrize("kept", [{"last": {"export": 4}}, {"last": {"lunch": "here"}}, {"last": {"clip": "a\0b"}}, {}])
def test_what_makes_no_sense_is_left_out(kept: dict[str, dict[str, str]]) -> None:
    folders = LastFolders()
    folders.recall(kept)
    assert folders.remembered() == {"last": {}}
