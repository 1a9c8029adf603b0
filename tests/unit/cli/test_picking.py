"""`--shape NAME` and `--alone`: which shapes get keys, with whom they are solved, and what is refused."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.cli.picking import Picking, picked, trackable
from roam_core.errors import RoamError
from roam_core.media import open_clip
from roam_core.propagate.shapes.provenance import Stamp, Stamps
from roam_core.roto import Clip, Origin, Project, RotoShape, edit, file, layers
from tests.unit.cli.conftest import SHOT, Outcome, Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal

CONFIG = ("--config", "baseline")


@pytest.fixture
def two(plate: Plate) -> Path:
    """A project with a body and a smaller shape over it, both with artist keys on 1001 and 1006, and an open one."""
    project = Project(Clip.of(open_clip(plate.folder)))
    for name, size in (("Body", 1.0), ("Spot", 0.6)):
        project, shape = edit.new_shape(project, _scaled(1001, size), 1001, name=name)
        project = project.with_shape(edit.set_key(shape, 1006, _scaled(1006, size)))
    project, _ = edit.new_shape(project, SHOT.truth(1001), 1001, name="Line", closed=False)
    path = plate.folder.parent / "two.roam"
    file.save(project, path)
    return path


def _scaled(frame: int, size: float) -> Array:
    points = SHOT.truth(frame)
    middle = points[:, 0].mean(axis=0)
    return np.asarray(middle + size * (points - middle))


def shapes_of(path: Path) -> dict[str, RotoShape]:
    return {shape.name: shape for shape in file.load(path).shapes}


def solved(path: Path) -> dict[str, list[int]]:
    """The frames on which each shape holds keys of the engine's."""
    return {
        name: [key.frame for key in shape.keys if key.origin is Origin.ENGINE]
        for name, shape in shapes_of(path).items()
    }


def run(roam: Roam, plate: Plate, path: Path, command: str, *words: object) -> Outcome:
    if command == "fill":
        return roam("fill", path, *CONFIG, *words)
    return roam("track", plate.folder, "--init", path, "--save", path, *CONFIG, *words)


COMMANDS = pytest.mark.parametrize("command", ["track", "fill"])
INSIDE = [1002, 1003, 1004, 1005]


@COMMANDS
def test_only_the_named_shapes_get_keys(roam: Roam, plate: Plate, two: Path, command: str) -> None:
    before = shapes_of(two)
    done = run(roam, plate, two, command, "--shape", "Spot")
    assert done.status == 0
    assert solved(two) == {"Body": [], "Spot": INSIDE, "Line": []}
    assert shapes_of(two)["Body"] == before["Body"]
    assert done.err in ("Filled 1 gap(s).\n", "Tracked 1 shape(s) from frame 1001 to 1006.\n")


@COMMANDS
def test_it_may_be_given_again_and_an_id_is_a_name(roam: Roam, plate: Plate, two: Path, command: str) -> None:
    words = ("--shape", "Body", "--shape", shapes_of(two)["Spot"].id)
    assert run(roam, plate, two, command, *words).status == 0
    assert solved(two) == {"Body": INSIDE, "Spot": INSIDE, "Line": []}


@COMMANDS
def test_one_by_one_is_as_all_at_once(roam: Roam, plate: Plate, two: Path, command: str) -> None:
    whole = two.with_name("whole.roam")
    whole.write_bytes(two.read_bytes())
    run(roam, plate, whole, command)
    for name in ("Spot", "Body"):
        run(roam, plate, two, command, "--shape", name)
    assert two.read_bytes() == whole.read_bytes()


@COMMANDS
def test_alone_is_said_in_the_keys_and_is_fresh(roam: Roam, plate: Plate, two: Path, command: str) -> None:
    assert run(roam, plate, two, command, "--shape", "Spot", "--alone").status == 0
    project = file.load(two)
    spot = next(shape for shape in project.shapes if shape.name == "Spot")
    engine = [key for key in spot.keys if key.origin is Origin.ENGINE]
    assert [key.frame for key in engine] == INSIDE
    assert all(Stamp.read(key.inputs).alone for key in engine)
    stamps = Stamps.of(project.shapes, project.clip)
    assert not any(stamps.is_stale(spot, key) for key in engine)
    assert "stale" not in roam("info", two).out


def test_alone_is_filled_again_together(roam: Roam, two: Path) -> None:
    assert roam("fill", two, *CONFIG, "--alone").err == "Filled 1 gap(s).\n"
    assert roam("fill", two, *CONFIG, "--alone").err == "Filled 0 gap(s); 1 already filled.\n"
    assert roam("fill", two, *CONFIG).err == "Filled 1 gap(s).\n"
    assert roam("fill", two, *CONFIG, "--shape", "Spot").err == "Filled 0 gap(s); 1 already filled.\n"
    assert not any(Stamp.read(key.inputs).alone for shape in file.load(two).shapes for key in shape.keys)


def test_a_named_shape_that_is_filled_leaves_the_other_to_be_filled(roam: Roam, two: Path) -> None:
    roam("fill", two, *CONFIG, "--shape", "Spot")
    assert roam("fill", two, *CONFIG).err == "Filled 1 gap(s).\n"
    assert solved(two) == {"Body": INSIDE, "Spot": INSIDE, "Line": []}


@COMMANDS
def test_what_cannot_be_meant_is_refused_in_one_sentence(roam: Roam, plate: Plate, two: Path, command: str) -> None:
    before = two.read_bytes()
    require_refusal(run(roam, plate, two, command, "--shape", "Arm"), "Arm", "Body", "Spot")
    require_refusal(run(roam, plate, two, command, "--shape", "Body", "--shape", "Arm"), "Arm")
    require_refusal(run(roam, plate, two, command, "--shape", "Line"), "closed", "Line")
    assert two.read_bytes() == before
    project = file.load(two)
    file.save(edit.set_properties(project, shapes_of(two)["Spot"].id, locked=True), two)
    locked = two.read_bytes()
    require_refusal(run(roam, plate, two, command, "--shape", "Spot"), "Spot", "locked")
    assert two.read_bytes() == locked
    assert run(roam, plate, two, command).status == 0
    assert solved(two) == {"Body": INSIDE, "Spot": [], "Line": []}


def test_a_track_begins_on_the_first_key_of_what_is_picked(roam: Roam, plate: Plate, two: Path) -> None:
    project = file.load(two)
    spot = edit.delete_keys(edit.key_here(shapes_of(two)["Spot"], 1003), [1001])
    file.save(project.with_shape(spot), two)
    assert run(roam, plate, two, "track", "--shape", "Spot").err == "Tracked 1 shape(s) from frame 1003 to 1006.\n"
    assert solved(two) == {"Body": [], "Spot": [1004, 1005], "Line": []}


def test_names_and_ids_pick_closed_shapes(two: Path) -> None:
    project = file.load(two)
    assert [shape.name for shape in picked(project, None)] == ["Body", "Spot", "Line"]
    assert [shape.name for shape in picked(project, ["Spot", "Spot"])] == ["Spot"]
    assert [shape.name for shape in trackable(project)] == ["Body", "Spot"]
    with pytest.raises(RoamError, match=r"none\.$"):
        picked(Project(), ["Body"])


def test_what_lies_in_a_locked_layer_is_locked(two: Path) -> None:
    project = file.load(two)
    project, layer = layers.grouped(project, [project.shapes[0].id], "Done")
    project = edit.set_properties(project, layer.id, locked=True)
    assert [shape.name for shape in trackable(project)] == ["Spot"]
    with pytest.raises(RoamError, match="'Body' is locked, or lies in a locked layer"):
        trackable(project, Picking(["Body"]))


@COMMANDS
@pytest.mark.parametrize("config", ["baseline", "best"])
def test_a_single_point_is_left_out_like_an_open_line(
    roam: Roam, plate: Plate, two: Path, command: str, config: str
) -> None:
    project, dot = edit.new_shape(file.load(two), SHOT.truth(1001)[:1], 1001, name="Dot")
    file.save(project.with_shape(edit.set_key(dot, 1006, SHOT.truth(1006)[:1])), two)
    before = two.read_bytes()
    require_refusal(run(roam, plate, two, command, "--shape", "Dot", "--config", config), "Dot", "single point")
    assert two.read_bytes() == before
    done = run(roam, plate, two, command, "--config", config)
    assert (done.status, done.err) in ((0, "Filled 1 gap(s).\n"), (0, "Tracked 2 shape(s) from frame 1001 to 1006.\n"))
    assert solved(two) == {"Body": INSIDE, "Spot": INSIDE, "Line": [], "Dot": []}


@pytest.mark.parametrize("workers", [(), ("--workers", 2)])
def test_what_ends_in_a_gap_is_filled_up_to_there_once(roam: Roam, two: Path, workers: tuple[object, ...]) -> None:
    project = file.load(two)
    spot = next(shape for shape in project.shapes if shape.name == "Spot")
    ends = replace(edit.delete_keys(spot, [1006]), lifetime=(None, 1004))
    file.save(project.with_shape(ends), two)
    assert roam("fill", two, *CONFIG, "--shape", "Body").status == 0
    assert roam("fill", two, *CONFIG, *workers).err == "Filled 1 gap(s).\n"
    assert (solved(two)["Body"], solved(two)["Spot"]) == (INSIDE, INSIDE[:2])
    assert roam("fill", two, *CONFIG, *workers).err == "Filled 0 gap(s); 1 already filled.\n"
