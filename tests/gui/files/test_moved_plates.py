"""A project whose plate moved or changed: found again near it, or told in the status bar, with all shapes kept."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import cv2
import pytest
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from roam_core.geometry import bezier
from roam_core.roto import Keyframe, Origin, RotoShape, edit, file
from tests.gui.windows import WAIT, opened_window, write_clip


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 2), tmp_path / "journal") as window:
        window.document.save(tmp_path / "a.roam")
        yield window


def said_on_opening(qtbot: QtBot, window: MainWindow, path: Path) -> str:
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(path)
    return window.status.sentence.text()


def test_a_plate_that_moved_is_found_near_the_project(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "media").mkdir()
    (tmp_path / "plate").rename(tmp_path / "media" / "plate")
    assert "Its plate was found at" in said_on_opening(qtbot, window, tmp_path / "a.roam")
    assert window.document.project.require_clip().path == tmp_path / "media" / "plate"
    assert window.reader.source is not None


def test_keys_that_were_tracked_with_a_departed_dial_are_told(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    points = bezier.polygon_points([(8.0, 8.0), (40.0, 8.0), (40.0, 30.0)])
    inputs = "forward:best+firmness=2:0:from=1"
    keys = [Keyframe(1, points), Keyframe(2, points, origin=Origin.ENGINE, inputs=inputs)]
    shape = RotoShape("shape-1", "Body", tuple(keys))
    file.save(edit.add_items(window.document.project, [shape])[0], tmp_path / "b.roam")
    said = said_on_opening(qtbot, window, tmp_path / "b.roam")
    assert said.startswith("Opened b.roam. Keys were tracked with 'best+firmness=2', which turns a dial")
    assert said_on_opening(qtbot, window, tmp_path / "a.roam") == "Opened a.roam."


@pytest.mark.parametrize(
    ("half", "words"),
    [(True, "the project was made for"), (False, "is not that of the plate")],
    ids=["size", "content"],
)
def test_a_plate_of_another_size_or_content_is_told(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, half: bool, words: str
) -> None:
    for image in (tmp_path / "plate").iterdir():
        picture = cv2.imread(str(image))
        cv2.imwrite(str(image), picture[::2, ::2] if half else 255 - picture)
    assert words in said_on_opening(qtbot, window, tmp_path / "a.roam")
