"""What the scores of parts come to, on squares whose places are known."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from benchmarks import figures, parts, processes, report
from benchmarks.__main__ import main
from benchmarks.figures import Figure
from benchmarks.parts import Score
from roam_core.geometry import bezier
from roam_core.roto import Keyframe, RotoShape
from tests.unit.benchmarks.test_main import one_by_one

COUNT = 5
SQUARE = np.array([[20.0, 20.0], [60.0, 20.0], [60.0, 60.0], [20.0, 60.0]])


def moved(step: tuple[float, float], frame: int) -> np.ndarray:
    return np.array([[1.0, 0.0, step[0] * frame], [0.0, 1.0, step[1] * frame], [0.0, 0.0, 1.0]])


@pytest.fixture
def pair() -> Figure:
    """A square that moves by two pixels a frame, and a nearer one that lies still over its right part."""
    steps, rest = {"far": (2.0, 0.0), "near": (0.0, 0.0)}, {"far": SQUARE, "near": SQUARE + np.array([30.0, 0.0])}
    motions = {part: [moved(step, frame) for frame in range(COUNT)] for part, step in steps.items()}
    lines = {part: [rest[part] + motion[:2, 2] for motion in motions[part]] for part in steps}
    background = np.random.default_rng(3).integers(0, 255, (100, 140, 3)).astype(np.uint8)
    return Figure("pair", [cv2.GaussianBlur(background, (0, 0), 1.0)] * COUNT, ("far", "near"), lines, motions)


def test_what_is_hidden_may_lie_anywhere_and_what_leaks_counts(pair: Figure) -> None:
    truth = [pair.whole("far", frame) for frame in pair.frames[1:]]
    assert parts.seen_overlaps(pair, "far", truth) == [1.0] * 4
    behind = [matte | pair.whole("near", frame) for frame, matte in enumerate(truth, start=1)]
    first, *_ = parts.seen_overlaps(pair, "far", behind)
    # Of the near square (50 to 90) the far one hides 50 to 62; the other 28 columns are a leak beside 28 that are seen.
    assert first == pytest.approx(28 / 56)
    lost = [matte & ~pair.whole("near", frame) for frame, matte in enumerate(truth, start=1)]
    assert parts.seen_overlaps(pair, "far", lost) == [1.0] * 4


def test_frames_on_which_nothing_is_seen_are_not_scored(pair: Figure) -> None:
    pair.lines["far"][2] = pair.lines["near"][2] + (0.5, 0.0)  # type: ignore[index]
    truth = [pair.whole("far", frame) for frame in pair.frames[1:]]
    assert parts.seen_overlaps(pair, "far", truth) == [1.0, None, 1.0, 1.0]


def test_keys_are_not_scored_nor_what_lies_behind_them(pair: Figure) -> None:
    truth = [pair.whole("near", frame) for frame in pair.frames[1:]]
    assert parts.seen_overlaps(pair, "near", truth, [0, 3]) == [1.0, 1.0, None, None]


def test_a_part_is_held_until_it_is_first_lost() -> None:
    assert parts.score([0.9, None, 0.7, 0.8, None]) == Score(pytest.approx(0.8), 0.8, pytest.approx(2 / 3), 2)
    assert parts.score([None, 0.9, None]).held == 3


def test_a_slide_is_told_from_the_true_motion(pair: Figure) -> None:
    points = bezier.polygon_points(SQUARE.tolist())
    standing = RotoShape("far", "Far", (Keyframe(0, points),))
    assert parts.slide(pair, standing) == pytest.approx(2.0 * (1 + 2 + 3 + 4) / 4)
    following = RotoShape(
        "far", "Far", tuple(Keyframe(frame, points + np.array([2.0 * frame, 0.0])) for frame in pair.frames)
    )
    assert parts.slide(pair, following) == pytest.approx(0.0)


def test_straight_keys_meet_the_truth_of_an_even_motion(pair: Figure) -> None:
    np.testing.assert_allclose(parts.linear(pair.lines["far"], [0, 2, 4]), pair.lines["far"][1:])
    held = parts.linear(pair.lines["far"], [0, 2])
    np.testing.assert_allclose(held[1:], [pair.lines["far"][2]] * 3)


def test_the_whole_is_the_union(pair: Figure) -> None:
    union = [pair.union(pair.order, frame) for frame in pair.frames[1:]]
    assert parts.whole_overlap(pair, union) == 1.0
    assert parts.whole_overlap(pair, [pair.whole("near", frame) for frame in pair.frames[1:]]) < 0.9


def test_the_least_margin_names_its_shot_and_part() -> None:
    def shot(alone: float, together: float) -> dict[str, object]:
        return {"parts": {"alone": {"arm": {"iou": alone}}, "together": {"arm": {"iou": together}}}}

    found = {"a": shot(0.5, 0.9), "b": shot(0.9, 0.8)}
    assert parts.least_margin(found, "together", "alone") == (pytest.approx(-0.1), "b", "arm")


def test_a_hidden_part_is_not_drawn(pair: Figure) -> None:
    assert pair.drawn == ("far", "near")
    pair.lines["far"][0] = pair.lines["near"][0] - (5.0, 0.0)  # type: ignore[index]
    pair._masks.clear()
    assert pair.drawn == ("near",)


def test_a_walker_agrees_with_its_masks() -> None:
    figure = figures.of_walker(0, 2)
    assert figure.drawn == figure.order
    assert figure.size == (540, 960)
    shape = parts.first_shapes(figure)[0]
    assert shape.id == figure.order[0]
    true = figure.lines["torso"][1]
    carried = figure.since("torso", 1) @ np.column_stack([figure.lines["torso"][0], np.ones(len(true))]).T
    np.testing.assert_allclose(carried[:2].T, true, atol=1e-8)


def test_puppets_that_are_not_there_are_said_to_be_left_out(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(figures, "PUPPET", tmp_path / "none.py")
    assert main(["parts", "--seeds", "", "--puppets", "1"]) == 0
    assert "The puppets are left out" in capsys.readouterr().err


@pytest.mark.parametrize(("words", "complaint"), [(["--seeds", "a"], "--seeds a"), (["--frames", "3"], "--frames 3")])
def test_a_wrong_word_is_answered(words: list[str], complaint: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["parts", *words]) == 1
    assert complaint in capsys.readouterr().err


def test_the_tables_hold_what_was_measured(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path, pair: Figure, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(figures, "of_walker", lambda _seed, _count: pair)
    monkeypatch.setattr(processes, "each", one_by_one)
    monkeypatch.setattr(report, "OUT", tmp_path / "out")
    monkeypatch.setattr(report, "ROOT", tmp_path)
    monkeypatch.setattr(parts, "GAP", 2)
    assert main(["parts", "--seeds", "7", "--frames", "4", "--puppets", ""]) == 0
    found = json.loads((tmp_path / "out" / "parts-some.json").read_text(encoding="utf-8"))
    by_method = found["shots"]["walker 7"]["parts"]
    assert set(by_method) == set(parts.METHODS)
    assert by_method["linear keys"]["far"]["iou"] == pytest.approx(1.0)
    assert found["times"]["walker 7"]["parts"] > 0.0
    shown = capsys.readouterr().out
    assert "| linear keys" in shown
    assert "Least margin of a part" in shown
