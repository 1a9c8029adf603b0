"""Carrying shapes through a shot: one frame, many frames (`run`), between keys (`span`), the public `Tracker`.

Each name is loaded when it is first asked for: what reads the stamp of a key does not wait for the solver.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from roam_core.on_demand import offered

if TYPE_CHECKING:
    from roam_core.propagate.between.span import fill_span
    from roam_core.propagate.frame.result import FrameResult, Landmarks, Termination, TrackResult
    from roam_core.propagate.memory import TrackMemory
    from roam_core.propagate.run import track
    from roam_core.propagate.tracker import Tracker
    from roam_core.propagate.warming import warm_up, warm_up_parts

__all__ = [
    "FrameResult",
    "Landmarks",
    "Termination",
    "TrackMemory",
    "TrackResult",
    "Tracker",
    "fill_span",
    "track",
    "warm_up",
    "warm_up_parts",
]

_ROOMS = {
    "roam_core.propagate.between.span": ("fill_span",),
    "roam_core.propagate.frame.result": ("FrameResult", "Landmarks", "Termination", "TrackResult"),
    "roam_core.propagate.memory": ("TrackMemory",),
    "roam_core.propagate.run": ("track",),
    "roam_core.propagate.tracker": ("Tracker",),
    "roam_core.propagate.warming": ("warm_up", "warm_up_parts"),
}
__getattr__, __dir__ = offered(__name__, _ROOMS)
