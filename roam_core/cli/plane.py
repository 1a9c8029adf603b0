"""`roam plane P.roam --shape NAME`: follow the surface under shapes; a layer around them takes its motion."""

from __future__ import annotations

import argparse
import sys
import time
from collections import deque
from collections.abc import Sequence
from functools import partial
from typing import TYPE_CHECKING

from roam_core.cancel import CancelToken
from roam_core.cli.bar import bar
from roam_core.cli.keeping import Keeper, kept
from roam_core.cli.lines import print_json
from roam_core.cli.overwriting import add_overwrite, claimed, project_writer
from roam_core.cli.paths import path_word
from roam_core.cli.picking import Picking, add_shapes, picked, trackable
from roam_core.cli.plate import Plate, loaded, opened
from roam_core.cli.shown_start import shown_start
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target
from roam_core.cli.track import first_key, frame_range
from roam_core.errors import RoamError
from roam_core.geometry.plane_motion import PlaneMotion
from roam_core.interchange.authorship import Kind
from roam_core.interchange.targets import Sources, require_free
from roam_core.params import is_doubtful
from roam_core.roto import Project, RotoShape
from roam_core.roto.following import followed, with_moving_layer
from roam_core.roto.surfaces import LeaveOut, adjusted_frames, covering, covers_at, legs_of, outlines_at

if TYPE_CHECKING:
    from roam_core.motion.plane_track import PlaneStep

WAYS = tuple(way.value for way in LeaveOut if way is not LeaveOut.CHOSEN)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Declare the command's options."""
    parser.add_argument("project", type=path_word, metavar="P.roam")
    add_shapes(parser, "a shape on the surface; default: all")
    parser.add_argument(
        "--motion",
        choices=[kind.value for kind in PlaneMotion],
        default=PlaneMotion.SIMILARITY.value,
        help="what the surface may do; the simplest that fits is the best (default similarity)",
    )
    add_shapes(parser, "a shape before the surface: what it covers is not looked at", "--exclude")
    parser.add_argument(
        "--leave-out",
        choices=WAYS,
        default=None,
        help="which shapes lie before the surface, in place of naming them (default: those above)",
    )
    parser.add_argument("--start", type=int, metavar="F", help="frame to begin on (default: the shapes' first key)")
    parser.add_argument("--end", type=int, metavar="F", help="last frame to track (default: the last)")
    parser.add_argument("--backward", action="store_true", help="track to earlier frames")
    parser.add_argument("--save", type=path_word, metavar="OUT.roam", help="write here (default: P.roam itself)")
    parser.add_argument("--json", action="store_true", help="print one line of JSON a frame")
    add_overwrite(parser)


def run(arguments: argparse.Namespace) -> int:
    """Carry out the command."""
    target = arguments.project if arguments.save is None else arguments.save
    write = project_writer(target, arguments.project)
    project = loaded(arguments.project)
    picking = Picking(arguments.shape)
    shapes, covers = surface_of(project, arguments)
    with opened(str(project.require_clip().path), project.clip) as plate:
        first = arguments.start
        if first is None:
            first = first_key(arguments.project, project, picking, plate.source.frames, backward=arguments.backward)
        else:
            first = shown_start(first, shapes, plate, backward=arguments.backward)
        frames = frame_range(plate.source.frames, first, arguments.end, backward=arguments.backward)
        if len(frames) < 2:
            raise RoamError(f"There is no frame to track to from {frames[0]}; name another with --start or --end.")
        if not arguments.exclude:
            which = LeaveOut(arguments.leave_out or LeaveOut.ABOVE)
            covers = covering(project, [shape.id for shape in shapes], frames[0], which)
        require_target(target)
        sources = Sources.of(plate.source, arguments.project)
        require_free([(target, Kind.PROJECT)], sources, overwrite=arguments.overwrite, rewritten=arguments.project)
        with claimed(target), cancelling() as token, kept(write) as keeper:
            least = follow(
                plate, project, (shapes, covers), frames, PlaneMotion(arguments.motion), token, keeper, arguments.json
            )
    if not arguments.json:
        print(f"Followed the plane from frame {frames[0]} to {frames[-1]}. {verdict(*least)}", file=sys.stderr)
    return 0


def surface_of(project: Project, arguments: argparse.Namespace) -> tuple[list[RotoShape], list[RotoShape]]:
    """The shapes on the surface, and those before it that are named."""
    excluded = picked(project, arguments.exclude) if arguments.exclude else []
    if excluded and arguments.leave_out is not None:
        raise RoamError("--exclude names what lies before the surface and --leave-out chooses it; give one of them.")
    taken = {shape.id for shape in excluded}
    shapes = trackable(project, Picking(arguments.shape))
    both = [shape.name for shape in shapes if shape.id in taken]
    if arguments.shape and both:
        raise RoamError(f"The shape {both[0]!r} cannot be on the surface and before it; name it once.")
    shapes = [shape for shape in shapes if shape.id not in taken]
    if not shapes:
        raise RoamError(f"{arguments.project} holds no closed, unlocked shape on a surface.")
    return shapes, excluded


def follow(
    plate: Plate,
    project: Project,
    work: tuple[Sequence[RotoShape], Sequence[RotoShape]],
    frames: range,
    kind: PlaneMotion,
    token: CancelToken,
    keeper: Keeper,
    tells: bool,
) -> tuple[float, int]:
    """Track the surface, leg by leg, and offer what is finished; the least confidence and its frame."""
    from roam_core.motion.plane_track import track_plane  # numba: a command's help must not wait for it

    shapes, covers = work
    aspect = project.require_clip().pixel_aspect
    ids = [shape.id for shape in shapes]
    legs = legs_of(frames, adjusted_frames(project, ids))
    project, layer = with_moving_layer(project, ids, frames[0])
    least, began = (1.0, frames[-1]), time.perf_counter()
    plate.ahead_of(frames[0], frames)
    with bar(1.0) as shown:
        for leg in legs:
            left = deque(leg[1:])
            given = *outlines_at(shapes, leg[0]), leg, kind, token, partial(covers_at, covers), aspect
            for step in track_plane(plate.read_or_bridge, *given):
                project = followed(project, layer, leg[0], step.frame, step.matrix, step.confidence)
                keeper.offer(project)
                least = min(least, (step.confidence, step.frame))
                shown.update(abs(step.frame - frames[0]) / (len(frames) - 1) - shown.n)
                now = time.perf_counter()
                passed = _up_to(left, step.frame)
                if tells:
                    for frame in passed:
                        print_missing(frame)
                    print_step(step, now - began)
                began = now
                plate.ahead_of(step.frame, frames)
            if tells:
                for frame in left:
                    print_missing(frame)
    plate.require_read()
    return least


def _up_to(left: deque[int], frame: int) -> list[int]:
    """Take the frames up to this one from those of a leg that are left; those before it."""
    passed: list[int] = []
    while left and left[0] != frame:
        passed.append(left.popleft())
    if left:
        left.popleft()
    return passed


def print_missing(frame: int) -> None:
    """The line of a frame that the plate lacks: nothing is known of it, and the layer goes straight on past it."""
    print_json({"frame": frame, "seconds": 0.0, "confidence": 0.0, "seen": 0.0, "error": None, "matrix": None})


def print_step(step: PlaneStep, seconds: float) -> None:
    """One line of JSON: the frame, how far it can be trusted, and the motion since the leg's first frame.

    The error of a plane that was bridged is not known: null.
    """
    print_json(
        {
            "frame": step.frame,
            "seconds": round(seconds, 6),
            "confidence": round(step.confidence, 4),
            "seen": round(step.seen, 4),
            "error": round(step.error, 3) if step.error < float("inf") else None,
            "matrix": [[round(value, 9) for value in row] for row in step.matrix.tolist()],
        }
    )


def verdict(confidence: float, frame: int) -> str:
    """What to think of a track whose least confidence is this."""
    if not is_doubtful(confidence):
        return f"Confidence is {confidence:.2f} at least."
    return f"Look at frame {frame}: confidence is {confidence:.2f} there."
