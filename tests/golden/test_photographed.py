"""A quality budget on a real shot, through the command line, scored with the bench beside the project."""

from __future__ import annotations

import importlib.util
import json
from pathlib import Path
from types import ModuleType

import cv2
import pytest

from roam_core.cli import main
from roam_core.params import CONFIGS

pytestmark = pytest.mark.shared

LAST = 11
"""Frames 0-11."""


def bench(shared: Path) -> ModuleType:
    """The scoring program beside the project as a module."""
    spec = importlib.util.spec_from_file_location("bench_score", shared / "bench" / "score.py")
    assert spec is not None
    assert spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@pytest.mark.parametrize("config", list(CONFIGS))
def test_a_nearly_rigid_object_is_followed(
    config: str, shared: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    data = shared / "data" / "davis2016-train"
    pictures, masks = data / "JPEGImages" / "car-turn", data / "Annotations" / "car-turn"
    words = ["--init", str(masks / "00000.png"), "--end", str(LAST), "--config", config, "--json"]
    status = main(["track", str(pictures), *words, "--matte", str(tmp_path), "--save", str(tmp_path / "car.roam")])
    lines = [json.loads(line) for line in capsys.readouterr().out.splitlines()]
    assert status == 0
    assert [line["frame"] for line in lines] == list(range(LAST + 1))
    assert sorted(path.name for path in tmp_path.glob("*.png")) == [f"{frame:05d}.png" for frame in range(LAST + 1)]
    score = bench(shared)
    overlaps = []
    for frame in range(1, LAST + 1):
        ours, true = (score.read_mask(str(folder / f"{frame:05d}.png")) for folder in (tmp_path, masks))
        assert cv2.imread(str(tmp_path / f"{frame:05d}.png"), cv2.IMREAD_UNCHANGED).shape == true.shape
        overlaps.append(score.iou(ours, true))
    assert sum(overlaps) / len(overlaps) > 0.8
