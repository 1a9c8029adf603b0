"""UnderWay: one place for the news of all long work, one key to stop it."""

from __future__ import annotations

import pytest
from PySide6.QtCore import QObject, Qt, Signal
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.jobs.runner import Ending
from app.jobs.under_way import UnderWay
from app.model.view_state import ViewState
from app.panels.bars.status import StatusBar
from tests.gui.waiting import WAIT


class Work(QObject):
    progress = Signal(float, str)
    finished = Signal(object, str)

    def __init__(self) -> None:
        super().__init__()
        self.stops = 0

    def stop(self) -> None:
        self.stops += 1


@pytest.fixture
def works(qapp: QApplication) -> tuple[Work, Work]:
    return Work(), Work()


def test_work_is_under_way_until_the_last_of_it_ends(works: tuple[Work, Work]) -> None:
    under_way, changes = UnderWay(*works), []
    under_way.changed.connect(lambda: changes.append(under_way.is_any))
    works[0].progress.emit(0.1, "tracking")
    works[1].progress.emit(0.2, "exporting")
    works[0].finished.emit(Ending.DONE, "tracked")
    assert under_way.is_any
    works[1].finished.emit(Ending.FAILED, "disk full")
    assert changes == [True, True, True, False]


def test_one_stop_stops_all(works: tuple[Work, Work]) -> None:
    UnderWay(*works).stop()
    assert [work.stops for work in works] == [1, 1]


def test_the_work_that_began_first_is_told_until_it_ends(
    qtbot: QtBot, view_state: ViewState, works: tuple[Work, Work]
) -> None:
    status = StatusBar(view_state, UnderWay(*works))
    qtbot.addWidget(status)
    status.show_stop_keys("Esc")
    works[0].progress.emit(0.25, "Tracking body forward")
    works[1].progress.emit(0.5, "Exporting")
    assert status.sentence.text() == "Tracking body forward"
    assert status._hint.text() == "Esc stops  ·  1 more"
    works[0].finished.emit(Ending.DONE, "Tracked body.")
    works[1].progress.emit(0.75, "Exporting")
    assert (status.sentence.text(), status.bar.value()) == ("Tracked body.", 750)
    status.reading.timeout.emit()
    assert status.sentence.text() == "Exporting"
    assert status._hint.text() == "Esc stops"


def test_the_status_bar_has_a_button_that_stops_all(
    qtbot: QtBot, view_state: ViewState, works: tuple[Work, Work]
) -> None:
    status = StatusBar(view_state, UnderWay(*works))
    qtbot.addWidget(status)
    status.show_stop_keys("Esc")
    assert status.stop.isHidden()
    works[0].progress.emit(0.25, "Tracking body forward")
    assert not status.stop.isHidden()
    assert "(Esc)" in status.stop.toolTip()
    qtbot.mouseClick(status.stop, Qt.MouseButton.LeftButton)
    assert [work.stops for work in works] == [1, 1]


def test_the_status_bar_tells_how_far_and_how_to_stop_it(
    qtbot: QtBot, view_state: ViewState, works: tuple[Work, Work]
) -> None:
    status = StatusBar(view_state, UnderWay(*works))
    qtbot.addWidget(status)
    assert status.bar.isHidden()
    works[0].progress.emit(0.25, "Tracking body forward")
    assert not status.bar.isHidden()
    assert status.bar.value() == 250
    assert status.sentence.text() == "Tracking body forward"
    works[0].finished.emit(Ending.DONE, "Tracked body.")
    assert status.bar.isHidden()
    assert status.sentence.text() == "Tracked body."
    view_state.say("Select a shape first.")
    assert status.sentence.text() == "Select a shape first."


def test_what_is_said_while_work_goes_on_stands_until_it_is_read(
    qtbot: QtBot, view_state: ViewState, works: tuple[Work, Work]
) -> None:
    status = StatusBar(view_state, UnderWay(*works))
    qtbot.addWidget(status)
    works[0].progress.emit(0.25, "Tracking body forward: frame 7")
    view_state.say("Hat is locked.")
    works[0].progress.emit(0.5, "Tracking body forward: frame 8")
    assert (status.sentence.text(), status.bar.value()) == ("Hat is locked.", 500)
    status.reading.timeout.emit()
    assert status.sentence.text() == "Tracking body forward: frame 8"
    view_state.say("Hat is locked.")
    view_state.say("")
    assert status.sentence.text() == "Tracking body forward: frame 8"
    view_state.say("Hat is locked.")
    works[0].finished.emit(Ending.DONE, "Tracked body.")
    assert status.sentence.text() == "Hat is locked."
    status.reading.setInterval(0)
    qtbot.waitUntil(lambda: status.sentence.text() == "Tracked body.", timeout=WAIT)
    assert not status.reading.isActive()


class Writing(Work):
    is_writing = True


def test_the_key_does_not_stop_what_writes_files(works: tuple[Work, Work]) -> None:
    export = Writing()
    under_way = UnderWay(export, works[0])
    export.progress.emit(0.1, "Exporting")
    assert not under_way.is_stopped_by_key
    works[0].progress.emit(0.1, "Tracking")
    assert under_way.is_stopped_by_key
    under_way.stop_by_key()
    assert (export.stops, works[0].stops) == (0, 1)


def test_files_are_written_until_the_last_of_them_is(works: tuple[Work, Work]) -> None:
    export = Writing()
    under_way = UnderWay(export, works[0])
    export.progress.emit(0.1, "Exporting")
    export.finished.emit(Ending.CANCELLED, "Export stopped.")
    assert under_way.is_any
    export.is_writing = False
    export.finished.emit(Ending.DONE, "Exported.")
    assert not under_way.is_any


class Opening(Work):
    is_opening = True


def test_what_is_saved_while_a_project_opens_does_not_end_that(works: tuple[Work, Work]) -> None:
    files = Opening()
    under_way = UnderWay(files, works[0])
    files.progress.emit(0.1, "Opening")
    files.finished.emit(Ending.DONE, "Saved.")
    assert under_way.is_any
    files.is_opening = False
    files.finished.emit(Ending.DONE, "Opened.")
    assert not under_way.is_any


def test_what_the_key_stops_is_told_before_what_is_written_beside_it(
    qtbot: QtBot, view_state: ViewState, works: tuple[Work, Work]
) -> None:
    export = Writing()
    status = StatusBar(view_state, UnderWay(export, works[0]))
    qtbot.addWidget(status)
    status.show_stop_keys("Esc")
    export.progress.emit(0.5, "Exporting")
    assert status._hint.text() == ""
    assert "Esc" not in status.stop.toolTip()
    works[0].progress.emit(0.25, "Tracking body forward")
    export.progress.emit(0.6, "Exporting")
    assert status.sentence.text() == "Tracking body forward"
    assert status._hint.text() == "Esc stops  ·  1 more"
    qtbot.mouseClick(status.stop, Qt.MouseButton.LeftButton)
    assert (export.stops, works[0].stops) == (0, 1)
    works[0].finished.emit(Ending.CANCELLED, "Stopped.")
    export.progress.emit(0.7, "Exporting")
    qtbot.mouseClick(status.stop, Qt.MouseButton.LeftButton)
    assert export.stops == 1
