"""The curve editor in the program itself, under a virtual X server: a key and a tangent dragged with the real mouse."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtCore import QPointF, QRect
from pytestqt.qtbot import QtBot

from app.files.reading import clip_project
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Animated, ValueKey, edit, file
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip
from tests.gui.x_window import NEEDS_SCREEN, WINDOW, Screen, program_on, rest, screen, until

__all__ = ["screen"]

pytestmark = NEEDS_SCREEN

FADES = Animated((ValueKey(FIRST, 0.25), ValueKey(FIRST + 3, 0.5, slopes=(0.0, 0.0)), ValueKey(FIRST + 7, 0.75)))


@pytest.fixture
def project_path(tmp_path: Path) -> Path:
    """A saved project on a tiny clip, with a shape whose opacity varies."""
    path = tmp_path / "fades.roam"
    project, _source = clip_project(write_clip(tmp_path / "plate"))
    project, shape = edit.new_shape(project, polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)]), FIRST)
    file.save(project.with_shape(replace(shape, opacity=FADES)), path)
    return path


@pytest.fixture
def places(qtbot: QtBot, project_path: Path, tmp_path: Path) -> dict[str, tuple[float, float]]:
    """Where things lie in a window of that size, looked up in one that is not on the screen, and closed again."""
    with opened_window(qtbot, project_path, tmp_path / "looked up") as window:
        window.resize(*WINDOW)
        qtbot.wait(100)
        window.actions_by_id["view.curves"].trigger()
        plot = window.timeline.curves.plot
        settle(qtbot, window)

        def place(frame: float, percent: float) -> tuple[float, float]:
            point = plot.mapTo(window, plot.key_point(frame, percent).toPoint())
            return point.x(), point.y()

        key = plot.lines[0].keys[1]
        return {
            "key": place(key.frame, key.value),
            "there": place(key.frame + 1, 60.0),
            "beside": place(FIRST + 6, 5.0),
        }


def settle(qtbot: QtBot, window: MainWindow) -> None:
    """Wait until the plot lies where it will stay: nothing of it changes for a while."""
    plot, seen = window.timeline.curves.plot, [QRect()]

    def is_still() -> bool:
        qtbot.wait(300)
        seen.append(QRect(plot.mapTo(window, plot.rect().topLeft()), plot.size()))
        return bool(plot.lines) and seen[-1] == seen[-2] and seen[-1].bottom() < WINDOW[1]

    qtbot.waitUntil(is_still, timeout=WAIT)


def saved(path: Path) -> Animated:
    (shape,) = file.load(path).shapes
    assert isinstance(shape.opacity, Animated)
    return shape.opacity


def test_a_key_is_dragged_and_its_tangent_turned(
    screen: Screen, project_path: Path, places: dict[str, tuple[float, float]]
) -> None:
    with program_on(screen, project_path) as program:
        screen.do("mousemove", WINDOW[0] // 3, WINDOW[1] // 3)
        screen.key("f", "shift+t")
        rest()  # the window lays itself out
        screen.click(*places["beside"])
        drag(screen, places["key"], places["there"])
        screen.key("ctrl+s")
        until(lambda: saved(project_path) != FADES, "the moved key", program)
        moved = saved(project_path)
        assert moved.frames == (FIRST, FIRST + 4, FIRST + 7)
        assert abs(moved.keys[1].value - 0.6) < 0.02
        assert moved.keys[1].slopes == (0.0, 0.0)
        third = (places["beside"][0] - places["there"][0]) / 2  # one frame: a third of the span after the key
        end = places["there"][0] + third, places["there"][1]
        drag(screen, end, (end[0], end[1] - 15))
        screen.key("ctrl+s")
        until(lambda: saved(project_path) != moved, "the turned tangent", program)
        slopes = saved(project_path).keys[1].slopes
        assert slopes is not None
        assert slopes[0] == slopes[1] > 0.0
        screen.key("ctrl+z", "ctrl+z", "ctrl+s")
        until(lambda: saved(project_path) == FADES, "both steps undone", program)
        screen.key("ctrl+q")


def drag(screen: Screen, start: tuple[float, float], end: tuple[float, float]) -> None:
    """Press, move in steps, release, as a hand does."""
    steps = [QPointF(*start) + (QPointF(*end) - QPointF(*start)) * k / 4 for k in range(5)]
    screen.drag(*[(step.x(), step.y()) for step in steps])
