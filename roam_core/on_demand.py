"""Names that a package offers and loads when they are first asked for: who takes one does not wait for the others."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from typing import Any


def offered(
    package: str, rooms: Mapping[str, Iterable[str]], renamed: Mapping[str, tuple[str, str]] | None = None
) -> tuple[Callable[[str], Any], Callable[[], list[str]]]:
    """`__getattr__` and `__dir__` of a package, by which `from package import name` loads the name's module alone.

    Parameters
    ----------
    rooms : the names by their modules. renamed : names that are called otherwise in their module: (module, name there),
        or (module, "") for the module itself.
    """
    homes = {name: (room, name) for room, names in rooms.items() for name in names} | dict(renamed or {})

    def found(name: str) -> Any:
        if name not in homes:
            raise AttributeError(f"module {package!r} has no attribute {name!r}")
        room, own_name = homes[name]
        module = import_module(room)
        return getattr(module, own_name) if own_name else module

    def names() -> list[str]:
        return sorted({*vars(sys.modules[package]), *homes})

    return found, names
