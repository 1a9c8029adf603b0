"""Which artist's key a run carries to a frame."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.propagate.shapes.taking_part import governing_key
from roam_core.roto import Keyframe, Origin, RotoShape

KEY = Keyframe(1, np.zeros((4, 3, 2)))


def test_the_governing_key_is_the_last_one_passed() -> None:
    keys = [replace(KEY, frame=frame) for frame in (2, 6)]
    shape = RotoShape("a", "A", (*keys, replace(KEY, frame=4, origin=Origin.ENGINE)))
    forward = [getattr(governing_key(shape, frame, True), "frame", None) for frame in (1, 2, 5, 6, 9)]
    backward = [getattr(governing_key(shape, frame, False), "frame", None) for frame in (1, 2, 5, 6, 9)]
    assert forward == [None, 2, 2, 6, 6]
    assert backward == [2, 2, 6, 6, None]
