"""The add-on in Blender itself, where it is installed: masks out of a project, and the same shapes back in another."""

from __future__ import annotations

import json
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest

from roam_core.cli import main
from roam_core.roto import file
from tests.unit.interchange.blender_judge import command
from tests.unit.plugins.conftest import Desk, pytestmark

__all__ = ["pytestmark"]

SESSION = Path(__file__).with_name("blender_session.py")
STARTS = 11
"""The scene's frame on which Blender shows the plate's frame 1001."""


@pytest.mark.parametrize("opened", [1001, 1003])
def test_shapes_go_to_blender_and_come_back(desk: Desk, opened: int) -> None:
    """Blender's clip begins with the picture that was opened."""
    blender = command()
    if blender is None:
        pytest.skip("Blender is not installed (pip install roam-roto[blender], on Python 3.11)")
    assert main(["plugin", "blender", str(desk.folder / "addons")]) == 0
    first, starts = desk.plate / f"plate.{opened}.png", STARTS + opened - 1001
    wanted = {"folder": str(desk.folder), "first": str(first), "starts": starts}
    environment = os.environ | {"ROAM_WANTED": json.dumps(wanted | {"project": str(desk.project)})}
    words = [*blender, str(SESSION)]
    done = subprocess.run(words, env=environment, capture_output=True, text=True, timeout=300, check=False)
    assert (desk.folder / "result.json").exists(), done.stdout + done.stderr
    result = json.loads((desk.folder / "result.json").read_text(encoding="utf-8"))
    assert (result["back"], result["sent"], result["masks"]) == (["FINISHED"], ["FINISHED"], ["ROAM"])
    assert result["opened"] == [str(desk.folder / "sent.roam")]
    assert "missing.roam" in result["told"]
    ours, (theirs,) = file.load(desk.project).shapes[0], file.load(desk.folder / "sent.roam").shapes
    assert (theirs.name, theirs.frames, theirs.closed) == ("Arm", (opened, 1005), True)
    for frame in range(opened, 1006):
        np.testing.assert_allclose(theirs.at(frame).points, ours.at(frame).points, atol=0.01)
