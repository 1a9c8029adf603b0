"""How ROAM is installed: what the packages beside the engine are called here, and whether the window can open.

In the repository the window is `app` and what is shipped beside the code is `resources`. A wheel holds them as
`roam_window` and `roam_core.resources`, for those two names would be in the way of other people's packages. The engine
needs `resources` for its demo, the program needs the window to open; both are found here, and nowhere else. A
stand-alone bundle (`bundle/`) holds the wheel's packages, an interpreter of its own, and the kernels compiled.
"""

from __future__ import annotations

import sys
from importlib import import_module
from importlib.resources import files
from importlib.resources.abc import Traversable
from importlib.util import find_spec
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from roam_core.errors import RoamError

if TYPE_CHECKING:
    from resources import demo as demo

IS_WHEEL = find_spec("roam_core.resources") is not None
"""False in a checkout, an editable install of it included."""
RESOURCES = "roam_core.resources" if IS_WHEEL else "resources"
WINDOW = "roam_window" if IS_WHEEL else "app"
BUNDLE = Path(str(sys._MEIPASS)) if hasattr(sys, "_MEIPASS") else None
"""The folder of the stand-alone bundle that this process runs from, as PyInstaller's loader tells it; else None."""
WINDOW_LIBRARIES = ("PySide6", "pyqtgraph")
"""What the extra `window` brings."""
WINDOW_MISSING = (
    'The window is not installed; install it with: python -m pip install "roam-roto[window]" '
    '(in a checkout of ROAM: ".[window]").'
)

STUDIO_LIBRARIES = ("distributed", "cryptography")
"""What processes of this machine ask for, of all that the extra `studio` brings."""
STUDIO_MISSING = (
    "{library} is not installed; what batches and farms need is installed with: python -m pip install "
    '"roam-roto[studio]" (in a checkout of ROAM: ".[studio]").'
)


def resource(*names: str) -> Traversable:
    """A file or folder that is shipped beside the code, such as `resource("icons", "eye.svg")`."""
    return files(RESOURCES).joinpath(*names)


def window_module(name: str) -> ModuleType | None:
    """The module `name` of the window, loaded; None where its libraries are not installed."""
    if any(find_spec(library) is None for library in WINDOW_LIBRARIES):
        return None
    return import_module(f"{WINDOW}.{name}")


def has_studio() -> bool:
    """Whether work can be spread over processes of this machine."""
    return all(find_spec(library) is not None for library in STUDIO_LIBRARIES)


def studio_module(name: str) -> Any:
    """A module of a library that the extra `studio` brings, loaded; a `RoamError` that tells where it is not installed.

    Without types: the libraries are optional.
    """
    library = name.partition(".")[0]
    if find_spec(library) is None:
        raise RoamError(STUDIO_MISSING.format(library=library))
    return import_module(name)


def __getattr__(name: str) -> Any:
    if name == "demo":  # loaded when it is asked for: it renders, and few callers need it
        return import_module(f"{RESOURCES}.demo")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
