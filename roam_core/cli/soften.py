"""`roam soften P.roam`: shapes as soft as the plate's edge, by motion blur and feather."""

from __future__ import annotations

import argparse
import sys

from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import add_shapes
from roam_core.cli.plate_task import PlateTask
from roam_core.matte.softening import softened, told
from roam_core.matte.softness import Softness
from roam_core.params.softness import SOFTNESS
from roam_core.roto import RotoShape

WAYS = {"both": (True, True), "motion-blur": (True, False), "feather": (False, True)}
"""What `--by` names: motion blur, feather."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument(
        "--by",
        choices=WAYS,
        default="both",
        help="what the softness becomes: motion blur, with feather for what the motion does not explain (default), "
        "or one of the two",
    )
    add_shapes(parser, "soften only this shape, or these")
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="write here (default: P.roam itself)")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a key: how wide its edge is")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    task = PlateTask.of(arguments, "soften")
    blur, feather = WAYS[arguments.by]

    found, soft = task.change(
        lambda read, token, progress: softened(
            read, task.asked, task.project.plate_root, SOFTNESS, token, progress, blur=blur, feather=feather
        ),
        lambda both: both[1],
    )
    if arguments.json:
        for shape in task.asked:
            _print_lines(shape, found)
    print(told(found, task.asked, soft), file=sys.stderr)
    return 0


def _print_lines(shape: RotoShape, found: Softness) -> None:
    """One line for each key that was looked at; null for a width that could not be read."""
    for frame in shape.frames:
        if (shape.id, frame) in found.total:
            width = found.typical([(shape.id, frame)])
            print_json(
                {
                    "shape": shape.name,
                    "frame": frame,
                    "width": None if width is None else round(width, 2),
                    "shutter": None if found.shutter is None else round(found.shutter, 3),
                }
            )
