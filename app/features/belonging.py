"""Belonging: what each shape is in its object, and where its parts hang together; found beside the window's thread."""

from __future__ import annotations

from collections.abc import Callable, Collection, Mapping, Sequence
from dataclasses import dataclass
from enum import StrEnum
from typing import Any

import numpy as np
from PySide6.QtCore import QObject, Signal

from roam_core.arrays import Array
from roam_core.geometry import polyline
from roam_core.geometry.joints import joints
from roam_core.params import scale_for
from roam_core.propagate.shapes import objects
from roam_core.propagate.shapes.objects import Role, Unit, units
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import BlendMode, Project, RotoShape

from ..jobs.runner import Report, Runner
from ..model.document import Document
from ..model.view_state import ViewState, shapes_looked_at
from ..translation import tr


class Kind(StrEnum):
    """What a shape is in its object."""

    PART = "part"
    WHOLE = "whole"
    HOLE = "hole"
    OCCLUDER = "occluder"
    ALONE = "alone"
    OPEN = "open"


@dataclass(frozen=True)
class Place:
    """What a shape is in its object.

    Attributes
    ----------
    kind : which part it plays. count : the parts of the object, or the shapes of the whole.
    host : of a hole the name of what it lies in; empty where that is several outlines. link : its link.
    """

    kind: Kind
    count: int = 1
    host: str = ""
    link: str = ""

    def __str__(self) -> str:
        words = {
            Kind.PART: tr("Part of {count}", count=self.count),
            Kind.WHOLE: tr("One object") if self.count == 1 else tr("Whole of {count} shapes", count=self.count),
            Kind.HOLE: tr("Hole of {name}", name=self.host or tr("the whole")),
            Kind.OCCLUDER: tr("Occluder"),
            Kind.ALONE: tr("By itself"),
            Kind.OPEN: tr("Open: not tracked"),
        }[self.kind]
        is_named = self.link and self.kind in (Kind.WHOLE, Kind.HOLE)
        return f"{words} ({self.link})" if is_named else words


@dataclass(frozen=True, eq=False)
class Bone:
    """Two parts, by the ids of their shapes, that hang together at `joint (2,)`, between their `middles (2, 2)`."""

    shapes: tuple[str, str]
    joint: Array
    middles: Array


class Belonging(QObject):
    """Answers for the document as it is. Finding takes a while: until then the last answer holds.

    Without a `runner` everything is found when it is asked for.

    Signals
    -------
    changed() : something was found out.
    """

    changed = Signal()

    def __init__(
        self, document: Document, view_state: ViewState, runner: Runner | None = None, parent: QObject | None = None
    ) -> None:
        super().__init__(parent)
        self._document, self._view, self._runner = document, view_state, runner
        self._asked: dict[str, object] = {}
        self._known: tuple[Project, tuple[object, ...]] | None = None
        self._places: dict[str, Place] = {}
        self._bones: tuple[int, tuple[Bone, ...]] = (0, ())
        """A frame, and what was found on it."""
        document.replaced.connect(self._forget)

    def places(self) -> Mapping[str, Place]:
        """What the shapes are in their objects, by their ids; without those of which that is not known yet."""
        project = self._document.project
        if self._is_new("places", self._decisive(project)):
            self._find("places", lambda: places(project), self._take_places)
        return self._places

    def bones(self) -> Sequence[Bone]:
        """Where the objects of the selected shapes, or all where none is selected, hang together on this frame.

        While shapes are soloed, of these alone.
        """
        project, frame = self._document.project, self._view.frame
        if not any(frame in shape.artist_frames for shape in project.shapes):
            return ()
        chosen = frozenset(shape.id for shape in shapes_looked_at(project, self._view))
        here = tuple(shape.key_at(frame) for shape in project.shapes)
        if self._is_new("bones", (self._decisive(project), frame, chosen, here)):
            self._find("bones", lambda: (frame, bones(project, frame, chosen)), self._take_bones)
        return self._bones[1] if self._bones[0] == frame else ()

    def _decisive(self, project: Project) -> tuple[object, ...]:
        """`decisive`, remembered: a project that is painted many times is asked about as often."""
        if self._known is None or self._known[0] is not project:
            self._known = project, decisive(project)
        return self._known[1]

    def _is_new(self, kind: str, question: object) -> bool:
        """Whether another question was asked last."""
        is_new = self._asked.get(kind) != question
        self._asked[kind] = question
        return is_new

    def _find(self, kind: str, look: Callable[[], Any], take: Callable[[Any], None]) -> None:
        if self._runner is None:
            take(look())
            return

        def work(report: Report) -> str:
            report.partial(look())
            return ""

        self._runner.start(f"belonging: {kind}", work).partial.connect(take)

    def _take_places(self, found: dict[str, Place]) -> None:
        is_news, self._places = found != self._places, found
        if is_news and self._runner is not None:  # without one it is being answered
            self.changed.emit()

    def _take_bones(self, found: tuple[int, tuple[Bone, ...]]) -> None:
        is_news = bool(found[1] or self._bones[1])
        self._bones = found
        if is_news and self._runner is not None:  # without one it is being painted
            self.changed.emit()

    def _forget(self) -> None:
        """Another project was opened."""
        self._asked.clear()
        self._places, self._bones = {}, (0, ())


def places(project: Project) -> dict[str, Place]:
    """What every shape of a project is in its object, by its id."""
    shapes, grouped = project.shapes, Stamps.of(project.shapes, project.clip).objects
    found = {shape.id: Place(Kind.OPEN) for shape in shapes}
    for members in set(grouped.values()):
        together = [shapes[k] for k in members]
        made = units(together, _gap(project))
        for unit in made:
            for k in unit.members:
                found[together[k].id] = _place(together, made, unit, k)
    return found


def _gap(project: Project) -> float:
    """Pixels between outlines of one compound that still belong together."""
    return objects.near(None if project.clip is None else project.clip.size[::-1])


def bones(project: Project, frame: int, chosen: Collection[str]) -> tuple[Bone, ...]:
    """Where the objects of the `chosen` shapes hang together, as a run that begins on `frame` has it.

    Only where one of the object's parts holds a key of the artist's: of other frames no run takes the joints.
    """
    shapes, grouped = project.shapes, Stamps.of(project.shapes, project.clip).objects
    scale = 1.0 if project.clip is None else scale_for(project.clip.size[::-1])
    found: list[Bone] = []
    for members in sorted(set(grouped.values())):
        together = [shapes[k] for k in members]
        if not any(shape.id in chosen for shape in together):
            continue
        parts = [together[unit.members[0]] for unit in units(together, _gap(project)) if unit.role is Role.PART]
        there = [part for part in parts if part.exists_at(frame)]
        if any(frame in part.artist_frames for part in there):
            found += _bones(there, frame, scale)
    return tuple(found)


def _bones(parts: Sequence[RotoShape], frame: int, scale: float) -> list[Bone]:
    """The joints of parts that are attached, as they lie on a frame."""
    lines = [part.at(frame).flatten() for part in parts]
    held = [joint for joint in joints(lines, scale) if all(parts[k].attached for k in joint.shapes)]
    return [
        Bone(
            (parts[joint.shapes[0]].id, parts[joint.shapes[1]].id),
            joint.places.mean(axis=0),
            np.array([polyline.resample(lines[k], 64).mean(axis=0) for k in joint.shapes]),
        )
        for joint in held
    ]


def _place(together: Sequence[RotoShape], made: Sequence[Unit], unit: Unit, k: int) -> Place:
    """What the shape at `k` of an object is, in the unit that it belongs to."""
    shape, members = together[k], [together[j] for j in unit.members]
    solid = [member for member in members if member.blend is not BlendMode.SUBTRACT]
    if unit.role is Role.OCCLUDER:
        return Place(Kind.OCCLUDER)
    if solid and shape not in solid:
        return Place(Kind.HOLE, host=solid[0].name if len(solid) == 1 else "", link=shape.link)
    if unit.role is Role.PART:
        return Place(Kind.PART, sum(each.role is Role.PART for each in made))
    if shape.link and len(members) == 1:
        return Place(Kind.ALONE)
    return Place(Kind.WHOLE, len(members), link=shape.link)


def decisive(project: Project) -> tuple[object, ...]:
    """All that decides what belongs together: a tracked frame changes none of it, and asks for nothing again."""
    return (project.clip, *((shape.id, shape.name, *objects.decisive(shape)) for shape in project.shapes))
