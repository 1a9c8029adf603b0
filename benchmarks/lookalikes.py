"""Lookalikes: the object of a shot with its own copy beside it, as one of two players of a team or two cars of a kind.

The copy lies behind the object, so what is true of that stays true. It goes beside it, or comes near from far off until
the two touch. The same frames without a copy are tracked, too.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable
from dataclasses import dataclass

import cv2
import numpy as np

from benchmarks import processes, report, shots
from roam_core.arrays import Bools, Image
from roam_core.params import params_for

STARTS = 0, 20, 40
"""Frames of a shot from which its runs begin, or the last from which they can."""
LENGTH = 12
"""Frames that are predicted from a key."""
BESIDE = 1.15
"""How far from the object its copy goes beside it, from middle to middle, as a multiple of its width."""
FAR, NEAR = 2.2, 1.0
"""How far away a copy that comes near is on the key and on the last frame."""
SOFT = 0.8
"""Standard deviation, in pixels, by which the copy's edge is softened."""

AWAY: dict[str, Callable[[int], float]] = {
    "goes beside it": lambda k: BESIDE,
    "comes near": lambda k: FAR + (NEAR - FAR) * k / LENGTH,
}
"""By what the copy does: how many widths it is away, k frames after the key."""


@dataclass(frozen=True)
class Run:
    """A run of a shot from a frame: what its object's copy does (a name in `AWAY`), None without one."""

    shot: str
    start: int
    copy: str | None


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `lookalikes` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Track the objects of all shots beside their copies and without, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    jobs = [(Run(name, start, copy), given.config) for name in chosen for start in STARTS for copy in (None, *AWAY)]
    measures = processes.each(measured, jobs)
    found = {(each.shot, each.start, each.copy): mean for (each, _), mean in zip(jobs, measures, strict=True)}
    by_shot = {
        name: [float(np.mean([found[name, k, copy] for k in STARTS])) for copy in (None, *AWAY)] for name in chosen
    }
    text, is_all = _text(by_shot, given.config), given.shots is None
    result = {"config": given.config, "shots": by_shot}
    report.write("lookalikes" if is_all else "lookalikes some", text, result, publish=given.publish and is_all)


def measured(job: tuple[Run, str]) -> float:
    """The mean IoU of a run by a configuration."""
    asked, config = job
    shot = shots.load(asked.shot)
    first = min(shot.first + asked.start, shot.last - LENGTH)
    frames = range(first, first + LENGTH + 1)
    masks = [shot.mask(frame) for frame in frames]

    def read(k: int) -> Image:
        if asked.copy is None:
            return shot.read(frames[k])
        return with_copy(shot.read(frames[k]), masks[k], _offset(masks[0], AWAY[asked.copy](k)))

    return float(np.mean([iou for iou, _ in shots.tracked(read, masks, config)]))


def _offset(mask: Bools, widths: float) -> int:
    """Pixels by which a copy that is so many `widths` of the object away lies to its right, negative to its left.

    It lies where, by the `mask` on the key, there is more room.
    """
    columns = np.flatnonzero(mask.any(axis=0))
    if len(columns) == 0:
        return 0
    side = 1 if columns[0] + columns[-1] < mask.shape[1] else -1
    return round(side * widths * float(np.ptp(columns) + 1))


def with_copy(picture: Image, mask: Bools, offset: int) -> Image:
    """A picture with a copy of what its mask shows `offset` pixels to the right, behind the object itself."""
    move = np.array([[1.0, 0.0, offset], [0.0, 1.0, 0.0]])
    size = mask.shape[1], mask.shape[0]
    copied = cv2.warpAffine(picture, move, size)
    cover = cv2.warpAffine(mask.astype(np.float32), move, size)
    share = np.where(mask, np.float32(0.0), cv2.GaussianBlur(cover, (0, 0), SOFT))[..., None]
    mixed = share * copied + (1.0 - share) * picture
    return np.asarray(np.round(mixed) if picture.dtype == np.uint8 else mixed, dtype=picture.dtype)


def _text(by_shot: dict[str, list[float]], config: str) -> str:
    rows = [[name, *(f"{iou:.3f}" for iou in means)] for name, means in by_shot.items()]
    mean = np.mean(list(by_shot.values()), axis=0)
    rows.append([f"**mean of {len(by_shot)} shots**", *(f"**{iou:.3f}**" for iou in mean)])
    title = f"Objects beside their own copies, {LENGTH} frames from three starts, configuration `{config}`. "
    table = report.table(["shot", "without a copy", *(f"a copy that {copy}" for copy in AWAY)], rows)
    return f"{title}{report.circumstances()}.\n\n{table}"
