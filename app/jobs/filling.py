"""Filling as work for the solver's thread: the frames between artist keys, gap by gap; which fills wait for others.

What is filled is not redone.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from roam_core.errors import RoamError
from roam_core.installation import has_studio
from roam_core.params import RoamParams, params_for
from roam_core.propagate.shapes.gaps import Gap, gaps_of
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.propagate.shapes.taking_part import takes_part
from roam_core.roto import Keyframe, Origin, Project, RotoShape

from ..translation import sentence_of, tr
from .runner import Report

WORTH_PROCESSES = 24
"""Frames to fill below which starting other processes takes longer than they save."""


@dataclass(frozen=True)
class Filled:
    """The engine's keys in one gap, by shape."""

    gap: Gap
    keys: Mapping[str, tuple[Keyframe, ...]]


@dataclass(frozen=True)
class FillRequest:
    """A snapshot of everything that filling needs: the project with all its shapes, and the ids of those to fill.

    `processes` of this machine may be used for it; 0: one for each two cores.
    """

    read: Callable[[int], Any]
    project: Project
    shapes: tuple[RotoShape, ...]
    asked: frozenset[str]
    gaps: tuple[Gap, ...]
    config: str
    clip: str
    size: tuple[int, int] | None = None
    alone: bool = False
    processes: int = 1


class WaitingFills:
    """Fills that begin when the run under way has ended, in their order."""

    def __init__(self) -> None:
        self._fills: list[tuple[Sequence[str], Sequence[Gap], Callable[[Sequence[str], Sequence[Gap]], None]]] = []

    def __bool__(self) -> bool:
        return bool(self._fills)

    def add(
        self, shape_ids: Sequence[str], gaps: Sequence[Gap], begin: Callable[[Sequence[str], Sequence[Gap]], None]
    ) -> None:
        """Have a fill of these shapes wait, which `begin` begins."""
        self._fills.append((shape_ids, gaps, begin))

    def add_first(
        self, shape_ids: Sequence[str], gaps: Sequence[Gap], begin: Callable[[Sequence[str], Sequence[Gap]], None]
    ) -> None:
        """Have a fill of these shapes wait before all others: it had begun already."""
        self._fills.insert(0, (shape_ids, gaps, begin))

    def clear(self) -> None:
        self._fills.clear()

    def leave_out(self, shape_ids: Collection[str]) -> None:
        """Fill these shapes no more: another run of them begins now."""
        rest = [([each for each in ids if each not in shape_ids], gaps, begin) for ids, gaps, begin in self._fills]
        self._fills = [fill for fill in rest if fill[0]]

    def begin_next(self, project: Project) -> None:
        """Begin the first one that is still wanted: of its shapes that are there and not locked gaps are left."""
        while self._fills:
            ids, gaps, begin = self._fills.pop(0)
            free = [shape_id for shape_id in ids if project.has(shape_id) and not project.is_locked(shape_id)]
            there = gaps_of([shape for shape_id in free if (shape := project.shape(shape_id)).closed])
            if still := [gap for gap in gaps if gap in there]:
                begin(free, still)
                return


def fill(report: Report, request: FillRequest) -> str:
    """Fill the gaps of the request, each handed over when it is finished; gives the closing sentence.

    Much is spread over processes first, if there may be some: their keys are those that are made here. A gap that
    cannot be filled, as where the picture of its key is damaged, does not lose the others; `RoamError` is raised at the
    end.
    """
    from roam_core.propagate.between.frames_shown import is_gap_filled
    from roam_core.propagate.between.span import fill_span

    params, stamps = params_for(request.config), Stamps(request.shapes, request.clip, request.size)
    shapes = [shape for shape in request.shapes if shape.id in request.asked]

    def is_filled(gap: Gap) -> bool:
        inside = range(gap[0] + 1, gap[1])
        return is_gap_filled(request.read, shapes, gap, inside, stamps, params, alone=request.alone)

    wanted = [gap for gap in request.gaps if not is_filled(gap)]
    plate = _Plate(request.read)
    failures: list[RoamError] = []
    spread = _filled_apart(report, request, wanted, params)
    for done, gap in enumerate(wanted):
        report.token.check()
        if gap in spread:
            continue

        def tell(fraction: float, _text: str, done: int = done, gap: Gap = gap) -> None:
            place = tr("Filling frames {first} to {last}", first=gap[0] + 1, last=gap[1] - 1)
            report.progress((done + fraction) / len(wanted), place)

        asked = {shape.id for shape in request.shapes if shape.id in request.asked and takes_part(shape, gap)}
        try:
            filled = fill_span(
                plate, _closed(request, asked), *gap, params, report.token, tell, request.clip, asked, request.alone
            )
        except RoamError as error:
            failures.append(error)
            continue
        report.partial(Filled(gap, {shape.id: _keys_in(shape, gap) for shape in filled if shape.id in asked}))
    if failures and len(wanted) == 1:
        raise failures[0]
    if failures:
        raise RoamError(
            tr(
                "{count} of {all} gap(s) could not be filled: {reason}",
                count=len(failures),
                all=len(wanted),
                reason=sentence_of(failures[0]),
            )
        )
    return _sentence(request, wanted)


def _filled_apart(report: Report, request: FillRequest, wanted: Sequence[Gap], params: RoamParams) -> Collection[Gap]:
    """Fill on processes of this machine what is worth it, each piece handed over as it ends; gives the whole gaps."""
    if request.processes == 1 or not has_studio() or sum(last - first - 1 for first, last in wanted) < WORTH_PROCESSES:
        return ()
    from roam_core.cli.picking import Picking
    from roam_core.cli.spans import pieces_of, taken
    from roam_core.cli.spreading import spread
    from roam_core.studio.cluster import ENGINE_THREADS, cores

    able = [shape.id for shape in request.shapes if shape.closed and not request.project.is_locked(shape.id)]
    ids = [shape_id for shape_id in able if shape_id in request.asked]
    picking = Picking(ids, request.alone)
    divided = pieces_of(request.project, wanted, picking) if ids else []
    processes = min(request.processes or cores() // ENGINE_THREADS, len(divided))
    if processes < 2:
        return ()
    report.progress(0.0, tr("Starting {count} processes …", count=processes))
    left = Counter(gap for gap, _ in divided)
    for done, piece in enumerate(
        spread(request.project, divided, params, processes, alone=request.alone, token=report.token)
    ):
        if piece.made is not None:
            left[piece.gap] -= 1
            filled = taken(request.project, piece.made, [piece.gap], params, picking)
            made = {shape_id: _keys_in(filled.shape(shape_id), piece.gap) for shape_id in ids}
            report.partial(Filled(piece.gap, {name: keys for name, keys in made.items() if keys}))
        place = tr(
            "Filled {done} of {all} pieces on {count} processes", done=done + 1, all=len(divided), count=processes
        )
        report.progress((done + 1) / len(divided), place)
    return [gap for gap, count in left.items() if not count]


class _Plate(Mapping[int, Any]):
    """The plate's pictures by frame, as the engine asks for them."""

    def __init__(self, read: Callable[[int], Any]) -> None:
        self._read = read

    def __getitem__(self, frame: int) -> Any:
        return self._read(frame)

    def __iter__(self) -> Iterator[int]:
        raise TypeError("the frames of a plate are read one by one")

    def __len__(self) -> int:
        raise TypeError("the frames of a plate are read one by one")


def _closed(request: FillRequest, asked: Collection[str]) -> list[RotoShape]:
    """The shapes asked for, and those that may take part; an open one that was asked for is told of by the engine."""
    return [shape for shape in request.shapes if shape.closed or shape.id in asked]


def _keys_in(shape: RotoShape, gap: Gap) -> tuple[Keyframe, ...]:
    return tuple(key for key in shape.keys if gap[0] < key.frame < gap[1] and key.origin is Origin.ENGINE)


def _sentence(request: FillRequest, gaps: Sequence[Gap]) -> str:
    """What was done: these of the gaps asked for were filled."""
    if not gaps:
        asked = [shape for shape in request.shapes if shape.id in request.asked]
        if not any(_keys_in(shape, gap) for shape in asked for gap in request.gaps):
            return tr("No frame between these keys shows anything: there is nothing to fill.")
        return tr("Filled already: nothing that it depends on has changed.")
    if len(gaps) == 1:
        return tr("Filled the frames {first} to {last}.", first=gaps[0][0] + 1, last=gaps[0][1] - 1)
    return tr(
        "Filled {count} gaps between frames {first} and {last}.",
        count=len(gaps),
        first=gaps[0][0],
        last=max(last for _, last in gaps),
    )
