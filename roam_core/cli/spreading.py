"""One project's gaps filled on several processes of this machine, and put together again."""

from __future__ import annotations

import sys
import tempfile
from collections.abc import Callable, Sequence
from pathlib import Path

from roam_core.cli.bar import bar
from roam_core.cli.keeping import kept
from roam_core.cli.performing import WORK
from roam_core.cli.picking import Picking
from roam_core.cli.spans import Gap, pieces_of, taken
from roam_core.params import RoamParams
from roam_core.roto import Project, file
from roam_core.studio import cluster, driver
from roam_core.studio.tasks import fill_task, pieces


def filled_apart(
    project: Project,
    gaps: Sequence[Gap],
    params: RoamParams,
    picking: Picking,
    workers: int,
    keep: Callable[[Project], None],
) -> Project:
    """The project with the keys of as many gaps as could be filled; it comes out as from one process.

    Each piece, a gap of one object, is a step of a batch on at most `workers` processes. What could not be filled is
    left to be filled here, where it is told why. `keep` is given what is finished, as it goes and however it ends.
    """
    divided = pieces_of(project, gaps, picking)
    with tempfile.TemporaryDirectory(prefix="roam-fill-") as folder:
        given = Path(folder) / "given.roam"
        file.save(project, given)
        task = fill_task(given, Path(folder) / "made", params.config, alone=picking.alone)
        parts, _ = pieces(task, divided)
        shares = cluster.Shares.here(min(workers, len(parts)))
        made = {part.step: part.made for part in parts}
        with (
            cluster.local(shares, dashboard=False, loading=WORK.modules) as client,
            kept(keep) as keeper,
            bar(len(parts), "{n}/{total} ") as shown,
        ):
            for outcome in driver.run(client, WORK, [[part] for part in parts]):
                shown.update()
                if outcome["status"] == "failed":
                    print(f"roam: {outcome['step']}: {outcome['said']}", file=sys.stderr)
                    continue
                project = taken(project, file.load(made[outcome["step"]]), gaps, params, picking)
                keeper.offer(project)
    return project
