"""The border between viewer and timeline: dragged, kept in every size of the window, and there again the next time."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.shell.laying_out.timeline_height import LEAST, MOST_SHARE, SHARE
from app.shell.main_window import MainWindow
from app.style import ROW_HEIGHT
from roam_core.roto import Animated, Project, ValueKey, edit
from tests.gui.timeline.places import CLIP, SQUARE
from tests.gui.windows import opened_window


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        yield window


def height(window: MainWindow) -> int:
    return window._halves.sizes()[1]


def drag_border(window: MainWindow, by: int) -> None:
    """Take the border by its middle and drag it down by so many pixels, up where it is negative."""
    handle = window._halves.handle(1)
    middle = handle.rect().center()
    QTest.mousePress(handle, Qt.MouseButton.LeftButton, pos=middle)
    QTest.mouseMove(handle, middle + QPoint(0, by))
    QTest.mouseRelease(handle, Qt.MouseButton.LeftButton, pos=middle + QPoint(0, by))


def test_before_it_is_dragged_it_takes_its_share(window: MainWindow) -> None:
    assert height(window) == pytest.approx(LEAST, abs=2)
    window.resize(1400, 2000)
    assert height(window) == pytest.approx(SHARE * window._halves.height(), abs=2)


def test_a_project_of_many_shapes_opens_with_more_rows_and_drawing_moves_nothing(window: MainWindow) -> None:
    window.resize(1400, 900)
    few, rows = height(window), window.timeline.rows
    project = Project(CLIP)
    for _ in range(100):
        project, _ = edit.new_shape(project, SQUARE, CLIP.first)
    window.document.open(project, None)
    QApplication.processEvents()
    assert few + 3 * ROW_HEIGHT < height(window) <= round(MOST_SHARE * window._halves.height())
    assert rows.height() >= 5 * ROW_HEIGHT
    window.document.apply("Delete", Project(CLIP))
    assert height(window) > few
    window.document.open(Project(CLIP), None)
    assert height(window) == few


def test_rows_of_values_count_as_those_of_shapes_do(window: MainWindow) -> None:
    window.resize(1400, 900)
    few, rows = height(window), window.timeline.rows
    fades = Animated((ValueKey(CLIP.first, 0.2), ValueKey(CLIP.first + 1, 0.8)))
    project = Project(CLIP)
    for _ in range(3):
        project, shape = edit.new_shape(project, SQUARE, CLIP.first)
        project = edit.set_properties(project, shape.id, opacity=fades)
    window.document.open(project, None)
    QApplication.processEvents()
    assert height(window) >= few + 3 * ROW_HEIGHT
    assert (rows.height(), window.timeline.band_rooms[1].height()) == (3 * ROW_HEIGHT, 3 * ROW_HEIGHT)


def test_a_dragged_height_is_kept_in_every_size_of_the_window(window: MainWindow) -> None:
    window.resize(1000, 900)
    drag_border(window, -60)
    dragged = height(window)
    assert dragged == pytest.approx(LEAST + 60, abs=3)
    window.resize(1400, 1600)
    assert height(window) == dragged
    window.resize(1000, 900)
    assert height(window) == dragged


def test_after_the_tall_timeline_the_dragged_height_is_back(window: MainWindow) -> None:
    window.resize(1000, 1200)
    drag_border(window, -40)
    dragged = height(window)
    window.actions_by_id["view.tall_timeline"].trigger()
    assert height(window) == pytest.approx(window._halves.height() / 2, abs=3)
    window.actions_by_id["view.tall_timeline"].trigger()
    assert height(window) == dragged


def test_the_next_window_has_the_dragged_height(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    drag_border(window, -30)
    window.keep_settings(tmp_path / "window.ini")
    with opened_window(qtbot, None, tmp_path / "other") as other:
        other.restore_settings(tmp_path / "window.ini")
        assert height(other) == height(window)


@pytest.mark.parametrize("kept", [{"dragged": {"pixels": "high"}}, {"dragged": {"pixels": -4}}, {"other": {}}])
def test_what_makes_no_sense_changes_nothing(window: MainWindow, kept: dict[str, dict[str, str]]) -> None:
    before = height(window)
    window.timeline_height.recall(kept)
    assert height(window) == before
