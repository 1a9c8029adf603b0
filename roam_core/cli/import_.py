"""`roam import FILE --into P.roam`: put the shapes of another program's file on top of those of a project.

With `--clip` the project is made by it.
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from roam_core.cli.overwriting import add_overwrite, project_writer, tell_of_holder
from roam_core.cli.plate import loaded
from roam_core.cli.track import require_target
from roam_core.errors import RoamError
from roam_core.interchange import ImportOptions, KeyChoice, MaskOptions, importer_for
from roam_core.interchange.authorship import Kind
from roam_core.interchange.reading import SPECK
from roam_core.interchange.targets import Sources, require_free
from roam_core.media import open_clip
from roam_core.roto import Clip, Project, edit


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("source", type=Path, metavar="FILE")
    parser.add_argument("--into", type=Path, required=True, metavar="P.roam", help="the project that gets the shapes")
    parser.add_argument("--clip", metavar="CLIP", help="make P.roam, a new project on this clip, and put the shapes in")
    parser.add_argument("--save", type=Path, metavar="OUT.roam", help="where to write it (default: P.roam itself)")
    parser.add_argument(
        "--frame-offset", type=int, default=0, metavar="N", help="what was added to the frame numbers on export"
    )
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
    write = project_writer(target, None if arguments.clip is not None else arguments.into)
    is_new = arguments.clip is not None
    project = Project(Clip.of(open_clip(arguments.clip))) if is_new else loaded(arguments.into)
    require_target(target)
    require_free(
        [(target, Kind.PROJECT)],
        Sources.of_clip(project.clip, *([] if is_new else [arguments.into]), *read_files(arguments.source)),
        overwrite=arguments.overwrite,
        rewritten=None if is_new else arguments.into,
    )
    tell_of_holder(target)
    masks = MaskOptions(arguments.tolerance, KeyChoice(arguments.keys), arguments.speckle)
    options = ImportOptions(frame_offset=arguments.frame_offset, masks=masks)
    imported = importer.read(arguments.source, project.require_clip(), options)
    for note in imported.notes:
        print(note, file=sys.stderr)
    count = sum(1 for _ in imported.layer.shapes())
    if count == 0:
        raise RoamError(f"{arguments.source} holds no shape that ROAM can read; nothing was written.")
    project, _ = edit.add_items(project, imported.layer.children)
    write(project)
    print(f"Read {count} shape(s) from {arguments.source} into {target}.", file=sys.stderr)
    return 0


def read_files(source: Path) -> list[Path]:
    """The file of shapes, or the masks of a folder."""
    return list(source.iterdir()) if source.is_dir() else [source]
