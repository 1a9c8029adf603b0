"""Single numbers by their paths, `region.redetection.alike`: what there is, what it means, another value for one."""

from __future__ import annotations

import difflib
import math
import re
from collections.abc import Iterator, Sequence
from dataclasses import fields, is_dataclass, replace
from typing import Any, Literal, TypeVar, get_args, get_origin, get_type_hints

from roam_core.errors import RoamError
from roam_core.params.limits import broken

P = TypeVar("P")
MOST_TIMES = 100.0
"""How many times what the configuration says a number may be; that small a part of it, too, unless it may be zero."""
MAY_BE_ZERO = re.compile(
    r"weight|share|lambda_|adaptation|doubted|better|believed|momentum|strength|"
    r"\b(mu|l2_rest|held|diffusion|key_aged|joint|tie)$"
)
"""What is multiplied and nothing is divided by: it can be left out."""
CLOSE = 0.6
"""Likeness of two names from which one may have been meant for the other, in [0, 1]."""
NAMES = re.compile(r"(?:^|(?<=[.;:] )|(?<=\n))\s*((?:`?[a-z]\w*`?, )*`?[a-z]\w*`?) ?: ")
"""Where a docstring begins to describe one field or several."""


def leaves(params: Any, room: str = "") -> Iterator[tuple[str, Any]]:
    """Every number by its path with its value; a room that is not there is told as None. Names are no numbers."""
    for each in fields(params):
        if each.name == "config":
            continue
        value, path = getattr(params, each.name), f"{room}{each.name}"
        if is_dataclass(value):
            yield from leaves(value, f"{path}.")
        else:
            yield path, value


def meanings(kind: type) -> dict[str, str]:
    """What the docstring of a dataclass of parameters says of each field, by name."""
    text = (kind.__doc__ or "").partition("----------\n")[2]
    own = {each.name for each in fields(kind)}
    starts = [
        (found.start(1), found.end(), [name.strip("` ") for name in found[1].split(",")])
        for found in NAMES.finditer(text)
    ]
    starts = [start for start in starts if own.issuperset(start[2])]
    stops = [start for start, _, _ in starts[1:]] + [len(text)]
    told: dict[str, str] = {}
    for (_, begin, names), stop in zip(starts, stops, strict=True):
        told.update(dict.fromkeys(names, " ".join(text[begin:stop].split()).rstrip(".;")))
    return told


def meaning(params: Any, path: str) -> str:
    """What the number at a path means, in the words of its room's docstring; empty for a path that is not there."""
    *rooms, name = path.split(".")
    for room in rooms:
        params = getattr(params, room, None)
    return meanings(type(params)).get(name, "") if is_dataclass(params) else ""


def changed(params: P, path: str, text: str) -> P:
    """The parameters with the number at a path as `text` says it; raises `RoamError` where that makes no sense."""
    room, value = _room_of(params, path), _value(params, path, text)
    with_it: P = _with(params, room, path.rpartition(".")[2], value)
    return with_it


def no_such(params: Any, name: str, others: Sequence[str] = ()) -> str:
    """That there is no dial or parameter of this name, with the closest ones."""
    known = [*others, *(path for path, _ in leaves(params))]
    last = {path.rpartition(".")[2]: path for path in reversed(known)}
    close = difflib.get_close_matches(name, known, 3, CLOSE)
    close += [last[each] for each in difflib.get_close_matches(name.rpartition(".")[2], list(last), 3, CLOSE)]
    meant = list(dict.fromkeys(close))[:3]
    hint = f"the closest are {', '.join(meant)}." if meant else "`roam configs --params` lists them all."
    return f"There is no dial or parameter {name!r} in the configuration {params.config!r}; {hint}"


def _room_of(params: Any, path: str) -> tuple[str, ...]:
    """The names of the rooms on the way to a number."""
    *rooms, name = path.split(".")
    here = params
    for depth, room in enumerate(rooms, start=1):
        here = getattr(here, room) if is_dataclass(here) and room in _names(here) else MISSING
        if here is None:
            way = ".".join(rooms[:depth])
            raise RoamError(f"The configuration {params.config!r} has no {way}, so {path} cannot be changed in it.")
        if not is_dataclass(here):
            raise RoamError(no_such(params, path))
    if name not in _names(here) or name == "config":
        raise RoamError(no_such(params, path))
    return tuple(rooms)


MISSING = object()
"""What stands at a path that leads nowhere."""


def _names(params: Any) -> set[str]:
    return {each.name for each in fields(params)}


def _with(params: Any, rooms: Sequence[str], name: str, value: Any) -> Any:
    if not rooms:
        return replace(params, **{name: value})
    return replace(params, **{rooms[0]: _with(getattr(params, rooms[0]), rooms[1:], name, value)})


def _value(params: Any, path: str, text: str) -> Any:
    """What a text says, for the number at a path."""
    *rooms, name = path.split(".")
    here = params
    for room in rooms:
        here = getattr(here, room)
    now, kind = getattr(here, name), get_type_hints(type(here))[name]
    may_be_none = type(None) in get_args(kind)
    if may_be_none and text == "none":
        return None
    if get_origin(kind) is Literal:
        if text not in get_args(kind):
            raise RoamError(f"{path}={text} makes no sense; choose from {', '.join(get_args(kind))}.")
        return text
    if may_be_none or is_dataclass(now):
        way = "none, or a number in it by its own path" if may_be_none else "a number in it by its own path"
        raise RoamError(f"{path} is a room of numbers; give {way}, as in {_example(here, name)}.")
    if isinstance(now, tuple):
        words = text.split(",")
        if len(words) != len(now):
            raise RoamError(f"{path}={text} makes no sense; give {len(now)} numbers with commas between them.")
        return tuple(_number(path, word, each) for word, each in zip(words, now, strict=True))
    return _number(path, text, now)


def _example(here: Any, name: str) -> str:
    room = getattr(here, name)
    inner = next((path for path, _ in leaves(room)), "name") if is_dataclass(room) else "name"
    return f"{name}.{inner}=1"


def _number(path: str, text: str, now: float) -> float:
    """A number like the present one: whole where that is, on its side of zero, not beyond reason."""
    try:
        found: float = int(text) if isinstance(now, int) else float(text)
    except ValueError:
        found = math.nan
    most = MOST_TIMES * max(abs(now), 1.0)
    least = 0.0 if now == 0 or MAY_BE_ZERO.search(path) else now / MOST_TIMES
    if now < 0:
        least = -most
    elif isinstance(now, int) and now > 0:
        least = 1
    if not least <= found <= most:
        kind = "whole number" if isinstance(now, int) else "number"
        raise RoamError(f"{path}={text} makes no sense; give a {kind} from {least:g} to {most:g} (it is {now:g}).")
    told = broken(path, found)
    if told is not None:
        raise RoamError(f"{path}={text} makes no sense; give {told} (it is {now:g}).")
    return found
