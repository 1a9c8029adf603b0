"""What a program that is tried out has around it: settings and journals of its own, and no screen."""

from __future__ import annotations

import os
from pathlib import Path

from tests.conftest import ROOT


def environment(folder: Path) -> dict[str, str]:
    """The environment of a process that keeps all that it keeps in `folder`."""
    own = {f"XDG_{kind}_HOME": str(folder / "state") for kind in ("STATE", "CONFIG")}
    return {**os.environ, **own, "QT_QPA_PLATFORM": "offscreen", "PYTHONPATH": str(ROOT)}
