"""The artist's way with parts in the window: draw, stack, link, detach, track together and alone, look at doubts."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.features.tracking import Scope
from app.shell.main_window import MainWindow
from roam_core.params import DOUBTFUL
from roam_core.propagate.parts.edges import Edge
from roam_core.propagate.shapes.provenance import Stamp
from roam_core.roto import Origin, RotoShape
from roam_core.roto.linking import BEHIND
from tests.gui.waiting import WAIT
from tests.gui.windows import click, opened_window
from tests.unit.propagate.figures import Figure, body_with_arms, written

SHIFT, CTRL, NONE = (
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.NoModifier,
)
BODY, ARM = "shape-1", "shape-2"
LAST = 7


@pytest.fixture(scope="module")
def figure() -> Figure:
    return body_with_arms()


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path, figure: Figure) -> Iterator[MainWindow]:
    """The figure's plate, with its body and its arm drawn by hand on the first frame."""
    empty = written(figure, [], tmp_path)
    with opened_window(qtbot, empty, tmp_path / "state") as window:
        for part in figure.parts[:2]:
            qtbot.keyClick(window.canvas, Qt.Key.Key_P)
            corners = part.truth(0)[:, 0].tolist()
            for corner in (*corners, corners[0]):
                click(qtbot, window, tuple(corner))
        assert [shape.artist_frames for shape in window.document.project.shapes] == [(0,), (0,)]
        yield window


def shape(window: MainWindow, shape_id: str) -> RotoShape:
    return window.document.project.shape(shape_id)


def place_told(qtbot: QtBot, window: MainWindow, wanted: str) -> None:
    """Wait until the Shape panel tells this of what is selected."""
    qtbot.waitUntil(lambda: window.properties.object_form.place.text() == wanted, timeout=WAIT)


def track(qtbot: QtBot, window: MainWindow) -> str:
    window.view_state.set_frame(0)
    with qtbot.waitSignal(window.propagation.finished, timeout=WAIT) as finished:
        qtbot.keyClick(window.canvas, Qt.Key.Key_BracketRight)
    return str(finished.args[1])


def test_parts_are_linked_and_parted_again_by_their_keys(qtbot: QtBot, window: MainWindow) -> None:
    view, form = window.view_state, window.properties.object_form
    view.select(frozenset({BODY, ARM}))
    place_told(qtbot, window, "Part of 2")
    qtbot.keyClick(window.canvas, Qt.Key.Key_J, CTRL)
    place_told(qtbot, window, "Whole of 2 shapes (object-1)")
    assert form.solve.currentText() == "As one: object-1"
    qtbot.keyClick(window.canvas, Qt.Key.Key_J, CTRL | SHIFT)
    place_told(qtbot, window, "Part of 2")
    view.select(frozenset({ARM}))
    form.solve.setCurrentIndex(form.solve.findText("By itself"))
    form.solve.activated.emit(form.solve.currentIndex())
    place_told(qtbot, window, "By itself")
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, CTRL)
    place_told(qtbot, window, "Part of 2")


def test_a_joint_is_seen_and_undone(qtbot: QtBot, window: MainWindow) -> None:
    window.actions_by_id["view.joints"].trigger()
    window.view_state.select(frozenset({ARM}))
    qtbot.waitUntil(lambda: len(window.belonging.bones()) == 1, timeout=WAIT)
    window.properties.object_form.attached.click()
    assert not shape(window, ARM).attached
    qtbot.waitUntil(lambda: len(window.belonging.bones()) == 0, timeout=WAIT)


def test_depth_is_set_on_a_frame_marked_in_its_row_and_seen_at_the_edges(qtbot: QtBot, window: MainWindow) -> None:
    view, form = window.view_state, window.properties.object_form
    window.actions_by_id["view.edges"].trigger()
    view.select(frozenset({BODY, ARM}))
    qtbot.waitUntil(lambda: ARM in window.edge_kinds.here(), timeout=WAIT)
    assert window.edge_kinds.here()[ARM].share(Edge.HIDDEN) == 0.0
    view.select(frozenset({ARM}))
    view.set_frame(4)
    form.level.setCurrentIndex(form.level.findData(BEHIND))
    form.level.activated.emit(form.level.currentIndex())
    assert shape(window, ARM).depth == ((4, BEHIND),)
    assert view.message == f"{shape(window, ARM).name} lies behind the others from frame 4 on."
    qtbot.waitUntil(lambda: ARM in window.edge_kinds.here(), timeout=WAIT)
    qtbot.waitUntil(lambda: window.edge_kinds.here()[ARM].share(Edge.HIDDEN) > 0.1, timeout=WAIT)
    view.set_frame(0)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Right, CTRL)
    assert view.frame == 4


def test_several_are_tracked_in_one_run_and_one_alone(qtbot: QtBot, window: MainWindow) -> None:
    view = window.view_state
    steps = window.document.undo_stack.count()
    view.select(frozenset({BODY, ARM}))
    assert track(qtbot, window).startswith("Tracked 2 shapes")
    assert [shape(window, each).frames for each in (BODY, ARM)] == [tuple(range(LAST + 1))] * 2
    assert window.document.undo_stack.count() == steps + 1
    together = shape(window, ARM).key_at(LAST)
    view.select(frozenset({ARM}))
    panel = window.tracker
    panel.scope.setCurrentIndex(panel.scope.findData(Scope.ALONE))
    panel.scope.activated.emit(panel.scope.currentIndex())
    body = shape(window, BODY)
    track(qtbot, window)
    assert shape(window, BODY) is body
    alone = shape(window, ARM).key_at(LAST)
    assert together is not None
    assert alone is not None
    assert [Stamp.read(key.inputs).alone for key in (together, alone)] == [False, True]
    assert alone.origin is Origin.ENGINE


def test_n_goes_to_where_a_part_is_hidden(qtbot: QtBot, window: MainWindow) -> None:
    """From frame 3 on the arm lies behind all: what cannot be seen is doubted."""
    view = window.view_state
    view.select(frozenset({ARM}))
    small = shape(window, ARM)
    inside = small.map_points(lambda points: (points - points.mean(axis=(0, 1))) * 0.4 + (80.0, 70.0))
    window.document.apply("Shrink", window.document.project.with_shape(inside))
    view.set_frame(3)
    window.actions_by_id["object.behind"].trigger()
    view.select(frozenset())
    track(qtbot, window)
    doubted = [key.frame for key in shape(window, ARM).keys if key.confidence is not None and key.confidence < DOUBTFUL]
    view.select(frozenset({ARM}))
    view.set_frame(0)
    qtbot.keyClick(window.canvas, Qt.Key.Key_N)
    assert doubted
    assert view.frame == doubted[0] >= 3
    assert "confidence of" in view.message
