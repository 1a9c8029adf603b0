"""A small window: nothing is cut off without a sign of it, work under way does not widen it, the picture stays."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import pytest
from PySide6.QtCore import QRect
from PySide6.QtWidgets import QApplication, QMenuBar, QWidget
from pytestqt.qtbot import QtBot

from app import style
from app.jobs.runner import Ending
from app.panels.bars.readout import Readout
from app.panels.bars.top_bar import MENU_OVERFLOW
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit, timing
from roam_core.roto.value_keys import keyed, with_value
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])
FRAMES = 40
"""So many that time can be zoomed."""
NARROW = 760
"""A width in which the menus have no room."""
SENTENCE = "Tracking Torso forward: frame 16 of 69 · 162 ms a frame"


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    """A window of 1000 x 700 with three shapes, of which the last has keys of opacity and feather."""
    with opened_window(qtbot, write_clip(tmp_path / "plate", FRAMES), tmp_path / "state") as window:
        window.setStyleSheet(style.style_sheet())
        project = window.document.project
        for _ in range(3):
            project, shape = edit.new_shape(project, SQUARE, FIRST)
        for name in ("opacity", "feather"):
            shape = with_value(shape, name, lambda value: keyed(value, FIRST))
        window.document.apply("Draw", project.with_shape(shape))
        QApplication.processEvents()
        yield window


def resize(window: MainWindow, width: int, height: int) -> None:
    window.resize(width, height)
    QApplication.processEvents()


def place(widget: QWidget, window: MainWindow) -> QRect:
    return QRect(widget.mapTo(window, widget.rect().topLeft()), widget.size())


# ---- what does not fit


def test_all_menus_and_whole_controls_stand_in_a_window_of_1000(window: MainWindow) -> None:
    menus, bar = window.menuWidget().findChild(QMenuBar), window.view_bar
    assert all(menus.actionGeometry(action).right() <= menus.width() for action in menus.actions())
    assert bar.more.isVisible()
    looks = (bar.exposure, bar.gamma, bar.channel, bar.display)
    assert [look for look in looks if look.isVisible() and look.width() < look.minimumSizeHint().width()] == []
    wipe = bar._tail.findChildren(QWidget)[0]
    in_sight = [look for look in looks if bar._in_sight.isAncestorOf(look)]
    assert bar.channel in in_sight
    assert [look for look in in_sight if place(look, window).right() >= place(wipe, window).left()] == []
    assert place(bar, window).right() <= window.width()


def test_what_is_put_away_is_in_the_menu_and_comes_back(window: MainWindow) -> None:
    bar = window.view_bar
    assert bar.more.menu().isAncestorOf(bar._page)
    assert bar.more.menu().sizeHint().width() >= bar._page.minimumSizeHint().width()
    assert all(bar._page.isAncestorOf(look) and not look.isHidden() for look in (bar.exposure, bar.gamma))
    resize(window, 1500, 700)
    assert not bar.more.isVisible()
    assert all(look.isVisible() and bar._in_sight.isAncestorOf(look) for look in (bar.exposure, bar.gamma))
    lefts = [look.x() for look in (bar.exposure, bar.gamma, bar.channel, bar.display)]
    assert lefts == sorted(lefts)


def test_numbers_of_looking_give_way_to_what_the_plate_is(window: MainWindow) -> None:
    bar = window.view_bar
    resize(window, 1500, 700)
    assert bar._plate.width() >= bar._plate.sizeHint().width()
    room = bar._width_without(()) + bar._plate.sizeHint().width()
    for width, away in (
        (room, ()),
        (room - 1, (bar.gamma,)),
        (bar._width_without((bar.gamma, bar.exposure)), (bar.gamma, bar.exposure)),
    ):
        bar.fit(width)
        assert bar._put_away == away


def test_menus_without_room_are_behind_a_mark(window: MainWindow) -> None:
    resize(window, NARROW, 700)
    menus = window.menuWidget().findChild(QMenuBar)
    overflow = menus.findChild(QWidget, MENU_OVERFLOW)
    assert overflow.isVisible()
    shot = overflow.grab().toImage()
    shades = [shot.pixelColor(x, y).lightness() for x in range(shot.width()) for y in range(shot.height())]
    assert max(shades) > 2 * min(shades) + 50  # light chevrons on the dark bar


def test_tools_without_room_are_in_the_menu_of_the_last_button(window: MainWindow) -> None:
    column = window.tool_column
    assert not column.more.isVisible()
    window.actions_by_id["view.tall_timeline"].trigger()
    QApplication.processEvents()
    shown = [name for name, button in column.buttons.items() if button.isVisible()]
    hidden = [name for name in column.buttons if name not in shown]
    assert hidden
    assert column.more.geometry().bottom() < column.height()
    assert column.more.menu().actions() == [window.actions_by_id[f"tool.{name}"] for name in hidden]
    assert not column.more.isChecked()
    column.more.menu().actions()[-1].trigger()
    assert window.view_state.tool == hidden[-1]
    assert column.more.isChecked()
    window.actions_by_id["view.tall_timeline"].trigger()
    QApplication.processEvents()
    assert not column.more.isVisible()


# ---- work under way


def test_work_under_way_never_widens_the_window_and_is_read_as_a_whole(
    window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    status, least = window.status, window.minimumSizeHint().width()
    modes = place(status._modes, window)
    monkeypatch.setattr(type(window.under_way), "is_any", property(lambda _: True))
    window.under_way.changed.emit()
    window.under_way.progress.emit(0.2, SENTENCE)
    QApplication.processEvents()
    assert (window.width(), window.minimumSizeHint().width()) == (1000, least)
    assert status.sentence.width() >= status.sentence.fontMetrics().horizontalAdvance(SENTENCE)
    assert status.stop.isVisible()
    assert status.bar.isVisible()
    assert place(status._modes, window) == modes
    seen = {part: part.isVisible() for part in (status._memory, status._hint, status._readout)}
    window.under_way.progress.emit(0.3, SENTENCE[:-20])
    assert seen == {part: part.isVisible() for part in seen}  # nothing comes and goes with the sentence's length
    monkeypatch.undo()
    window.under_way.changed.emit()
    window.under_way.ended.emit(Ending.DONE, "")
    assert not status.stop.isVisible()
    assert not status.bar.isVisible()
    assert status._readout.isVisible()


def test_a_sentence_has_the_room_that_the_read_out_does_not_take(window: MainWindow) -> None:
    resize(window, 1300, 700)
    window.view_state.say("word " * 60)
    window.findChild(Readout).setText("")
    QApplication.processEvents()
    sentence, memory = place(window.status.sentence, window), place(window.status._memory, window)
    assert memory.left() - sentence.right() < 40


# ---- the picture stays where it is


def test_rows_come_and_go_within_the_height_of_the_timeline(window: MainWindow, qtbot: QtBot) -> None:
    def viewer() -> QRect:
        QApplication.processEvents()
        return place(window.canvas, window)

    first, second, keyed_one = window.document.project.shapes
    before = viewer()
    seen = []
    for shape in (first, keyed_one, second):
        window.view_state.select(frozenset({shape.id}))
        assert viewer() == before
        seen.append(window.timeline.value_rows.isVisible())
    assert seen == [False, True, False]
    window.view_state.select(frozenset({keyed_one.id}))
    window.document.apply("Mark", timing.set_mark(window.document.project, FIRST, "here"))
    assert viewer() == before
    parts = [
        part for part in window.timeline.children() if isinstance(part, QWidget) and part.isVisible() and part.height()
    ]
    parts.sort(key=lambda part: part.y())
    qtbot.waitUntil(
        lambda: all(above.geometry().bottom() < below.y() for above, below in pairwise(parts)), timeout=WAIT
    )
    assert parts[-1].geometry().bottom() < window.timeline.height()
    window.timeline.axis.set_scale(window.timeline.axis.scale.zoomed(2.0, 300.0))
    assert viewer() == before
    assert window.timeline.bar.isVisible()


def test_a_value_row_without_room_is_scrolled_to(window: MainWindow) -> None:
    window.view_state.select(frozenset({window.document.project.shapes[2].id}))
    QApplication.processEvents()
    room = window.timeline.band_rooms[1]
    assert room.height() < window.timeline.value_rows.height() == 44
    assert room.verticalScrollBar().maximum() > 0
    window.actions_by_id["view.tall_timeline"].trigger()
    QApplication.processEvents()
    assert room.height() == window.timeline.value_rows.height()


def test_shapes_do_not_move_the_border_either(window: MainWindow) -> None:
    before = window._halves.sizes()
    project = window.document.project
    window.document.apply("Delete", edit.remove_items(project, [shape.id for shape in project.shapes[1:]]))
    QApplication.processEvents()
    assert window._halves.sizes() == before
