"""The shots that lie beside the repository, in `../shared`, held in memory: pictures, true masks, and their overlap."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from benchmarks import report
from roam_core import render_matte, shapes_from_mask, track
from roam_core.arrays import Bools, Image
from roam_core.errors import RoamError
from roam_core.matte.vectorise import coverage_of, read_mask
from roam_core.media import open_clip
from roam_core.media.colour import to_engine
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.roto import RotoShape

SHARED = report.ROOT.parent / "shared"
FOLDER = SHARED / "data" / "davis2016-train"
SCORE = SHARED / "bench" / "score.py"
ABSENT = (
    "The shots are not here: this wants DAVIS 2016 in ../shared/data/davis2016-train (JPEGImages and Annotations) and "
    "the scoring program ../shared/bench/score.py beside the repository."
)


@dataclass(frozen=True, eq=False)
class Shot:
    """Pictures `(h, w, 3)` RGB and true masks `(h, w)` bool of the frames `first`, `first + 1`, ..."""

    name: str
    first: int
    pictures: Sequence[Image]
    masks: Sequence[Bools]

    @property
    def frames(self) -> range:
        """All frames, by the plate's numbers."""
        return range(self.first, self.first + len(self.pictures))

    @property
    def last(self) -> int:
        return self.frames[-1]

    @property
    def size(self) -> tuple[int, int]:
        """(h, w)."""
        return self.masks[0].shape[0], self.masks[0].shape[1]

    def read(self, frame: int) -> Image:
        """The picture of a frame, as `roam_core.track` asks for it."""
        return self.pictures[frame - self.first]

    def mask(self, frame: int) -> Bools:
        """The true mask of a frame."""
        return self.masks[frame - self.first]


def is_present() -> bool:
    """True where the shots and the scoring program are."""
    return FOLDER.is_dir() and SCORE.is_file()


def names(wanted: str | None = None) -> list[str]:
    """The shots named in `wanted` ("a,b"), or all.

    Raises
    ------
    RoamError
        when the shots are not beside the repository, or one of that name is not among them.
    """
    if not is_present():
        raise RoamError(ABSENT)
    there = sorted(folder.name for folder in (FOLDER / "JPEGImages").iterdir())
    chosen = wanted.split(",") if wanted else there
    unknown = sorted(set(chosen) - set(there))
    if unknown:
        raise RoamError(f"There is no shot {unknown[0]!r}; choose from {', '.join(there)}.")
    return chosen


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What a benchmark of one configuration that publishes a table of the shots may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument("--shots", metavar="A,B", help="these shots only")
    parser.add_argument("--publish", action="store_true", help="put the table into docs/BENCHMARKS.md")


@lru_cache(maxsize=3)
def load(name: str) -> Shot:
    """A shot, decoded once for the process while it is among the last few asked for."""
    plate = open_clip(FOLDER / "JPEGImages" / name)
    size = plate.size[1], plate.size[0]
    pictures, masks = [], []
    for frame in plate.frames:
        pictures.append(to_engine(plate.read(frame), plate.colour_space))
        path = FOLDER / "Annotations" / name / f"{plate.frame_name(frame)}.png"
        masks.append(coverage_of(read_mask(path, size)) > 0.5)
    return Shot(name, plate.frames[0], pictures, masks)


def first_shapes(shot: Shot) -> list[RotoShape]:
    """The shapes of the first frame, from its true mask."""
    return shapes_from_mask(shot.mask(shot.first), shot.first)


def tracked(
    read: Callable[[int], Image], masks: Sequence[Bools], config: str, hidden: Sequence[Bools] | None = None
) -> list[tuple[float, float]]:
    """What is tracked from the first of true masks, on every further frame: IoU with its mask, and confidence.

    `read(k)` gives the picture that `masks[k]` belongs to, of which what is `hidden[k]` does not count. Of several
    shapes the confidence is their mean.
    """
    found = []
    for result in track(read, shapes_from_mask(masks[0]), range(len(masks)), config):
        if result.frame > 0:
            ours, true = (
                matte([each.shape for each in result.results], result.frame, masks[0].shape),
                masks[result.frame],
            )
            if hidden is not None:
                ours, true = ours & ~hidden[result.frame], true & ~hidden[result.frame]
            sure = float(np.mean([each.confidence for each in result.results]))
            found.append((overlap(ours, true), sure))
    return found


def overlap(ours: Bools, true: Bools) -> float:
    """Intersection over union; 1 for two empty masks."""
    union = int(np.count_nonzero(ours | true))
    return int(np.count_nonzero(ours & true)) / union if union else 1.0


def matte(shapes: Sequence[RotoShape], frame: int, size: tuple[int, int]) -> Bools:
    """The pixels `(h, w)` that the shapes cover by more than half."""
    return np.asarray(render_matte(shapes, frame, size) > 0.5)
