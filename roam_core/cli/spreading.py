"""One project's gaps filled on several processes of this machine, and put together again."""

from __future__ import annotations

import sys
from collections.abc import Iterator, Sequence
from dataclasses import dataclass

from roam_core.cancel import CancelToken
from roam_core.cli.bar import bar
from roam_core.cli.keeping import Write, kept
from roam_core.cli.performing import WORK
from roam_core.cli.picking import Picking
from roam_core.cli.spans import Piece, pieces_of, taken
from roam_core.params import RoamParams
from roam_core.propagate.shapes.gaps import Gap
from roam_core.roto import Project, file
from roam_core.studio import cluster, driver
from roam_core.studio.tasks import fill_task, pieces
from roam_core.temporary import working_folder

FOLDER = "roam-fill"


@dataclass(frozen=True)
class FilledPiece:
    """A piece that ended: the project with its keys, or None where it could not be filled, and what was said of it."""

    gap: Gap
    made: Project | None
    said: str


def filled_apart(
    project: Project,
    gaps: Sequence[Gap],
    params: RoamParams,
    picking: Picking,
    workers: int,
    keep: Write,
) -> Project:
    """The project with the keys of as many gaps as could be filled; it comes out as from one process.

    Each piece, a gap of one object, is a step of a batch on at most `workers` processes. What could not be filled is
    left to be filled here, where it is told why. `keep` is given what is finished, as it goes and however it ends.
    """
    divided = pieces_of(project, gaps, picking)
    with kept(keep) as keeper, bar(len(divided), "{n}/{total} ") as shown:
        for piece in spread(project, divided, params, workers, alone=picking.alone):
            shown.update()
            if piece.made is None:
                print(f"roam: {piece.said}", file=sys.stderr)
            else:
                project = taken(project, piece.made, gaps, params, picking)
                keeper.offer(project)
    return project


def spread(
    project: Project,
    divided: Sequence[Piece],
    params: RoamParams,
    workers: int,
    *,
    alone: bool,
    token: CancelToken | None = None,
) -> Iterator[FilledPiece]:
    """Fill pieces of a project on at most `workers` processes of this machine; yields each as it ends.

    Raises `Cancelled` when the token is cancelled: what runs is stopped at its next safe point.
    """
    with working_folder(FOLDER) as folder:
        given = folder / "given.roam"
        file.save(project, given)
        task = fill_task(given, folder / "made", params.config, alone=alone)
        parts, _ = pieces(task, divided)
        by_step = {part.step: part for part in parts}
        shares = cluster.Shares.here(min(workers, len(parts)))
        with cluster.local(shares, dashboard=False, loading=WORK.modules) as client:
            for outcome in driver.run(client, WORK, [[part] for part in parts], token=token):
                part = by_step[outcome["step"]]
                first, last = part.settings["span"]
                made = None if outcome["status"] == "failed" else file.load(part.made)
                yield FilledPiece((first, last), made, f"{part.step}: {outcome['said']}")
