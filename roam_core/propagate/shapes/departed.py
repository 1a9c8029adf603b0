"""Tracked keys whose stamps name a dial that is offered no more, or parameters that this program does not know."""

from __future__ import annotations

from collections.abc import Sequence

from roam_core.params import departed
from roam_core.propagate.shapes.provenance import Stamp, known_params
from roam_core.roto import Origin, RotoShape
from roam_core.roto.imported import is_import
from roam_core.translatable import enumerated, sentence

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
    stays = sentence(
        "with {names}, which turns a dial that is offered no more: they stay as they are", names=_listed(old)
    )
    stale = sentence("with {names}, which this program does not know: they count as stale", names=_listed(unknown))
    if not (old or unknown):
        return ""
    how = sentence("{stays}; and {stale}", stays=stays, stale=stale) if old and unknown else stays if old else stale
    return sentence("Keys were tracked {how}.", how=how)


def _listed(names: Sequence[str]) -> str:
    return enumerated([repr(name if len(name) <= 60 else f"{name[:57]}...") for name in names], NAMED) if names else ""
