"""The actions of looking: views, channels, proxies, zoom, and which parts of the window are shown."""

from __future__ import annotations

from ..translation import N_
from .spec import ActionSpec, Reach

_VIEWER = Reach.VIEWER

VIEWS: tuple[ActionSpec, ...] = (
    ActionSpec("view.source", N_("Source"), _VIEWER, "view-source", N_("The plate alone"), True),
    ActionSpec("view.overlay", N_("Overlay"), _VIEWER, "view-overlay", N_("The plate with its shapes"), True),
    ActionSpec("view.matte", N_("Matte"), _VIEWER, "view-matte", N_("The matte of all visible shapes"), True),
    ActionSpec(
        "view.cutout", N_("Cut-out"), _VIEWER, "view-cutout", N_("The plate inside of the matte, on a ground"), True
    ),
    ActionSpec(
        "view.onion", N_("Onion skin"), _VIEWER, "view-onion", N_("The outlines of frames before and after"), True
    ),
    ActionSpec(
        "view.confidence", N_("Confidence"), _VIEWER, "view-confidence", N_("Where the engine trusts the outline"), True
    ),
    ActionSpec(
        "view.alpha", N_("Alpha alone"), _VIEWER, "view-alpha", N_("The matte without its outlines, and back"), True
    ),
    ActionSpec("view.colour", N_("Colour"), _VIEWER, tip=N_("All channels"), checkable=True),
    ActionSpec("view.red", N_("Red"), _VIEWER, tip=N_("The red channel alone, and back"), checkable=True),
    ActionSpec("view.green", N_("Green"), _VIEWER, tip=N_("The green channel alone, and back"), checkable=True),
    ActionSpec("view.blue", N_("Blue"), _VIEWER, tip=N_("The blue channel alone, and back"), checkable=True),
    ActionSpec("view.luminance", N_("Luminance"), _VIEWER, tip=N_("Brightness alone, and back"), checkable=True),
    ActionSpec(
        "view.reset_look", N_("Reset exposure"), _VIEWER, tip=N_("Show the plate as it is: all channels, neutral")
    ),
    ActionSpec(
        "view.wipe",
        N_("Compare"),
        _VIEWER,
        "view-wipe",
        N_("Compare what is shown now with what will be: drag the line"),
        True,
    ),
    ActionSpec(
        "view.pin", N_("Pin as A"), _VIEWER, tip=N_("Compare with what is shown now, in place of what was pinned")
    ),
    ActionSpec(
        "view.hide_overlays", N_("Hide shapes"), _VIEWER, tip=N_("Hide the shapes while you look"), checkable=True
    ),
    ActionSpec(
        "view.joints",
        N_("Show joints"),
        _VIEWER,
        tip=N_("Where parts hang together, on frames with keys"),
        checkable=True,
    ),
    ActionSpec(
        "view.edges",
        N_("Show edges"),
        _VIEWER,
        tip=N_(
            "Free edges, which the picture shows, solid; seams of an object dashed; what a nearer part hides dotted"
        ),
        checkable=True,
    ),
    ActionSpec(
        "view.stabilise",
        N_("Stabilise view"),
        _VIEWER,
        tip=N_("Let the view go along with what is selected: it stands still on the screen from frame to frame"),
        checkable=True,
    ),
    ActionSpec("view.magnifier", N_("Magnifier"), _VIEWER, tip=N_("A point that is dragged, enlarged"), checkable=True),
    ActionSpec("view.full", N_("Full resolution"), _VIEWER, tip=N_("Show every pixel of the plate"), checkable=True),
    ActionSpec(
        "view.half",
        N_("Proxy 1/2"),
        _VIEWER,
        tip=N_("Show the plate at half its size: plays sooner, changes no result"),
        checkable=True,
    ),
    ActionSpec(
        "view.quarter",
        N_("Proxy 1/4"),
        _VIEWER,
        tip=N_("Show the plate at a quarter of its size: plays sooner, changes no result"),
        checkable=True,
    ),
    ActionSpec("view.fit", N_("Fit"), _VIEWER, "view-fit"),
    ActionSpec("view.fit_selection", N_("Frame selection"), _VIEWER),
    ActionSpec("view.actual_size", N_("100 %"), _VIEWER),
    ActionSpec("view.zoom_in", N_("Zoom in"), _VIEWER, tip=N_("At the pointer, where it is over the viewer")),
    ActionSpec("view.zoom_out", N_("Zoom out"), _VIEWER, tip=N_("At the pointer, where it is over the viewer")),
    ActionSpec("view.fit_time", N_("Fit time"), tip=N_("Show the whole clip in the timeline")),
    ActionSpec("view.zoom_in_time", N_("Zoom time in"), tip=N_("Show fewer frames in the timeline")),
    ActionSpec("view.zoom_out_time", N_("Zoom time out"), tip=N_("Show more frames in the timeline")),
    ActionSpec(
        "view.tall_timeline", N_("Tall timeline"), tip=N_("Give the timeline half of the window"), checkable=True
    ),
    ActionSpec("view.curves", N_("Curve editor"), tip=N_("What is keyed, as curves over time"), checkable=True),
    ActionSpec(
        "view.shape_panel", N_("Shape panel"), tip=N_("Show all that the Shape panel has of the selected shapes")
    ),
    ActionSpec("view.next_part", N_("Next part"), tip=N_("Give the keyboard to the next part of the window")),
    ActionSpec("view.previous_part", N_("Previous part"), tip=N_("Give the keyboard to the part before")),
    ActionSpec("view.panels", N_("Panels"), tip=N_("Show or hide the panels on the right"), checkable=True),
)
