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
from roam_core.propagate.engines.protocol import Engine
from roam_core.propagate.engines.view import EngineView
from roam_core.propagate.frame.confidence import ConfidenceFeatures, PoseFeatures, SpanFeatures, expected_overlap
from roam_core.propagate.frame.result import TrackResult
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
Told = tuple[float, ConfidenceFeatures | SpanFeatures | float]
"""The area of an object, as far as it was found, and its features, or its confidence where another model told it."""


@dataclass(frozen=True)
class Rated:
    """One frame.

    Attributes
    ----------
    iou : of its matte. known : what was known of each object that the fitted model rates. apart : the confidence of
        the others, each times its share: those that lie as on their keys but for a pose (`PoseFeatures`, fitted to
        figures), and those that only one pass of a fill has.
    """

    iou: float
    known: tuple[Known, ...]
    apart: float = 0.0


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
        picture, known, outlines = PreparedFrame(shot.read(frame)), list[Told](), list[RotoShape]()
        for tracker in trackers:
            results = tracker.step(picture, frame)
            outlines += [each.shape for each in results]
            if found := [each for each in results if each.confidence > 0.0]:
                told = _told_by(tracker.standing.engine, found)
                known.append((_area([each.shape for each in found], frame), told))
        yield _rated(shot, frame, outlines, known)


def _told_by(engine: Engine, found: Sequence[TrackResult]) -> ConfidenceFeatures | float:
    """What was known of an object; its confidence where it lies by a pose, or a hole of it goes by one."""
    features = engine.state.features if isinstance(engine, RegionEngine) else None
    if isinstance(features, ConfidenceFeatures):
        return features
    if isinstance(features, PoseFeatures):
        return expected_overlap(features)
    return float(np.mean([each.confidence for each in found]))


def filled(shot: Shot, gap: int) -> Iterator[Rated]:
    """The frames between keys so many frames apart, from the true masks there."""
    keys = list(shot.frames[::gap])
    shapes = true_keys.of(shot).over(keys)
    pictures = {frame: shot.read(frame) for frame in shot.frames}
    filling = Filling(Reader(pictures.__getitem__), params_for(CONFIGS["best"]))
    for start, stop in pairwise(keys):
        gaps = spans(shapes, start, stop)
        if not gaps:
            continue
        stamps = Stamps(shapes, size=shot.size)
        groups = sorted({stamps.filled_with(k, (start, stop)) for k in gaps[0][2]})
        view = EngineView.of_key(filling.read(start), filling.params)
        made = [
            (group, filling.passed(group, (start, stop), view, (start, stop)))
            for group in ([shapes[k] for k in members] for members in groups)
        ]
        for frame in range(start + 1, stop):
            known, outlines = list[Told](), list[RotoShape]()
            for group, span in made:
                solved = filling.solved(span, group, view, frame)
                pairs = [(s, each) for s, each in zip(group, solved, strict=True) if each is not None]
                here = [RotoShape(s.id, s.name, (Keyframe(frame, m.points),), blend=s.blend) for s, m in pairs]
                outlines += here
                known += [
                    (_area([line], frame), m.features or m.confidence) for line, (_, m) in zip(here, pairs, strict=True)
                ]
            yield _rated(shot, frame, outlines, known)


def _rated(
    shot: Shot,
    frame: int,
    outlines: list[RotoShape],
    known: list[Told],
) -> Rated:
    iou = shots.overlap(shots.matte(outlines, frame, shot.size), shot.mask(frame))
    whole = max(_area(outlines, frame), 1.0)
    told = [(area / whole, each) for area, each in known]
    return Rated(
        iou,
        tuple((share, astuple(each)) for share, each in told if not isinstance(each, float)),
        sum(share * each for share, each in told if isinstance(each, float)),
    )


def _area(shapes: Sequence[RotoShape], frame: int) -> float:
    """Square pixels of the outlines, each by itself."""
    lines = [bezier.flatten(shape.at(frame).points) for shape in shapes]
    return float(sum(cv2.contourArea(line.astype(np.float32)) for line in lines))
