"""How the picture is looked at, in the view bar: channel, exposure, gamma, display; for the eye alone."""

from __future__ import annotations

import math
from collections.abc import Callable
from itertools import groupby

from PySide6.QtCore import QSignalBlocker, Qt, Signal
from PySide6.QtGui import QActionGroup, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QMenu, QSlider, QToolButton, QWidget

from roam_core.errors import RoamError
from roam_core.media.colour_spaces import offered_views
from roam_core.media.looking import Channel, Look

from ... import style
from ...actions.actions import Actions
from ...model.viewing import EXPOSURES, GAMMAS, Viewing
from ...translation import sentence_of, tr
from ...widgets.fields import NumberField

STEPS = 160
"""Steps of a slider from one end to the other."""
SLIDER_WIDTH, LEAST_SLIDER_WIDTH, FIELD_WIDTH = 72, 36, 40
DISPLAY_WIDTH = 84
PLAIN_VIEW = "sRGB"
"""The view that needs no configuration: what the engine sees."""
LETTERS = {
    Channel.COLOUR: "RGB",
    Channel.RED: "R",
    Channel.GREEN: "G",
    Channel.BLUE: "B",
    Channel.LUMINANCE: "Y",
}


class ResettingSlider(QSlider):
    """A slider that a double click puts back, and the wheel moves only while it has the keyboard.

    Signals
    -------
    reset() : it was double-clicked.
    """

    reset = Signal()

    def __init__(self, tip: str) -> None:
        super().__init__(Qt.Orientation.Horizontal)
        self.setRange(0, STEPS)
        self.setMaximumWidth(SLIDER_WIDTH)
        self.setMinimumWidth(LEAST_SLIDER_WIDTH)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(tip)

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        self.reset.emit()

    def wheelEvent(self, event: QWheelEvent) -> None:
        if self.hasFocus():
            super().wheelEvent(event)
        else:
            event.ignore()


class LookSlider(QWidget):
    """A name, a slider and a number for one part of the look; the name is marked while it is not neutral.

    `share` says how far along the slider a value lies, in [0, 1]; `value` is its inverse.
    """

    def __init__(
        self,
        viewing: Viewing,
        name: str,
        letters: str,
        bounds: tuple[float, float],
        share: Callable[[float], float],
        value: Callable[[float], float],
        tip: str,
    ) -> None:
        super().__init__()
        self._viewing, self._name, self._letters, self._share = viewing, name, letters, share
        self.mark = QLabel()
        self.mark.setToolTip(tip)
        self.slider = ResettingSlider(tr("{tip}; double click: neutral", tip=tip))
        self.field = NumberField(*bounds, decimals=2, step=0.1, tip=tip)
        self.field.setFixedWidth(FIELD_WIDTH)
        self.slider.setAccessibleName(tip)
        self.field.setAccessibleName(tip)
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 0, 0, 0)
        row.setSpacing(4)
        for part in (self.mark, self.slider, self.field):
            row.addWidget(part)
        self.slider.valueChanged.connect(lambda step: self._push(round(value(step / STEPS), 2)))
        self.slider.reset.connect(lambda: self._push(getattr(Look(), name)))
        self.field.edited.connect(lambda number, _: self._push(number))
        viewing.changed.connect(self._pull)
        self._pull()

    @property
    def is_neutral(self) -> bool:
        """True while this part of the look changes nothing."""
        return bool(getattr(self._viewing.look, self._name) == getattr(Look(), self._name))

    def _push(self, number: float) -> None:
        self._viewing.set_look(**{self._name: number})

    def _pull(self) -> None:
        number = getattr(self._viewing.look, self._name)
        with QSignalBlocker(self.slider):
            self.slider.setValue(round(STEPS * self._share(number)))
        self.field.show_value(number)
        self.mark.setText(self._letters if self.is_neutral else f"●  {self._letters}")
        self.mark.setStyleSheet(f"color: {style.WEAK if self.is_neutral else style.ACCENT}; font-size: 11px;")


class ChannelButton(QToolButton):
    """Says which channel is shown, and lets another be chosen."""

    def __init__(self, viewing: Viewing, actions: Actions) -> None:
        super().__init__()
        self._viewing, self._actions = viewing, actions
        self.setObjectName("menuButton")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setToolTip(tr("Which channel is shown"))
        self.setAccessibleName(tr("Which channel is shown"))
        self.setFixedSize(42, 24)
        menu, group = QMenu(self), QActionGroup(self)
        for channel in Channel:
            menu.addAction(group.addAction(actions[f"view.{channel}"]))
        menu.addSeparator()
        menu.addAction(actions["view.reset_look"])
        self.setMenu(menu)
        viewing.changed.connect(self._pull)
        self._pull()

    def _pull(self) -> None:
        channel = self._viewing.look.channel
        self._actions[f"view.{channel}"].setChecked(True)
        self.setText(LETTERS[channel])
        self.setStyleSheet("" if channel is Channel.COLOUR else f"color: {style.ACCENT};")


class DisplayButton(QToolButton):
    """Says which view of which display is shown, and lets another of the OpenColorIO configuration be chosen."""

    def __init__(self, viewing: Viewing) -> None:
        super().__init__()
        self._viewing = viewing
        self.setObjectName("menuButton")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setFixedSize(DISPLAY_WIDTH, 24)
        menu = QMenu(self)
        # The configuration is read when it is asked for: a window opens without it.
        menu.aboutToShow.connect(self._fill)
        self.setMenu(menu)
        viewing.changed.connect(self._pull)
        self._pull()

    def _fill(self) -> None:
        menu = self.menu()
        menu.clear()
        self._offer(menu, PLAIN_VIEW, None)
        menu.addSeparator()
        try:
            views = offered_views()
        except RoamError as error:
            menu.addAction(sentence_of(error)).setEnabled(False)
            return
        for display, named in groupby(views, key=lambda view: view[0]):
            below = menu.addMenu(display)
            for view in named:
                self._offer(below, view[1], view)

    def _offer(self, menu: QMenu, title: str, view: tuple[str, str] | None) -> None:
        action = menu.addAction(title)
        action.setCheckable(True)
        action.setChecked(view == self._viewing.look.view)
        action.triggered.connect(lambda: self._viewing.set_look(view=view))

    def _pull(self) -> None:
        view = self._viewing.look.view
        name = PLAIN_VIEW if view is None else view[1]
        self.setText(self.fontMetrics().elidedText(name, Qt.TextElideMode.ElideRight, DISPLAY_WIDTH - 20))
        shown = (
            tr("the plate's light with the sRGB curve")
            if view is None
            else tr("{view} on {display}", view=view[1], display=view[0])
        )
        self.setToolTip(tr("Display and view, for looking only: {shown}", shown=shown))
        self.setStyleSheet("" if view is None else f"color: {style.ACCENT};")


def exposure_slider(viewing: Viewing) -> LookSlider:
    """Exposure in stops, evenly along the slider."""
    low, high = EXPOSURES
    return LookSlider(
        viewing, "exposure", "EV", EXPOSURES,
        lambda stops: (stops - low) / (high - low), lambda share: low + share * (high - low),
        tr("Exposure in stops, for looking only"),
    )  # fmt: skip


def gamma_slider(viewing: Viewing) -> LookSlider:
    """Gamma, by its logarithm along the slider: 1 lies in the middle."""
    span = math.log(GAMMAS[1] / GAMMAS[0])
    return LookSlider(
        viewing, "gamma", "γ", GAMMAS,
        lambda gamma: math.log(gamma / GAMMAS[0]) / span, lambda share: GAMMAS[0] * math.exp(share * span),
        tr("Gamma, for looking only"),
    )  # fmt: skip
