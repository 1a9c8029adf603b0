"""Pictures of what lies on the desk: menus of right clicks, floating panels, the second viewer, full screen."""

from __future__ import annotations

from typing import TYPE_CHECKING

from scripts.camera import (
    IMAGES,
    QUALITY,
    SIZE,
    anchors_of,
    close_up,
    live,
    on_screen,
    opened,
    photograph,
    show_frame,
    until,
)

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow

TRACKED_TO, LOOKED_AT, SOFT = 1010, 1006, 24.0


def photograph_menu(shown: MainWindow) -> None:
    """The menu of a right click on a point."""
    from PySide6.QtCore import QPointF
    from PySide6.QtGui import QContextMenuEvent
    from PySide6.QtWidgets import QApplication

    opened(shown, shown.files.open_demo)
    (shape,) = shown.document.project.shapes
    shown.view_state.select(frozenset([shape.id]))
    spot = on_screen(shown, anchors_of(shown)[2])
    where = shown.canvas.mapToGlobal(QPointF(spot)).toPoint()
    event = QContextMenuEvent(QContextMenuEvent.Reason.Mouse, spot, where)
    QApplication.sendEvent(shown.canvas, event)
    photograph_screen(shown, "menu.jpg")
    menu = QApplication.activePopupWidget()
    if menu is not None:
        menu.close()


def photograph_soft_edge(shown: MainWindow) -> None:
    """A feather by its number, and the soft edge that it makes, in the viewer."""
    from roam_core.roto import edit

    (shape,) = shown.document.project.shapes
    project = edit.set_properties(shown.document.project, shape.id, feather=SOFT)
    shown.document.apply("Feather", project)
    close_up(shown)
    photograph(shown, "soft-edge.jpg")
    shown.document.undo_stack.undo()
    shown.actions_by_id["view.fit"].trigger()


def photograph_second_viewer(shown: MainWindow) -> None:
    """The matte beside the picture, and two panels that float."""
    from resources import demo

    shown.view_state.set_play_range(demo.FIRST, TRACKED_TO + 1)
    shown.actions_by_id["track.forward"].trigger()
    until(lambda: shown.propagation.is_running, "the engine to begin")
    until(lambda: not shown.propagation.is_running, "the engine to end")
    shown.view_state.set_play_range(demo.FIRST, demo.LAST + 1)
    show_frame(shown, LOOKED_AT)
    shown.actions_by_id["window.second_viewer"].trigger()
    live(400)
    for number, name in enumerate(("shapes", "timeline")):
        shown.actions_by_id[f"window.float_{name}"].trigger()
        window = shown.workspace.parts[name].window
        assert window is not None
        window.setGeometry(*((70, 90, 240, 150), (240, 560, 760, 190))[number])
    photograph_screen(shown, "second-viewer.jpg")


def photograph_full_screen(shown: MainWindow) -> None:
    """The viewer alone, with the timeline called in."""
    shown.actions_by_id["window.reset_layout"].trigger()
    shown.actions_by_id["window.full_screen"].trigger()
    shown.actions_by_id["window.timeline"].trigger()
    live(600)
    shown.actions_by_id["view.fit"].trigger()
    photograph(shown, "full-screen.jpg")
    shown.full_screen.leave()
    shown.resize(*SIZE)
    live(400)


def photograph_screen(shown: MainWindow, name: str) -> None:
    """Write what the screen shows where the window lies, with all that lies over it."""
    live(800)
    place = shown.frameGeometry()
    picture = shown.screen().grabWindow(0, place.x(), place.y(), place.width(), place.height())
    path = IMAGES / name
    if not picture.save(str(path), quality=QUALITY):
        raise SystemExit(f"screenshots: {path} cannot be written")
    print(f"Wrote {path.relative_to(IMAGES.parent.parent)}, {picture.width()}x{picture.height()}.")


SCENES = (photograph_menu, photograph_soft_edge, photograph_second_viewer, photograph_full_screen)
