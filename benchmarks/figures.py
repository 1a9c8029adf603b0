"""Shots of figures in parts, with the truth of every part: the project's own walker, and the puppet beside it.

The walker is `resources.walker`. The puppet is a program in `../shared/bench` that puts limbs of real cloth over a real
picture; its shots are rendered once, into `out/benchmarks/puppets`.
"""

from __future__ import annotations

import json
import subprocess
import sys
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path

import cv2
import numpy as np

from benchmarks import report, shots
from resources import walker
from roam_core.arrays import Array, Bools, Image
from roam_core.errors import RoamError
from roam_core.kernels.coverage import coverage

PUPPET = shots.SHARED / "bench" / "puppet.py"
ABSENT = (
    "The puppets are left out: they want the program ../shared/bench/puppet.py and DAVIS 2016 in "
    "../shared/data/davis2016-train beside the repository."
)
SHOWN = 0.5
"""Share of a part that must be seen on the first frame: an artist draws what can be seen there."""
HALF_A_PIXEL = np.array([[1.0, 0.0, 0.5], [0.0, 1.0, 0.5], [0.0, 0.0, 1.0]])
"""From the puppet's pixels, whose centres lie at whole numbers, to ours."""


@dataclass(frozen=True, eq=False)
class Figure:
    """A shot of frames 0, 1, ... and the truth of its parts.

    Attributes
    ----------
    pictures : (h, w, 3) RGB. order : the names of the parts, the farthest first.
    lines : by part, its whole outline `(K, 2)` on every frame; a vertex is the same place of the part on all of them.
    motions : by part, the affine motion `(3, 3)` of every frame, from the part's own coordinates to the picture.
    """

    name: str
    pictures: Sequence[Image]
    order: tuple[str, ...]
    lines: dict[str, Sequence[Array]]
    motions: dict[str, Sequence[Array]]
    _masks: dict[tuple[str, int], Bools] = field(default_factory=dict, repr=False)

    @property
    def frames(self) -> range:
        return range(len(self.pictures))

    @property
    def size(self) -> tuple[int, int]:
        """(h, w)."""
        return self.pictures[0].shape[0], self.pictures[0].shape[1]

    def read(self, frame: int) -> Image:
        """The picture of a frame, as `roam_core.track` asks for it."""
        return self.pictures[frame]

    def whole(self, part: str, frame: int) -> Bools:
        """The pixels of a part, seen or hidden."""
        if (part, frame) not in self._masks:
            self._masks[part, frame] = np.asarray(coverage(self.lines[part][frame], self.size) > 0.5)
        return self._masks[part, frame]

    def union(self, parts: Sequence[str], frame: int) -> Bools:
        """The pixels of any of these parts."""
        found = np.zeros(self.size, dtype=bool)
        for part in parts:
            found |= self.whole(part, frame)
        return found

    def hidden(self, part: str, frame: int) -> Bools:
        """The pixels of a part that a nearer one covers."""
        nearer = self.order[self.order.index(part) + 1 :]
        return self.whole(part, frame) & self.union(nearer, frame)

    @property
    def drawn(self) -> tuple[str, ...]:
        """The parts that are seen well enough on the first frame to be drawn there, in their order."""
        return tuple(
            part for part in self.order if self.hidden(part, 0).sum() < (1.0 - SHOWN) * self.whole(part, 0).sum()
        )

    def since(self, part: str, frame: int) -> Array:
        """The true motion `(3, 3)` of a part from the first frame to another."""
        return np.asarray(self.motions[part][frame] @ np.linalg.inv(self.motions[part][0]))


def of_walker(seed: int, count: int) -> Figure:
    """The first `count` frames of a walk."""
    walk = walker.Walker(seed)
    moments = range(walker.FIRST, walker.FIRST + count)
    return Figure(
        f"walker {seed}",
        [walk.render(moment) for moment in moments],
        walker.ORDER,
        {part: [walk.line(part, moment) for moment in moments] for part in walker.ORDER},
        {part: [_square(walk.affine(part, moment)) for moment in moments] for part in walker.ORDER},
    )


def has_puppets() -> bool:
    """True where the puppet and what it is made of are."""
    return PUPPET.is_file() and shots.FOLDER.is_dir()


def of_puppet(seed: int, count: int) -> Figure:
    """The first `count` frames of a puppet's shot, rendered when it is first asked for."""
    folder = report.OUT / "puppets" / str(seed)
    if not (folder / "truth.json").is_file():
        folder.mkdir(parents=True, exist_ok=True)
        subprocess.run([sys.executable, str(PUPPET), str(shots.FOLDER), str(seed), str(folder)], check=True)
    truth = json.loads((folder / "truth.json").read_text(encoding="utf-8"))
    parts = truth["parts"]
    back = np.linalg.inv(HALF_A_PIXEL)
    return Figure(
        f"puppet {seed}",
        [_picture(folder / "frames" / f"{frame:05d}.jpg") for frame in range(count)],
        tuple(truth["order"]),
        {part: [np.array(line) + 0.5 for line in parts[part]["outline"][:count]] for part in parts},
        {part: [HALF_A_PIXEL @ _square(m) @ back for m in parts[part]["affine"][:count]] for part in parts},
    )


def _square(matrix: Array | Sequence[Sequence[float]]) -> Array:
    return np.vstack([matrix, [0.0, 0.0, 1.0]])


def _picture(path: Path) -> Image:
    image = cv2.imread(str(path))
    if image is None:
        raise RoamError(f"{path} cannot be read; delete its folder, and it is rendered again.")
    return np.asarray(cv2.cvtColor(image, cv2.COLOR_BGR2RGB))
