"""What a number has to be beside like the present one: an odd side, 4 or 8 neighbours, a share of a whole."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass


@dataclass(frozen=True)
class Limit:
    """Of the numbers whose paths match `paths`: `holds` tells which ones do, `told` says so in words."""

    paths: re.Pattern[str]
    holds: Callable[[float], bool]
    told: str


LIMITS = (
    Limit(re.compile(r"window"), lambda number: number % 2 == 1, "an odd number, for a node may also stay"),
    Limit(re.compile(r"max_nodes"), lambda number: number >= 2, "2 or more, for an outline has edges"),
    Limit(re.compile(r"gradient_top"), lambda number: number <= 100, "a percentile, 100 at most"),
    Limit(re.compile(r"proposals\.neighbours"), lambda number: number in (4, 8), "4 or 8"),
    Limit(re.compile(r"(.*\.)?key_share"), lambda number: number <= 1, "a share, 1 at most"),
    Limit(
        re.compile(r"(.*\.)?(klt\.window|planar\.window(_closely)?)"),
        lambda number: number >= 3,
        "3 or more, for a corner is known by what surrounds it",
    ),
)
"""A number that breaks one of them makes no sense in any run."""


def broken(path: str, number: float) -> str | None:
    """What the number at a path has to be, where it is not; else None."""
    return next((limit.told for limit in LIMITS if limit.paths.fullmatch(path) and not limit.holds(number)), None)
