"""`make test` runs every test in one part, and tells what failed and what was left out."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from threading import Event

import pytest

from scripts.run_tests import (
    ENGINE,
    KERNELS,
    LINT,
    SCREEN,
    STAGES,
    TRACKING,
    WINDOW,
    Part,
    left_out,
    run_lane,
    run_stage,
)


def test_what_one_part_leaves_out_another_runs() -> None:
    parts = [part for lanes in STAGES for lane in lanes for part in lane]
    assert sorted(part.name for part in parts) == ["engine", "kernels", "lint", "screen", "tracking", "window"]
    ignored = {word.removeprefix("--ignore=") for word in ENGINE.words if word.startswith("--ignore=")}
    assert ignored == {TRACKING.words[0], WINDOW.words[0]}
    assert (WINDOW.words[1:], SCREEN.words) == (("-m", "not xvfb"), (WINDOW.words[0], "-m", "xvfb"))
    assert (KERNELS.environment, LINT.words) == ({"NUMBA_DISABLE_JIT": "1"}, ())


@pytest.fixture
def small(tmp_path: Path) -> Part:
    """A part of a test that fails, one that does not, and one that is skipped."""
    path = tmp_path / "test_small.py"
    path.write_text(
        "import pytest\ndef test_a(): assert False\ndef test_b(): pass\ndef test_c(): pytest.skip('no reason')\n",
        encoding="utf-8",
    )
    return Part("small", (str(path), "-p", "no:cacheprovider", f"--rootdir={tmp_path}"))


def test_a_failed_part_is_named_and_a_skipped_test_told(
    small: Part, tmp_path: Path, capfd: pytest.CaptureFixture[str]
) -> None:
    good = replace(small, name="good", words=(*small.words, "--deselect", "test_small.py::test_a"))
    assert run_stage(((good,), (small,)), tmp_path) == ["small"]
    first, *skipped = left_out(tmp_path)
    assert first == "== 5 tests, 2 of them skipped"
    assert skipped == ["   skipped test_small.test_c: no reason"] * 2
    assert "1 failed, 1 passed, 1 skipped" in capfd.readouterr().out


def test_after_an_interruption_no_part_begins(small: Part, tmp_path: Path) -> None:
    stopped = Event()
    stopped.set()
    assert run_lane((small,), tmp_path, stopped, is_live=False) == []
    assert list(tmp_path.glob("*.xml")) == []
