"""`--json`: every command has it, and what it prints is JSON, a line each."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.cli import COMMANDS, main
from roam_core.roto import edit, file
from roam_core.roto.placement import LayerTransform
from tests.unit.cli.conftest import Plate, Roam
from tests.unit.studio.shots import put_gaps


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_has_it(command: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit):
        main([command, "--help"])
    assert "--json" in capsys.readouterr().out


@pytest.fixture
def project(roam: Roam, plate: Plate, tmp_path: Path) -> Path:
    """The shot, tracked."""
    path = tmp_path / "shot.roam"
    words = ("--config", "baseline", "--end", 1003, "--save", path)
    assert roam("track", plate.folder, "--init", plate.mask, *words).status == 0
    return path


def test_files_are_told(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("export", project, tmp_path / "shot.nk", "--to", "nuke", "--json")
    assert json.loads(done.out) == {"shapes": 1, "files": [str(tmp_path / "shot.nk")], "notes": []}
    done = roam("render", project, "--out", tmp_path / "m", "--end", 1002, "--json")
    names = [str(tmp_path / "m" / f"plate.{frame}.png") for frame in (1001, 1002)]
    assert json.loads(done.out) == {"files": names, "kept": []}
    done = roam("render", project, "--out", tmp_path / "m", "--end", 1002, "--resume", "--json")
    assert json.loads(done.out) == {"files": [], "kept": names}
    assert done.err == ""


def test_shapes_that_were_read_are_counted_and_a_project_is_made_for_a_clip(
    roam: Roam, project: Path, plate: Plate, tmp_path: Path
) -> None:
    assert roam("export", project, tmp_path / "shot.nk", "--to", "nuke").status == 0
    made = tmp_path / "made.roam"
    words = ("import", tmp_path / "shot.nk", "--into", made, "--clip", plate.folder, "--json")
    told = json.loads(roam(*words).out)
    assert (told["shapes"], told["files"]) == (1, [str(made)])
    refused = roam(*words)
    assert refused.status == 1
    assert "is there already" in refused.err


def test_a_project_and_a_clip_are_described(roam: Roam, project: Path, plate: Plate) -> None:
    told = json.loads(roam("info", project, "--json").out)
    (shape,) = told["shapes"]
    assert (shape["artist_keys"], shape["engine_keys"], shape["stale"]) == ([1001], [1002, 1003], [])
    assert sorted(shape["confidence"]) == ["1002", "1003"]
    assert told["clip"]["is_there"]
    clip = json.loads(roam("info", plate.folder, "--json").out)["clip"]
    assert (clip["first"], clip["last"], clip["size"], clip["missing"]) == (1001, 1006, [130, 110], [])


def test_layers_and_their_motion_are_described(roam: Roam, project: Path) -> None:
    """A planar track is a layer's: its frames, its adjust keys, and where it is least sure."""
    held = file.load(project)
    held, layer = edit.add_layer(held, "Körper 1")
    held, inner = edit.add_layer(held, "Plain", layer.id)
    motion = LayerTransform.of({1001: np.eye(3), 1004: np.eye(3)})
    motion = replace(motion, confidence=((1004, 0.25),), adjusted=(1001, 1004))
    file.save(edit.set_properties(held, layer.id, transform=motion, locked=True, visible=False), project)
    first, second = json.loads(roam("info", project, "--json").out)["layers"]
    assert (first["name"], first["holds"], first["visible"], first["locked"]) == ("Körper 1", [inner.id], False, True)
    assert first["motion"] == {"frames": [1001, 1004], "adjust_keys": [1001, 1004], "confidence": {"1004": 0.25}}
    assert (second["name"], second["motion"]) == ("Plain", None)
    lines = [line for line in roam("info", project).out.splitlines() if line.startswith("layer")]
    assert lines == [
        "layer    'Körper 1': 0 shape(s), add, hidden, locked; moves on 1001-1004, 2 adjust keys; "
        "least sure on 1004 (0.25)",
        "layer    'Plain': 0 shape(s), add",
    ]


@pytest.mark.parametrize("name", ["ROAM_THREADS", "ROAM_CACHE_MB"])
@pytest.mark.parametrize("value", ["0", "many", "-1", "9" * 5000])
def test_nonsense_in_the_environment_is_told(
    roam: Roam, plate: Plate, monkeypatch: pytest.MonkeyPatch, name: str, value: str
) -> None:
    monkeypatch.setenv(name, value)
    done = roam("track", plate.folder, "--init", plate.mask, "--config", "baseline", "--end", 1001)
    assert done.status == 1
    assert f"{name} is '{value[:20]}'" in done.err


def test_a_span_is_filled_alone(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    given = put_gaps(tmp_path / "gaps.roam", plate.folder)
    words = ("fill", given, "--config", "baseline", "--save", tmp_path / "part.roam", "--span")
    assert roam(*words, 1003, 1006).status == 0
    told = json.loads(roam("info", tmp_path / "part.roam", "--json").out)
    assert [shape["engine_keys"] for shape in told["shapes"]] == [[1004, 1005]] * 2
    refused = roam(*words, 1002, 1003)
    assert refused.status == 1
    assert "there are 1001-1003, 1003-1006" in refused.err
