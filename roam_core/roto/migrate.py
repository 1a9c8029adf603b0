"""Steps that carry the plain dictionaries of an older project file to the present version, one version at a time."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

VERSION = 1
"""The version of `.roam` files that this program writes."""

STEPS: dict[int, Callable[[dict[str, Any]], dict[str, Any]]] = {}
"""`STEPS[v]` turns a document of version v into one of version v + 1."""


def migrate(document: dict[str, Any], version: int) -> dict[str, Any]:
    """`document` of `version` as one of `VERSION`."""
    for step in range(version, VERSION):
        document = STEPS[step](document)
    return document
