"""Makes the second viewer of a main window: what it shows and does is the first one's, how it looks at it its own."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QWidget

from roam_core.arrays import UInt8

from ..actions.actions import Actions
from ..actions.context import Place
from ..actions.viewer_actions import ViewerActions
from ..canvas.ripple_frame import RippleFrame
from ..canvas.view import CanvasView
from ..model.document import Document
from ..model.view_state import ViewState
from ..model.viewing import PROXIES, Viewing, ViewMode
from ..panels.second_viewer import SecondViewer
from ..widgets.focus import FocusFollowsPointer
from .context_menus import ContextMenus


def second_viewer(
    first: CanvasView,
    document: Document,
    view_state: ViewState,
    actions: Actions,
    parent: QWidget,
    look_through: Callable[[Viewing], object],
) -> SecondViewer:
    """The second viewer beside `first`; its dialogs and menus lie over `parent`.

    `look_through` is told how either looks at the plate, the first one first: proxies are that one's to choose.
    """
    look_through(first.viewing)

    def make() -> CanvasView:
        canvas = CanvasView(document, view_state, in_hand=first.in_hand)
        canvas.proposed, canvas.bones, canvas.edges = first.proposed, first.bones, first.edges
        canvas.stage.plate_of = first.stage.plate_of
        RippleFrame(view_state, canvas)
        FocusFollowsPointer(canvas, minds_fields=False)
        look_through(canvas.viewing)
        looks = {
            name: call for name, call in canvas.handlers().items() if name.startswith("view.") and name not in PROXIES
        }
        own = ViewerActions(actions, canvas, looks)
        menus = ContextMenus(document, view_state, own, parent)

        def open_menu(place: Place, where: QPoint) -> None:
            """A method of `menus` would be let go of with them: this holds them."""
            for mode in ViewMode:
                own[f"view.{mode}"].setChecked(canvas.mode is mode)
            own["view.hide_overlays"].setChecked(canvas.viewing.are_shapes_hidden)
            own["view.stabilise"].setChecked(canvas.viewing.is_stabilised)
            menus.open(place, where)

        canvas.menu_asked.connect(open_menu)
        return canvas

    def present() -> tuple[int, UInt8 | None] | None:
        stage = first.stage
        if stage.frame is None:
            return None
        return stage.frame, None if stage.picture is None else stage.picture.pixels

    return SecondViewer(make, present)
