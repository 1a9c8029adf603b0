"""What a right click offers, by what lies under the pointer."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from enum import StrEnum

from PySide6.QtWidgets import QMenu, QWidget

from .menus import SEPARATOR
from .specs import SPECS, Reach
from .viewer_actions import ActionsById


class Place(StrEnum):
    """What lies under the pointer: in the viewer, and in the list of shapes."""

    POINT = "point"
    SHAPE = "shape"
    BACKGROUND = "background"
    SHAPE_ROW = "row of a shape"
    LAYER_ROW = "row of a layer"
    EMPTY_LIST = "no row"


_OF_SHAPES = (
    "key.set", "key.delete", SEPARATOR,
    "track.forward", "track.backward", "track.fill", "track.delete_engine_keys", SEPARATOR,
    "edit.copy", "edit.cut", "edit.paste_properties", "shape.duplicate", "shape.rename", "shape.delete", SEPARATOR,
    "points.toggle_closed", "shape.reverse", "shape.to_bezier", "shape.to_bspline", SEPARATOR,
    "shape.group", "layer.ungroup", "shape.raise", "shape.lower", SEPARATOR,
    "object.one", "object.parts", SEPARATOR,
    "object.in_front", "object.behind", "object.as_stacked", SEPARATOR,
    "shape.lock", "shape.hide", "shape.show_all", "shape.solo", SEPARATOR,
    "view.fit_selection", "view.stabilise", "view.shape_panel", "file.export_selected",
)  # fmt: skip

CONTEXT: Mapping[Place, tuple[str, ...]] = {
    Place.POINT: (
        "points.smooth", "points.cusp", "points.first", "points.delete", SEPARATOR,
        "points.select_all", "points.transform", SEPARATOR,
        "feather.reset", "feather.all_keys", SEPARATOR,
        "key.set", "key.set_points", "key.delete", SEPARATOR,
        "track.forward", "track.backward", SEPARATOR,
        "view.fit_selection",
    ),
    Place.SHAPE: ("points.select_all", "points.transform", SEPARATOR, *_OF_SHAPES),
    Place.BACKGROUND: (
        "edit.paste", "shape.select_all", "shape.show_all", "shape.solo", SEPARATOR,
        "tool.bezier", "tool.bspline", "tool.object", "shape.from_mask", SEPARATOR,
        "view.overlay", "view.matte", "view.cutout", "view.hide_overlays", "view.stabilise", SEPARATOR,
        "view.fit", "view.actual_size", SEPARATOR,
        "mark.toggle", "track.next_doubtful",
    ),
    Place.SHAPE_ROW: _OF_SHAPES,
    Place.LAYER_ROW: (
        "layer.ungroup", "layer.add", "shape.group", "shape.raise", "shape.lower", SEPARATOR,
        "track.forward", "track.backward", "planar.forward", "planar.backward", SEPARATOR,
        "edit.copy", "edit.cut", "edit.paste_properties", "shape.duplicate", "shape.rename", "shape.delete", SEPARATOR,
        "shape.hide", "shape.show_all", "shape.solo", SEPARATOR,
        "view.fit_selection", "view.stabilise", "view.shape_panel", "file.export_selected",
    ),
    Place.EMPTY_LIST: (
        "edit.paste", "layer.add", SEPARATOR, "shape.select_all", "shape.find", "shape.show_all", "shape.solo",
    ),
}  # fmt: skip
"""What each offers; what cannot be done there at the moment is left out."""

_LISTS_OWN = (
    "points.delete", "points.select_all", "points.next", "points.previous", "proposal.keep", "proposal.refuse",
)  # fmt: skip
"""Actions of the viewer with keys that mean something else in a list: Del, Ctrl+A, Tab, Return, Backspace."""
IN_LIST = tuple(spec.id for spec in SPECS if spec.reach is Reach.VIEWER and spec.id not in _LISTS_OWN)
"""Actions of the viewer whose keys work in the list of shapes, too: what they mean are its rows.

So the tool for a shape may be chosen on the row that was clicked, and the keys work that the menu of a row shows.
"""


def context_menu(actions: ActionsById, place: Place, is_possible: Callable[[str], bool], parent: QWidget) -> QMenu:
    """A menu of what can be done there, with the keys; deleted when it closes."""
    menu = QMenu(parent)
    menu.aboutToHide.connect(menu.deleteLater)
    for entry in CONTEXT[place]:
        if entry == SEPARATOR:
            menu.addSeparator()  # several in a row are shown as one
        elif is_possible(entry):
            actions[entry].setShortcutVisibleInContextMenu(True)
            menu.addAction(actions[entry])
    return menu
