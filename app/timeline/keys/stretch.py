"""StretchEnds: brackets beside the first and the last of several chosen keys, by which these are stretched in time."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from enum import StrEnum

from PySide6.QtCore import QPointF
from PySide6.QtGui import QColor, QPainter, QPen

from roam_core.roto.timing import stretched

from ... import style
from ...translation import N_, tr
from ..axis import TimeAxis

GRAB = 4.0
"""Pixels around a bracket in which a press takes hold of it."""
BESIDE = 10.0
"""Pixels from the middle of a key to its bracket."""
INWARD = 3.0
TIP = N_("Drag to stretch the chosen keys in time")
STRETCHING = N_("Stretch {keys}: they go from frame {first} to {last}.")


class End(StrEnum):
    """The end of the chosen keys that is dragged; the other one stays."""

    FIRST = "first"
    LAST = "last"


class StretchEnds:
    """The brackets of the keys on `frames`, in rows from `top` to `bottom` pixels; none where they lie on one frame."""

    def __init__(self, axis: TimeAxis, frames: Iterable[int], top: float, bottom: float) -> None:
        own = sorted(set(frames))
        self._axis, self._top, self._bottom = axis, top, bottom
        self._frames = (own[0], own[-1]) if len(own) > 1 else None

    def at(self, position: QPointF, nearest_key: float) -> End | None:
        """The bracket under a position, unless a key lies nearer, so many pixels away."""
        if self._frames is None or not self._top <= position.y() <= self._bottom:
            return None
        distance, end = min((abs(position.x() - x), end) for end, x in self._edges())
        return end if distance <= GRAB and distance < nearest_key else None

    def paint(self, painter: QPainter) -> None:
        if self._frames is None:
            return
        painter.setPen(QPen(QColor(style.TEXT), 1.5))
        top, bottom = self._top + 2.5, self._bottom - 3.5
        for end, x in self._edges():
            inner = x + (INWARD if end is End.FIRST else -INWARD)
            painter.drawPolyline([QPointF(inner, top), QPointF(x, top), QPointF(x, bottom), QPointF(inner, bottom)])

    def _edges(self) -> list[tuple[End, float]]:
        assert self._frames is not None
        scale = self._axis.scale
        first, last = (scale.x(frame) for frame in self._frames)
        edges = [(End.FIRST, max(first - BESIDE, scale.left + 1.0)), (End.LAST, last + BESIDE)]
        return [(end, x) for end, x in edges if scale.left <= x]


class Stretch:
    """One drag of a bracket, from where it was pressed."""

    def __init__(self, axis: TimeAxis, end: End, x: float) -> None:
        self._axis, self._end, self._pressed_time = axis, end, axis.scale.time(x)

    def goes(self, frames: Iterable[int], x: float) -> dict[int, int]:
        """Where keys on `frames` go with the pointer at `x`: not out of the clip, in order, none over another."""
        own, (start, stop) = sorted(set(frames)), self._axis.scale.clip
        if len(own) < 2:
            return {}
        way, first, last = round(self._axis.scale.time(x) - self._pressed_time), own[0], own[-1]
        if self._end is End.LAST:
            last = max(min(last + way, max(stop - 1, last)), first + len(own) - 1)
        else:
            first = min(max(first + way, min(start, first)), last - len(own) + 1)
        return stretched(own, first, last)


def told(keys: str, goes: Mapping[int, int]) -> str:
    """The sentence that says where so many keys go; empty where they are there no more."""
    return "" if not goes else tr(STRETCHING, keys=keys, first=min(goes.values()), last=max(goes.values()))
