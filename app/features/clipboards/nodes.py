"""Copy for Nuke and for Fusion, and paste of what they copied: shapes as text of other programs on the clipboard."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from PySide6.QtGui import QGuiApplication

from roam_core.roto.layers import only

from ...jobs.copying import Copying
from ...jobs.importing import Import
from ...model.document import Document
from ...model.view_state import ViewState, shapes_in_hand
from ...translation import tr

PROGRAMS = {"nuke": "Nuke", "fusion": "Fusion"}
"""Programs that paste nodes as text, by the name of the format that they understand."""


class NodeClipboard:
    """The verbs behind "Copy for Nuke" and "Copy for Fusion", and what Ctrl+V does with text that is not ROAM's own."""

    def __init__(self, document: Document, view_state: ViewState, copying: Copying, importing: Import) -> None:
        self._document, self._view, self._copying, self._importing = document, view_state, copying, importing
        copying.copied.connect(_put_on_clipboard)
        importing.came_in.connect(self._select)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {f"edit.copy_{name}": partial(self.copy, name) for name in PROGRAMS}

    def copy(self, name: str) -> None:
        """Copy the selected shapes, or all where none is selected, as nodes of a program."""
        project = self._document.project
        if project.clip is None or not project.shapes:
            self._view.say(tr("There is no shape to copy for {programs}; draw one first.", programs=PROGRAMS[name]))
            return
        chosen = [shape.id for shape in shapes_in_hand(project, self._view.selection)]
        self._copying.start(name, PROGRAMS[name], only(project, chosen))

    def paste(self, text: str) -> bool:
        """Put in the shapes of a text of another program; False where it is none of a known kind."""
        from roam_core.interchange.clipboard import format_of

        if format_of(text) is None:
            return False
        self._importing.paste(text)
        return True

    def _select(self, ids: frozenset[str]) -> None:
        """Select what came in, by the clipboard or from a file."""
        project = self._document.project
        shapes = frozenset(shape.id for shape in only(project, ids).shapes)
        self._view.select(shapes, layers=frozenset(ids - shapes))


def _put_on_clipboard(text: str) -> None:
    QGuiApplication.clipboard().setText(text)
