"""`--shape NAME`: which shapes of a project a command works on."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

from roam_core.errors import RoamError
from roam_core.propagate.shapes.provenance import MIN_POINTS
from roam_core.roto import Project, RotoShape
from roam_core.roto.layers import only
from roam_core.translatable import sentence


class NothingToSolve(RoamError):
    """A sound project of whose shapes none, or none of the frames, is there to be worked on."""


@dataclass(frozen=True)
class Picking:
    """What `--shape` and `--alone` say: names or ids of the shapes that are wanted, None for all; and how."""

    names: Sequence[str] | None = None
    alone: bool = False


EVERYTHING = Picking()
"""All shapes, those of an object together."""


def add_shapes(parser: argparse.ArgumentParser, meaning: str, word: str = "--shape") -> None:
    """Declare `--shape`, or another `word` that takes names or ids of shapes and may be given again."""
    parser.add_argument(word, action="append", metavar="NAME", help=f"{meaning} (name or id; may be given again)")


def add_arguments(parser: argparse.ArgumentParser, verb: str) -> None:
    """Declare `--shape` and `--alone` for a command that solves frames."""
    add_shapes(parser, f"{verb} only this shape, or these")
    parser.add_argument(
        "--alone", action="store_true", help="solve each shape as if its object had no others (default: together)"
    )


def picked(project: Project, names: Sequence[str] | None) -> list[RotoShape]:
    """The shapes with these names or ids, all for None; one sentence for a name that no closed shape has."""
    if not names:
        return list(project.shapes)
    return _named([shape for shape in project.shapes if shape.closed], names, "closed shape")


def with_only(project: Project, names: Sequence[str] | None) -> Project:
    """The project with the shapes of these names or ids alone, open ones too; all for None.

    Raises `RoamError` for a name that no shape has.
    """
    if not names:
        return project
    return only(project, [shape.id for shape in _named(project.shapes, names, "shape")])


def _named(shapes: Sequence[RotoShape], names: Sequence[str], kind: str) -> list[RotoShape]:
    for name in names:
        if not any(name in (shape.name, shape.id) for shape in shapes):
            known = ", ".join(repr(shape.name) for shape in shapes) or "none"
            raise RoamError(f"There is no {kind} {name!r}; the {kind}s of the project: {known}.")
    return [shape for shape in shapes if shape.name in names or shape.id in names]


def trackable(project: Project, picking: Picking = EVERYTHING) -> list[RotoShape]:
    """The closed, unlocked shapes among those picked, but for single points, which outline nothing.

    One sentence where a named one is locked, a point, or not there.
    """
    closed = [shape for shape in picked(project, picking.names) if shape.closed]
    wanted = [shape for shape in closed if shape.point_count >= MIN_POINTS]
    if picking.names and len(wanted) < len(closed):
        name = next(shape.name for shape in closed if shape not in wanted)
        raise RoamError(sentence("{name!r} is a single point; draw an outline around the object first.", name=name))
    locked = {shape.id: shape.name for shape in wanted if project.is_locked(shape.id)}
    if picking.names and locked:
        name = next(iter(locked.values()))
        raise RoamError(
            sentence(
                "The shape {name!r} is locked, or lies in a locked layer; unlock that before it is solved.", name=name
            )
        )
    return [shape for shape in wanted if shape.id not in locked]
