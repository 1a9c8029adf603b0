"""The engine of ROAM: a pure library of values, curves and solvers. Never imports Qt.

What is listed here is the library's face: it stays under these names. Each name is loaded when it is first asked for,
so that a caller who only reads a project does not wait for the solver.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from roam_core.on_demand import offered

__version__ = "0.1.0"

if TYPE_CHECKING:
    from roam_core.cancel import Cancelled, CancelToken
    from roam_core.errors import RoamError
    from roam_core.interchange import ExportOptions, Imported, ImportOptions, KeyChoice, read_shapes, write_shapes
    from roam_core.interchange.protocol import LossyExport
    from roam_core.matte import read_mask, render_matte, shapes_from_mask
    from roam_core.media import MissingFrame, PlateSource, open_clip
    from roam_core.media.colour import to_engine
    from roam_core.params import RoamParams
    from roam_core.propagate import FrameResult, Termination, Tracker, TrackResult, fill_span, track
    from roam_core.proposal.mask_keys.keys import keys_from_mask
    from roam_core.roto import (
        BlendMode,
        Clip,
        Interpolation,
        Keyframe,
        Layer,
        Origin,
        Outline,
        Project,
        RotoShape,
        edit,
    )
    from roam_core.roto.file import load as load_project
    from roam_core.roto.file import save_checked as save_project

__all__ = [
    "BlendMode",
    "CancelToken",
    "Cancelled",
    "Clip",
    "ExportOptions",
    "FrameResult",
    "ImportOptions",
    "Imported",
    "Interpolation",
    "KeyChoice",
    "Keyframe",
    "Layer",
    "LossyExport",
    "MissingFrame",
    "Origin",
    "Outline",
    "PlateSource",
    "Project",
    "RoamError",
    "RoamParams",
    "RotoShape",
    "Termination",
    "TrackResult",
    "Tracker",
    "__version__",
    "edit",
    "fill_span",
    "keys_from_mask",
    "load_project",
    "open_clip",
    "read_mask",
    "read_shapes",
    "render_matte",
    "save_project",
    "shapes_from_mask",
    "to_engine",
    "track",
    "write_shapes",
]

_ROOMS = {
    "roam_core.cancel": ("CancelToken", "Cancelled"),
    "roam_core.errors": ("RoamError",),
    "roam_core.interchange": ("ExportOptions", "ImportOptions", "Imported", "KeyChoice", "read_shapes", "write_shapes"),
    "roam_core.interchange.protocol": ("LossyExport",),
    "roam_core.matte": ("read_mask", "render_matte", "shapes_from_mask"),
    "roam_core.media": ("MissingFrame", "PlateSource", "open_clip"),
    "roam_core.media.colour": ("to_engine",),
    "roam_core.params": ("RoamParams",),
    "roam_core.propagate": ("FrameResult", "Termination", "TrackResult", "Tracker", "fill_span", "track"),
    "roam_core.proposal.mask_keys.keys": ("keys_from_mask",),
    "roam_core.roto": (
        "BlendMode",
        "Clip",
        "Interpolation",
        "Keyframe",
        "Layer",
        "Origin",
        "Outline",
        "Project",
        "RotoShape",
    ),
}
_RENAMED = {
    "edit": ("roam_core.roto.edit", ""),
    "load_project": ("roam_core.roto.file", "load"),
    "save_project": ("roam_core.roto.file", "save_checked"),
}
__getattr__, __dir__ = offered(__name__, _ROOMS, _RENAMED)
