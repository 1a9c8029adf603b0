"""Frames with their IoU and what the engine knew of their quality: carried forward, or filled between two keys."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import astuple, dataclass
from itertools import pairwise

import cv2
import numpy as np

from benchmarks import restarts, shots, true_keys
from benchmarks.shots import Shot
from roam_core import shapes_from_mask
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.params import CONFIGS, params_for
from roam_core.propagate.between.span import Filling, Reader, spans
from roam_core.propagate.engines.by_regions import RegionEngine
from roam_core.propagate.frame.confidence import ConfidenceFeatures, SpanFeatures
from roam_core.propagate.group import GroupTracker
from roam_core.propagate.shapes.objects import near, objects
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Keyframe, RotoShape

CARRIED = ("whole", "restarts")
FILLED = {"fill 10": 10, "fill 20": 20}
"""Frames from key to key, by the name of the protocol."""
LENGTH = 20
"""Frames of a run, and from the start of one to the start of the next: how often an artist sets a key."""

Known = tuple[float, tuple[float, ...]]
"""The share of the frame's area that an object has, as far as it was found, and its features."""


@dataclass(frozen=True)
class Rated:
    """One frame: its IoU, and what was known of each of its objects."""

    iou: float
    known: tuple[Known, ...]


def of_job(job: tuple[str, str]) -> list[Rated]:
    """The frames of a shot under a protocol: one of `CARRIED` or `FILLED`."""
    name, protocol = job
    shot = shots.load(name)
    if protocol in FILLED:
        return list(filled(shot, FILLED[protocol]))
    runs = [shot.frames] if protocol == "whole" else restarts.runs(shot.frames, LENGTH, LENGTH)
    return [each for run in runs if shot.mask(run[0]).any() for each in carried(shot, run)]


def carried(shot: Shot, run: range) -> Iterator[Rated]:
    """The frames of a run from the true mask of its first."""
    shapes = shapes_from_mask(shot.mask(run[0]), run[0])
    groups = objects(shapes, near(shot.size))
    trackers = [GroupTracker("best") for _ in groups]
    first = PreparedFrame(shot.read(run[0]))
    for tracker, members in zip(trackers, groups, strict=True):
        tracker.start(first, [shapes[k] for k in members], run[0])
    for frame in run[1:]:
        picture, known, outlines = PreparedFrame(shot.read(frame)), [], list[RotoShape]()
        for tracker in trackers:
            results = tracker.step(picture, frame)
            engine = tracker.standing.engine
            assert isinstance(engine, RegionEngine)
            features = engine.state.features
            outlines += [each.shape for each in results]
            found = [each.shape for each in results if each.confidence > 0.0]
            known.append((_area(found, frame), features if isinstance(features, ConfidenceFeatures) else None))
        yield _rated(shot, frame, outlines, known)


def filled(shot: Shot, gap: int) -> Iterator[Rated]:
    """The frames between keys so many frames apart, from the true masks there."""
    keys = list(shot.frames[::gap])
    shapes = true_keys.of(shot).over(keys)
    filling = Filling(Reader({frame: shot.read(frame) for frame in shot.frames}), params_for(CONFIGS["best"]))
    for start, stop in pairwise(keys):
        gaps = spans(shapes, start, stop)
        if not gaps:
            continue
        stamps = Stamps(shapes, size=shot.size)
        groups = sorted({stamps.filled_with(k, (start, stop)) for k in gaps[0][2]})
        made = [
            (group, filling.passed(group, (start, stop), shot.size))
            for group in ([shapes[k] for k in members] for members in groups)
        ]
        for frame in range(start + 1, stop):
            known, outlines = [], list[RotoShape]()
            for group, span in made:
                solved = filling.solved(span, group, frame)
                pairs = [(s, each) for s, each in zip(group, solved, strict=True) if each is not None]
                here = [RotoShape(s.id, s.name, (Keyframe(frame, m.points),), blend=s.blend) for s, m in pairs]
                outlines += here
                known.append((_area(here, frame), pairs[0][1].features if pairs else None))
            yield _rated(shot, frame, outlines, known)


def _rated(
    shot: Shot,
    frame: int,
    outlines: list[RotoShape],
    known: list[tuple[float, ConfidenceFeatures | SpanFeatures | None]],
) -> Rated:
    iou = shots.overlap(shots.matte(outlines, frame, shot.size), shot.mask(frame))
    whole = max(_area(outlines, frame), 1.0)
    return Rated(iou, tuple((area / whole, astuple(features)) for area, features in known if features is not None))


def _area(shapes: Sequence[RotoShape], frame: int) -> float:
    """Square pixels of the outlines, each by itself."""
    lines = [bezier.flatten(shape.at(frame).points) for shape in shapes]
    return float(sum(cv2.contourArea(line.astype(np.float32)) for line in lines))
