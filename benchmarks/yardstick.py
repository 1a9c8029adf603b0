"""The yardstick: OpenCV's fastest dense flow on the same frames in the same run, so that machines can be compared."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from itertools import pairwise

import cv2

from roam_core.arrays import Image


def flow_seconds(pictures: Sequence[Image], clock: Callable[[], float] = time.thread_time) -> list[float]:
    """Seconds of DIS flow at its fastest preset from each whole picture to the next (Kroeger et al., ECCV 2016)."""
    flow = cv2.DISOpticalFlow.create(cv2.DISOPTICAL_FLOW_PRESET_ULTRAFAST)
    greys = [cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY) for picture in pictures]
    seconds = []
    for before, after in pairwise(greys):
        began = clock()
        flow.calc(before, after, None)
        seconds.append(clock() - began)
    return seconds
