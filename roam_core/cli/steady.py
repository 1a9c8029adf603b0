"""`roam steady P.roam`: tracked and filled keys moved so that their outlines boil less."""

from __future__ import annotations

import argparse
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite
from roam_core.cli.paths import path_word
from roam_core.cli.picking import NothingToSolve, add_shapes
from roam_core.cli.plate_task import PlateTask
from roam_core.errors import RoamError
from roam_core.params.steadiness import RESIDUAL, STEADINESS
from roam_core.roto import Origin, RotoShape

if TYPE_CHECKING:
    from roam_core.propagate.steadiness.steadying import Steadied


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument(
        "--strength",
        type=float,
        default=STEADINESS.strength,
        metavar="S",
        help=f"from 0, nothing, to 1 (default: {STEADINESS.strength:g})",
    )
    add_shapes(parser, "steady only this shape, or these")
    parser.add_argument("--start", type=int, metavar="F", help="first frame (default: the first with a tracked key)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame (default: the last with a tracked key)")
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="write here (default: P.roam itself)")
    parser.add_argument("--json", action="store_true", help="print one line of JSON for each key that moved")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    from roam_core.propagate.steadiness.steadying import steadying, told  # SciPy: help must not wait for it

    strength = arguments.strength
    if not 0.0 <= strength <= 1.0:
        raise RoamError(f"--strength {strength:g} is not between 0 and 1.")
    task = PlateTask.of(arguments, "steady")
    frames = _frames(task.asked, arguments.start, arguments.end, arguments.project)
    found = task.change(
        lambda read, token, progress: steadying(
            read, task.asked, frames, strength, STEADINESS, RESIDUAL, token, progress
        ),
        lambda found: found.shapes,
    )
    if arguments.json:
        _print_lines(found)
    print(told(found), file=sys.stderr)
    return 0


def _frames(shapes: Sequence[RotoShape], start: int | None, end: int | None, path: Path) -> range:
    """The frames whose keys may move: those asked for, or all that have a tracked key."""
    tracked = tracked_frames(shapes, path)
    first, last = min(tracked) if start is None else start, max(tracked) if end is None else end
    if start is not None and end is not None and first > last:
        raise RoamError(f"--start {first} lies after --end {last}; give an earlier first frame.")
    if start is not None and start > max(tracked):
        raise RoamError(f"--start {start} lies after the last tracked key, which is on frame {max(tracked)}.")
    if end is not None and end < min(tracked):
        raise RoamError(f"--end {end} lies before the first tracked key, which is on frame {min(tracked)}.")
    if not any(first <= frame <= last for frame in tracked):
        raise RoamError(f"Frames {first} to {last} hold no tracked key; there are some from {min(tracked)} on.")
    return range(max(first, min(tracked)), min(last, max(tracked)) + 1)


def tracked_frames(shapes: Sequence[RotoShape], path: Path) -> list[int]:
    """The frames of the keys that may be steadied, some more than once; `NothingToSolve` where there is none."""
    tracked = [key.frame for shape in shapes for key in shape.keys if key.origin is Origin.ENGINE]
    if not tracked:
        raise NothingToSolve(f"{path} has no tracked or filled key to steady; track or fill its shapes first.")
    return tracked


def _print_lines(found: Steadied) -> None:
    """One line for each key that moved; null where its boil is not known."""
    names = {shape.id: shape.name for shape in found.shapes}
    for (shape, frame), moved in found.moved.items():
        before, after = found.boil.get((shape, frame), (None, None))
        print_json(
            {
                "shape": names[shape],
                "frame": frame,
                "moved": round(moved, 3),
                "boil_before": None if before is None else round(before, 3),
                "boil": None if after is None else round(after, 3),
            }
        )
