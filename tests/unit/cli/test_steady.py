"""`roam steady`: tracked keys moved so that they boil less, told in a sentence and in JSON, and what it refuses."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.media import open_clip
from roam_core.propagate.steadiness import steadying
from roam_core.roto import Clip, Origin, Project, edit, file
from tests.golden.shots import blob, gliding
from tests.unit.cli.conftest import Roam
from tests.unit.cli.test_bad_input import require_refusal
from tests.unit.propagate.steadiness.test_steadied import FRAMES, RADII, drawn


@pytest.fixture
def trembling(tmp_path: Path) -> Path:
    """A project with a body whose tracked keys tremble."""
    shot = gliding(blob(RADII), len(FRAMES), (60.0, 60.0), (2.3, 0.7), drift=(-0.6, 0.4))
    (tmp_path / "plate").mkdir()
    for frame in FRAMES:
        cv2.imwrite(str(tmp_path / "plate" / f"plate.{frame}.png"), shot.read(frame)[..., ::-1])
    rng = np.random.default_rng(5)
    shape = drawn(shot, {frame: rng.normal(0.0, 0.8, len(RADII)) for frame in FRAMES})
    path = tmp_path / "p.roam"
    file.save(edit.add_shape(Project(Clip.of(open_clip(tmp_path / "plate"))), shape), path)
    return path


def test_tracked_keys_move_and_the_boil_is_told(roam: Roam, trembling: Path) -> None:
    (before,) = file.load(trembling).shapes
    done = roam("steady", trembling)
    (after,) = file.load(trembling).shapes
    assert (done.status, done.out) == (0, "")
    moved = [key for key in after.keys if key != before.key_at(key.frame)]
    assert [key.origin for key in moved] == [Origin.ENGINE] * 8
    assert [key.inputs for key in after.keys] == [key.inputs for key in before.keys]
    words = done.err.split()
    assert done.err == f"8 keys moved; boil by the picture {words[7]} px before, {words[10]} px now.\n"
    assert float(words[10]) < 0.7 * float(words[7])


def test_a_part_is_saved_elsewhere_and_told_in_json(roam: Roam, trembling: Path, tmp_path: Path) -> None:
    as_it_was, target = trembling.read_bytes(), tmp_path / "steady.roam"
    words = ("--strength", 1, "--start", 1003, "--end", 1005, "--shape", "Body", "--save", target, "--json")
    done = roam("steady", trembling, *words)
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [(line["shape"], line["frame"]) for line in lines] == [("Body", frame) for frame in (1003, 1004, 1005)]
    assert all(line["moved"] > 0 for line in lines)
    assert sum(line["boil"] for line in lines) < sum(line["boil_before"] for line in lines)
    before, after = file.load(trembling).shapes[0], file.load(target).shapes[0]
    assert [key.frame for key in after.keys if key != before.key_at(key.frame)] == [1003, 1004, 1005]
    assert trembling.read_bytes() == as_it_was


def test_frames_that_hold_no_tracked_key_cost_nothing(
    roam: Roam, trembling: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Every frame up to the one that was named was gone through: a minute for a number of nine digits."""
    given: list[range] = []
    whole = steadying.steadying
    monkeypatch.setattr(steadying, "steadying", lambda *words: (given.append(words[2]), whole(*words))[1])
    for k, words in enumerate([(), ("--start", -999_999_999, "--end", 999_999_999)]):
        assert roam("steady", trembling, *words, "--save", tmp_path / f"{k}.roam").status == 0
    assert given[0] == given[1]
    assert file.load(tmp_path / "0.roam") == file.load(tmp_path / "1.roam")


def test_a_strength_of_nothing_changes_nothing(roam: Roam, trembling: Path) -> None:
    before = file.load(trembling).shapes
    done = roam("steady", trembling, "--strength", 0, "--json")
    assert (done.status, done.out) == (0, "")
    assert done.err == "No tracked key could be steadied; nothing was changed.\n"
    assert file.load(trembling).shapes == before


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--strength", "1.5"), "--strength 1.5 is not between 0 and 1"),
        (("--strength", "-0.1"), "is not between"),
        (("--strength", "nan"), "is not between"),
        (("--shape", "other"), "There is no"),
        (("--start", "1005", "--end", "1003"), "--start 1005 lies after --end 1003"),
        (("--start", "1020"), "--start 1020 lies after the last tracked key, which is on frame "),
        (("--end", "12"), "--end 12 lies before the first tracked key, which is on frame "),
    ],
)
def test_what_cannot_be_is_refused(roam: Roam, trembling: Path, words: tuple[str, ...], sentence: str) -> None:
    before = trembling.read_bytes()
    require_refusal(roam("steady", trembling, *words), sentence)
    assert trembling.read_bytes() == before


def test_nothing_to_steady_is_refused(roam: Roam, trembling: Path) -> None:
    project = file.load(trembling)
    (shape,) = project.shapes
    for other in (replace(shape, locked=True), replace(shape, keys=shape.artist_keys)):
        file.save(project.with_shape(other), trembling)
        require_refusal(roam("steady", trembling))
        assert file.load(trembling).shapes == (other,)
