"""The command line of the benchmarks."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

import pytest

from benchmarks import artist, davis, processes, report, shots
from benchmarks.__main__ import BENCHMARKS, main
from benchmarks.shots import Shot


def one_by_one(function: Callable[[Any], Any], jobs: Iterable[Any], **_: object) -> list[Any]:
    return [function(job) for job in jobs]


@pytest.fixture
def beside(monkeypatch: pytest.MonkeyPatch, tmp_path: Path, sliding: Shot, gliding: Shot) -> Path:
    """Two tiny shots in place of those beside the repository, worked on in this process; results go to a folder."""
    known = {shot.name: shot for shot in (sliding, gliding)}
    monkeypatch.setattr(shots, "load", known.__getitem__)
    monkeypatch.setattr(shots, "names", lambda wanted=None: wanted.split(",") if wanted else list(known))
    monkeypatch.setattr(processes, "each", one_by_one)
    monkeypatch.setattr(report, "OUT", tmp_path / "out")
    monkeypatch.setattr(report, "ROOT", tmp_path)
    return tmp_path / "out"


@pytest.mark.parametrize("name", list(BENCHMARKS))
def test_every_benchmark_explains_itself(name: str, capsys: pytest.CaptureFixture[str]) -> None:
    with pytest.raises(SystemExit) as end:
        main([name, "--help"])
    assert end.value.code == 0
    assert "usage: python -m benchmarks" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("words", "complaint"),
    [
        (["artist", "--peers", "nobody"], "There is no peer 'nobody'"),
        (["artist", "--threshold", "high"], "--threshold high"),
        (["artist", "--threshold", "1.5"], "--threshold 1.5"),
        (["artist", "--parts", "keys,nothing"], "--parts keys,nothing"),
        (["artist", "--config", "worst"], "There is no configuration 'worst'"),
        (["davis", "--config", "worst"], "There is no configuration 'worst'"),
        (["stages", "--config", "worst"], "There is no configuration 'worst'"),
        (["stages", "--frames", "1"], "--frames 1"),
        (["speed", "--config", "worst"], "There is no configuration 'worst'"),
        (["drift", "--config", "worst"], "There is no configuration 'worst'"),
        (["tune", "--field", "size=1"], "no field 'size'"),
        (["tune", "--field", "mu"], "--field mu is not NAME=V,W"),
        (["tune", "--field", "mu=much"], "mu holds a float"),
    ],
)
def test_a_wrong_word_is_answered_by_a_sentence(
    words: list[str], complaint: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(words) == 1
    assert complaint in capsys.readouterr().err


def test_shots_that_are_not_there_are_asked_for(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(shots, "FOLDER", tmp_path)
    monkeypatch.setattr(shots, "SCORE", tmp_path / "none")
    assert main(["artist"]) == 1
    assert "The shots are not here" in capsys.readouterr().err


def test_the_artist_counts_what_was_placed(beside: Path, capsys: pytest.CaptureFixture[str]) -> None:
    words = ["artist", "--peers", "hold,linear", "--config", "", "--threshold", "0.8", "--shots", "sliding"]
    assert main([*words, "--parts", "edits,keys"]) == 0
    found = json.loads((beside / "artist-keys-some.json").read_text(encoding="utf-8"))["shots"]["sliding"]
    # Four edits over the twelve frames after the first; five and two keys over the thirteen of the shot.
    assert found["hold"]["edits 0.8"] == pytest.approx(100 * 4 / 12)
    assert found["hold"]["keys 0.8"] == pytest.approx(100 * 5 / 13)
    assert found["linear"]["keys 0.8"] == pytest.approx(100 * 2 / 13)
    shown = capsys.readouterr().out
    assert [line.split()[-4::2] for line in shown.splitlines() if line.startswith("| sliding")] == [
        ["33.3", "33.3"],
        ["38.5", "15.4"],
    ]


def test_results_are_kept(beside: Path) -> None:
    assert main(["artist", "--peers", "hold", "--config", "", "--threshold", "0.8", "--parts", "gap"]) == 0
    assert [path.name for path in beside.iterdir()] == ["artist-gap.json"]


@pytest.mark.usefixtures("beside")
def test_tuning_tries_all_values_on_all_shots(capsys: pytest.CaptureFixture[str]) -> None:
    words = ["tune", "--config", "baseline", "--field", "mu=0.05,0.5", "--length", "2", "--gap", "20"]
    assert main(words) == 0
    shown = capsys.readouterr().out
    assert shown.count("| present |") == 1
    assert "Leave-one-shot-out: 0." in shown


def test_a_shot_counts_unless_its_own_outlines_fail_often() -> None:
    assert not artist.leaves_out([0.95] * 19 + [0.85], 0.9)
    assert artist.leaves_out([0.95] * 18 + [0.85] * 2, 0.9)


def test_all_configurations_stand_in_one_table() -> None:
    mean = {"iou": 0.5, "acc": 0.9, "f": 0.4, "sec_per_frame": 0.02}
    scored = {"mean": mean, "shots": [{}], "restarts": {"a": {"mean": 0.6, "spread": 0.1}}}
    table = davis._summary({"baseline": scored, "best": scored | {"restarts": {}}})
    assert "0.600 ± 0.100" in table
    assert [line.split("|")[1].strip() for line in table.splitlines() if "`b" in line] == ["`baseline`", "`best`"]
    assert "paper: Full, validation" in table
