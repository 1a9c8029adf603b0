"""The gaps of a fill: which there are, which are filled, how they are divided, and keys that were made elsewhere."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from roam_core.cli.picking import EVERYTHING, NothingToSolve, Picking, trackable
from roam_core.cli.plate import Plate
from roam_core.errors import RoamError
from roam_core.params import RoamParams
from roam_core.propagate.between.frames_shown import is_gap_filled
from roam_core.propagate.shapes.gaps import Gap, gaps_of
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import takes_part
from roam_core.roto import Clip, Keyframe, Project

Piece = tuple[Gap, tuple[str, ...]]
"""A gap, and the ids of the shapes of one object that get keys there."""


def gaps_to_fill(project: Project, path: Path, picking: Picking = EVERYTHING) -> list[Gap]:
    """Every gap between neighbouring artist keys of a shape, in order; `NothingToSolve` where there is none."""
    if not trackable(project, picking):
        raise NothingToSolve(f"{path} holds no closed, unlocked shape to fill.")
    gaps = gaps_of(trackable(project, picking))
    if not gaps:
        raise NothingToSolve(
            f"{path} has no gap to fill: no shape has artist keys on two frames with others between them. "
            "Set a key on a later frame first."
        )
    return gaps


def within(gaps: Sequence[Gap], span: Sequence[int] | None) -> list[Gap]:
    """The gaps that lie between two frames, both inclusive; all for None."""
    if span is None:
        return list(gaps)
    first, last = span
    inside = [gap for gap in gaps if first <= gap[0] and gap[1] <= last]
    if not inside:
        known = ", ".join(f"{gap[0]}-{gap[1]}" for gap in gaps[:8])
        raise RoamError(f"--span {first} {last} holds no gap between artist keys; there are {known}.")
    return inside


def asked_frames(clip: Clip, start: int | None, end: int | None) -> range:
    """The frames of a clip from `--start` to `--end`, both inclusive; all for None, and a sentence for others."""
    first, last = clip.first if start is None else start, clip.last if end is None else end
    for name, frame in (("start", first), ("end", last)):
        if not clip.first <= frame <= clip.last:
            raise RoamError(f"--{name} {frame} lies outside the clip's frames {clip.first}-{clip.last}.")
    if last < first:
        raise RoamError(f"--end {last} comes before --start {first}.")
    return range(first, last + 1)


def part_files(given: Sequence[Path] | None) -> list[Path]:
    """The projects that `--take` names: files, and all projects of a folder, by name."""
    return [path for place in given or () for path in (sorted(place.glob("*.roam")) if place.is_dir() else [place])]


def taken(
    project: Project, part: Project, gaps: Sequence[Gap], params: RoamParams, picking: Picking = EVERYTHING
) -> Project:
    """The project with those ENGINE keys of `part` that filling the gaps of `project` would make, told by their stamps.

    Everything else of `part` is left alone: shapes that are not in the project, and keys of other settings.
    """
    stamps = Stamps.of(project.shapes, project.clip)
    filled = {shape.id: shape for shape in part.shapes}
    for shape in trackable(project, picking):
        other = filled.get(shape.id)
        if other is None or other.point_count != shape.point_count:
            continue
        keys: list[Keyframe] = []
        for gap in gaps:
            if takes_part(shape, gap):
                between = [key for key in other.keys if gap[0] < key.frame < gap[1]]
                keys += [key for key in between if stamps.is_filled(shape, key, gap, params, picking.alone)]
        if keys:
            project = project.with_shape(shape.with_keys(keys))  # as they are: they were settled when they were made
    return project


def pieces_of(project: Project, gaps: Sequence[Gap], picking: Picking = EVERYTHING) -> list[Piece]:
    """The gaps divided by objects: what can be filled apart, and comes out as if it had been filled in one run."""
    stamps, ids = Stamps.of(project.shapes, project.clip), [shape.id for shape in project.shapes]
    pieces: list[Piece] = []
    for gap in gaps:
        asked = [ids.index(shape.id) for shape in trackable(project, picking) if takes_part(shape, gap)]
        for members in sorted({stamps.filled_with(k, gap, picking.alone) for k in asked}):
            pieces.append((gap, tuple(ids[k] for k in members if k in asked)))
    return pieces


def is_filled(project: Project, gap: Gap, params: RoamParams, plate: Plate, picking: Picking = EVERYTHING) -> bool:
    """True when every frame in the gap that shows something holds a key that filling would only make again."""
    stamps = Stamps.of(project.shapes, project.clip)
    inside = [frame for frame in plate.source.frames if gap[0] < frame < gap[1]]
    shapes = trackable(project, picking)
    return is_gap_filled(plate.parts, shapes, gap, inside, stamps, params, alone=picking.alone)
