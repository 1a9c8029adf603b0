"""A guard against a defect of the Qt bindings that would end the program within seconds."""

from __future__ import annotations

import ctypes
import sys

MANY = 1 << 40
"""More references than a lifetime of Qt calls can take away."""


def keep_none_alive() -> None:
    """Give `None` more references than can be lost.

    PySide6 6.12.0 returns `None` from every void call without taking a reference to it. Since Python 3.12 `None` is
    immortal and that does no harm; on 3.11 each `painter.drawRect` takes a reference away that was not its own, and
    after a few thousand the interpreter aborts with `none_dealloc`. Calling this again is harmless.
    """
    if sys.version_info >= (3, 12) or sys.implementation.name != "cpython" or sys.getrefcount(None) > MANY // 2:
        return
    # The reference count is the first field of an object, at the address that CPython gives as its id.
    ctypes.c_ssize_t.from_address(id(None)).value += MANY
