"""`--shape NAME`: which shapes of a project a command works on."""

from __future__ import annotations

import argparse
from collections.abc import Sequence
from dataclasses import dataclass

from roam_core.errors import RoamError
from roam_core.roto import Project, RotoShape


@dataclass(frozen=True)
class Picking:
    """What `--shape` and `--alone` say: names or ids of the shapes that are wanted, None for all; and how."""

    names: Sequence[str] | None = None
    alone: bool = False


EVERYTHING = Picking()
"""All shapes, those of an object together."""


def add_arguments(parser: argparse.ArgumentParser, verb: str) -> None:
    """Declare `--shape` and `--alone` for a command that solves frames."""
    parser.add_argument(
        "--shape", action="append", metavar="NAME", help=f"{verb} only this shape, or these (may be given again)"
    )
    parser.add_argument(
        "--alone", action="store_true", help="solve each shape as if its object had no others (default: together)"
    )


def picked(project: Project, names: Sequence[str] | None) -> list[RotoShape]:
    """The shapes with these names or ids, all for None; one sentence for a name that no closed shape has."""
    if not names:
        return list(project.shapes)
    closed = [shape for shape in project.shapes if shape.closed]
    for name in names:
        if not any(name in (shape.name, shape.id) for shape in closed):
            known = ", ".join(repr(shape.name) for shape in closed) or "none"
            raise RoamError(f"There is no closed shape {name!r}; the closed shapes of the project: {known}.")
    return [shape for shape in closed if shape.name in names or shape.id in names]


def trackable(project: Project, picking: Picking = EVERYTHING) -> list[RotoShape]:
    """The closed, unlocked shapes among those picked; one sentence where a named one is locked or is not there."""
    wanted = [shape for shape in picked(project, picking.names) if shape.closed]
    locked = [shape.name for shape in wanted if shape.locked]
    if picking.names and locked:
        raise RoamError(f"The shape {locked[0]!r} is locked; unlock it before it is solved.")
    return [shape for shape in wanted if not shape.locked]
