"""A plate on disk, a project on it, and ROAM's program as a script that the other programs' Python can start."""

from __future__ import annotations

import importlib
import os
import stat
import sys
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.media import open_clip
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape, file
from tests.conftest import ROOT

SIZE = (160, 90)
SCRIPTS = ROOT / "resources" / "plugins"
pytestmark = pytest.mark.skipif(os.name == "nt", reason="ROAM's program is a shell script here")


@dataclass
class Desk:
    """A folder with a plate `plate.1001.png` ... and a project with one shape, and what ROAM's window was opened on."""

    folder: Path
    plate: Path
    project: Path
    program: Path
    opened: list[str]


def corners(left: float, top: float) -> np.ndarray[Any, np.dtype[np.float64]]:
    return polygon_points([(left, top), (left + 60, top), (left + 60, top + 40), (left, top + 40)])


@pytest.fixture
def desk(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Desk:
    plate = tmp_path / "plate"
    plate.mkdir()
    for frame in range(1001, 1006):
        cv2.imwrite(str(plate / f"plate.{frame}.png"), np.full((SIZE[1], SIZE[0], 3), 60, dtype=np.uint8))
    project = tmp_path / "work.roam"
    keys = (Keyframe(1001, corners(20, 20)), Keyframe(1005, corners(40, 30)))
    shape = RotoShape("shape-1", "Arm", keys)
    file.save(Project(Clip.of(open_clip(plate)), Layer("root", "Root", (shape,))), project)
    program = tmp_path / "roam"
    program.write_text(f'#!/bin/sh\nPYTHONPATH="{ROOT}" exec "{sys.executable}" -m roam_core "$@"\n', encoding="utf-8")
    program.chmod(program.stat().st_mode | stat.S_IXUSR)
    monkeypatch.setenv("ROAM_PROGRAM", str(program))
    return Desk(tmp_path, plate, project, program, [])


@pytest.fixture
def plugin(desk: Desk, monkeypatch: pytest.MonkeyPatch) -> Iterator[Callable[[str, str, dict[str, ModuleType]], Any]]:
    """Loads a script as another program does, which has modules of its own; ROAM's window is only remembered."""
    loaded: list[str] = []

    def load(program: str, name: str, theirs: dict[str, ModuleType]) -> Any:
        for each, module in theirs.items():
            monkeypatch.setitem(sys.modules, each, module)
        monkeypatch.syspath_prepend(str(SCRIPTS))
        monkeypatch.syspath_prepend(str(SCRIPTS / program))
        loaded.extend(("roam_bridge", name))
        module = importlib.import_module(name)
        bridge = importlib.import_module("roam_bridge")
        monkeypatch.setattr(bridge, "open_window", lambda path, chosen="": desk.opened.append(str(path)))
        return module

    yield load
    for name in loaded:
        sys.modules.pop(name, None)
