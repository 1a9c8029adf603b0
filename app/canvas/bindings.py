"""A guard against a defect of the Qt bindings that would end the program within seconds on Python 3.11."""

from __future__ import annotations

import ctypes
import sys

SINGLETONS = (None, True, False, NotImplemented)
MANY = 1 << 40
"""More references than a lifetime of Qt calls can take away."""


def keep_singletons_alive() -> None:
    """Give Python's singletons more references than can be lost.

    PySide6 6.12.0 returns `None` from every void call, and `True` from every `Signal.emit` with arguments, without
    taking a reference. Since Python 3.12 these objects are immortal and that does no harm; on 3.11 each call takes a
    reference away that was not its own, and after some thousands the interpreter aborts with `none_dealloc` or
    `bool_dealloc`. Calling this again is harmless.
    """
    if sys.version_info >= (3, 12) or sys.implementation.name != "cpython":
        return
    for singleton in SINGLETONS:
        if sys.getrefcount(singleton) < MANY // 2:
            # The reference count is the first field of an object, at the address that CPython gives as its id.
            ctypes.c_ssize_t.from_address(id(singleton)).value += MANY
