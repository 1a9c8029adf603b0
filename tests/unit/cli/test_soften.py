"""`roam soften`: shapes as soft as their plate, told in a sentence and in JSON, and what it refuses."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.matte import shape_matte
from roam_core.media import open_clip
from roam_core.roto import Clip, Keyframe, MotionBlur, Project, edit, file
from tests.unit.cli.conftest import Roam
from tests.unit.cli.test_bad_input import require_refusal
from tests.unit.matte.test_softness import SIZE, disc, picture

FRAMES = range(1, 5)


@pytest.fixture
def soft_plate(tmp_path: Path) -> Path:
    """A project with a hard disc on a plate in which it is blurred by a shutter of half a frame."""
    shape = disc(step=8.0, frames=FRAMES)
    goes_on = disc(step=8.0, frames=range(FRAMES.start - 1, FRAMES.stop + 1))
    blurred = replace(goes_on, motion_blur=MotionBlur(0.5, -0.25, 32))
    (tmp_path / "plate").mkdir()
    for frame in FRAMES:
        image = picture(shape_matte(blurred, frame, SIZE), seed=frame)
        cv2.imwrite(str(tmp_path / "plate" / f"plate.{frame:04d}.png"), image)
    path = tmp_path / "p.roam"
    file.save(edit.add_shape(Project(Clip.of(open_clip(tmp_path / "plate"))), shape), path)
    return path


def test_motion_blur_is_set_and_told(roam: Roam, soft_plate: Path) -> None:
    before = file.load(soft_plate).shapes[0]
    done = roam("soften", soft_plate)
    (after,) = file.load(soft_plate).shapes
    assert (done.status, done.out) == (0, "")
    assert after.motion_blur is not None
    assert after.motion_blur.shutter == pytest.approx(0.5, abs=0.06)
    assert after.keys == before.keys
    assert done.err.startswith(f"Shutter {after.motion_blur.shutter:.2f} frames. Edge ")
    assert done.err.endswith("1 shape changed, 0 with feather.\n")


def test_feather_is_saved_elsewhere_and_told_in_json(roam: Roam, soft_plate: Path, tmp_path: Path) -> None:
    before, target = soft_plate.read_bytes(), tmp_path / "soft.roam"
    done = roam("soften", soft_plate, "--by", "feather", "--save", target, "--json")
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [(line["shape"], line["frame"]) for line in lines] == [("disc", frame) for frame in FRAMES]
    assert all(2.0 < line["width"] < 4.0 and 0.4 < line["shutter"] < 0.6 for line in lines)
    (after,) = file.load(target).shapes
    assert after.motion_blur is None
    widths = [np.hypot(*key.feather[:, 0].T) for key in after.keys if key.feather is not None]
    assert len(widths) == len(FRAMES)
    # The disc moves sideways: soft at its sides, hard above and below.
    assert all(width.max() > 3.0 and width.min() == 0.0 for width in widths)
    assert soft_plate.read_bytes() == before


def test_what_cannot_be_read_is_said_and_changes_nothing(roam: Roam, soft_plate: Path) -> None:
    project = file.load(soft_plate)
    far = replace(project.shapes[0], keys=(Keyframe(1, project.shapes[0].keys[0].points + 1000.0),))
    file.save(project.with_shape(far), soft_plate)
    done = roam("soften", soft_plate, "--json")
    assert done.status == 0
    assert json.loads(done.out) == {"shape": "disc", "frame": 1, "width": None, "shutter": None}
    assert done.err == "No edge of these shapes could be read in the plate; nothing was changed.\n"
    assert file.load(soft_plate).shapes[0] == far


def test_nothing_to_soften_is_refused(roam: Roam, soft_plate: Path) -> None:
    require_refusal(roam("soften", soft_plate, "--shape", "other"))
    project = file.load(soft_plate)
    file.save(project.with_shape(replace(project.shapes[0], locked=True)), soft_plate)
    before = soft_plate.read_bytes()
    require_refusal(roam("soften", soft_plate))
    require_refusal(roam("soften", soft_plate, "--shape", "disc"))
    assert soft_plate.read_bytes() == before
