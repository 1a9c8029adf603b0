"""Interlaced movies: two moments in one frame, row by row. Combing is measured; what cannot be shown at all is told."""

from __future__ import annotations

import os
import subprocess
import sys
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Bools, Image
from roam_core.errors import RoamError
from roam_core.media.measure import plain_name

PROBED = 9
"""Pictures from the beginning of a movie that are looked at."""
COLUMNS = 256
"""Columns of a picture that are looked at."""
STEP = 20
"""Levels of 255 by which a row differs from its neighbours, or a pixel from the picture before, to count."""
MOVING = 0.001
"""Share of a picture that must have moved before its combing says anything."""
COMBED = (0.05, 1.15)
"""Combed share of what moved, and its ratio to what two rows further apart show, above which a picture is interlaced.

Of 23 shots the ratio is 0.4 at most, of mere noise 1. Of the same shots with rows of two frames woven together 20 are
found; water, a car far away and a small ball pass for progressive.
"""
PROBE = "roam_core.media.first_picture"
"""The module that decodes a movie's first picture; the program of a bundle runs it as Python does."""
LONGEST_PROBE = 30.0
"""Seconds after which a probe says nothing."""


def thinned(picture: Image) -> Image:
    """Some columns of a picture `(h, w, 3)`, all that is looked at of it."""
    return np.ascontiguousarray(picture[:, :: max(picture.shape[1] // COLUMNS, 1)])


def require_progressive(path: Path, pictures: Sequence[Image]) -> None:
    """Refuse a movie whose first pictures are interlaced, measured or by what the decoder makes of them.

    Parameters
    ----------
    pictures : (h, w', 3) uint8, some that follow each other from the beginning, `thinned`.

    Raises
    ------
    RoamError
        when they are combed where they move; or are one and the same because they are marked as interlaced, and
        OpenCV, which cannot convert them, gives memory in which there never was a picture.
    """
    if is_combed(pictures) or (_are_all_one(pictures) and _holds_others(path, len(pictures)) and _is_marked(path)):
        raise interlaced(path)


def interlaced(path: Path) -> RoamError:
    """What is told of a movie that is interlaced."""
    return RoamError(
        f"{path} is interlaced: each of its frames shows two moments, in every other row. "
        "Deinterlace it in another program, as images or as a progressive movie, and open that."
    )


def is_combed(pictures: Sequence[Image]) -> bool:
    """Whether most of the pictures `(h, w, 3)` that move are combed: rows differ more than every second row does."""
    greys = [_grey(picture) for picture in pictures]
    found = [combing for before, after in pairwise(greys) if (combing := _combing(before, after)) is not None]
    least, ratio = COMBED
    combed = [near > least and near > ratio * far for near, far in found]
    return 2 * sum(combed) > len(combed) > 0


def _combing(before: NDArray[np.int16], after: NDArray[np.int16]) -> tuple[float, float] | None:
    """Of the pixels that moved the share that stand out against the rows beside them, and against the next but one.

    None where too little moved.
    """
    moved = (np.abs(after - before) > STEP)[2:-2]
    count = int(moved.sum())
    if count <= MOVING * moved.size:
        return None
    near, far = (int((_stands_out(after, rows) & moved).sum()) / count for rows in (1, 2))
    return near, far


def _stands_out(picture: NDArray[np.int16], rows: int) -> Bools:
    """Where a pixel, without the two outermost rows, is brighter or darker than both of those so many rows away."""
    inner = picture[2:-2]
    above, below = inner - picture[2 - rows : -2 - rows], inner - picture[2 + rows : len(picture) - 2 + rows]
    return np.asarray((np.minimum(above, below) > STEP) | (np.maximum(above, below) < -STEP))


def _grey(picture: Image) -> NDArray[np.int16]:
    return np.asarray(cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY), dtype=np.int16)


def _are_all_one(pictures: Sequence[Image]) -> bool:
    return len(pictures) > 1 and all(np.array_equal(before, after) for before, after in pairwise(pictures))


def _holds_others(path: Path, count: int) -> bool:
    """Whether the first `count` packets of the file, its frames as they are coded, are not one and the same."""
    with plain_name(path) as name:
        stream = cv2.VideoCapture(name, cv2.CAP_FFMPEG, [cv2.CAP_PROP_FORMAT, -1])
    packets: set[bytes] = set()
    while len(packets) < 2 and count > 0 and stream.grab():
        packets.add(np.asarray(stream.retrieve()[1]).tobytes())
        count -= 1
    stream.release()
    return len(packets) > 1


def _is_marked(path: Path) -> bool:
    """Whether FFmpeg says that the first frame is interlaced: in a process of its own, whose errors can be heard."""
    heard = {**os.environ, "OPENCV_FFMPEG_LOGLEVEL": "16"}
    try:
        with plain_name(path) as name:
            command = [sys.executable, "-m", PROBE, name]
            done = subprocess.run(command, capture_output=True, env=heard, timeout=LONGEST_PROBE, check=False)
    except (OSError, subprocess.SubprocessError):
        return False
    return b"interlaced" in (done.stdout + done.stderr).replace(os.fsencode(path), b"")
