"""Values between their keys, as judges reckon them."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any


def between(keys: Sequence[tuple[float, str, Any]], frame: float) -> Any:
    """What keys `(frame, how it goes on, value)` give at a frame: constant beyond, `hold`, `smooth` or straight."""
    index = max((k for k, (at, _, _) in enumerate(keys) if at <= frame), default=0)
    start, how, value = keys[index]
    if frame <= start or index == len(keys) - 1 or how == "hold":
        return value
    stop, _, following = keys[index + 1]
    share = (frame - start) / (stop - start)
    share = share * share * (3.0 - 2.0 * share) if how == "smooth" else share
    return (1.0 - share) * value + share * following
