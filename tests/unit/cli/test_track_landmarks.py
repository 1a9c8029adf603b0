"""`roam track --landmarks OUT.nk`: the nodes, what is refused before any work, and what is left behind."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.geometry import similarity
from roam_core.params import CONFIGS
from roam_core.roto import edit, file
from tests.golden.shots import inverse
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal, tree
from tests.unit.interchange.test_nuke_landmarks import judged

WITH = [name for name, params in CONFIGS.items() if params.landmarks is not None]
WITHOUT = [name for name, params in CONFIGS.items() if params.landmarks is None]
HEIGHT = SHOT.size[0]


@pytest.mark.parametrize("config", WITH)
def test_landmarks_become_tracks_that_go_with_the_object(roam: Roam, plate: Plate, config: str) -> None:
    out = plate.folder.parent / "landmarks.nk"
    done = roam("track", plate.folder, "--init", plate.mask, "--config", config, "--landmarks", out)
    assert (done.status, done.out) == (0, "")
    assert done.err.endswith("Tracked 1 shape(s) from frame 1001 to 1006.\n")
    (node,) = judged(out, HEIGHT)
    assert node.knobs["reference_frame"] == "1001"
    assert node.rows
    assert 1001 in {frame for row in node.rows for frame in row.places}
    for row in node.rows:
        frames = list(row.places)
        on_body = similarity.apply(inverse(SHOT.poses[frames[0] - 1001]), np.array([row.places[frames[0]]]))
        true = np.vstack([similarity.apply(SHOT.poses[frame - 1001], on_body) for frame in frames])
        # A body of 22 pixels: every patch of 32 sees the background glide the other way, too.
        assert np.hypot(*(np.array(list(row.places.values())) - true).T).max() < 1.5


def test_writing_landmarks_changes_nothing_else(roam: Roam, plate: Plate) -> None:
    folder = plate.folder.parent
    words = ("track", plate.folder, "--init", plate.mask, "--config", "medium", "--save")
    assert roam(*words, folder / "a.roam").status == 0
    assert roam(*words, folder / "b.roam", "--landmarks", folder / "one.nk", "--json").status == 0
    assert (folder / "a.roam").read_bytes() == (folder / "b.roam").read_bytes()
    assert roam(*words, folder / "b.roam", "--landmarks", folder / "two.nk").status == 0
    assert (folder / "one.nk").read_bytes() == (folder / "two.nk").read_bytes()


def test_backward(roam: Roam, plate: Plate) -> None:
    out = plate.folder.parent / "landmarks.nk"
    words = ("--init", plate.last_mask, "--backward", "--config", "medium", "--landmarks", out)
    assert roam("track", plate.folder, *words).status == 0
    (node,) = judged(out, HEIGHT)
    assert node.knobs["reference_frame"] == "1006"
    assert all(row.name.split()[-1].startswith("1006-") for row in node.rows)


def test_the_start_frame_alone(roam: Roam, plate: Plate) -> None:
    out = plate.folder.parent / "landmarks.nk"
    words = ("--init", plate.mask, "--end", 1001, "--config", "medium", "--landmarks", out)
    assert roam("track", plate.folder, *words).status == 0
    (node,) = judged(out, HEIGHT)
    assert {tuple(row.places) for row in node.rows} == {(1001,)}


def test_an_interrupted_run_writes_what_is_finished(roam: Roam, plate: Plate, interrupt: Callable[[int], None]) -> None:
    interrupt(1003)
    out = plate.folder.parent / "landmarks.nk"
    done = roam("track", plate.folder, "--init", plate.mask, "--config", "medium", "--landmarks", out)
    assert done.status == 130
    (node,) = judged(out, HEIGHT)
    assert {frame for row in node.rows for frame in row.places} == {1001, 1002, 1003}


def test_an_interruption_before_the_first_frame_writes_nothing(
    roam: Roam, plate: Plate, interrupt: Callable[[int], None]
) -> None:
    interrupt(0)
    out = plate.folder.parent / "landmarks.nk"
    assert roam("track", plate.folder, "--init", plate.mask, "--config", "medium", "--landmarks", out).status == 130
    assert not out.exists()


def test_hostile_names_of_shapes_are_inert(roam: Roam, plate: Plate) -> None:
    path, out = plate.folder.parent / "p.roam", plate.folder.parent / "landmarks.nk"
    roam("track", plate.folder, "--init", plate.mask, "--end", 1001, "--save", path)
    project = file.load(path)
    name = '[exit] } { "$x\\\n</Object>'
    file.save(edit.set_properties(project, project.shapes[0].id, name=name), path)
    assert roam("track", plate.folder, "--init", path, "--config", "medium", "--landmarks", out).status == 0
    (node,) = judged(out, HEIGHT)
    assert {row.name.rsplit(" ", 1)[0] for row in node.rows} == {name}


# ---- refused ---------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("config", WITHOUT)
def test_a_configuration_without_landmarks(roam: Roam, plate: Plate, config: str) -> None:
    folder = plate.folder.parent
    before = tree(folder)
    words = ("--config", config, "--landmarks", folder / "a.nk", "--save", folder / "p.roam", "--matte", folder / "m")
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *words), config, "medium and full")
    assert tree(folder) == before


def test_the_standard_configuration_has_none(roam: Roam, plate: Plate) -> None:
    out = plate.folder.parent / "a.nk"
    require_refusal(roam("track", plate.folder, "--init", plate.mask, "--landmarks", out), "best", "--config")


@pytest.mark.parametrize(
    ("target", "words"),
    [
        ("none/a.nk", ["none", "does not exist"]),
        ("a.roam", ["a.roam", ".nk"]),
        ("a", [".nk"]),
        ("folder.nk", ["folder.nk", "is a folder"]),
        ("first.png", ["first.png", ".nk"]),
    ],
)
def test_targets_that_cannot_be(roam: Roam, plate: Plate, target: str, words: list[str]) -> None:
    folder = plate.folder.parent
    (folder / "folder.nk").mkdir()
    before = tree(folder)
    options = ("--config", "medium", "--landmarks", folder / target, "--save", folder / "p.roam")
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *options), *words)
    assert tree(folder) == before


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write anywhere")
def test_a_folder_that_may_not_be_written_to(roam: Roam, plate: Plate) -> None:
    locked = plate.folder.parent / "locked"
    locked.mkdir(mode=0o500)
    options = ("--config", "medium", "--landmarks", locked / "a.nk")
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *options), locked, "cannot be written to")


def test_one_file_for_two_things(roam: Roam, plate: Plate) -> None:
    out = plate.folder.parent / "a.nk"
    options = ("--config", "medium", "--landmarks", out, "--save", out)
    require_refusal(roam("track", plate.folder, "--init", plate.mask, *options), f"{out} would be written twice")
    assert not out.exists()


def test_an_object_without_a_mark_has_nothing_to_write(roam: Roam, plate: Plate, tmp_path: Path) -> None:
    """Known only at the end: the project is kept, and the sentence says what is missing."""
    for frame in SHOT.frames:
        flat = np.full((*SHOT.size, 3), 90, np.uint8)
        cv2.imwrite(str(plate.folder / f"plate.{frame}.png"), flat)
    out, path = tmp_path / "a.nk", tmp_path / "p.roam"
    words = ("--init", plate.mask, "--config", "medium", "--landmarks", out, "--save", path)
    done = roam("track", plate.folder, *words)
    before, reason = done.err.splitlines()
    assert (done.status, done.out) == (1, "")
    assert before.startswith("roam: Frame 1001 is of one tone in and around the shapes")
    assert reason.startswith("roam: No landmark was found")
    assert str(out) in reason
    assert not out.exists()
    assert file.load(path).shapes[0].frames == tuple(SHOT.frames)
