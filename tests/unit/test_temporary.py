"""Temporary folders of a work: they go with it, and what killed processes left goes with the next of that work."""

from __future__ import annotations

import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest

from roam_core.temporary import working_folder


@pytest.fixture(autouse=True)
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setattr("tempfile.tempdir", str(tmp_path))
    return tmp_path


def test_what_a_killed_process_left_goes_and_nothing_else(place: Path) -> None:
    dead = subprocess.Popen([sys.executable, "-c", ""])
    dead.wait()
    here = f"roam-fill-{platform.node()}"
    elsewhere = [f"roam-other-{dead.pid}-a", f"roam-fill-{dead.pid}-a", f"roam-fill-render-07-{dead.pid}-a"]
    kept = [f"{here}-{os.getpid()}-a", f"{here}-mine-a", "roam-fill-old", *elsewhere]
    for name in (*kept, f"{here}-{dead.pid}-a"):
        (place / name).mkdir()
        (place / name / "given.roam").write_text("{}")
    with working_folder("roam-fill") as folder:
        assert folder.parent == place
        assert sorted(path.name for path in place.iterdir()) == sorted([*kept, folder.name])
    assert sorted(path.name for path in place.iterdir()) == sorted(kept)
