"""Numbers of things in sentences."""

from __future__ import annotations


def counted(count: int, thing: str) -> str:
    """`1 shape`, `2 shapes`: how many there are of a thing."""
    return f"{count} {thing}" if count == 1 else f"{count} {thing}s"
