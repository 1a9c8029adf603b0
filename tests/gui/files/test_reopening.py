"""What was opened is remembered, drawn, and offered again: on the start page and in the File menu."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtGui import QColor, QImage
from pytestqt.qtbot import QtBot

from app import style
from app.jobs.thumbnails import SIZE
from app.model.personal import Personal
from app.model.recent import MOST, Place, Recent, load_recent, save_recent, with_newest
from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import edit
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    personal = Personal(tmp_path, tmp_path / "cache")
    with opened_window(qtbot, None, tmp_path / "journal", personal) as window:
        yield window


def opened(qtbot: QtBot, window: MainWindow, path: Path) -> None:
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.files.open(path)
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)


def cards(window: MainWindow) -> list[str]:
    items = (window.reopening.page.recent.item(row) for row in range(window.reopening.page.recent.count()))
    return [item.text().splitlines()[0] for item in items]


def begun(qtbot: QtBot, window: MainWindow) -> None:
    """The start page is there and knows what is on the disk."""
    with qtbot.waitSignal(window.reopening._thumbnails.seen, timeout=WAIT):
        window.reopening.page.begin()


def test_the_list_is_bounded_and_a_path_stands_there_once() -> None:
    entries: tuple[Recent, ...] = ()
    for number in range(MOST + 5):
        entries = with_newest(entries, Recent(Path(f"/{number}"), number))
    assert len(entries) == MOST
    assert entries[0].path == Path(f"/{MOST + 4}")
    again = with_newest(entries, Recent(Path(f"/{MOST}"), 99.0))
    assert (again[0].when, len(again), len({entry.path for entry in again})) == (99.0, MOST, MOST)


@pytest.mark.parametrize(
    "text",
    [
        "{}",
        '{"recent": [3, {"path": 3}, {"when": 1}]}',
        '{"recent": [{"path": "/a", "when": "x"}, {"path": "/a", "when": NaN}, {"path": "/a", "when": 1e300}]}',
        '{"recent": [{"path": "\\u0000", "when": 1}, {"path": "\\ud800", "when": 1}, {"path": "", "when": 1}]}',
    ],
)
def test_entries_that_make_no_sense_are_not_remembered(tmp_path: Path, text: str) -> None:
    (tmp_path / "recent.json").write_text(text, encoding="utf-8")
    assert load_recent(tmp_path / "recent.json") == ()
    kept = Recent(Path("/a"), 1.0), Recent(Path("/b"), 1.0, Place(7)), Recent(Path("/c"), 1.0, Place(7, (3, 9)))
    save_recent(kept, tmp_path / "recent.json")
    assert load_recent(tmp_path / "recent.json") == kept


@pytest.mark.parametrize(
    ("told", "place"),
    [
        ({"frame": "7"}, None),
        ({"frame": True}, None),
        ({"frame": 1e9}, None),
        ({"in": 3, "stop": 9}, None),
        ({"frame": 7, "in": 9, "stop": 3}, Place(7)),
        ({"frame": 7, "in": 3}, Place(7)),
        ({"frame": 7, "in": 3, "stop": 10**12}, Place(7)),
    ],
)
def test_a_place_that_makes_no_sense_is_left_out(tmp_path: Path, told: dict[str, object], place: Place | None) -> None:
    entry = {"path": "/a", "when": 1.0} | told
    (tmp_path / "recent.json").write_text(json.dumps({"recent": [entry]}), encoding="utf-8")
    assert load_recent(tmp_path / "recent.json") == (Recent(Path("/a"), 1.0, place),)


@pytest.mark.parametrize("way", ["another", "restart", "again"])
def test_a_project_opens_where_it_was_left(qtbot: QtBot, window: MainWindow, tmp_path: Path, way: str) -> None:
    plate, path, view = write_clip(tmp_path / "plate"), tmp_path / "shot.roam", window.view_state
    opened(qtbot, window, plate)
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(path)
    view.set_play_range(FIRST + 2, FIRST + 6)
    view.set_frame(FIRST + 4)
    if way == "again":
        opened(qtbot, window, path)
        assert (view.frame, view.play_range) == (FIRST + 4, (FIRST + 2, FIRST + 6))
    elif way == "another":
        opened(qtbot, window, plate)
        assert (view.frame, view.play_range) == (FIRST, (FIRST, FIRST + COUNT))
        opened(qtbot, window, path)
        assert (view.frame, view.play_range) == (FIRST + 4, (FIRST + 2, FIRST + 6))
    else:
        window.close()
        qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
        with opened_window(qtbot, None, tmp_path / "next", Personal(tmp_path, tmp_path / "cache")) as again:
            opened(qtbot, again, path)
            assert (again.view_state.frame, again.view_state.play_range) == (FIRST + 4, (FIRST + 2, FIRST + 6))


def test_of_a_place_beside_the_clip_is_taken_what_the_clip_has(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    opened(qtbot, window, write_clip(tmp_path / "plate"))
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(tmp_path / "shot.roam")
    window.files.new()
    for place, frame, within in (
        (Place(FIRST + 99, (FIRST + 3, FIRST + 99)), FIRST + COUNT - 1, (FIRST + 3, FIRST + COUNT)),
        (Place(FIRST + 1, (FIRST + 50, FIRST + 99)), FIRST + 1, (FIRST, FIRST + COUNT)),
        (Place(FIRST + 1), FIRST + 1, (FIRST, FIRST + COUNT)),
    ):
        window.personal.note_place(tmp_path / "shot.roam", place)
        opened(qtbot, window, tmp_path / "shot.roam")
        assert (window.view_state.frame, window.view_state.play_range) == (frame, within)
        window.files.new()


def test_two_windows_remember_together(tmp_path: Path, qapp: object) -> None:
    first, second = Personal(tmp_path), Personal(tmp_path)
    first.note_recent(Path("/a"))
    second.note_recent(Path("/b"))
    first.note_recent(Path("/c"))
    assert [entry.path.name for entry in first.recent] == ["c", "b", "a"]


def test_an_empty_window_offers_what_there_is_to_do(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    page = window.reopening.page
    assert page.isHidden()  # a window that is about to open something shows no page for a moment
    begun(qtbot, window)
    assert page.isVisible()
    assert page.geometry() == window.canvas.rect()
    window.resize(900, 640)
    qtbot.waitUntil(lambda: page.geometry() == window.canvas.rect(), timeout=WAIT)
    opened(qtbot, window, write_clip(tmp_path / "plate", 2))
    assert page.isHidden()
    window.files.new()
    assert page.isVisible()


def test_what_was_opened_and_saved_comes_first_with_its_picture(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    clip = write_clip(tmp_path / "plate", 2)
    opened(qtbot, window, clip)
    project, shape = edit.new_shape(window.document.project, SQUARE, FIRST)
    window.document.apply("Draw", project)
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.files.save(tmp_path / "a.roam")
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)
    assert [entry.path for entry in window.personal.recent] == [tmp_path / "a.roam", clip]
    picture = QImage(str(window.personal.recent[0].picture_in(tmp_path / "cache")))
    assert picture.size() == SIZE
    # The left edge of the square, on the plate scaled to the picture's width.
    scale = SIZE.width() / 160
    top = (SIZE.height() - 120 * scale) / 2
    seen = picture.pixelColor(round(40 * scale), round(top + 50 * scale))
    assert (seen.redF(), seen.greenF(), seen.blueF()) == pytest.approx(shape.colour, abs=0.02)


def test_pictures_of_what_is_forgotten_go(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    first, second = write_clip(tmp_path / "first", 2), write_clip(tmp_path / "second", 2)
    opened(qtbot, window, first)
    picture = window.personal.recent[0].picture_in(tmp_path / "cache")
    qtbot.waitUntil(picture.exists, timeout=WAIT)
    window.personal.forget_recent(first)
    opened(qtbot, window, second)
    qtbot.waitUntil(lambda: not picture.exists(), timeout=WAIT)
    assert window.personal.recent[0].picture_in(tmp_path / "cache").exists()


def test_a_click_opens_it_again_and_what_is_gone_is_dim(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    clip = write_clip(tmp_path / "plate", 2)
    window.personal.note_recent(tmp_path / "gone.roam")
    window.personal.note_recent(clip)
    begun(qtbot, window)
    assert cards(window) == ["plate", "gone.roam"]
    listed = window.reopening.page.recent
    gone = listed.item(1)
    assert gone.foreground().color() == QColor(style.DISABLED)
    assert "not there any more" in gone.text()
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        qtbot.mouseClick(listed.viewport(), Qt.MouseButton.LeftButton, pos=listed.visualItemRect(gone).center())
    assert "gone.roam" in window.status.sentence.text()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        qtbot.mouseClick(
            listed.viewport(), Qt.MouseButton.LeftButton, pos=listed.visualItemRect(listed.item(0)).center()
        )
    assert window.document.project.require_clip().path == clip


def test_an_entry_is_taken_off_the_list(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.personal.note_recent(tmp_path / "gone.roam")
    begun(qtbot, window)
    window.reopening.page.recent.setCurrentRow(0)
    with qtbot.waitSignal(window.reopening._thumbnails.seen, timeout=WAIT):
        window.reopening.page.recent.actions()[0].trigger()
    assert cards(window) == []
    assert load_recent(tmp_path / "recent.json") == ()


def test_the_file_menu_lists_them_too(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.reopening.menu.aboutToShow.emit()
    assert [action.text() for action in window.reopening.menu.actions()] == ["Nothing yet"]
    clip = write_clip(tmp_path / "plate", 2)
    window.personal.note_recent(clip)
    window.reopening.menu.aboutToShow.emit()
    (entry,) = window.reopening.menu.actions()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        entry.trigger()
    assert window.document.project.require_clip().path == clip
