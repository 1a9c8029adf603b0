"""Altered shots: the object beside its own copy, behind a trunk, in haze or shadow, zoomed, shaken or out of focus.

A copy, as one of two players of a team or two cars of a kind, lies behind the object, so what is true of that stays
true. It goes beside it, or comes near from far off until the two touch. What a trunk hides is not true of it. The
same frames are tracked as they are, too.
"""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from benchmarks import processes, report, shots
from roam_core.arrays import Array, Bools, Image
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
ZOOM = 2.2
"""How many times as large the shot is seen where the camera is nearest."""
SHAKEN = 12.0, 1.5, 1.15
"""Standard deviations of a frame's place, in pixels, and turn, in degrees; how much larger a shaken shot is seen."""
DEFOCUS = 4.0
"""Standard deviation, in pixels, of the blur on the last frame."""
HAZE = 0.7, 0.75
"""How much of the last frame is haze, and how bright that is."""

SHADOW = 0.55, 3.0
"""How much darker a shadow is, and how softly it ends, in pixels."""

TRUNK = 0.15
"""How wide the trunk is, as a share of the picture's width."""
BARK = (100.0, 80.0, 57.0), 0.3
"""Its mean colour, in levels of 255, and by which share of that it deviates from place to place."""

Frames = tuple[list[Image], list[Bools]]
"""The pictures of a run, and their true masks."""


@dataclass(frozen=True)
class Run:
    """A run of a shot from a frame, altered as a name in `ALTERATIONS` says."""

    shot: str
    start: int
    alteration: str


def beside_its_copy(pictures: Sequence[Image], masks: Sequence[Bools], widths: Sequence[float]) -> Frames:
    """The object with its copy, which is by frame so many `widths` of the object away."""
    offsets = [_offset(masks[0], each) for each in widths]
    return [with_copy(*each) for each in zip(pictures, masks, offsets, strict=True)], list(masks)


def zoomed(pictures: Sequence[Image], masks: Sequence[Bools], zooms: Sequence[float]) -> Frames:
    """As seen by frame so many times as large, about the middle of the object where the picture reaches so far."""
    (height, width), size = masks[0].shape, np.array(masks[0].shape[::-1], dtype=np.float64)
    ends = [_middle(masks[0]), _middle(masks[-1])]
    views = []
    for zoom, u in zip(zooms, np.linspace(0.0, 1.0, len(zooms)), strict=True):
        half = 0.5 * size / zoom
        x, y = np.clip((1.0 - u) * ends[0] + u * ends[1], half, size - half)
        views.append(np.array([[zoom, 0.0, 0.5 * width - zoom * x], [0.0, zoom, 0.5 * height - zoom * y]]))
    return _seen(pictures, masks, views)


def shaken(pictures: Sequence[Image], masks: Sequence[Bools]) -> Frames:
    """As seen by a camera that is shaken from frame to frame, the same way in each shot."""
    random = np.random.default_rng(0)
    (height, width), (pixels, degrees, zoom) = masks[0].shape, SHAKEN
    views = []
    for _ in pictures:
        view = cv2.getRotationMatrix2D((width / 2, height / 2), random.normal(0.0, degrees), zoom)
        view[:, 2] += random.normal(0.0, pixels, 2)
        views.append(view)
    return _seen(pictures, masks, views)


def defocused(pictures: Sequence[Image], masks: Sequence[Bools]) -> Frames:
    """As the focus goes away from frame to frame; sharp on the first."""
    sigmas = np.linspace(0.0, DEFOCUS, len(pictures))
    return [cv2.GaussianBlur(p, (0, 0), s) if s > 0 else p for p, s in zip(pictures, sigmas, strict=True)], list(masks)


def hazy(pictures: Sequence[Image], masks: Sequence[Bools]) -> Frames:
    """As haze comes up from frame to frame; none is on the first."""
    most, grey = HAZE
    found = []
    for picture, share in zip(pictures, np.linspace(0.0, most, len(pictures)), strict=True):
        is_levels = picture.dtype == np.uint8
        mixed = (1.0 - share) * picture + share * grey * (255.0 if is_levels else 1.0)
        found.append(np.asarray(np.round(mixed) if is_levels else mixed, dtype=picture.dtype))
    return found, list(masks)


def shadowed(pictures: Sequence[Image], masks: Sequence[Bools]) -> Frames:
    """As a shadow comes in from the left, until it lies over all of the picture; none is on the first."""
    darker, soft = SHADOW
    columns, found = np.arange(masks[0].shape[1]) + 0.5, []
    for picture, edge in zip(pictures, np.linspace(-4.0 * soft, len(columns) + 4.0 * soft, len(pictures)), strict=True):
        light = 1.0 - darker / (1.0 + np.exp((columns - edge) / soft))
        lit = light[:, None] * picture
        found.append(np.asarray(np.round(lit) if picture.dtype == np.uint8 else lit, dtype=picture.dtype))
    return found, list(masks)


def behind_a_trunk(pictures: Sequence[Image], masks: Sequence[Bools]) -> Frames:
    """As a trunk goes before the object from its left to its right; it lies beside it on the first frame."""
    height, width = masks[0].shape
    bark = _bark(height, round(TRUNK * width))
    wide, columns = bark.shape[1], np.arange(width)
    half = 0.5 * (_width(masks[0]) + wide) + 3.0
    found, seen = [], []
    for picture, mask, way in zip(pictures, masks, np.linspace(-half, half, len(masks)), strict=True):
        of_trunk = columns - round(_middle(mask)[0] + way - 0.5 * wide)
        hidden = (of_trunk >= 0) & (of_trunk < wide)
        is_levels = picture.dtype == np.uint8
        before = picture.copy()
        before[:, hidden] = bark[:, of_trunk[hidden]] if is_levels else bark[:, of_trunk[hidden]] / 255.0
        found.append(before)
        seen.append(mask & ~hidden)
    return found, seen


def _bark(height: int, width: int) -> Array:
    """The picture `(height, width, 3)` of a trunk, in levels of 255."""
    noise = cv2.GaussianBlur(np.random.default_rng(0).normal(size=(height, width)), (0, 0), sigmaX=1.2, sigmaY=9.0)
    colour, share = BARK
    return np.asarray(np.clip(np.array(colour) * (1.0 + share * noise / noise.std())[..., None], 0.0, 255.0))


ALTERATIONS: dict[str, Callable[[Sequence[Image], Sequence[Bools]], Frames]] = {
    "as it is": lambda pictures, masks: (list(pictures), list(masks)),
    "a copy beside it": lambda pictures, masks: beside_its_copy(pictures, masks, [BESIDE] * len(masks)),
    "a copy comes near": lambda pictures, masks: beside_its_copy(pictures, masks, np.linspace(FAR, NEAR, len(masks))),
    "pulled out": lambda pictures, masks: zoomed(pictures, masks, np.geomspace(ZOOM, 1.0, len(masks))),
    "pushed in": lambda pictures, masks: zoomed(pictures, masks, np.geomspace(1.0, ZOOM, len(masks))),
    "shaken": shaken,
    "out of focus": defocused,
    "in haze": hazy,
    "in shadow": shadowed,
    "behind a trunk": behind_a_trunk,
}
"""By name what becomes of the pictures and the masks of a run, the key first."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `altered` may be told."""
    shots.add_arguments(parser)


def run(given: argparse.Namespace) -> None:
    """Track the objects of all shots, altered in every way and as they are, and report."""
    params_for(given.config)
    chosen = shots.names(given.shots)
    jobs = [(Run(name, start, each), given.config) for name in chosen for start in STARTS for each in ALTERATIONS]
    measures = processes.each(measured, jobs)
    found = {(each.shot, each.start, each.alteration): mean for (each, _), mean in zip(jobs, measures, strict=True)}
    by_shot = {name: [_mean([found[name, k, each] for k in STARTS]) for each in ALTERATIONS] for name in chosen}
    text, is_all = _text(by_shot, given.config), given.shots is None
    result = {"config": given.config, "shots": by_shot}
    report.write("altered" if is_all else "altered some", text, result, publish=given.publish and is_all)


def measured(job: tuple[Run, str]) -> float | None:
    """The mean IoU of a run by a configuration; None where its key shows nothing of the object."""
    asked, config = job
    shot = shots.load(asked.shot)
    first = min(shot.first + asked.start, shot.last - LENGTH)
    frames = range(first, first + LENGTH + 1)
    pictures, masks = ALTERATIONS[asked.alteration](
        [shot.read(frame) for frame in frames], [shot.mask(frame) for frame in frames]
    )
    if not masks[0].any():
        return None
    return float(np.mean([iou for iou, _ in shots.tracked(pictures.__getitem__, masks, config)]))


def _mean(measures: Sequence[float | None]) -> float:
    """The mean of those that there are."""
    return float(np.mean([each for each in measures if each is not None]))


def _seen(pictures: Sequence[Image], masks: Sequence[Bools], views: Sequence[Array]) -> Frames:
    """Pictures and masks by frame under affine maps `(2, 3)`; beyond the edge the picture is mirrored, the mask not."""
    size = masks[0].shape[1], masks[0].shape[0]
    moved = [
        cv2.warpAffine(picture, view, size, flags=cv2.INTER_LINEAR, borderMode=cv2.BORDER_REFLECT_101)
        for picture, view in zip(pictures, views, strict=True)
    ]
    covered = [cv2.warpAffine(mask.astype(np.float32), view, size) for mask, view in zip(masks, views, strict=True)]
    return moved, [np.asarray(each > 0.5) for each in covered]


def _middle(mask: Bools) -> Array:
    """The centre of mass `(2,)` of a mask, that of the picture for an empty one."""
    rows, columns = np.nonzero(mask)
    if len(rows) == 0:
        return 0.5 * np.array(mask.shape[::-1], dtype=np.float64)
    return np.array([columns.mean() + 0.5, rows.mean() + 0.5])


def _offset(mask: Bools, widths: float) -> int:
    """Pixels by which a copy that is so many `widths` of the object away lies to its right, negative to its left.

    It lies where, by the `mask` on the key, there is more room.
    """
    columns = np.flatnonzero(mask.any(axis=0))
    if len(columns) == 0:
        return 0
    side = 1 if columns[0] + columns[-1] < mask.shape[1] else -1
    return round(side * widths * _width(mask))


def _width(mask: Bools) -> float:
    """Columns from the first to the last that a mask has something in; 0 of an empty one."""
    columns = np.flatnonzero(mask.any(axis=0))
    return float(np.ptp(columns) + 1) if len(columns) else 0.0


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
    title = f"Altered shots, {LENGTH} frames from three starts, configuration `{config}`. {report.circumstances()}."
    return f"{title}\n\n{report.table(['shot', *ALTERATIONS], rows)}"
