"""Nothing in the column jumps: each panel has one place, whatever is selected."""

from __future__ import annotations

from pathlib import Path

import pytest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from app.widgets.panel import Panel
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, MotionBlur, Project, edit
from tests.gui.windows import opened_window

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


def various() -> Project:
    """A plain shape, one with motion blur, one with that and a lifetime, a locked one, and an empty layer."""
    project = Project(clip=Clip(Path("plate"), 1, 20, (200, 150)))
    for _ in range(4):
        project, _shape = edit.new_shape(project, SQUARE, 1)
    _, blurred, short, locked = (shape.id for shape in project.shapes)
    project = edit.set_properties(project, blurred, motion_blur=MotionBlur())
    project = edit.set_properties(project, short, motion_blur=MotionBlur(), lifetime=(2, 9))
    return edit.add_layer(edit.set_properties(project, locked, locked=True))[0]


def places(window: MainWindow) -> dict[str, tuple[int, int]]:
    """Where each panel begins, and how high it is."""
    QApplication.processEvents()
    return {panel.title: (panel.y(), panel.height()) for panel in window.panel_column.findChildren(Panel)}


@pytest.mark.parametrize("height", [700, 1500])
def test_panels_keep_their_places_whatever_is_selected(qtbot: QtBot, tmp_path: Path, height: int) -> None:
    with opened_window(qtbot, None, tmp_path / "journal") as window:
        window.resize(1200, height)
        window.document.open(project := various(), None)
        at_first = places(window)
        ids = [shape.id for shape in project.shapes]
        for chosen in ({ids[0]}, {ids[1]}, {ids[2]}, {ids[3]}, set(ids)):
            window.view_state.select(frozenset(chosen))
            assert places(window) == at_first
        layer = next(item.id for item in project.root.items() if item.id not in ids)
        window.view_state.select(frozenset(), layers=frozenset({layer}))
        assert places(window) == at_first
