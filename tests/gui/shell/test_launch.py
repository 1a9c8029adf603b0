"""`roam` where the window is installed: without a display, with a wrong path, with a command."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from app import folders
from roam_core.cli import program
from roam_core.errors import RoamError
from tests.gui.waiting import WAIT
from tests.gui.windows import write_clip

DISPLAYS = ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")


@pytest.fixture
def no_display(monkeypatch: pytest.MonkeyPatch) -> None:
    for name in DISPLAYS:
        monkeypatch.delenv(name, raising=False)


@pytest.mark.skipif(sys.platform in ("win32", "darwin"), reason="there is always a display there")
class TestWithoutADisplay:
    def test_a_window_is_refused_in_one_sentence(
        self, no_display: None, capsys: pytest.CaptureFixture[str], tmp_path: Path
    ) -> None:
        assert program.main([str(write_clip(tmp_path / "plate", 1))]) == program.BAD_USAGE
        error = capsys.readouterr().err
        assert error.count("\n") == 1
        assert "no display" in error

    def test_the_demo_is_tracked_on_the_command_line(
        self, no_display: None, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
    ) -> None:
        asked: list[list[str]] = []
        monkeypatch.setattr(program, "command_line", lambda argv: asked.append(argv) or 0)
        assert program.main(["demo"]) == 0
        assert asked == [["demo", "--headless"]]
        assert "without a window" in capsys.readouterr().err


@pytest.mark.parametrize("path", ["nowhere", "nowhere.roam", "nowhere.%04d.png"])
def test_a_path_that_is_not_there_is_one_sentence(
    tmp_path: Path, capsys: pytest.CaptureFixture[str], path: str
) -> None:
    assert program.main([str(tmp_path / path)]) == program.FAILED
    error = capsys.readouterr().err
    assert error.startswith("roam: ")
    assert error.count("\n") == 1
    assert "nowhere" in error


def test_state_goes_to_a_private_folder_where_the_artists_own_cannot_be_written_to(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr("platformdirs.user_state_path", lambda *_, **__: tmp_path / "own")
    assert folders.state_folder() == tmp_path / "own"
    assert folders.state_trouble() == ""
    assert folders.other_state_folders() == ()
    (tmp_path / "file").touch()
    monkeypatch.setattr("platformdirs.user_state_path", lambda *_, **__: tmp_path / "file" / "roam")
    monkeypatch.setattr("platformdirs.user_cache_path", lambda *_, **__: tmp_path / "file" / "roam")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    state = folders.state_folder()
    assert state.parent == tmp_path
    assert state == folders.state_folder(), "what is autosaved there is found again"
    assert folders.cache_folder() not in (state, tmp_path / "file" / "roam")
    assert f"are kept in {state} for now" in folders.state_trouble()
    assert folders.other_state_folders() == (tmp_path / "file" / "roam",)
    monkeypatch.setattr("platformdirs.user_state_path", lambda *_, **__: tmp_path / "own")
    assert folders.other_state_folders() == (state,), "what was kept there is offered when the artist's own is back"
    state.chmod(0o777)
    assert folders.other_state_folders() == () or os.name == "nt", "others may have put anything there"
    monkeypatch.setattr("platformdirs.user_state_path", lambda *_, **__: tmp_path / "file" / "roam")
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path / "file"))
    with pytest.raises(RoamError, match=r"Neither .* nor a temporary folder can be written to"):
        folders.state_folder()


def test_commands_are_handed_on_without_loading_qt() -> None:
    program = (
        "import sys; from roam_core.cli.program import main; code = main(['info', '/nowhere.roam']); "
        "sys.exit(code if not any(name.startswith('PySide6') for name in sys.modules) else 99)"
    )
    result = subprocess.run(
        [sys.executable, "-c", program], capture_output=True, text=True, timeout=WAIT / 1000, check=False
    )
    assert result.returncode == 1, result.stderr
    assert result.stderr.startswith("roam: ")
