"""Parts drawn by hand on real shots, tracked together: a contact sheet of each shot, and how its parts fill the mask.

The truth knows the whole figure alone, so a part is judged by its share inside the true mask, and the union of the
parts by its IoU with it, relative to that on the first frame: hand-drawn outlines do not fill the mask themselves.
What the part named `post` covers counts neither as a part nor against one.
"""

from __future__ import annotations

import argparse
import json
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from benchmarks import processes, report, shots
from benchmarks.contact_sheet import WIDTH, tile, write_sheet
from benchmarks.shots import Shot
from roam_core import track
from roam_core.arrays import Array, Bools, UInt8
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.kernels.coverage import coverage
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.roto import BlendMode, Keyframe, RotoShape

Lines = dict[str, list[Array]]
"""The closed polyline `(K, 2)` of each part on every frame from the first one on, bottom first."""

OUTLINES = Path(__file__).with_name("part_outlines.json")
"""Polygons in pixels by shot and part, bottom first."""
POST = "post"
"""The part that subtracts."""
SPANS = (10, 20, 40)
"""Frames after the first over which the IoU is averaged; the longest is tracked."""
SHOWN = (0, 5, 10, 20, 40)
COLUMNS, MARGIN, ZOOM = 3, 24, 2
"""Tiles across, pixels left around the mask, and by how much a tile is larger while it is drawn."""
COLOURS = (
    (60, 200, 255),
    (80, 255, 80),
    (255, 120, 60),
    (255, 80, 255),
    (255, 255, 80),
    (80, 80, 255),
    (60, 190, 160),
    (200, 160, 255),
    (255, 255, 255),
)
"""Blue, green, red; one a part."""


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `part_sheets` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument("--shots", metavar="A,B", help=f"some of {', '.join(outlines())}")


def run(given: argparse.Namespace) -> None:
    """Track the parts, write the sheets, and report."""
    params_for(given.config)
    drawn = outlines()
    chosen = shots.names(given.shots or ",".join(drawn))
    bare = [name for name in chosen if name not in drawn]
    if bare:
        raise RoamError(f"No parts are drawn on {bare[0]!r}; choose from {', '.join(drawn)}.")
    found = dict(zip(chosen, processes.each(measured, [(name, given.config) for name in chosen]), strict=True))
    name = "part-sheets" if given.shots is None else "part-sheets some"
    report.write(name, _text(found, given.config), {"config": given.config, "shots": found}, publish=False)
    print(f"The sheets are in {_folder().relative_to(report.ROOT)}.")


def outlines() -> dict[str, dict[str, Array]]:
    """The polygons `(P, 2)` of every shot by the names of its parts, bottom first."""
    read = json.loads(OUTLINES.read_text(encoding="utf-8"))
    return {shot: {part: np.array(line, dtype=float) for part, line in parts.items()} for shot, parts in read.items()}


def measured(job: tuple[str, str]) -> dict[str, Any]:
    """Track the parts of a shot by a configuration, write the sheet, and score."""
    name, config = job
    shot = shots.load(name)
    lines = tracked(shot, outlines()[name], config)
    path = _folder() / f"{name}.png"
    path.parent.mkdir(parents=True, exist_ok=True)
    write_sheet(_tiles(shot, lines), path, COLUMNS)
    overlaps, shares = [], []
    for k, frame in enumerate(shot.frames[: SPANS[-1] + 1]):
        masks = {part: np.asarray(coverage(each[k], shot.size) > 0.5) for part, each in lines.items()}
        hidden = masks.pop(POST, np.zeros(shot.size, dtype=bool))
        overlap, inside = score(list(masks.values()), hidden, shot.mask(frame))
        overlaps.append(overlap)
        shares.append(inside)
    return {"overlaps": overlaps, "inside": shares, **summary(overlaps, shares)}


def tracked(shot: Shot, drawn: Mapping[str, Array], config: str) -> Lines:
    """The parts carried together from the first frame of a shot to the end of the longest span."""
    shapes = [_shape(part, line, shot.first) for part, line in drawn.items()]
    lines = {shape.id: [shape.at(shot.first).flatten()] for shape in shapes}
    for solved in track(shot.read, shapes, shot.frames[: SPANS[-1] + 1], config):
        for each in solved.results:
            lines[each.shape.id].append(each.shape.at(solved.frame).flatten())
    return lines


def score(parts: Sequence[Bools], hidden: Bools, true: Bools) -> tuple[float, float]:
    """The IoU of the union of the parts with the true mask, and the mean share of a part inside it.

    Nothing of a part counts where it is `hidden`; of one that is nowhere seen the share is 0.
    """
    seen = [part & ~hidden for part in parts]
    inside = [int(np.count_nonzero(part & true)) / max(1, int(np.count_nonzero(part))) for part in seen]
    return shots.overlap(np.logical_or.reduce(seen), true), float(np.mean(inside))


def summary(overlaps: Sequence[float], shares: Sequence[float]) -> dict[str, float]:
    """Means over the frames after the first: the IoU relative to the first one's for each span, and the share."""
    relative = {f"1-{last}": float(np.mean(overlaps[1 : last + 1])) / overlaps[0] for last in SPANS}
    return {"first": overlaps[0], **relative, "share": float(np.mean(shares[1:]))}


def _shape(part: str, line: Array, frame: int) -> RotoShape:
    blend = BlendMode.SUBTRACT if part == POST else BlendMode.ADD
    return RotoShape(part, part, (Keyframe(frame, bezier.polygon_points(line)),), blend=blend)


def _folder() -> Path:
    return report.OUT / "part-sheets"


# ---- the sheet


def _tiles(shot: Shot, lines: Lines) -> list[UInt8]:
    """The shown frames around the figure, all cut to one size, and the legend."""
    boxes = [cv2.boundingRect(shot.mask(shot.first + k).astype(np.uint8)) for k in SHOWN]
    side = min(max(max(box[2:]) for box in boxes) + 2 * MARGIN, *shot.size)
    tiles = []
    for k, (x, y, width, height) in zip(SHOWN, boxes, strict=True):
        middle = np.array([x + width // 2, y + height // 2])
        left, top = np.clip(middle - side // 2, 0, np.array(shot.size[::-1]) - side)
        cut = shot.read(shot.first + k)[top : top + side, left : left + side, ::-1]
        times = ZOOM * WIDTH / side
        large = np.asarray(cv2.resize(cut, (ZOOM * WIDTH, ZOOM * WIDTH), interpolation=cv2.INTER_CUBIC), dtype=np.uint8)
        # The centre of a pixel lies half a pixel from its corner in both pictures.
        placed = [np.round((each[k] - (left, top)) * times - 0.5).astype(np.int32) for each in lines.values()]
        tiles.append(tile(large, str(k), [([line], colour) for line, colour in zip(placed, COLOURS, strict=False)]))
    return [*tiles, _legend(tiles[0].shape, list(lines))]


def _legend(shape: tuple[int, ...], parts: Sequence[str]) -> UInt8:
    """The names of the parts in their colours, the top one first."""
    empty = np.zeros(shape, dtype=np.uint8)
    for row, (part, colour) in enumerate(reversed(list(zip(parts, COLOURS, strict=False)))):
        cv2.putText(empty, part, (16, 40 + 28 * row), cv2.FONT_HERSHEY_SIMPLEX, 0.6, colour, 1, cv2.LINE_AA)
    return empty


def _text(found: Mapping[str, Mapping[str, Any]], config: str) -> str:
    columns = ["first", *(f"1-{last}" for last in SPANS), "share"]
    rows = [[shot, *(f"{each[column]:.3f}" for column in columns)] for shot, each in found.items()]
    means = [float(np.mean([each[column] for each in found.values()])) for column in columns]
    rows.append(["**mean**", *(f"**{mean:.3f}**" for mean in means)])
    head = ["shot", "IoU, frame 0", *(f"relative, 1-{last}" for last in SPANS), f"inside, 1-{SPANS[-1]}"]
    title = f"Parts drawn by hand on frame 0, tracked together, configuration `{config}`. {report.circumstances()}."
    return f"{title}\n\n{report.table(head, rows)}"
