"""`roam export P.roam --to FORMAT OUT`: write a project's shapes for another program."""

from __future__ import annotations

import argparse
import sys
from collections import Counter
from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

from roam_core.cli.bar import progress_bar
from roam_core.cli.lines import print_json
from roam_core.cli.matte_options import add_matte_arguments, matte_options, matte_style
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes, with_only
from roam_core.cli.plate import loaded, tell
from roam_core.cli.stopping import cancelling
from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, exporter_for
from roam_core.interchange.matte_style import MATTES, SUFFIXES
from roam_core.interchange.naming import is_numbered
from roam_core.interchange.protocol import Exporter, LossyExport
from roam_core.interchange.svg.format import SvgFormat
from roam_core.interchange.targets import Sources, exported, require_free
from roam_core.translatable import Sentence

MOST_NAMES = 4
"""Of files that are told by name; more are counted."""
MOST_ALIKE = 12
"""Of notes that say the same of several shapes; more are counted, that other notes are not lost among them."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam", help="the project")
    parser.add_argument(
        "out",
        type=path_word,
        metavar="OUT",
        help="a file; for mattes, and svg of every frame, a pattern such as m.####.exr",
    )
    parser.add_argument("--to", required=True, metavar="FORMAT", help=" | ".join(EXPORTERS))
    parser.add_argument(
        "--keys",
        choices=[choice.value for choice in KeyChoice],
        default=KeyChoice.EVERY.value,
        help="every key, the artist's only, or as few as keep the outline within the tolerance",
    )
    parser.add_argument(
        "--tolerance", type=float, metavar="E", help=f"pixels, for reduced keys ({ExportOptions.tolerance:g})"
    )
    parser.add_argument(
        "--smooth",
        type=float,
        default=0.0,
        metavar="E",
        help="let tracked keys move by up to so many pixels, that shapes move evenly through time (none)",
    )
    parser.add_argument(
        "--frames", type=int, nargs=2, metavar=("FIRST", "LAST"), help="keys and pictures of these frames only (all)"
    )
    parser.add_argument("--frame-offset", type=int, default=0, metavar="N", help="added to every frame number")
    parser.add_argument("--frame", type=int, metavar="F", help="svg: the frame of the picture (the clip's first)")
    parser.add_argument(
        "--lossy", action="store_true", help="write even where the mattes would differ in the other program"
    )
    parser.add_argument("--json", action="store_true", help="print a line of JSON: the files, and what they leave out")
    add_shapes(parser, "write only this shape, or these")
    add_matte_arguments(parser)
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    exporter = exporter_for(arguments.to)
    require_suffix(exporter, arguments.out)
    require_one_drawing(exporter, arguments)
    project = with_only(loaded(arguments.project), arguments.shape)
    options = ExportOptions(
        frame_offset=arguments.frame_offset,
        keys=KeyChoice(arguments.keys),
        tolerance=ExportOptions.tolerance if arguments.tolerance is None else arguments.tolerance,
        smoothing=arguments.smooth,
        frames=None if arguments.frames is None else range(arguments.frames[0], arguments.frames[1] + 1),
        frame=arguments.frame,
        mattes=matte_style(arguments, arguments.out.name),
        lossy=arguments.lossy,
    )
    targets = exported(exporter, project, arguments.out, options)
    require_free(
        targets,
        Sources.of_clip(project.clip, arguments.project),
        overwrite=arguments.overwrite,
    )
    tell(without_effect(exporter, arguments))
    try:
        with cancelling() as token, progress_bar() as progress:
            notes = exporter.export(project, arguments.out, replace(options, progress=progress, token=token))
    except LossyExport as refusal:
        raise RoamError(f"{refusal} To write it all the same, say --lossy.") from None
    if not project.shapes:
        notes = (f"{arguments.project} holds no shape: what was written is empty.", *notes)
    notes = (*filter(None, [bare(exporter, [path for path, _ in targets])]), *notes)
    if arguments.json:
        files = [str(path) for path, _ in targets]
        print_json({"shapes": len(project.shapes), "files": files, "notes": list(notes)})
        return 0
    place = place_of(arguments.out, [path for path, _ in targets])
    print(f"Wrote {len(project.shapes)} shape(s) to {place}.", file=sys.stderr)
    for note in condensed(notes):
        print(note, file=sys.stderr)
    return 0


def condensed(notes: Sequence[str]) -> Iterator[str]:
    """The notes, of those that say the same of other shapes the first `MOST_ALIKE`, and how many there are more."""
    kinds = Counter(kind_of(note) for note in notes)
    told: Counter[str] = Counter()
    for note in notes:
        kind = kind_of(note)
        told[kind] += 1
        if told[kind] <= MOST_ALIKE:
            yield note
        if told[kind] == MOST_ALIKE and kinds[kind] > MOST_ALIKE:
            yield f"(and {kinds[kind] - MOST_ALIKE} more like this; --json lists all)"


def kind_of(note: str) -> str:
    """What a note says, whatever it says it of."""
    return note.template if isinstance(note, Sentence) else note


def without_effect(exporter: Exporter, arguments: argparse.Namespace) -> str:
    """That options were given which are for something else than what is written, in a sentence; "" for none."""
    idle = []
    if arguments.tolerance is not None and arguments.keys != KeyChoice.REDUCED:
        idle.append("--tolerance is for --keys reduced")
    if arguments.smooth and arguments.keys == KeyChoice.ARTIST:
        idle.append("--smooth is for tracked keys")
    if arguments.frame is not None and exporter.name != SvgFormat.name:
        idle.append(f"--frame is for {SvgFormat.name}")
    if exporter.name != MATTES and (given := matte_options(arguments)):
        idle.append(f"{', '.join(given)} {'is' if len(given) == 1 else 'are'} for {MATTES}")
    return f"Without effect here: {'; '.join(idle)}." if idle else ""


def place_of(out: Path, written: Sequence[Path]) -> str:
    """Where the files lie: what was asked for, their names, or of many how many there are, with the first and last."""
    if out.name in [path.name for path in written] or out.is_dir():
        return str(out)
    if len(written) <= MOST_NAMES:
        return ", ".join(path.name for path in written)
    return f"{len(written)} files, {written[0]} to {written[-1]}"


def require_one_drawing(exporter: Exporter, arguments: argparse.Namespace) -> None:
    """Refuse one frame for a pattern of names for every frame."""
    if arguments.frame is not None and exporter.name == SvgFormat.name and is_numbered(arguments.out.name):
        raise RoamError(
            f"{arguments.out.name} is a pattern for every frame, and --frame asks for one; "
            f"say --frames {arguments.frame} {arguments.frame}."
        )


def bare(exporter: Exporter, written: Sequence[Path]) -> str:
    """That programs may not know a file for its name has no suffix, in a sentence; "" where all have one."""
    found = next((path for path in written if not path.suffix), None)
    if found is None or exporter.name == MATTES:
        return ""
    return f"{found} has no suffix: other programs know such files by names that end in {exporter.suffix}."


def require_suffix(exporter: Exporter, path: Path) -> None:
    """Refuse a name that ends as another format of shapes does; an unknown suffix, or none, is the user's own."""
    suffix, is_mattes = path.suffix.lower(), exporter.name == MATTES
    others = {other.suffix for other in EXPORTERS.values() if other.name != MATTES}
    if suffix in others and suffix != exporter.suffix and not path.is_dir():
        fitting = " or ".join(sorted(SUFFIXES)) if is_mattes else exporter.suffix
        raise RoamError(
            f"{path.name} is the name of another format's files; those of {exporter.name} end in {fitting}."
        )
