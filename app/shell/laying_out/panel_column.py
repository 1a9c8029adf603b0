"""PanelColumn: the panels at the right of the viewer, one below the other; those that are asked for come at its end."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import Qt, QTimer
from PySide6.QtWidgets import QScrollArea, QUndoView

from ...actions.actions import Actions
from ...panels.planar import PlanarPanel
from ...panels.properties import PropertiesPanel
from ...panels.review import ReviewPanel
from ...panels.shapes import ShapesPanel
from ...panels.tracker import TrackerPanel
from ...translation import tr
from ...widgets.controls import tool_button
from ...widgets.panel import Panel
from ..workspace import Workspace
from . import layout

SHAPE_TOOLS = ("shape.group", "shape.duplicate", "shape.delete")
KEY_TOOLS = ("key.set", "key.delete")
"""Actions with a button in the title of the panels Shapes and Shape."""


@dataclass(frozen=True)
class PanelParts:
    """What lies in the panels; `log` is a panel already."""

    shapes: ShapesPanel
    tracker: TrackerPanel
    planar: PlanarPanel
    properties: PropertiesPanel
    review: ReviewPanel
    history: QUndoView
    log: Panel


class PanelColumn:
    """Gives each part its panel, and `workspace` the panels: they fold, float and go away.

    Attributes
    ----------
    area : the column itself, which scrolls where the window is low.
    shapes, shape, review, history : four of its panels.
    """

    def __init__(self, parts: PanelParts, actions: Actions, workspace: Workspace) -> None:
        self._parts, self._actions = parts, actions
        shape_tools = tuple(tool_button(actions, name) for name in SHAPE_TOOLS)
        self.history = Panel("history", tr("History"), parts.history)
        self.review = Panel("review", tr("Review"), parts.review, parts.review.tools)
        key_tools = tuple(tool_button(actions, name) for name in KEY_TOOLS)
        self.shape = Panel("shape", tr("Shape"), parts.properties, key_tools)
        self.shapes = shapes = Panel("shapes", tr("Shapes"), parts.shapes, shape_tools)
        tracks = Panel("track", tr("Track"), parts.tracker), Panel("planar", tr("Planar track"), parts.planar)
        asked = self.review, self.history, parts.log
        column = layout.column(shapes, *tracks, self.shape, *asked, growing=shapes, is_loose=True)
        column.setObjectName("panelColumn")
        column.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        for panel in (shapes, *tracks, self.shape):
            workspace.add(panel.name, panel.title, panel)
        shows = ("review.panel", "edit.history", "help.log")
        for panel, show in zip(asked, shows, strict=True):
            workspace.add(panel.name, panel.title, panel, show=show, is_shown_first=False)
        self.area: QScrollArea = layout.scrolled(column)
        actions["view.panels"].toggled.connect(self.area.setVisible)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "shape.find": self.find_shape,
            "shape.rename": self.rename,
            "view.shape_panel": self.show_shape,
        }

    def find_shape(self) -> None:
        """Bring the field that searches the Shapes panel into sight, and give it the keyboard."""
        search = self._parts.shapes.search
        self._show(self.shapes, "window.shapes")
        search.open()
        QTimer.singleShot(0, self.area, lambda: self.area.ensureWidgetVisible(search))

    def rename(self) -> None:
        """Bring the list of shapes into sight, and let the name of what is selected be typed there."""
        self._show(self.shapes, "window.shapes")
        self._parts.shapes.rename()
        QTimer.singleShot(0, self.area, lambda: self.area.ensureWidgetVisible(self._parts.shapes))

    def show_shape(self) -> None:
        """Bring the Shape panel into sight, unfolded."""
        self._show(self.shape, "window.shape")
        QTimer.singleShot(0, self.area, lambda: self.area.ensureWidgetVisible(self._parts.properties))

    def _show(self, panel: Panel, switch: str) -> None:
        for name in ("view.panels", switch):
            self._actions[name].setChecked(True)
        panel.fold(False)
