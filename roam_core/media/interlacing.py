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
from roam_core.translatable import sentence

PROBED = 9
"""Pictures from the beginning of a movie that are looked at."""
COLUMNS = 256
"""Columns of a picture that are looked at, or up to twice as many."""
PIECE = 16
"""Columns that lie side by side: they are looked at in pieces, so that columns can be compared as rows are."""
STEP = 20
"""Levels of 255 by which a row differs from its neighbours, or a pixel from the picture before, to count."""
MOVING = 0.001
"""Share of a picture that must have moved before its combing says anything."""
COMBED = (0.05, 1.15)
"""Combed share of what moved, and its ratio to what two rows further apart show, above which a picture is interlaced.

Of 23 shots the ratio is 0.4 at most, of mere noise 1. Of the same shots with rows of two frames woven together 20 are
found; water, a car far away and a small ball pass for progressive.
"""
SIDEWAYS = 2.5
"""Ratio of combed rows to columns combed in the same way, above which a picture is interlaced.

Of the 20 that are found it is 5 at least. Dithered pictures, and those that were made smaller without a filter, are
combed both ways: there it is between .5 and 2.
"""
NEVER = ".gif"
"""The extension of movies that are never interlaced."""
PROBE = "roam_core.media.first_picture"
"""The module that decodes a movie's first picture; the program of a bundle runs it as Python does."""
LONGEST_PROBE = 30.0
"""Seconds after which a probe says nothing."""


_INNER = np.s_[2:-2, :, 2:-2]
"""Of a picture without the outermost rows, and of each piece without the outermost columns."""


def thinned(picture: Image) -> Image:
    """Some columns of a picture `(h, w, 3)`, all that is looked at of it: pieces of `PIECE` columns, evenly spread."""
    width = picture.shape[1]
    pieces = np.arange(width - width % PIECE) // PIECE
    return np.ascontiguousarray(picture[:, : len(pieces)][:, pieces % max(width // COLUMNS, 1) == 0])


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
    if path.suffix.lower() == NEVER:
        return
    if is_combed(pictures) or (_are_all_one(pictures) and _holds_others(path, len(pictures)) and _is_marked(path)):
        raise interlaced(path)


def interlaced(path: Path) -> RoamError:
    """What is told of a movie that is interlaced."""
    return RoamError(
        sentence(
            "{path} is interlaced: each of its frames shows two moments, in every other row. "
            "Deinterlace it in another program, as images or as a progressive movie, and open that.",
            path=path,
        )
    )


def is_combed(pictures: Sequence[Image]) -> bool:
    """Whether most of the pictures that move are combed: rows differ more than every second row, and than columns, do.

    Parameters
    ----------
    pictures : (h, w', 3) uint8, `thinned`: each `PIECE` columns lie side by side. Narrower ones say nothing.
    """
    greys = [_grey(picture) for picture in pictures if picture.size]
    found = [combing for before, after in pairwise(greys) if (combing := _combing(before, after)) is not None]
    least, ratio = COMBED
    combed = [near > least and near > ratio * far and near > SIDEWAYS * across for near, far, across in found]
    return 2 * sum(combed) > len(combed) > 0


def _combing(before: NDArray[np.int16], after: NDArray[np.int16]) -> tuple[float, float, float] | None:
    """Of the pixels that moved the share that stand out against the rows beside them, the next but one, and the columns
    beside them.

    None where too little moved. Pictures are (h, pieces, `PIECE`).
    """
    moved = (np.abs(after - before) > STEP)[_INNER]
    count = int(moved.sum())
    if count <= MOVING * moved.size:
        return None
    near, far, across = (int((_stands_out(after, *way) & moved).sum()) / count for way in ((0, 1), (0, 2), (2, 1)))
    return near, far, across


def _stands_out(picture: NDArray[np.int16], axis: int, distance: int) -> Bools:
    """Where a pixel of `_INNER` is brighter or darker than both of those so many rows (axis 0) or columns (2) away."""
    one, other = (picture[_INNER] - np.roll(picture, by, axis)[_INNER] for by in (-distance, distance))
    return np.asarray((np.minimum(one, other) > STEP) | (np.maximum(one, other) < -STEP))


def _grey(picture: Image) -> NDArray[np.int16]:
    grey = cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY)
    pieces = grey.shape[1] // PIECE
    return np.asarray(grey[:, : pieces * PIECE], np.int16).reshape(len(grey), pieces, PIECE)


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
