"""Carrying shapes through a shot: one frame, many frames (`run`), between keys (`span`), the public `Tracker`."""

from roam_core.propagate.between.span import fill_span
from roam_core.propagate.frame.result import FrameResult, Landmarks, Termination, TrackResult
from roam_core.propagate.memory import TrackMemory
from roam_core.propagate.run import track
from roam_core.propagate.tracker import Tracker
from roam_core.propagate.warm_up import warm_up

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
]
