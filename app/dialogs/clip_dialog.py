"""The clip dialog: what was found out about a clip, with its first picture, before it opens or while it is open.

The artist may differ.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np
from PySide6.QtCore import QSignalBlocker, QSize, Qt, Signal
from PySide6.QtGui import QImage, QPixmap
from PySide6.QtWidgets import (
    QCheckBox,
    QComboBox,
    QDialog,
    QDialogButtonBox,
    QHBoxLayout,
    QLabel,
    QVBoxLayout,
    QWidget,
)

from roam_core.media.colour import to_display
from roam_core.media.curves import LINEAR, LOG, SRGB
from roam_core.media.source import SPEEDS

from .. import style
from ..jobs.found_clip import FoundClip
from ..translation import N_, tr
from ..widgets.controls import dense_form, form_label, weak_label
from ..widgets.number_boxes import DecimalBox

if TYPE_CHECKING:
    from roam_core.media import PlateSource
    from roam_core.roto import Clip

COLOUR_WORDS = {SRGB: "sRGB", LINEAR: N_("Scene linear"), LOG: N_("Cineon log")}
"""What the spaces are called that are not OpenColorIO's."""
PICTURE = QSize(400, 225)
MOST_GAPS = 6
"""Missing frames that are named one by one; of more only the number is told."""
DEPTHS = N_("Half float"), N_("Float")
"""Depths that are no whole number."""


class ClipDialog(QDialog):
    """What cannot be changed is told, what can be mistaken by a program may be set.

    Of the project's clip it shows what holds for it now.

    Signals
    -------
    chosen() : open it, or read it from now on, as `layer`, `colour_space`, `fps` and `pixel_aspect` say.
    layer_wanted(name) : look at the clip again, at this layer of its files; `take` shows what was found.
    """

    chosen = Signal()
    layer_wanted = Signal(str)

    def __init__(self, found: FoundClip, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.found = found
        self.setWindowTitle(tr("Open clip") if found.held is None else tr("Clip settings"))
        self.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._build()
        self._lay_out()
        self._pull_picture()

    def take(self, found: FoundClip) -> None:
        """Show another layer of the same clip, if it is still the one chosen; what the artist declared holds."""
        if found.source.layer != self.layer:
            return
        is_declared = self.colour_space != self.found.source.colour_space
        declared = self.colour_space if is_declared else found.source.colour_space
        self.found = found
        self._pull_colours(declared)
        self.depth_told.setText(_depth_word(found.source.depth))
        self._pull_picture()

    @property
    def layer(self) -> str:
        return str(self.layers.currentText())

    @property
    def colour_space(self) -> str:
        return str(self.colours.currentData())

    @property
    def fps(self) -> float:
        """Frames per second; the clip's own value where the field, which rounds, was left as it was."""
        return _unless_changed(self.rate, *(each.fps for each in self._known))

    @property
    def pixel_aspect(self) -> float:
        return _unless_changed(self.aspect, *(each.pixel_aspect for each in self._known))

    # ---- the rest is private

    @property
    def _known(self) -> tuple[Clip | PlateSource, ...]:
        """What holds now, and what the files say."""
        return tuple(filter(None, (self.found.held, self.found.source)))

    def _build(self) -> None:
        source, now = self.found.source, self._known[0]
        self.picture = QLabel()
        self.picture.setFixedSize(PICTURE)
        self.picture.setAlignment(Qt.AlignmentFlag.AlignCenter)
        self.picture.setObjectName("plate")
        self.picture.setWordWrap(True)
        self.colours = QComboBox()
        self._pull_colours(now.colour_space)
        self.colours.currentIndexChanged.connect(lambda _: self._pull_picture())
        self.layers = QComboBox()
        self.layers.addItems(list(source.layers))
        self.layers.setCurrentText(source.layer)
        self.layers.currentTextChanged.connect(self.layer_wanted)
        self.depth_told = QLabel(_depth_word(source.depth))
        self.rate, self.aspect = _number(*SPEEDS, now.fps), _number(0.1, 10.0, now.pixel_aspect)
        self.aspect.valueChanged.connect(lambda _: self._pull_picture())
        self.asks_no_more = QCheckBox(tr("Open clips without asking from now on"))
        self.asks_no_more.setVisible(self.found.held is None)
        button = QDialogButtonBox.StandardButton
        self.buttons = QDialogButtonBox(button.Cancel | (button.Open if self.found.held is None else button.Ok))
        self.buttons.accepted.connect(self._choose)
        self.buttons.rejected.connect(self.close)

    def _lay_out(self) -> None:
        source = self.found.source
        width, height = source.size
        form = dense_form()
        for title, word in (
            (tr("Plate"), source.path.name),
            (tr("Frames"), range_sentence(source)),
            (tr("Missing"), gaps_sentence(source.missing)),
            (tr("Size"), f"{width} × {height}"),
        ):
            label = QLabel(word)
            label.setWordWrap(True)
            label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
            form.addRow(form_label(title), label)
        form.addRow(form_label(tr("Depth")), self.depth_told)
        if self.layers.count() > 1:
            form.addRow(form_label(tr("Layer")), self.layers)
        for title, field in (
            (tr("Colour"), self.colours),
            (tr("Frame rate"), self.rate),
            (tr("Pixel aspect"), self.aspect),
        ):
            form.addRow(form_label(title), field)
        right = QVBoxLayout()
        right.addLayout(form)
        right.addStretch(1)
        right.addWidget(weak_label(str(self.found.path.parent)))
        upper = QHBoxLayout()
        upper.setSpacing(2 * style.MARGIN)
        upper.addWidget(self.picture, 0, Qt.AlignmentFlag.AlignTop)
        upper.addLayout(right, 1)
        lower = QHBoxLayout()
        lower.addWidget(self.asks_no_more, 1)
        lower.addWidget(self.buttons)
        column = QVBoxLayout(self)
        column.setSpacing(2 * style.MARGIN)
        column.addLayout(upper, 1)
        column.addLayout(lower)
        self.setMinimumWidth(PICTURE.width() + 340)

    def _pull_colours(self, space: str) -> None:
        """The colour spaces to choose from, with `space` chosen."""
        with QSignalBlocker(self.colours):
            self.colours.clear()
            for each in self.found.spaces if space in self.found.spaces else (*self.found.spaces, space):
                word = tr(COLOUR_WORDS.get(each, each))
                self.colours.addItem(
                    tr("{space} (found)", space=word) if each == self.found.source.colour_space else word, each
                )
            self.colours.setCurrentIndex(self.colours.findData(space))

    def _pull_picture(self) -> None:
        """The first picture as it will look with the colours and pixels that are chosen now."""
        if self.found.picture is None:
            self.picture.setText(self.found.trouble)
            return
        shown = np.ascontiguousarray(to_display(self.found.picture, self.colour_space))
        height, width = shown.shape[:2]
        image = QImage(shown.tobytes(), width, height, 3 * width, QImage.Format.Format_RGB888)
        wide = image.scaled(max(round(width * self.pixel_aspect), 1), height)
        mode = Qt.TransformationMode.SmoothTransformation
        fitted = wide.scaled(PICTURE, Qt.AspectRatioMode.KeepAspectRatio, mode)
        self.picture.setPixmap(QPixmap.fromImage(fitted))

    def _choose(self) -> None:
        self.close()  # first: what is chosen may ask about unsaved work, and this may be gone before the answer
        self.chosen.emit()


def range_sentence(source: PlateSource) -> str:
    """`1001–1048, 47 frames`; of a single frame its number."""
    first, last, count = source.frames[0], source.frames[-1], len(source.frames)
    return (
        tr("{first}–{last}, {count} frames", first=first, last=last, count=count)
        if count > 1
        else tr("{first}, a single picture", first=first)
    )


def gaps_sentence(missing: tuple[int, ...]) -> str:
    """`none`, a few missing frames by number, or how many there are."""
    if not missing:
        return tr("none")
    if len(missing) <= MOST_GAPS:
        return ", ".join(map(str, missing))
    return tr("{count} frames, from {first} to {last}", count=len(missing), first=missing[0], last=missing[-1])


def _depth_word(depth: str) -> str:
    """The depth of a plate as the engine says it - `10 bits`, `half float`, `float` - in the window's language."""
    bits = depth.removesuffix(" bits")
    if bits.isdecimal():
        return tr("{bits} bits", bits=bits)
    return tr(next((word for word in DEPTHS if word.lower() == depth), depth))


def _number(least: float, most: float, value: float) -> DecimalBox:
    field = DecimalBox()
    field.setDecimals(3)
    field.setRange(least, most)
    field.setValue(value)
    field.setAlignment(Qt.AlignmentFlag.AlignRight)
    return field


def _unless_changed(field: DecimalBox, *known: float) -> float:
    return next((each for each in known if field.value() == round(each, field.decimals())), field.value())
