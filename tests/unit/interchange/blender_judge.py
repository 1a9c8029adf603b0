"""Blender itself as a judge: it runs an exported script and renders the mask that the script made.

Blender runs in a process of its own: this interpreter where the package `bpy` is installed, the one that the variable
ROAM_BLENDER_PYTHON names, or the program `blender`.
"""

from __future__ import annotations

import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Any

import OpenImageIO as oiio  # noqa: N813
import pytest

from roam_core.arrays import Float32

RENDER = Path(__file__).with_name("blender_render.py")


@dataclass(frozen=True)
class Rendered:
    """Mattes `(h, w)` by frame, and what Blender holds of each mask layer."""

    mattes: dict[float, Float32]
    layers: list[dict[str, Any]]


@cache
def command() -> tuple[str, ...] | None:
    """How a script is run by Blender here, or None."""
    if chosen := os.environ.get("ROAM_BLENDER_PYTHON"):
        return (chosen,)
    if importlib.util.find_spec("bpy") is not None:
        return (sys.executable,)
    if program := shutil.which("blender"):
        return (program, "--background", "--factory-startup", "--python-exit-code", "1", "--python")
    return None


def rendered(script: str, folder: Path, size: tuple[int, int], aspect: float, frames: Sequence[float]) -> Rendered:
    """Run the script and render the frames at `size` (width, height); skips where there is no Blender."""
    blender = command()
    if blender is None:
        pytest.skip("Blender is not installed (pip install roam-roto[blender], on Python 3.11)")
    path = folder / "masks.py"
    path.write_bytes(script.encode("ascii"))
    wanted = {"script": str(path), "out": str(folder), "size": size, "aspect": aspect, "frames": list(frames)}
    environment = os.environ | {"ROAM_WANTED": json.dumps(wanted)}
    done = subprocess.run(
        [*blender, str(RENDER)], env=environment, capture_output=True, text=True, timeout=300, check=False
    )
    assert done.returncode == 0, done.stdout + done.stderr
    mattes = {frame: oiio.ImageBuf(str(folder / f"{frame}.exr")).get_pixels()[..., 0] for frame in frames}
    return Rendered(mattes, json.loads((folder / "layers.json").read_text(encoding="utf-8")))
