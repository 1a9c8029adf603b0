"""The engine of ROAM: a pure library of values, curves and solvers. Never imports Qt.

The doors of the library are loaded when they are first asked for, so that a caller who only reads a project does not
wait for the solver.
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from roam_core.errors import RoamError
    from roam_core.matte import render_matte, shapes_from_mask
    from roam_core.propagate import FrameResult, Termination, Tracker, TrackResult, fill_span, track
    from roam_core.proposal.keys import keys_from_mask
    from roam_core.roto import Keyframe, Project, RotoShape

__all__ = [
    "FrameResult",
    "Keyframe",
    "Project",
    "RoamError",
    "RotoShape",
    "Termination",
    "TrackResult",
    "Tracker",
    "fill_span",
    "keys_from_mask",
    "render_matte",
    "shapes_from_mask",
    "track",
]

_ROOMS = {
    "roam_core.errors": ("RoamError",),
    "roam_core.matte": ("render_matte", "shapes_from_mask"),
    "roam_core.propagate": ("FrameResult", "Termination", "TrackResult", "Tracker", "fill_span", "track"),
    "roam_core.proposal.keys": ("keys_from_mask",),
    "roam_core.roto": ("Keyframe", "Project", "RotoShape"),
}
_HOME = {name: room for room, names in _ROOMS.items() for name in names}


def __getattr__(name: str) -> Any:
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(_HOME[name]), name)
