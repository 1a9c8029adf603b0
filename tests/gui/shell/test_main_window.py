"""The main window: everything is connected, keys reach where they should, nothing unsaved is lost, nothing survives."""

from __future__ import annotations

import threading
from collections.abc import Iterator
from pathlib import Path

import pytest
from PySide6.QtCore import QMimeData, QPointF, Qt, QUrl
from PySide6.QtGui import QDropEvent, QGuiApplication
from PySide6.QtWidgets import QMessageBox, QToolButton
from pytestqt.qtbot import QtBot

from app.actions.specs import SPECS
from app.dialogs import questions
from app.dialogs.clip_dialog import ClipDialog
from app.dialogs.mask_dialog import MaskDialog
from app.dialogs.questions import Unsaved
from app.features.playback import Repeat
from app.jobs import export
from app.jobs.runner import Ending, Report
from app.model.viewing import BackgroundKind
from app.shell.main_window import MainWindow
from app.widgets.panel import Panel
from roam_core.geometry.bezier import polygon_points
from roam_core.media import finding, open_clip
from roam_core.roto import BlendMode, Project, edit, file
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, opened_window, write_clip

SQUARE = polygon_points([(40, 30), (80, 30), (80, 70), (40, 70)])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        yield window


def draw(window: MainWindow) -> None:
    project, shape = edit.new_shape(window.document.project, SQUARE, FIRST)
    window.document.apply("Draw", project)
    window.view_state.select(frozenset({shape.id}))


def test_a_clip_opens_on_its_own_frames(window: MainWindow) -> None:
    assert window.view_state.frame == FIRST
    assert window.view_state.play_range == (FIRST, FIRST + COUNT)
    assert window.timeline.axis.scale.clip == (FIRST, FIRST + COUNT)
    assert not window.document.is_modified
    assert "8 frames" in window.status.sentence.text()


def test_every_action_is_connected(window: MainWindow) -> None:
    handled = set(window._handlers()) | {f"tool.{name}" for name in window.tool_column._names}
    switches = {"edit.history", "help.log", "view.panels", "view.tall_timeline", "time.loop", "time.ping_pong"}
    switches |= {"key.auto", "key.points", "key.ripple", "points.soft", "points.lasso", "window.full_screen"}
    for part in window.workspace.parts.values():
        switches |= {part.show_action.objectName(), part.float_action.objectName()}
    assert handled | switches == {spec.id for spec in SPECS}


def test_transport_keys_work_in_the_whole_window_and_edit_keys_in_the_viewer(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    button = window.tool_column.findChildren(QToolButton)[0]
    button.setFocus()
    qtbot.keyClick(button, Qt.Key.Key_Right)
    assert window.view_state.frame == FIRST + 1
    qtbot.keyClick(button, Qt.Key.Key_S)
    assert window.document.project.shapes[0].artist_frames == (FIRST,)
    window.canvas.setFocus()
    qtbot.keyClick(window.canvas, Qt.Key.Key_S)
    assert window.document.project.shapes[0].artist_frames == (FIRST, FIRST + 1)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Left, Qt.KeyboardModifier.ControlModifier)
    assert window.view_state.frame == FIRST
    qtbot.keyClick(window.canvas, Qt.Key.Key_End)
    assert window.view_state.frame == FIRST + COUNT - 1
    qtbot.keyClick(window.canvas, Qt.Key.Key_B)
    assert window.view_state.tool == "bezier"
    assert window.actions_by_id["tool.bezier"].isChecked()


def test_keys_that_mean_whole_shapes_and_layers_work_in_the_list_of_shapes(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    tree = window.shapes.tree
    tree.setFocus()
    qtbot.keyClick(tree, Qt.Key.Key_G, Qt.KeyboardModifier.ControlModifier)
    (layer,) = window.view_state.layers
    qtbot.keyClick(tree, Qt.Key.Key_D, Qt.KeyboardModifier.ControlModifier)
    assert [item.name for item in window.document.project.root.children] == ["Layer 1", "Layer 2"]
    qtbot.keyClick(tree, Qt.Key.Key_H)
    assert [item.visible for item in window.document.project.root.children] == [True, False]
    qtbot.keyClick(tree, Qt.Key.Key_Delete)
    assert [item.id for item in window.document.project.root.children] == [layer]


def test_letters_in_the_list_of_shapes_are_keys_and_select_no_row(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    first = window.view_state.selection
    draw(window)
    others = edit.set_properties(window.document.project, window.document.project.shapes[1].id, name="Torso")
    window.document.apply("Rename", edit.set_properties(others, others.shapes[0].id, name="Arm"))
    window.view_state.select(first.shapes)
    window.shapes.tree.setFocus()
    qtbot.keyClicks(window.shapes.tree, "t")
    assert window.view_state.tool == "transform"
    window.view_state.set_frame(FIRST + 1)
    qtbot.keyClicks(window.shapes.tree, "s")
    assert [shape.artist_frames for shape in window.document.project.shapes] == [(FIRST, FIRST + 1), (FIRST,)]
    qtbot.keyClicks(window.shapes.tree, "3x")
    assert window.view_state.selection == first


def test_typing_a_name_moves_no_playhead_and_plays_nothing(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    window.properties.name.setFocus()
    window.properties.name.selectAll()
    qtbot.keyClicks(window.properties.name, "jklio")
    qtbot.keyClick(window.properties.name, Qt.Key.Key_Return)
    assert window.document.project.shapes[0].name == "jklio"
    assert window.playback.speed == 0
    assert window.view_state.play_range == (FIRST, FIRST + COUNT)


def test_in_and_out_and_the_fields_of_the_transport(qtbot: QtBot, window: MainWindow) -> None:
    window.view_state.set_frame(FIRST + 2)
    qtbot.keyClick(window.canvas, Qt.Key.Key_I)
    window.view_state.set_frame(FIRST + 5)
    qtbot.keyClick(window.canvas, Qt.Key.Key_O)
    assert window.view_state.play_range == (FIRST + 2, FIRST + 6)
    window.transport._frame.setValue(FIRST + 7)
    assert window.view_state.frame == FIRST + 7
    qtbot.keyClick(window.canvas, Qt.Key.Key_Home)
    assert window.view_state.frame == FIRST + 2
    qtbot.keyClick(window.canvas, Qt.Key.Key_I, Qt.KeyboardModifier.AltModifier)
    assert window.view_state.play_range == (FIRST, FIRST + COUNT)


def test_undo_and_redo_name_what_they_do(qtbot: QtBot, window: MainWindow) -> None:
    undo, redo = window.actions_by_id["edit.undo"], window.actions_by_id["edit.redo"]
    assert not undo.isEnabled()
    draw(window)
    assert (undo.isEnabled(), undo.text()) == (True, "Undo Draw")
    qtbot.keyClick(window.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
    assert window.document.project.shapes == ()
    assert (redo.isEnabled(), redo.text()) == (True, "Redo Draw")
    assert window.status.sentence.text() == "Undone: Draw."
    redo.trigger()
    assert window.status.sentence.text() == "Redone: Draw."
    undo.trigger()
    assert not window.document.is_modified


def test_saving_happens_on_the_worker_while_edits_go_on(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: tmp_path / "a.roam")
    draw(window)
    saved = window.document.project
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):
        window.actions_by_id["file.save"].trigger()
        draw(window)
    assert file.load(tmp_path / "a.roam") == saved
    assert window.document.is_modified
    assert window.windowTitle().startswith("a.roam")
    window.document.undo_stack.undo()
    assert not window.document.is_modified


@pytest.mark.parametrize("kind", ["export", "review"])
@pytest.mark.parametrize("answer", ["Keep it running", "Stop it and close"])
def test_closing_asks_about_what_is_being_written(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, tmp_path: Path, kind: str, answer: str
) -> None:
    asked: list[tuple[str, str]] = []

    def click(box: QMessageBox) -> int:
        asked.append((box.text(), box.defaultButton().text()))
        next(button for button in box.buttons() if button.text() == answer).click()
        return 0

    monkeypatch.setattr(QMessageBox, "exec", click)
    done = threading.Event()

    def write(report: Report) -> str:
        while not done.wait(0.01):
            report.token.check()
        return "Written."

    if kind == "export":
        monkeypatch.setattr(export, "_export", lambda report, _: write(report))
        ended_by = window.export.finished
        window.export.start("nuke", tmp_path / "a.nk")
    else:
        ended_by = window.exporter.start(kind, write).ended
    window.close()
    assert asked == [("Stop the export and close?", "Keep it running")]
    if answer == "Keep it running":
        with qtbot.waitSignal(ended_by, timeout=WAIT) as ended:
            done.set()
        assert ended.args == [Ending.DONE, "Written."]
        assert window.isVisible()
        window.close()
    qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
    assert len(asked) == 1


def test_the_key_that_stops_leaves_an_export_alone(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    done = threading.Event()

    def write(report: Report, _request: object) -> str:
        report.progress(0.5, "Exporting")
        while not done.wait(0.01):
            report.token.check()
        return "Written."

    monkeypatch.setattr(export, "_export", write)
    with qtbot.waitSignal(window.export.progress, timeout=WAIT):
        window.export.start("nuke", tmp_path / "a.nk")
    stop = window.actions_by_id["track.stop"]
    assert not stop.isEnabled()
    window.planar.progress.emit(0.1, "Planar track")
    assert stop.isEnabled()
    stop.trigger()
    with qtbot.waitSignal(window.export.finished, timeout=WAIT) as finished:
        done.set()
    assert finished.args == [Ending.DONE, "Written."]


@pytest.mark.parametrize("answer", Unsaved)
def test_closing_asks_about_unsaved_changes(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, answer: Unsaved
) -> None:
    asked: list[str] = []
    monkeypatch.setattr(questions, "ask_unsaved", lambda parent, name: asked.append(name) or answer)
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: tmp_path / "a.roam")
    draw(window)
    window.close()
    if answer is Unsaved.CANCEL:
        assert window.isVisible()
    else:
        qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
    assert asked == ["untitled"]
    assert (tmp_path / "a.roam").exists() is (answer is Unsaved.SAVE)


@pytest.mark.parametrize("modifier", [Qt.KeyboardModifier.NoModifier, Qt.KeyboardModifier.AltModifier])
def test_a_clip_dropped_on_the_window_is_opened(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, modifier: Qt.KeyboardModifier
) -> None:
    other, data = write_clip(tmp_path / "other", 3), QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(other))])
    event = QDropEvent(QPointF(5, 5), Qt.DropAction.CopyAction, data, Qt.MouseButton.LeftButton, modifier)
    event.ignore()
    window.dragEnterEvent(event)  # by hand: Qt delivers drops only within a drag of the desktop's
    assert event.isAccepted()
    if modifier is Qt.KeyboardModifier.AltModifier:  # at once; else the artist sees first what was found
        with qtbot.waitSignal(window.document.replaced, timeout=WAIT):
            window.dropEvent(event)
    else:
        with qtbot.waitSignal(window.files.looked, timeout=WAIT):
            window.dropEvent(event)
        (dialog,) = window.findChildren(ClipDialog)
        with qtbot.waitSignal(window.document.replaced, timeout=WAIT):
            dialog.buttons.accepted.emit()
    assert window.document.project.require_clip().last == FIRST + 2


def test_shapes_dropped_on_the_window_join_the_project_as_one_step(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    draw(window)
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        window.export.start("nuke", tmp_path / "a.nk")
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT):
        window.file_actions.open_dropped([tmp_path / "a.nk"])
    assert len(window.document.project.shapes) == 2
    assert "Read 1 shape from a.nk" in window.status.sentence.text()
    assert window.view_state.selection.shapes == {window.document.project.shapes[-1].id}
    assert window.document.undo_stack.undoText() == "Import shapes"
    window.document.undo_stack.undo()
    assert len(window.document.project.shapes) == 1


def test_a_file_of_shapes_whose_name_says_nothing_is_known_when_it_is_dropped(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    """As on the command line, by how it begins; what else is dropped with it is left alone."""
    draw(window)
    with qtbot.waitSignal(window.export.finished, timeout=WAIT):
        window.export.start("nuke", tmp_path / "a.nk")
    (tmp_path / "a.nk").rename(tmp_path / "shapes.bak")
    (tmp_path / "notes.txt").write_text("nothing")
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT):
        window.file_actions.open_dropped([tmp_path / "shapes.bak", tmp_path / "notes.txt"])
    assert len(window.document.project.shapes) == 2


def test_the_menu_imports_files_and_folders_of_masks(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (tmp_path / "a.fxs").write_text("<Other/>")
    monkeypatch.setattr(questions, "choose_shapes", lambda parent, start, suffixes: tmp_path / "a.fxs")
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT):
        window.actions_by_id["file.import_shapes"].trigger()
    assert "no Silhouette shape file" in window.status.sentence.text()
    masks = write_clip(tmp_path / "masks", 2)
    monkeypatch.setattr(questions, "choose_folder", lambda parent, title, start: masks)
    window.actions_by_id["file.import_masks"].trigger()
    (dialog,) = window.findChildren(MaskDialog)
    with qtbot.waitSignal(window.importing.finished, timeout=WAIT) as finished:
        dialog.accept()
    assert "masks" in finished.args[1]


@pytest.mark.parametrize("name", ["file.import_shapes", "file.import_masks", "file.export_nuke", "file.export_mattes"])
def test_without_a_clip_nothing_is_asked_before_it_is_told(window: MainWindow, name: str) -> None:
    window.document.open(Project(), None)
    window.actions_by_id[name].trigger()  # a chooser would wait for an answer
    assert window.status.sentence.text() == (
        "There is nothing to export yet; open a clip first."
        if "export" in name
        else "Open a clip first: shapes come into its frames and pixels."
    )


def test_an_older_project_whose_shapes_are_summed_says_so(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    project = window.document.project
    for k in range(2):
        project, _ = edit.new_shape(project, SQUARE + k, FIRST)
    path = tmp_path / "old.roam"
    file.save(project, path)
    text = path.read_text()
    for version, is_told in ((2, True), (3, False)):
        path.write_text(text.replace('"version": 3', f'"version": {version}', 1))
        with qtbot.waitSignal(window.files.finished, timeout=WAIT):
            window.files.open(path)
        sentence = window.status.sentence.text()
        assert sentence.startswith("Opened old.roam.")
        assert ("It joins soft edges as older versions did (Plus)" in sentence) is is_told
        assert [shape.blend for shape in window.document.project.shapes][1] is (
            BlendMode.PLUS if is_told else BlendMode.ADD
        )


def test_a_plate_that_is_gone_is_told_and_the_shapes_are_still_there(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(finding, "LEVELS", 1)  # beside the test's own folder lie those of others
    draw(window)
    window.document.save(tmp_path / "a.roam")
    (tmp_path / "plate").rename(tmp_path / "elsewhere")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(tmp_path / "a.roam")
    assert len(window.document.project.shapes) == 1
    assert "plate could not be opened" in window.status.sentence.text()


def test_a_plate_that_was_moved_is_chosen_again_and_the_shapes_stay(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(finding, "LEVELS", 1)
    draw(window)
    window.document.save(tmp_path / "a.roam")
    (tmp_path / "plate").rename(tmp_path / "elsewhere")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(tmp_path / "a.roam")
    drawn = window.document.project.root
    monkeypatch.setattr(questions, "choose_clip_folder", lambda parent, start: tmp_path / "elsewhere")
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.file_actions.open_clip()
    assert window.document.project.root is drawn
    assert window.document.project.require_clip().path == tmp_path / "elsewhere"
    assert window.document.path == tmp_path / "a.roam"
    assert window.document.is_modified


def test_files_are_not_offered_to_the_cache(
    window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    asked: list[Path] = []
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: asked.append(start))
    window.file_actions.save()
    monkeypatch.setattr("app.files.file_actions.cache_folder", lambda: tmp_path)
    window.file_actions.save()
    assert [path.parent for path in asked] == [tmp_path, Path.home()]


def test_a_new_project_is_not_replaced_by_what_was_being_opened(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(write_clip(tmp_path / "other", 3))
        window.files.new()
    qtbot.waitUntil(lambda: window.writer.is_idle, timeout=WAIT)
    with qtbot.waitSignal(window.files.saved, timeout=WAIT):  # the worker has been through what it was given
        window.files.save(tmp_path / "a.roam")
    assert window.document.project.clip is None
    assert not window.under_way.is_any


def test_what_cannot_be_opened_is_one_sentence_and_changes_nothing(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    before = window.document.project
    (tmp_path / "bad.roam").write_text("no project", encoding="utf-8")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(tmp_path / "bad.roam")
    assert "bad.roam" in window.status.sentence.text()
    assert window.document.project is before


@pytest.mark.parametrize(
    ("action", "sentence"), [("track.forward", "Draw a shape first"), ("key.set", "Select a shape first")]
)
def test_what_cannot_be_done_says_why(window: MainWindow, action: str, sentence: str) -> None:
    window.actions_by_id[action].trigger()
    assert sentence in window.status.sentence.text()


def test_shape_verbs_are_one_step_each(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    before = window.document.project
    lock, unlock = "shape.lock", "shape.lock"
    for action in ("shape.duplicate", "shape.group", lock, "shape.hide", "shape.show_all", unlock, "shape.delete"):
        steps = window.document.undo_stack.count()
        window.actions_by_id[action].trigger()
        assert window.document.undo_stack.count() == steps + 1, action
    while window.document.project is not before:
        window.document.undo_stack.undo()
    assert window.document.undo_stack.index() == 1


def test_shapes_are_copied_cut_and_pasted_with_their_keys(qtbot: QtBot, window: MainWindow) -> None:
    draw(window)
    original = window.document.project.shapes[0]
    control = Qt.KeyboardModifier.ControlModifier
    qtbot.keyClick(window.canvas, Qt.Key.Key_C, control)
    qtbot.keyClick(window.canvas, Qt.Key.Key_V, control)
    pasted = window.document.project.shapes[-1]
    assert pasted.keys == original.keys
    assert (pasted.id, pasted.name) != (original.id, original.name)
    assert window.view_state.selection.shapes == {pasted.id}
    qtbot.keyClick(window.canvas, Qt.Key.Key_X, control)
    assert window.document.project.shapes == (original,)
    QGuiApplication.clipboard().setText("no shape")
    qtbot.keyClick(window.canvas, Qt.Key.Key_V, control)
    assert window.document.project.shapes == (original,)
    assert "no shape to paste" in window.status.sentence.text()


def test_the_last_used_settings_come_back(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    window.actions_by_id["time.loop"].trigger()
    window.resize(760, 640)  # fits on the screen that there is without a screen
    window.actions_by_id["edit.history"].trigger()
    window.panels.history.toggle()
    window.canvas.viewing.set_onion(before=7)
    window.canvas.viewing.set_background(kind=BackgroundKind.COLOUR, colour="#203040")
    window.keep_settings(tmp_path / "window.ini")
    with opened_window(qtbot, None, tmp_path / "other") as other:
        other.restore_settings(tmp_path / "window.ini")
        assert other.playback.repeat is Repeat.ONCE
        assert other.canvas.viewing.onion == window.canvas.viewing.onion
        assert other.canvas.viewing.background == window.canvas.viewing.background
        assert other.size() == window.size()
        assert not other.panels.history.isHidden()
        folded = [panel.title for panel in other.panel_column.findChildren(Panel) if panel.is_folded]
        assert folded == ["History"]
        (tmp_path / "bad.ini").write_text("[General]\ngeometry=nonsense\nmode=abacus\n", encoding="utf-8")
        other.restore_settings(tmp_path / "bad.ini")
        assert other.tracking.config == window.tracking.config


def test_views_and_panels_can_be_switched(qtbot: QtBot, window: MainWindow) -> None:
    qtbot.keyClick(window.canvas, Qt.Key.Key_1)
    assert window.canvas.mode == "source"
    assert window.actions_by_id["view.source"].isChecked()
    qtbot.keyClick(window.canvas, Qt.Key.Key_QuoteLeft)
    assert window.actions_by_id["view.hide_overlays"].isChecked()
    window.actions_by_id["view.panels"].trigger()
    assert window.panel_column.isHidden()
    window.actions_by_id["edit.history"].trigger()
    assert not window.panels.history.isHidden()
    window.actions_by_id["view.tall_timeline"].trigger()
    lower = window._halves.sizes()[1]
    assert lower > window._halves.height() / 3


def test_leaving_hides_the_window_at_once_and_waits_for_what_is_read_last(
    qtbot: QtBot, window: MainWindow, monkeypatch: pytest.MonkeyPatch
) -> None:
    seen: list[tuple[str, bool]] = []
    close_reader, close_journal = window.reader.close, window.journal.close

    def reader_closes(wait: float = 10.0) -> bool:
        seen.append(("reader" if wait else "told", window.isVisible()))
        return close_reader(wait)

    def journal_closes() -> None:
        seen.append(("journal", window.isVisible()))
        close_journal()

    monkeypatch.setattr(window.reader, "close", reader_closes)
    monkeypatch.setattr(window.journal, "close", journal_closes)
    window.close()
    qtbot.waitUntil(lambda: ("reader", False) in seen, timeout=WAIT)
    assert seen[:3] == [("told", False), ("journal", False), ("reader", False)]


def test_why_a_frame_has_no_picture_is_told_until_one_is_shown_again(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    plate = open_clip(tmp_path / "plate")
    last = tmp_path / "plate" / f"plate.{FIRST + COUNT - 1}.png"
    content = last.read_bytes()
    last.unlink()
    window.reader.open(plate)  # nothing of it is held
    window.view_state.set_frame(FIRST + COUNT - 1)
    qtbot.waitUntil(lambda: "no longer there" in window.status.sentence.text(), timeout=WAIT)
    last.write_bytes(content)
    window.view_state.set_frame(FIRST)
    qtbot.waitUntil(lambda: "no longer there" not in window.status.sentence.text(), timeout=WAIT)
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.view_state.set_frame(FIRST + COUNT - 1)
    window.view_state.say("Something else.")
    window.view_state.set_frame(FIRST)
    qtbot.waitUntil(lambda: window.canvas.stage.frame == FIRST, timeout=WAIT)
    assert window.status.sentence.text() == "Something else."
