"""Reviewing under a virtual X server by keys alone: on to the frame that boils, a note on it, saved."""

from __future__ import annotations

from pathlib import Path

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Mark, Origin, edit, file
from tests.gui.windows import COUNT, FIRST, SIZE, write_clip
from tests.gui.x_window import NEEDS_SCREEN, PATIENCE, WINDOW, Screen, program_on, screen, until

__all__ = ["screen"]

BENT = FIRST + 4
SQUARE = polygon_points([(40, 40), (80, 40), (80, 80), (40, 80)])

pytestmark = NEEDS_SCREEN


def tracked_project(tmp_path: Path) -> Path:
    """A square that stands still, but for one point on one frame."""
    from app.files.reading import clip_project

    path = tmp_path / "disc.roam"
    project, _source = clip_project(write_clip(tmp_path / "plate"))
    project, shape = edit.new_shape(project, SQUARE, FIRST)
    outlines = {frame: np.array(SQUARE) for frame in range(FIRST + 1, FIRST + COUNT)}
    outlines[BENT][0] += 12.0
    keys = [Keyframe(frame, points, origin=Origin.ENGINE, confidence=0.9) for frame, points in outlines.items()]
    file.save(project.with_shape(edit.set_engine_keys(shape, keys)), path)
    return path


def test_n_goes_to_the_boil_and_a_note_is_typed_there(screen: Screen, tmp_path: Path) -> None:
    path = tracked_project(tmp_path)
    with program_on(screen, path) as program:
        screen.click((WINDOW[0] - SIZE[0]) / 2, 60)  # beside the shape: the viewer has the keyboard
        screen.key("n", "shift+m")
        screen.do("type", "the elbow")
        screen.key("Return", "ctrl+s")
        until(lambda: bool(file.load(path).marks), "the note in the file", program)
        assert file.load(path).marks == (Mark(BENT, "the elbow"),)
        screen.key("alt+m", "ctrl+q")
        assert program.wait(PATIENCE) == 0
