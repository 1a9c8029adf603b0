"""Many frames: the loop that the command line, the window and the tests all run."""

from __future__ import annotations

import time
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache, partial
from itertools import pairwise

from roam_core.arguments import frame_number, names_of, shown
from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media.partial import Images, reading
from roam_core.media.source import MissingFrame
from roam_core.params import DEFAULT_CONFIG, RoamParams, params_for
from roam_core.params.evidence import BlankParams
from roam_core.propagate.frame.result import FrameResult, TrackResult
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.memory import Beginning, ReadPicture, TrackMemory, begins, take_up
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import RotoShape
from roam_core.roto.bounds import require_near
from roam_core.roto.given import shapes_of
from roam_core.threads import each
from roam_core.translatable import sentence


def track(
    read: Images,
    shapes: Sequence[RotoShape],
    frames: Sequence[int],
    config: str | RoamParams = DEFAULT_CONFIG,
    token: CancelToken | None = None,
    clip: str = "",
    memory: TrackMemory | None = None,
    begun: Callable[[FrameResult], None] | None = None,
    only: Collection[str] | None = None,
    alone: bool = False,
) -> Iterator[FrameResult]:
    """Carry `shapes` from `frames[0]`, where they are given, through the other frames, in their order.

    `shapes` come bottom first. Those that belong together (`propagate.shapes.objects`) are solved together; all share
    one preparation of each picture. Results come one frame at a time; a caller that stops early keeps what it has. The
    first frame yields nothing: it is the artist's, or an engine frame from which the run goes on as if it had never
    been stopped (`memory` spares it the way there). `begun` is told of it before the others are solved: the landmarks
    to start with, and the shapes as given; but a key of the engine's there that is out of date, as where the artist
    corrected another of its object, is solved anew.

    `only` are the ids of the shapes that are wanted; None: all. The others are solved with those whose object they
    belong to, and are not given back: what is wanted comes out the same whichever of its object is. With `alone` each
    shape is solved as if there were no others. What is locked in a project is carried like all else: `only` leaves it
    out (`Project.is_locked`).

    Parameters
    ----------
    read : a function that gives the picture of a frame, (h, w, 3) RGB, uint8 or float32 in [0, 1], and raises
        `MissingFrame` where there is none, or a mapping that does so. What else it raises ends the run.
    frames : in the order in which they are gone through, rising or falling. Where they leave some out, a run that is
        taken up is so through those that hold its keys, and no other is read.
    config : name of a configuration (`roam_core.params.CONFIGS`) or a `RoamParams`.
    clip : identity of the clip for the stamps of ENGINE keys (`provenance.clip_stamp`).

    Raises
    ------
    Cancelled
        at a safe point after `token` was cancelled.
    ValueError
        when an argument is not what it should be, such as an id in `only` that no shape has, or frames that neither
        rise nor fall.
    MissingFrame, RoamError
        as `read` raises them for the first frame, and where that is blank and holds no key; a gap later on, or a blank
        frame, is passed over and reported as MISSING_FRAME.
    """
    shapes, frames = shapes_of(shapes), frames if isinstance(frames, range) else _numbers(frames)
    read = reading(read)
    only = names_of(only, (shape.id for shape in shapes))
    asked = [k for k, shape in enumerate(shapes) if only is None or shape.id in only]
    if not asked:
        raise RoamError(sentence("There is no shape to track; draw one, or select one, first."))
    if len(frames) == 0:
        raise RoamError(sentence("There is no frame to track; name the one to begin on, and those to go to."))
    first, params = PreparedFrame(read(frames[0])), params_for(config)

    def prepared(frame: int) -> PreparedFrame:
        return first if frame == frames[0] else PreparedFrame(read(frame))

    shows = _showing(prepared, [shapes[k] for k in asked], frames[0], params.blank)
    if not any(shapes[k].key_at(frames[0]) for k in asked) and not shows(frames[0]):
        raise MissingFrame(sentence("Frame {frame} shows nothing; track from a frame that does.", frame=frames[0]))
    stamps = Stamps(shapes, clip, first.size)
    forward = frames.step > 0 if isinstance(frames, range) else frames[-1] >= frames[0]
    sparse = any(abs(after - before) > 1 for before, after in pairwise(frames))
    together: dict[Beginning, list[int]] = {}
    for k in asked:
        beginning = begins(stamps, k, frames[0], params.config, forward=forward, alone=alone, shows=shows)
        together.setdefault(beginning, []).append(k)
    under_way = []
    for beginning, own in together.items():
        tracker = GroupTracker(config, clip, alone=alone)
        take_up(
            tracker, prepared, stamps, beginning, frames[0], memory, token, forward=forward, alone=alone, sparse=sparse
        )
        under_way.append(_Run(tracker, beginning.members, tuple(own)))
    if begun is not None:
        begun(_in_order(frames[0], under_way, [run.tracker.given() for run in under_way]))
    for frame in frames[1:]:
        if token is not None:
            token.check()
        try:
            picture = PreparedFrame(read(frame))
        except MissingFrame:
            yield _in_order(frame, under_way, [run.tracker.skip(frame) for run in under_way])
            continue
        began = time.perf_counter()
        solved = each(partial(_stepped, picture, frame, token), under_way)
        result = _in_order(frame, under_way, solved, time.perf_counter() - began)
        if memory is not None:
            for run in under_way:
                memory.keep(run.tracker.standing, run.tracker.stamp(forward=forward))
        under_way = _regrouped(under_way, stamps, forward, alone, picture, frame)
        yield result


@dataclass(frozen=True, eq=False)
class _Run:
    """Shapes that are solved together: all of them, and those that were asked for, by their indices."""

    tracker: GroupTracker
    members: tuple[int, ...]
    asked: tuple[int, ...]


def _showing(
    prepared: ReadPicture, shapes: Sequence[RotoShape], start: int, params: BlankParams
) -> Callable[[int], bool]:
    """Tells, once for each frame, whether it has a picture that shows something of the shapes.

    A gap shows nothing; on the frame of the `start` it raises `MissingFrame`. A shape that lies nowhere near the image
    raises `RoamError`.
    """

    @cache
    def shows(frame: int) -> bool:
        outlines = [shape.at(frame).points for shape in shapes]
        for shape, outline in zip(shapes, outlines, strict=True):
            require_near(shape, frame, outline)
        try:
            return not is_blank(prepared(frame), outlines, params)
        except MissingFrame:
            if frame == start:
                raise
            return False

    return shows


def _regrouped(
    runs: Sequence[_Run], stamps: Stamps, forward: bool, alone: bool, picture: PreparedFrame, frame: int
) -> list[_Run]:
    """The runs that go on from a frame: one that began anew there, all being given, does so with those there are now.

    Those are the others of the object that the artist keyed by then; what was not asked for is as it is in the project.
    """
    wanted: dict[tuple[int, ...], list[tuple[int, _Run]]] = {}
    result = []
    for run in runs:
        if alone or run.tracker.standing.known_from != frame:
            result.append(run)
            continue
        for k in run.asked:
            wanted.setdefault(stamps.solved_with(k, frame, forward), []).append((k, run))
    for members, pairs in wanted.items():
        asked = tuple(sorted(k for k, _ in pairs))
        same = next((run for _, run in pairs if run.members == members), None)
        if same is not None:
            result.append(replace(same, asked=asked))
            continue
        now = {
            j: shape
            for run in runs
            for j, shape in zip(run.members, run.tracker.standing.shapes, strict=True)
            if j in run.asked
        }
        tracker = pairs[0][1].tracker.another()
        tracker.start(picture, [now.get(j, stamps.shapes[j]) for j in members], frame, forward=forward)
        result.append(_Run(tracker, members, asked))
    return sorted(result, key=lambda run: (run.members, run.asked))


def _numbers(frames: Sequence[int]) -> tuple[int, ...]:
    if not isinstance(frames, Iterable):
        raise ValueError(f"frames are several numbers, the first one to begin on, not {shown(frames)}")
    numbers = tuple(map(frame_number, frames))
    steps = [after - before for before, after in pairwise(numbers)]
    if not (all(step > 0 for step in steps) or all(step < 0 for step in steps)):
        raise ValueError(f"frames rise or fall, each once, from the one to begin on, not {shown(frames)}")
    return numbers


def _stepped(picture: PreparedFrame, frame: int, token: CancelToken | None, run: _Run) -> tuple[TrackResult, ...]:
    try:
        return run.tracker.step(picture, frame, token)
    except MissingFrame:  # where its file is damaged shows when it is read there
        return run.tracker.skip(frame)


def _in_order(
    frame: int, runs: Sequence[_Run], solved: Sequence[Sequence[TrackResult]], seconds: float = 0.0
) -> FrameResult:
    by_shape = {
        k: result
        for run, results in zip(runs, solved, strict=True)
        for k, result in zip(run.members, results, strict=True)
        if k in run.asked
    }
    return FrameResult(frame, tuple(by_shape[k] for k in sorted(by_shape)), seconds)
