"""Why a curve lies where it lies on a frame: what each term or cue says at its nodes and landmarks."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.params import RoamParams
from roam_core.propagate.between.frames_shown import keys_shown
from roam_core.propagate.engines.protocol import Account, Step
from roam_core.propagate.frame.nodes import NodeMap
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.memory import Beginning, ReadPicture, is_left_on, solve_again
from roam_core.propagate.parts.edges import Edges, edges, edges_on_key
from roam_core.propagate.shapes import provenance
from roam_core.propagate.shapes.gaps import Gap
from roam_core.propagate.shapes.objects import cuts, stacked
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.roto import Clip, Keyframe, Origin, RotoShape
from roam_core.translatable import sentence


@dataclass(frozen=True, eq=False)
class Explanation:
    """One shape's key on one frame, taken apart.

    Attributes
    ----------
    shape, key : the shape, and its key on the frame.
    config : the configuration that made the key; "" for the artist's.
    account : why its outline lies where it lies; without terms for an artist's key.
    apart : how far, in pixels, the key's control points lie from those that the run to this frame finds; 0 unless the
        key was filled from both sides, its shapes were tracked in other company, frames that it came over lost their
        keys since or it came back to them, or it was made on a machine that rounds otherwise.
    edges : where its outline is free, a seam or hidden; None where the shape is not there.
    on_key : the frame of the artist's key that it goes back to, and the same samples there; None without one.
    """

    shape: RotoShape
    key: Keyframe
    config: str
    account: Account
    apart: float = 0.0
    edges: Edges | None = None
    on_key: tuple[int, Edges] | None = None


@dataclass(frozen=True)
class _Run:
    """The run that a key came from: its configuration, direction, where it began, and the shapes that it solved.

    `alone` as in its stamp; `filled`: it was one of the two passes over a gap.
    """

    config: str
    forward: bool
    begun: int
    members: tuple[int, ...]
    alone: bool
    filled: bool


def explain(
    read: ReadPicture,
    shapes: Sequence[RotoShape],
    frame: int,
    clip: Clip | None,
    token: CancelToken | None = None,
    only: Collection[str] | None = None,
) -> list[Explanation]:
    """Take apart the keys that closed `shapes`, all of a project, hold on `frame`; those without a key are left out.

    What the engine knew when it came to the frame is worked out anew from the artist's keys, as in
    `propagate.memory.take_up`, for all shapes that it solved together. A frame that was filled from both sides is
    explained by the run from the nearer of its artist keys, of those that show something. `only` are the ids of those
    that are asked for.

    Raises
    ------
    RoamError
        for a key that is out of date, and for one that no configuration of this program made.
    Cancelled
        at a safe point after `token` was cancelled.
    """
    found: dict[int, Explanation] = {}
    runs: dict[_Run, list[int]] = {}
    stamps = Stamps.of(shapes, clip)

    @cache
    def shown(gap: Gap, config: str) -> frozenset[int]:
        """The keys of a gap that filling it goes by: their pictures are looked at once for all shapes."""
        params = provenance.known_params(config) or RoamParams()
        return frozenset(keys_shown(read, shapes, gap, params))

    for index, shape in enumerate(shapes):
        key = shape.key_at(frame)
        if key is None or not shape.closed or (only is not None and shape.id not in only):
            continue
        if key.origin is Origin.ARTIST:
            found[index] = _given(shape, key)
        else:
            runs.setdefault(_run_of(shown, stamps, index, key), []).append(index)
    for run, asked in runs.items():
        found.update(_explained(read, stamps, asked, frame, run, token))
    return _with_edges(read, shapes, frame, [found[index] for index in sorted(found)])


def _with_edges(
    read: ReadPicture, shapes: Sequence[RotoShape], frame: int, found: Sequence[Explanation]
) -> list[Explanation]:
    """The explanations with the kinds of edge of their shapes; on the key where that has a picture."""
    if not found:
        return []
    now = edges(read(frame), shapes, frame, {each.shape.id for each in found})
    keyed = edges_on_key(read, shapes, frame, now)
    return [replace(each, edges=now.get(each.shape.id), on_key=keyed.get(each.shape.id)) for each in found]


def _given(shape: RotoShape, key: Keyframe) -> Explanation:
    """An artist's key: nothing but where its nodes lie."""
    return Explanation(shape, key, "", Account.at(NodeMap.of(key.points, RoamParams(), 1.0), key.points))


def _run_of(shown: Callable[[tuple[int, int], str], Collection[int]], stamps: Stamps, k: int, key: Keyframe) -> _Run:
    made, shape = Stamp.read(key.inputs), stamps.shapes[k]
    if provenance.known_params(made.config) is None:
        raise RoamError(
            sentence(
                "The key of {name!r} on frame {frame} does not say which configuration made it; track it again.",
                name=shape.name,
                frame=key.frame,
            )
        )
    if stamps.is_stale(shape, key):
        raise RoamError(
            sentence(
                "The key of {name!r} on frame {frame} is out of date: the artist's key, the clip or the parameters "
                "have changed since. Track it again first.",
                name=shape.name,
                frame=key.frame,
            )
        )
    assert made.begun is not None
    if made.gap is None:
        members = stamps.solved_with(k, made.begun, made.forward, made.alone)
        return _Run(made.config, made.forward, made.begun, members, made.alone, filled=False)
    first, last = made.gap
    keyed = [frame for frame in made.gap if frame in shape.artist_frames]
    # One whose picture went since it was filled is told of by its name.
    ends = [frame for frame in keyed if frame in shown(made.gap, made.config)] or keyed
    begun = min(ends, key=lambda frame: (abs(frame - key.frame), frame))
    together = stamps.filled_with(k, (first, last), made.alone)
    members = tuple(j for j in together if begun in stamps.shapes[j].artist_frames)
    return _Run(made.config, begun == first, begun, members, made.alone, filled=True)


def _explained(
    read: ReadPicture, stamps: Stamps, asked: Sequence[int], frame: int, run: _Run, token: CancelToken | None
) -> dict[int, Explanation]:
    """The keys of the shapes asked for, all of one run.

    A run may have left frames out. Where the one through all of them finds other points, the one through those that
    hold keys of it is looked at too, and the nearer one explains.
    """
    passed = list(range(run.begun, frame, 1 if run.forward else -1)) or [run.begun]
    through_all = _explained_through(passed, read, stamps, asked, frame, run, token)
    keyed = passed if run.filled else [each for each in passed if each == run.begun or _is_keyed(stamps, each, run)]
    if keyed == passed or _apart(through_all) == 0.0:
        return through_all
    return min(through_all, _explained_through(keyed, read, stamps, asked, frame, run, token), key=_apart)


def _is_keyed(stamps: Stamps, frame: int, run: _Run) -> bool:
    return is_left_on(stamps, Beginning(run.begun, run.members), frame, run.config, run.forward, run.alone)


def _apart(found: Mapping[int, Explanation]) -> float:
    return max((each.apart for each in found.values()), default=0.0)


def _explained_through(
    passed: Sequence[int],
    read: ReadPicture,
    stamps: Stamps,
    asked: Sequence[int],
    frame: int,
    run: _Run,
    token: CancelToken | None,
) -> dict[int, Explanation]:
    """The keys as a run that goes through these frames, and no others, to `frame` explains them."""
    tracker, together = GroupTracker(run.config), [stamps.shapes[k] for k in run.members]
    solve_again(tracker, read, together, passed, token, forward=run.forward)
    standing = tracker.standing
    step = standing.view.step(standing.engine, read(frame), stacked(together, frame), token)
    keys = [shape.key_at(frame) for shape in together]
    return {
        k: _of_key(together[place], key, is_hole, step, place, tracker.params)
        for place, (k, key, is_hole) in enumerate(zip(run.members, keys, cuts(together), strict=True))
        if k in asked and key is not None
    }


def _of_key(shape: RotoShape, key: Keyframe, is_hole: bool, step: Step, place: int, params: RoamParams) -> Explanation:
    """The key of the shape in this `place` among those that were solved together."""
    account = step.account(place, key.points, is_hole)
    apart = float(np.hypot(*(key.points - step.results[place].points).T).max())
    return Explanation(shape, key, params.config, account, apart)
