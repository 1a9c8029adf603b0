"""The benchmark of saving: its projects are what they say, and each step does its work."""

from __future__ import annotations

import json
from pathlib import Path

from benchmarks import saving
from roam_core.roto import file


def test_the_project_is_always_the_same_and_comes_back(tmp_path: Path) -> None:
    project = saving.project_of(3, 20)
    assert project == saving.project_of(3, 20)
    assert [len(shape.keys) for shape in project.shapes] == [20] * 3
    assert saving._save((3, 20), tmp_path / "a.roam").seconds > 0.0
    assert file.load(tmp_path / "a.roam") == project
    assert saving._load((3, 20), tmp_path / "a.roam").seconds > 0.0


def test_plain_json_holds_the_same_numbers(tmp_path: Path) -> None:
    saving._plain_save((2, 9), tmp_path / "plain.json")
    points = [[key.points.tolist() for key in shape.keys] for shape in saving.project_of(2, 9).shapes]
    assert json.loads((tmp_path / "plain.json").read_text()) == points
    assert saving._plain_load((2, 9), tmp_path / "plain.json").seconds > 0.0
