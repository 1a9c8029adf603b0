"""The clip dialog: what was found is told, what the artist says holds, and who wants no question gets none."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QCoreApplication, QEvent, Qt
from PySide6.QtWidgets import QDialogButtonBox, QLabel
from pytestqt.qtbot import QtBot
from shiboken6 import isValid

from app.dialogs import questions
from app.dialogs.clip_dialog import ClipDialog, gaps_sentence
from app.jobs.found_clip import looked_at
from app.model.personal import Personal
from app.shell.main_window import MainWindow
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.media import declared
from roam_core.media.colour import to_display, to_engine
from roam_core.roto import Clip, Keyframe, Origin, Project, edit
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip
from tests.unit.media.conftest import write_parts

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, None, tmp_path / "journal", Personal(tmp_path)) as window:
        yield window


@pytest.fixture
def clip(tmp_path: Path) -> Path:
    """Eight frames, the third one missing."""
    folder = write_clip(tmp_path / "plate")
    (folder / f"plate.{FIRST + 2}.png").unlink()
    return folder


def asked(qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch) -> ClipDialog:
    """The dialog that File > Open clip shows."""
    monkeypatch.setattr(questions, "choose_clip_folder", lambda parent, start: clip)
    with qtbot.waitSignal(window.files.looked, timeout=WAIT):
        window.actions_by_id["file.open_clip"].trigger()
    (dialog,) = window.findChildren(ClipDialog)
    return dialog


def press(qtbot: QtBot, dialog: ClipDialog, which: QDialogButtonBox.StandardButton) -> None:
    qtbot.mouseClick(dialog.buttons.button(which), Qt.MouseButton.LeftButton)


OPEN, CANCEL = QDialogButtonBox.StandardButton.Open, QDialogButtonBox.StandardButton.Cancel


def test_it_tells_what_was_found(qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    said = [label.text() for label in dialog.findChildren(QLabel)]
    for sentence in ("plate", f"{FIRST}–{FIRST + 7}, 7 frames", str(FIRST + 2), "160 × 120", "8 bits"):
        assert sentence in said
    assert dialog.colours.currentText() == "sRGB (found)"
    assert not dialog.picture.pixmap().isNull()
    press(qtbot, dialog, CANCEL)
    assert window.document.project.clip is None


def test_a_clip_opens_as_it_was_found(
    qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        press(qtbot, dialog, OPEN)
    opened = window.document.project.require_clip()
    assert (opened.path, opened.fps, opened.colour_space, opened.pixel_aspect) == (clip, 24.0, "sRGB", 1.0)
    assert window.personal.recent[0].path == clip


def test_it_may_be_gone_before_what_is_chosen_has_come_to_an_end(
    qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As where unsaved work is asked about, and the dialog is closed while the question waits."""
    dialog = asked(qtbot, window, clip, monkeypatch)
    dialog.chosen.disconnect()

    def wait_for_an_answer() -> None:
        dialog.close()
        QCoreApplication.sendPostedEvents(dialog, QEvent.Type.DeferredDelete)

    dialog.chosen.connect(wait_for_an_answer)
    dialog._choose()
    assert not isValid(dialog)


def test_what_the_artist_says_holds_and_comes_back_with_the_project(
    qtbot: QtBot, window: MainWindow, clip: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    before = dialog.picture.pixmap().toImage()
    dialog.colours.setCurrentIndex(dialog.colours.findData("linear"))
    assert dialog.picture.pixmap().toImage() != before
    dialog.rate.setValue(25.0)
    dialog.aspect.setValue(2.0)
    assert dialog.picture.pixmap().width() > 1.9 * dialog.picture.pixmap().height()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        press(qtbot, dialog, OPEN)
    plate = looked_at(clip).source.read(FIRST)
    np.testing.assert_array_equal(shown.args[1], to_display(plate, "linear"))
    assert window.playback.fps == 25.0
    window.document.save(tmp_path / "a.roam")
    window.files.new()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        window.files.open(tmp_path / "a.roam")
    np.testing.assert_array_equal(shown.args[1], to_display(plate, "linear"))
    opened = window.document.project.require_clip()
    assert (opened.fps, opened.colour_space, opened.pixel_aspect) == (25.0, "linear", 2.0)


def test_the_question_can_be_put_off_for_good(
    qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    qtbot.keyClick(dialog.asks_no_more, Qt.Key.Key_Space)
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        press(qtbot, dialog, OPEN)
    assert not window.personal.preferences.asks_about_clips
    window.files.new()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.actions_by_id["file.open_clip"].trigger()


def test_a_first_frame_that_cannot_be_read_is_told_and_the_rest_opens(tmp_path: Path) -> None:
    folder = write_clip(tmp_path / "plate")
    damaged = folder / f"plate.{FIRST}.png"
    damaged.write_bytes(damaged.read_bytes()[:200])
    found = looked_at(folder)
    assert found.picture is None
    assert damaged.name in found.trouble


def test_no_clip_is_one_sentence(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.file_actions.open_dropped([tmp_path / "nothing.mov"])
    assert "nothing.mov" in window.status.sentence.text()
    assert window.findChildren(ClipDialog) == []
    with pytest.raises(RoamError):
        looked_at(tmp_path / "nothing")


def test_gaps_are_named_while_they_are_few() -> None:
    assert gaps_sentence(()) == "none"
    assert gaps_sentence((3, 5)) == "3, 5"
    assert gaps_sentence(tuple(range(10, 30))) == "20 frames, from 10 to 29"


def test_a_layer_is_chosen_among_those_of_the_files(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    folder = tmp_path / "parts"
    for frame in (1001, 1002):
        parts = [("depth", "", ("Z",)), ("beauty", "", ("R", "G", "B")), ("diffuse", "", ("R", "G", "B"))]
        write_parts(folder / f"p.{frame}.exr", parts)
    dialog = asked(qtbot, window, folder, monkeypatch)
    assert [dialog.layers.itemText(k) for k in range(3)] == ["depth.Z", "beauty", "diffuse"]
    assert dialog.layer == "beauty"
    before = dialog.picture.pixmap().toImage()
    with qtbot.waitSignal(window.files.looked, timeout=WAIT):
        dialog.layers.setCurrentText("depth.Z")
    assert dialog.picture.pixmap().toImage() != before
    assert window.findChildren(ClipDialog) == [dialog]
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        press(qtbot, dialog, OPEN)
    assert not shown.args[1].any()
    assert window.document.project.require_clip().layer == "depth.Z"
    window.document.save(tmp_path / "a.roam")
    window.files.new()
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        window.files.open(tmp_path / "a.roam")
    assert not shown.args[1].any()


def test_files_of_one_layer_offer_no_choice(
    qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    assert "Layer" not in [label.text() for label in dialog.findChildren(QLabel)]


def test_a_colour_space_of_open_color_io_is_offered_and_holds(
    qtbot: QtBot, window: MainWindow, clip: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    dialog = asked(qtbot, window, clip, monkeypatch)
    before = dialog.picture.pixmap().toImage()
    dialog.colours.setCurrentIndex(dialog.colours.findData("ARRI LogC4"))
    assert dialog.picture.pixmap().toImage() != before
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        press(qtbot, dialog, OPEN)
    plate = looked_at(clip).source.read(FIRST)
    np.testing.assert_array_equal(shown.args[1], to_display(plate, "ARRI LogC4"))
    assert window.document.project.require_clip().colour_space == "ARRI LogC4"
    np.testing.assert_array_equal(window.reader.engine_frame(FIRST), to_engine(plate, "ARRI LogC4"))


# ---- of the clip that is open


def settings(qtbot: QtBot, window: MainWindow) -> ClipDialog:
    """The dialog that File > Clip settings shows, once the look at the clip has ended: that is finished, too."""
    with qtbot.waitSignals([window.files.looked, window.files.finished], timeout=WAIT):
        window.actions_by_id["file.clip_settings"].trigger()
    return window.findChildren(ClipDialog)[-1]


def take(qtbot: QtBot, window: MainWindow, dialog: ClipDialog) -> None:
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        press(qtbot, dialog, QDialogButtonBox.StandardButton.Ok)


def test_what_is_said_of_the_open_clip_holds_below_the_same_shapes(
    qtbot: QtBot, window: MainWindow, clip: Path, tmp_path: Path
) -> None:
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.files.open(clip)
    tracked = Keyframe(FIRST + 1, SQUARE, origin=Origin.ENGINE)
    project, shape = edit.new_shape(window.document.project, SQUARE, FIRST)
    window.document.apply("Draw", project.with_shape(shape.with_key(tracked)))
    window.document.save(tmp_path / "a.roam")
    window.view_state.set_frame(FIRST + 3)
    before = window.document.project
    dialog = settings(qtbot, window)
    assert (dialog.windowTitle(), dialog.colour_space, dialog.fps) == ("Clip settings", "sRGB", 24.0)
    assert dialog.asks_no_more.isHidden()
    dialog.colours.setCurrentIndex(dialog.colours.findData("linear"))
    dialog.rate.setValue(25.0)
    dialog.aspect.setValue(2.0)
    take(qtbot, window, dialog)
    said = {"colour_space": "linear", "fps": 25.0, "pixel_aspect": 2.0}
    assert window.document.project == replace(before, clip=replace(before.require_clip(), **said))
    assert window.document.is_modified
    assert (window.view_state.frame, window.playback.fps) == (FIRST + 3, 25.0)
    assert window.view_state.message.endswith("Tracked frames are out of date: they were found in other colours.")
    plate = looked_at(clip).source.read(FIRST)
    window.view_state.set_frame(FIRST)
    qtbot.waitUntil(lambda: window.reader.plate(FIRST) is not None, timeout=WAIT)
    np.testing.assert_array_equal(window.reader.source.read(FIRST), plate)
    assert window.reader.source.colour_space == "linear"


def test_what_holds_is_shown_to_the_last_digit_and_left_alone_where_nothing_is_changed(
    qtbot: QtBot, window: MainWindow, clip: Path, tmp_path: Path
) -> None:
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.files.open_clip(clip, lambda source: declared(source, "ARRI LogC4", 24000 / 1001, 1.0))
    window.document.save(tmp_path / "a.roam")
    held = window.document.project.require_clip()
    dialog = settings(qtbot, window)
    assert (dialog.colour_space, dialog.fps) == ("ARRI LogC4", 24000 / 1001)
    take(qtbot, window, dialog)
    assert window.document.project.require_clip() is held
    assert not window.document.is_modified


def test_without_a_clip_there_are_no_settings_of_it(window: MainWindow) -> None:
    window.actions_by_id["file.clip_settings"].trigger()
    assert window.view_state.message == "There is no clip yet; open one."


def test_a_plate_that_is_gone_is_told_in_place_of_its_settings(window: MainWindow, clip: Path) -> None:
    window.document.open(Project(Clip.of(looked_at(clip).source)), None)  # as where no plate was found
    window.actions_by_id["file.clip_settings"].trigger()
    assert window.view_state.message.startswith("The plate of the project is not there")
