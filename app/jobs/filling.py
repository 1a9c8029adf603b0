"""Filling as work for the solver's thread: the frames between artist keys, gap by gap; what is filled is not redone."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Any

from app.jobs.runner import Report
from roam_core.params import RoamParams, params_for
from roam_core.propagate.provenance import fill_stamp
from roam_core.roto import Keyframe, Origin, RotoShape

Gap = tuple[int, int]
"""Two frames with artist keys and none between."""


@dataclass(frozen=True)
class Filled:
    """The engine's keys in one gap, by shape."""

    gap: Gap
    keys: Mapping[str, tuple[Keyframe, ...]]


@dataclass(frozen=True)
class FillRequest:
    """A snapshot of everything that filling needs."""

    read: Callable[[int], Any]
    shapes: tuple[RotoShape, ...]
    gaps: tuple[Gap, ...]
    config: str
    clip: str


def gaps_of(shapes: Sequence[RotoShape]) -> list[Gap]:
    """Every gap between neighbouring artist keys of a shape, in order."""
    return sorted(
        {
            (first, last)
            for shape in shapes
            for first, last in pairwise(shape.artist_frames)
            if any(shape.exists_at(frame) for frame in range(first + 1, last))
        }
    )


def fill(report: Report, request: FillRequest) -> str:
    """Fill the gaps of the request, each handed over when it is finished; gives the closing sentence."""
    from roam_core.propagate.span import fill_span

    params, shapes = params_for(request.config), {shape.id: shape for shape in request.shapes}
    wanted = [gap for gap in request.gaps if not _is_filled(list(shapes.values()), gap, params, request.clip)]
    plate = _Plate(request.read)
    for done, gap in enumerate(wanted):
        report.token.check()

        def tell(fraction: float, _text: str, done: int = done, gap: Gap = gap) -> None:
            place = f"Filling frames {gap[0] + 1} to {gap[1] - 1}"
            report.progress((done + fraction) / len(wanted), place)

        members = _members(list(shapes.values()), gap)
        for shape in fill_span(plate, members, *gap, params, report.token, tell, request.clip):
            shapes[shape.id] = shape
        report.partial(Filled(gap, {shape.id: _keys_in(shapes[shape.id], gap) for shape in members}))
    return _sentence(wanted)


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


def _members(shapes: Sequence[RotoShape], gap: Gap) -> list[RotoShape]:
    """The shapes with an artist key on either end of the gap and none between."""
    first, last = gap
    return [
        shape
        for shape in shapes
        if {first, last} & set(shape.artist_frames) and not any(first < frame < last for frame in shape.artist_frames)
    ]


def _is_filled(shapes: Sequence[RotoShape], gap: Gap, params: RoamParams, clip: str) -> bool:
    """True when every frame in the gap holds a key that filling would only make again."""
    keyed = [shape for shape in shapes if gap in pairwise(shape.artist_frames)]
    return all(
        (key := shape.key_at(frame)) is not None and key.inputs == fill_stamp(shape, frame, params, clip)
        for shape in keyed
        for frame in range(gap[0] + 1, gap[1])
        if shape.exists_at(frame)
    )


def _keys_in(shape: RotoShape, gap: Gap) -> tuple[Keyframe, ...]:
    return tuple(key for key in shape.keys if gap[0] < key.frame < gap[1] and key.origin is Origin.ENGINE)


def _sentence(gaps: Sequence[Gap]) -> str:
    if not gaps:
        return "Filled already: nothing that it depends on has changed."
    if len(gaps) == 1:
        return f"Filled the frames {gaps[0][0] + 1} to {gaps[0][1] - 1}."
    return f"Filled {len(gaps)} gaps between frames {gaps[0][0]} and {max(last for _, last in gaps)}."
