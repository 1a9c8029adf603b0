"""`roam shift P.roam`: everything so many frames later or earlier, or to the numbers that its plate's pictures have."""

from __future__ import annotations

import argparse
import sys
from dataclasses import replace
from pathlib import Path

from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes, with_only
from roam_core.cli.plate import loaded, require_plate
from roam_core.cli.targets import require_target
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind
from roam_core.interchange.targets import Sources, require_free
from roam_core.media import declared
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.restamping import renumbered
from roam_core.roto import Clip, Project
from roam_core.roto.relinking import is_renumbered, open_plate
from roam_core.roto.shifting import frames_held, shifted


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument(
        "--by", type=int, metavar="N", help="frames later, or below zero earlier (default: as the plate was renumbered)"
    )
    add_shapes(parser, "shift only this shape, or these, with --by")
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="write here (default: P.roam itself)")
    parser.add_argument(
        "--json", action="store_true", help="print a line of JSON: by how much, which frames, and what is out of date"
    )
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    source: Path = arguments.project
    target = source if arguments.save is None else arguments.save
    writer = project_writer(target, source)
    project = loaded(source)
    if not frames_held(project):
        raise RoamError(f"{source} has neither keys nor notes to shift.")
    if arguments.by is None:
        after = _renumbered(project, source, arguments.shape)
        by = after.require_clip().first - project.require_clip().first
    else:
        by = arguments.by
        after = shifted(project, by, _asked(project, arguments.shape))
    require_target(target)
    sources = Sources.of_clip(project.clip, source)
    require_free([(target, Kind.PROJECT)], sources, overwrite=arguments.overwrite, rewritten=source)
    with claimed(target):
        writer(after)
    was, now, more = frames_held(project), frames_held(after), max(_stale(after) - _stale(project), 0)
    if arguments.json:
        print_json({"by": by, "first": now[0], "last": now[-1], "out_of_date": more, "files": [str(target)]})
    told = f"Frames {was[0]} to {was[-1]} are {now[0]} to {now[-1]} now."
    print(f"{told} {more} tracked key(s) are out of date for it." if more else told, file=sys.stderr)
    return 0


def _renumbered(project: Project, path: Path, names: list[str] | None) -> Project:
    """The project on its plate's numbers, all of it."""
    if names:
        raise RoamError("With --shape say by how many frames: --by N. With its plate's numbers all of a project goes.")
    clip = project.require_clip()
    require_plate(clip)
    found = Clip.of(declared(open_plate(clip), clip.colour_space, clip.fps, clip.pixel_aspect))
    if not is_renumbered(clip, found):
        raise RoamError(
            f"The plate of {path} does not show the project's pictures under other numbers: it has {found.first} to "
            f"{found.last}, the project {clip.first} to {clip.last}. Say by how many frames: --by N."
        )
    return renumbered(replace(project, clip=replace(found, extra=clip.extra)), clip)


def _asked(project: Project, names: list[str] | None) -> list[str] | None:
    """The ids of the shapes of these names; None for everything, what is locked too."""
    if not names:
        return None
    asked = with_only(project, names).shapes
    for shape in asked:
        if project.is_locked(shape.id):
            raise RoamError(f"{shape.name!r} is locked; unlock it to shift it alone.")
    return [shape.id for shape in asked]


def _stale(project: Project) -> int:
    stamps = Stamps.of(project.shapes, project.clip)
    return sum(stamps.is_stale(shape, key) for shape in project.shapes for key in shape.keys)
