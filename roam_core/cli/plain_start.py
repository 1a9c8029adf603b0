"""Whether a run would begin on nothing: the working picture of one tone in and around the shapes."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from roam_core.arrays import Array, Image
from roam_core.roto import RotoShape
from roam_core.roto.bounds import is_near

BESIDE = 0.25
"""Of the size of a shape is looked at beside it."""
LEAST_BESIDE = 8
"""Pixels."""
LEVELS = 2.0
"""Of 255, by which what shows nothing may differ."""
STRAYS = 1.0
"""Percent of the pixels that do not count, at either end: dust, hot ones."""

WHITE, BLACK, PLAIN = "white", "black", "of one tone"


def plain_start(picture: Image, shapes: Iterable[RotoShape], frame: int) -> str:
    """That a working picture `(h, w, 3)`, uint8 or float in [0, 1], shows nothing to follow, in a sentence; else ""."""
    tones = [_tone(_around(picture, shape.at(frame).points)) for shape in shapes if shape.exists_at(frame)]
    if not tones or None in tones:
        return ""
    tone = tones[0] if len(set(tones)) == 1 else PLAIN
    told = f"Frame {frame} is {tone} in and around the shapes: there is nothing to follow."
    if tone == WHITE:
        return f"{told} Values above white are cut off; --colour says what the plate's values are."
    return f"{told} Begin on a frame that shows the object (--start)."


def _around(picture: Image, points: Array) -> Image:
    """What lies in and around an outline `(P, 3, 2)`; nothing where that is beyond the picture."""
    height, width = picture.shape[:2]
    places = points.reshape(-1, 2)
    if not is_near(places):
        return picture[:0]
    margin = np.maximum(BESIDE * np.ptp(places, axis=0), LEAST_BESIDE)
    left, top = np.clip(places.min(axis=0) - margin, 0, (width, height)).astype(int)
    right, bottom = np.clip(np.ceil(places.max(axis=0) + margin), 0, (width, height)).astype(int)
    return picture[top:bottom, left:right]


def _tone(picture: Image) -> str | None:
    """What a part of a picture is all over; None where it shows something, or is none."""
    if picture.size == 0:
        return None
    scale = 1.0 if picture.dtype == np.uint8 else 255.0
    low, high = scale * np.percentile(picture, (STRAYS, 100.0 - STRAYS), axis=(0, 1))
    if (high - low).max() > LEVELS:
        return None
    if low.min() >= 255.0 - LEVELS:
        return WHITE
    return BLACK if high.max() <= LEVELS else PLAIN
