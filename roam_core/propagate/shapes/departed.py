"""Tracked keys whose stamps name a dial that is offered no more, or parameters that this program does not know."""

from __future__ import annotations

from collections.abc import Sequence

from roam_core.params import departed
from roam_core.propagate.shapes.provenance import Stamp, known_params
from roam_core.roto import Origin, RotoShape
from roam_core.roto.imported import is_import

NAMED = 3
"""Names that a sentence tells one by one."""


def departed_settings(shapes: Sequence[RotoShape]) -> str:
    """One sentence for all keys of all shapes that were tracked so, for who opens their project; mostly empty."""
    names = sorted(
        {
            Stamp.read(key.inputs).config
            for shape in shapes
            for key in shape.keys
            if key.origin is Origin.ENGINE and key.inputs and not is_import(key)
        }
    )
    unknown = [name for name in names if known_params(name) is None]
    old = [name for name in names if name not in unknown and departed(name)]
    told = []
    if old:
        told.append(f"with {_listed(old)}, which turns a dial that is offered no more: they stay as they are")
    if unknown:
        told.append(f"with {_listed(unknown)}, which this program does not know: they count as stale")
    return f"Keys were tracked {'; and '.join(told)}." if told else ""


def _listed(names: Sequence[str]) -> str:
    more = len(names) - NAMED
    told = [repr(name if len(name) <= 60 else f"{name[:57]}...") for name in names[:NAMED]]
    return ", ".join(told) + (f" and {more} more" if more > 0 else "")
