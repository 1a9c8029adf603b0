"""Compiling every kernel ahead of the first track, by tracking tiny pictures; called from the worker thread."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.geometry.bezier import polygon_points
from roam_core.matte import render_matte
from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams
from roam_core.propagate.between.span import fill_span
from roam_core.propagate.run import track
from roam_core.roto import Keyframe, RotoShape


def warm_up(*configs: str | RoamParams) -> None:
    """Run the given configurations (all, if none) once on two small frames; fast when the code is cached on disk."""
    pictures = np.full((2, 48, 64, 3), 40, dtype=np.uint8)
    pictures[0, 12:36, 16:40], pictures[1, 13:37, 17:41] = 200, 200
    square = RotoShape("warm-up", "warm-up", (Keyframe(0, polygon_points([(16, 12), (40, 12), (40, 36), (16, 36)])),))
    for config in configs or CONFIGS:
        for _ in track(lambda frame: pictures[frame], [square], range(2), config):
            pass


def warm_up_parts(config: str | RoamParams = DEFAULT_CONFIG) -> None:
    """Track and fill a small figure of two parts, each of which moves by itself: what `warm_up` does not come to."""
    frames = range(3)
    parts = _figure(frames)
    texture = np.random.default_rng(1).integers(0, 60, (24, 32, 3)).repeat(3, axis=0).repeat(3, axis=1)
    pictures = {}
    for frame in frames:
        matte = render_matte(parts, frame, (72, 96)) > 0.5
        moved = np.roll(texture, (2 * frame, 2 * frame), axis=(0, 1))
        pictures[frame] = np.where(matte[..., None], 180 + moved, texture + 20).astype(np.uint8)
    drawn = [replace(part, keys=part.keys[:1]) for part in parts]
    for _ in track(pictures.__getitem__, drawn, frames, config):
        pass
    fill_span(pictures, parts, frames[0], frames[-1], config)


def _figure(frames: range) -> list[RotoShape]:
    """An arm and its hand, which overlap; each with a key at either end."""
    shapes = []
    boxes = {"arm": (14, 24, 46, 40), "hand": (42, 22, 66, 44)}
    for (name, (left, top, right, bottom)), step in zip(boxes.items(), ((2, 2), (2, -1)), strict=True):
        corners = np.array([(left, top), (right, top), (right, bottom), (left, bottom)], dtype=np.float64)
        ends = (frames[0], frames[-1])
        keys = tuple(Keyframe(frame, polygon_points(corners + np.multiply(step, frame))) for frame in ends)
        shapes.append(RotoShape(name, name, keys))
    return shapes
