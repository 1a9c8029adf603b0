"""`roam track CLIP --init FILE`: carry shapes through a clip; mattes, a project and a line a frame come out."""

from __future__ import annotations

import argparse
import sys
from bisect import bisect
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext, suppress
from dataclasses import replace
from pathlib import Path
from typing import Any

from numpy.typing import NDArray
from tqdm import tqdm

from roam_core import propagate
from roam_core.bounded import require_regular
from roam_core.cli.configuring import configured
from roam_core.cli.joining import Joining
from roam_core.cli.keeping import Write, kept
from roam_core.cli.lines import print_json
from roam_core.cli.matte_files import matte_targets, without_matte, write_mattes
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.picking import EVERYTHING, NothingToSolve, Picking, trackable
from roam_core.cli.picking import add_arguments as add_picking
from roam_core.cli.plain_start import plain_start
from roam_core.cli.plate import Plate, add_reading, opened, tell
from roam_core.cli.shown_start import shown_start
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target, require_writable
from roam_core.errors import RoamError
from roam_core.interchange.authorship import Kind, is_project
from roam_core.interchange.nuke.landmarks import LandmarkPaths, write_landmarks
from roam_core.interchange.registry import holds_shapes, read_shapes
from roam_core.interchange.targets import PROJECT, Sources, require_free
from roam_core.matte.vectorise import (
    LEAST_AREA,
    coverage_of,
    is_in_colour,
    may_be_picture,
    read_mask,
    shapes_from_mask,
    specks_left_out,
)
from roam_core.media.numbering import split_number
from roam_core.media.unseen import unseen_of_mask
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.propagate import FrameResult, Termination
from roam_core.propagate.shapes.frame_confidence import whole_confidence
from roam_core.propagate.shapes.provenance import clip_stamp
from roam_core.roto import Clip, Layer, Project, RotoShape, edit, file

Report = Callable[[FrameResult], None]
MANY = 100
"""Shapes of one mask, beyond which it may be noise."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("clip", metavar="CLIP", help="folder of images, pattern (plate.%%04d.exr) or movie")
    parser.add_argument(
        "--init",
        type=path_word,
        required=True,
        metavar="FILE",
        help="mask of the start frame, a .roam project, or a file of shapes that `roam import` reads",
    )
    parser.add_argument("--config", default=DEFAULT_CONFIG, help=f"{' | '.join(CONFIGS)} (default {DEFAULT_CONFIG})")
    parser.add_argument(
        "--start",
        type=int,
        metavar="F",
        help="frame that FILE describes (default: its first key, of a mask the clip's first)",
    )
    parser.add_argument("--end", type=int, metavar="F", help="last frame to track (default: the last)")
    parser.add_argument("--backward", action="store_true", help="track to earlier frames, by default from the last")
    add_reading(parser)
    add_picking(parser, "track")
    parser.add_argument("--matte", type=path_word, metavar="DIR", help="write 8-bit PNG mattes named as the frames")
    parser.add_argument("--save", type=path_word, metavar="P.roam", help="write a project")
    parser.add_argument(
        "--landmarks", type=path_word, metavar="OUT.nk", help="write the landmarks as Nuke Tracker4 nodes"
    )
    parser.add_argument("--json", action="store_true", help="print one line of JSON a frame")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    # Everything that can be refused is refused before anything is written.
    configured(arguments.config)
    if arguments.landmarks is not None:
        require_landmarks(arguments.config, arguments.landmarks)
    init: Path = arguments.init
    write = None if arguments.save is None else project_writer(arguments.save, init)
    given = given_project(init)
    with opened(arguments.clip, given.clip if given else None, arguments.layer, arguments.colour) as plate:
        picking = Picking(arguments.shape, arguments.alone)
        if given is None and holds_shapes(init):
            given = imported_project(init, plate)
        start = arguments.start
        if start is None:
            start = first_key(init, given, picking, plate.source.frames, backward=arguments.backward)
        elif given is not None:
            start = shown_start(start, trackable(given, picking), plate, arguments.config, backward=arguments.backward)
        frames = frame_range(plate.source.frames, start, arguments.end, backward=arguments.backward)
        project = initial_project(init, given, plate, frames[0])
        if given is None and arguments.start is None:
            tell_of_number(init, plate.source.frames, frames[0])
        wanted = trackable(project, picking)  # refuses a name that no shape of the mask has
        joining = Joining.of(wanted, frames)
        tell(plain_start(plate.read(frames[0]), filter(joining.begins_with, wanted), frames[0]))
        if arguments.save is not None:
            require_target(arguments.save)
        rewritten = init if _is_project(init) else None
        require_free(
            results(arguments, plate, frames),
            Sources.of(plate.source, init),
            overwrite=arguments.overwrite,
            rewritten=rewritten,
        )
        missing = without_matte(plate, sorted(frames), arguments.matte)
        for sentence in (kept_nowhere(arguments), missing, *joining.told()):
            tell(sentence)
        if arguments.matte is not None:
            require_writable(arguments.matte, create=True)
        landmarks = LandmarkPaths()

        def report(solved: FrameResult) -> None:
            landmarks.add(solved)
            if arguments.json:
                print_line(solved)

        with (
            nullcontext() if arguments.save is None else claimed(arguments.save),
            landmarks_kept(landmarks, project.require_clip(), arguments.landmarks),
        ):
            track_project(
                plate,
                project,
                frames,
                arguments.config,
                picking,
                report=report,
                mattes=arguments.matte,
                keep=write,
            )
    if not arguments.json:
        count = sum(map(joining.is_taken, wanted))
        print(f"Tracked {count} shape(s) from frame {frames[0]} to {frames[-1]}.", file=sys.stderr)
    return 0


def kept_nowhere(arguments: argparse.Namespace) -> str:
    """That nothing of a run would be written or printed, in a sentence; "" where something is."""
    if arguments.json or any(each is not None for each in (arguments.save, arguments.matte, arguments.landmarks)):
        return ""
    return "Nothing of this run is kept: to keep it, name a project with --save, or a folder for mattes with --matte."


def results(arguments: argparse.Namespace, plate: Plate, frames: range) -> list[tuple[Path, Kind]]:
    """The files that a run will write, and what they will be."""
    made = matte_targets(plate, frames, arguments.matte)
    if arguments.save is not None:
        made.append((arguments.save, Kind.PROJECT))
    if arguments.landmarks is not None:
        made.append((arguments.landmarks, Kind.SHAPES))
    return made


def track_project(
    plate: Plate,
    project: Project,
    frames: range,
    config: str,
    picking: Picking = EVERYTHING,
    *,
    report: Report | None = None,
    mattes: Path | None = None,
    keep: Write | None = None,
) -> Project:
    """Track the closed, unlocked shapes of a project, or those picked, through `frames` of its plate.

    A shape whose keys all lie ahead joins on the first of them, unless that holds for all (`joining`).
    `report` is called with the first frame, as it was given, and with each solved one; `mattes` is a folder for a PNG
    of each frame, written as it is solved. `keep` is given what is finished, as the run goes and however it ends.
    """
    shapes = [shape for shape in project.shapes if shape.closed]
    wanted = trackable(project, picking)
    joining = Joining.of(wanted, frames)
    asked = {shape.id for shape in wanted if joining.is_taken(shape)}
    stamp = clip_stamp(project.clip)
    propagate.warm_up(config)  # what solves is loaded here: a command's help must not wait for it
    pictures = None if mattes is None else Mattes(plate, mattes)

    def finished(solved: FrameResult) -> None:
        nonlocal project
        solved = joining.joined(solved)
        project = with_results(project, solved)
        plate.ahead_of(solved.frame, frames)  # not before something was looked at of the first: the same is decoded
        keeper.offer(project)
        if pictures is not None:
            pictures.add(project, solved)
        if report is not None:
            report(solved)

    plate.parts(frames[0])  # where it cannot be read nothing begins
    quiet = not sys.stderr.isatty()
    with cancelling() as token, kept(keep) as keeper:
        keeper.offer(project)
        solved = propagate.track(
            plate.parts_or_bridge, shapes, frames, config, token, stamp, begun=finished, only=asked, alone=picking.alone
        )
        for result in tqdm(solved, total=len(frames) - 1, unit="frame", disable=quiet, leave=False):
            finished(result)
        if pictures is not None:
            pictures.finish(project)
        plate.require_read()
    return project


class Mattes:
    """The mattes of a run, each written when its frame is finished.

    A frame whose picture could not be read has one too; it waits for the next solved frame, which tells how the shapes
    pass it.
    """

    def __init__(self, plate: Plate, folder: Path) -> None:
        self._plate, self._folder = plate, folder
        self._waiting: list[int] = []

    def add(self, project: Project, solved: FrameResult) -> None:
        """Take up one more frame; `project` holds it."""
        self._waiting.append(solved.frame)
        if any(result.termination is not Termination.MISSING_FRAME for result in solved.results):
            self.finish(project)

    def finish(self, project: Project) -> None:
        """Write what waits."""
        write_mattes(self._plate, project, self._waiting, self._folder)
        self._waiting.clear()


@contextmanager
def landmarks_kept(paths: LandmarkPaths, clip: Clip, out: Path | None) -> Iterator[None]:
    """Write the landmarks to `out` when the block ends; those that there are where it ends early."""
    try:
        yield
    except BaseException:
        if out is not None and paths.shapes:
            with suppress(RoamError):  # none were found yet; what ended the run is told
                write_landmarks(paths, clip, out)
        raise
    if out is not None and paths.shapes:
        for note in write_landmarks(paths, clip, out):
            print(note, file=sys.stderr)


def with_results(project: Project, result: FrameResult) -> Project:
    """The project with the engine's shapes of one frame in place of what they were."""
    for each in result.results:
        project = project.with_shape(each.shape)
    return project


def frame_range(frames: tuple[int, ...], start: int | None, end: int | None, *, backward: bool = False) -> range:
    """The frames of a run, its first one first: from `start` to `end`, both inclusive, in the run's direction."""
    first, last = (frames[-1], frames[0]) if backward else (frames[0], frames[-1])
    first, last = first if start is None else start, last if end is None else end
    for name, frame in (("start", first), ("end", last)):
        if not frames[0] <= frame <= frames[-1]:
            raise RoamError(f"--{name} {frame} lies outside the clip's frames {frames[0]}-{frames[-1]}.")
    if first not in frames:
        before, after = frames[bisect(frames, first) - 1 :][:2]
        raise RoamError(
            f"--start {first} is missing from the clip; the nearest frames that it has are {before} and {after}."
        )
    if (last > first) if backward else (last < first):
        way = "backward" if backward else "forward"
        raise RoamError(f"--end {last} cannot be reached from --start {first} {way}.")
    return range(first, last - 1, -1) if backward else range(first, last + 1)


def given_project(init: Path) -> Project | None:
    """The project of a file that holds one, or None for another file."""
    if not init.exists():
        raise RoamError(
            f"{init} does not exist; --init wants a mask image of the start frame, a .roam project or a file of shapes."
        )
    if init.is_dir():
        raise RoamError(
            f"{init} is a folder; --init wants the mask of the start frame, a file. "
            "A sequence of masks becomes shapes by roam import."
        )
    require_regular(init)  # here: a pipe of this process is not there for the one that decodes
    if not _is_project(init):
        return None
    project = file.load(init)
    if not trackable(project):
        raise NothingToSolve(f"{init} holds no closed, unlocked shape to track.")
    return project


def _is_project(init: Path) -> bool:
    """By its name, or, as of an earlier version (`P.roam.1`), by its content."""
    return init.suffix.lower() == PROJECT or is_project(init)


def imported_project(init: Path, plate: Plate) -> Project:
    """A project of the shapes in another program's file; what is lost of them is told."""
    clip = Clip.of(plate.source)
    imported = read_shapes(init, clip)
    for note in imported.notes:
        print(note, file=sys.stderr)
    project, _ = edit.add_items(Project(clip), imported.layer.children)
    if not trackable(project):
        raise RoamError(f"{init} holds no closed, unlocked shape to track.")
    return project


def first_key(
    path: Path, project: Project | None, picking: Picking, frames: tuple[int, ...], *, backward: bool
) -> int | None:
    """Where a run begins that passes every key of the artist's: on the first one, or backward on the last one.

    Of those only that lie on `frames`, of which the clip has pictures; that others are passed over is told. None where
    there is no key.

    Raises
    ------
    RoamError
        when the clip has a picture of none of them.
    """
    shapes = [] if project is None else trackable(project, picking)
    keyed = sorted({frame for shape in shapes for frame in shape.artist_frames or shape.frames}, reverse=backward)
    if not keyed:
        return None
    shown = set(frames)
    start = next((frame for frame in keyed if frame in shown), None)
    if start is not None:
        if start != keyed[0]:
            tell(f"The run begins on frame {start}: the clip has no picture of frame {keyed[0]}, where a key lies.")
        return start
    if not frames[0] <= keyed[0] <= frames[-1]:
        raise RoamError(
            f"The keys of {path} begin on frame {keyed[0]}, outside the clip's frames {frames[0]}-{frames[-1]}; name "
            "another clip, or the frame to begin on with --start."
        )
    raise RoamError(
        f"The clip has no picture of frame {keyed[0]}, where the keys of {path} begin; set one where it has, or name "
        "the frame to begin on with --start."
    )


def initial_project(init: Path, given: Project | None, plate: Plate, start: int) -> Project:
    """The project to track: the given one on this clip, or one made of a mask of the start frame."""
    clip = Clip.of(plate.source)
    if given is not None:
        return replace(given, clip=replace(clip, extra=given.clip.extra if given.clip else {}))
    width, height = plate.source.size
    mask = read_mask(init, (height, width))
    if is_in_colour(mask):
        raise RoamError(
            f"{init} is a picture in colour, no mask; give the object's mask, white inside and black elsewhere."
        )
    shapes: list[RotoShape] = shapes_from_mask(mask, start)
    if not shapes:
        brightest = float(coverage_of(mask).max())
        reason = f" at half of white: its brightest value is {brightest:.1%} of it" if brightest > 0 else ""
        raise RoamError(f"The mask {init} is empty{reason}; paint the object white on frame {start}.")
    for sentence in _odd_about(mask, init, len(shapes)):
        print(sentence, file=sys.stderr)
    return Project(clip, Layer("root", "Root", tuple(shapes)))


def tell_of_number(mask: Path, frames: tuple[int, ...], start: int) -> None:
    """Say that a mask whose name bears the number of another of the clip's frames is taken for the first one."""
    before, number, _ = split_number(mask.stem) or ("", "", "")
    if number and int(number) in frames and int(number) != start and not before.lower().endswith("v"):
        print(
            f"The mask {mask} is taken for frame {start}; if it is of frame {number}, say --start {number}.",
            file=sys.stderr,
        )


def _odd_about(mask: NDArray[Any], init: Path, count: int) -> Iterator[str]:
    """What an artist should know of a mask that became `count` shapes."""
    if pages := unseen_of_mask(init):
        yield pages
    if may_be_picture(coverage_of(mask)):
        yield (
            f"Most of the mask {init} is neither black nor white. If it is a picture, stop (Ctrl+C) and give a mask, "
            "white inside."
        )
    left_out = specks_left_out(mask)
    if left_out:
        yield (
            f"{left_out} speck(s) or pinhole(s) of the mask {init} were left out, each below {LEAST_AREA:.0f} square "
            "pixels."
        )
    if count > MANY:
        yield (
            f"The mask {init} makes {count} shapes, and tracking so many takes long. If they are noise, stop (Ctrl+C) "
            "and clean the mask first."
        )


def require_landmarks(config: str, path: Path) -> None:
    """Refuse a file for landmarks that a run could not fill or write at its end."""
    if params_for(config).landmarks is None:
        able = " and ".join(name for name, params in CONFIGS.items() if params.landmarks is not None)
        raise RoamError(f"The configuration {config} has no landmarks to write; those of {able} do (--config).")
    if path.suffix.lower() != ".nk":
        raise RoamError(f"Landmarks are written as a Nuke script; {path.name} does not end in .nk.")
    require_target(path)


def print_line(solved: FrameResult) -> None:
    """One line of JSON: the frame's seconds by the clock, energy over all shapes, confidence, and what costs most.

    Shapes that do not exist on the frame say nothing of it, unless there are no others.
    """
    results = [each for each in solved.results if each.shape.exists_at(solved.frame)] or list(solved.results)
    confidence, worst = whole_confidence([(result.shape, result.confidence) for result in results], solved.frame)
    line = {
        "frame": solved.frame,
        "seconds": round(solved.seconds, 6),
        "energy": round(sum(result.energies.get("total", 0.0) for result in results), 6),
        "confidence": round(confidence, 4),
        "termination": results[worst].termination.value,
    }
    print_json(line)
