"""The pictures of the documentation: the real window on the demo shot, photographed. `make screenshots` runs this.

Takes the display that is there, or starts a virtual one where there is none. Settings, journals and the log of the
person who runs it stay untouched: the window gets a state folder of its own.
"""

from __future__ import annotations

import os
import sys
import tempfile
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from scripts import desk_scenes
from scripts.camera import (
    IMAGES,
    anchors_of,
    close_up,
    close_up_on_all,
    display,
    drag,
    drag_on_screen,
    hover,
    live,
    on_screen,
    opened,
    photograph,
    save,
    show_frame,
    until,
    window,
)
from scripts.review_scenes import photograph_review

if TYPE_CHECKING:
    from app.shell.main_window import MainWindow
    from roam_core.propagate.frame.topology_proposals import Proposal
    from roam_core.roto import Project, RotoShape

TRACKED_TO, LOOKED_AT, STOPPED_AT, DOUBTED_AFTER = 1024, 1012, 1016, 1030
WALKER, WALKED_TO, STRIDE = 2, 1017, 1009
"""Which walker is shown in parts, how far it is tracked, and where it is looked at."""
SPOTS = ((376.0, 277.0), (382.0, 357.0))
"""On the first frame of the demo, marks that a point track would follow."""
DRAWN_POINTS = 11
"""Points of the outline that are drawn when the picture of drawing is taken."""


def main() -> int:
    """Take all pictures. Returns the exit code."""
    with tempfile.TemporaryDirectory() as state, display() as found:
        if not found:
            print(
                "screenshots: there is no display and no Xvfb; install xvfb or log in with a display.", file=sys.stderr
            )
            return 1
        os.environ["XDG_STATE_HOME"] = state
        IMAGES.mkdir(parents=True, exist_ok=True)
        with window(Path(state)) as shown:
            for scene in SCENES:
                scene(shown)
    return 0


def photograph_opening(shown: MainWindow) -> None:
    """What was found out about a clip before it opens."""
    from app.dialogs.clip_dialog import ClipDialog
    from roam_core.cli.demo import demo_frames

    assert shown.personal.folder is not None
    plates = shown.personal.folder.with_name("plates")
    plates.mkdir()
    (plates / "manta").symlink_to(demo_frames(), target_is_directory=True)  # no one's own folders in the picture
    shown.file_actions.open_dropped([plates / "manta"])
    until(lambda: shown.findChild(ClipDialog), "the clip to be looked at")
    dialog = shown.findChild(ClipDialog)
    assert dialog is not None
    photograph(dialog, "clip.jpg")
    opened(shown, dialog.buttons.accepted.emit)


def photograph_drawing(shown: MainWindow) -> None:
    """A Bezier shape around the manta, half drawn with real presses and drags."""
    from resources import demo

    shown.actions_by_id["tool.bezier"].trigger()
    points = demo.true_points(demo.FIRST)
    for anchor, _, out in points[:DRAWN_POINTS]:
        drag(shown, anchor, out)
    hover(shown, points[DRAWN_POINTS, 0])
    photograph(shown, "drawing.jpg")
    shown.actions_by_id["tool.select"].trigger()


def photograph_tracking(shown: MainWindow) -> None:
    """The demo as it opens while it is tracked, and when part of it is."""
    from resources import demo

    opened(shown, shown.files.open_demo)
    run = shown.propagation
    shown.view_state.set_play_range(demo.FIRST, TRACKED_TO + 1)
    shown.actions_by_id["track.forward"].trigger()
    until(lambda: shown.view_state.frame >= STOPPED_AT and run.is_running, "the engine to come this far")
    save(shown, "tracking.jpg")
    until(lambda: not run.is_running, "the engine to end")
    shown.view_state.set_play_range(demo.FIRST, demo.LAST + 1)
    show_frame(shown, LOOKED_AT)
    photograph(shown, "window.jpg")


def photograph_views(shown: MainWindow) -> None:
    """Cut-out, matte, onion skin; the matte beside the outline by a wipe."""
    from PySide6.QtCore import QPoint

    for view in ("cutout", "matte"):
        shown.actions_by_id[f"view.{view}"].trigger()
        live(1200)  # a matte that was rendered for the view before is not rendered again
        photograph(shown, f"{view}.jpg")
    shown.actions_by_id["view.wipe"].trigger()
    shown.actions_by_id["view.overlay"].trigger()
    middle = QPoint(shown.canvas.width() // 2, shown.canvas.height() // 2)
    drag_on_screen(shown, middle, on_screen(shown, anchors_of(shown).mean(axis=0)))
    photograph(shown, "wipe.jpg")
    shown.actions_by_id["view.wipe"].trigger()
    shown.canvas.viewing.set_onion(step=4)
    shown.actions_by_id["view.onion"].trigger()
    close_up(shown)
    photograph(shown, "onion.jpg")
    shown.actions_by_id["view.fit"].trigger()


def photograph_doubt(shown: MainWindow) -> None:
    """The next frame worth fixing, in the confidence view: tracked on to where the engine has doubts."""
    from resources import demo

    show_frame(shown, TRACKED_TO)
    shown.view_state.set_play_range(demo.FIRST, demo.LAST + 1)
    shown.actions_by_id["track.forward"].trigger()
    until(lambda: shown.propagation.is_running, "the engine to begin")
    until(lambda: not shown.propagation.is_running, "the engine to end")
    shown.actions_by_id["view.confidence"].trigger()
    show_frame(shown, DOUBTED_AFTER)
    shown.actions_by_id["track.next_doubtful"].trigger()
    frame = shown.view_state.frame
    until(lambda: frame in shown.reader.cached_frames(), "the most doubtful frame")
    photograph(shown, "confidence.jpg")
    photograph(shown.timeline, "timeline.png")
    shown.actions_by_id["view.overlay"].trigger()
    show_frame(shown, LOOKED_AT)


def photograph_editing(shown: MainWindow) -> None:
    """The transform box about the whole shape; feather pulled out of one point with the hand."""
    shown.actions_by_id["tool.transform"].trigger()
    photograph(shown, "transform.jpg")
    shown.actions_by_id["tool.feather"].trigger()
    anchors = anchors_of(shown)
    centre = anchors.mean(axis=0)
    for anchor in anchors[:3]:
        away = anchor - centre
        drag(shown, anchor, anchor + 28.0 * away / float((away @ away) ** 0.5))
    close_up(shown)
    photograph(shown, "feather.jpg")
    shown.actions_by_id["view.fit"].trigger()
    shown.actions_by_id["tool.select"].trigger()
    while shown.document.undo_stack.canUndo() and "feather" in shown.document.undo_stack.undoText().lower():
        shown.actions_by_id["edit.undo"].trigger()


def photograph_proposal(shown: MainWindow) -> None:
    """A proposal to part the tail from the body. Posed: the engine has no doubt of this kind about the demo."""
    from roam_core.propagate.frame.result import FrameResult, Termination, TrackResult

    (shape,) = shown.document.project.shapes
    proposal = posed_proposal(shape, shown.document.project)
    result = TrackResult(LOOKED_AT, shape, 0.9, {}, Termination.CONVERGED, 0.0, (proposal,))
    shown.proposals.take(FrameResult(LOOKED_AT, (result,)), 1)
    close_up(shown)
    photograph(shown, "proposal.jpg")
    shown.actions_by_id["view.fit"].trigger()
    shown.actions_by_id["proposal.refuse"].trigger()


def posed_proposal(shape: RotoShape, project: Project) -> Proposal:
    """The shape's region on the frame, parted where it is thin."""
    import cv2
    import numpy as np

    from roam_core import render_matte
    from roam_core.propagate.frame.topology_proposals import Proposal
    from roam_core.proposal.reshaping.topology import TopologyChange, TopologyKind

    assert project.clip is not None
    width, height = project.clip.size
    whole = (render_matte([shape], LOOKED_AT, (height, width)) > 0.5).astype(np.uint8)
    body = cv2.morphologyEx(whole, cv2.MORPH_OPEN, cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (25, 25)))
    rings = []
    for part in (body, whole - body):
        found, _ = cv2.findContours(part, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)
        rings.append(max(found, key=cv2.contourArea)[:, 0].astype(np.float64) + 0.5)
    return Proposal.of(TopologyChange(TopologyKind.SPLIT, tuple(rings), 41.6), shape, LOOKED_AT, height / 480.0)


def photograph_planar(shown: MainWindow) -> None:
    """A layer that moves as the surface in the shape does: its corners with an adjust key, its row in the timeline.

    Then points that a track would follow.
    """
    import numpy as np
    from PySide6.QtCore import Qt
    from PySide6.QtTest import QTest

    from resources import demo

    show_frame(shown, demo.FIRST)
    shown.view_state.set_play_range(demo.FIRST, LOOKED_AT + 1)
    shown.actions_by_id["planar.forward"].trigger()
    until(lambda: shown.planar.is_running, "the planar track to begin")
    until(lambda: not shown.planar.is_running, "the planar track to end")
    shown.view_state.set_play_range(demo.FIRST, demo.LAST + 1)
    shown.view_state.set_tool("adjust")
    QTest.keyClick(shown.canvas, Qt.Key.Key_Return)
    photograph(shown, "planar.jpg")
    for _ in range(2):
        shown.actions_by_id["edit.undo"].trigger()
    show_frame(shown, demo.FIRST)
    shown.view_state.set_tool("points")
    for spot in np.array(SPOTS):
        drag(shown, spot, spot)
    photograph(shown, "points.jpg")
    QTest.keyClick(shown.canvas, Qt.Key.Key_Escape)
    shown.view_state.set_tool("select")
    show_frame(shown, LOOKED_AT)


def photograph_finding(shown: MainWindow) -> None:
    """The command palette with a few letters typed; the keymap editor, the settings."""
    from PySide6.QtTest import QTest

    shown.actions_by_id["help.palette"].trigger()
    QTest.keyClicks(shown.services.palette.field, "doub")
    photograph(shown, "palette.jpg")
    shown.services.palette.leave()
    shown.actions_by_id["edit.keymap"].trigger()
    shown.actions_by_id["edit.settings"].trigger()
    for dialog, name in ((shown.services._editor, "keymap"), (shown.services._settings, "settings")):
        assert dialog is not None
        photograph(dialog, f"{name}.png")
        dialog.close()


def photograph_export(shown: MainWindow) -> None:
    """The export dialog on the tracked demo, with the options of mattes."""
    from app.dialogs.export_dialog import ExportDialog
    from app.jobs.export import MATTES

    shown.actions_by_id["file.export"].trigger()
    dialog = shown.findChild(ExportDialog)
    assert dialog is not None
    dialog.choose(MATTES)
    dialog.target.setText("shots/demo/mattes")
    photograph(dialog, "export.png")
    shown.view_state.select(frozenset())
    with posed(shown, lossy_project(shown.document.project)):
        dialog.choose("cvat")
        dialog.target.setText("shots/demo/manta.xml")
        until(lambda: dialog.notes.toPlainText(), "what would be lost")
        photograph(dialog, "losses.png")
    dialog.close()


def photograph_keyed_value(shown: MainWindow) -> None:
    """The upper rows of the Shape panel, of a shape whose opacity has keys, between two of them."""
    from roam_core.roto import Animated, Interpolation, ValueKey

    (shape,) = shown.document.project.shapes
    faded = Animated((ValueKey(LOOKED_AT - 8, 1.0), ValueKey(LOOKED_AT + 8, 0.4, Interpolation.SMOOTH)))
    with posed(shown, shown.document.project.with_shape(replace(shape, opacity=faded, feather=6.0))):
        shown.view_state.select(frozenset([shape.id]))
        live(300)
        photograph(shown.properties, "keyed.png", shown.properties.object_form.y())


def photograph_curves(shown: MainWindow) -> None:
    """The curve editor on an opacity with tangents, one of its keys chosen."""
    from roam_core.roto import Animated, Interpolation, ValueKey

    (shape,) = shown.document.project.shapes
    peak = LOOKED_AT + 2
    keys = (
        ValueKey(LOOKED_AT - 9, 0.2, slopes=(0.0, 0.02)),
        ValueKey(peak, 0.9, slopes=(0.01, 0.01)),
        ValueKey(LOOKED_AT + 16, 0.4, Interpolation.SMOOTH),
        ValueKey(LOOKED_AT + 26, 0.7, Interpolation.HOLD),
    )
    soft = Animated((ValueKey(LOOKED_AT - 5, 2.0), ValueKey(LOOKED_AT + 20, 12.0)))
    with posed(shown, shown.document.project.with_shape(replace(shape, opacity=Animated(keys), feather=soft))):
        shown.view_state.select(frozenset([shape.id]))
        show_frame(shown, LOOKED_AT)
        shown.actions_by_id["view.curves"].setChecked(True)
        shown.timeline.values.select(frozenset([(shape.id, "opacity", peak)]))
        live(500)
        photograph(shown, "curves.jpg")
        shown.actions_by_id["view.curves"].setChecked(False)


@contextmanager
def posed(shown: MainWindow, project: Project) -> Iterator[None]:
    """The project for a while, as one step that is undone."""
    shown.document.apply("Pose", project)
    yield
    shown.actions_by_id["edit.undo"].trigger()


def lossy_project(project: Project) -> Project:
    """The demo's with a layer that takes away, a soft edge and an opacity: what labels cannot hold."""
    from roam_core.roto import BlendMode, edit

    (shape,) = project.shapes
    project = project.with_shape(replace(shape, feather=4.0))
    project, layer = edit.add_layer(project, name="Remora")
    project, inner = edit.new_shape(project, shape.keys[0].points, shape.keys[0].frame, name="Fin", layer_id=layer.id)
    project = project.with_shape(replace(inner, opacity=0.5))
    return project.map_item(layer.id, lambda item: replace(item, blend=BlendMode.SUBTRACT))


def photograph_start(shown: MainWindow) -> None:
    """The start page, with a project and a clip that were opened before."""
    folder = shown.personal.folder
    assert folder is not None
    folder.mkdir(exist_ok=True)
    saved: list[bool] = []
    shown.files.saved.connect(lambda: saved.append(True))
    shown.files.save(folder / "manta.roam")
    until(lambda: saved, "the project to be saved")
    live(1200)  # its picture is drawn beside the window's thread
    shown.files.new()
    shown.reopening.page.begin()
    photograph(shown, "start.jpg")


def photograph_parts(shown: MainWindow) -> None:
    """A walking figure: its parts on the first frame, their joints and edges there, and tracked on a later one."""
    from resources import walker
    from roam_core.roto import file

    assert shown.personal.folder is not None
    plates = shown.personal.folder.with_name("plates") / "walker"
    walker.write_frames(plates, walker.Walker(WALKER))
    path = plates.with_name("walker.roam")
    file.save(walker_project(plates), path)
    opened(shown, lambda: shown.files.open_project(path))
    close_up_on_all(shown)
    photograph(shown, "parts-drawn.jpg")
    shown.actions_by_id["view.joints"].trigger()
    photograph(shown, "parts-joints.jpg")
    shown.actions_by_id["view.joints"].trigger()
    shown.actions_by_id["view.edges"].trigger()
    until(lambda: len(shown.edge_kinds.here()) == len(walker.ORDER), "the edges")
    photograph(shown, "parts-edges.jpg")
    shown.actions_by_id["view.edges"].trigger()
    shown.view_state.set_play_range(walker.FIRST, WALKED_TO + 1)
    shown.view_state.select(frozenset())
    shown.actions_by_id["track.forward"].trigger()
    until(lambda: shown.propagation.is_running, "the engine to begin")
    until(lambda: not shown.propagation.is_running, "the engine to end")
    show_frame(shown, STRIDE)
    close_up_on_all(shown)
    photograph(shown, "parts-tracked.jpg")


def photograph_softness(shown: MainWindow) -> None:
    """The figure's matte with the plate's shutter, and to the left of the wipe's line as it was drawn."""
    (leg,) = [shape for shape in shown.document.project.shapes if shape.name == "Far lower leg"]
    shown.view_state.select(frozenset([leg.id]))
    shown.actions_by_id["view.fit_selection"].trigger()
    shown.view_state.select(frozenset())
    shown.actions_by_id["view.matte"].trigger()
    shown.actions_by_id["view.hide_overlays"].trigger()
    live(1200)
    shown.actions_by_id["view.wipe"].trigger()
    shown.actions_by_id["shape.match_edge"].trigger()
    until(lambda: shown.under_way.is_any, "the plate to be looked at")
    until(lambda: not shown.under_way.is_any, "the plate's edge")
    live(1200)
    photograph(shown, "softness.jpg")
    shown.actions_by_id["view.hide_overlays"].trigger()
    shown.actions_by_id["view.wipe"].trigger()
    shown.actions_by_id["view.overlay"].trigger()


def walker_project(plates: Path) -> Project:
    """The walker's clip, and a shape for each of its parts with the true outline on the first frame, bottom first."""
    from resources import walker
    from roam_core.media import open_clip
    from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape
    from roam_core.roto.project import PALETTE

    walk = walker.Walker(WALKER)
    shapes = tuple(
        RotoShape(
            f"shape-{number}",
            part.capitalize(),
            (Keyframe(walker.FIRST, walk.points(part, walker.FIRST)),),
            colour=PALETTE[number % len(PALETTE)],
        )
        for number, part in enumerate(walk.order, start=1)
    )
    return Project(Clip.of(open_clip(plates)), Layer("root", "Root", shapes))


def photograph_german(shown: MainWindow) -> None:
    """The window in German, on the demo."""
    from app.model.personal import Personal
    from app.shell.main_window import MainWindow
    from app.translation import SOURCE, speak

    assert shown.personal.folder is not None
    speak("de")
    state = shown.personal.folder.with_name("german")
    german = MainWindow(state / "journal", Personal(state, shown.personal.folder.with_name("cache")))
    german.resize(shown.size())
    german.show()
    german.files.open_demo()
    until(lambda: german.document.project.shapes and german.reader.source is not None, "the demo in German")
    german.view_state.select(frozenset({german.document.project.shapes[0].id}))
    show_frame(german, german.view_state.frame + 1)
    photograph(german, "german.jpg")
    german._leave()
    until(lambda: not german.isVisible(), "the German window to close")
    speak(SOURCE)


SCENES = (
    photograph_opening,
    photograph_drawing,
    photograph_tracking,
    photograph_views,
    photograph_doubt,
    photograph_editing,
    photograph_proposal,
    photograph_planar,
    photograph_finding,
    photograph_export,
    photograph_keyed_value,
    photograph_curves,
    lambda shown: photograph_review(shown, "review.jpg", "review-movie.png", "contact-sheet.jpg"),
    photograph_start,
    photograph_parts,
    photograph_softness,
    photograph_german,
    *desk_scenes.SCENES,
)


if __name__ == "__main__":
    sys.exit(main())
