"""What every action of the window is called, where its keys work and what it shows; by id."""

from __future__ import annotations

from ..translation import N_
from .file_specs import FILE
from .review_specs import REVIEW
from .spec import ActionSpec, Reach
from .view_specs import VIEWS

__all__ = ["SPECS", "ActionSpec", "Reach"]

_VIEWER = Reach.VIEWER
_FLOAT = N_("Take it out of the main window, to another monitor, or put it back")

SPECS: tuple[ActionSpec, ...] = (
    *FILE,
    ActionSpec("edit.undo", N_("Undo")),
    ActionSpec("edit.redo", N_("Redo")),
    ActionSpec("edit.history", N_("History"), tip=N_("Show every step and go back to any"), checkable=True),
    ActionSpec("edit.copy", N_("Copy"), _VIEWER, tip=N_("Copy the selected shapes")),
    ActionSpec("edit.cut", N_("Cut"), _VIEWER, tip=N_("Cut the selected shapes")),
    ActionSpec(
        "edit.paste", N_("Paste"), _VIEWER, tip=N_("Paste the copied shapes, also those copied in Nuke or Fusion")
    ),
    ActionSpec(
        "edit.paste_properties",
        N_("Paste all properties"),
        _VIEWER,
        tip=N_("Let what is selected look and count as what was copied; outlines, names and frames stay"),
    ),
    ActionSpec(
        "edit.paste_matte_properties",
        N_("Paste matte properties"),
        _VIEWER,
        tip=N_("Let what is selected count in the matte as what was copied; outlines and colours stay"),
    ),
    ActionSpec(
        "edit.paste_colour",
        N_("Paste colour"),
        _VIEWER,
        tip=N_("The outline colour of the copied shape, for the selected ones; mattes stay"),
    ),
    ActionSpec(
        "edit.copy_nuke", N_("Copy for Nuke"), tip=N_("The selected shapes, or all, as a node to paste into a script")
    ),
    ActionSpec(
        "edit.copy_fusion", N_("Copy for Fusion"), tip=N_("The selected shapes, or all, as nodes to paste into a flow")
    ),
    ActionSpec(
        "tool.select", N_("Select"), _VIEWER, "tool-select", N_("Select and drag shapes, points and handles"), True
    ),
    ActionSpec(
        "tool.transform",
        N_("Transform"),
        _VIEWER,
        "tool-transform",
        N_("Move, turn, scale and shear points or shapes"),
        True,
    ),
    ActionSpec(
        "tool.reshape", N_("Reshape"), _VIEWER, "tool-reshape", N_("Pull the points under a soft, round brush"), True
    ),
    ActionSpec(
        "tool.bezier", N_("Bezier"), _VIEWER, "tool-bezier", N_("Draw a Bezier shape: click corners, drag curves"), True
    ),
    ActionSpec(
        "tool.bspline", N_("B-spline"), _VIEWER, "tool-bspline", N_("Draw a smooth shape by its control points"), True
    ),
    ActionSpec("tool.polygon", N_("Polygon"), _VIEWER, "tool-polygon", N_("Draw a polygon"), True),
    ActionSpec(
        "tool.freehand", N_("Freehand"), _VIEWER, "tool-freehand", N_("Draw by hand; few points are fitted"), True
    ),
    ActionSpec(
        "tool.magnetic",
        N_("Magnetic lasso"),
        _VIEWER,
        "tool-magnetic",
        N_("Draw a line that clings to the edges"),
        True,
    ),
    ActionSpec(
        "tool.object", N_("Object"), _VIEWER, "tool-object", N_("Box or click an object: a shape is fitted to it"), True
    ),
    ActionSpec("shape.to_bezier", N_("Make Bezier"), tip=N_("Give the selected B-splines handles; no outline changes")),
    ActionSpec(
        "shape.to_bspline", N_("Make B-spline"), tip=N_("Give the selected shapes control points: smooth everywhere")
    ),
    ActionSpec("shape.from_mask", N_("From mask image…"), tip=N_("Fit shapes to a picture of this frame's mask")),
    ActionSpec(
        "tool.ellipse", N_("Ellipse"), _VIEWER, "tool-ellipse", N_("Span an ellipse; Shift makes it a circle"), True
    ),
    ActionSpec(
        "tool.rectangle",
        N_("Rectangle"),
        _VIEWER,
        "tool-rectangle",
        N_("Span a rectangle; Shift makes it a square"),
        True,
    ),
    ActionSpec(
        "tool.feather",
        N_("Feather"),
        _VIEWER,
        "tool-feather",
        N_("Soften the edge: pull the feather out of points"),
        True,
    ),
    ActionSpec(
        "tool.points",
        N_("Track points"),
        _VIEWER,
        "tool-points",
        N_("Put points that a track follows, with the shapes"),
        True,
    ),
    ActionSpec(
        "tool.adjust", N_("Adjust track"), _VIEWER, "tool-adjust", N_("Pin the corners of a tracked surface"), True
    ),
    ActionSpec(
        "feather.reset",
        N_("Reset feather"),
        _VIEWER,
        tip=N_("Put the feather of the selected points back on the outline"),
    ),
    ActionSpec(
        "feather.all_keys", N_("Feather for all keys"), _VIEWER, tip=N_("Give the soft edge as it is here to every key")
    ),
    ActionSpec("points.delete", N_("Delete"), _VIEWER, tip=N_("Delete the selected points or shapes")),
    ActionSpec("points.select_all", N_("Select all points"), _VIEWER),
    ActionSpec("points.next", N_("Next point"), _VIEWER),
    ActionSpec("points.previous", N_("Previous point"), _VIEWER),
    ActionSpec("points.smooth", N_("Smooth points"), _VIEWER),
    ActionSpec("points.cusp", N_("Cusp points"), _VIEWER),
    ActionSpec(
        "points.transform", N_("Transform by numbers…"), _VIEWER, tip=N_("Move, turn, scale and shear by numbers")
    ),
    ActionSpec(
        "points.mirror_across", N_("Mirror horizontally"), _VIEWER, tip=N_("Swap left and right of what is selected")
    ),
    ActionSpec(
        "points.mirror_down", N_("Mirror vertically"), _VIEWER, tip=N_("Swap top and bottom of what is selected")
    ),
    ActionSpec("points.toggle_closed", N_("Open or close"), _VIEWER),
    ActionSpec(
        "shape.reverse", N_("Reverse direction"), tip=N_("Let the selected shapes run the other way, on all keys")
    ),
    ActionSpec(
        "points.first", N_("Set as first point"), tip=N_("Let the shape begin with the selected point, on all keys")
    ),
    ActionSpec(
        "shape.select_all", N_("Select all shapes"), _VIEWER, tip=N_("Select the shapes in sight that are not locked")
    ),
    ActionSpec("shape.select_none", N_("Select nothing"), _VIEWER, tip=N_("Let go of all shapes, points and layers")),
    ActionSpec("shape.find", N_("Find in the list"), tip=N_("List only the shapes and layers that are called so")),
    ActionSpec("shape.rename", N_("Rename"), tip=N_("Type another name, in the list")),
    ActionSpec("shape.duplicate", N_("Duplicate"), _VIEWER, "duplicate"),
    ActionSpec("shape.group", N_("Group into a layer"), _VIEWER, "layer-add"),
    ActionSpec(
        "layer.ungroup",
        N_("Ungroup"),
        _VIEWER,
        "layer-remove",
        N_("Dissolve the layer; its shapes stay as they are seen"),
    ),
    ActionSpec("layer.add", N_("New layer"), tip=N_("Add an empty layer, to drop shapes on")),
    ActionSpec("shape.raise", N_("Raise"), _VIEWER, tip=N_("One place higher in the list: over what lies above")),
    ActionSpec("shape.lower", N_("Lower"), _VIEWER, tip=N_("One place lower in the list: under what lies below")),
    ActionSpec(
        "shape.steady",
        N_("Steady the outline…"),
        tip=N_("Move tracked keys so that their outlines boil less"),
    ),
    ActionSpec(
        "shape.match_edge",
        N_("Match the plate's edge"),
        tip=N_("Feather and shutter as the plate shows them, on all keys"),
    ),
    ActionSpec("shape.delete", N_("Delete shape"), icon="delete", tip=N_("Delete the selected shapes and layers")),
    ActionSpec("shape.lock", N_("Lock or unlock"), icon="lock"),
    ActionSpec("shape.hide", N_("Hide"), _VIEWER, "eye-off"),
    ActionSpec(
        "shape.solo", N_("Solo"), _VIEWER, "solo", N_("Show the selected shapes and layers alone, and all again")
    ),
    ActionSpec("shape.show_all", N_("Show all"), _VIEWER, "eye"),
    ActionSpec("points.soft", N_("Soft selection"), _VIEWER, "", N_("Points near the selected ones follow them"), True),
    ActionSpec(
        "points.lasso", N_("Lasso selection"), _VIEWER, "", N_("Drag a free line about points, not a rectangle"), True
    ),
    ActionSpec(
        "key.auto",
        N_("Auto-key"),
        _VIEWER,
        "",
        N_("Edits make keys on their frames; off: they change keys around"),
        True,
    ),
    ActionSpec("key.points", N_("Key points"), _VIEWER, "", N_("An edit keys only the points that it moves"), True),
    ActionSpec("key.set_points", N_("Set key for points"), _VIEWER, tip=N_("Make the selected points yours here")),
    ActionSpec("key.copy", N_("Copy key"), _VIEWER, tip=N_("Copy the selected shapes as they are on this frame")),
    ActionSpec("key.paste", N_("Paste key"), _VIEWER, tip=N_("Put the copied key on this frame")),
    ActionSpec(
        "key.paste_range", N_("Paste key to range…"), _VIEWER, tip=N_("Hold the copied key through a range of frames")
    ),
    ActionSpec(
        "key.shift", N_("Shift in time…"), tip=N_("All keys and notes, or those of what is selected, later or earlier")
    ),
    ActionSpec(
        "key.stretch", N_("Stretch keys…"), tip=N_("Have the chosen keys lie between two frames, evenly spread")
    ),
    ActionSpec(
        "key.ripple", N_("Ripple edit"), _VIEWER, "", N_("An edit changes all keys of the in/out range alike"), True
    ),
    ActionSpec(
        "key.set", N_("Set key"), _VIEWER, "key-set", N_("Make the selected shapes, as they are here, artist keys")
    ),
    ActionSpec(
        "key.delete",
        N_("Delete key"),
        _VIEWER,
        "key-delete",
        N_("Delete the keys of the selected shapes on this frame"),
    ),
    ActionSpec(
        "key.linear", N_("Linear"), icon="key-linear", tip=N_("Move on evenly from the chosen keys, or from this one")
    ),
    ActionSpec(
        "key.smooth", N_("Smooth"), icon="key-smooth", tip=N_("Begin and end softly after the chosen keys or this one")
    ),
    ActionSpec("key.hold", N_("Hold"), icon="key-hold", tip=N_("Stand still after the chosen keys, or this one")),
    ActionSpec("key.tangents", N_("Tangents"), icon="key-tangents", tip=N_("Bend the chosen keys of values smoothly")),
    ActionSpec("track.backward", N_("Track backward"), icon="track-backward"),
    ActionSpec("track.backward_one", N_("Track one frame backward"), icon="track-backward-one"),
    ActionSpec("track.stop", N_("Stop"), icon="track-stop", tip=N_("Stop; the frames that are finished stay")),
    ActionSpec("track.forward_one", N_("Track one frame forward"), icon="track-forward-one"),
    ActionSpec("track.forward", N_("Track forward"), icon="track-forward"),
    ActionSpec("track.to_next_key", N_("Track to the next key"), icon="track-to-key"),
    ActionSpec(
        "track.fill",
        N_("Fill between keys"),
        icon="track-fill",
        tip=N_("Track the frames between two keys from both at once"),
    ),
    ActionSpec(
        "track.next_doubtful",
        N_("Next doubtful frame"),
        icon="doubtful-next",
        tip=N_("Go to the next frame worth fixing: where confidence is low, or the outline boils"),
    ),
    ActionSpec("track.previous_doubtful", N_("Previous doubtful frame"), icon="doubtful-previous"),
    ActionSpec(
        "track.most_doubtful", N_("Most doubtful frame"), tip=N_("Go to the frame that the engine trusts least")
    ),
    ActionSpec(
        "proposal.next", N_("Next proposal"), tip=N_("Go to the next frame on which the engine proposes a change")
    ),
    ActionSpec("proposal.keep", N_("Keep"), _VIEWER, tip=N_("Make the change that the engine proposes here")),
    ActionSpec("proposal.refuse", N_("Refuse"), _VIEWER, tip=N_("Leave the shape as it is")),
    ActionSpec("proposal.keep_always", N_("Always"), tip=N_("Make this change, and every one proposed for this shape")),
    ActionSpec("proposal.refuse_always", N_("Never"), tip=N_("Refuse, and propose nothing more for this shape")),
    ActionSpec("proposal.ask_again", N_("Ask again"), tip=N_("Propose changes for the selected shapes again")),
    ActionSpec(
        "planar.backward",
        N_("Planar track backward"),
        icon="planar-backward",
        tip=N_("Follow the surface in the shapes back"),
    ),
    ActionSpec(
        "planar.forward", N_("Planar track forward"), icon="planar-forward", tip=N_("Follow the surface in the shapes")
    ),
    ActionSpec(
        "track.delete_engine_keys",
        N_("Delete tracked frames"),
        tip=N_("All of them, or those between in and out; artist keys stay"),
    ),
    ActionSpec(
        "object.one", N_("Solve as one object"), _VIEWER, tip=N_("Track the selected shapes as one whole object")
    ),
    ActionSpec(
        "object.parts", N_("Solve as parts"), _VIEWER, tip=N_("By outlines again: shapes that overlap are parts")
    ),
    ActionSpec("object.apart", N_("Solve by itself"), tip=N_("Track each of the selected shapes with no other")),
    ActionSpec(
        "object.attach", N_("Attach to neighbours"), tip=N_("Let parts hang by joints on those that they overlap")
    ),
    ActionSpec("object.detach", N_("Detach"), tip=N_("Let parts move free of those that they overlap")),
    ActionSpec("object.in_front", N_("In front from here"), tip=N_("From this frame on the shapes hide the others")),
    ActionSpec("object.behind", N_("Behind from here"), tip=N_("From this frame on the others hide the shapes")),
    ActionSpec(
        "object.as_stacked", N_("As stacked from here"), tip=N_("From this frame on what hides what goes by the list")
    ),
    *VIEWS,
    ActionSpec("time.previous", N_("Previous frame")),
    ActionSpec("time.next", N_("Next frame")),
    ActionSpec("time.back_ten", N_("Ten frames back")),
    ActionSpec("time.on_ten", N_("Ten frames on")),
    ActionSpec(
        "time.previous_key",
        N_("Previous key"),
        icon="time-previous-key",
        tip=N_("Go one key, or change of depth, of the shapes in hand back"),
    ),
    ActionSpec(
        "time.next_key",
        N_("Next key"),
        icon="time-next-key",
        tip=N_("Go one key, or change of depth, of the shapes in hand on"),
    ),
    ActionSpec("time.first", N_("First frame"), icon="time-first"),
    ActionSpec("time.last", N_("Last frame"), icon="time-last"),
    ActionSpec("time.toggle_play", N_("Play or pause")),
    ActionSpec("time.play_back", N_("Play backward"), icon="time-play-back", tip=N_("Play backward; again: faster")),
    ActionSpec("time.pause", N_("Pause"), icon="time-pause"),
    ActionSpec("time.play", N_("Play forward"), icon="time-play", tip=N_("Play forward; again: faster")),
    ActionSpec("time.play_slowly", N_("Play slowly"), tip=N_("Play forward at half speed; again: slower")),
    ActionSpec(
        "time.play_back_slowly", N_("Play backward slowly"), tip=N_("Play backward at half speed; again: slower")
    ),
    ActionSpec(
        "time.loop", N_("Loop"), icon="time-loop", tip=N_("Begin again at the end of the range"), checkable=True
    ),
    ActionSpec(
        "time.ping_pong", N_("Back and forth"), icon="time-ping-pong", tip=N_("Turn at both ends"), checkable=True
    ),
    ActionSpec("time.set_in", N_("Set in")),
    ActionSpec("time.set_out", N_("Set out")),
    ActionSpec("time.clear_range", N_("Clear in and out")),
    *REVIEW,
    ActionSpec("edit.keymap", N_("Change keys…"), tip=N_("Keys of other programs, and keys of your own")),
    ActionSpec("edit.settings", N_("Settings…")),
    ActionSpec("help.palette", N_("Find an action…"), tip=N_("Do anything by a few letters of its name")),
    ActionSpec("help.keys", N_("Keys…"), tip=N_("Show every key, and find one")),
    ActionSpec("help.log", N_("Messages"), tip=N_("Show what was said, and when"), checkable=True),
    ActionSpec("help.report", N_("Problem report…"), tip=N_("Versions, system and messages, to copy into an issue")),
    ActionSpec("help.about", N_("About ROAM…")),
    ActionSpec("window.full_screen", N_("Full-screen viewer"), tip=N_("The picture alone; Esc leaves"), checkable=True),
    ActionSpec("window.second_viewer", N_("Second viewer"), tip=N_("Another view of the same frame"), checkable=True),
    ActionSpec("window.shapes", N_("Panel: Shapes"), tip=N_("Show or hide the list of shapes"), checkable=True),
    ActionSpec("window.track", N_("Panel: Track"), tip=N_("Show or hide the tracker"), checkable=True),
    ActionSpec("window.planar", N_("Panel: Planar track"), tip=N_("Show or hide the planar tracker"), checkable=True),
    ActionSpec(
        "window.shape", N_("Panel: Shape"), tip=N_("Show or hide what the selected shapes have"), checkable=True
    ),
    ActionSpec("window.timeline", N_("Timeline"), tip=N_("Show or hide it, also in full screen"), checkable=True),
    ActionSpec("window.float_shapes", N_("Float: Shapes"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_track", N_("Float: Track"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_planar", N_("Float: Planar track"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_shape", N_("Float: Shape"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_review", N_("Float: Review"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_history", N_("Float: History"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_log", N_("Float: Messages"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_curves", N_("Float: Curve editor"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_timeline", N_("Float: Timeline"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.float_second_viewer", N_("Float: Second viewer"), icon="float", tip=_FLOAT, checkable=True),
    ActionSpec("window.reset_layout", N_("Reset layout"), tip=N_("Every part in its place, as in a new window")),
)
