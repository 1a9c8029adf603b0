"""Pictures of the frames of which a step is least sure: the plate, and the outlines on it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import UInt8
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.media.colour import to_display
from roam_core.propagate import Termination
from roam_core.roto import Project, file
from roam_core.roto.relinking import open_plate, relinked

MOST = 3
"""Pictures of a step."""
DOUBTED = 0.9
"""Confidence below which a frame is shown."""
WIDEST = 640
"""Pixels across a picture."""
LINE, SHADE = (40, 230, 120), (0, 0, 0)
"""RGB of an outline, and of what sets it off from the plate."""


def seen(frames: Mapping[str, Sequence[Any]]) -> dict[int, float]:
    """The confidence of a step by frame, in order, without frames whose picture is missing: nothing is doubted there.

    `frames` gives the confidence first, the seconds, and last how the frame ended (`Termination`).
    """
    told = {int(frame): float(values[0]) for frame, values in frames.items() if values[-1] != Termination.MISSING_FRAME}
    return dict(sorted(told.items()))


def doubtful(frames: Mapping[str, Sequence[Any]], most: int = MOST) -> list[int]:
    """The frames of which a step is least sure, the worst first; `frames` as for `seen`."""
    rated = sorted((confidence, frame) for frame, confidence in seen(frames).items())
    return [frame for confidence, frame in rated[:most] if confidence < DOUBTED]


def write_doubtful(project: str, frames: Mapping[str, Sequence[Any]], folder: Path, name: str) -> dict[str, str]:
    """Write a picture of each doubtful frame into `folder`; the names of the files by frame.

    What cannot be read or written has none: a picture decides no result.
    """
    made: dict[str, str] = {}
    wanted = doubtful(frames)
    if not wanted:
        return made
    try:
        shown = relinked(file.load(project), Path(project).parent)
        plate = open_plate(shown.require_clip())
        folder.mkdir(parents=True, exist_ok=True)
        for frame in wanted:
            if frame in plate.frames:
                picture = drawn(to_display(plate.read(frame), plate.colour_space), shown, frame)
                _, content = cv2.imencode(".jpg", picture[..., ::-1], [cv2.IMWRITE_JPEG_QUALITY, 85])
                place = f"{name}.{frame}.jpg"
                write_atomically(folder / place, content.tobytes(), flushes=False)
                made[str(frame)] = place
    except (RoamError, OSError):
        return made
    return made


def drawn(picture: UInt8, project: Project, frame: int) -> UInt8:
    """A picture `(h, w, 3)` RGB, no wider than `WIDEST`, with the outlines of the shapes that are there on a frame."""
    height, width = picture.shape[:2]
    factor = min(1.0, WIDEST / width)
    size = max(1, round(width * factor)), max(1, round(height * factor))
    canvas = np.ascontiguousarray(cv2.resize(picture, size, interpolation=cv2.INTER_AREA))
    for shape in project.shapes:
        if shape.exists_at(frame):
            line = bezier.flatten(shape.at(frame).points, closed=shape.closed) * factor - 0.5
            places = np.rint(line * 16).astype(np.int32)[None]
            for colour, thickness in ((SHADE, 3), (LINE, 1)):
                cv2.polylines(canvas, places, shape.closed, colour, thickness, cv2.LINE_AA, 4)
    return np.asarray(canvas)
