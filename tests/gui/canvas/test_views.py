"""The views: cut-out on its backgrounds, onion skin, alpha alone, channels and exposure, single pixels from near."""

from __future__ import annotations

import json
import threading
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QSizeF
from PySide6.QtGui import QColor, QImage, QPainter
from pytestqt.qtbot import QtBot

from app.canvas.items.onion import ghosts
from app.canvas.plate.backdrop import Backdrop
from app.canvas.plate.background import CHECKERS
from app.canvas.plate.picture import Picture
from app.canvas.plate.pixel_marks import paint_pixel_marks
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import Background, BackgroundKind, Onion, Viewing, ViewMode
from app.paint.viewport import LARGEST, Viewport
from roam_core.arrays import Float32
from roam_core.geometry.bezier import polygon_points
from roam_core.media.colour_spaces import offered_views
from roam_core.media.looking import Channel, Look, Plate, seen_plate
from roam_core.roto import Clip, Keyframe, Project, edit
from tests.gui.hand import CTRL, Hand
from tests.gui.waiting import WAIT

SQUARE = [(40.0, 40.0), (120.0, 40.0), (120.0, 100.0), (40.0, 100.0)]
GREY = QColor(100, 100, 100)


@pytest.fixture
def shape_id(canvas: CanvasView, document: Document) -> str:
    """A square that moves right by 4 pixels a frame, from a key on frame 1 to one on frame 11."""
    project, shape = edit.new_shape(document.project, polygon_points(SQUARE), 1)
    moved = shape.with_key(Keyframe(11, polygon_points([(x + 40.0, y) for x, y in SQUARE])))
    document.apply("Draw shape", project.with_shape(moved))
    return shape.id


def looks(canvas: CanvasView) -> QImage:
    return canvas.grab().toImage()


def colour_at(canvas: CanvasView, x: float, y: float) -> QColor:
    return looks(canvas).pixelColor(canvas.image_to_widget(x, y).toPoint())


def reach(canvas: CanvasView, key: str, hand: Hand, qtbot: QtBot) -> None:
    """Press a view's key and wait for its matte."""
    hand.key(key)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()


# ---- cut-out


def test_the_cut_out_shows_the_plate_inside_and_the_background_outside(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot
) -> None:
    reach(canvas, "4", hand, qtbot)
    assert canvas.mode is ViewMode.CUTOUT
    assert colour_at(canvas, 80.0, 70.0) == GREY
    assert colour_at(canvas, 10.0, 130.0) in CHECKERS
    canvas.viewing.set_background(kind=BackgroundKind.COLOUR, colour="#104020")
    assert colour_at(canvas, 10.0, 130.0) == QColor("#104020")
    assert colour_at(canvas, 80.0, 70.0) == GREY


def test_what_lies_below_is_painted_once_in_every_view(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    rendered: list[object] = []
    whole = Backdrop._render
    monkeypatch.setattr(Backdrop, "_render", lambda self, *given: (rendered.append(given), whole(self, *given)))
    reach(canvas, "4", hand, qtbot)
    for key in ("2", "3", "4", "5"):
        hand.key(key)
        looks(canvas)
        qtbot.waitUntil(lambda: canvas.stage.matte._running is None, timeout=WAIT)
        looks(canvas)
        count = len(rendered)
        looks(canvas)
        assert len(rendered) == count, key


def test_the_cut_out_lies_on_a_picture(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, tmp_path: Path
) -> None:
    path = tmp_path / "street.png"
    assert cv2.imwrite(str(path), np.full((30, 40, 3), (10, 20, 200), dtype=np.uint8))  # OpenCV writes blue first
    reach(canvas, "4", hand, qtbot)
    canvas.viewing.set_background(kind=BackgroundKind.IMAGE, image=str(path))
    with qtbot.waitSignal(canvas.stage.background.ready, timeout=WAIT):
        canvas.repaint()
    assert colour_at(canvas, 10.0, 130.0) == QColor(200, 20, 10)
    assert colour_at(canvas, 80.0, 70.0) == GREY


def test_a_background_that_is_no_picture_is_refused_in_a_sentence(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, tmp_path: Path, view_state: ViewState
) -> None:
    path = tmp_path / "street.png"
    path.write_text("no picture")
    reach(canvas, "4", hand, qtbot)
    canvas.viewing.set_background(kind=BackgroundKind.IMAGE, image=str(path))
    with qtbot.waitSignal(canvas.stage.background.refused, timeout=WAIT):
        canvas.repaint()
    assert "street.png" in view_state.message
    assert colour_at(canvas, 10.0, 130.0) in CHECKERS


def test_the_cut_out_never_mixes_two_frames(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, view_state: ViewState
) -> None:
    reach(canvas, "4", hand, qtbot)
    view_state.set_frame(11)  # its picture has not come yet
    assert colour_at(canvas, 45.0, 70.0) == GREY
    canvas.set_image(11, np.full((150, 200, 3), 30, dtype=np.uint8))
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    assert colour_at(canvas, 130.0, 70.0) == QColor(30, 30, 30)
    assert colour_at(canvas, 60.0, 70.0) in CHECKERS


def test_a_proxy_is_cut_out_too(canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot) -> None:
    canvas.set_image(1, np.full((75, 100, 3), 90, dtype=np.uint8))
    reach(canvas, "4", hand, qtbot)
    assert colour_at(canvas, 80.0, 70.0) == QColor(90, 90, 90)
    assert colour_at(canvas, 10.0, 130.0) in CHECKERS


def test_a_missing_frame_is_not_cut_out(canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot) -> None:
    reach(canvas, "4", hand, qtbot)
    canvas.set_image(1, None)
    assert canvas.stage.emptiness() == "frame 1 is missing or damaged"
    assert colour_at(canvas, 80.0, 60.0) != GREY


# ---- alpha


def test_a_shows_the_alpha_alone_and_again_what_was_before(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, view_state: ViewState
) -> None:
    hand.key("5")
    reach(canvas, "a", hand, qtbot)
    assert colour_at(canvas, 80.0, 70.0) == QColor(255, 255, 255)
    shown = looks(canvas)
    edge = canvas.image_to_widget(80.0, 40.0).toPoint()
    above = [shown.pixelColor(edge.x(), edge.y() + dy).getRgb()[:3] for dy in (-3, -2, 2, 3)]
    assert above == [(0, 0, 0)] * 2 + [(255, 255, 255)] * 2  # no outline over the edge
    hand.click((80.0, 40.0))
    assert not view_state.selection.shapes
    hand.key("a")
    assert canvas.mode is ViewMode.ONION


# ---- mattes that do not come


def test_the_matte_of_a_project_that_is_left_is_not_shown(
    canvas: CanvasView, document: Document, shape_id: str, qtbot: QtBot
) -> None:
    """It came after the other project was opened, and stayed until that one's own was there."""
    layer, gate, render = canvas.stage.matte, threading.Event(), canvas.stage.matte._render
    brightest: list[int] = []

    def note() -> None:
        shown = canvas.stage.shown_picture()
        brightest.append(0 if shown is None else int(shown.pixels.max()))

    def wait_and_render(project: Project, frame: int, size: tuple[int, int]) -> Float32:
        gate.wait(WAIT / 1000)
        return render(project, frame, size)

    layer._render = wait_and_render
    canvas.viewing.set_mode(ViewMode.MATTE)
    canvas.repaint()
    document.open(Project(clip=Clip(Path("other"), 1, 20, (200, 150))), None)
    canvas.stage.changed.connect(note)
    canvas.repaint()
    gate.set()
    qtbot.waitUntil(lambda: bool(brightest) and layer._running is None, timeout=WAIT)
    assert brightest == [0]


def test_a_matte_that_could_not_be_rendered_is_told(
    canvas: CanvasView, shape_id: str, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It was said to be rendered for ever."""

    def fail(*_: object) -> Float32:
        raise MemoryError

    monkeypatch.setattr(threading, "excepthook", lambda args: None)
    canvas.stage.matte._render = fail
    canvas.viewing.set_mode(ViewMode.MATTE)
    assert canvas.stage.emptiness() == "Rendering the matte …"
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    assert canvas.stage.emptiness() == "The matte could not be rendered"


# ---- onion skin


def test_ghosts_fade_with_their_distance_and_stay_in_the_clip(document: Document, canvas: CanvasView) -> None:
    found = ghosts(document.project, 2, Onion(before=3, after=2), [])
    assert [frame for frame, _ in found] == [4, 1, 3]
    opacity = dict(found)
    assert opacity[3] > opacity[4]


def test_ghosts_of_keys_however_far(document: Document, canvas: CanvasView, shape_id: str) -> None:
    onion = Onion(before=2, after=2, only_keys=True)
    shape = document.project.shape(shape_id)
    assert [frame for frame, _ in ghosts(document.project, 7, onion, [shape])] == [1, 11]
    assert ghosts(document.project, 7, replace(onion, before=0), [shape])[0][0] == 11


def test_the_onion_skin_draws_other_frames_of_the_selected_shape(
    canvas: CanvasView, hand: Hand, shape_id: str, document: Document, view_state: ViewState
) -> None:
    view_state.set_frame(6)
    canvas.set_image(6, np.full((150, 200, 3), 100, dtype=np.uint8))
    before, after = (44.0, 70.0), (76.0, 70.0)  # left sides on the frames 2 and 10; on 6 it stands at 60
    assert colour_at(canvas, *before) == colour_at(canvas, *after) == GREY
    hand.key("5")
    canvas.viewing.set_onion(before=1, after=1, step=4, before_colour="#ff0000", after_colour="#00ff00")
    assert colour_at(canvas, *before).red() > 120
    assert colour_at(canvas, *after).green() > 120
    project, other = edit.new_shape(document.project, polygon_points([(5.0, 5.0), (20.0, 5.0), (20.0, 20.0)]), 6)
    document.apply("Draw", project)
    view_state.select(frozenset({other.id}))
    assert colour_at(canvas, *before) == GREY
    canvas.viewing.set_onion(all_shapes=True)
    assert colour_at(canvas, *before).red() > 120


@pytest.mark.parametrize("selects", [True, False])
def test_the_onion_skin_draws_the_shape_where_it_does_not_exist_on_this_frame(
    canvas: CanvasView, hand: Hand, shape_id: str, document: Document, view_state: ViewState, selects: bool
) -> None:
    """And no other one in its place."""
    project = edit.set_properties(document.project, shape_id, lifetime=(1, 5))
    corner = polygon_points([(5.0, 5.0), (20.0, 5.0), (20.0, 20.0), (5.0, 20.0)])
    project, _other = edit.new_shape(project, corner, 6)
    document.open(project, None)
    view_state.set_frame(6)
    view_state.select(frozenset({shape_id} if selects else ()))
    canvas.set_image(6, np.full((150, 200, 3), 100, dtype=np.uint8))
    hand.key("5")
    canvas.viewing.set_onion(before=1, after=0, step=4, before_colour="#ff0000")
    assert colour_at(canvas, 44.0, 70.0).red() > 120


def test_counts_are_kept_within_reason() -> None:
    viewing = Viewing()
    viewing.set_onion(before=99, after=-3, step=0)
    assert (viewing.onion.before, viewing.onion.after, viewing.onion.step) == (12, 0, 1)


# ---- channels, exposure, gamma


def test_channel_keys_show_one_channel_and_all_again(canvas: CanvasView, hand: Hand) -> None:
    canvas.set_image(1, np.full((150, 200, 3), (200, 100, 50), dtype=np.uint8))
    for key, value in (("1", 200), ("2", 100), ("3", 50)):
        hand.key(key, CTRL)
        assert colour_at(canvas, 100.0, 75.0) == QColor(value, value, value)
    hand.key("3", CTRL)
    assert canvas.viewing.look.channel is Channel.COLOUR
    hand.key("4", CTRL)
    assert colour_at(canvas, 100.0, 75.0) == QColor(118, 118, 118)
    hand.key("0", CTRL)
    assert colour_at(canvas, 100.0, 75.0) == QColor(200, 100, 50)


def test_a_look_reaches_the_screen_and_nothing_else(
    canvas: CanvasView, document: Document, shape_id: str, hand: Hand
) -> None:
    project = document.project
    canvas.viewing.set_look(exposure=1.0, gamma=1.5)
    bright = Look(exposure=1.0, gamma=1.5).table[100]
    assert colour_at(canvas, 100.0, 75.0) == QColor(bright, bright, bright)
    assert document.project is project
    assert (canvas.stage.picture.pixels == 100).all()
    canvas.viewing.set_look(exposure=99.0)
    assert canvas.viewing.look.exposure == 8.0
    canvas.viewing.reset_look()
    assert canvas.viewing.look.is_neutral
    assert colour_at(canvas, 150.0, 130.0) == GREY


def test_float_plates_show_what_lies_above_white(canvas: CanvasView) -> None:
    light = np.full((150, 200, 3), 3.0, dtype=np.float32)
    canvas.stage.plate_of = lambda frame: Plate(light, "linear", light)
    canvas.set_image(1, np.full((150, 200, 3), 255, dtype=np.uint8))
    assert colour_at(canvas, 100.0, 75.0) == QColor(255, 255, 255)
    canvas.viewing.set_look(exposure=-2.0)
    assert colour_at(canvas, 100.0, 75.0).red() == 225  # the sRGB value of 0.75


@pytest.mark.parametrize("near", [False, True])
def test_a_cut_out_is_looked_at_as_the_plate_is(
    canvas: CanvasView, hand: Hand, shape_id: str, qtbot: QtBot, near: bool
) -> None:
    light = np.full((150, 200, 3), (3.0, 0.5, 0.1), dtype=np.float32)
    canvas.stage.plate_of = lambda frame: Plate(light, "linear", light)
    canvas.set_image(1, np.full((150, 200, 3), (255, 188, 89), dtype=np.uint8))
    if near:
        canvas.set_viewport(Viewport(4.0, -200.0, -200.0))
    view = offered_views()[0]
    seen_plate(light[:1, :1], "linear", Look(view=view))  # as the reader of plates does beside the window's thread
    reach(canvas, "4", hand, qtbot)
    for look in ({"exposure": -2.0}, {"view": view}, {"channel": Channel.GREEN}):
        canvas.viewing.set_look(**look)  # type: ignore[arg-type]
        hand.key("1")
        plate = colour_at(canvas, 80.0, 70.0)
        hand.key("4")
        assert colour_at(canvas, 80.0, 70.0) == plate
        assert colour_at(canvas, 60.0, 110.0) in CHECKERS
    assert canvas.stage.shown_picture().value(80.0, 70.0).tolist() == pytest.approx([3.0, 0.5, 0.1])
    assert [canvas.stage.shown_picture().opacity(80.0, y) for y in (70.0, 110.0)] == [255, 0]


# ---- what comes back


def test_background_and_onion_come_back_and_the_look_does_not() -> None:
    viewing, again = Viewing(), Viewing()
    viewing.set_background(kind=BackgroundKind.COLOUR, colour="#112233")
    viewing.set_onion(before=5, only_keys=True, after_colour="#445566")
    viewing.set_look(exposure=2.0)
    again.recall(viewing.remembered())
    assert (again.background, again.onion) == (viewing.background, viewing.onion)
    assert again.look.is_neutral


def test_how_often_a_background_was_chosen_is_not_remembered() -> None:
    viewing, again = Viewing(), Viewing()
    viewing.set_background(kind=BackgroundKind.COLOUR, choice=3)
    kept = viewing.remembered()
    assert kept["ground"]["choice"] == 0
    again.recall(kept)
    assert again.background == Background(BackgroundKind.COLOUR)


def test_a_background_picture_that_cannot_be_looked_at_does_not_come_back() -> None:
    viewing = Viewing()
    viewing.recall({"ground": {"kind": "image", "image": "a" * 300}})
    assert viewing.background == Background()


def test_the_display_and_view_come_back_with_their_configuration(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OCIO", raising=False)
    viewing, gone = Viewing(), Viewing()
    chosen = offered_views()[1]
    viewing.set_look(view=chosen, exposure=2.0)
    kept = json.loads(json.dumps(viewing.remembered()))
    monkeypatch.setenv("OCIO", "another.ocio")
    gone.recall(kept)
    assert gone.look.view is None
    monkeypatch.delenv("OCIO")
    again = Viewing()
    again.recall(gone.remembered())
    assert again.look == Look(view=chosen)
    again.set_look(view=None)
    last = Viewing()
    last.recall(again.remembered())
    assert last.look.view is None


def test_a_view_that_the_configuration_has_no_more_is_not_looked_through(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("OCIO", raising=False)
    viewing, again = Viewing(), Viewing()
    viewing.set_look(view=("sRGB - Display", "Gone"))
    again.recall(viewing.remembered())
    assert again.look.view is None


@pytest.mark.parametrize(
    "nonsense",
    [None, 3, {"ground": {"kind": "sky"}}, {"views": {"": ["a", 3]}}, {"views": {"": "ab"}}, {"views": []},
     {"onion": {"before": "many", "before_colour": "reddish"}}, {"ground": []},
     {"ground": {"kind": "image", "image": "/no/such/picture.png"}}],
)  # fmt: skip
def test_what_makes_no_sense_is_not_taken_back(nonsense: object) -> None:
    viewing = Viewing()
    viewing.recall(nonsense)
    assert (viewing.background, viewing.onion) == (Viewing().background, Viewing().onion)


# ---- single pixels


@pytest.fixture
def coloured(canvas: CanvasView) -> CanvasView:
    canvas.set_image(1, np.full((150, 200, 3), (200, 120, 40), dtype=np.uint8))
    return canvas


def at(canvas: CanvasView, scale: float) -> QImage:
    """The view with the pixel (50, 50) at its corner."""
    canvas.set_viewport(Viewport(scale, -50.0 * scale, -50.0 * scale))
    return looks(canvas)


def kinds_of(picture: QImage, across: int, down: int) -> set[tuple[int, ...]]:
    """The colours inside of the second pixel of the second row."""
    return {
        picture.pixelColor(x, y).getRgb()[:3]
        for x in range(across + 3, 2 * across - 2)
        for y in range(down + 3, 2 * down - 2)
    }


def test_a_grid_stands_between_pixels_from_800_percent(coloured: CanvasView) -> None:
    assert at(coloured, 7.0).pixelColor(14, 60).getRgb()[:3] == (200, 120, 40)
    near = at(coloured, 9.0)
    assert near.pixelColor(18, 60).getRgb()[:3] != (200, 120, 40)
    assert kinds_of(near, 9, 9) == {(200, 120, 40)}


@pytest.mark.parametrize(("scale", "is_there"), [(3.9, False), (4.0, True)])
def test_the_grid_stands_from_800_percent_on_a_screen_of_fine_pixels_too(scale: float, is_there: bool) -> None:
    """There the zoom is told in the screen's pixels, two to a unit; the grid came at 1600 %."""
    screen = QImage(80, 60, QImage.Format.Format_RGB32)
    screen.setDevicePixelRatio(2.0)
    screen.fill(GREY)
    picture = Picture(np.full((15, 20, 3), 100, dtype=np.uint8))
    painter = QPainter(screen)
    paint_pixel_marks(painter, Viewport(scale), picture, picture.size, Look())
    painter.end()
    assert any(screen.pixelColor(x, 12) != GREY for x in range(40, 60)) is is_there


def test_values_are_written_into_large_pixels(coloured: CanvasView) -> None:
    assert kinds_of(at(coloured, 40.0), 40, 40) == {(200, 120, 40)}
    assert len(kinds_of(at(coloured, 60.0), 60, 60)) > 5


def test_zoom_ends_where_a_pixel_is_as_large_as_can_be_read(coloured: CanvasView, hand: Hand) -> None:
    for _ in range(60):
        hand.wheel((100.0, 75.0), 240)
    assert coloured.zoom == LARGEST
    assert coloured.plate_size() == QSizeF(200.0, 150.0)
    assert coloured.widget_to_image(coloured.image_to_widget(100.0, 75.0)) == pytest.approx((100.0, 75.0))
