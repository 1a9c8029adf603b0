"""The benchmark of the window measures what it says: a drag that moves a point, different frames that are painted."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtWidgets import QApplication

from benchmarks import report, window
from roam_core.roto import Layer

SMALL = (320, 180)


@pytest.fixture
def small(monkeypatch: pytest.MonkeyPatch, qapp: QApplication) -> None:
    """A small clip, looked at for a moment."""
    monkeypatch.setattr(window, "SIZE", SMALL)
    monkeypatch.setattr(window, "FRAMES", 4)
    monkeypatch.setattr(window.DrawnPlate.__init__, "__defaults__", (4, SMALL))
    monkeypatch.setattr(window, "scene", lambda: Layer("root", "Root", (window.ring(12),)))


def test_a_drag_moves_its_point_and_playback_paints_frames(small: None, tmp_path: Path) -> None:
    with window.opened_window(tmp_path) as shown:
        laps = window.drag_laps(shown, 10)
        assert len(laps) == 10
        assert min(min(lap) for lap in laps) > 0.0
        project = shown.document.project
        assert len(project.shapes[0].at(1).points) == window.DRAGGED_POINTS
        frames, spent = window.frames_a_second(shown, 50.0, 0.3)
        assert frames > 0.0
        assert spent > 0.0
        assert shown.playback.speed == 0.0


def test_the_drawn_plate_glides() -> None:
    plate = window.DrawnPlate(3, SMALL)
    first, second = plate.read(1), plate.read(2)
    assert first.shape == (180, 320, 3)
    np.testing.assert_array_equal(np.roll(first, 16, axis=1), second)
    assert plate.clip.size == SMALL


def test_the_table_says_what_was_aimed_at(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys) -> None:
    found = {
        "median": 7.25,
        "ninetieth": 9.0,
        "busy": 5.0,
        "shown": 24.0,
        "spent": 20.0,
        "most": 31.0,
        "start": 812.0,
        "work": 700.0,
    }
    monkeypatch.setattr(window, "_in_a_process", lambda platform: found)
    monkeypatch.setattr(report, "OUT", tmp_path)
    monkeypatch.setattr(report, "ROOT", tmp_path)
    parser = window.argparse.ArgumentParser()
    window.arguments(parser)
    window.run(parser.parse_args([]))
    told = capsys.readouterr().out
    rows = [[cell.strip() for cell in line.split("|")[2:4]] for line in told.splitlines() if "in memory" in line]
    assert ["7.2", "16"] in rows
    assert ["24.0", "24"] in rows
    assert (tmp_path / "window.json").is_file()


def test_two_checkouts_are_told_as_ratios(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys) -> None:
    here, there = (
        dict.fromkeys(("median", "ninetieth", "busy", "shown", "spent", "most", "start", "work"), 6.0),
        tmp_path,
    )
    asked: list[Path] = []

    def in_a_process(platform: str, root: Path = report.ROOT) -> dict[str, float]:
        asked.append(root)
        return here if root != there else dict.fromkeys(here, 8.0)

    monkeypatch.setattr(window, "_in_a_process", in_a_process)
    parser = window.argparse.ArgumentParser()
    window.arguments(parser)
    window.run(parser.parse_args(["--beside", str(tmp_path)]))
    rows = [[cell.strip() for cell in line.split("|")[2:5]] for line in capsys.readouterr().out.splitlines()]
    assert rows.count(["6.0", "8.0", "0.75"]) >= len(here)
    assert asked[:4] == [report.ROOT, tmp_path, report.ROOT, tmp_path]


def test_the_start_of_the_program_is_measured() -> None:
    command = [window.sys.executable, "-c", window.START, str(window.time.monotonic())]
    until_painted, of_processor = map(float, window._told(command, "offscreen", report.ROOT).split())
    assert min(until_painted, of_processor) > 0.0
