"""Kills an artist at any moment, and looks what is left: the saved project opens, and hardly anything else is lost."""

from __future__ import annotations

import argparse
import json
import random
import shutil
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from pathlib import Path

from app.journal import recovery
from roam_core.errors import RoamError
from roam_core.media import open_clip
from roam_core.roto import Clip, Project, edit, file
from tests.conftest import ROOT
from tests.endurance.artist import MODES, NOTES, SQUARE, TRACKING, UNTITLED, WORK
from tests.endurance.environment import environment
from tests.gui.windows import write_clip

READY, LATEST = 240.0, 2.5
"""Seconds after which an artist that notes nothing is stuck, and up to which one that works is killed."""
FRAMES = 24


@dataclass(frozen=True)
class Outcome:
    """What was left of one artist: how many edits were committed, recovered and lost, and the seconds they took."""

    mode: str
    after: float
    committed: int
    recovered: int
    lost_edits: int
    lost_seconds: float
    opens: bool

    @property
    def is_kept(self) -> bool:
        """At most one edit or one second is gone, and what was saved opens."""
        return self.opens and (self.lost_edits <= 1 or self.lost_seconds <= 1.0)


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `kill` may be told."""
    parser.add_argument("--times", type=int, default=200, metavar="N", help="how often (default 200)")
    parser.add_argument("--seed", type=int, default=0, metavar="S", help="of the moments (default 0)")
    parser.add_argument("--out", type=Path, metavar="FILE", help="write every outcome as JSON")


def run(given: argparse.Namespace) -> int:
    """Kill so many artists, print what was lost, and fail where it was too much."""
    moments = random.Random(given.seed)
    outcomes = []
    with tempfile.TemporaryDirectory() as folder:
        clip = write_clip(Path(folder) / "plate", FRAMES)
        for index in range(given.times):
            place = Path(folder) / f"{index:04d}"
            outcomes.append(outcome(place, clip, MODES[index % len(MODES)], moments.uniform(0.0, LATEST)))
            shutil.rmtree(place)
    print(report(outcomes))
    if given.out is not None:
        given.out.write_text(json.dumps([asdict(each) for each in outcomes], indent=1), encoding="utf-8")
    return 0 if all(each.is_kept for each in outcomes) else 1


def outcome(folder: Path, clip: Path, mode: str, after: float, *, flushed: bool = False) -> Outcome:
    """Let an artist work in `folder` and kill it so many seconds after its first edit.

    `flushed`: only what the journal said to be on the disk counts as committed.
    """
    folder.mkdir()
    if mode != UNTITLED:
        project, _ = edit.new_shape(Project(Clip.of(open_clip(clip))), SQUARE, 1001, name="0")
        file.save(project, folder / WORK)
    command = [sys.executable, "-m", "tests.endurance.artist", mode, str(folder), *(["flushed"] if flushed else [])]
    artist = subprocess.Popen(
        command,
        env=environment(folder),
        cwd=ROOT,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    deadline = time.monotonic() + READY
    while not notes(folder):
        if artist.poll() is not None or time.monotonic() > deadline:
            artist.kill()
            raise SystemExit(f"kill: the artist ({mode}) did not begin to work")
        time.sleep(0.02)
    time.sleep(after)
    artist.kill()
    artist.wait()
    return judged(folder, mode, after)


def judged(folder: Path, mode: str, after: float) -> Outcome:
    """What is left in a folder in which an artist was killed."""
    noted = notes(folder)
    opens, saved = mode == UNTITLED, 0
    if mode != UNTITLED:
        try:
            saved, opens = number(file.load(folder / WORK), mode), True
        except RoamError as error:
            print(f"{mode}: {error}", file=sys.stderr)
    recovered = max([saved, *(number(project, mode) for project in recoveries(folder / "state"))])
    ahead = [when for made, when in noted if made > recovered]
    lost = max(noted[-1][0] - recovered, 0)
    return Outcome(mode, after, noted[-1][0], recovered, lost, noted[-1][1] - ahead[0] if ahead else 0.0, opens)


def notes(folder: Path) -> list[tuple[int, float]]:
    """What the artist has noted: the number of each edit, and when."""
    if not (folder / NOTES).exists():
        return []
    lines = (folder / NOTES).read_text(encoding="ascii").splitlines()
    return [(int(made), float(when)) for made, when in (line.split() for line in lines)]


def recoveries(states: Path) -> list[Project]:
    """All projects that the next start would offer to recover, and that can be."""
    found = []
    for each in recovery.offered(recovery.recoveries(states / "roam" / "journal")):
        try:
            found.append(recovery.load(each)[0])
        except RoamError as error:
            print(error, file=sys.stderr)
    return found


def number(project: Project, mode: str) -> int:
    """How far the artist had come in a project."""
    shape = project.shapes[0]
    return len(shape.keys) if mode == TRACKING else int(shape.name)


def report(outcomes: Sequence[Outcome]) -> str:
    """A table: how often, how much was committed, and the most that was lost."""
    count = Counter(each.mode for each in outcomes)
    lines = [
        "| | killed | edits committed | edits lost, most | seconds lost, most | kept |",
        "|---|---|---|---|---|---|",
    ]
    for mode in count:
        own = [each for each in outcomes if each.mode == mode]
        kept = sum(each.is_kept for each in own)
        lines.append(
            f"| {mode} | {len(own)} | {sum(each.committed for each in own)} | {max(each.lost_edits for each in own)} "
            f"| {max(each.lost_seconds for each in own):.2f} | {kept} of {len(own)} |"
        )
    return "\n".join(lines)
