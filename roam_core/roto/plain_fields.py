"""Plain fields of shapes and layers: what each may hold, so that what an edit sets can be saved and opened again."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np

from roam_core.arguments import finite, frame_number, shown
from roam_core.roto.animated import Animatable, checked, value_keys
from roam_core.roto.motion_blur import MotionBlur


def plain(name: str, value: Any, owner: str) -> Any:
    """A value for the field `name` of the shape or layer that is called `owner`, as the field holds it.

    Fields that are not plain, such as keys, come back as they are.

    Raises
    ------
    ValueError
        when the field cannot have that value.
    """
    check = _CHECKS.get(name)
    return value if check is None else check(value, f"the {name} of {owner!r}")


def _flag(value: Any, what: str) -> bool:
    if not isinstance(value, bool | np.bool_ | int | np.integer) or value not in (0, 1):
        raise ValueError(f"{what} is True or False, not {shown(value)}")
    return bool(value)


def _text(value: Any, what: str) -> str:
    if not isinstance(value, str):
        raise ValueError(f"{what} is a text, not {shown(value)}")
    return value


def _word_or_none(value: Any, what: str) -> str:
    return "" if value is None else _text(value, what)


def _share(value: Any, what: str) -> Animatable:
    """Tangents may lead beyond between two keys: there the share is held (`animated.share_at`)."""
    share = checked(value, what)
    values = [key.value for key in value_keys(share)] if not isinstance(share, float) else [share]
    for number in values:
        if not 0.0 <= number <= 1.0:
            raise ValueError(f"{what} lies from 0 to 1; it cannot be {number:g}")
    return share


def _colour(value: Any, what: str) -> tuple[float, ...]:
    try:
        channels = tuple(finite(channel, what) for channel in value)
    except (TypeError, ValueError):
        channels = ()
    if len(channels) != 3:
        raise ValueError(f"{what} is red, green and blue, each from 0 to 1, not {shown(value)}")
    return channels


def _blur(value: Any, what: str) -> MotionBlur | None:
    if not isinstance(value, MotionBlur | None):
        raise ValueError(f"{what} is a MotionBlur, or None for none, not {shown(value)}")
    return value


def _levels(value: Any, what: str) -> tuple[tuple[int, int], ...]:
    try:
        return tuple(sorted((frame_number(frame), frame_number(level)) for frame, level in value))
    except (TypeError, ValueError):
        raise ValueError(f"{what} is pairs of a frame and a level, such as ((1001, 1),), not {shown(value)}") from None


_CHECKS: dict[str, Callable[[Any, str], Any]] = {
    **dict.fromkeys(("visible", "locked", "invert", "closed", "attached"), _flag),
    **dict.fromkeys(("id", "name"), _text),
    **dict.fromkeys(("link", "compound"), _word_or_none),
    "opacity": _share,
    "colour": _colour,
    "motion_blur": _blur,
    "depth": _levels,
}
