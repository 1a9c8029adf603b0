"""Frames on which a shape exists: half-open ranges, whose ends may be open."""

from __future__ import annotations

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
