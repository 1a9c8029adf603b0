"""The export dialog under the hand: every format, what may be chosen, what the export noted, that it can be stopped."""

from __future__ import annotations

import json
import threading
from collections.abc import Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QRect, Qt
from PySide6.QtWidgets import QApplication, QComboBox, QMessageBox, QWidget
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.dialogs.export_dialog import ExportDialog
from app.jobs.export import Export
from app.jobs.runner import Ending, Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice
from roam_core.interchange.matte_style import DataWindow, Depth, Gathering, MatteFile, Parts
from roam_core.interchange.mattes.exporter import MatteExporter
from roam_core.interchange.plain_json import JsonFormat
from roam_core.interchange.protocol import STANDARD, settled
from roam_core.roto import Clip, Keyframe, Origin, Project, edit
from tests.gui.waiting import WAIT
from tests.gui.windows import opened_window, write_clip

CLIP = Clip(Path("/plates/shot"), 1001, 1010, (64, 48))
SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def dialog(qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, tmp_path: Path) -> ExportDialog:
    """The dialog on a tracked square of ten frames, inverted, which Nuke does not hold."""
    project, shape = edit.new_shape(Project(CLIP), SQUARE, 1001)
    keys = [Keyframe(f, SQUARE + (f - 1001), origin=Origin.ENGINE) for f in range(1002, 1011)]
    document.open(project.with_shape(edit.set_engine_keys(shape, keys)), None)
    view_state.set_play_range(1003, 1006)
    dialog = ExportDialog(document, view_state, Export(document, runner), lambda suffix: tmp_path / f"shot{suffix}")
    qtbot.addWidget(dialog)
    with qtbot.waitExposed(dialog, timeout=WAIT):
        dialog.show()
    return dialog


def pick(field: QComboBox, value: str) -> None:
    field.setCurrentIndex(field.findData(str(value)))
    assert field.currentData() == str(value)


def export(qtbot: QtBot, dialog: ExportDialog) -> str:
    """Press Export, wait for the end; gives what the dialog tells."""
    with qtbot.waitSignal(dialog._export.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.start, LEFT)
    return dialog.notes.toPlainText()


def test_it_lists_every_format_there_is(dialog: ExportDialog) -> None:
    rows = [dialog.formats.topLevelItem(row) for row in range(dialog.formats.topLevelItemCount())]
    assert [(row.text(0), row.text(1)) for row in rows if row] == [(e.title, e.suffix) for e in EXPORTERS.values()]


def test_a_click_on_a_format_shows_what_it_can_be_asked(qtbot: QtBot, dialog: ExportDialog, tmp_path: Path) -> None:
    seen = {}
    for row, name in enumerate(EXPORTERS):
        item = dialog.formats.topLevelItem(row)
        assert item is not None
        place = dialog.formats.visualItemRect(item).center()
        qtbot.mouseClick(dialog.formats.viewport(), LEFT, pos=place)
        assert dialog.exporter.name == name
        seen[name] = dialog.keys.count(), dialog.mattes.isVisible(), dialog.path.name
    assert seen["nuke"] == (3, False, "shot.nk")
    assert seen["silhouette"] == (3, False, "shot.fxs")
    assert seen["mattes"] == (2, True, "shot_mattes")


def test_keys_tolerance_and_frames_reach_the_file(qtbot: QtBot, dialog: ExportDialog, tmp_path: Path) -> None:
    dialog.choose("json")
    assert not dialog.tolerance.isEnabled()
    export(qtbot, dialog)
    assert frames_in(tmp_path / "shot.json") == list(range(1001, 1011))
    pick(dialog.keys, KeyChoice.ARTIST)
    export(qtbot, dialog)
    assert frames_in(tmp_path / "shot.json") == [1001]
    pick(dialog.keys, KeyChoice.REDUCED)
    assert dialog.tolerance.isEnabled()
    qtbot.mouseClick(dialog.frames.in_out, LEFT)
    assert (dialog.frames.first.value(), dialog.frames.last.value()) == (1003, 1005)
    told = export(qtbot, dialog)
    assert frames_in(tmp_path / "shot.json") == [1003, 1005]
    assert told.splitlines()[0] == f"Exported to {tmp_path / 'shot.json'}."
    assert len(told.splitlines()) == 2
    assert dialog.hint.text() == "Replaces the file that is there."
    qtbot.mouseClick(dialog.all_frames, LEFT)
    assert dialog.options.frames is None


@pytest.mark.parametrize("parts", [Parts.ALL, Parts.SHAPE])
def test_the_hint_tells_of_mattes_that_are_there(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path, parts: Parts
) -> None:
    dialog.choose("mattes")
    pick(dialog.mattes.parts, parts)
    dialog.target.setText(str(tmp_path / "mattes"))
    first = {Parts.ALL: "matte.1001.png", Parts.SHAPE: "Shape_1/matte.1001.png"}[parts]
    assert dialog.hint.text() == f"The pictures are mattes/{first} and so on."
    dialog.frames.take(range(1003, 1005))
    export(qtbot, dialog)
    assert dialog.hint.text().endswith(" and so on. Replaces files that are there.")
    dialog.frames.take(range(1001, 1011))
    assert dialog.hint.text().endswith("Replaces files that are there.")
    dialog.mattes.resumes.setChecked(True)
    assert "Replaces" not in dialog.hint.text()
    dialog.mattes.resumes.setChecked(False)
    dialog.frames.take(range(1006, 1011))
    assert "Replaces" not in dialog.hint.text()
    dialog.frames.take(range(1001, 1011))
    pick(dialog.mattes.file, MatteFile.EXR)
    assert "Replaces" not in dialog.hint.text()


def test_the_hint_tells_of_any_file_of_a_format_that_writes_several(
    qtbot: QtBot, dialog: ExportDialog, document: Document, tmp_path: Path
) -> None:
    document.open(edit.new_shape(document.project, SQUARE + 20, 1001)[0], None)
    dialog.choose("mlt")
    dialog.target.setText(str(tmp_path / "splines.json"))
    assert dialog.hint.text() == ""
    export(qtbot, dialog)
    assert not (tmp_path / "splines.json").exists()
    assert dialog.hint.text() == "Replaces files that are there."


def test_tracked_keys_are_smoothed_through_time_as_far_as_is_typed(
    qtbot: QtBot, dialog: ExportDialog, document: Document, tmp_path: Path
) -> None:
    (shape,) = document.project.shapes
    shaken = [Keyframe(f, SQUARE + 2.0 * (f % 2), origin=Origin.ENGINE) for f in range(1002, 1011)]
    document.open(document.project.with_shape(edit.set_engine_keys(shape, shaken)), None)
    dialog.choose("json")
    export(qtbot, dialog)
    as_tracked = corners_in(tmp_path / "shot.json")
    dialog.smoothing.setFocus()
    dialog.smoothing.selectAll()
    qtbot.keyClicks(dialog.smoothing, "0.5")
    told = export(qtbot, dialog)
    strays = np.abs(corners_in(tmp_path / "shot.json") - as_tracked)
    assert strays[0].max() == 0.0  # the artist's own
    assert 0.3 < strays[1:].max() <= 0.51
    assert "smoothed through time" in told
    pick(dialog.keys, KeyChoice.ARTIST)
    assert not dialog.smoothing.isEnabled()
    assert dialog.options.smoothing == 0.0
    pick(dialog.keys, KeyChoice.EVERY)
    assert dialog.options.smoothing == 0.5


def test_the_artists_name_stays_when_the_format_changes(qtbot: QtBot, dialog: ExportDialog, tmp_path: Path) -> None:
    dialog.choose("nuke")
    dialog.target.selectAll()
    qtbot.keyClicks(dialog.target, "hero")
    export(qtbot, dialog)
    assert (tmp_path / "hero.nk").is_file()
    dialog.target.setText(str(tmp_path / "hero.nk"))
    dialog.choose("silhouette")
    assert dialog.path == tmp_path / "hero.fxs"
    dialog.target.clear()
    assert not dialog.start.isEnabled()


def test_a_look_at_mattes_takes_no_name_away(dialog: ExportDialog, tmp_path: Path) -> None:
    dialog.choose("nuke")
    dialog.target.setText(str(tmp_path / "jobs" / "hero.nk"))
    dialog.choose("mattes")
    assert dialog.path == tmp_path / "shot_mattes"
    dialog.target.setText(str(tmp_path / "frames"))
    dialog.choose("silhouette")
    assert dialog.path == tmp_path / "jobs" / "hero.fxs"
    dialog.choose("mattes")
    assert dialog.path == tmp_path / "frames"


def test_mattes_are_written_as_chosen(qtbot: QtBot, dialog: ExportDialog, tmp_path: Path) -> None:
    dialog.choose("mattes")
    form = dialog.mattes
    assert [form.depths.itemData(row) for row in range(form.depths.count())] == ["8", "16"]
    assert not form.gathering.isEnabled()
    pick(form.file, MatteFile.EXR)
    pick(form.depths, Depth.FLOAT)
    pick(form.parts, Parts.SHAPE)
    pick(form.gathering, Gathering.CHANNELS)
    pick(form.pixels, DataWindow.TIGHT)
    dialog.frames.last.setValue(1002)
    export(qtbot, dialog)
    assert sorted(path.name for path in (tmp_path / "shot_mattes").iterdir()) == ["matte.1001.exr", "matte.1002.exr"]
    pick(form.file, MatteFile.PNG)
    assert (form.chosen.gathering, form.chosen.window) == (Gathering.FILES, DataWindow.FULL)


def test_the_first_matte_is_named_as_it_will_be_called(dialog: ExportDialog, document: Document) -> None:
    document.open(Project(replace(CLIP, first=0, last=5)), None)
    dialog.choose("mattes")
    assert "matte.0000.png" in dialog.hint.text()


def test_a_cryptomatte_has_its_own_depth_and_gives_the_other_back(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path
) -> None:
    dialog.choose("mattes")
    form = dialog.mattes
    pick(form.file, MatteFile.EXR)
    assert form.parts.itemText(0) == "All shapes together"
    pick(form.gathering, Gathering.CRYPTOMATTE)
    assert [form.depths.itemText(row) for row in range(form.depths.count())] == ["Float"]
    assert form.parts.itemText(0) == "Shapes and layers"
    assert (form.chosen.depth, form.chosen.parts) == (Depth.FLOAT, Parts.ALL)
    assert "matte.1001.exr" in dialog.hint.text()
    dialog.frames.last.setValue(1002)
    export(qtbot, dialog)
    assert sorted(path.name for path in (tmp_path / "shot_mattes").iterdir()) == ["matte.1001.exr", "matte.1002.exr"]
    content = (tmp_path / "shot_mattes" / "matte.1001.exr").read_bytes()
    assert b"uint32_to_float32" in content
    pick(form.gathering, Gathering.CHANNELS)
    assert (form.chosen.depth, form.parts.itemText(0)) == (Depth.HALF, "All shapes together")
    pick(form.gathering, Gathering.CRYPTOMATTE)
    pick(form.file, MatteFile.TIFF)
    assert (form.chosen.gathering, form.parts.itemText(0)) == (Gathering.FILES, "All shapes together")
    assert form.depths.count() == 3


def test_an_export_can_be_stopped_and_the_window_lives_meanwhile(
    qtbot: QtBot, dialog: ExportDialog, monkeypatch: pytest.MonkeyPatch
) -> None:
    begun, token = threading.Event(), []

    def wait(self: MatteExporter, project: Project, path: Path, options: object) -> tuple[str, ...]:
        assert threading.current_thread() is not threading.main_thread()
        token.append(options.token)  # type: ignore[attr-defined]
        begun.set()
        while True:
            token[0].check()

    monkeypatch.setattr(MatteExporter, "export", wait)
    dialog.choose("mattes")
    qtbot.mouseClick(dialog.start, LEFT)
    qtbot.waitUntil(begun.is_set, timeout=WAIT)
    assert not dialog.start.isEnabled()
    with qtbot.waitSignal(dialog._export.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.stop, LEFT)
    assert dialog.notes.toPlainText() == "Export stopped; the files that are finished stay."
    assert dialog.start.isEnabled()
    assert not dialog.stop.isEnabled()


def test_the_end_of_another_export_is_not_taken_for_its_own(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    is_asked, startable = threading.Event(), []

    def wait(self: JsonFormat, project: Project, path: Path, options: object) -> tuple[str, ...]:
        assert is_asked.wait(WAIT / 1000)
        return ()

    monkeypatch.setattr(JsonFormat, "export", wait)
    dialog._export.finished.connect(lambda *_: startable.append(dialog.start.isEnabled()))
    dialog.choose("silhouette")
    dialog._export.start("json", tmp_path / "other.json")
    qtbot.mouseClick(dialog.start, LEFT)
    is_asked.set()
    qtbot.waitUntil(lambda: len(startable) == 2, timeout=WAIT)
    assert startable == [False, True]
    assert "shot.fxs" in dialog.notes.toPlainText()


def test_stop_stops_the_dialogs_own_export_and_no_other(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It waits for one that was begun from the menu: that goes on, and nobody waits for it to hear of the stop."""
    is_stopped = threading.Event()

    def wait(self: JsonFormat, project: Project, path: Path, options: ExportOptions) -> tuple[str, ...]:
        assert is_stopped.wait(WAIT / 1000)
        assert options.token is not None
        options.token.check()
        return ()

    monkeypatch.setattr(JsonFormat, "export", wait)
    endings: list[Ending] = []
    dialog._export.finished.connect(lambda ending, _: endings.append(ending))
    dialog.choose("silhouette")
    dialog._export.start("json", tmp_path / "other.json")
    qtbot.mouseClick(dialog.start, LEFT)
    qtbot.mouseClick(dialog.stop, LEFT)
    assert endings == [Ending.CANCELLED]
    assert dialog.notes.toPlainText() == "Export stopped; the files that are finished stay."
    assert (dialog.start.isEnabled(), dialog.stop.isEnabled()) == (True, False)
    is_stopped.set()
    qtbot.waitUntil(lambda: not dialog._export.is_writing, timeout=WAIT)
    assert endings == [Ending.CANCELLED, Ending.DONE]
    assert not (tmp_path / "shot.fxs").exists()


def test_what_cannot_be_written_is_one_sentence(qtbot: QtBot, dialog: ExportDialog, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("no folder")
    dialog.choose("nuke")
    dialog.target.setText(str(tmp_path / "file" / "a.nk"))
    told = export(qtbot, dialog)
    assert told
    assert "\n" not in told
    assert "Exported" not in told


def test_no_format_proposes_the_file_of_another(dialog: ExportDialog) -> None:
    proposed = {}
    for name in EXPORTERS:
        dialog.choose(name)
        proposed[name] = dialog.path.name
    assert len(set(proposed.values())) == len(EXPORTERS)
    assert (proposed["nuke"], proposed["nuke-tracks"]) == ("shot.nk", "shot_tracks.nk")
    assert (proposed["nuke-python"], proposed["blender"]) == ("shot.py", "shot_blender.py")
    assert (proposed["json"], proposed["coco"]) == ("shot.json", "shot_coco.json")
    dialog.choose("nuke-tracks")
    dialog.target.setText(str(dialog.path.with_name("mine.nk")))
    seen = []
    for name in ("coco", "json", "nuke-tracks", "nuke"):
        dialog.choose(name)
        seen.append(dialog.path.name)
    assert seen == ["mine_coco.json", "mine.json", "mine_tracks.nk", "mine.nk"]


def test_a_dot_in_a_name_begins_no_suffix_and_a_long_name_is_told(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path
) -> None:
    dialog.choose("nuke")
    dialog.target.setText(str(tmp_path / "shot_010.v003"))
    assert dialog.path == tmp_path / "shot_010.v003.nk"
    dialog.choose("svg")
    assert dialog.path == tmp_path / "shot_010.v003.svg"
    dialog.target.setText("n" * 300)
    assert "is too long; choose a shorter one." in export(qtbot, dialog)


def test_browse_asks_for_a_file_or_a_folder(
    qtbot: QtBot, dialog: ExportDialog, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(questions, "choose_export", lambda parent, title, start, suffix: tmp_path / f"chosen{suffix}")
    monkeypatch.setattr(questions, "choose_folder", lambda parent, title, start: tmp_path / "folder")
    chosen = []
    for name in ("fusion", "mattes"):
        dialog.choose(name)
        qtbot.mouseClick(dialog.browse, LEFT)
        chosen.append(dialog.path.name)
    assert chosen == ["chosen.setting", "folder"]


def test_selected_shapes_alone_are_exported_where_that_is_asked_for(
    qtbot: QtBot, dialog: ExportDialog, document: Document, view_state: ViewState, tmp_path: Path
) -> None:
    project, other = edit.new_shape(document.project, SQUARE + 20.0, 1001, name="Other")
    project, layer = edit.add_layer(project)
    project, inner = edit.new_shape(project, SQUARE, 1001, name="Inner", layer_id=layer.id)
    document.open(project, None)
    dialog.choose("json")
    dialog.selected.click()
    assert not dialog.start.isEnabled()
    assert "No shape is selected" in dialog.hint.text()
    for chosen, names in (
        ({other.id}, ["Other"]),
        ({inner.id}, [layer.name]),
        ({other.id, inner.id}, ["Other", layer.name]),
    ):
        view_state.select(frozenset(chosen))
        export(qtbot, dialog)
        assert [item["name"] for item in json.loads((tmp_path / "shot.json").read_text())["items"]] == names
    view_state.select(frozenset())
    assert not dialog.start.isEnabled()
    dialog.selected.click()
    export(qtbot, dialog)
    assert len(json.loads((tmp_path / "shot.json").read_text())["items"]) == 3


class Flat(JsonFormat):
    """A format that holds no inverted shapes, and no names but short ones."""

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        notes, losses = [], []
        for shape in project.shapes:
            if shape.invert:
                losses.append(f"{shape.name!r} is not inverted there.")
            if len(shape.name) > 9:
                notes.append(f"{shape.name!r} was cut.")
        told = settled(notes, losses, options)
        super().export(project, path, options)
        return told


@pytest.fixture
def lossy(qtbot: QtBot, dialog: ExportDialog, document: Document, monkeypatch: pytest.MonkeyPatch) -> Document:
    """The dialog on a format that cannot hold the square, which is inverted."""
    monkeypatch.setitem(EXPORTERS, "json", Flat())
    (shape,) = document.project.shapes
    document.apply("Invert", document.project.with_shape(replace(shape, name="Inside out", invert=True)))
    dialog.choose("json")
    return document


TOLD = "'Inside out' is not inverted there.", "'Inside out' was cut."
LOSSES = f"The mattes would differ in the other program:\n{TOLD[0]}\n\nBesides:\n{TOLD[1]}"


def test_what_would_be_lost_is_shown_before_anything_is_written(
    qtbot: QtBot, dialog: ExportDialog, lossy: Document, tmp_path: Path
) -> None:
    qtbot.waitUntil(lambda: dialog.notes.toPlainText() == LOSSES, timeout=WAIT)
    assert dialog.start.text() == "Export anyway"
    assert list(tmp_path.iterdir()) == []
    told = export(qtbot, dialog)
    path = tmp_path / "shot.json"
    assert told.splitlines() == [f"Exported to {path}.", *TOLD]
    assert frames_in(path) == list(range(1001, 1011))


def test_the_loss_of_a_format_that_is_chosen_while_another_is_written_is_told_after_that(
    qtbot: QtBot, dialog: ExportDialog, lossy: Document
) -> None:
    dialog.choose("svg")
    with qtbot.waitSignal(dialog._export.finished, timeout=WAIT):
        qtbot.mouseClick(dialog.start, LEFT)
        dialog.choose("json")
    qtbot.waitUntil(lambda: dialog.notes.toPlainText() == LOSSES, timeout=WAIT)
    assert dialog.start.text() == "Export anyway"


def test_the_loss_is_told_of_what_is_chosen_now(
    qtbot: QtBot, dialog: ExportDialog, lossy: Document, view_state: ViewState
) -> None:
    qtbot.waitUntil(lambda: dialog.start.text() == "Export anyway", timeout=WAIT)
    dialog.choose("nuke")
    assert dialog.start.text() == "Export"
    dialog.choose("json")
    qtbot.waitUntil(lambda: dialog.start.text() == "Export anyway", timeout=WAIT)
    project, plain = edit.new_shape(lossy.project, SQUARE, 1001, name="Plain")
    lossy.apply("Draw", project)
    assert dialog.start.text() == "Export"  # not known yet: pressed now, it asks
    view_state.select(frozenset({plain.id}))
    with qtbot.waitSignal(dialog._foresight.seen, timeout=WAIT):
        dialog.selected.click()
    assert dialog.start.text() == "Export"
    assert dialog.notes.toPlainText() == ""
    with qtbot.waitSignal(dialog._foresight.seen, timeout=WAIT):
        dialog.selected.click()
    assert dialog.start.text() == "Export anyway"


@pytest.mark.parametrize("answer", [True, False])
def test_a_loss_that_was_not_seen_is_asked_about(
    qtbot: QtBot, dialog: ExportDialog, lossy: Document, tmp_path: Path, answer: bool
) -> None:
    asked: list[Sequence[str]] = []

    def ask(losses: Sequence[str]) -> bool:
        asked.append(losses)
        return answer

    dialog._export._may_lose = ask
    told = export(qtbot, dialog)  # before the losses are found out
    assert asked == [["'Inside out' is not inverted there."]]
    assert (tmp_path / "shot.json").exists() is answer
    assert told.startswith("Exported to" if answer else "Nothing was exported")


@pytest.mark.parametrize("answer", ["Export anyway", "Cancel"])
def test_the_question_names_what_would_be_lost(qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, answer: str) -> None:
    shown: list[str] = []

    def click(box: QMessageBox) -> int:
        shown.extend((box.informativeText(), box.detailedText()))
        next(button for button in box.buttons() if button.text().replace("&", "") == answer).click()
        return 0

    monkeypatch.setattr(QMessageBox, "exec", click)
    parent = QWidget()
    qtbot.addWidget(parent)
    monkeypatch.setattr(questions, "translated", str.upper)
    losses = [f"Shape {k} is lost." for k in range(9)]
    assert questions.ask_lossy(parent, losses) is (answer == "Export anyway")
    assert shown == ["\n".join(losses[:6]).upper(), "\n".join(losses).upper()]


def test_what_is_told_stays_until_something_else_is_known(qtbot: QtBot, dialog: ExportDialog, lossy: Document) -> None:
    qtbot.waitUntil(lambda: dialog.notes.toPlainText() == LOSSES, timeout=WAIT)
    project, _ = edit.new_shape(lossy.project, SQUARE, 1001, name="Plain")
    with qtbot.waitSignal(dialog._foresight.seen, timeout=WAIT):
        lossy.apply("Draw", project)
        assert dialog.notes.toPlainText() == LOSSES
    assert dialog.notes.toPlainText() == LOSSES
    dialog.choose("svg")
    assert dialog.notes.toPlainText() == ""
    assert dialog.notes.placeholderText().startswith("Looking")
    qtbot.waitUntil(lambda: dialog.notes.placeholderText() == "The format holds all that is chosen.", timeout=WAIT)


def test_an_export_that_would_be_refused_says_so_before(
    qtbot: QtBot, dialog: ExportDialog, document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Never(JsonFormat):
        def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
            raise RoamError("No such thing can be written.")

    monkeypatch.setitem(EXPORTERS, "json", Never())
    dialog.choose("json")
    qtbot.waitUntil(lambda: dialog.notes.toPlainText() == "No such thing can be written.", timeout=WAIT)


def test_nothing_moves_when_another_format_is_chosen(qtbot: QtBot, dialog: ExportDialog, lossy: Document) -> None:
    def places() -> list[QRect]:
        return [widget.geometry() for widget in (dialog, dialog.formats, dialog.notes, dialog.start, dialog.stop)]

    dialog.choose("svg")
    qtbot.waitUntil(lambda: dialog.notes.placeholderText().startswith("The format"), timeout=WAIT)
    before = places()
    dialog.choose("json")
    qtbot.waitUntil(lambda: dialog.start.text() == "Export anyway", timeout=WAIT)
    assert places() == before
    dialog.choose("mattes")
    QApplication.processEvents()
    assert places() == before


def test_without_a_clip_there_is_nothing_to_export(dialog: ExportDialog, document: Document) -> None:
    document.open(Project(), None)
    assert not dialog.start.isEnabled()
    assert dialog.hint.text() == "There is nothing to export yet; open a clip first."
    assert dialog.notes.placeholderText() == ""


def test_ctrl_e_opens_it_beside_the_work(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 3), tmp_path / "journal") as window:
        qtbot.keyClick(window.canvas, Qt.Key.Key_E, Qt.KeyboardModifier.ControlModifier)
        dialog = window.findChild(ExportDialog)
        assert dialog is not None
        assert dialog.isVisible()
        assert not dialog.isModal()
        assert (dialog.frames.first.value(), dialog.frames.last.value()) == (1001, 1003)
        qtbot.mouseClick(dialog.leave, LEFT)
        assert not dialog.isVisible()


def frames_in(path: Path) -> list[int]:
    """The frames of the keys of the only shape."""
    (shape,) = json.loads(path.read_text())["items"]
    return [key["frame"] for key in shape["keys"]]


def corners_in(path: Path) -> Array:
    """The anchors of the only shape on each of its keys, `(K, P, 2)`."""
    (shape,) = json.loads(path.read_text())["items"]
    return np.array([key["points"] for key in shape["keys"]], dtype=np.float64)
