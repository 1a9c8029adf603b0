"""Small shots on disk, and projects on them with gaps to fill."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np

from roam_core import Clip, Keyframe, Project, edit, open_clip, save_project, shapes_from_mask
from tests.unit.cli.conftest import SHOT, write_picture


def put_plate(folder: Path) -> Path:
    """The frames of the shot, `plate.1001.png` and so on, in a new folder."""
    folder.mkdir(parents=True)
    for frame in SHOT.frames:
        write_picture(folder / f"plate.{frame}.png", SHOT.read(frame))
    return folder


def put_mask(path: Path) -> Path:
    """The mask of the first frame."""
    cv2.imwrite(str(path), np.round(SHOT.matte(SHOT.frames[0]) * 255).astype(np.uint8))
    return path


def put_shot(folder: Path) -> Path:
    """A shot by the convention of folders: `plate` and `init.png`."""
    put_plate(folder / "plate")
    put_mask(folder / "init.png")
    return folder


def put_gaps(path: Path, plate: Path) -> Path:
    """A project of two objects with keys on three frames: two gaps each."""
    first = SHOT.frames[0]
    (drawn,) = shapes_from_mask(SHOT.matte(first), first)
    points = drawn.keys[0].points
    keyed = [(frame, points + np.array([1.7, 0.8]) * (frame - first)) for frame in (1001, 1003, 1006)]
    large = replace(drawn, keys=tuple(Keyframe(frame, at) for frame, at in keyed))
    small = tuple(Keyframe(frame, (at - 60.0) * 0.12 + np.array([105.0, 90.0])) for frame, at in keyed)
    project = edit.add_shape(Project(Clip.of(open_clip(plate))), large)
    save_project(edit.add_shape(project, replace(large, id="small", name="Small", keys=small)), path)
    return path
