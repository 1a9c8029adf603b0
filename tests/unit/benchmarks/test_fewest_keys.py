"""The benchmark of fewest keys: a row for each reach and tolerance, and fewer keys where more is allowed."""

from __future__ import annotations

import json
from itertools import pairwise
from pathlib import Path

import pytest

from benchmarks import demo_shot, fewest_keys, shots
from benchmarks.__main__ import main
from benchmarks.shots import Shot


def test_more_freedom_never_takes_more_keys(
    monkeypatch: pytest.MonkeyPatch,
    tmp_path: Path,
    gliding: Shot,
    sliding: Shot,
    capsys: pytest.CaptureFixture[str],
) -> None:
    monkeypatch.setattr(fewest_keys.report, "OUT", tmp_path / "out")
    monkeypatch.setattr(fewest_keys.report, "ROOT", tmp_path)
    monkeypatch.setattr(demo_shot, "load", lambda: sliding)
    monkeypatch.setattr(shots, "names", lambda wanted: [wanted])
    monkeypatch.setattr(shots, "load", {"gliding": gliding}.__getitem__)
    assert main(["keys", "--shots", "gliding"]) == 0
    said = capsys.readouterr().out
    assert said.count("| gliding, ") == len(fewest_keys.REACHES) * len(fewest_keys.TOLERANCES)
    found = json.loads((tmp_path / "out" / "keys.json").read_text())["shots"]
    assert [shot["shot"] for shot in found] == [sliding.name, gliding.name]
    for shot in found:
        for reach in shot["reaches"]:
            assert reach["moved"][0] <= reach["reach"]
            assert reach["iou"] > 0.8
            for motion in ("cubic", "linear"):
                for tight, loose in pairwise(reach["tolerances"]):
                    assert loose[motion]["keys"] <= tight[motion]["keys"] <= shot["frames"]
                    assert loose[motion]["error"][0] <= loose["tolerance"]
