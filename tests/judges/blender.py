"""Blender itself as a judge: it runs the script and renders its mask or its group of nodes."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from roam_core.arrays import Float32
from tests.unit.interchange.blender_judge import command, rendered


def is_there() -> bool:
    """True where Blender can be run."""
    return command() is not None


def mattes(
    text: str, folder: Path, frames: Sequence[float], size: tuple[int, int], aspect: float = 1.0
) -> dict[float, Float32]:
    """The mattes `(h, w)` of a script at the frames; skips the test where there is no Blender."""
    return rendered(text, folder, (size[1], size[0]), aspect, frames).mattes
