"""A figure drawn part by part: parts alone and together, filled between keys, beside simpler tools; and what it costs.

Every part is drawn whole on the first frame, from its true mask, also under what covers it. The IoU of a part leaves
out the pixels in which a nearer part hides it: what is hidden may lie anywhere, what leaks onto another part counts.
Frames on which less than a tenth of the part is seen are not scored.
"""

from __future__ import annotations

import argparse
import sys
import time
from collections.abc import Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from typing import Any

import cv2
import numpy as np

from benchmarks import figures, processes, report, shots
from benchmarks.figures import Figure
from benchmarks.yardstick import flow_seconds
from roam_core import fill_span, keys_from_mask, shapes_from_mask, track
from roam_core.arrays import Array, Bools, UInt8
from roam_core.errors import RoamError
from roam_core.geometry import projective
from roam_core.geometry.plane_motion import PlaneMotion, ransac
from roam_core.kernels.coverage import coverage
from roam_core.motion.planar import corners_in, followed
from roam_core.params import CONFIGS, DEFAULT_CONFIG, params_for
from roam_core.propagate import warm_up
from roam_core.roto import RotoShape

SEEDS, PUPPETS = "0,1,2,3", "101,102,103,104"
FRAMES, GAP = 24, 12
"""Frames after the first, and from key to key where the frames between are filled."""
HELD = 0.8
"""IoU under which a part is lost."""
SEEN = 0.1
"""Share of a part, and pixels, under which a frame is not scored."""
SEEN_PIXELS = 50
WINDOW, AGREE, CORNERS = 11, 1.5, 3
"""The peer's: pixels of the windows that it compares, by which a corner may disagree with its similarity, and the
fewest corners that make one. They suit it best on two walkers and a puppet: limbs are thin."""
SETTLING = 2
"""Frames at the beginning that are solved but not timed."""

ALONE, TOGETHER, PLANAR = "alone", "together", "planar, similarity"
FILLED_ALONE, FILLED_TOGETHER, LINEAR = "filled, alone", "filled, together", "linear keys"
METHODS = (ALONE, TOGETHER, PLANAR, FILLED_ALONE, FILLED_TOGETHER, LINEAR)

Mattes = list[Bools]
"""Of the frames after the first."""


@dataclass(frozen=True)
class Job:
    """A shot by what it shows ("walker", "puppet") and its seed, and the configuration."""

    what: str
    seed: int
    frames: int
    config: str


@dataclass(frozen=True)
class Score:
    """How one part fared on the frames that were scored.

    Attributes
    ----------
    iou, last : the mean, and that of the last one. good : the share of them that are not under `HELD`.
    held : frames before the first one under it. slide : pixels from its points to where they belong, if asked for.
    """

    iou: float
    last: float
    good: float
    held: int
    slide: float | None = None


def arguments(parser: argparse.ArgumentParser) -> None:
    """What `parts` may be told."""
    parser.add_argument("--config", metavar="NAME", default=DEFAULT_CONFIG, help=f"one of {', '.join(CONFIGS)}")
    parser.add_argument("--seeds", metavar="A,B", default=SEEDS, help="of the walkers (default: %(default)s)")
    parser.add_argument("--puppets", metavar="A,B", default=PUPPETS, help="seeds of the puppets; '' for none")
    parser.add_argument("--frames", type=int, default=FRAMES, metavar="N", help="frames after the first")
    parser.add_argument("--publish", action="store_true", help="put the tables into docs/BENCHMARKS.md")


def run(given: argparse.Namespace) -> None:
    """Score the figures, time the walkers, and report."""
    params_for(given.config)
    if not GAP <= given.frames <= 35:
        raise RoamError(f"--frames {given.frames} is not between {GAP} and 35.")
    walkers, puppets = _numbers("--seeds", given.seeds), _numbers("--puppets", given.puppets)
    whole = (given.seeds, given.frames) == (SEEDS, FRAMES)
    if walkers:
        found = _found("walker", walkers, given)
        times = {f"walker {seed}": timed(figures.of_walker(seed, given.frames + 1), given.config) for seed in walkers}
        text = f"{_text(found, given)}\n\n{_cost(times)}"
        result = {"shots": found, "times": times}
        report.write("parts" if whole else "parts some", text, result, publish=given.publish and whole)
    if puppets and not figures.has_puppets():
        print(f"\n{figures.ABSENT}", file=sys.stderr)
    elif puppets:
        found, whole = _found("puppet", puppets, given), (given.puppets, given.frames) == (PUPPETS, FRAMES)
        name = "parts puppets" if whole else "parts puppets some"
        report.write(name, _text(found, given), {"shots": found}, publish=given.publish and whole)


def _found(what: str, seeds: Sequence[int], given: argparse.Namespace) -> dict[str, dict[str, Any]]:
    """What was measured on every shot, by its name."""
    jobs = [Job(what, seed, given.frames, given.config) for seed in seeds]
    return {f"{job.what} {job.seed}": each for job, each in zip(jobs, processes.each(measured, jobs), strict=True)}


def measured(job: Job) -> dict[str, Any]:
    """All methods on one shot: scores by method and part, and the IoU of the whole figure."""
    load = figures.of_walker if job.what == "walker" else figures.of_puppet
    figure = load(job.seed, job.frames + 1)
    drawn = first_shapes(figure)
    parts: dict[str, dict[str, Any]] = {}
    one = _matte_of(_tracked(figure, shapes_from_mask(figure.union(figure.order, 0)), job.config), figure)
    wholes = {"one object": whole_overlap(figure, one)}
    for method in (ALONE, TOGETHER):
        groups = [drawn] if method == TOGETHER else [[shape] for shape in drawn]
        carried = [shape for group in groups for shape in _tracked(figure, group, job.config)]
        parts[method] = _scores(figure, {shape.id: _matte_of([shape], figure) for shape in carried})
        for shape in carried:
            parts[method][shape.id]["slide"] = slide(figure, shape)
        wholes[f"parts {method}"] = whole_overlap(figure, _matte_of(carried, figure))
    moved = planar(figure)
    parts[PLANAR] = _scores(figure, {part: _covered(lines, figure) for part, lines in moved.items()})
    for part, lines in moved.items():
        parts[PLANAR][part]["slide"] = float(
            np.mean([_apart(a, b) for a, b in zip(lines, figure.lines[part][1:], strict=True)])
        )
    keys = list(range(0, job.frames + 1, GAP))
    keyed = [_keyed(figure, shape, keys) for shape in drawn]
    for method in (FILLED_ALONE, FILLED_TOGETHER):
        groups = [keyed] if method == FILLED_TOGETHER else [[shape] for shape in keyed]
        filled = [shape for group in groups for shape in _filled(figure, group, keys, job.config)]
        parts[method] = _scores(figure, {shape.id: _matte_of([shape], figure) for shape in filled}, keys)
    straight = {part: linear(figure.lines[part], keys) for part in figure.drawn}
    parts[LINEAR] = _scores(figure, {part: _covered(lines, figure) for part, lines in straight.items()}, keys)
    return {"parts": parts, "whole": wholes}


# ---- scoring


def seen_overlaps(figure: Figure, part: str, mattes: Mattes, keys: Sequence[int] = ()) -> list[float | None]:
    """The IoU of a part on the frames after the first, without what is hidden.

    None on `keys`, after the last one of them, and where next to nothing of the part is seen.
    """
    overlaps: list[float | None] = []
    for frame, matte in enumerate(mattes, start=1):
        true, hidden = figure.whole(part, frame), figure.hidden(part, frame)
        seen = true & ~hidden
        enough = seen.sum() >= max(SEEN_PIXELS, SEEN * true.sum())
        if keys and (frame in keys or frame > keys[-1]):
            enough = False
        overlaps.append(shots.overlap(matte & ~hidden, seen) if enough else None)
    return overlaps


def score(overlaps: Sequence[float | None]) -> Score:
    """What the IoU of a part on every frame come to; None: not scored."""
    scored = [value for value in overlaps if value is not None] or [float("nan")]
    lost = (k for k, value in enumerate(overlaps) if value is not None and value < HELD)
    good = float(np.mean(np.array(scored) >= HELD))
    return Score(float(np.mean(scored)), scored[-1], good, next(lost, len(overlaps)))


def whole_overlap(figure: Figure, mattes: Mattes) -> float:
    """The mean IoU of the figure, without the pixels of parts that were never drawn."""
    overlaps = []
    for frame, matte in enumerate(mattes, start=1):
        true = figure.union(figure.drawn, frame)
        other = figure.union(figure.order, frame) & ~true
        overlaps.append(shots.overlap(matte & ~other, true))
    return float(np.mean(overlaps))


def slide(figure: Figure, shape: RotoShape) -> float:
    """Mean pixels from where the motion of a part takes the points of its shape to where they lie."""
    first = shape.at(0).anchors
    apart = [
        _apart(projective.apply(figure.since(shape.id, frame), first), shape.at(frame).anchors)
        for frame in figure.frames[1:]
    ]
    return float(np.mean(apart))


def _apart(a: Array, b: Array) -> float:
    return float(np.hypot(*(a - b).T).mean())


def least_margin(found: Mapping[str, Mapping[str, Any]], method: str, other: str) -> tuple[float, str, str]:
    """The least that a part gains by `method` over `other` in IoU, and the shot and the part of which that is."""
    return min(
        (each["parts"][method][part]["iou"] - each["parts"][other][part]["iou"], shot, part)
        for shot, each in found.items()
        for part in each["parts"][method]
    )


def _scores(figure: Figure, mattes: Mapping[str, Mattes], keys: Sequence[int] = ()) -> dict[str, Any]:
    return {part: asdict(score(seen_overlaps(figure, part, each, keys))) for part, each in mattes.items()}


# ---- the methods


def first_shapes(figure: Figure) -> list[RotoShape]:
    """A shape for each part that is drawn, bottom first, whole; its id is the part's name."""
    return [
        replace(shapes_from_mask(figure.whole(part, 0))[0], id=part, name=part.capitalize()) for part in figure.drawn
    ]


def planar(figure: Figure) -> dict[str, list[Array]]:
    """Outlines moved by the similarity of the corners in them, nearest first, each without what lies nearer."""
    lines = {part: figure.lines[part][0] for part in figure.drawn}
    found: dict[str, list[Array]] = {part: [] for part in figure.drawn}
    greys = [np.asarray(cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY), dtype=np.uint8) for picture in figure.pictures]
    for frame in figure.frames[1:]:
        nearer = np.zeros(figure.size, dtype=bool)
        for part in reversed(figure.drawn):
            mask = coverage(lines[part], figure.size) > 0.5
            looked_at = (mask & ~nearer).astype(np.uint8)
            nearer |= mask
            lines[part] = _moved(greys[frame - 1], greys[frame], looked_at, lines[part])
            found[part].append(lines[part])
    return found


def _moved(before: UInt8, after: UInt8, mask: UInt8, line: Array) -> Array:
    """An outline moved as the corners of a mask do; where they are too few, it stands still."""
    source, target = followed(before, after, corners_in(before, mask), WINDOW)
    motion = None
    if len(source) >= CORNERS:
        motion, _ = ransac(PlaneMotion.SIMILARITY, source, target, AGREE)
    return line if motion is None else np.asarray(projective.apply(motion, line))


def linear(lines: Sequence[Array], keys: Sequence[int]) -> list[Array]:
    """The outlines after the first key, every place moved straight from key to key; behind the last one held."""
    found = []
    for frame in range(keys[0] + 1, len(lines)):
        after = next((key for key in keys if key >= frame), keys[-1])
        before = max((key for key in keys if key < frame), default=keys[0])
        u = min(1.0, (frame - before) / max(after - before, 1))
        found.append((1.0 - u) * lines[before] + u * lines[after])
    return found


def _covered(lines: Sequence[Array], figure: Figure) -> Mattes:
    return [np.asarray(coverage(line, figure.size) > 0.5) for line in lines]


def _tracked(figure: Figure, shapes: Sequence[RotoShape], config: str) -> list[RotoShape]:
    carried = list(shapes)
    for solved in track(figure.read, shapes, figure.frames, config):
        carried = [result.shape for result in solved.results]
    return carried


def _keyed(figure: Figure, shape: RotoShape, keys: Sequence[int]) -> RotoShape:
    """The shape with keys fitted to the part's true mask on later frames."""
    for frame in keys[1:]:
        shape = keys_from_mask([shape], figure.whole(shape.id, frame), frame)[0]
    return shape


def _filled(figure: Figure, shapes: Sequence[RotoShape], keys: Sequence[int], config: str) -> list[RotoShape]:
    return fill_span(dict(enumerate(figure.pictures)), shapes, keys[0], keys[-1], config)


def _matte_of(shapes: Sequence[RotoShape], figure: Figure) -> Mattes:
    return [shots.matte(shapes, frame, figure.size) for frame in figure.frames[1:]]


# ---- what it costs


def timed(figure: Figure, config: str) -> dict[str, float]:
    """Milliseconds a frame of all parts together, of one object of their extent, and of the yardstick: one thread."""
    threads = cv2.getNumThreads()
    processes.one_thread()
    try:
        warm_up(config)
        parts, clock = _laps(figure, first_shapes(figure), config)
        one, one_clock = _laps(figure, shapes_from_mask(figure.union(figure.drawn, 0)), config)
        flow = 1000.0 * float(np.median(flow_seconds(figure.pictures)))
    finally:
        cv2.setNumThreads(threads)
    return {"parts": parts, "one": one, "parts by the clock": clock, "one by the clock": one_clock, "flow": flow}


def _laps(figure: Figure, shapes: Sequence[RotoShape], config: str) -> tuple[float, float]:
    """The median milliseconds of a frame: the processor's, and by the clock."""
    laps = []
    began = time.process_time(), time.perf_counter()
    for _ in track(figure.read, shapes, figure.frames, config):
        now = time.process_time(), time.perf_counter()
        laps.append((now[0] - began[0], now[1] - began[1]))
        began = time.process_time(), time.perf_counter()
    processor, clock = 1000.0 * np.median(laps[SETTLING:], axis=0)
    return float(processor), float(clock)


# ---- tables


def _text(found: Mapping[str, Mapping[str, Any]], given: argparse.Namespace) -> str:
    count = sum(len(each["parts"][ALONE]) for each in found.values())
    title = f"{len(found)} shots, {count} parts, {given.frames} frames each, configuration `{given.config}`; keys "
    title += f"{GAP} frames apart where the frames between are filled. {report.circumstances()}."
    return "\n\n".join([title, _methods(found, given.frames), _margins(found), _by_part(found), _wholes(found)])


def _methods(found: Mapping[str, Mapping[str, Any]], frames: int) -> str:
    rows = []
    for method in METHODS:
        scores = [score for each in found.values() for score in each["parts"][method].values()]
        names = ("iou", "good", "last", "held")
        iou, good, last, held = (float(np.nanmean([score[name] for score in scores])) for name in names)
        carried = [f"{last:.3f}", f"{held:.1f}"] if method in (ALONE, TOGETHER, PLANAR) else ["-", "-"]
        slides = [score["slide"] for score in scores if score["slide"] is not None]
        slid = f"{np.mean(slides):.1f}" if slides else "-"
        rows.append([method, f"{iou:.3f}", f"{100.0 * good:.0f} %", *carried, slid])
    head = ["parts", "IoU", f"frames at {HELD:g}", "at the end", f"frames held, of {frames}", "slide, px"]
    return report.table(head, rows)


def _margins(found: Mapping[str, Mapping[str, Any]]) -> str:
    sentences = []
    for method, other in ((TOGETHER, ALONE), (FILLED_TOGETHER, FILLED_ALONE), (FILLED_TOGETHER, LINEAR)):
        margin, shot, part = least_margin(found, method, other)
        sentences.append(f"{method} against {other} {margin:+.3f} ({shot}, {part})")
    return f"Least margin of a part in IoU: {'; '.join(sentences)}."


def _by_part(found: Mapping[str, Mapping[str, Any]]) -> str:
    """The mean IoU of each part over the shots in which it was drawn."""
    names = sorted({part for each in found.values() for part in each["parts"][ALONE]})
    rows = []
    for part in names:
        there = [each["parts"] for each in found.values() if part in each["parts"][ALONE]]
        means = [np.nanmean([parts[method][part]["iou"] for parts in there]) for method in METHODS]
        rows.append([part.replace("_", " "), *(f"{mean:.3f}" for mean in means)])
    return report.table(["IoU of", *METHODS], rows)


def _wholes(found: Mapping[str, Mapping[str, Any]]) -> str:
    names = list(next(iter(found.values()))["whole"])
    values = np.array([[each["whole"][name] for name in names] for each in found.values()])
    rows = [[shot, *(f"{value:.3f}" for value in row)] for shot, row in zip(found, values, strict=True)]
    rows.append([f"**mean of {len(found)}**", *(f"**{value:.3f}**" for value in values.mean(axis=0))])
    return report.table(["IoU of the whole figure", *names], rows)


def _cost(times: Mapping[str, Mapping[str, float]]) -> str:
    head = [
        "all parts together",
        "processor, ms a frame",
        "one object",
        "times one object",
        "by the clock",
        "times DIS",
    ]
    rows, ratios = [], []
    for shot, each in times.items():
        ratio = (
            each["parts"] / each["one"],
            each["parts by the clock"] / each["one by the clock"],
            each["parts"] / each["flow"],
        )
        ratios.append(ratio)
        rows.append([shot, f"{each['parts']:.0f}", f"{each['one']:.0f}", *(f"{value:.2f}" for value in ratio)])
    rows.append(["**median**", "", "", *(f"**{value:.2f}**" for value in np.median(ratios, axis=0))])
    return report.table(head, rows)


def _numbers(option: str, text: str) -> list[int]:
    try:
        return [int(word) for word in text.split(",") if word]
    except ValueError:
        raise RoamError(f"{option} {text} is not a list of whole numbers, such as {SEEDS}.") from None
