"""`roam fill P.roam`: ENGINE keys on every frame between neighbouring artist keys, from both sides at once."""

from __future__ import annotations

import argparse
import sys
import time
from collections import Counter
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from tqdm import tqdm

from roam_core import propagate
from roam_core.cancel import CancelToken
from roam_core.cli.bar import bar
from roam_core.cli.configuring import configured
from roam_core.cli.keeping import Write, kept
from roam_core.cli.lines import print_json
from roam_core.cli.matte_files import matte_targets, without_matte, write_mattes
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.picking import EVERYTHING, Picking, trackable
from roam_core.cli.picking import add_arguments as add_picking
from roam_core.cli.plate import Plate, loaded, opened, tell
from roam_core.cli.spans import gaps_to_fill, is_filled, part_files, taken, within
from roam_core.cli.spreading import filled_apart
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target, require_writable
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind
from roam_core.interchange.targets import Sources, require_free
from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams
from roam_core.propagate import Termination
from roam_core.propagate.shapes.frame_confidence import whole_confidence
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.provenance import clip_stamp
from roam_core.propagate.shapes.taking_part import takes_part
from roam_core.roto import Origin, Project, RotoShape

FAILED = 1


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    parser.add_argument("--config", default=DEFAULT_CONFIG, help=f"{' | '.join(CONFIGS)} (default {DEFAULT_CONFIG})")
    add_picking(parser, "fill")
    parser.add_argument(
        "--span", type=int, nargs=2, metavar=("FIRST", "LAST"), help="fill only the gaps within these frames (all)"
    )
    parser.add_argument(
        "--take",
        type=path_word,
        action="append",
        metavar="PART",
        help="take keys that are what filling would make from this copy of P.roam, or from those of a folder",
    )
    parser.add_argument(
        "--workers", type=int, default=1, metavar="N", help="spread gaps and objects over processes of this machine (1)"
    )
    parser.add_argument("--matte", type=path_word, metavar="DIR", help="write 8-bit PNG mattes named as the frames")
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="write here (default: P.roam itself)")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a frame")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    params = configured(arguments.config)
    if arguments.workers < 1:
        raise RoamError("--workers has to be 1 or more.")
    target = arguments.project if arguments.save is None else arguments.save
    write = project_writer(target, arguments.project)
    project = loaded(arguments.project)
    picking = Picking(arguments.shape, arguments.alone)
    gaps = within(gaps_to_fill(project, arguments.project, picking), arguments.span)
    parts = [loaded(path) for path in part_files(arguments.take)]
    with opened(str(project.require_clip().path), project.clip) as plate:
        require_target(target)
        frames = range(gaps[0][0], max(last for _, last in gaps) + 1)
        require_free(
            [(target, Kind.PROJECT), *matte_targets(plate, frames, arguments.matte)],
            Sources.of(plate.source, arguments.project),
            overwrite=arguments.overwrite,
            rewritten=arguments.project,
        )
        tell(without_matte(plate, frames, arguments.matte))
        with claimed(target):
            if arguments.matte is not None:
                require_writable(arguments.matte, create=True)
            for part in parts:
                project = taken(project, part, gaps, params, picking)
            wanted = [gap for gap in gaps if not is_filled(project, gap, params, plate, picking)]
            there, missing, began = len(gaps) - len(wanted), wanted, time.perf_counter()
            if arguments.workers > 1 and wanted:
                project = filled_apart(project, wanted, params, picking, arguments.workers, write)
                parts.append(project)
                wanted = [gap for gap in gaps if not is_filled(project, gap, params, plate, picking)]
            apart = [gap for gap in missing if gap not in wanted]
            shares = seconds_by_frame(apart, time.perf_counter() - began)
            filled = fill_project(plate, project, wanted, params, write, picking)
            project = filled.project
            if not wanted and (target != arguments.project or parts):
                write(project)
            if arguments.matte is not None:
                failed = set(wanted) - set(filled.gaps)
                shown = [frame for frame in frames if not any(first < frame < last for first, last in failed)]
                write_mattes(plate, project, shown, arguments.matte)
    if arguments.json:
        found = (set(gaps) - set(wanted)) | set(filled.gaps)
        for frame in sorted({frame for first, last in found for frame in range(first, last + 1)}):
            print_json(line_of(project, frame, shares.get(frame, 0.0) + filled.seconds.get(frame, 0.0), picking))
    elif filled.gaps or not wanted:
        count = len(apart) + len(filled.gaps)
        print(f"Filled {count} gap(s)" + (f"; {there} already filled." if there else "."), file=sys.stderr)
    return FAILED if len(filled.gaps) < len(wanted) else 0


def seconds_by_frame(gaps: Sequence[Gap], seconds: float) -> dict[int, float]:
    """The time that gaps took together, by the clock, in equal shares for the frames within them; gaps may overlap."""
    inside = [frame for first, last in gaps for frame in range(first + 1, last)]
    return {frame: times * seconds / len(inside) for frame, times in Counter(inside).items()}


@dataclass(frozen=True)
class FilledProject:
    """A project with the `gaps` that could be filled, and the seconds that each of their frames took."""

    project: Project
    gaps: Sequence[Gap]
    seconds: Mapping[int, float]


def fill_project(
    plate: Plate,
    project: Project,
    gaps: Sequence[Gap],
    params: RoamParams,
    keep: Write,
    picking: Picking = EVERYTHING,
) -> FilledProject:
    """Fill the gaps one after the other. `keep` is given what is finished, as it goes and however it ends.

    A gap that cannot be filled is told on the standard error, and left out.
    """
    seconds: dict[int, float] = {}
    done: list[Gap] = []
    if gaps:
        propagate.warm_up(params.config)  # what solves is loaded here: a command's help must not wait for it
    with (
        cancelling() as token,
        kept(keep) as keeper,
        bar(sum(last - first for first, last in gaps), "{n:.0f}/{total} ") as shown,
    ):
        for gap in gaps:
            began = time.perf_counter()
            try:
                filled = _filled(plate, project, gap, params, picking, token, shown)
            except RoamError as error:
                tqdm.write(f"roam: The gap from frame {gap[0]} to {gap[1]} is not filled: {error}", file=sys.stderr)
                continue
            for shape in filled:
                project = project.with_shape(shape)
            keeper.offer(project)
            done.append(gap)
            shares = seconds_by_frame([gap], time.perf_counter() - began)
            seconds.update({frame: seconds.get(frame, 0.0) + share for frame, share in shares.items()})
        plate.require_read()
    return FilledProject(project, done, seconds)


def _filled(
    plate: Plate, project: Project, gap: Gap, params: RoamParams, picking: Picking, token: CancelToken, shown: Any
) -> list[RotoShape]:
    begun, length = shown.n, gap[1] - gap[0]

    def moved(fraction: float, _: str) -> None:
        shown.update(begun + fraction * length - shown.n)

    stamp = clip_stamp(project.clip)
    asked = {shape.id for shape in trackable(project, picking) if takes_part(shape, gap)}
    shapes = [shape for shape in project.shapes if shape.closed]
    filled = propagate.fill_span(
        plate.parts_or_bridge, shapes, *gap, params, token, moved, stamp, only=asked, alone=picking.alone
    )
    return [shape for shape in filled if shape.id in asked]


def line_of(project: Project, frame: int, seconds: float, picking: Picking) -> dict[str, object]:
    """What a line of JSON says of a frame: how long it took now, the confidence of what is picked, and any doubt."""
    alive = [shape for shape in trackable(project, picking) if shape.exists_at(frame)]
    keyed = [(shape, key) for shape in alive if (key := shape.key_at(frame))]
    if any(key.origin is Origin.ENGINE for _, key in keyed):
        rated = [(shape, 1.0 if key.origin is Origin.ARTIST else key.confidence or 0.0) for shape, key in keyed]
        confidence, _ = whole_confidence(rated, frame)
        termination = Termination.of(confidence)
    else:
        confidence = 1.0 if keyed or not alive else 0.0
        termination = Termination.ARTIST_KEY if keyed else Termination.MISSING_FRAME
        termination = termination if alive else Termination.OUTSIDE_LIFETIME
    return {
        "frame": frame,
        "seconds": round(seconds, 6),
        "confidence": round(confidence, 4),
        "termination": termination.value,
    }
