"""Shapes whose first keys lie ahead of a run: they join it there, bit by bit as if it had begun with them."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import pytest

from roam_core.cli.joining import Joining
from roam_core.media import open_clip
from roam_core.roto import Clip, Project, RotoShape, edit, file
from tests.unit.cli.conftest import SHOT, Plate, Roam
from tests.unit.matte.conftest import rectangle


@pytest.fixture
def late(plate: Plate) -> Path:
    """Two shapes apart: one with keys on both ends, `Late` with one in the midst."""
    project = Project(Clip.of(open_clip(plate.folder)))
    project, early = edit.new_shape(project, SHOT.truth(1001), 1001, name="Early")
    project = project.with_shape(edit.set_key(early, 1006, SHOT.truth(1006)))
    project, _ = edit.new_shape(project, SHOT.truth(1004) * 0.4, 1004, name="Late")
    path = plate.folder.parent / "late.roam"
    file.save(project, path)
    return path


def tracked(roam: Roam, plate: Plate, path: Path, *words: object) -> tuple[dict[str, RotoShape], str, list[float]]:
    out = path.with_name("out.roam")
    done = roam("track", plate.folder, "--init", path, "--save", out, "--json", *words)
    assert done.status == 0
    lines = [json.loads(line) for line in done.out.splitlines()]
    return {shape.name: shape for shape in file.load(out).shapes}, done.err, [line["confidence"] for line in lines]


@pytest.mark.parametrize(("words", "on"), [((), range(1004, 1007)), (("--backward",), range(1001, 1005))])
def test_a_shape_joins_on_its_first_key(
    roam: Roam, plate: Plate, late: Path, words: tuple[str, ...], on: range
) -> None:
    """It had tracked keys before, made from a copy of that key, which lay beside the object."""
    both, said, sure = tracked(roam, plate, late, *words)
    assert both["Late"].frames == tuple(on)
    assert "'Late' is tracked from frame 1004 on" in said
    lone, said, _ = tracked(roam, plate, late, *words, "--shape", "Late")
    assert both["Late"] == lone["Late"]
    assert "is tracked from" not in said
    early, _, surer = tracked(roam, plate, late, *words, "--shape", "Early")
    assert both["Early"] == early["Early"]
    assert sure[:2] == surer[:2]


def test_what_was_tracked_ahead_of_it_stays(roam: Roam, plate: Plate, late: Path) -> None:
    """Backward from its key; a later run forward wrote over that what a copy of the key became."""
    before, _, _ = tracked(roam, plate, late, "--start", 1004, "--end", 1003, "--backward", "--shape", "Late")
    project = file.load(late)
    file.save(project.with_shape(before["Late"]), late)
    shape = before["Late"]
    assert shape.frames == (1003, 1004)
    after, _, _ = tracked(roam, plate, late)
    assert after["Late"].frames == (1003, 1004, 1005, 1006)
    assert after["Late"].keys[:2] == shape.keys


def test_a_shape_without_a_key_on_the_way_is_left_out(roam: Roam, plate: Plate, late: Path) -> None:
    both, said, _ = tracked(roam, plate, late, "--end", 1004)
    assert both["Late"].frames == (1004,)
    assert "'Late' is not tracked" in said


def test_where_all_keys_lie_ahead_the_shapes_are_taken_as_they_are_there(roam: Roam, plate: Plate, late: Path) -> None:
    """`--start` is the frame that the file describes."""
    both, said, _ = tracked(roam, plate, late, "--start", 1002, "--shape", "Late")
    assert both["Late"].frames == (1003, 1004, 1005, 1006)
    assert said == ""


def test_a_shape_that_only_begins_to_exist_there_needs_no_words() -> None:
    early, late = rectangle(0.0, 0.0, 9.0, 9.0), rectangle(3.0, 3.0, 5.0, 5.0)
    early = replace(early, keys=(replace(early.keys[0], frame=1),))
    late = replace(late, id="late", keys=(replace(late.keys[0], frame=4),))
    assert len(list(Joining.of([early, late], range(1, 9)).told())) == 1
    assert not list(Joining.of([early, replace(late, lifetime=(4, 9))], range(1, 9)).told())
