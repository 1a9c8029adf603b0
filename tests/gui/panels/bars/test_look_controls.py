"""The controls of looking: sliders and numbers, double click resets, a mark tells what is not neutral; the popups."""

from __future__ import annotations

import threading
from pathlib import Path

import cv2
import numpy as np
import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QColor
from PySide6.QtWidgets import QColorDialog, QFileDialog
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.canvas.plate.picture import Picture
from app.canvas.view import CanvasView
from app.model.document import Document
from app.model.view_state import ViewState
from app.model.viewing import BackgroundKind, ViewMode
from app.paint.viewport import Viewport
from app.panels.bars.look_controls import STEPS, LookSlider
from app.panels.bars.readout import Readout
from app.panels.bars.view_bar import ViewBar
from roam_core.media.looking import Channel, Plate
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def bar(qtbot: QtBot, document: Document, canvas: CanvasView) -> ViewBar:
    (actions,) = canvas.findChildren(Actions)
    bar = ViewBar(document, canvas, actions)
    qtbot.addWidget(bar)
    bar.resize(900, 28)
    bar.show()
    return bar


def drag_to(qtbot: QtBot, control: LookSlider, share: float) -> None:
    slider = control.slider
    middle, y = slider.width() // 2, slider.height() // 2
    qtbot.mousePress(slider, LEFT, pos=QPoint(middle, y))
    qtbot.mouseMove(slider, QPoint(round(share * slider.width()), y))
    qtbot.mouseRelease(slider, LEFT, pos=QPoint(round(share * slider.width()), y))


def test_exposure_is_dragged_typed_and_put_back_by_a_double_click(
    qtbot: QtBot, bar: ViewBar, canvas: CanvasView
) -> None:
    viewing, control = canvas.viewing, bar.exposure
    assert control.is_neutral
    assert control.mark.text() == "EV"
    drag_to(qtbot, control, 0.9)
    assert viewing.look.exposure > 3.0
    assert control.mark.text() == "●  EV"
    assert control.field.value() == pytest.approx(viewing.look.exposure)
    qtbot.mouseDClick(control.slider, LEFT)
    assert viewing.look.exposure == 0.0
    assert control.slider.value() == STEPS // 2
    control.field.setFocus()
    control.field.selectAll()
    qtbot.keyClicks(control.field, "-1.5")
    qtbot.keyClick(control.field, Qt.Key.Key_Return)
    assert viewing.look.exposure == -1.5


def test_gamma_of_one_lies_in_the_middle(qtbot: QtBot, bar: ViewBar, canvas: CanvasView) -> None:
    assert bar.gamma.slider.value() == STEPS // 2
    drag_to(qtbot, bar.gamma, 0.75)
    assert 1.5 < canvas.viewing.look.gamma < 3.5
    assert bar.gamma.mark.text() == "●  γ"
    qtbot.mouseDClick(bar.gamma.slider, LEFT)
    assert canvas.viewing.look.is_neutral


def test_the_channel_button_says_which_channel_is_shown(bar: ViewBar, canvas: CanvasView) -> None:
    assert bar.channel.text() == "RGB"
    for action in bar.channel.menu().actions():
        if action.objectName() == "view.green":
            action.trigger()
    assert canvas.viewing.look.channel is Channel.GREEN
    assert bar.channel.text() == "G"


def test_the_bar_marks_what_is_shown(bar: ViewBar, canvas: CanvasView) -> None:
    for name in ("cutout", "onion", "alpha", "source"):
        canvas.handlers()[f"view.{name}"]()
        assert bar._actions[f"view.{name}"].isChecked()
    canvas.wipe.toggle()
    assert bar._actions["view.wipe"].isChecked()


def test_the_plates_name_gives_way_in_a_narrow_window(bar: ViewBar) -> None:
    assert bar._plate.minimumSizeHint().width() <= 40


# ---- what lies under a cut-out


def test_the_background_is_chosen_in_its_popup(
    bar: ViewBar, canvas: CanvasView, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    form, viewing = bar.background, canvas.viewing
    assert not form.colour.isEnabled()
    form.kind.setCurrentIndex(form.kind.findData(BackgroundKind.COLOUR))
    form.kind.activated.emit(form.kind.currentIndex())
    assert viewing.background.kind is BackgroundKind.COLOUR
    assert form.colour.isEnabled()
    path = str(tmp_path / "street.exr")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (path, ""))
    form.kind.setCurrentIndex(form.kind.findData(BackgroundKind.IMAGE))
    form.kind.activated.emit(form.kind.currentIndex())
    assert (viewing.background.kind, viewing.background.image) == (BackgroundKind.IMAGE, path)
    assert form.image.text() == "street.exr"


def test_the_picture_that_is_chosen_again_is_read_again(
    bar: ViewBar, canvas: CanvasView, qtbot: QtBot, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """One that had been repaired or painted over stayed as it was, or refused, until the program was started again."""
    path, layer, seen = tmp_path / "street.png", canvas.stage.background, []
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(path), ""))
    canvas.viewing.set_mode(ViewMode.CUTOUT)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    for grey in (200, 20):
        assert cv2.imwrite(str(path), np.full((30, 40, 3), grey, dtype=np.uint8))
        bar.background.image.click()
        layer.of(canvas.viewing.background)
        qtbot.waitUntil(lambda: layer._thread is None, timeout=WAIT)
        qtbot.waitUntil(lambda: all(thread.name != "ground" for thread in threading.enumerate()), timeout=WAIT)
        picture = layer.of(canvas.viewing.background)
        assert isinstance(picture, Picture)
        seen.append(int(picture.pixels.max()))
    assert seen == [200, 20]


def test_no_picture_chosen_changes_nothing(bar: ViewBar, canvas: CanvasView, monkeypatch: pytest.MonkeyPatch) -> None:
    form = bar.background
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: ("", ""))
    form.kind.setCurrentIndex(form.kind.findData(BackgroundKind.IMAGE))
    form.kind.activated.emit(form.kind.currentIndex())
    assert canvas.viewing.background.kind is BackgroundKind.CHECKER
    assert form.kind.currentData() == BackgroundKind.CHECKER


def test_a_colour_is_seen_while_it_is_being_chosen(bar: ViewBar, canvas: CanvasView, qtbot: QtBot) -> None:
    canvas.viewing.set_background(kind=BackgroundKind.COLOUR)
    bar.background.colour.click()
    (dialog,) = bar.background.colour.findChildren(QColorDialog) or bar.findChildren(QColorDialog)
    dialog.setCurrentColor(QColor("#224466"))
    assert canvas.viewing.background.colour == "#224466"
    dialog.accept()


# ---- the onion skin's popup


def test_the_onion_skin_is_told_its_frames(bar: ViewBar, canvas: CanvasView, qtbot: QtBot) -> None:
    form = bar.onion
    form.before.setFocus()
    form.before.selectAll()
    qtbot.keyClicks(form.before, "5")
    qtbot.keyClick(form.before, Qt.Key.Key_Return)
    form.only_keys.click()
    form.all_shapes.click()
    onion = canvas.viewing.onion
    assert (onion.before, onion.after, onion.only_keys, onion.all_shapes) == (5, 3, True, True)
    assert not form.step.isEnabled()


# ---- the read-out


def test_the_read_out_tells_where_the_pointer_is_and_what_is_there(
    canvas: CanvasView, hand: Hand, qtbot: QtBot
) -> None:
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    picture = np.full((150, 200, 3), 100, dtype=np.uint8)
    picture[44, 33] = 7, 8, 9
    canvas.set_image(1, picture)
    hand.move((33.5, 44.5))
    assert readout.text().split() == ["x", "33.5", "y", "44.5", "R", "7", "G", "8", "B", "9"]
    hand.move((-3.0, 44.5))
    assert readout.text().split() == ["x", "-3.0", "y", "44.5"]
    canvas.leaveEvent(None)
    assert readout.text() == ""


def test_the_read_out_follows_the_frame_under_a_resting_pointer(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    hand.move((33.5, 44.5))
    canvas.set_image(2, np.full((150, 200, 3), 42, dtype=np.uint8))
    assert readout.text().split()[4:] == ["R", "42", "G", "42", "B", "42"]
    canvas.set_image(3, None)
    assert readout.text().split() == ["x", "33.5", "y", "44.5"]


def test_the_read_out_tells_a_float_plates_own_values(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    light = np.full((150, 200, 3), 2.5, dtype=np.float32)
    canvas.stage.plate_of = lambda frame: Plate(light, "linear", light)
    canvas.set_image(1, np.full((150, 200, 3), 255, dtype=np.uint8))
    canvas.viewing.set_look(exposure=-1.0)
    hand.move((33.5, 44.5))
    assert readout.text().split()[4:6] == ["R", "2.500"]


def test_the_read_out_knows_proxies(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    proxy = np.zeros((75, 100, 3), dtype=np.uint8)
    proxy[22, 16] = 50
    canvas.set_image(1, proxy)
    hand.move((33.5, 44.5))
    assert readout.text().split()[5] == "50"


def test_a_display_and_its_view_are_chosen_and_reset_leaves_them(bar: ViewBar, canvas: CanvasView) -> None:
    button, viewing = bar.display, canvas.viewing
    assert (button.text(), viewing.look.view) == ("sRGB", None)
    button.menu().aboutToShow.emit()
    plain, _, first, *_ = button.menu().actions()
    assert plain.isChecked()
    view = next(action for action in first.menu().actions() if "ACES" in action.text())
    view.trigger()
    assert viewing.look.view == (first.text(), view.text())
    assert first.text() in button.toolTip()
    viewing.set_look(exposure=1.0)
    viewing.reset_look()
    assert (viewing.look.exposure, viewing.look.view) == (0.0, (first.text(), view.text()))
    button.menu().aboutToShow.emit()
    plain, _, first, *_ = button.menu().actions()
    assert not plain.isChecked()
    plain.trigger()
    assert (viewing.look.view, button.text()) == (None, "sRGB")


def test_a_configuration_that_cannot_be_read_is_told_in_the_menu(
    bar: ViewBar, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("OCIO", str(tmp_path / "absent.ocio"))
    bar.display.menu().aboutToShow.emit()
    _, _, told = bar.display.menu().actions()
    assert "absent.ocio cannot be read" in told.text()
    assert not told.isEnabled()


def test_the_read_out_follows_the_view_under_a_resting_pointer(canvas: CanvasView, hand: Hand, qtbot: QtBot) -> None:
    """It went on telling what had been there before the zoom, and the values of the matte over the plate."""
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    canvas.set_viewport(Viewport(4.0, -300.0, -250.0))
    hand.move((110.0, 80.0))
    assert readout.text().split()[:4] == ["x", "110.0", "y", "80.0"]
    canvas.fit()
    assert readout.text().split()[:4] == ["x", "58.0", "y", "23.0"]
    canvas.viewing.set_mode(ViewMode.MATTE)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    assert readout.text().split()[4:] == ["A", "0"]
    canvas.viewing.set_mode(ViewMode.OVERLAY)
    assert readout.text().split()[4:] == ["R", "100", "G", "100", "B", "100"]


def test_the_read_out_tells_no_values_of_a_missing_frame_in_the_cut_out(
    canvas: CanvasView, hand: Hand, view_state: ViewState, qtbot: QtBot
) -> None:
    """It told those of the frame before."""
    readout = Readout(canvas)
    qtbot.addWidget(readout)
    canvas.viewing.set_mode(ViewMode.CUTOUT)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    hand.move((33.5, 44.5))
    assert "A" in readout.text()
    view_state.set_frame(2)
    canvas.set_image(2, None)
    assert readout.text().split() == ["x", "33.5", "y", "44.5"]
