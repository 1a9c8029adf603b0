"""The mattes that `track` and `fill` write beside a project: one PNG for each frame of the plate, named as that."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from pathlib import Path

from roam_core.cli.matte_options import require_no_picture
from roam_core.cli.plate import Plate
from roam_core.interchange.authorship import Kind
from roam_core.interchange.mattes.exporter import write_matte
from roam_core.roto import Project

MOST_NAMED = 12
"""Frames that a message names."""


def matte_targets(plate: Plate, frames: Iterable[int], folder: Path | None) -> list[tuple[Path, Kind]]:
    """The mattes of a plate's frames. Refuses a folder that is named as pictures are."""
    if folder is None:
        return []
    require_no_picture(folder, "Mattes are named as the plate's frames.")
    there = set(plate.source.frames)
    return [(matte_path(plate, frame, folder), Kind.PICTURE) for frame in frames if frame in there]


def left_out(frames: Sequence[int]) -> str:
    """A sentence on the frames that get no matte, "" for none."""
    if not frames:
        return ""
    more = f" and {len(frames) - MOST_NAMED} more" if len(frames) > MOST_NAMED else ""
    named = ", ".join(map(str, frames[:MOST_NAMED]))
    return (
        f"The plate has no picture of frame(s) {named}{more}: no matte is written there; an export to mattes has them."
    )


def without_matte(plate: Plate, frames: Iterable[int], folder: Path | None) -> str:
    """A sentence on those of the `frames` that get no matte in a folder, as the plate lacks them; "" for none."""
    if folder is None:
        return ""
    there = set(plate.source.frames)
    return left_out([frame for frame in frames if frame not in there])


def matte_path(plate: Plate, frame: int, folder: Path) -> Path:
    """Where the matte of a frame goes: it has the frame's own name."""
    return folder / f"{plate.source.frame_name(frame)}.png"


def write_mattes(plate: Plate, project: Project, frames: Sequence[int], folder: Path) -> None:
    """One matte for each frame of the plate in `frames`, named as the plate's frames."""
    width, height = plate.source.size
    for frame in frames:
        if frame in plate.source.frames:
            write_matte(project.root, frame, matte_path(plate, frame, folder), (height, width))
