"""What of the parameters stands in the stamp of a tracked key: all, but of later ones only what was changed.

A stamp tells whether a key is still what the engine would make of it. A number that the engine had always had, before
it came into the parameters, may not make every older key stale: it is marked `later`, and says its value only where
that is not the default. One that was given another name is stamped by its `former` one. Whoever gives such a default
another value gives `provenance.REVISION` another number.
"""

from __future__ import annotations

from dataclasses import MISSING, field, fields, is_dataclass
from typing import Any, TypeVar

T = TypeVar("T")
LATER, FORMER = "stamped where it is changed", "stamped as"
"""In the metadata of a field."""


def later(default: T) -> T:
    """The default of a field, or a whole room, that a stamp tells only where it is changed."""
    return field(default=default, metadata={LATER: True})


def former(name: str, default: T) -> T:
    """The default of a field that a stamp tells by the name that it had before."""
    return field(default=default, metadata={FORMER: name})


def values(params: Any) -> dict[str, object]:
    """All fields of a dataclass of parameters by name, rooms as dictionaries, as a stamp tells them."""
    told: dict[str, object] = {}
    for each in fields(params):
        value = getattr(params, each.name)
        default = each.default if each.default is not MISSING else None
        if each.metadata.get(LATER) and value == default:
            continue
        told[each.metadata.get(FORMER, each.name)] = values(value) if is_dataclass(value) else value
    return told
