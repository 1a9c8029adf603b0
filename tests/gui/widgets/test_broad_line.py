"""A broad, pale line looks as pyqtgraph's own, which takes the square of its points."""

from __future__ import annotations

import numpy as np
import pyqtgraph as pg
import pytest
from PySide6.QtGui import QColor
from pytestqt.qtbot import QtBot

from app.widgets.broad_line import BroadLine
from roam_core.arrays import Array, Int64
from tests.gui.pixels import pixels_of
from tests.gui.waiting import WAIT

PALE = QColor(216, 216, 216, 80)
FRAMES = 400


@pytest.fixture
def line() -> tuple[Array, Array]:
    """A line that trembles, with a gap, and a frame by itself."""
    values = 0.5 + 0.2 * np.sin(1.7 * np.arange(FRAMES)) + 0.1 * np.sin(0.11 * np.arange(FRAMES))
    values[[150, 300, 302]] = np.nan
    return np.arange(FRAMES) + 0.5, values


def shown(qtbot: QtBot, item: pg.GraphicsObject, first: float, last: float) -> Int64:
    """The pixels of a plot of some frames with this alone."""
    view = pg.GraphicsView(background=(24, 24, 24))
    qtbot.addWidget(view)
    view.resize(500, 80)
    box = pg.ViewBox(enableMouse=False, enableMenu=False, defaultPadding=0)
    view.setCentralItem(box)
    box.addItem(item, ignoreBounds=True)
    box.setYRange(0.0, 1.0, padding=0)
    box.setXRange(first, last, padding=0)
    with qtbot.waitExposed(view, timeout=WAIT):
        view.show()
    return pixels_of(view)


@pytest.mark.parametrize("seen", [(0.0, FRAMES), (100.0, 180.0), (-50.0, 60.0)])
def test_it_has_the_pixels_of_one_that_is_stroked_at_once(
    qtbot: QtBot, line: tuple[Array, Array], seen: tuple[float, float]
) -> None:
    own = BroadLine(PALE, 3.0)
    own.set_line(*line)
    whole = pg.PlotCurveItem(*line, connect="finite", pen=pg.mkPen(PALE, width=3))
    a, b = shown(qtbot, own, *seen), shown(qtbot, whole, *seen)
    assert len(np.unique(a.reshape(-1, 3), axis=0)) == 2  # as pale where pieces overlap
    assert np.abs(a - b).max() <= 1


def test_nothing_is_shown_of_no_values(qtbot: QtBot) -> None:
    own = BroadLine(PALE, 3.0)
    own.set_line(np.zeros(0), np.zeros(0))
    assert len(np.unique(shown(qtbot, own, 0.0, 10.0).reshape(-1, 3), axis=0)) == 1
