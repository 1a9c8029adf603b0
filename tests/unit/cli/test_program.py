"""`roam` where the window is not installed, and where it is."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path
from types import SimpleNamespace

import cv2
import numpy as np
import pytest

import roam_core
from roam_core import installation
from roam_core.cli import COMMANDS, program
from roam_core.geometry import bezier
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit, file
from tests.conftest import ROOT


@pytest.fixture
def no_window(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(installation, "WINDOW_LIBRARIES", ("no_such_library",))


@pytest.mark.parametrize("arguments", [[], ["shot/"], ["work.roam"]])
def test_without_the_window_it_is_said_what_to_install(
    no_window: None, arguments: list[str], capsys: pytest.CaptureFixture[str]
) -> None:
    assert program.main(arguments) == program.BAD_USAGE
    said = capsys.readouterr().err
    assert said.count("\n") == 1
    assert 'pip install "roam-roto[window]"' in said


def test_without_the_window_the_demo_is_tracked_all_the_same(
    no_window: None, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    asked: list[list[str]] = []
    monkeypatch.setattr(program, "command_line", lambda argv: asked.append(argv) or 0)
    assert program.main(["demo"]) == 0
    assert asked == [["demo", "--headless"]]
    assert "The window is not installed" in capsys.readouterr().err


def test_commands_do_not_ask_for_the_window(
    no_window: None, capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(installation, "find_spec", lambda name: pytest.fail(f"asked for {name}"))
    assert program.main(["info", "nowhere.roam"]) == 1
    assert "nowhere.roam" in capsys.readouterr().err


@pytest.mark.parametrize(
    "words",
    [
        *([command, "--help"] for command in COMMANDS),
        ["--version"],
        ["--help"],
        ["configs"],
        ["info", "p.png"],
        ["info", "p.roam"],
    ],
)
def test_what_needs_no_engine_does_not_load_what_compiles_it(tmp_path: Path, words: list[str]) -> None:
    cv2.imwrite(str(tmp_path / "p.png"), np.full((40, 60, 3), 90, np.uint8))
    outline = bezier.polygon_points([(10.0, 10.0), (40.0, 10.0), (40.0, 30.0)])
    tracked = Keyframe(2, outline, origin=Origin.ENGINE, confidence=0.9, inputs="none")
    shape = RotoShape("a", "A", (Keyframe(1, outline), tracked))
    project = Project(Clip(tmp_path / "p.png", 1, 2, (60, 40)))
    file.save(edit.add_shape(project, shape), tmp_path / "p.roam")
    code = f"""
import sys
from roam_core.cli.program import main
try:
    main({words!r})
finally:
    print(*{{"numba", "scipy"}} & set(sys.modules), file=sys.stderr)
"""
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(
        [sys.executable, "-c", code], cwd=tmp_path, env=environment, capture_output=True, text=True, check=False
    )
    assert (done.returncode, done.stderr.splitlines()[-1]) == (0, "")
    assert done.stdout


@pytest.mark.skipif(sys.platform == "win32", reason="a process of Windows gets no SIGINT from itself")
def test_ctrl_c_at_the_very_end_is_no_traceback() -> None:
    code = """
import atexit, os, signal, sys
from roam_core.cli import program
program.command_line = lambda argv: 130
atexit.register(lambda: os.kill(os.getpid(), signal.SIGINT))
sys.argv = ["roam", "info", "p.roam"]
sys.exit(program.main())
"""
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert (done.returncode, done.stderr) == (-signal.SIGINT, "")


@pytest.mark.skipif(sys.platform == "win32", reason="its shell closes no streams")
@pytest.mark.parametrize("closed", [">&-", "2>&-", "<&- >&- 2>&-"])
def test_a_command_runs_without_standard_streams(closed: str, tmp_path: Path) -> None:
    (tmp_path / "plate").mkdir()
    for frame in (1001, 1002):
        cv2.imwrite(str(tmp_path / "plate" / f"plate.{frame}.png"), np.full((40, 60, 3), 90, np.uint8))
    white = np.zeros((40, 60), np.uint8)
    white[10:30, 20:40] = 255
    cv2.imwrite(str(tmp_path / "mask.png"), white)
    command = [sys.executable, "-m", "roam_core", "track", "plate", "--init", "mask.png", "--config", "baseline"]
    command += ["--matte", "mattes", "--save", "p.roam", "--json"]
    shell = ["sh", "-c", f'exec "$@" {closed}', "sh", *command]
    environment = os.environ | {"PYTHONPATH": str(ROOT)}
    done = subprocess.run(shell, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    assert [path.name for path in sorted((tmp_path / "mattes").iterdir())] == ["plate.1001.png", "plate.1002.png"]
    assert file.load(tmp_path / "p.roam").shapes[0].frames == (1001, 1002)


@pytest.mark.parametrize(
    ("arguments", "status"), [(["--help"], 0), (["--version"], 0), (["version"], 0), (["--versio"], 2)]
)
def test_help_and_version_need_no_window(
    no_window: None, arguments: list[str], status: int, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as left:
        program.main(arguments)
    assert left.value.code == status
    said = capsys.readouterr()
    if arguments == ["--help"]:
        assert all(f"\n  {name} " in said.out for name in COMMANDS)
    elif status == 0:
        assert said.out == f"roam {roam_core.__version__}\n"
    else:
        assert "--versio" in said.err


def test_help_is_given_for_the_word_unless_a_clip_is_called_so(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    handed: list[str | None] = []
    window = SimpleNamespace(open_window=lambda path: handed.append(path) or 0)
    monkeypatch.setattr(program, "window_module", lambda name: window)
    monkeypatch.chdir(tmp_path)
    with pytest.raises(SystemExit) as left:
        program.main(["help"])
    assert left.value.code == 0
    assert "\n  track " in capsys.readouterr().out
    (tmp_path / "help").mkdir()
    assert (program.main(["help"]), program.main(["shot"])) == (0, 0)  # which is not far from shift
    assert handed == ["help", "shot"]


def test_the_window_is_handed_what_to_open_and_its_answer_is_the_programs(monkeypatch: pytest.MonkeyPatch) -> None:
    handed: list[str | None] = []
    window = SimpleNamespace(
        open_window=lambda path: handed.append(path) or 7, open_demo=lambda: 8, has_display=lambda: True
    )
    monkeypatch.setattr(program, "window_module", lambda _: window)
    assert [program.main(arguments) for arguments in ([], ["shot/"], ["demo"])] == [7, 7, 8]
    assert handed == [None, "shot/"]


def test_a_checkout_finds_its_own_folders() -> None:
    assert (installation.RESOURCES, installation.WINDOW) == ("resources", "app")
    assert installation.demo.__name__ == "resources.demo"
    assert installation.resource("icons", "eye.svg").is_file()
    with pytest.raises(AttributeError, match="no attribute 'trailer'"):
        _ = installation.trailer


@pytest.mark.parametrize(
    ("arguments", "sentence"),
    [
        (["tarck", "shot", "--init", "mask.png"], "there is no command tarck; did you mean track?"),
        (["zzz", "--json"], "there is no command zzz\n"),
        (["prepar"], "there is no command prepar; did you mean prepare?"),
        ([".", "--init", "mask.png"], "unrecognized arguments: --init mask.png"),
    ],
)
def test_a_misspelt_command_is_named_and_not_what_follows_it(
    arguments: list[str], sentence: str, capsys: pytest.CaptureFixture[str]
) -> None:
    with pytest.raises(SystemExit) as ended:
        program.main(arguments)
    assert ended.value.code == program.BAD_USAGE
    assert sentence in capsys.readouterr().err
