"""`roam review P.roam OUT`: a movie, pictures or a contact sheet of a shot; frames worth a look, as a list."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Mapping, Sequence

from roam_core.arrays import Array
from roam_core.cli.bar import progress_bar
from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes, with_only
from roam_core.cli.plate import loaded, opened
from roam_core.cli.spans import asked_frames
from roam_core.cli.stopping import cancelling
from roam_core.errors import RoamError
from roam_core.interchange.targets import Sources, require_free
from roam_core.review.findings import Finding, FindingKind, findings
from roam_core.review.frames import HINT, chosen_frames
from roam_core.review.look import Burn, Ground, ReviewLook, ReviewView
from roam_core.review.picture_boil import boil_by_picture
from roam_core.review.sheet import SheetLayout
from roam_core.review.writing import ReviewRequest, output_of, write_review
from roam_core.roto import Mark, Project

NOTHING_BURNT = "none"


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument(
        "out",
        type=path_word,
        nargs="?",
        metavar="OUT",
        help="a movie (.mp4, .mov, .avi), a folder for PNGs, a sheet's .png",
    )
    parser.add_argument("--sheet", action="store_true", help="write a contact sheet, pages of small pictures, as PNG")
    parser.add_argument("--list", action="store_true", help="print notes, and frames that are doubtful or boil")
    parser.add_argument("--json", action="store_true", help="print the list as one line of JSON for each entry")
    parser.add_argument(
        "--by-picture",
        action="store_true",
        help="measure the boil of the list by the motion of the plate: slower, and better where shapes bend",
    )
    parser.add_argument("--frames", metavar="WHICH", help=f"{HINT} (default: all; of a sheet x10)")
    parser.add_argument("--start", type=int, metavar="F", help="first frame (default: the clip's first)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame (default: the clip's last)")
    parser.add_argument(
        "--view",
        choices=[view.value for view in ReviewView],
        default=ReviewView.OVERLAY,
        help="outlines on the plate, or a cut-out",
    )
    parser.add_argument(
        "--ground", choices=[ground.value for ground in Ground], default=Ground.GREY, help="what a cut-out lies on"
    )
    parser.add_argument(
        "--burn",
        default="frame,note",
        metavar="WHAT",
        help="what is written on pictures: frame, note, confidence, with commas between them, or none "
        "(default: frame,note)",
    )
    parser.add_argument("--scale", type=float, default=1.0, metavar="S", help="of pictures to the plate (default: 1)")
    parser.add_argument("--fps", type=float, metavar="N", help="frames a second of a movie (default: the clip's)")
    parser.add_argument("--columns", type=int, default=SheetLayout.columns, metavar="N", help="of a contact sheet")
    parser.add_argument("--rows", type=int, default=SheetLayout.rows, metavar="N", help="of a contact sheet")
    parser.add_argument(
        "--width", type=int, default=SheetLayout.width, metavar="PX", help="of a page of a contact sheet"
    )
    parser.add_argument("--font", default="", metavar="NAME", help="name or file of the font of what is written")
    add_shapes(parser, "write only this shape, or these")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    if arguments.out is None and not (arguments.list or arguments.json):
        raise RoamError("Say where to write, such as out.mp4 or a folder, or ask for the --list.")
    project = with_only(loaded(arguments.project), arguments.shape)
    within = asked_frames(project.require_clip(), arguments.start, arguments.end)
    if arguments.list or arguments.json:
        measured = _measured(project) if arguments.by_picture else None
        _print_list(project, within, measured, as_json=arguments.json)
    if arguments.out is not None:
        print(_write(arguments, project, within), file=sys.stderr)
    return 0


def _write(arguments: argparse.Namespace, project: Project, within: range) -> str:
    """Write the movie, the pictures or the sheet; the sentence that says so."""
    words = arguments.frames or ("x10" if arguments.sheet else "all")
    request = ReviewRequest(
        project,
        chosen_frames(project, words, within),
        output_of(arguments.out, is_sheet=arguments.sheet),
        arguments.out,
        ReviewLook(
            ReviewView(arguments.view),
            Ground(arguments.ground),
            burns_of(arguments.burn),
            arguments.scale,
            arguments.font,
        ),
        SheetLayout(arguments.columns, arguments.rows, arguments.width),
        arguments.fps,
    )
    clip = project.require_clip()
    with opened(str(clip.path), clip) as plate:
        sources = Sources.of(plate.source, arguments.project)
        require_free(request.targets(), sources, overwrite=arguments.overwrite)
        with cancelling() as token, progress_bar() as progress:
            return write_review(request, plate.read, token, progress)


def burns_of(words: str) -> frozenset[Burn]:
    """What `--burn` names.

    Raises `RoamError` for a word that means nothing.
    """
    named = [word.strip() for word in words.split(",")]
    if named == [NOTHING_BURNT]:
        return frozenset()
    for word in named:
        if word not in set(Burn):
            raise RoamError(f"{word!r} cannot be written on a picture; say {', '.join(Burn)} or {NOTHING_BURNT}.")
    return frozenset(Burn(word) for word in named)


def _measured(project: Project) -> Mapping[str, Array]:
    """The boil of all shapes by the picture."""
    clip = project.require_clip()
    with opened(str(clip.path), clip) as plate, cancelling() as token, progress_bar() as progress:
        return boil_by_picture(plate.read_or_bridge, project.shapes, token, progress)


def _print_list(project: Project, within: range, measured: Mapping[str, Array] | None, *, as_json: bool) -> None:
    """Notes, doubts and boil in the order of time."""
    found: list[tuple[int, Mark | Finding]] = [(mark.frame, mark) for mark in project.marks]
    found += [(each.frame, each) for each in findings(project, measured)]
    listed = [each for frame, each in sorted(found, key=lambda pair: pair[0]) if frame in within]
    if as_json:
        for each in listed:
            print_json(_note(each) if isinstance(each, Mark) else _finding(each))
        return
    for each in listed:
        said = note_sentence(each) if isinstance(each, Mark) else each.sentence
        print(f"{each.frame}  {said}")
    print(_counted(listed), file=sys.stderr)


def note_sentence(mark: Mark) -> str:
    """What is said of a mark: its note on one line."""
    return f"note: {' '.join(mark.text.split())}" if mark.text else "marked"


def _counted(listed: Sequence[Mark | Finding]) -> str:
    kinds = [each.kind for each in listed if isinstance(each, Finding)]
    doubts, boils = kinds.count(FindingKind.DOUBT), kinds.count(FindingKind.BOIL)
    return f"{len(listed) - len(kinds)} note(s), {doubts} doubtful, {boils} with boil."


def _note(mark: Mark) -> dict[str, object]:
    return {"kind": "note", "frame": mark.frame, "text": mark.text}


def _finding(found: Finding) -> dict[str, object]:
    measure = "confidence" if found.kind is FindingKind.DOUBT else "boil"
    return {"kind": found.kind.value, "frame": found.frame, "shape": found.name, measure: round(found.value, 3)}
