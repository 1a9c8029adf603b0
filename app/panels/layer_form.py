"""The form of the selected layers: name, opacity, switches, and the motion that a track gave them."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QPushButton, QWidget

from roam_core.roto import Layer
from roam_core.roto.animated import Animated, set_at
from roam_core.roto.following import still
from roam_core.roto.value_keys import with_value

from .. import style
from ..model.document import Document
from ..model.reasons import LOCKED_STAYS
from ..model.view_state import ViewState
from ..translation import tr
from ..widgets.controls import dense_form, form_label
from ..widgets.fields import BlendBox, NameField, NumberField, ScrubLabel, SwitchBox, shared
from .value_key import KeyedFrame, ValueKeyButton, ValueVerb, keyed_row

FREE_OF_LOCKS = {"visible", "locked"}
"""What can be changed on a locked layer."""


class LayerForm(QWidget):
    """Shows the layers that are selected as such, what differs between them as mixed, and edits all of them."""

    def __init__(self, document: Document, view_state: ViewState, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._view = document, view_state
        form = dense_form()
        form.setContentsMargins(style.MARGIN, style.MARGIN, style.MARGIN, style.MARGIN)
        self.setLayout(form)
        self.name = NameField()
        self.name.named.connect(self._push_name)
        form.addRow(form_label(tr("Layer")), self.name)
        self.blend = BlendBox(tr("How the joint matte of the layer joins what lies under it"))
        self.blend.picked.connect(lambda mode: self.push(tr("Layer blend"), blend=mode))
        form.addRow(form_label(tr("Blend")), self.blend)
        self.opacity = NumberField(0.0, 100.0, suffix=" %", tip=tr("Of the joint matte of all that lies in the layer"))
        self._begun = KeyedFrame(self.opacity, view_state)
        self.opacity.edited.connect(self._push_opacity)
        self.opacity_key = ValueKeyButton()
        self.opacity_key.acted.connect(
            lambda text, verb: self._push_value(tr("Layer opacity: {text}", text=text), verb)
        )
        form.addRow(ScrubLabel(tr("Opacity"), self.opacity), keyed_row(self.opacity, self.opacity_key))
        form.addRow(form_label(tr("State")), self._switches())
        self._motion = QLabel()
        self._motion.setToolTip(tr("The frames on which a track moves the layer"))
        self.clear_motion = QPushButton(tr("Remove"))
        self.clear_motion.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.clear_motion.setToolTip(tr("Let the layer stand still; every key stays where it is seen"))
        self.clear_motion.clicked.connect(self._push_stillness)
        row = QHBoxLayout()
        row.addWidget(self._motion, 1)
        row.addWidget(self.clear_motion)
        form.addRow(form_label(tr("Motion")), row)
        for signal in (document.replaced, view_state.selection_changed):
            for field in (self.name, self.opacity):
                signal.connect(field.forget_typing)
        for signal in (document.changed, document.replaced, view_state.selection_changed):
            signal.connect(self._pull)
        view_state.frame_changed.connect(self._follow)
        self._pull()

    @property
    def layers(self) -> list[Layer]:
        """The layers that are shown."""
        items = self._document.project.root.items()
        return [item for item in items if isinstance(item, Layer) and item.id in self._view.layers]

    def push(self, text: str, merge_key: str = "", **values: Any) -> None:
        """Set fields of every shown layer that is not locked, as one undo step."""
        self._push_each(text, lambda layer: replace(layer, **values), merge_key, values.keys() <= FREE_OF_LOCKS)

    # ---- the rest is private

    def _push_each(
        self, text: str, verb: Callable[[Layer], Layer], merge_key: str = "", works_locked: bool = False
    ) -> None:
        project = self._document.project
        for layer in self.layers:
            if (works_locked or not project.is_locked(layer.id)) and verb(layer) != layer:
                project = project.map_item(layer.id, verb)
        self._document.apply(text, project, merge_key)
        if not works_locked and any(project.is_locked(layer.id) for layer in self.layers):
            self._view.say(tr(LOCKED_STAYS))
        self._pull()

    def _push_opacity(self, percent: float, merge_key: str) -> None:
        frame = self._begun.of(merge_key)
        self._push_value(tr("Layer opacity"), lambda value: set_at(value, frame, percent / 100), merge_key)

    def _push_value(self, text: str, verb: ValueVerb, merge_key: str = "") -> None:
        self._push_each(text, lambda layer: with_value(layer, "opacity", verb), merge_key)

    def _switches(self) -> QGridLayout:
        self.visible = SwitchBox(tr("Visible"), tr("What lies in a hidden layer takes no part in the matte"))
        self.locked = SwitchBox(tr("Locked"), tr("What lies in a locked layer cannot be changed by hand"))
        self.invert = SwitchBox(tr("Invert"), tr("The matte is what lies outside of the shapes of the layer"))
        grid = QGridLayout()
        grid.setVerticalSpacing(0)
        grid.setHorizontalSpacing(2 * style.MARGIN)
        grid.setColumnStretch(2, 1)
        texts = {
            "visible": (tr("Hide layer"), tr("Show layer")), "locked": (tr("Unlock layer"), tr("Lock layer")),
            "invert": (tr("Undo invert layer"), tr("Invert layer")),
        }  # fmt: skip
        for index, (name, box) in enumerate(
            (("visible", self.visible), ("locked", self.locked), ("invert", self.invert))
        ):
            grid.addWidget(box, index // 2, index % 2)
            box.clicked.connect(lambda on, name=name: self.push(texts[name][on], **{name: on}))
        return grid

    def _push_stillness(self) -> None:
        """Take the motion away; keys stay where they are seen on their own frames."""
        project = self._document.project
        for layer in self.layers:
            if not project.is_locked(layer.id) and layer.transform is not None:
                project = still(project, layer.id)
        self._document.apply(tr("Remove motion"), project)

    def _push_name(self, name: str) -> None:
        if name and len(self.layers) == 1:
            self.push(tr("Rename"), name=name)
        self._pull()

    def _follow(self) -> None:
        self.opacity_key.frame = self._view.frame
        if any(isinstance(layer.opacity, Animated) for layer in self.layers):
            self._pull()

    def _pull(self, _ids: object = None) -> None:
        layers = self.layers
        if not layers:
            return
        is_free, is_one = any(not self._document.project.is_locked(layer.id) for layer in layers), len(layers) == 1
        self.name.show_name(*((layers[0].name,) if is_one else ("", tr("{count} layers", count=len(layers)))))
        self.name.setEnabled(is_one and is_free)
        self.blend.show_mode(shared(layer.blend for layer in layers))
        shown = [layer.opacity_at(self._view.frame) * 100 for layer in layers]
        self.opacity.show_value(shared(shown), shown[0])
        self.opacity_key.show_values([layer.opacity for layer in layers], self._view.frame)
        for name, box in (("visible", self.visible), ("locked", self.locked), ("invert", self.invert)):
            box.show_value(shared(getattr(layer, name) for layer in layers))
        for control in (self.blend, self.opacity, self.opacity_key, self.invert):
            control.setEnabled(is_free)
        self._motion.setText(_told(layers))
        self.clear_motion.setEnabled(is_free and any(layer.transform for layer in layers))


def _told(layers: list[Layer]) -> str:
    """Where the motion of the layers is known."""
    frames = {frame for layer in layers if layer.transform for frame in layer.transform.frames}
    if not frames:
        return tr("stands still")
    return f"{min(frames)} – {max(frames)}" if len(frames) > 1 else tr("set on {frame}", frame=min(frames))
