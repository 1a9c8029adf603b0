"""Copy, cut and paste of shapes: the clipboard holds them as the text of a project without a clip."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from roam_core.errors import RoamError
from roam_core.roto import Layer, Project, RotoShape, edit, file, linking
from roam_core.roto.baking import baked

from ...model.document import Document
from ...model.view_state import ViewState, selected_shapes
from ...translation import tr
from ..verbs.shapes import delete
from .keys import KeyClipboard, copied_keys


class ShapeClipboard:
    """The verbs behind Ctrl+C, X and V in the viewer. Other windows of ROAM understand what was copied.

    `paste_text(text)` takes shapes out of text of another program, and says whether it knows its kind.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        parent: QWidget | None = None,
        paste_text: Callable[[str], bool] = lambda _: False,
    ) -> None:
        self._document, self._view, self._paste_text = document, view_state, paste_text
        self.keys = KeyClipboard(document, view_state, parent)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "edit.copy": self.copy,
            "edit.cut": self.cut,
            "edit.paste": self.paste,
        } | self.keys.handlers()

    def copy(self) -> None:
        """Copy the selected shapes with all their keys."""
        self._copy(self._selected())

    def cut(self) -> None:
        """Copy the selected shapes that are not locked, and delete them."""
        if shapes := self._selected():
            self._copy([shape for shape in shapes if not self._document.project.is_locked(shape.id)])
            delete(self._document, self._view, [shape.id for shape in shapes], tr("Cut"))

    def _copy(self, shapes: Sequence[RotoShape]) -> None:
        if shapes:
            QGuiApplication.clipboard().setText(_text(shapes))
            self._view.say(tr("Copied {shapes}.", shapes=tr("%n shape(s)", "", len(shapes))))

    def paste(self) -> None:
        """Put copied shapes on top, with ids and names of their own, and select them; a copied key on this frame."""
        if copied_keys() is not None:
            self.keys.paste()
            return
        text = QGuiApplication.clipboard().text()
        try:
            copied = file.loads(text, Path(), tr("the clipboard")).shapes
        except RoamError:
            if not self._paste_text(text):
                self._view.say(tr("There is no shape to paste; copy one first, here or in another program."))
            return
        project, ids = self._document.project, []
        for shape in linking.relinked(project, copied):
            project, pasted = _added(project, shape)
            ids.append(pasted.id)
        self._document.apply(tr("Paste"), project)
        self._view.select(frozenset(ids))
        self._tell_of_keys_beside_the_clip(copied)

    def _tell_of_keys_beside_the_clip(self, shapes: Iterable[RotoShape]) -> None:
        """Say so where no key of what was pasted lies on the clip: it came from another shot, and never moves here."""
        clip, frames = self._document.project.clip, [frame for shape in shapes for frame in shape.frames]
        if clip is not None and frames and not any(frame in clip.frame_range for frame in frames):
            self._view.say(
                tr(
                    "The keys lie on frames {low} to {high}, none of them on the clip's {first} to {last}.",
                    low=min(frames),
                    high=max(frames),
                    first=clip.first,
                    last=clip.last,
                )
            )

    def _selected(self) -> list[RotoShape]:
        return selected_shapes(self._document.project, self._view.selection)


def _text(shapes: Sequence[RotoShape]) -> str:
    # Where they are pasted no layer moves them: what theirs did becomes their own.
    held = tuple(baked(shape) if shape.placement else shape for shape in shapes)
    return file.dumps(Project(root=Layer("root", "Root", held)), Path())


def _added(project: Project, shape: RotoShape) -> tuple[Project, RotoShape]:
    taken = {item.name for item in project.root.items()}
    name = project.free_name(shape.name) if shape.name in taken else shape.name
    copy = replace(shape, id=project.free_id("shape"), name=name)
    return edit.add_shape(project, copy), copy
