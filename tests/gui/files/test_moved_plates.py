"""A project whose plate moved or changed: found again near it, or told in the status bar, with all shapes kept."""

from __future__ import annotations

import shutil
from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtWidgets import QMessageBox
from pytestqt.qtbot import QtBot

from app.canvas.plate.stage import LOST
from app.dialogs import questions
from app.shell.main_window import MainWindow
from roam_core.geometry import bezier
from roam_core.media import declared
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import Keyframe, Origin, RotoShape, edit, file, timing
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, Gate, opened_window, write_clip

SQUARE = bezier.polygon_points([[20.0, 20.0], [90.0, 20.0], [90.0, 80.0], [20.0, 80.0]])


@pytest.fixture
def window(qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate", 2), tmp_path / "journal") as window:
        window.document.save(tmp_path / "a.roam")
        yield window


def said_on_opening(qtbot: QtBot, window: MainWindow, path: Path) -> str:
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open(path)
    return window.status.sentence.text()


def test_a_plate_that_moved_is_found_near_the_project(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    (tmp_path / "media").mkdir()
    (tmp_path / "plate").rename(tmp_path / "media" / "plate")
    assert "Its plate was found at" in said_on_opening(qtbot, window, tmp_path / "a.roam")
    assert window.document.project.require_clip().path == tmp_path / "media" / "plate"
    assert window.reader.source is not None


def test_keys_that_were_tracked_with_a_departed_dial_are_told(qtbot: QtBot, window: MainWindow, tmp_path: Path) -> None:
    points = bezier.polygon_points([(8.0, 8.0), (40.0, 8.0), (40.0, 30.0)])
    inputs = "forward:best+firmness=2:0:from=1"
    keys = [Keyframe(1, points), Keyframe(2, points, origin=Origin.ENGINE, inputs=inputs)]
    shape = RotoShape("shape-1", "Body", tuple(keys))
    file.save(edit.add_items(window.document.project, [shape])[0], tmp_path / "b.roam")
    said = said_on_opening(qtbot, window, tmp_path / "b.roam")
    assert said.startswith("Opened b.roam. Keys were tracked with 'best+firmness=2', which turns a dial")
    assert said_on_opening(qtbot, window, tmp_path / "a.roam") == "Opened a.roam."


@pytest.mark.parametrize(
    ("half", "words"),
    [(True, "the project was made for"), (False, "is not that of the plate")],
    ids=["size", "content"],
)
def test_a_plate_of_another_size_or_content_is_told(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, half: bool, words: str
) -> None:
    for image in (tmp_path / "plate").iterdir():
        picture = cv2.imread(str(image))
        cv2.imwrite(str(image), picture[::2, ::2] if half else 255 - picture)
    assert words in said_on_opening(qtbot, window, tmp_path / "a.roam")


def test_another_sequence_in_the_folder_is_not_taken_for_the_plate(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    for frame in range(FIRST, FIRST + 3):
        shutil.copyfile(tmp_path / "plate" / f"plate.{FIRST + 1}.png", tmp_path / "plate" / f"matte.{frame}.png")
    assert said_on_opening(qtbot, window, tmp_path / "a.roam") == "Opened a.roam."
    assert window.reader.source.path == tmp_path / "plate"
    assert window.reader.source.frame_name(FIRST) == f"plate.{FIRST}"


@pytest.mark.parametrize("mattes", [2, 3])
def test_a_lost_plate_is_known_in_a_folder_with_another_sequence(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, mattes: int
) -> None:
    """The longer sequence was taken for it, and of two alike none."""
    new, mine = tmp_path / "renamed", tmp_path / "so" / "deep" / "that" / "nothing" / "is" / "near" / "a.roam"
    mine.parent.mkdir(parents=True)
    window.document.save(mine)
    (tmp_path / "plate").rename(new)
    for frame in range(FIRST, FIRST + mattes):
        shutil.copyfile(new / f"plate.{FIRST + 1}.png", new / f"matte.{frame}.png")
    assert "could not be opened" in said_on_opening(qtbot, window, mine)
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.file_actions.open_dropped([new])
    assert window.reader.source is not None
    assert window.reader.source.frame_name(FIRST) == f"plate.{FIRST}"


def test_a_clip_is_relinked_to_another_version_below_the_same_shapes(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document = window.document
    document.open(edit.new_shape(document.project, SQUARE, FIRST)[0], tmp_path / "a.roam")
    version = write_clip(tmp_path / "plate_v002", 3)
    for image in version.iterdir():
        cv2.imwrite(str(image), 255 - cv2.imread(str(image)))
    monkeypatch.setattr(questions, "choose_plate", lambda parent, start: version / f"plate.{FIRST + 1}.png")
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        window.actions_by_id["file.relink_clip"].trigger()
    clip = document.project.require_clip()
    assert (clip.path.parent, clip.first, clip.last) == (version, FIRST, FIRST + 2)
    assert [shape.name for shape in document.project.shapes] == ["Shape 1"]
    assert document.is_modified
    assert document.path == tmp_path / "a.roam"
    np.testing.assert_array_equal(shown.args[1], cv2.imread(str(version / f"plate.{FIRST}.png"))[..., ::-1])
    assert "is not that of the plate" in window.status.sentence.text()


def test_a_clip_is_read_again_with_what_was_rendered_meanwhile(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    """What was shown once stayed in memory; a run goes on from nothing that was found in it."""
    held, memory = window.document.project.require_clip(), window.propagation._memory
    path = tmp_path / "plate" / f"plate.{FIRST + 1}.png"
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.view_state.set_frame(FIRST + 1)
    cv2.imwrite(str(path), 255 - cv2.imread(str(path)))
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT) as shown:
        window.actions_by_id["file.reload_clip"].trigger()
    np.testing.assert_array_equal(shown.args[1], cv2.imread(str(path))[..., ::-1])
    assert (shown.args[0], window.view_state.frame) == (FIRST + 1, FIRST + 1)
    assert window.propagation._memory is not memory
    assert (window.document.project.require_clip(), window.document.is_modified) == (held, False)
    qtbot.waitUntil(lambda: "read anew" in window.status.sentence.text(), timeout=WAIT)


def test_frames_that_came_while_the_clip_was_open_are_taken_as_it_is_reloaded(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    document, view = window.document, window.view_state
    document.apply("Draw", edit.new_shape(document.project, SQUARE, FIRST)[0])
    shutil.copy(tmp_path / "plate" / f"plate.{FIRST}.png", tmp_path / "plate" / f"plate.{FIRST + 2}.png")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.actions_by_id["file.reload_clip"].trigger()
    assert document.project.require_clip().frame_range == range(FIRST, FIRST + 3)
    assert view.play_range == (FIRST, FIRST + 3)
    assert [shape.name for shape in document.project.shapes] == ["Shape 1"]
    (tmp_path / "plate").rename(tmp_path / "gone")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.actions_by_id["file.reload_clip"].trigger()
    assert document.project.require_clip().frame_range == range(FIRST, FIRST + 3)
    assert "plate" in window.status.sentence.text()


@pytest.mark.parametrize("follows", [True, False])
@pytest.mark.parametrize("opens", [True, False])
def test_a_plate_whose_pictures_are_numbered_anew_takes_keys_and_notes_along_if_the_artist_says_so(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, follows: bool, opens: bool
) -> None:
    document, view = window.document, window.view_state
    drawn = edit.new_shape(document.project, SQUARE, FIRST)[0]
    clip = clip_stamp(drawn.clip)
    inputs = stamp(drawn.shapes, FIRST + 1, FIRST, CONFIGS[DEFAULT_CONFIG], clip, forward=True)
    key = Keyframe(FIRST + 1, SQUARE, origin=Origin.ENGINE, inputs=inputs)
    tracked = drawn.with_shape(drawn.shapes[0].with_key(key))
    document.open(timing.set_mark(tracked, FIRST, "look"), tmp_path / "a.roam")
    document.save(tmp_path / "a.roam")
    view.set_frame(FIRST + 1)
    view.set_play_range(FIRST + 1, FIRST + 2)
    renumbered = tmp_path / ("plate" if opens else "plate_0001")
    renumbered.mkdir(exist_ok=True)
    for frame in (1, 2):
        picture = tmp_path / "plate" / f"plate.{FIRST + frame - 1}.png"
        (shutil.move if opens else shutil.copyfile)(picture, renumbered / f"plate.{frame:04d}.png")
    with qtbot.waitSignal(window.files.renumbered, timeout=WAIT):
        if opens:
            window.files.open(tmp_path / "a.roam")
        else:
            window.files.open_plate(renumbered)
    box = window.findChild(QMessageBox)
    assert box is not None
    assert "numbered from 1 now, not from 1001" in box.informativeText()
    assert (view.frame, view.play_range) == (2, (1, 3) if opens else (2, 3))  # relinked: the same picture, in and out
    assert document.is_modified
    assert document.path == tmp_path / "a.roam"
    wanted = f"Shift by {1 - FIRST}" if follows else "Leave them"
    next(button for button in box.buttons() if button.text() == wanted).click()
    (shape,), (mark,) = document.project.shapes, document.project.marks
    first = 1 if follows else FIRST
    assert shape.frames == (first, first + 1)
    assert mark.frame == first
    stale = Stamps.of(document.project.shapes, document.project.clip).is_stale(shape, shape.keys[1])
    assert stale is not follows
    assert document.undo_stack.count() == int(follows)


@pytest.mark.parametrize(
    ("first", "last", "told"),
    [
        (FIRST, FIRST + 1, f"Keys on frames {FIRST + 2} to {FIRST + 2} lie beside the clip now, which has"),
        (FIRST + 50, FIRST + 52, f"The keys lie on frames {FIRST} to {FIRST + 2}, none of them on"),
        (FIRST, FIRST + 5, ""),
    ],
)
def test_keys_that_a_cut_leaves_beside_the_clip_are_told(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, first: int, last: int, told: str
) -> None:
    document = window.document
    project, shape = edit.new_shape(document.project, SQUARE, FIRST)
    clip = replace(project.require_clip(), last=FIRST + 2)
    document.open(replace(project.with_shape(edit.key_here(shape, FIRST + 2)), clip=clip), None)
    cut = tmp_path / "cut"
    cut.mkdir()
    for frame in range(first, last + 1):
        cv2.imwrite(str(cut / f"plate.{frame}.png"), np.full((120, 160, 3), frame % 200, np.uint8))
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(cut)
    said = window.status.sentence.text()
    assert told in said
    assert ("Shift in time" in said) is bool(told)


def test_what_was_declared_of_the_plate_holds_for_its_next_version(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.files.open_clip(tmp_path / "plate", lambda source: declared(source, "linear", 25.0, 2.0))
    version = write_clip(tmp_path / "plate_v002", 3)
    with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
        window.files.open_plate(version)
    clip = window.document.project.require_clip()
    assert (clip.path, clip.colour_space, clip.fps, clip.pixel_aspect) == (version, "linear", 25.0, 2.0)


def test_a_version_of_the_plate_that_cannot_be_opened_changes_nothing(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    (tmp_path / "notes.txt").write_text("no plate")
    before = window.document.project
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(tmp_path / "notes.txt")
    assert window.document.project is before
    assert window.reader.source is not None


def test_what_is_drawn_while_the_plate_is_relinked_stays_and_so_do_frame_and_selection(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    document, view, version = window.document, window.view_state, write_clip(tmp_path / "plate_v002", 3)
    gate = Gate(monkeypatch, "read_version")
    window.files.open_plate(version)
    assert gate.reached.wait(WAIT / 1000)
    for _ in range(2):
        document.apply("Draw", edit.new_shape(document.project, SQUARE, FIRST)[0])
    view.set_frame(FIRST + 1)
    view.set_play_range(FIRST + 1, view.play_range[1])
    view.select(frozenset({document.project.shapes[1].id}))
    drawn, selection = document.project.shapes, view.selection
    document.save(tmp_path / "b.roam")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        gate.open.set()
    assert document.project.require_clip().path == version
    assert document.project.shapes == drawn
    assert document.path == tmp_path / "b.roam"
    assert document.is_modified
    assert (view.frame, view.selection) == (FIRST + 1, selection)
    assert view.play_range == (FIRST + 1, FIRST + 3)  # in stays, out was the clip's end


def test_what_was_done_before_the_plate_was_relinked_is_undone_and_redone_on_the_new_one(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    document, version = window.document, write_clip(tmp_path / "plate_v002", 3)
    for _ in range(3):
        document.apply("Draw", edit.new_shape(document.project, SQUARE, FIRST)[0])
    document.undo_stack.undo()
    document.save(tmp_path / "b.roam")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(version)
    for step, left in (("undo", 1), ("undo", 0), ("redo", 1), ("redo", 2), ("redo", 3)):
        getattr(document.undo_stack, step)()
        assert len(document.project.shapes) == left
        assert document.project.require_clip().path == version
        assert document.is_modified
    assert not document.undo_stack.canRedo()


def test_an_empty_viewer_says_that_the_plate_is_lost_until_it_is_relinked(
    qtbot: QtBot, window: MainWindow, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("app.files.reading.relinked", lambda project, _folder: project)
    (tmp_path / "plate").rename(tmp_path / "elsewhere")
    said_on_opening(qtbot, window, tmp_path / "a.roam")
    qtbot.waitUntil(lambda: window.canvas.words.sentence(window.canvas._snapshot()) == LOST, timeout=WAIT)
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(tmp_path / "elsewhere")
    qtbot.waitUntil(lambda: window.canvas.words.sentence(window.canvas._snapshot()) == "", timeout=WAIT)


def test_frames_that_came_since_are_told_and_taken_by_a_relink(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    """A plate that was still being written when the project was made."""
    for frame in (FIRST + 2, FIRST + 3):
        shutil.copy(tmp_path / "plate" / f"plate.{FIRST}.png", tmp_path / "plate" / f"plate.{frame}.png")
    said = said_on_opening(qtbot, window, tmp_path / "a.roam")
    assert said.startswith("Opened a.roam. The plate has frames 1001 to 1004 now, the project 1001 to 1002;")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(tmp_path / "plate")
    assert window.document.project.require_clip().last == FIRST + 3
    window.document.save(tmp_path / "b.roam")
    assert said_on_opening(qtbot, window, tmp_path / "b.roam") == "Opened b.roam."
    (tmp_path / "plate" / f"plate.{FIRST + 3}.png").unlink()  # what is missing is hatched in the timeline
    assert said_on_opening(qtbot, window, tmp_path / "b.roam") == "Opened b.roam."


def test_a_plate_that_was_numbered_anew_tells_that_no_key_lies_on_it(
    qtbot: QtBot, window: MainWindow, tmp_path: Path
) -> None:
    project, _ = edit.new_shape(window.document.project, SQUARE, FIRST)
    window.document.apply("Draw", project)
    for frame in (1, 2):
        (tmp_path / "new").mkdir(exist_ok=True)
        shutil.copy(tmp_path / "plate" / f"plate.{FIRST}.png", tmp_path / "new" / f"plate.{frame:04d}.png")
    with qtbot.waitSignal(window.files.finished, timeout=WAIT):
        window.files.open_plate(tmp_path / "new")
    said = window.status.sentence.text()
    assert said.startswith("The plate is new now; save to keep that. The keys lie on frames 1001 to 1001, none of them")
