"""The view bar at the window's upper right: what the plate is, and which view of it is shown."""

from __future__ import annotations

from PySide6.QtGui import QActionGroup
from PySide6.QtWidgets import QHBoxLayout, QLabel, QWidget

from app.actions import Actions
from app.canvas.view import CanvasView
from app.canvas.viewing import ViewMode
from app.document import Document
from app.folders import cache_folder
from app.panels.controls import tool_button
from roam_core.roto import Clip


class ViewBar(QWidget):
    """`plate_v003 . 1001-1048 . 960x540 . sRGB`, then a button for each view."""

    def __init__(self, document: Document, canvas: CanvasView, actions: Actions, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self._document, self._canvas, self._actions = document, canvas, actions
        self._plate = QLabel()
        self._plate.setObjectName("weak")
        row = QHBoxLayout(self)
        row.setContentsMargins(0, 1, 6, 1)
        row.setSpacing(2)
        row.addWidget(self._plate)
        row.addSpacing(12)
        self._group = QActionGroup(self)
        for mode in ViewMode:
            self._group.addAction(actions[f"view.{mode}"])
            row.addWidget(tool_button(actions, f"view.{mode}"))
        canvas.view_changed.connect(self._pull_view)
        self._pull_view()
        document.replaced.connect(self._pull)
        document.changed.connect(self._pull)

    def _pull_view(self) -> None:
        self._actions[f"view.{self._canvas.mode}"].setChecked(True)
        self._actions["view.hide_overlays"].setChecked(self._canvas.are_shapes_hidden)

    def _pull(self, _ids: object = None) -> None:
        clip = self._document.project.clip
        if clip is None:
            self._plate.setText("")
            return
        width, height = clip.size
        parts = (_name(clip), f"{clip.first}–{clip.last}", f"{width}×{height}", clip.colour_space)
        self._plate.setText("  ·  ".join(parts))
        self._plate.setToolTip(str(clip.path))


def _name(clip: Clip) -> str:
    """The clip's name as the artist knows it.

    A folder of the application's own cache, such as the demo's, is a name and a hash of its version; the hash says
    nothing to an artist.
    """
    return clip.name.rpartition("-")[0] or clip.name if clip.path.parent == cache_folder() else clip.name
