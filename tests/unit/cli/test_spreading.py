"""Fills on several processes: their folder goes with their work, and what killed ones left with the next."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from roam_core.cli.spreading import working_folder


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    return tmp_path


def test_what_a_killed_process_left_goes_and_nothing_else(place: Path) -> None:
    dead = subprocess.Popen([sys.executable, "-c", ""])
    dead.wait()
    kept = [f"roam-fill-{os.getpid()}-a", f"roam-other-{dead.pid}-a", "roam-fill-mine-a", "roam-fill-old"]
    for name in (*kept, f"roam-fill-{dead.pid}-a"):
        (place / name).mkdir()
        (place / name / "given.roam").write_text("{}")
    with working_folder() as folder:
        assert folder.parent == place
        assert sorted(path.name for path in place.iterdir()) == sorted([*kept, folder.name])
    assert sorted(path.name for path in place.iterdir()) == sorted(kept)
