"""`make setup`: what it does again, and what it leaves alone."""

from __future__ import annotations

import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import ROOT

pytestmark = pytest.mark.skipif(shutil.which("make") is None, reason="make is not installed")


@pytest.fixture
def checkout(tmp_path: Path) -> Path:
    """A folder with a space in its name in which everything is installed, older than nothing that it came from."""
    folder = tmp_path / "my roam"
    for name in ("Makefile", "pyproject.toml", "constraints.txt", "scripts/system-libraries"):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)
    python = folder / ".venv" / "bin" / "python"
    python.parent.mkdir(parents=True)
    python.write_text("#!/bin/sh\n", encoding="utf-8")
    python.chmod(0o755)
    (folder / ".venv" / ".ready").write_text(f"{folder.resolve()}\n", encoding="utf-8")
    return folder


def steps(folder: Path) -> str:
    """What make would do; of other makes that run this test it hears nothing."""
    environment = {name: value for name, value in os.environ.items() if not name.startswith(("MAKE", "MFLAGS"))}
    command = ["make", "--dry-run", "setup", "PYTHON=python3"]
    done = subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True, check=True)
    return done.stdout


def test_what_is_installed_is_left_alone(checkout: Path) -> None:
    assert "venv" not in steps(checkout)
    (checkout / ".venv" / ".ready").write_text("", encoding="utf-8")  # as it was before it held the folder
    assert "venv" not in steps(checkout)


def test_other_requirements_are_installed_into_the_same_environment(checkout: Path) -> None:
    later = (checkout / ".venv" / ".ready").stat().st_mtime + 60
    os.utime(checkout / "pyproject.toml", (later, later))
    said = steps(checkout)
    assert "pip install" in said
    assert 'test -z "" && test -x .venv/bin/python' in said


def test_in_a_folder_that_was_moved_everything_is_installed_anew(checkout: Path) -> None:
    moved = checkout.rename(checkout.with_name("roam"))
    said = steps(moved)
    assert 'test -z "yes" && test -x .venv/bin/python; } || python3 -m venv --clear .venv' in said
    assert "pip install" in said
