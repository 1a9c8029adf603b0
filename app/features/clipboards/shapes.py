"""Copy, cut and paste of layers and shapes: the clipboard holds them as the text of a project without a clip."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QWidget

from roam_core.errors import RoamError
from roam_core.roto import Layer, Project, file
from roam_core.roto.copies import joined, taken_out
from roam_core.roto.layers import home_for_new, moved

from ...model.document import Document
from ...model.reasons import keys_beside, outdated_by
from ...model.view_state import ViewState
from ...translation import tr
from ..verbs.shapes import NOTHING_SELECTED, delete, rows_in_hand, select_items, told_of_locked
from .keys import KeyClipboard, copied_keys
from .properties import PropertyClipboard


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
        self.properties = PropertyClipboard(document, view_state)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "edit.copy": self.copy,
            "edit.cut": self.cut,
            "edit.paste": self.paste,
            **self.keys.handlers(),
            **self.properties.handlers(),
        }

    def copy(self) -> None:
        """Copy the selected layers and shapes with all their keys."""
        self._copy(self._in_hand())

    def cut(self) -> None:
        """Copy the selected layers and shapes that are not locked, nor hold what is, and delete them."""
        if rows := self._in_hand():
            self._copy([item_id for item_id in rows if not self._document.project.holds_locked(item_id)])
            delete(self._document, self._view, rows, tr("Cut"))

    def _copy(self, item_ids: Sequence[str]) -> None:
        if item_ids:
            items = taken_out(self._document.project, item_ids)
            # The clipboard holds no project but this: nothing moves them there but their own keys and motion.
            QGuiApplication.clipboard().setText(file.dumps(Project(root=Layer("root", "Root", tuple(items))), Path()))
            layers = sum(isinstance(item, Layer) for item in items)
            counted = (
                (tr("%n layer(s)", "", layers), layers),
                (tr("%n shape(s)", "", len(items) - layers), len(items) - layers),
            )
            self._view.say(tr("Copied {shapes}.", shapes=", ".join(words for words, number in counted if number)))

    def paste(self) -> None:
        """Put copied layers and shapes on top of the layer in hand, with ids and names of their own, and select them.

        That is the layer into which a shape would be drawn, and of a layer that was copied the one around it. Where a
        key was copied last, put that on this frame.
        """
        text = QGuiApplication.clipboard().text()  # of hundreds of shapes 100 MB: taken out once
        if copied_keys(text) is not None:
            self.keys.paste()
            return
        try:
            copied = file.loads(text, Path(), tr("the clipboard")).root
        except RoamError:
            if not self._paste_text(text):
                self._view.say(tr("There is no shape to paste; copy one first, here or in another program."))
            return
        project, ids = joined(self._document.project, copied.children)
        home = self._home({item.id for item in copied.children})
        if home.id != project.root.id:
            project = moved(project, ids, home.id, len(home.children))
        outdated = outdated_by(self._document.project, project)
        self._document.apply(tr("Paste"), project)
        select_items(self._document, self._view, ids)
        beside = "" if project.clip is None else keys_beside(copied.shapes(), project.clip)
        if told := f"{beside or outdated} {told_of_locked(project, ids)}".strip():
            self._view.say(told)

    def _home(self, copied: set[str]) -> Layer:
        """The layer that takes what is pasted: no copy of a layer comes into its original, one of those `copied`."""
        project, rows = self._document.project, set(self._selected())
        layers = {item_id for item_id in rows & copied if isinstance(project.find(item_id), Layer)}
        around = {project.layers_above(item_id)[-1].id for item_id in layers}
        if project.root.id in around:
            return project.root
        return home_for_new(project, (rows - layers) | around)

    def _in_hand(self) -> list[str]:
        """The selected layers and shapes; says so when there is none."""
        if not (rows := self._selected()):
            self._view.say_here(tr(NOTHING_SELECTED))
        return rows

    def _selected(self) -> list[str]:
        return rows_in_hand(self._document.project, self._view)
