"""The outlines of a span settled between those of the frames on either side; the artist's keys stay as they are."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RegionParams
from roam_core.propagate.between.directional_pass import ReadPicture
from roam_core.propagate.between.endpoint_consistency import Span
from roam_core.propagate.between.merge import Merged
from roam_core.propagate.frame.result import Part
from roam_core.propagate.steadiness.residual import Flows, Places, residual
from roam_core.propagate.steadiness.settle import known_steps, settled

Row = Sequence[Merged | None]
"""Every outline of a span on one frame; None for one that is not there."""


def steadied(
    read: ReadPicture, span: Span, rows: Sequence[Row], params: RegionParams, token: CancelToken | None = None
) -> list[list[Merged | None]]:
    """The merged outlines of all frames between the keys of a span, each drawn to those of the frames beside it.

    `rows` are in the order of the frames, the first key's own left out.
    """
    asked = params.steadiness
    if asked.weight <= 0:
        return [list(row) for row in rows]
    outlines = [_of_key(span.first.parts), *(_of_row(row) for row in rows), _of_key(span.last.parts)]
    places = [
        None if points is None else Places.of(points, asked.residual, span.scale)
        for points in (next((row[k] for row in outlines if row[k] is not None), None) for k in range(len(outlines[0])))
    ]
    steps = _steps(read, span, outlines, places, params, token)
    result = []
    for n, row in enumerate(rows, start=1):
        now: list[Merged | None] = []
        for k, each in enumerate(row):
            place = places[k]
            if each is None or place is None:
                now.append(None)
                continue
            column = [step[k] for step in steps]
            before, after = known_steps(column[:n][::-1]), known_steps(column[n:])
            points = settled(each.points, place, before, after, asked, params.contour_fit.untying, span.scale)
            now.append(replace(each, points=points))
        result.append(now)
    return result


def _of_key(parts: Sequence[Part | None]) -> list[Array | None]:
    return [None if part is None else part.points for part in parts]


def _of_row(row: Row) -> list[Array | None]:
    return [None if each is None else each.points for each in row]


def _steps(
    read: ReadPicture,
    span: Span,
    outlines: Sequence[Sequence[Array | None]],
    places: Sequence[Places | None],
    params: RegionParams,
    token: CancelToken | None,
) -> list[list[Array | None]]:
    """For each frame but the first what its outlines did since the one before (`residual`); None: not known."""
    asked, found = params.steadiness.residual, []
    before = _picture(read, span.first.frame)
    for n, frame in enumerate(range(span.first.frame + 1, span.last.frame + 1), start=1):
        if token is not None:
            token.check()
        after = _picture(read, frame)
        pairs = [
            None if old is None or new is None else (old, new)
            for old, new in zip(outlines[n - 1], outlines[n], strict=True)
        ]
        there = [points for pair in pairs if pair is not None for points in pair]
        flows = None
        if before is not None and after is not None and there:
            flows = Flows.of(before, after, there, asked, span.scale)
        found.append(
            [
                None
                if flows is None or pair is None or place is None
                else residual(flows, *pair, place, asked, span.scale, subtracts=span.subtracts(k))
                for k, (pair, place) in enumerate(zip(pairs, places, strict=True))
            ]
        )
        before = after
    return found


def _picture(read: ReadPicture, frame: int) -> PreparedFrame | None:
    """None where the plate has none."""
    try:
        return read(frame)
    except MissingFrame:
        return None
