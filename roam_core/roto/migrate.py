"""Steps that carry the plain dictionaries of an older project file to the present version, one version at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from roam_core.roto.packing import listed_rows, packed_numbers

VERSION = 3
"""The version of `.roam` files that this program writes."""
UNION_SINCE = 3
"""The version from which on "add" is a union of soft edges, and what added before is "plus"."""


def migrate(document: dict[str, Any], version: int) -> dict[str, Any]:
    """`document` of `version` as one of `VERSION`."""
    for step in range(version, VERSION):
        document = STEPS[step](document)
    return document


def _pack_matrices(document: dict[str, Any]) -> dict[str, Any]:
    """1 to 2: the matrices of layers were rows of nine numbers; keys stood one by one, which they still may."""
    waiting = [document["root"]]
    while waiting:
        layer = waiting.pop()
        if layer.get("transform") is not None:
            rows = listed_rows(layer["transform"]["matrices"], 9).reshape(-1, 3, 3)
            layer["transform"]["matrices"] = packed_numbers(rows)
        waiting.extend(child for child in layer["children"] if child["type"] == "Layer")
    return document


def _sum_what_was_added(document: dict[str, Any]) -> dict[str, Any]:
    """2 to 3: "add" was the clamped sum, which is "plus" now, and layers were joined by it.

    What lies lowest in its layer joins with nothing, by either the same: it becomes what "add" is now.
    """
    waiting = [document["root"]]
    while waiting:
        for index, child in enumerate(waiting.pop()["children"]):
            if child["type"] == "Layer":
                waiting.append(child)
            if index > 0 and child.get("blend", "add") == "add":
                child["blend"] = "plus"
    return document


STEPS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {1: _pack_matrices, 2: _sum_what_was_added}
"""`STEPS[v]` turns a document of version v into one of version v + 1."""
