"""What the commands share that change the shapes of a project by what its plate shows."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import TypeVar

from roam_core.cancel import CancelToken, Progress
from roam_core.cli.bar import progress_bar
from roam_core.cli.overwriting import claimed, project_writer
from roam_core.cli.picking import NothingToSolve, Picking, trackable
from roam_core.cli.plate import loaded, opened
from roam_core.cli.stopping import cancelling
from roam_core.cli.targets import require_target
from roam_core.interchange.authorship import Kind
from roam_core.interchange.targets import Sources, require_free
from roam_core.media.source import ReadImage
from roam_core.roto import RotoShape
from roam_core.roto.project import Project

T = TypeVar("T")


@dataclass(frozen=True)
class PlateTask:
    """Shapes that were `asked` for of a project, which are to be changed, and written to `target`.

    `overwrite`: another file there may be replaced. `writer` writes a project to it.
    """

    source: Path
    target: Path
    overwrite: bool
    project: Project
    asked: Sequence[RotoShape]
    writer: Callable[[Project], object]

    @classmethod
    def of(cls, arguments: argparse.Namespace, verb: str) -> PlateTask:
        """By the words `project`, `save`, `shape` and `overwrite`; `verb` says what shapes are wanted for.

        Raises
        ------
        RoamError
            when the project cannot be read, or lacks a shape that is named. `NothingToSolve` when it holds no closed,
            unlocked shape of those asked for.
        """
        source = arguments.project
        target = source if arguments.save is None else arguments.save
        writer = project_writer(target, source)
        project = loaded(source)
        asked = asked_shapes(project, source, arguments.shape, verb)
        return cls(source, target, arguments.overwrite, project, asked, writer)

    def change(
        self, look: Callable[[ReadImage, CancelToken, Progress], T], shapes: Callable[[T], Sequence[RotoShape]]
    ) -> T:
        """What `look` finds in the plate, with a bar, and to be stopped, once the target is sure to be writable.

        The project is written with the `shapes` that come of it in place of those asked for, in that order.

        Raises
        ------
        RoamError
            when the plate cannot be opened, or was away for a while, or the target is in the way of another file.
        """
        with opened(str(self.project.require_clip().path), self.project.clip) as plate:
            require_target(self.target)
            sources = Sources.of(plate.source, self.source)
            require_free([(self.target, Kind.PROJECT)], sources, overwrite=self.overwrite, rewritten=self.source)
            with claimed(self.target):
                with cancelling() as token, progress_bar() as progress:
                    found = look(plate.read_or_bridge, token, progress)
                plate.require_read()
                self._write(shapes(found))
            return found

    def _write(self, shapes: Sequence[RotoShape]) -> None:
        project = self.project
        for old, new in zip(self.asked, shapes, strict=True):
            if new is not old:
                project = project.with_shape(new)
        self.writer(project)


def asked_shapes(project: Project, path: Path, names: Sequence[str] | None, verb: str) -> Sequence[RotoShape]:
    """The closed, unlocked shapes of these names or ids, all for None; `NothingToSolve` where there is none."""
    asked = trackable(project, Picking(names))
    if not asked:
        raise NothingToSolve(f"{path} holds no closed, unlocked shape to {verb}.")
    return asked
