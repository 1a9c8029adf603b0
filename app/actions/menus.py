"""The menu bar: which actions stand in which menu."""

from __future__ import annotations

from PySide6.QtWidgets import QMenu, QMenuBar

from ..translation import N_, tr
from .actions import Actions

SEPARATOR = ""
RECENT = "menu.recent"
"""Stands where a submenu is put in that fills itself."""
PASTE_PROPERTIES = "menu.paste_properties"

MENUS: dict[str, tuple[str, ...]] = {
    N_("File"): (
        "file.new", "file.open_clip", "file.open_movie", "file.open_project", RECENT,
        "file.open_demo", SEPARATOR,
        "file.clip_settings", "file.relink_clip", "file.reload_clip", SEPARATOR,
        "file.save", "file.save_as", "file.save_version", "file.recover", SEPARATOR,
        "file.import_shapes", "file.import_masks", SEPARATOR,
        "file.export", "file.export_selected", "file.export_nuke", "file.export_mattes", SEPARATOR,
        "file.quit",
    ),
    N_("Edit"): (
        "edit.undo", "edit.redo", "edit.history", SEPARATOR,
        "edit.copy", "edit.cut", "edit.paste", PASTE_PROPERTIES, "edit.copy_nuke", "edit.copy_fusion", SEPARATOR,
        "points.delete", "shape.select_all", "points.select_all", "shape.select_none", "points.next",
        "points.previous", "shape.find", SEPARATOR,
        "points.soft", "points.lasso", SEPARATOR,
        "points.transform", "points.mirror_across", "points.mirror_down", "shape.raise", "shape.lower", SEPARATOR,
        "points.smooth", "points.cusp", "points.toggle_closed", "shape.reverse", "points.first",
        "shape.to_bezier", "shape.to_bspline",
        "feather.reset", "feather.all_keys", SEPARATOR,
        "edit.keymap", "edit.settings",
    ),
    N_("Shape"): (
        "tool.select", "tool.transform", "tool.reshape", "tool.bezier", "tool.bspline", "tool.polygon", "tool.freehand",
        "tool.magnetic", "tool.ellipse", "tool.rectangle", "tool.object", "shape.from_mask", "tool.feather",
        "tool.points", "tool.adjust", SEPARATOR,
        "shape.steady", "shape.match_edge", SEPARATOR,
        "shape.rename", "shape.duplicate", "shape.group", "layer.ungroup", "layer.add", "shape.delete", SEPARATOR,
        "shape.lock", "shape.hide", "shape.show_all", "shape.solo",
    ),
    N_("Keys"): (
        "key.set", "key.set_points", "key.delete", SEPARATOR,
        "key.linear", "key.smooth", "key.hold", "key.tangents", SEPARATOR,
        "key.copy", "key.paste", "key.paste_range", SEPARATOR,
        "key.shift", "key.stretch", SEPARATOR,
        "key.auto", "key.points", "key.ripple",
    ),
    N_("Track"): (
        "track.forward", "track.backward", "track.forward_one", "track.backward_one", "track.to_next_key",
        "track.fill", SEPARATOR,
        "track.stop", SEPARATOR,
        "track.next_doubtful", "track.previous_doubtful", "track.most_doubtful", SEPARATOR,
        "object.one", "object.parts", "object.apart", SEPARATOR,
        "object.attach", "object.detach", SEPARATOR,
        "object.in_front", "object.behind", "object.as_stacked", SEPARATOR,
        "planar.forward", "planar.backward", SEPARATOR,
        "track.delete_engine_keys",
    ),
    N_("Proposal"): (
        "proposal.next", SEPARATOR,
        "proposal.keep", "proposal.refuse", SEPARATOR,
        "proposal.keep_always", "proposal.refuse_always", "proposal.ask_again",
    ),
    N_("View"): (
        "view.source", "view.overlay", "view.matte", "view.cutout", "view.onion", "view.confidence", "view.alpha",
        "view.hide_overlays", "view.joints", "view.edges", "view.stabilise", "view.magnifier", SEPARATOR,
        "view.colour", "view.red", "view.green", "view.blue", "view.luminance", "view.reset_look", SEPARATOR,
        "view.full", "view.half", "view.quarter", SEPARATOR,
        "view.wipe", "view.pin", SEPARATOR,
        "view.fit", "view.fit_selection", "view.actual_size", "view.zoom_in", "view.zoom_out", SEPARATOR,
        "view.fit_time", "view.zoom_in_time", "view.zoom_out_time", SEPARATOR,
        "view.tall_timeline", "view.curves", "view.shape_panel", "view.panels",
    ),
    N_("Playback"): (
        "time.toggle_play", "time.play", "time.play_back", "time.pause", "time.play_slowly",
        "time.play_back_slowly", "time.loop", "time.ping_pong", SEPARATOR,
        "time.previous", "time.next", "time.previous_key", "time.next_key", "time.first", "time.last", SEPARATOR,
        "time.set_in", "time.set_out", "time.clear_range",
    ),
    N_("Review"): (
        "mark.toggle", "mark.name", "time.previous_mark", "time.next_mark", SEPARATOR,
        "review.panel", "review.measure_boil", SEPARATOR,
        "review.movie", "review.sheet",
    ),
    N_("Window"): (
        "window.full_screen", "window.second_viewer", SEPARATOR,
        "window.shapes", "window.track", "window.planar", "window.shape", "window.timeline", SEPARATOR,
        "window.float_shapes", "window.float_track", "window.float_planar", "window.float_shape",
        "window.float_review", "window.float_history", "window.float_log", "window.float_timeline",
        "window.float_curves",
        "window.float_second_viewer", SEPARATOR,
        "window.reset_layout", SEPARATOR,
        "view.next_part", "view.previous_part",
    ),
    N_("Help"): ("help.palette", "help.keys", SEPARATOR, "help.log", "help.report", "help.about"),
}  # fmt: skip

SUBMENUS: dict[str, tuple[str, tuple[str, ...]]] = {
    PASTE_PROPERTIES: (
        N_("Paste properties"), ("edit.paste_properties", "edit.paste_matte_properties", "edit.paste_colour"),
    ),
}  # fmt: skip
"""Titles and actions of submenus, by what stands for them in a menu."""


def menu_of(action_id: str) -> str:
    """The title of the menu in which an action stands, or its submenu; empty where it stands in none."""
    entry = next((name for name, (_, entries) in SUBMENUS.items() if action_id in entries), action_id)
    return next((tr(title) for title, entries in MENUS.items() if entry in entries), "")


def menu_bar(actions: Actions, recent: QMenu) -> QMenuBar:
    """A bar with every menu; `recent` lists what was opened before."""
    bar = QMenuBar()
    for title, entries in MENUS.items():
        menu = bar.addMenu(tr(title))
        for entry in entries:
            if entry == SEPARATOR:
                menu.addSeparator()
            elif entry == RECENT:
                menu.addMenu(recent)
            elif entry in SUBMENUS:
                below, names = SUBMENUS[entry]
                menu.addMenu(tr(below)).addActions([actions[name] for name in names])
            else:
                menu.addAction(actions[entry])
    return bar
