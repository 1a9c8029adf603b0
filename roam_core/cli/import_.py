"""`roam import FILE --into P.roam`: put the shapes of another program's file on top of those of a project."""

from __future__ import annotations

import argparse
import os
import sys
from pathlib import Path

from roam_core.cli.bar import progress_bar
from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.plate import loaded, opened
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target
from roam_core.errors import RoamError
from roam_core.interchange import ImportOptions, KeyChoice, MaskOptions, importer_for
from roam_core.interchange.authorship import Kind
from roam_core.interchange.reading import SPECK
from roam_core.interchange.targets import Sources, require_free
from roam_core.roto import Clip, Project, edit


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("source", type=path_word, metavar="FILE")
    parser.add_argument(
        "--into", type=path_word, required=True, metavar="P.roam", help="the project that gets the shapes"
    )
    parser.add_argument(
        "--clip", metavar="CLIP", help="the plate of the shapes, where P.roam is not there yet and is to be made for it"
    )
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="where to write it (default: P.roam itself)")
    parser.add_argument(
        "--frame-offset", type=int, default=0, metavar="N", help="what was added to the frame numbers on export"
    )
    parser.add_argument("--json", action="store_true", help="print a line of JSON: how many shapes, and what was lost")
    masks = parser.add_argument_group("masks", "for a folder of masks, or one picture of a numbered sequence")
    masks.add_argument(
        "--tolerance",
        type=float,
        default=MaskOptions.tolerance,
        metavar="PX",
        help="how far curves may stray from the masks' outline (%(default)g)",
    )
    masks.add_argument(
        "--keys",
        choices=[KeyChoice.EVERY.value, KeyChoice.REDUCED.value],
        default=MaskOptions.keys.value,
        help="a key on every frame, or as few as hold the tolerance (%(default)s)",
    )
    masks.add_argument(
        "--speckle",
        type=float,
        metavar="AREA",
        help=f"leave out what is smaller, in square pixels; 0 keeps all ({SPECK:g} for masks of 480 lines)",
    )
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    target = arguments.into if arguments.save is None else arguments.save
    importer = importer_for(arguments.source)
    write = project_writer(target, arguments.into)
    project = given_project(arguments.into, arguments.clip)
    require_target(target)
    require_free(
        [(target, Kind.PROJECT)],
        Sources.of_clip(project.clip, arguments.into, *read_files(arguments.source)),
        overwrite=arguments.overwrite,
        rewritten=arguments.into if arguments.clip is None else None,
    )
    masks = MaskOptions(arguments.tolerance, KeyChoice(arguments.keys), arguments.speckle)
    with claimed(target):
        with cancelling() as token, progress_bar() as progress:
            options = ImportOptions(arguments.frame_offset, masks=masks, progress=progress, token=token)
            imported = importer.read(arguments.source, project.require_clip(), options)
        count = sum(1 for _ in imported.layer.shapes())
        if not arguments.json or count == 0:  # why nothing could be read is told in any case
            for note in imported.notes:
                print(note, file=sys.stderr)
        if count == 0:
            raise RoamError(f"{arguments.source} holds no shape that ROAM can read; nothing was written.")
        project, _ = edit.add_items(project, imported.layer.children)
        write(project)
    if arguments.json:
        print_json({"shapes": count, "files": [str(target)], "notes": list(imported.notes)})
    else:
        print(f"Read {count} shape(s) from {arguments.source} into {target}.", file=sys.stderr)
    return 0


def given_project(path: Path, clip: str | None) -> Project:
    """The project at `path`; where none is there and a clip is named, an empty one for that."""
    if clip is None:
        if not os.path.lexists(path):
            raise RoamError(f"{path} does not exist; name its plate, by --clip, and a project is made for that.")
        return loaded(path)
    if path.is_dir():
        raise RoamError(f"{path} is a folder; name the project, a file whose name ends in .roam.")
    if path.exists():
        raise RoamError(
            f"{path} is there already and has a clip of its own; leave out --clip, or name another project."
        )
    with opened(clip) as plate:
        return Project(Clip.of(plate.source))


def read_files(source: Path) -> list[Path]:
    """The file of shapes, or the masks of a folder."""
    return list(source.iterdir()) if source.is_dir() else [source]
