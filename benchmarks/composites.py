"""Composites: the object of each shot over the pictures of other shots, whose own objects pass behind it; or before it.

The shots have one thing each that moves by itself; films have passers-by. Objects and surroundings meet here that no
parameter was chosen on together. The other shot runs backwards, and what moves in it stays in the picture. With
`--in-front` each shot is as it is, and the object of another one, scaled to its size, passes before its own from the
left to the right; what it hides does not count.
"""

from __future__ import annotations

import argparse
from collections.abc import Sequence

import cv2
import numpy as np

from benchmarks import processes, report, shots
from benchmarks.shots import Shot
from roam_core.arrays import Array, Bools, Image
from roam_core.params import params_for

PLATES = 5, 11, 17
"""By how many places the other shots lie after that of the object, in the order of their names."""
LENGTH = 48
"""Frames that are predicted from the first one, at most."""
CROSSING = 36
"""Frames that it takes to pass in front."""
ASIDE = 6.0
"""Pixels that lie between the two on the first and on the last of them."""
LARGEST = 0.8, 1.0
"""Width and height of what passes in front, as shares of the object's, at most."""
SOFT = 0.8
"""Standard deviation, in pixels, by which the object's edge is softened, after a pixel was taken off around it."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `composites` may be told."""
    shots.add_arguments(parser)
    parser.add_argument(
        "--in-front", action="store_true", help="the other shots' objects pass before those of the shots"
    )


def run(given: argparse.Namespace) -> None:
    """Track the objects of all shots before others, and report."""
    params_for(given.config)
    chosen, every = shots.names(given.shots), shots.names()
    plates = {name: [every[(every.index(name) + places) % len(every)] for places in PLATES] for name in chosen}
    jobs = [(name, plate, given.config, given.in_front) for name in chosen for plate in plates[name]]
    measures = processes.each(measured, jobs)
    found = {(name, plate): each for (name, plate, *_), each in zip(jobs, measures, strict=True)}
    text, is_all = _text(plates, found, given.config, in_front=given.in_front), given.shots is None
    result = {"config": given.config, "shots": {f"{name} / {plate}": each for (name, plate), each in found.items()}}
    block = ("composites in front" if given.in_front else "composites") + ("" if is_all else " some")
    report.write(block, text, result, publish=given.publish and is_all)


def measured(job: tuple[str, str, str, bool]) -> tuple[float, float]:
    """Of the object of a shot with another one behind it, or in front of it: mean IoU, mean confidence."""
    name, plate, config, in_front = job
    shot, other = shots.load(name), shots.load(plate)
    pictures, masks, hidden = crossed(shot, other) if in_front else (*composed(shot, other), None)
    iou, confidence = np.mean(shots.tracked(pictures.__getitem__, masks, config, hidden), axis=0)
    return float(iou), float(confidence)


def composed(shot: Shot, plate: Shot) -> tuple[list[Image], list[Bools]]:
    """The object of `shot` over the pictures of `plate`, from its last one backwards, and the object's masks."""
    count = min(len(shot.pictures), len(plate.pictures), LENGTH + 1)
    below = list(reversed(plate.pictures))
    masks = list(shot.masks[:count])
    return [_over(*each) for each in zip(shot.pictures[:count], masks, below[:count], strict=True)], masks


def crossed(shot: Shot, other: Shot) -> tuple[list[Image], list[Bools], list[Bools]]:
    """`shot` with the object of `other` passing in front of its own; its object's masks, and what is hidden of them.

    The other object moves as it does in its shot, from the last picture backwards and on again where there are few.
    """
    count = min(len(shot.pictures), CROSSING + 1)
    there = [*range(len(other.pictures) - 1, -1, -1), *range(len(other.pictures))]
    masks, size, found, hidden = list(shot.masks[:count]), None, [], []
    for k, (picture, mask, way) in enumerate(zip(shot.pictures, masks, np.linspace(-1.0, 1.0, count), strict=False)):
        theirs, their_mask = other.pictures[there[k % len(there)]], other.masks[there[k % len(there)]]
        if not (mask.any() and their_mask.any()):
            found.append(picture)
            hidden.append(np.zeros_like(mask))
            continue
        (middle, extent), (their_middle, their_extent) = _box(mask), _box(their_mask)
        size = size or min(1.0, *(LARGEST * extent / their_extent))
        aside = way * (0.5 * (extent[0] + size * their_extent[0]) + ASIDE), 0.0
        carry = np.column_stack([size * np.eye(2), middle + aside - size * their_middle])
        before, before_mask = (
            cv2.warpAffine(each, carry, mask.shape[::-1]) for each in (theirs, their_mask.astype(np.uint8))
        )
        found.append(_over(np.asarray(before), np.asarray(before_mask) > 0, picture))
        hidden.append((np.asarray(before_mask) > 0) & mask)
    return found, masks, hidden


def _box(mask: Bools) -> tuple[Array, Array]:
    """The middle and the extent `(2,)` of a mask, x and y, pixels."""
    ends = [np.flatnonzero(mask.any(axis=axis))[[0, -1]] for axis in (0, 1)]
    return np.mean(ends, axis=1) + 0.5, np.diff(ends, axis=1)[:, 0] + 1.0


def _over(picture: Image, mask: Bools, below: Image) -> Image:
    """What a mask shows of a picture, over another picture."""
    height, width = mask.shape
    if below.shape[:2] != mask.shape:
        below = np.asarray(cv2.resize(below, (width, height), interpolation=cv2.INTER_AREA))
    if below.dtype != picture.dtype:
        below = below / np.float32(255.0) if below.dtype == np.uint8 else below * np.float32(255.0)
    core = cv2.erode(mask.astype(np.float32), np.ones((3, 3), np.uint8))
    share = cv2.GaussianBlur(core, (0, 0), SOFT)[..., None]
    mixed = share * picture + (1.0 - share) * below
    return np.asarray(np.round(mixed) if picture.dtype == np.uint8 else mixed, dtype=picture.dtype)


def _text(
    plates: dict[str, list[str]], found: dict[tuple[str, str], tuple[float, float]], config: str, *, in_front: bool
) -> str:
    rows = [[name, *_cells([found[name, plate] for plate in below])] for name, below in plates.items()]
    mean = _cells([found[name, plate] for name, below in plates.items() for plate in below])[-2:]
    rows.append([f"**mean of {len(found)} runs**", *([""] * len(PLATES)), *(f"**{cell}**" for cell in mean)])
    headings = ["object", *(f"{places} on" for places in PLATES), "IoU", "confidence"]
    what, length = ("Other objects in front", CROSSING) if in_front else ("Objects over other shots", LENGTH)
    title = f"{what}, up to {length} frames, configuration `{config}`. {report.circumstances()}."
    return f"{title}\n\n{report.table(headings, rows)}"


def _cells(measures: Sequence[tuple[float, float]]) -> list[str]:
    """The IoU of each run, their mean, and the mean confidence."""
    return [f"{value:.3f}" for value in (*(iou for iou, _ in measures), *np.mean(measures, axis=0))]
