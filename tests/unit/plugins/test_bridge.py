"""What the scripts for other programs share: the program that they start, keys out of what was read on every frame."""

from __future__ import annotations

import importlib
import json
import subprocess
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from roam_core.cli import main
from roam_core.cli import plugin as plugin_command
from roam_core.errors import RoamError
from roam_core.interchange import read_shapes
from roam_core.roto import Clip
from tests.unit.plugins.conftest import Desk, pytestmark

__all__ = ["pytestmark"]


@pytest.fixture
def bridge(plugin: Any) -> Any:
    return plugin("nuke", "roam_bridge", {"nuke": ModuleType("nuke")})


def test_a_straight_way_needs_its_ends_alone(bridge: Any) -> None:
    rows = {frame: [[float(min(frame, 5)), 2.0]] for frame in range(1, 10)}
    assert [key["frame"] for key in bridge.keys_of(rows)] == [1, 5, 9]


def test_a_single_frame_is_a_key(bridge: Any) -> None:
    assert [key["frame"] for key in bridge.keys_of({7: [[1.0, 2.0]]})] == [7]


def test_a_bent_way_keeps_every_frame(bridge: Any) -> None:
    rows = {frame: [[float(frame**2), 0.0]] for frame in range(5)}
    assert [key["frame"] for key in bridge.keys_of(rows)] == [0, 1, 2, 3, 4]


def test_its_document_is_one_that_roam_reads(bridge: Any, tmp_path: Path) -> None:
    rows = [[10.0, 10.0] * 3, [50.0, 10.0] * 3, [30.0, 40.0] * 3]
    shape = {"name": "Arm", "closed": True, "keys": bridge.keys_of({1: rows, 2: rows})}
    path = tmp_path / "shapes.json"
    path.write_text(bridge.document([shape], (160, 90)), encoding="utf-8")
    (read,) = read_shapes(path, Clip(Path("plate"), 1, 2, (160, 90))).layer.shapes()
    assert (read.name, read.point_count) == ("Arm", 3)


def test_a_program_that_is_not_there_is_told(bridge: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.delenv("ROAM_PROGRAM")
    monkeypatch.setenv("PATH", "")
    with pytest.raises(bridge.Trouble, match="ROAM_PROGRAM"):
        bridge.run("info")


def test_the_first_frame_is_the_plates(bridge: Any, desk: Desk) -> None:
    assert bridge.first_frame(str(desk.plate)) == 1001


def test_the_picture_that_is_named_has_its_own_number(bridge: Any, desk: Desk) -> None:
    assert bridge.frame_of_file(str(desk.plate / "plate.1003.png")) == 1003
    assert bridge.frame_of_file(str(desk.plate)) == 1001


def test_what_follows_a_dot_stays_in_a_projects_name(bridge: Any) -> None:
    names = ("a/shot.v002", "a/shot.v002.roam", "a/shot")
    assert [bridge.project_of(name).as_posix() for name in names] == [f"{names[0]}.roam", names[1], "a/shot.roam"]
    with pytest.raises(bridge.Trouble, match="name"):
        bridge.project_of("a/")


def test_what_roam_says_is_read_in_any_locale(bridge: Any, desk: Desk, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("PYTHONIOENCODING", "latin-1")
    with pytest.raises(bridge.Trouble, match="Fl\u00fcgel"):
        bridge.run("info", desk.folder / "Fl\u00fcgel")


def test_the_scripts_start_the_roam_that_wrote_them(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    for folder in ("mine", "other"):
        (tmp_path / folder).mkdir()
        (tmp_path / folder / "roam").write_text("#!/bin/sh\n", encoding="utf-8")
        (tmp_path / folder / "roam").chmod(0o755)
    monkeypatch.setenv("PATH", str(tmp_path / "other"))
    monkeypatch.setattr("sys.argv", [str(tmp_path / "mine" / "roam")])
    assert main(["plugin", "nuke", str(tmp_path)]) == 0
    assert (tmp_path / "roam" / "program.txt").read_text(encoding="utf-8").strip() == str(tmp_path / "mine" / "roam")


def test_on_windows_the_program_is_found_by_a_word_without_its_suffix(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """pip's `roam.exe` says that it is `roam`; the menu then told that ROAM was not found."""
    program = tmp_path / "Scripts" / "roam.exe"
    program.parent.mkdir()
    program.write_text("#!/bin/sh\n", encoding="utf-8")
    program.chmod(0o755)
    monkeypatch.setenv("PATH", "")
    monkeypatch.setattr("sys.argv", [str(program.with_suffix(""))])
    assert main(["plugin", "nuke", str(tmp_path)]) == 0
    assert (tmp_path / "roam" / "program.txt").read_text(encoding="utf-8").strip() == str(program)


def test_on_windows_no_console_opens_beside_the_other_program(
    bridge: Any, desk: Desk, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its window would flash at every call, and to close the one that stays ends ROAM's own."""
    started: list[int] = []
    no_window = 0x08000000  # as Windows' Python calls it by name
    monkeypatch.setattr(subprocess, "CREATE_NO_WINDOW", no_window, raising=False)

    def start(*_command: object, creationflags: int = 0, **_options: object) -> Any:
        started.append(creationflags)
        return subprocess.CompletedProcess([], 0, "", "")

    monkeypatch.setattr(subprocess, "run", start)
    monkeypatch.setattr(subprocess, "Popen", start)
    bridge.run("info")
    importlib.reload(bridge).open_window(desk.project)
    assert started == [no_window, no_window]


def test_on_a_full_disk_no_half_of_the_menu_is_left(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    write, written = plugin_command.write_atomically, []

    def until_full(path: Path, content: bytes) -> None:
        if written:
            raise RoamError(f"{path} cannot be written: No space left on device.")
        written.append(path)
        write(path, content)

    monkeypatch.setattr(plugin_command, "write_atomically", until_full)
    assert main(["plugin", "nuke", str(tmp_path)]) == 1
    assert "No space left on device" in capsys.readouterr().err
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize(
    ("program", "scripts"),
    [
        ("nuke", {"menu.py", "roam_nuke.py"}),
        ("natron", {"initGui.py", "roam_natron.py"}),
        ("blender", {"__init__.py", "roam_masks.py"}),
    ],
)
def test_the_command_writes_all_that_a_program_needs(
    program: str, scripts: set[str], tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["plugin", program, str(tmp_path)]) == 0
    written = {path.name for path in (tmp_path / "roam").iterdir()}
    assert written - {"program.txt"} == scripts | {"roam_bridge.py"}
    assert str(tmp_path / "roam") in capsys.readouterr().out
    assert main(["plugin", program, str(tmp_path)]) == 1
    assert "--overwrite" in capsys.readouterr().err
    assert main(["plugin", program, str(tmp_path), "--overwrite", "--json"]) == 0
    told = json.loads(capsys.readouterr().out)
    assert {Path(path).name for path in told["files"]} == written


def test_a_clip_that_is_not_there_is_refused_before_a_project_is_made(desk: Desk) -> None:
    assert main(["export", str(desk.project), str(desk.folder / "a.json"), "--to", "json"]) == 0
    target = desk.folder / "new.roam"
    words = ["import", str(desk.folder / "a.json"), "--into", str(target), "--clip"]
    assert main([*words, str(desk.folder / "nowhere")]) == 1
    assert not target.exists()
    assert main([*words, str(desk.plate)]) == 0
    assert target.exists()
