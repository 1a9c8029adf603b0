"""A short plate and a mask on disk, and the command line as a function of its words."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.cli import main
from roam_core.propagate import FrameResult, track
from tests.golden.shots import Shot, blob, gliding

SHOT = gliding(blob([24.0, 20.0, 18.0, 22.0, 26.0]), 6, (60.0, 55.0), (1.7, 0.8), size=(110, 130), drift=(-0.5, 0.3))
"""Frames 1001-1006."""


@dataclass(frozen=True)
class Outcome:
    """How a command ended and what it said."""

    status: int
    out: str
    err: str


Roam = Callable[..., Outcome]


@dataclass(frozen=True)
class Plate:
    """A folder of images with a mask of the first and one of the last frame."""

    folder: Path
    mask: Path
    last_mask: Path
    shot: Shot = SHOT


@pytest.fixture
def roam(capsys: pytest.CaptureFixture[str]) -> Roam:
    """`roam("info", path)` runs the command line in this process."""

    def run(*words: object) -> Outcome:
        capsys.readouterr()
        status = main([str(word) for word in words])
        said = capsys.readouterr()
        return Outcome(status, said.out, said.err)

    return run


@pytest.fixture
def interrupt(monkeypatch: pytest.MonkeyPatch) -> Callable[[int], None]:
    """`interrupt(1003)`: the user presses Ctrl+C when tracking has come to that frame, at once if it is no frame."""

    def at(frame: int) -> None:
        def interrupting(*arguments: Any, **options: Any) -> Iterator[FrameResult]:
            if frame not in SHOT.frames:
                raise KeyboardInterrupt
            for result in track(*arguments, **options):
                yield result
                if result.frame == frame:
                    raise KeyboardInterrupt

        monkeypatch.setattr("roam_core.propagate.track", interrupting)

    return at


@pytest.fixture
def plate(tmp_path: Path) -> Plate:
    """The shot as PNG, `plate.1001.png` and so on, in a folder of its own."""
    folder = tmp_path / "plate"
    folder.mkdir()
    for frame in SHOT.frames:
        write_picture(folder / f"plate.{frame}.png", SHOT.read(frame))
    masks = tmp_path / "first.png", tmp_path / "last.png"
    for path, frame in zip(masks, (SHOT.frames[0], SHOT.frames[-1]), strict=True):
        cv2.imwrite(str(path), np.round(SHOT.matte(frame) * 255).astype(np.uint8))
    return Plate(folder, *masks)


def write_picture(path: Path, image: UInt8) -> None:
    """Write an RGB picture."""
    cv2.imwrite(str(path), np.ascontiguousarray(image[..., ::-1]))


def read_matte(path: Path) -> UInt8:
    """A written matte: 8 bits, one channel."""
    matte = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
    assert matte.dtype == np.uint8
    assert matte.ndim == 2
    return np.asarray(matte)
