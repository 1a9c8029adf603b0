"""Copy and paste of the key of one frame: to another frame, or through a range of frames."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from roam_core.errors import RoamError
from roam_core.roto import Keyframe, Layer, Project, RotoShape, file
from roam_core.roto.pasting import copied_key, paste_key, paste_through, targets

from ...model.document import Document
from ...model.reasons import NOTHING_SELECTED, why_kept
from ...model.shown import editable_in
from ...model.view_state import ViewState, selected_shapes
from ...translation import N_, sentence_of, tr
from ...widgets.asking import ask
from .paste_range import PasteRangeDialog

MARK = "clipboard"
"""The project's extra field that tells keys from whole shapes on the clipboard."""

NOTHING_COPIED = N_("There is no key to paste; copy one first.")
OF_OTHERS = N_("The copied keys are of other shapes: select those, or as many shapes as were copied.")


class KeyClipboard:
    """The verbs on keys of the viewer. Other windows of ROAM understand what was copied."""

    def __init__(self, document: Document, view_state: ViewState, parent: QWidget | None = None) -> None:
        self._document, self._view, self._parent = document, view_state, parent

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"key.copy": self.copy, "key.paste": self.paste, "key.paste_range": self.ask_range}

    def copy(self) -> None:
        """Copy the selected shapes as they are on this frame."""
        shapes = selected_shapes(self._document.project, self._view.selection)
        if not shapes:
            self._view.say_here(tr("Select a shape first: its key on this frame is copied."))
            return
        alone = tuple(copied_key(shape, self._view.frame) for shape in shapes)
        held = Project(root=Layer("root", "Root", alone), extra={MARK: "keys"})
        QGuiApplication.clipboard().setText(file.dumps(held, Path()))
        self._view.say(tr("Copied the key of frame {frame}: paste puts it on another frame.", frame=self._view.frame))

    def paste(self) -> None:
        """Put the copied key on this frame."""
        frame = self._view.frame
        self._paste(tr("Paste key"), lambda shape, key: paste_key(shape, key, [frame]), range(frame, frame + 1))

    def ask_range(self) -> None:
        """Ask for the range through which to paste, unless there is nothing to paste."""
        if copied_keys() is None:
            self._view.say(tr(NOTHING_COPIED))
            return
        clip = self._document.project.clip
        dialog = PasteRangeDialog(self._view.play_range, clip.frame_range if clip else None, self._parent)
        ask(dialog, lambda: self.paste_through(dialog.frames, dialog.every), self._document.replaced)

    def paste_through(self, frames: range, every: int) -> None:
        """Hold the copied key through `frames`, with a key on each so many of them (0: on both ends alone)."""
        self._paste(tr("Paste key to range"), lambda shape, key: paste_through(shape, key, frames, every), frames)

    def _paste(self, text: str, verb: Callable[[RotoShape, Keyframe], RotoShape], frames: range) -> None:
        """Put the copied keys on `frames` into the shapes that may be edited there; says what keeps the first other."""
        copied, project = copied_keys(), self._document.project
        if copied is None:
            self._view.say(tr(NOTHING_COPIED))
            return
        editable = {shape.id for shape in editable_in(project, frames)}
        chosen = selected_shapes(project, self._view.selection)
        wanted = targets(project, copied, chosen)
        kept = why_kept(project, map(project.shape, wanted), frames)
        refused = ""
        for shape_id, key in wanted.items():
            try:
                if shape_id in editable:
                    project = project.with_shape(verb(project.shape(shape_id), key))
            except RoamError as error:  # it fits the others
                refused = refused or sentence_of(error)
        self._document.apply(text, project)
        if not wanted:
            self._view.say_here(tr(OF_OTHERS) if chosen else tr(NOTHING_SELECTED))
        elif refused or kept:
            self._view.say(refused or kept)


def copied_keys(text: str | None = None) -> list[RotoShape] | None:
    """The shapes, each with its one copied key, that the clipboard holds (its `text`); None where there are none."""
    text = QGuiApplication.clipboard().text() if text is None else text
    if f'"{MARK}"' not in text:  # hundreds of whole shapes are not read to find that out
        return None
    try:
        held = file.loads(text, Path(), tr("the clipboard"))
    except RoamError:
        return None
    return list(held.shapes) if held.extra.get(MARK) == "keys" else None
