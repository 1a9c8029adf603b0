"""An artist's way through the window, with real events: draw, track, stop, correct, resume, undo, save, export."""

from __future__ import annotations

import threading
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.dialogs import questions
from app.shell.main_window import MainWindow
from roam_core.roto import Origin, edit, file
from tests.gui.waiting import WAIT
from tests.gui.windows import (
    COUNT,
    FIRST,
    centre,
    click,
    drag,
    nothing_slow_in_the_window_thread,
    opened_window,
    shape,
    write_clip,
)

LAST = FIRST + COUNT - 1
CORNERS = 10


def outline(frame: int, radius: float = 24.0) -> list[tuple[float, float]]:
    """Corners of a polygon around the disc."""
    x, y = centre(frame)
    turns = np.linspace(0, 2 * np.pi, CORNERS, endpoint=False)
    return [(float(x + radius * np.cos(turn)), float(y + radius * np.sin(turn))) for turn in turns]


def engine_frames(window: MainWindow) -> list[int]:
    return [key.frame for key in shape(window.document.project).keys if key.origin is Origin.ENGINE]


def draw_disc(qtbot: QtBot, window: MainWindow) -> None:
    qtbot.keyClick(window.canvas, Qt.Key.Key_P)
    for corner in outline(FIRST):
        click(qtbot, window, corner)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Return)
    qtbot.keyClick(window.canvas, Qt.Key.Key_Q)


def track(qtbot: QtBot, window: MainWindow, key: Qt.Key) -> str:
    """Press a track key and wait for the end; gives the closing sentence."""
    with qtbot.waitSignal(window.propagation.finished, timeout=WAIT) as finished:
        qtbot.keyClick(window.canvas, key)
    return str(finished.args[1])


def test_the_artists_path(qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(questions, "choose_save", lambda parent, start: tmp_path / "disc.roam")
    monkeypatch.setattr(questions, "choose_export", lambda parent, title, start, suffix: tmp_path / f"disc{suffix}")
    clip = write_clip(tmp_path / "plate")
    with (
        nothing_slow_in_the_window_thread(monkeypatch) as slow_calls,
        opened_window(qtbot, clip, tmp_path / "journal") as window,
    ):
        document, view, canvas = window.document, window.view_state, window.canvas

        draw_disc(qtbot, window)
        assert shape(document.project).artist_frames == (FIRST,)
        assert shape(document.project).point_count == CORNERS

        # Track forward with ], to the end.
        assert f"to frame {LAST}" in track(qtbot, window, Qt.Key.Key_BracketRight)
        assert engine_frames(window) == list(range(FIRST + 1, LAST + 1))
        assert view.frame == LAST
        found = shape(document.project).at(LAST).anchors.mean(axis=0)
        assert np.hypot(*(found - centre(LAST))) < 6.0

        # One undo step takes the whole run back; redo brings it again.
        qtbot.keyClick(canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert engine_frames(window) == []
        qtbot.keyClick(canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier | Qt.KeyboardModifier.ShiftModifier)
        assert len(engine_frames(window)) == COUNT - 1

        # Correct a vertex on a tracked frame: it becomes an artist's key.
        view.set_frame(FIRST + 3)
        anchor = tuple(shape(document.project).at(FIRST + 3).anchors[0])
        drag(qtbot, window, anchor, (anchor[0] + 5, anchor[1] - 3))
        fixed = shape(document.project).key_at(FIRST + 3)
        assert fixed is not None
        assert fixed.origin is Origin.ARTIST

        # Resume from there: the correction stays, bit for bit.
        track(qtbot, window, Qt.Key.Key_F7)
        assert shape(document.project).key_at(FIRST + 3) is fixed
        assert shape(document.project).artist_frames == (FIRST, FIRST + 3)

        # Track across it, from before and from behind: it stays, bit for bit.
        for start, key in ((FIRST, Qt.Key.Key_F7), (LAST, Qt.Key.Key_F5)):
            view.set_frame(start)
            track(qtbot, window, key)
            assert shape(document.project).key_at(FIRST + 3) is fixed

        # Save, reopen, export.
        with qtbot.waitSignal(window.files.saved, timeout=WAIT):
            qtbot.keyClick(canvas, Qt.Key.Key_S, Qt.KeyboardModifier.ControlModifier)
        assert not document.is_modified
        saved = document.project
        window.file_actions.new()
        with qtbot.waitSignal(window.reader.picture, timeout=WAIT):
            window.files.open(tmp_path / "disc.roam")
        assert document.project == saved == file.load(tmp_path / "disc.roam")
        with qtbot.waitSignal(window.export.finished, timeout=WAIT):
            window.actions_by_id["file.export_nuke"].trigger()
        assert (tmp_path / "disc.nk").stat().st_size > 1000
    assert {"decode", "solve", "save"} <= set(slow_calls)


def test_two_shapes_are_tracked_in_one_run_and_one_step(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        before = window.document.project
        window.shape_verbs.duplicate()
        both = window.document.project
        window.view_state.select(frozenset(item.id for item in both.shapes))
        assert "Tracked 2 shapes" in track(qtbot, window, Qt.Key.Key_BracketRight)
        assert [each.frames for each in window.document.project.shapes] == [tuple(range(FIRST, LAST + 1))] * 2
        for expected in (both, before):
            qtbot.keyClick(window.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
            assert window.document.project is expected


def test_backslash_fills_between_two_keys(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        view, document = window.view_state, window.document
        view.set_frame(LAST)
        moved = shape(document.project).at(LAST).points + np.subtract(centre(LAST), centre(FIRST))
        document.apply("Move", document.project.with_shape(edit.set_key(shape(document.project), LAST, moved)))
        keyed = document.project
        view.set_frame(FIRST + 3)
        assert "Filled the frames" in track(qtbot, window, Qt.Key.Key_Backslash)
        assert engine_frames(window) == list(range(FIRST + 1, LAST))
        assert view.frame == FIRST + 3
        for frame in range(FIRST, LAST + 1):
            found = shape(document.project).at(frame).anchors.mean(axis=0)
            assert np.hypot(*(found - centre(frame))) < 2.0
        assert "Filled already" in track(qtbot, window, Qt.Key.Key_F6)
        qtbot.keyClick(window.canvas, Qt.Key.Key_Z, Qt.KeyboardModifier.ControlModifier)
        assert document.project is keyed


def test_escape_stops_the_run_and_keeps_what_is_finished(
    qtbot: QtBot, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        stop = window.actions_by_id["track.stop"]
        assert not stop.isEnabled()

        was_stopped = threading.Event()

        def press_escape() -> None:
            if len(engine_frames(window)) == 2:
                assert stop.isEnabled()
                qtbot.keyClick(window.canvas, Qt.Key.Key_Escape)
                was_stopped.set()

        def read(frame: int) -> Any:
            """The plate; after two tracked frames it waits for the key, so that there is something to stop."""
            assert frame <= FIRST + 2 or was_stopped.wait(WAIT / 1000)
            return window.reader.engine_frame(frame)

        window.document.changed.connect(press_escape)
        monkeypatch.setattr(window.propagation, "_read", read)
        sentence = track(qtbot, window, Qt.Key.Key_BracketRight)
        assert "the finished frames stay" in sentence
        assert engine_frames(window) == [FIRST + 1, FIRST + 2]
        assert not stop.isEnabled()
        assert len(window.document.project.shapes) == 1  # Esc stops; it never deletes


def test_closing_amid_a_run_ends_it(qtbot: QtBot, tmp_path: Path) -> None:
    """The fixtures see to it that no thread, timer or window survives."""
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "journal") as window:
        draw_disc(qtbot, window)
        qtbot.keyClick(window.canvas, Qt.Key.Key_BracketRight)
        assert window.propagation.is_running
        window._leave()
        qtbot.waitUntil(lambda: not window.isVisible(), timeout=WAIT)
        assert not window.propagation.is_running
