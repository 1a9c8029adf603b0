"""Names and ids that nothing bears yet; the same ones for the same work."""

from __future__ import annotations

import re
from collections.abc import Collection
from itertools import count


def counted_on(name: str, taken: Collection[str]) -> str:
    """The name itself where it is free; else with the next free number: `Arm` gives `Arm 1`, `Arm 1` gives `Arm 2`.

    Zeros before a number stay: `Take 019` gives `Take 020`.
    """
    if name not in taken:
        return name
    found = re.fullmatch(r"(.*) ([0-9]{1,9})", name, re.DOTALL)
    stem, last, width = (found[1], int(found[2]), len(found[2])) if found else (name, 0, 1)
    return next(each for number in count(last + 1) if (each := f"{stem} {number:0{width}}") not in taken)


def next_id(kind: str, taken: Collection[str]) -> str:
    """The next free id of a kind: `shape-1`, `layer-3`."""
    first = 1 + sum(each.startswith(f"{kind}-") for each in taken)
    return next(each for number in count(first) if (each := f"{kind}-{number}") not in taken)
