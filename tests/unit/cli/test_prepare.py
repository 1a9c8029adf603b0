"""`roam prepare`: all that has to be compiled is asked for once, step by step."""

from __future__ import annotations

import json
import tempfile
from pathlib import Path

import cv2
import pytest

from roam_core.cli import main, prepare
from roam_core.kernels import coverage
from roam_core.params import CONFIGS


def test_every_step_is_done_once_and_the_end_is_told(
    monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    done = list[str]()
    monkeypatch.setattr(prepare, "work", lambda: [(name, lambda name=name: done.append(name)) for name in ("a", "b")])
    assert main(["prepare"]) == 0
    assert done == ["a", "b"]
    assert capsys.readouterr().err.startswith("The engine is prepared")
    assert main(["prepare", "--json"]) == 0
    assert json.loads(capsys.readouterr().out)["seconds"].keys() == {"a", "b"}


def test_every_configuration_is_among_the_steps() -> None:
    names = [name for name, _ in prepare.work()]
    assert [name for name in names if name.startswith("tracking")] == [f"tracking ({config})" for config in CONFIGS]


@pytest.mark.parametrize("name", ["keys and mattes", "masks"])
def test_the_other_steps_do_their_work(name: str) -> None:
    steps = dict(prepare.work())
    steps[name]()


def test_masks_are_made_in_a_folder_whose_name_has_accents(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """Where a user of Windows is called so: OpenCV takes names in the letters of the machine there."""
    write = cv2.imwrite
    monkeypatch.setattr(cv2, "imwrite", lambda path, *given: path.isascii() and write(path, *given))
    (tmp_path / "J\u00fcrgen").mkdir()
    monkeypatch.setattr(tempfile, "tempdir", str(tmp_path / "J\u00fcrgen"))
    dict(prepare.work())["masks"]()


def test_mattes_of_hard_and_soft_shapes_that_move_are_made(monkeypatch: pytest.MonkeyPatch) -> None:
    """Motion blur of hard shapes has kernels of its own; they were compiled when the first of them was rendered."""
    made = set[str]()
    for name in ("coverage", "swept_coverage", "distance", "holds_centres"):
        kernel = getattr(coverage, name)
        monkeypatch.setattr(
            coverage, name, lambda *given, name=name, kernel=kernel: (made.add(name), kernel(*given))[1]
        )
    dict(prepare.work())["keys and mattes"]()
    assert made == {"coverage", "swept_coverage", "distance", "holds_centres"}
