"""The table of formats: every scene through every writer, and how far the judge's matte agrees with ours.

A cell is the least intersection over union of a scene's moments, of grey pixels: the sum of the lesser values over that
of the greater ones. Cells of one frame's formats take whole frames only.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange import EXPORTERS, ExportOptions
from roam_core.interchange.protocol import LossyExport
from roam_core.matte import render_matte
from roam_core.roto import Clip, Project
from tests.judges.coverage import overlap
from tests.judges.scenes import NAMES, SCENES, Scene


@dataclass(frozen=True)
class Judge:
    """Who reads what one writer wrote.

    Attributes
    ----------
    exporter : the writer's name.
    by : who judges, in a few words.
    matte : the matte `(h, w)` of a file at a moment.
    names : the names of its shapes, or None where the format has none.
    still : true for formats of one frame a file.
    least : what every cell must reach.
    step : differences up to this count as none: what a picture of few levels cannot tell apart.
    missing : why it cannot judge here, or nothing.
    """

    exporter: str
    by: str
    matte: Callable[[Path, Clip, float], Array]
    names: Callable[[Path], list[str]] | None = None
    still: bool = False
    least: float = 0.999
    step: float = 0.0
    missing: str = ""


@dataclass(frozen=True)
class Cell:
    """How one scene fared: the least overlap, and the sentences in which the writer refused to write it."""

    overlap: float
    losses: tuple[str, ...] = ()

    def __str__(self) -> str:
        return f"refused: {self.overlap:.3f}" if self.losses else f"{self.overlap:.4f}"


def judged(judge: Judge, scene: Scene, folder: Path) -> Cell:
    """The cell of a scene; what is refused is written all the same and judged, too."""
    losses = refusal(judge, scene.project, folder)
    moments = [moment for moment in scene.moments if not judge.still or moment == int(moment)]
    if not moments:
        moments = sorted({int(moment) for moment in scene.moments})
    found = [_overlap(judge, scene.project, moment, folder) for moment in moments]
    return Cell(min(found), losses)


def refusal(judge: Judge, project: Project, folder: Path) -> tuple[str, ...]:
    """The sentences in which a writer refuses a project; nothing is written then."""
    path = _path(judge, folder)
    path.unlink(missing_ok=True)
    try:
        EXPORTERS[judge.exporter].export(project, path, ExportOptions(frame=project.require_clip().first))
    except LossyExport as refused:
        assert not path.exists(), "what was refused was written"
        return refused.losses
    return ()


def _overlap(judge: Judge, project: Project, moment: float, folder: Path) -> float:
    clip = project.require_clip()
    path = _path(judge, folder)
    frame = int(moment) if judge.still else clip.first
    if judge.still or not path.exists():
        EXPORTERS[judge.exporter].export(project, path, ExportOptions(frame=frame, lossy=True))
    ours = render_matte(project, moment, (clip.size[1], clip.size[0])).astype(np.float64)
    theirs = judge.matte(path, clip, moment)
    return overlap(ours, np.where(np.abs(ours - theirs) <= judge.step, ours, theirs))


def _path(judge: Judge, folder: Path) -> Path:
    return folder / f"scene{EXPORTERS[judge.exporter].suffix}"


def names_kept(judge: Judge, folder: Path) -> tuple[int, int]:
    """How many of the scene's names another program shows, as they are or in a form of its own; and how many differ."""
    assert judge.names is not None
    project = SCENES["names"].project
    path = _path(judge, folder)
    EXPORTERS[judge.exporter].export(project, path, ExportOptions(frame=project.require_clip().first, lossy=True))
    found = judge.names(path)
    return sum(name in found for name in NAMES), len(set(found))


def rows(judges: list[Judge], folder: Path) -> Iterator[list[str]]:
    """The table's rows: who judges, a scene each, and the names."""
    able = [judge for judge in judges if not judge.missing]
    for name, scene in SCENES.items():
        cells = []
        for judge in able:
            place = folder / f"{judge.exporter} {len(name)}"
            place.mkdir(exist_ok=True)
            cells.append(str(judged(judge, scene, place)))
            for left in place.iterdir():
                left.unlink()
        yield [name, *cells]


def table(judges: list[Judge], folder: Path) -> str:
    """The table in Markdown."""
    able = [judge for judge in judges if not judge.missing]
    head = ["scene", *(judge.exporter for judge in able)]
    lines = [head, ["---", *("---:" for _ in able)], *rows(able, folder)]
    told = ["names as they are, of " + str(len(NAMES))]
    for judge in able:
        told.append("–" if judge.names is None else f"{names_kept(judge, folder)[0]}")
    lines.append(told)
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


__all__ = ["Cell", "Judge", "judged", "names_kept", "refusal", "replace", "table"]
