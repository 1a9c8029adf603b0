"""One session in a real window: gestures by keys and mouse, and what they leave in the project and the settings."""

from __future__ import annotations

import json
import subprocess
import time
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QSettings

from roam_core.roto import Layer, Project, RotoShape, edit, file
from tests.gui.windows import COUNT, FIRST, SIZE
from tests.gui.x_window import NEEDS_SCREEN, PATIENCE, WINDOW, Screen, program_on, rest, screen, until

pytestmark = NEEDS_SCREEN
__all__ = ["screen"]

VIEWER = (36.0, 26.0, 925.0, 531.0)
WHOLE = (0.0, 0.0, *map(float, WINDOW))
"""Left, top, right and bottom of the viewer in a window of `WINDOW`, and in full screen."""
FRAME_FIELD, FLOAT_SHAPES, BORDER = (250, 550), (1176, 39), (500, 534)
"""On the screen: the field of the frame, the button that floats the list of shapes, the timeline's upper border."""
SQUARE = np.array([(100.0, 60.0), (150.0, 60.0), (150.0, 110.0), (100.0, 110.0)])
TRIANGLE = np.array([(20.0, 20.0), (140.0, 20.0), (140.0, 100.0)])
TALLER = 60


def write_ground(folder: Path) -> Path:
    """Ground with texture of several sizes, which glides by (2, 1) pixels a frame."""
    folder.mkdir()
    noise = np.random.default_rng(7)
    layers = [cv2.GaussianBlur(noise.standard_normal((SIZE[1], SIZE[0])), (0, 0), sigma) for sigma in (1.5, 4.0)]
    ground = 128.0 + 24.0 * sum(layer / layer.std() for layer in layers)
    for frame in range(COUNT):
        picture = np.roll(ground, (frame, 2 * frame), axis=(0, 1)).clip(0, 255).astype(np.uint8)
        assert cv2.imwrite(str(folder / f"plate.{FIRST + frame}.png"), cv2.merge([picture] * 3))
    return folder


def at(position: np.ndarray, area: tuple[float, float, float, float] = VIEWER) -> tuple[float, float]:
    """Where an image position stands on the screen: the fitted plate lies in the middle of the viewer."""
    left, top, right, bottom = area
    scale = min((right - left - 48.0) / SIZE[0], (bottom - top - 48.0) / SIZE[1])
    x, y = (np.array([left + right, top + bottom]) / 2 + scale * (position - np.array(SIZE) / 2)).tolist()
    return x, y


class Artist:
    """Works in the program, and saves to let the test see what came of it."""

    def __init__(self, screen: Screen, program: subprocess.Popen[bytes], path: Path) -> None:
        self.screen, self.program, self.path = screen, program, path

    def over_viewer(self) -> None:
        """The pointer over empty background: keys mean the viewer."""
        self.screen.do("mousemove", 80, 300)
        self.screen.do("mousemove", 82, 302)

    def until_saved(self, holds: Callable[[Project], bool], what: str) -> Project:
        """Save until the file shows it."""

        def is_there() -> bool:
            self.screen.key("ctrl+s")
            return holds(file.load(self.path))

        until(is_there, what, self.program)
        return file.load(self.path)


@pytest.fixture
def project_path(tmp_path: Path) -> Path:
    """Two squares on each other, `lower` and `upper`, on textured ground that glides."""
    from app.files.reading import clip_project

    path = tmp_path / "gestures.roam"
    project, _source = clip_project(write_ground(tmp_path / "plate"))
    for name in ("lower", "upper"):
        project, shape = edit.new_shape(project, np.repeat(SQUARE[:, None], 3, axis=1), FIRST)
        project = edit.set_properties(project, shape.id, name=name)
    file.save(project, path)
    return path


def test_a_session_of_gestures(screen: Screen, project_path: Path, tmp_path: Path) -> None:
    with program_on(screen, project_path) as program:
        artist = Artist(screen, program, project_path)
        rest()  # the picture comes
        take_the_next_shape_below(artist)
        open_a_menu(artist)
        type_a_frame(artist)
        track_the_surface(artist)
        draw_in_full_screen(artist)
        float_a_panel(artist)
        x, y = BORDER
        screen.drag(np.array([x, y]), np.array([x, y - TALLER // 2]), np.array([x, y - TALLER]))
        artist.over_viewer()
        screen.key("ctrl+q")
        assert program.wait(PATIENCE) == 0
    settings = QSettings(str(tmp_path / "state" / "roam" / "window.ini"), QSettings.Format.IniFormat)
    dragged = json.loads(str(settings.value("timeline")))["dragged"]["pixels"]
    assert abs(dragged - (WINDOW[1] - BORDER[1] - 24 + TALLER)) < 12  # 24: the status bar
    assert json.loads(str(settings.value("layout")))["shapes"]["floats"] is True


def named(project: Project, name: str) -> RotoShape:
    (found,) = [shape for shape in project.shapes if shape.name == name]
    return found


def take_the_next_shape_below(artist: Artist) -> None:
    """Click twice at one place of both outlines, and hide what is selected then."""
    artist.over_viewer()
    for _ in range(2):
        artist.screen.click(*at(np.array([125.0, 60.0])))
        time.sleep(0.6)  # no double click
    artist.screen.key("h")
    found = artist.until_saved(lambda project: not all(shape.visible for shape in project.shapes), "a hidden shape")
    assert [shape.name for shape in found.shapes if not shape.visible] == ["lower"]


def open_a_menu(artist: Artist) -> None:
    """A right click on a point, and the first entry of the menu: the point becomes smooth."""
    artist.screen.click(*at(np.array([125.0, 110.0])))
    x, y = at(SQUARE[1])
    artist.screen.do("mousemove", round(x), round(y), "click", 3)
    rest()
    artist.screen.key("Down", "Return")
    artist.over_viewer()

    def is_smooth(project: Project) -> bool:
        return edit.is_smooth(named(project, "upper").at(FIRST).control_points[1])

    artist.until_saved(is_smooth, "the smooth point")


def type_a_frame(artist: Artist) -> None:
    """After Return the keyboard belongs to the viewer: the next key sets a key on the frame that was typed."""
    artist.screen.click(*FRAME_FIELD)
    artist.screen.key("ctrl+a")
    artist.screen.do("type", "--delay", 60, str(FIRST + 3))
    artist.screen.key("Return")
    artist.over_viewer()
    artist.screen.key("s")
    wanted = (FIRST, FIRST + 3)
    artist.until_saved(lambda project: named(project, "upper").artist_frames == wanted, "a key on the typed frame")


def track_the_surface(artist: Artist) -> None:
    """From the first frame to the last, into a layer that moves."""
    artist.screen.key("Home", "alt+bracketright")

    def is_tracked(project: Project) -> bool:
        layers = [item for item in project.root.items() if isinstance(item, Layer) and item.transform is not None]
        return any(layer.transform and FIRST + COUNT - 1 in layer.transform.frames for layer in layers)

    artist.until_saved(is_tracked, "the planar track")


def draw_in_full_screen(artist: Artist) -> None:
    """The picture is as large as the window; a shape is drawn on it, and Esc leaves."""
    artist.screen.key("F11")
    rest()  # all is laid out: the clicks mean the picture's new places
    artist.screen.key("f", "p")
    for corner in TRIANGLE:
        artist.screen.click(*at(corner, WHOLE))
    artist.screen.key("Return")
    found = artist.until_saved(lambda project: len(project.shapes) == 3, "the shape drawn in full screen")
    (drawn,) = [shape for shape in found.shapes if shape.name not in ("lower", "upper")]
    np.testing.assert_allclose(drawn.at(FIRST).anchors, TRIANGLE, atol=1.5)
    artist.screen.key("Escape")
    rest()


def float_a_panel(artist: Artist) -> None:
    """The button in its title takes the list of shapes out of the window."""
    assert not artist.screen.windows("^Shapes$")
    artist.screen.click(*FLOAT_SHAPES)
    until(lambda: bool(artist.screen.windows("^Shapes$")), "the floating panel", artist.program)
