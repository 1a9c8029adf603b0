"""Frames on which a shape exists: half-open ranges, whose ends may be open."""

from __future__ import annotations

from typing import Any

from roam_core.arguments import frame_number, shown

EVER = 10_000_000
"""Frame that stands for "always" at an open end of a lifetime; files for other programs can number it, offset too."""

LAST_FRAME = 999_999_999
"""The greatest number of a frame: those of files have up to nine digits."""


def lifetime_of(start: int | None, stop: int | None) -> tuple[int, int] | None:
    """The half-open frame range of a lifetime whose ends may be open, None; None where both are."""
    if start is None:
        return None if stop is None else (-EVER if stop > -EVER else stop - EVER, stop)
    if stop is None:
        stop = EVER if start < EVER else start + EVER
    return start, stop


def open_ends(lifetime: tuple[int, int]) -> tuple[int | None, int | None]:
    """What `lifetime_of` was given: None for an end that is open."""
    start, stop = lifetime
    since, until = lifetime_of(None, stop), lifetime_of(start, None)
    assert since is not None
    assert until is not None
    return None if start == since[0] else start, None if stop == until[1] else stop


def given_lifetime(pair: Any, name: str) -> tuple[int, int] | None:
    """What a shape was given as its lifetime, as two plain frame numbers; None for always.

    One that ends before it begins holds no frame.
    """
    try:
        start, stop = (None if end is None else frame_number(end) for end in pair)
    except (TypeError, ValueError):
        raise ValueError(
            f"the lifetime of {name!r} is a first frame and the frame after the last, not {shown(pair)}"
        ) from None
    lifetime = lifetime_of(start, stop)
    return None if lifetime is None else (lifetime[0], max(lifetime))
