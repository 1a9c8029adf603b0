"""`roam fill`: between the artist's keys, again only where something changed, and what it refuses."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import pytest

from roam_core.cli.fill import line_of
from roam_core.cli.picking import Picking
from roam_core.media import open_clip
from roam_core.propagate.between.span import fill_span
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, file
from roam_core.roto import edit as verbs
from tests.golden.shots import overlap
from tests.unit.cli.conftest import SHOT, Plate, Roam, read_matte, write_picture
from tests.unit.cli.test_bad_input import require_refusal
from tests.unit.matte.conftest import rectangle

FRAMES = list(SHOT.frames)
CONFIG = ("--config", "baseline")


@pytest.fixture
def keyed(plate: Plate) -> Path:
    """A project with a shape that has the true outline on frames 1001, 1004 and 1006."""
    project, shape = verbs.new_shape(Project(Clip.of(open_clip(plate.folder))), SHOT.truth(1001), 1001)
    for frame in (1004, 1006):
        shape = verbs.set_key(shape, frame, SHOT.truth(frame))
    path = plate.folder.parent / "p.roam"
    file.save(project.with_shape(shape), path)
    return path


def test_every_gap_is_filled_and_the_artists_keys_stay(roam: Roam, plate: Plate, keyed: Path) -> None:
    before, out = file.load(keyed).shapes[0], plate.folder.parent / "mattes"
    done = roam("fill", keyed, *CONFIG, "--matte", out)
    assert (done.status, done.out, done.err) == (0, "", "Filled 2 gap(s).\n")
    (shape,) = file.load(keyed).shapes
    assert shape.frames == tuple(FRAMES)
    assert [key for key in shape.keys if key.origin is Origin.ARTIST] == list(before.keys)
    assert sorted(path.name for path in out.iterdir()) == [f"plate.{frame}.png" for frame in FRAMES]
    for frame in FRAMES:
        assert overlap(read_matte(out / f"plate.{frame}.png") > 127, SHOT.matte(frame) > 0.5) > 0.9


def test_what_other_processes_filled_is_counted_as_filled(roam: Roam, keyed: Path) -> None:
    """It was told as filled before, in no time."""
    other = keyed.with_name("other.roam")
    words = ("fill", keyed, *CONFIG, "--workers", 2, "--save", other)
    assert roam(*words).err == "Filled 2 gap(s).\n"
    other.unlink()
    seconds = {line["frame"]: line["seconds"] for line in map(json.loads, roam(*words, "--json").out.splitlines())}
    assert {frame for frame, took in seconds.items() if took > 0.0} == {1002, 1003, 1005}
    assert roam("fill", other, *CONFIG, "--workers", 2).err == "Filled 0 gap(s); 2 already filled.\n"


def test_what_is_filled_is_not_solved_again(roam: Roam, keyed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    assert roam("fill", keyed, *CONFIG).status == 0
    once = keyed.read_bytes()
    asked: list[tuple[int, int]] = []

    def watched(images: Any, shapes: Any, start: int, stop: int, *rest: Any, **options: Any) -> Any:
        asked.append((start, stop))
        return fill_span(images, shapes, start, stop, *rest, **options)

    monkeypatch.setattr("roam_core.propagate.fill_span", watched)
    assert roam("fill", keyed, *CONFIG).err == "Filled 0 gap(s); 2 already filled.\n"
    assert (asked, keyed.read_bytes()) == ([], once)
    project = file.load(keyed)
    moved = verbs.set_key(project.shapes[0], 1006, SHOT.truth(1006) + 1.0)
    file.save(project.with_shape(moved), keyed)
    assert roam("fill", keyed, *CONFIG).err == "Filled 1 gap(s); 1 already filled.\n"
    assert asked == [(1004, 1006)]


def test_frames_outside_of_lifetimes_are_no_missing_frames(roam: Roam, keyed: Path) -> None:
    project = file.load(keyed)
    file.save(verbs.set_properties(project, project.shapes[0].id, lifetime=(1001, 1003)), keyed)
    lines = [json.loads(line) for line in roam("fill", keyed, *CONFIG, "--json").out.splitlines()]
    ends = {line["frame"]: (line["termination"], line["confidence"]) for line in lines}
    assert [ends[frame] for frame in (1003, 1004)] == [("outside_lifetime", 1.0)] * 2


def test_frames_that_lie_in_no_gap_are_not_told(roam: Roam, plate: Plate) -> None:
    """Between the gaps of two shapes they were called missing, which made a batch's report doubt the job."""
    for frame in (1007, 1008):
        write_picture(plate.folder / f"plate.{frame}.png", SHOT.read(1006))
    project = Project(Clip.of(open_clip(plate.folder)))
    for name, keys, size in (("Early", (1001, 1003), 1.0), ("Late", (1006, 1008), 0.4)):
        project, shape = verbs.new_shape(project, SHOT.truth(1001) * size, keys[0], name=name)
        project = project.with_shape(verbs.set_key(shape, keys[1], SHOT.truth(1003) * size))
    path = plate.folder.parent / "two.roam"
    file.save(project, path)

    def told(*words: object) -> dict[int, str]:
        lines = map(json.loads, roam("fill", path, *CONFIG, "--json", *words).out.splitlines())
        return {line["frame"]: line["termination"] for line in lines}

    assert list(told()) == [1001, 1002, 1003, 1006, 1007, 1008]
    assert list(told("--shape", "Late")) == [1006, 1007, 1008]


def test_a_line_is_of_the_shapes_that_are_picked() -> None:
    """As those of `roam track`: what another shape is doubted for says nothing of a fill that left it out."""
    sure, lost = (
        replace(
            rectangle(0.0, 0.0, 9.0, 9.0),
            id=name,
            name=name,
            keys=(Keyframe(2, points, origin=Origin.ENGINE, confidence=trust),),
        )
        for name, trust, points in (("Sure", 0.95, SHOT.truth(1001)), ("Lost", 0.1, SHOT.truth(1001)))
    )
    project = Project(root=Layer("root", "Root", (sure, lost)))
    assert line_of(project, 2, 0.0, Picking(["Sure"]))["confidence"] == 0.95
    assert line_of(project, 2, 0.0, Picking())["termination"] == "low_confidence"


def test_it_is_saved_elsewhere_and_told_in_json(roam: Roam, plate: Plate, keyed: Path) -> None:
    before, target = keyed.read_bytes(), plate.folder.parent / "filled.roam"
    done = roam("fill", keyed, *CONFIG, "--save", target, "--json")
    lines = [json.loads(line) for line in done.out.splitlines()]
    assert [line["frame"] for line in lines] == FRAMES
    assert all(set(line) == {"frame", "seconds", "confidence", "termination"} for line in lines)
    artist = [line["frame"] for line in lines if line["termination"] == "artist_key"]
    assert (artist, done.err, keyed.read_bytes()) == ([1001, 1004, 1006], "", before)
    assert len(file.load(target).shapes[0].keys) == len(FRAMES)


def test_an_interrupted_fill_keeps_its_finished_gaps(roam: Roam, keyed: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def interrupting(images: Any, shapes: Any, start: int, *rest: Any, **options: Any) -> Any:
        if start == 1004:
            raise KeyboardInterrupt
        return fill_span(images, shapes, start, *rest, **options)

    monkeypatch.setattr("roam_core.propagate.fill_span", interrupting)
    assert roam("fill", keyed, *CONFIG).status == 130
    assert file.load(keyed).shapes[0].frames == (1001, 1002, 1003, 1004, 1006)


def test_info_tells_what_is_not_filled_and_what_is_stale(roam: Roam, keyed: Path) -> None:
    assert "3 frame(s) between its artist keys are not filled, the first is 1002" in roam("info", keyed).out
    assert roam("fill", keyed, *CONFIG).status == 0
    assert "not filled" not in roam("info", keyed).out
    assert "3 artist, 3 engine;" in roam("info", keyed).out
    project = file.load(keyed)
    file.save(project.with_shape(verbs.set_key(project.shapes[0], 1006, SHOT.truth(1006) + 1.0)), keyed)
    assert "3 artist, 3 engine (1 stale);" in roam("info", keyed).out


def whitened(path: Path) -> None:
    cv2.imwrite(str(path), np.full((*SHOT.size, 3), 255, np.uint8))


def torn(path: Path) -> None:
    path.write_bytes(path.read_bytes()[:-200])


@pytest.mark.parametrize("spoilt", [whitened, torn])
def test_a_frame_that_shows_nothing_is_filled_by_no_run(
    roam: Roam, plate: Plate, keyed: Path, spoilt: Callable[[Path], None]
) -> None:
    spoilt(plate.folder / "plate.1002.png")
    project = file.load(keyed)
    file.save(project.with_shape(verbs.delete_keys(project.shapes[0], [1004])), keyed)
    assert "4 frame(s) between its artist keys are not filled, the first is 1002" in roam("info", keyed).out
    assert "Filled 1 gap(s).\n" in roam("fill", keyed, *CONFIG).err
    (shape,) = file.load(keyed).shapes
    assert shape.frames == (1001, 1003, 1004, 1005, 1006)
    assert "not filled" not in roam("info", keyed).out
    assert json.loads(roam("info", keyed, "--json").out)["shapes"][0]["not_filled"] == []
    for words in ((), ("--workers", "2")):
        assert "Filled 0 gap(s); 1 already filled.\n" in roam("fill", keyed, *CONFIG, *words).err
    file.save(project.with_shape(verbs.delete_keys(shape, [1003])), keyed)
    assert "1 frame(s) between its artist keys are not filled, the first is 1003" in roam("info", keyed).out
    assert "Filled 1 gap(s).\n" in roam("fill", keyed, *CONFIG).err
    assert file.load(keyed).shapes[0] == shape


def test_locked_shapes_stay_as_they_are(roam: Roam, keyed: Path) -> None:
    project = file.load(keyed)
    project, twin = verbs.new_shape(project, SHOT.truth(1001), 1001)
    twin = verbs.set_key(twin, 1006, SHOT.truth(1006))
    file.save(verbs.set_properties(project.with_shape(twin), twin.id, locked=True), keyed)
    assert roam("fill", keyed, *CONFIG).status == 0
    assert file.load(keyed).shapes[1].frames == (1001, 1006)


def test_that_a_gap_in_the_plate_gets_no_matte_is_told(roam: Roam, plate: Plate, keyed: Path) -> None:
    """As by `roam render`: a folder of mattes lacked a frame without a word."""
    (plate.folder / "plate.1002.png").unlink()
    out = plate.folder.parent / "mattes"
    done = roam("fill", keyed, *CONFIG, "--matte", out)
    assert "roam: The plate has no picture of frame(s) 1002: no matte is written there" in done.err
    assert not (out / "plate.1002.png").exists()


def test_what_cannot_be_filled_is_refused_in_one_sentence(roam: Roam, plate: Plate, keyed: Path) -> None:
    project = file.load(keyed)
    whole = keyed.read_bytes()
    one = verbs.delete_keys(project.shapes[0], [1004, 1006])
    wrong = {
        "no gap": project.with_shape(one),
        "no clip": Project(None, project.root),
        "no closed": project.with_shape(verbs.toggle_closed(project.shapes[0])),
    }
    for words, bad in wrong.items():
        file.save(bad, keyed)
        require_refusal(roam("fill", keyed), words)
    keyed.write_bytes(whole)
    require_refusal(roam("fill", keyed, "--config", "better"), "better")
    require_refusal(roam("fill", keyed, "--save", plate.folder), "folder")
    require_refusal(roam("fill", plate.folder / "none.roam"), "none.roam")
    for entry in plate.folder.iterdir():
        entry.unlink()
    (plate.folder / "notes.txt").touch()  # an empty folder is no plate: another copy of it is looked for
    require_refusal(roam("fill", keyed), plate.folder)
    assert keyed.read_bytes() == whole
