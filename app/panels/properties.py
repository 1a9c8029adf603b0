"""The shape panel: everything plain about the selected shapes, each control two lines: from the document, and to it."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass, replace
from typing import Any

from PySide6.QtCore import QSignalBlocker, Qt
from PySide6.QtWidgets import (
    QGridLayout,
    QHBoxLayout,
    QLabel,
    QStackedLayout,
    QToolButton,
    QWidget,
)

from roam_core.roto import BlendMode, MotionBlur, RotoShape, edit
from roam_core.roto.animated import Animated, value_at
from roam_core.roto.edit import MIN_POINTS_CLOSED
from roam_core.roto.properties import begin_at, end_at, limit_lifetime, set_motion_blur
from roam_core.roto.value_keys import set_value, with_value

from .. import style
from ..features.belonging import Belonging
from ..features.navigation import clip_frames
from ..model.document import Document
from ..model.reasons import LOCKED_STAYS, outdated_by_blend
from ..model.view_state import ViewState, selected_shapes
from ..translation import N_, tr
from ..widgets.controls import FRAME_LIMIT, align_labels, dense_form, form_label
from ..widgets.fields import BlendBox, NameField, NumberField, ScrubLabel, SwitchBox, shared
from .colour_row import ColourRow
from .layer_form import LayerForm
from .object_form import ObjectForm
from .value_key import KeyedFrame, ValueKeyButton, keyed_row

NOTHING = N_("Select a shape to see its properties.")
FREE_OF_LOCKS = {"visible", "locked"}
"""What can be changed on a locked shape."""

Shapes = Sequence[RotoShape]
Verb = Callable[[RotoShape], RotoShape]


@dataclass(frozen=True)
class Field:
    """One control: how it shows the values of shapes. Writing goes through `PropertiesPanel.push`."""

    widget: QWidget
    show: Callable[[Shapes], None]
    works_locked: bool = False


class PropertiesPanel(QWidget):
    """Shows the selected shapes, what differs between them as mixed, and edits all of them at once."""

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        belonging: Belonging | None = None,
        parent: QWidget | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view = document, view_state
        self._fields: list[Field] = []
        self._values: list[str] = []
        """Names of the values that may vary with time."""
        self._lifetime_rows: list[QWidget] = []
        self._form_page = QWidget()
        self._form = dense_form()
        self._form.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        self._form_page.setLayout(self._form)
        self._hint = QLabel(tr(NOTHING))
        self._hint.setObjectName("weak")
        self._hint.setAlignment(Qt.AlignmentFlag.AlignHCenter | Qt.AlignmentFlag.AlignTop)
        self._hint.setContentsMargins(0, 2 * style.MARGIN, 0, 0)
        self._pages = QStackedLayout(self)
        self._pages.addWidget(self._hint)
        self._pages.addWidget(self._form_page)
        self.layer_form = LayerForm(document, view_state)
        self._pages.addWidget(self.layer_form)
        self._build_looks()
        self._build_switches()
        self.object_form = ObjectForm(document, view_state, belonging or Belonging(document, view_state))
        self._form.addRow(self.object_form)
        self._build_motion_blur()
        self._build_lifetime()
        align_labels(self._form, self.object_form.form)
        # Tab goes from number to number: Return, where the next one was meant, pressed the button between them.
        self.setTabOrder(self.feather, self.opacity_key)
        self.setTabOrder(self.last, self.from_here)
        for signal in (document.replaced, view_state.selection_changed):
            signal.connect(self._forget_typing)
        for signal in (document.changed, document.replaced, view_state.selection_changed):
            signal.connect(self._pull)
        view_state.frame_changed.connect(self._follow)
        self._pull()

    # ---- the controls, two lines each: model to widget, widget to model

    def _build_looks(self) -> None:
        self.name = name = NameField()
        self._add_row(form_label(tr("Name")), name, lambda shapes: self._show_name(shapes))
        name.named.connect(self._push_name)

        self.colours = colours = ColourRow()
        self._add_row(
            form_label(tr("Colour")), colours, lambda shapes: colours.show_colour(shared(s.colour for s in shapes))
        )
        colours.picked.connect(lambda colour: self.push(tr("Colour"), colour=colour))

        self.blend = blend = BlendBox(tr("How the shape joins what lies under it in its layer"))
        self._add_row(
            form_label(tr("Blend")), blend, lambda shapes: blend.show_mode(shared(shape.blend for shape in shapes))
        )
        blend.picked.connect(self._push_blend)

        self.opacity, self.opacity_key = NumberField(0.0, 100.0, suffix=" %"), ValueKeyButton()
        self._add_value("opacity", tr("Opacity"), self.opacity, self.opacity_key, 100.0)

        tip = tr("Width of an even soft edge; below zero it lies inside")
        self.feather = NumberField(-500.0, 500.0, suffix=" px", decimals=1, step=0.5, tip=tip)
        self.feather_key = ValueKeyButton()
        self._add_value("feather", tr("Feather"), self.feather, self.feather_key)

    def _build_switches(self) -> None:
        self.visible = SwitchBox(tr("Visible"), tr("A hidden shape takes no part in the matte"))
        self.locked = SwitchBox(tr("Locked"), tr("A locked shape cannot be changed by hand"))
        self.invert = SwitchBox(tr("Invert"), tr("The matte is what lies outside of the shape"))
        self.closed = SwitchBox(tr("Closed"), tr("Only a closed shape has a matte"))
        grid = QGridLayout()
        grid.setVerticalSpacing(0)
        grid.setHorizontalSpacing(2 * style.MARGIN)
        grid.setColumnStretch(2, 1)
        switches = ("visible", self.visible), ("locked", self.locked), ("closed", self.closed), ("invert", self.invert)
        for index, (name, box) in enumerate(switches):
            grid.addWidget(box, index // 2, index % 2)
            self._add_switch(name, box)
        self._form.addRow(form_label(tr("State")), grid)

    def _build_motion_blur(self) -> None:
        self.blur = blur = SwitchBox(tr("On"), tr("Soft edges where the points move while the shutter is open"))
        self._add_row(
            form_label(tr("Motion blur")),
            blur,
            lambda shapes: blur.show_value(shared(bool(s.motion_blur) for s in shapes)),
        )
        blur.clicked.connect(lambda on: self.push_each(tr("Motion blur"), lambda shape: set_motion_blur(shape, on)))
        self.shutter = NumberField(
            0.0,
            4.0,
            suffix=tr(" frames"),
            decimals=2,
            step=0.05,
            tip=tr("How long the shutter is open; 0.5 is 180 degrees"),
        )
        self.phase = NumberField(
            -4.0, 4.0, suffix=tr(" frames"), decimals=2, step=0.05, tip=tr("When it opens, counted from the frame")
        )
        self.samples = NumberField(2.0, 256.0, tip=tr("Moments of the open shutter that are joined"))
        self._add_blur_number("shutter", tr("Shutter"), self.shutter)
        self._add_blur_number("phase", tr("Phase"), self.phase)
        self._add_blur_number("samples", tr("Samples"), self.samples)

    def _add_blur_number(self, name: str, label: str, field: NumberField) -> None:
        kind = int if name == "samples" else float

        def put(shape: RotoShape, value: float) -> RotoShape:
            return set_motion_blur(shape, True, **{name: kind(value)}) if shape.motion_blur else shape

        self._add_number(label, field, lambda s: getattr(s.motion_blur or MotionBlur(), name), put)

    def _build_lifetime(self) -> None:
        self.limited = limited = SwitchBox(tr("Limited"), tr("The shape exists on some frames only"))
        self._add_row(
            form_label(tr("Lifetime")),
            limited,
            lambda shapes: limited.show_value(shared(bool(s.lifetime) for s in shapes)),
        )
        limited.clicked.connect(
            lambda on: self.push_each(tr("Lifetime"), lambda shape: limit_lifetime(shape, on, self._clip()))
        )
        self.first = NumberField(-FRAME_LIMIT, FRAME_LIMIT, tip=tr("First frame on which the shape exists"))
        self.last = NumberField(-FRAME_LIMIT, FRAME_LIMIT, tip=tr("Last frame on which the shape exists"))
        self.from_here, self.to_here = _here(tr("From this frame on")), _here(tr("Up to this frame"))
        self.from_here.clicked.connect(lambda: self._push_frame(begin_at, self._view.frame))
        self.to_here.clicked.connect(lambda: self._push_frame(end_at, self._view.frame))
        self._add_frame(tr("From"), self.first, self.from_here, lambda s: self._lifetime(s)[0], begin_at)
        self._add_frame(tr("To"), self.last, self.to_here, lambda s: self._lifetime(s)[1] - 1, end_at)

    def _lifetime(self, shape: RotoShape) -> tuple[int, int]:
        """The half-open range of frames in which a shape exists: those of the clip where it has no lifetime."""
        clip = self._clip()
        return shape.lifetime or (clip.start, clip.stop)

    def _add_frame(self, label: str, field: NumberField, here: QToolButton, get: Any, verb: Any) -> None:
        row = QWidget()
        box = QHBoxLayout(row)
        box.setContentsMargins(0, 0, 0, 0)
        box.addWidget(field, 1)
        box.addWidget(here)
        self._fields.append(Field(row, lambda shapes: field.show_value(shared(map(get, shapes)), get(shapes[0]))))
        field.edited.connect(lambda value, key: self._push_frame(verb, int(value), key))
        self._form.addRow(ScrubLabel(label, field), row)
        self._lifetime_rows.append(row)

    # ---- making rows

    def _add_row(self, label: QLabel, widget: QWidget, show: Callable[[Shapes], None]) -> None:
        self._fields.append(Field(widget, show))
        self._form.addRow(label, widget)

    def _add_number(
        self,
        label: str,
        field: NumberField,
        get: Callable[[RotoShape], float],
        put: Callable[[RotoShape, float], RotoShape],
    ) -> None:
        def show(shapes: Shapes) -> None:
            values = [get(shape) for shape in shapes if shape.motion_blur] or list(map(get, shapes))
            field.show_value(shared(values), values[0])

        self._add_row(ScrubLabel(label, field), field, show)
        field.edited.connect(lambda value, key: self.push_each(label, lambda shape: put(shape, value), key))

    def _add_value(self, name: str, label: str, field: NumberField, button: ValueKeyButton, unit: float = 1.0) -> None:
        """A row for the field `name` of shapes, which may vary with time; `unit` is what the row shows for 1."""

        def show(shapes: Shapes) -> None:
            values, frame = [getattr(shape, name) for shape in shapes], self._view.frame
            numbers = [value_at(value, frame) * unit for value in values]
            field.show_value(shared(numbers), numbers[0])
            button.show_values(values, frame)

        begun = KeyedFrame(field, self._view)

        def push(number: float, key: str) -> None:
            frame = begun.of(key)
            self.push_each(label, lambda shape: set_value(shape, name, frame, number / unit), key)

        self._values.append(name)
        self._add_row(ScrubLabel(label, field), keyed_row(field, button), show)
        field.edited.connect(push)
        button.acted.connect(
            lambda text, verb: self.push_each(f"{label}: {text}", lambda shape: with_value(shape, name, verb))
        )

    def _add_switch(self, name: str, box: SwitchBox) -> None:
        def show(shapes: Shapes) -> None:
            box.show_value(shared(getattr(shape, name) for shape in shapes))

        self._fields.append(Field(box, show, works_locked=name in FREE_OF_LOCKS))
        if name == "closed":  # of a B-spline other points follow from it
            box.clicked.connect(lambda on: self.push_each(_switched(name, on), lambda shape: _as_closed(shape, on)))
        else:
            box.clicked.connect(lambda on: self.push(_switched(name, on), **{name: on}))

    # ---- widget to model

    def push(self, text: str, merge_key: str = "", **values: Any) -> None:
        """Set fields of every selected shape, as one undo step; what is equal already is no step."""
        self.push_each(text, lambda shape: replace(shape, **values), merge_key, values.keys() <= FREE_OF_LOCKS)

    def push_each(self, text: str, verb: Verb, merge_key: str = "", works_locked: bool = False) -> None:
        """Put `verb(shape)` in the place of every selected shape that is not locked, as one undo step; says so where
        some are.
        """
        project, selected = self._document.project, self._selected()
        free = [shape for shape in selected if works_locked or not project.is_locked(shape.id)]
        self._document.apply(text, project.with_shapes(map(verb, free)), merge_key and f"{merge_key} {text}")
        if len(free) < len(selected):
            self._view.say(tr(LOCKED_STAYS))
        self._pull()

    def _push_blend(self, mode: BlendMode) -> None:
        before = self._document.project
        self.push(tr("Blend"), blend=mode)
        if told := outdated_by_blend(before, self._document.project):
            self._view.say(told)

    def _push_name(self, name: str) -> None:
        if name and len(self._selected()) == 1:
            self.push(tr("Rename"), name=name)
        self._pull()

    def _push_frame(self, verb: Callable[..., RotoShape], frame: int, merge_key: str = "") -> None:
        """Set an end of the lifetimes. A frame that is given takes the other end along where that would lie beyond it;
        on the way of a drag or of steps the other end would not come back.
        """
        self.push_each(tr("Lifetime"), lambda shape: verb(shape, frame, self._clip(), pushes=not merge_key), merge_key)

    def _clip(self) -> range:
        return clip_frames(self._document.project, self._view.frame)

    # ---- model to widget

    def _selected(self) -> list[RotoShape]:
        return selected_shapes(self._document.project, self._view.selection)

    def _forget_typing(self) -> None:
        """Something else is shown: what is being typed did not mean it."""
        self.name.forget_typing()
        for field in self._form_page.findChildren(NumberField):
            field.forget_typing()

    def _pull(self, _ids: object = None) -> None:
        selected = self._selected()
        form = self.layer_form if self.layer_form.layers else self._form_page if selected else self._hint
        self._pages.setCurrentWidget(form)
        if not selected:
            return
        is_free = any(not self._document.project.is_locked(shape.id) for shape in selected)
        for field in self._fields:
            with QSignalBlocker(field.widget):
                field.show(selected)
            field.widget.setEnabled(is_free or field.works_locked)
        self.closed.setEnabled(is_free and all(shape.point_count >= MIN_POINTS_CLOSED for shape in selected))
        self.name.setEnabled(is_free and len(selected) == 1)
        # What has no meaning now is dim, in its place: nothing in the column moves with the selection.
        for field_row in (self.shutter, self.phase, self.samples):
            self._enable_row(field_row, is_free and any(shape.motion_blur for shape in selected))
        for row in self._lifetime_rows:
            self._enable_row(row, is_free and any(shape.lifetime for shape in selected))

    def _enable_row(self, row: QWidget, is_enabled: bool) -> None:
        for part in (row, self._form.labelForField(row)):
            part.setEnabled(is_enabled)

    def _follow(self) -> None:
        """Another frame: what varies is another value there, and what does not may be told as before."""
        if any(isinstance(getattr(shape, name), Animated) for shape in self._selected() for name in self._values):
            self._pull()
        for button in (self.opacity_key, self.feather_key):
            button.frame = self._view.frame

    def _show_name(self, shapes: Shapes) -> None:
        """A name belongs to one shape."""
        if len(shapes) == 1:
            self.name.show_name(shapes[0].name)
        else:
            self.name.show_name("", tr("{count} shapes", count=len(shapes)))


def _as_closed(shape: RotoShape, on: bool) -> RotoShape:
    return shape if shape.closed is on else edit.toggle_closed(shape)


def _here(tip: str) -> QToolButton:
    button = QToolButton()
    button.setObjectName("raised")
    button.setText(tr("here"))
    button.setToolTip(tip)
    button.setAccessibleName(tip)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    button.setFixedHeight(style.ROW_HEIGHT)
    return button


def _switched(name: str, on: bool) -> str:
    """What a switch's undo step is called."""
    words = {
        "visible": (tr("Hide"), tr("Show")), "locked": (tr("Unlock"), tr("Lock")), "closed": (tr("Open"), tr("Close")),
        "invert": (tr("Undo invert"), tr("Invert")),
    }  # fmt: skip
    return words[name][on]
