"""The program itself, under a virtual X server and driven by keys and mouse: draw, track, save."""

from __future__ import annotations

import signal
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest

from app.journal import recovery
from app.model.recent import Recent, save_recent
from roam_core.roto import Origin, file
from tests.gui.windows import COUNT, FIRST, SIZE, centre, write_clip
from tests.gui.x_window import NEEDS_SCREEN, PATIENCE, WINDOW, Screen, screen, settled, until

__all__ = ["screen"]

LAST, CORNERS, RADIUS = FIRST + COUNT - 1, 10, 24.0
TOOLS, MENU, PANELS, TIMELINE = 36, 30, 275, 229
"""Pixels of the window that are not the viewer, at its four sides."""
FIRST_CARD = (380, 150)
"""Where the start page shows what was opened last."""

pytestmark = NEEDS_SCREEN


@pytest.fixture
def project_path(tmp_path: Path) -> Path:
    """A project on a tiny clip, saved, without a shape: Ctrl+S then needs no file chooser."""
    from app.files.reading import clip_project

    path = tmp_path / "disc.roam"
    project, _source = clip_project(write_clip(tmp_path / "plate"))
    file.save(project, path)
    return path


def outline(frame: int) -> Iterator[tuple[float, float]]:
    """Corners on the screen of a polygon around the disc, in a window of `WINDOW` at the screen's corner.

    The fitted plate stands in the middle of the viewer; the viewer is what the bars and panels around it leave.
    """
    left, top, right, bottom = TOOLS, MENU, WINDOW[0] - PANELS, WINDOW[1] - TIMELINE
    scale = 0.95 * min((right - left) / SIZE[0], (bottom - top) / SIZE[1])
    for turn in np.linspace(0, 2 * np.pi, CORNERS, endpoint=False):
        x, y = centre(frame) + RADIUS * np.array([np.cos(turn), np.sin(turn)])
        yield (left + right) / 2 + scale * (x - SIZE[0] / 2), (top + bottom) / 2 + scale * (y - SIZE[1] / 2)


def tracked_frames(path: Path) -> list[int]:
    shapes = file.load(path).shapes
    return [key.frame for shape in shapes for key in shape.keys if key.origin is Origin.ENGINE]


def test_draw_track_and_save(screen: Screen, project_path: Path, tmp_path: Path) -> None:
    log = tmp_path / "output"
    with log.open("wb") as output:
        command = [sys.executable, "-m", "app", str(project_path)]
        program = subprocess.Popen(command, env=screen.environment, stdout=output, stderr=output)
        try:
            work(screen, program, project_path)
            assert program.wait(PATIENCE) == 0
        finally:
            program.kill()
    assert "Traceback" not in log.read_text()
    (shape,) = file.load(project_path).shapes
    assert shape.artist_frames == (FIRST,)
    assert shape.point_count == CORNERS
    assert np.hypot(*(shape.at(FIRST).anchors.mean(axis=0) - centre(FIRST))) < 6.0
    moved = shape.at(LAST).anchors.mean(axis=0) - shape.at(FIRST).anchors.mean(axis=0)
    assert np.hypot(*(moved - np.subtract(centre(LAST), centre(FIRST)))) < 6.0


def test_a_signal_ends_the_program_and_unsaved_work_waits_for_recovery(
    screen: Screen, project_path: Path, tmp_path: Path
) -> None:
    command = [sys.executable, "-m", "app", str(project_path)]
    program = subprocess.Popen(command, env=screen.environment)
    try:
        draw(screen, program, project_path)
        until(lambda: bool(screen.windows("disc.roam\\*")), "the mark of unsaved changes", program)
        program.send_signal(signal.SIGINT)
        assert program.wait(PATIENCE) == 0
    finally:
        program.kill()
    (found,) = recovery.offered(recovery.recoveries(tmp_path / "state" / "roam" / "journal"))
    assert found.original == project_path
    assert len(recovery.load(found)[0].shapes) == 1
    assert file.load(project_path).shapes == ()


def test_what_was_drawn_before_a_kill_is_offered_with_its_project(
    screen: Screen, project_path: Path, tmp_path: Path
) -> None:
    command = [sys.executable, "-m", "app", str(project_path)]
    root = tmp_path / "state" / "roam" / "journal"
    program = subprocess.Popen(command, env=screen.environment)
    try:
        draw(screen, program, project_path)
        until(lambda: any(b"RotoShape" in path.read_bytes() for path in root.glob("*/*.journal")), "the edit", program)
    finally:
        program.kill()
        program.wait(PATIENCE)
    assert file.load(project_path).shapes == ()
    program = subprocess.Popen(command, env=screen.environment)
    try:
        until(lambda: bool(screen.windows("Recover work")), "the offer", program)
        screen.do("windowfocus", screen.windows("Recover work")[0])
        screen.key("Return")
        until(lambda: bool(screen.windows("disc.roam\\*")), "the unsaved work", program)
        screen.do("windowfocus", screen.windows("disc.roam")[0])
        screen.key("ctrl+s")
        until(lambda: len(file.load(project_path).shapes) == 1, "the shape in the file", program)
        until(lambda: not screen.windows("disc.roam\\*"), "the saved title", program)
        screen.key("ctrl+q")
        assert program.wait(PATIENCE) == 0
    finally:
        program.kill()


def test_a_lasso_and_the_transform_box(screen: Screen, project_path: Path) -> None:
    program = subprocess.Popen([sys.executable, "-m", "app", str(project_path)], env=screen.environment)
    try:
        draw(screen, program, project_path)
        screen.key("ctrl+s")
        until(lambda: len(file.load(project_path).shapes) == 1, "the drawn shape", program)
        (drawn,) = file.load(project_path).shapes
        spots = np.array(list(outline(FIRST)))
        middle, reach = spots.mean(axis=0), np.ptp(spots[:, 0])
        # A free line about the right half, with Ctrl and Alt; then the box about it is dragged to the right.
        screen.do("keydown", "ctrl", "keydown", "alt")
        around = middle + reach * np.array([(0.0, -0.8), (0.8, -0.8), (0.8, 0.8), (0.0, 0.8), (0.0, 0.75)])
        screen.drag(*around)
        screen.do("keyup", "alt", "keyup", "ctrl")
        screen.key("t")
        inside = middle + reach * np.array((0.3, 0.1))
        screen.drag(inside, inside + np.array((20.0, 0.0)), inside + np.array((40.0, 0.0)))
        screen.key("Return", "ctrl+s")
        until(lambda: file.load(project_path).shapes != (drawn,), "the transformed shape", program)
        screen.key("ctrl+q")
        assert program.wait(PATIENCE) == 0
    finally:
        program.kill()
    (moved,) = file.load(project_path).shapes
    shift = moved.at(FIRST).anchors - drawn.at(FIRST).anchors
    right = drawn.at(FIRST).anchors[:, 0] > drawn.at(FIRST).anchors[:, 0].mean() + 1.0
    assert (shift[right, 0] > 3.0).all()
    assert not shift[~right].any()
    assert not shift[:, 1].any()


def test_a_project_of_before_is_opened_from_the_start_page_and_an_action_found(
    screen: Screen, project_path: Path, tmp_path: Path
) -> None:
    (tmp_path / "state" / "roam").mkdir(parents=True)
    save_recent([Recent(project_path, 0.0)], tmp_path / "state" / "roam" / "recent.json")
    program = subprocess.Popen([sys.executable, "-m", "app"], env=screen.environment)
    try:
        until(lambda: bool(screen.windows("untitled")), "the empty window", program)

        def is_open() -> bool:
            screen.click(*FIRST_CARD)  # again until the list is filled
            return bool(screen.windows(project_path.name))

        until(is_open, "the project of before", program)
        (window,) = screen.windows(project_path.name)
        screen.do("windowfocus", window)
        screen.key("ctrl+k")
        screen.do("type", "--delay", 60, "about")
        screen.key("Return")
        until(lambda: bool(screen.windows("About ROAM")), "the dialog that the palette found", program)
        screen.do("windowfocus", screen.windows("About ROAM")[0])
        screen.key("Escape")
        until(lambda: not screen.windows("About ROAM"), "the dialog's end", program)
        screen.do("windowfocus", window)
        screen.key("ctrl+q")
        assert program.wait(PATIENCE) == 0
    finally:
        program.kill()


def work(screen: Screen, program: subprocess.Popen[bytes], project_path: Path) -> None:
    """What the artist does."""
    draw(screen, program, project_path)
    screen.key("bracketright")

    def is_tracked() -> bool:
        screen.key("ctrl+s")  # while it tracks, too: the window is alive
        return tracked_frames(project_path) == list(range(FIRST + 1, LAST + 1))

    until(is_tracked, "the last tracked frame", program)
    screen.key("ctrl+q")


def draw(screen: Screen, program: subprocess.Popen[bytes], project_path: Path) -> None:
    """Wait for the window and draw a polygon around the disc."""
    until(lambda: bool(screen.windows(project_path.name)), "the window", program)
    window = screen.windows(project_path.name)[-1]
    settled(screen, window)
    screen.do("mousemove", WINDOW[0] // 3, WINDOW[1] // 3)
    screen.key("f", "p")
    for corner in outline(FIRST):
        screen.click(*corner)
    screen.key("Return")
