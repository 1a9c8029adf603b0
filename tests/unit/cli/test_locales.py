"""Names of files that are no UTF-8, and terminals that show ASCII only: every command opens them, and prints."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.unit.cli.conftest import Plate, Roam

ODD = "caf\udce9 \N{HAIRCUT}"
LOCALES = (
    {"LANG": "C"},
    {"LC_ALL": "POSIX"},
    {"LC_ALL": "C", "PYTHONUTF8": "0", "PYTHONCOERCECLOCALE": "0"},
    {"PYTHONIOENCODING": "ascii:strict"},
)


@pytest.fixture
def odd(tmp_path: Path, plate: Plate) -> Path:
    """The plate's folder under a name that is no UTF-8."""
    try:
        return plate.folder.rename(tmp_path / ODD)
    except OSError:
        pytest.skip("this file system refuses names that are not UTF-8")


def test_tracking_exporting_rendering_and_telling(odd: Path, plate: Plate, tmp_path: Path, roam: Roam) -> None:
    mask = plate.mask.rename(tmp_path / f"mask {ODD}.png")
    project = tmp_path / f"{ODD}.roam"
    assert roam("track", odd, "--init", mask, "--config", "baseline", "--save", project).status == 0
    assert roam("export", project, tmp_path / f"{ODD}.nk", "--to", "nuke").status == 0
    assert (tmp_path / f"{ODD}.nk").exists()
    assert roam("render", project, "--out", tmp_path / f"out {ODD}").status == 0
    assert len(list((tmp_path / f"out {ODD}").iterdir())) == len(list(odd.iterdir()))


@pytest.mark.parametrize("locale", LOCALES, ids=str)
def test_what_no_terminal_can_show_is_printed_escaped(odd: Path, locale: dict[str, str]) -> None:
    plain = {name: value for name, value in os.environ.items() if not name.startswith(("LC_", "LANG", "PYTHON"))}
    done = subprocess.run(
        [sys.executable, "-m", "roam_core", "info", os.fsencode(odd)],
        cwd=ROOT,
        env=plain | locale,
        capture_output=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert b"frames   " in done.stdout
    assert b"caf" in done.stdout
