"""The menus of right clicks: in the viewer and in the list of shapes, what can be done there, with its keys."""

from __future__ import annotations

from functools import partial

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QMenu, QWidget

from ..actions.context import Place, context_menu
from ..actions.viewer_actions import ActionsById
from ..features.possible import is_possible
from ..model.document import Document
from ..model.view_state import ViewState


class ContextMenus:
    """Opens one where it is asked for; they lie over `parent`."""

    def __init__(self, document: Document, view_state: ViewState, actions: ActionsById, parent: QWidget) -> None:
        self._document, self._view, self._actions, self._parent = document, view_state, actions, parent

    def menu(self, place: Place) -> QMenu:
        """What can be done there now."""
        possible = partial(is_possible, self._document.project, self._view)
        return context_menu(self._actions, place, possible, self._parent)

    def open(self, place: Place, where: QPoint) -> None:
        """Show it at a place of the screen."""
        self.menu(place).popup(where)
