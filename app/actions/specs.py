"""What every action of the window is called, where its keys work and what it shows; by id."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum


class Reach(StrEnum):
    """Where an action's keys work: transport and files in the whole window, edits in the viewer only."""

    WINDOW = "window"
    VIEWER = "viewer"


@dataclass(frozen=True)
class ActionSpec:
    """What an action is called and where its keys work; `tip` is a sentence for the tooltip, if the title needs one."""

    id: str
    title: str
    reach: Reach = Reach.WINDOW
    icon: str = ""
    tip: str = ""
    checkable: bool = False


_VIEWER = Reach.VIEWER
_TO_KEYS = "Go one key, or change of depth, of the shapes in hand"

SPECS: tuple[ActionSpec, ...] = (
    ActionSpec("file.new", "New"),
    ActionSpec("file.open_clip", "Open clip…"),
    ActionSpec("file.open_movie", "Open movie…"),
    ActionSpec("file.open_project", "Open project…"),
    ActionSpec("file.open_demo", "Open the demo", tip="A short shot to try everything on"),
    ActionSpec("file.relink_clip", "Relink clip…", tip="Another version of the plate below the same shapes"),
    ActionSpec("file.save", "Save"),
    ActionSpec("file.save_as", "Save as…"),
    ActionSpec("file.recover", "Recover work…", tip="What crashes left, and what was thrown away, session by session"),
    ActionSpec("file.import_shapes", "Import shapes…", tip="Shapes of Nuke, Silhouette and others; or drop the file"),
    ActionSpec("file.import_masks", "Import masks…", tip="Fit shapes to a folder of mask pictures"),
    ActionSpec("file.export", "Export…", tip="Shapes for other programs, and mattes: every format, keys and frames"),
    ActionSpec("file.export_selected", "Export selected shapes…", tip="The selected shapes alone, in any format"),
    ActionSpec("file.export_nuke", "Export to Nuke…"),
    ActionSpec("file.export_mattes", "Export mattes…"),
    ActionSpec("file.quit", "Quit"),
    ActionSpec("edit.undo", "Undo"),
    ActionSpec("edit.redo", "Redo"),
    ActionSpec("edit.history", "History", tip="Show every step and go back to any", checkable=True),
    ActionSpec("edit.copy", "Copy", _VIEWER, tip="Copy the selected shapes"),
    ActionSpec("edit.cut", "Cut", _VIEWER, tip="Cut the selected shapes"),
    ActionSpec("edit.paste", "Paste", _VIEWER, tip="Paste the copied shapes, also those copied in Nuke or Fusion"),
    ActionSpec("edit.copy_nuke", "Copy for Nuke", tip="The selected shapes, or all, as a node to paste into a script"),
    ActionSpec("edit.copy_fusion", "Copy for Fusion", tip="The selected shapes, or all, as nodes to paste into a flow"),
    ActionSpec("tool.select", "Select", _VIEWER, "tool-select", "Select and drag shapes, points and handles", True),
    ActionSpec(
        "tool.transform", "Transform", _VIEWER, "tool-transform", "Move, turn, scale and shear points or shapes", True
    ),
    ActionSpec("tool.reshape", "Reshape", _VIEWER, "tool-reshape", "Pull the points under a soft, round brush", True),
    ActionSpec(
        "tool.bezier", "Bezier", _VIEWER, "tool-bezier", "Draw a Bezier shape: click corners, drag curves", True
    ),
    ActionSpec("tool.bspline", "B-spline", _VIEWER, "tool-bspline", "Draw a smooth shape by its control points", True),
    ActionSpec("tool.polygon", "Polygon", _VIEWER, "tool-polygon", "Draw a polygon", True),
    ActionSpec("tool.freehand", "Freehand", _VIEWER, "tool-freehand", "Draw by hand; few points are fitted", True),
    ActionSpec(
        "tool.magnetic", "Magnetic lasso", _VIEWER, "tool-magnetic", "Draw a line that clings to the edges", True
    ),
    ActionSpec(
        "tool.object", "Object", _VIEWER, "tool-object", "Box or click an object: a shape is fitted to it", True
    ),
    ActionSpec("shape.to_bezier", "Make Bezier", tip="Give the selected B-splines handles; no outline changes"),
    ActionSpec("shape.to_bspline", "Make B-spline", tip="Give the selected shapes control points: smooth everywhere"),
    ActionSpec("shape.from_mask", "From mask image…", tip="Fit shapes to a picture of this frame's mask"),
    ActionSpec("tool.ellipse", "Ellipse", _VIEWER, "tool-ellipse", "Span an ellipse; Shift makes it a circle", True),
    ActionSpec(
        "tool.rectangle", "Rectangle", _VIEWER, "tool-rectangle", "Span a rectangle; Shift makes it a square", True
    ),
    ActionSpec(
        "tool.feather", "Feather", _VIEWER, "tool-feather", "Soften the edge: pull the feather out of points", True
    ),
    ActionSpec(
        "tool.points", "Track points", _VIEWER, "tool-points", "Put points that a track follows, with the shapes", True
    ),
    ActionSpec("tool.adjust", "Adjust track", _VIEWER, "tool-adjust", "Pin the corners of a tracked surface", True),
    ActionSpec(
        "feather.reset", "Reset feather", _VIEWER, tip="Put the feather of the selected points back on the outline"
    ),
    ActionSpec(
        "feather.all_keys", "Feather for all keys", _VIEWER, tip="Give the soft edge as it is here to every key"
    ),
    ActionSpec("points.delete", "Delete", _VIEWER, tip="Delete the selected points or shapes"),
    ActionSpec("points.select_all", "Select all points", _VIEWER),
    ActionSpec("points.next", "Next point", _VIEWER),
    ActionSpec("points.previous", "Previous point", _VIEWER),
    ActionSpec("points.smooth", "Smooth points", _VIEWER),
    ActionSpec("points.cusp", "Cusp points", _VIEWER),
    ActionSpec("points.transform", "Transform by numbers…", _VIEWER, tip="Move, turn, scale and shear by numbers"),
    ActionSpec("points.mirror_across", "Mirror horizontally", _VIEWER, tip="Swap left and right of what is selected"),
    ActionSpec("points.mirror_down", "Mirror vertically", _VIEWER, tip="Swap top and bottom of what is selected"),
    ActionSpec("points.toggle_closed", "Open or close", _VIEWER),
    ActionSpec("shape.select_all", "Select all shapes", _VIEWER, tip="Select the shapes in sight that are not locked"),
    ActionSpec("shape.duplicate", "Duplicate", _VIEWER, "duplicate"),
    ActionSpec("shape.group", "Group into a layer", _VIEWER, "layer-add"),
    ActionSpec(
        "layer.ungroup", "Ungroup", _VIEWER, "layer-remove", "Dissolve the layer; its shapes stay as they are seen"
    ),
    ActionSpec("layer.add", "New layer", tip="Add an empty layer, to drop shapes on"),
    ActionSpec(
        "shape.match_edge", "Match the plate's edge", tip="Feather and shutter as the plate shows them, on all keys"
    ),
    ActionSpec("shape.delete", "Delete shape", icon="delete", tip="Delete the selected shapes and layers"),
    ActionSpec("shape.lock", "Lock or unlock", icon="lock"),
    ActionSpec("shape.hide", "Hide", _VIEWER, "eye-off"),
    ActionSpec("shape.show_all", "Show all", _VIEWER, "eye"),
    ActionSpec("points.soft", "Soft selection", _VIEWER, "", "Points near the selected ones follow them", True),
    ActionSpec("points.lasso", "Lasso selection", _VIEWER, "", "Drag a free line about points, not a rectangle", True),
    ActionSpec(
        "key.auto", "Auto-key", _VIEWER, "", "Edits make keys on their frames; off: they change keys around", True
    ),
    ActionSpec(
        "key.points", "Key points", _VIEWER, "", "Edits key the points that they move; a track derives the others", True
    ),
    ActionSpec(
        "key.set_points", "Set key for points", _VIEWER, tip="Make the selected points, as they are here, the artist's"
    ),
    ActionSpec("key.copy", "Copy key", _VIEWER, tip="Copy the selected shapes as they are on this frame"),
    ActionSpec("key.paste", "Paste key", _VIEWER, tip="Put the copied key on this frame"),
    ActionSpec("key.paste_range", "Paste key to range…", _VIEWER, tip="Hold the copied key through a range of frames"),
    ActionSpec("key.ripple", "Ripple edit", _VIEWER, "", "An edit changes all keys of the in/out range alike", True),
    ActionSpec("key.set", "Set key", _VIEWER, "key-set", "Make the selected shapes, as they are here, artist keys"),
    ActionSpec(
        "key.delete", "Delete key", _VIEWER, "key-delete", "Delete the keys of the selected shapes on this frame"
    ),
    ActionSpec("key.linear", "Linear", icon="key-linear", tip="Move on evenly from the chosen keys, or from this one"),
    ActionSpec("key.smooth", "Smooth", icon="key-smooth", tip="Begin and end softly after the chosen keys or this one"),
    ActionSpec("key.hold", "Hold", icon="key-hold", tip="Stand still after the chosen keys, or this one"),
    ActionSpec(
        "key.tangents", "Tangents", icon="key-tangents", tip="Bend opacity or feather smoothly through the chosen keys"
    ),
    ActionSpec("track.backward", "Track backward", icon="track-backward"),
    ActionSpec("track.backward_one", "Track one frame backward", icon="track-backward-one"),
    ActionSpec("track.stop", "Stop", icon="track-stop", tip="Stop; the frames that are finished stay"),
    ActionSpec("track.forward_one", "Track one frame forward", icon="track-forward-one"),
    ActionSpec("track.forward", "Track forward", icon="track-forward"),
    ActionSpec("track.to_next_key", "Track to the next key", icon="track-to-key"),
    ActionSpec(
        "track.fill", "Fill between keys", icon="track-fill", tip="Track the frames between two keys from both at once"
    ),
    ActionSpec(
        "track.next_doubtful", "Next doubtful frame", icon="doubtful-next", tip="Go to the next frame worth fixing"
    ),
    ActionSpec("track.previous_doubtful", "Previous doubtful frame", icon="doubtful-previous"),
    ActionSpec("track.most_doubtful", "Most doubtful frame", tip="Go to the frame that the engine trusts least"),
    ActionSpec("proposal.next", "Next proposal", tip="Go to the next frame on which the engine proposes a change"),
    ActionSpec("proposal.keep", "Keep", _VIEWER, tip="Make the change that the engine proposes here"),
    ActionSpec("proposal.refuse", "Refuse", _VIEWER, tip="Leave the shape as it is"),
    ActionSpec("proposal.keep_always", "Always", tip="Make this change, and every one proposed for this shape"),
    ActionSpec("proposal.refuse_always", "Never", tip="Refuse, and propose nothing more for this shape"),
    ActionSpec("proposal.ask_again", "Ask again", tip="Propose changes for the selected shapes again"),
    ActionSpec(
        "planar.backward", "Planar track backward", icon="planar-backward", tip="Follow the surface in the shapes back"
    ),
    ActionSpec("planar.forward", "Planar track forward", icon="planar-forward", tip="Follow the surface in the shapes"),
    ActionSpec("track.delete_engine_keys", "Delete tracked frames", tip="Delete every tracked frame; artist keys stay"),
    ActionSpec("object.one", "Solve as one object", _VIEWER, tip="Track the selected shapes as one whole object"),
    ActionSpec("object.parts", "Solve as parts", _VIEWER, tip="By outlines again: shapes that overlap are parts"),
    ActionSpec("object.apart", "Solve by itself", tip="Track each of the selected shapes with no other"),
    ActionSpec("object.attach", "Attach to neighbours", tip="Let parts hang by joints on those that they overlap"),
    ActionSpec("object.detach", "Detach", tip="Let parts move free of those that they overlap"),
    ActionSpec("object.in_front", "In front from here", tip="From this frame on the shapes hide the others"),
    ActionSpec("object.behind", "Behind from here", tip="From this frame on the others hide the shapes"),
    ActionSpec("object.as_stacked", "As stacked from here", tip="From this frame on what hides what goes by the list"),
    ActionSpec("view.source", "Source", _VIEWER, "view-source", "The plate alone", True),
    ActionSpec("view.overlay", "Overlay", _VIEWER, "view-overlay", "The plate with its shapes", True),
    ActionSpec("view.matte", "Matte", _VIEWER, "view-matte", "The matte of all visible shapes", True),
    ActionSpec("view.cutout", "Cut-out", _VIEWER, "view-cutout", "The plate inside of the matte, on a ground", True),
    ActionSpec("view.onion", "Onion skin", _VIEWER, "view-onion", "The outlines of frames before and after", True),
    ActionSpec(
        "view.confidence", "Confidence", _VIEWER, "view-confidence", "Where the engine trusts the outline", True
    ),
    ActionSpec("view.alpha", "Alpha alone", _VIEWER, "view-alpha", "The matte without its outlines, and back", True),
    ActionSpec("view.colour", "Colour", _VIEWER, tip="All channels", checkable=True),
    ActionSpec("view.red", "Red", _VIEWER, tip="The red channel alone, and back", checkable=True),
    ActionSpec("view.green", "Green", _VIEWER, tip="The green channel alone, and back", checkable=True),
    ActionSpec("view.blue", "Blue", _VIEWER, tip="The blue channel alone, and back", checkable=True),
    ActionSpec("view.luminance", "Luminance", _VIEWER, tip="Brightness alone, and back", checkable=True),
    ActionSpec("view.reset_look", "Reset exposure", _VIEWER, tip="Show the plate as it is: all channels, neutral"),
    ActionSpec(
        "view.wipe", "Compare", _VIEWER, "view-wipe", "Compare what is shown now with what will be: drag the line", True
    ),
    ActionSpec("view.pin", "Pin as A", _VIEWER, tip="Compare with what is shown now, in place of what was pinned"),
    ActionSpec("view.hide_overlays", "Hide shapes", _VIEWER, tip="Hide the shapes while you look", checkable=True),
    ActionSpec(
        "view.joints", "Show joints", _VIEWER, tip="Where parts hang together, on frames with keys", checkable=True
    ),
    ActionSpec(
        "view.edges",
        "Show edges",
        _VIEWER,
        tip="Free edges, which the picture shows, solid; seams of an object dashed; what a nearer part hides dotted",
        checkable=True,
    ),
    ActionSpec("view.fit", "Fit", _VIEWER, "view-fit"),
    ActionSpec("view.fit_selection", "Frame selection", _VIEWER),
    ActionSpec("view.actual_size", "100 %", _VIEWER),
    ActionSpec("view.fit_time", "Fit time", tip="Show the whole clip in the timeline"),
    ActionSpec("view.tall_timeline", "Tall timeline", tip="Give the timeline half of the window", checkable=True),
    ActionSpec("view.curves", "Curve editor", tip="Opacity, feather and position as curves over time", checkable=True),
    ActionSpec("view.shape_panel", "Shape panel", tip="Show all that the Shape panel has of the selected shapes"),
    ActionSpec("view.panels", "Panels", tip="Show or hide the panels on the right", checkable=True),
    ActionSpec("time.previous", "Previous frame"),
    ActionSpec("time.next", "Next frame"),
    ActionSpec("time.back_ten", "Ten frames back"),
    ActionSpec("time.on_ten", "Ten frames on"),
    ActionSpec("time.previous_key", "Previous key", icon="time-previous-key", tip=f"{_TO_KEYS} back"),
    ActionSpec("time.next_key", "Next key", icon="time-next-key", tip=f"{_TO_KEYS} on"),
    ActionSpec("time.first", "First frame", icon="time-first"),
    ActionSpec("time.last", "Last frame", icon="time-last"),
    ActionSpec("time.toggle_play", "Play or pause"),
    ActionSpec("time.play_back", "Play backward", icon="time-play-back", tip="Play backward; again: faster"),
    ActionSpec("time.pause", "Pause", icon="time-pause"),
    ActionSpec("time.play", "Play forward", icon="time-play", tip="Play forward; again: faster"),
    ActionSpec("time.play_slowly", "Play slowly", tip="Play forward at half speed; again: slower"),
    ActionSpec("time.play_back_slowly", "Play backward slowly", tip="Play backward at half speed; again: slower"),
    ActionSpec("time.loop", "Loop", icon="time-loop", tip="Begin again at the end of the range", checkable=True),
    ActionSpec("time.ping_pong", "Back and forth", icon="time-ping-pong", tip="Turn at both ends", checkable=True),
    ActionSpec("time.set_in", "Set in"),
    ActionSpec("time.set_out", "Set out"),
    ActionSpec("time.clear_range", "Clear in and out"),
    ActionSpec("mark.toggle", "Mark frame", icon="mark", tip="Mark this frame, or take its mark away"),
    ActionSpec("mark.name", "Name mark…", tip="Put a word on this frame's mark"),
    ActionSpec("time.previous_mark", "Previous mark"),
    ActionSpec("time.next_mark", "Next mark"),
    ActionSpec("edit.keymap", "Change keys…", tip="Keys of other programs, and keys of your own"),
    ActionSpec("edit.settings", "Settings…"),
    ActionSpec("help.palette", "Find an action…", tip="Do anything by a few letters of its name"),
    ActionSpec("help.keys", "Keys…", tip="Show every key, and find one"),
    ActionSpec("help.log", "Messages", tip="Show what was said, and when", checkable=True),
    ActionSpec("help.report", "Problem report…", tip="Versions, system and messages, to copy into an issue"),
    ActionSpec("help.about", "About ROAM…"),
)
