"""`roam explain`: a table, a line of JSON a shape, a picture; one sentence for what cannot be explained."""

from __future__ import annotations

import json
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.roto import edit, file
from tests.unit.cli.conftest import Plate, Roam
from tests.unit.cli.test_bad_input import require_refusal


@pytest.fixture
def tracked(roam: Roam, plate: Plate) -> Path:
    """A project of the plate, tracked to frame 1003 under `medium`."""
    path = plate.folder.parent / "p.roam"
    words = ("--init", plate.mask, "--config", "medium", "--end", 1003, "--save", path)
    assert roam("track", plate.folder, *words).status == 0
    return path


def test_a_table_of_nodes_and_one_of_landmarks(roam: Roam, tracked: Path) -> None:
    done = roam("explain", tracked, "--frame", 1003)
    assert (done.status, done.err) == (0, "")
    lines = done.out.splitlines()
    assert lines[0].startswith("'Shape 1', frame 1003: medium, ")
    heads = [line.split() for line in lines if line.split()[-1:] == ["total"]]
    assert heads == [
        ["node", "point", "x", "y", "gradient", "l2", "local", "joint", "total"],
        ["id", "x", "y", "landmark", "star", "joint", "total"],
    ]
    assert {line.split()[0] for line in lines if line.endswith("%")} == {
        "gradient",
        "l2",
        "local",
        "joint",
        "landmark",
        "star",
    }


def test_json_says_the_same(roam: Roam, tracked: Path) -> None:
    (line,) = roam("explain", tracked, "--frame", 1003, "--json").out.splitlines()
    told = json.loads(line)
    assert (told["shape"], told["frame"], told["origin"], told["config"]) == ("Shape 1", 1003, "engine", "medium")
    nodes, landmarks = told["nodes"], told["landmarks"]
    assert [row["node"] for row in nodes] == list(range(len(nodes)))
    assert sum(row["local"] for row in nodes) == pytest.approx(told["sums"]["local"], abs=1e-3)
    both = sum(row["total"] for row in [*nodes, *landmarks])
    assert both == pytest.approx(sum(told["sums"].values()), abs=1e-3)


def test_best_tells_both_sides_of_the_outline(roam: Roam, plate: Plate) -> None:
    path = plate.folder.parent / "p.roam"
    roam("track", plate.folder, "--init", plate.mask, "--end", 1002, "--save", path)
    done = roam("explain", path, "--frame", 1002)
    head = next(line for line in done.out.splitlines() if line.split()[:1] == ["node"])
    cues = "local key global motion prior bias background texture patches lineage"
    assert " ".join(head.split()) == f"node point x y {cues} region difference"
    told = json.loads(roam("explain", path, "--frame", 1002, "--json").out)
    assert all(set(row["inside"]) == set(row["outside"]) == set(told["sums"]) for row in told["nodes"])


def test_the_artists_key_is_said_to_be_his(roam: Roam, tracked: Path) -> None:
    done = roam("explain", tracked, "--frame", 1001)
    assert done.status == 0
    assert done.out.splitlines()[0] == "'Shape 1', frame 1001: the artist made this key; nothing was solved."


def test_shares_of_the_outline_on_the_frame_and_on_its_key(roam: Roam, tracked: Path) -> None:
    lines = roam("explain", tracked, "--frame", 1003).out.splitlines()
    here = next(line for line in lines if line.startswith("Of its outline "))
    there = next(line for line in lines if line.startswith("On its key, frame 1001, "))
    assert "is free" in here
    assert there.endswith("% hidden.")
    told = json.loads(roam("explain", tracked, "--frame", 1003, "--json").out)
    assert set(told["edges"]) == {"free", "seam", "hidden", "unknown"}
    assert sum(told["edges"].values()) == pytest.approx(1.0, abs=1e-5)
    assert f"{told['edges']['free']:.0%} is free" in here
    assert told["key_frame"] == 1001
    on_key = roam("explain", tracked, "--frame", 1001).out
    assert "Of its outline" in on_key
    assert "On its key" not in on_key


@pytest.mark.parametrize("term", ["total", "local", "joint", "landmark"])
def test_a_picture_with_the_term_in_colours(roam: Roam, tracked: Path, term: str) -> None:
    out = tracked.parent / "why.png"
    done = roam("explain", tracked, "--frame", 1003, "--picture", out, "--term", term)
    assert (done.status, done.err) == (0, f"Drew {term} of 1 shape(s) to {out}.\n")
    picture = cv2.imread(str(out))
    assert picture.shape[1] > 600
    told = json.loads(roam("explain", tracked, "--frame", 1003, "--json").out)
    rows = told["landmarks" if term == "landmark" else "nodes"]
    least, most = (pick(rows, key=lambda row: row[term]) for pick in (min, max))
    blue, red = (np.array(colour, dtype=float) for colour in ((240, 110, 54), (40, 48, 226)))
    for row, colour in ((least, blue), (most, red)):
        assert np.abs(at(picture, rows, told["nodes"], row) - colour).max() < 30


def at(
    picture: np.ndarray, rows: list[dict[str, float]], nodes: list[dict[str, float]], row: dict[str, float]
) -> np.ndarray:
    """The picture's BGR where a node or landmark is drawn: it shows the part of the frame around the nodes."""
    places = np.array([(each["x"], each["y"]) for each in nodes])
    margin = max(24.0, 0.2 * float(np.ptp(places, axis=0).max()))
    corner = np.maximum(np.floor(places.min(axis=0) - margin), 0.0)
    far = np.minimum(np.ceil(places.max(axis=0) + margin), (130, 110))
    factor = picture.shape[1] / (far - corner)[0]
    x, y = np.rint((np.array([row["x"], row["y"]]) - corner) * factor - 0.5).astype(int)
    return picture[y, x].astype(float)


def test_a_picture_twice_is_the_same_picture(roam: Roam, tracked: Path) -> None:
    paths = [tracked.parent / name for name in ("a.png", "b.png")]
    for path in paths:
        roam("explain", tracked, "--frame", 1003, "--picture", path)
    assert paths[0].read_bytes() == paths[1].read_bytes()


def test_several_shapes_are_asked_for_as_of_every_command(roam: Roam, tracked: Path) -> None:
    project = file.load(tracked)
    points = project.shapes[0].at(1003).points
    for _ in range(2):
        project, _ = edit.new_shape(project, points + 3.0, 1003)
    file.save(project, tracked)
    asked = ("--shape", "Shape 1", "--shape", project.shapes[2].id)
    done = roam("explain", tracked, "--frame", 1003, "--json", *asked)
    assert [json.loads(line)["shape"] for line in done.out.splitlines()] == ["Shape 1", "Shape 3"]


def test_what_cannot_be_explained_is_one_sentence(roam: Roam, tracked: Path, plate: Plate) -> None:
    why = tracked.parent / "why.png"
    ask = ("explain", tracked, "--picture", why)
    require_refusal(roam(*ask, "--frame", 900), "--frame 900", "1001-1006")
    require_refusal(roam(*ask, "--frame", 1005), "holds a key on frame 1005", "missing or damaged get none")
    require_refusal(roam(*ask, "--frame", 1003, "--shape", "hat"), "'hat'", "'Shape 1'")
    project = file.load(tracked)
    file.save(edit.set_properties(project, project.shapes[0].id, lifetime=(1001, 1004)), tracked)
    require_refusal(roam(*ask, "--frame", 1005), "Frame 1005 lies outside the lifetime")
    file.save(project, tracked)
    require_refusal(roam(*ask, "--frame", 1003, "--term", "region"), "'region'", "gradient, l2, local, joint")
    require_refusal(roam("explain", tracked, "--frame", 1003, "--picture", plate.folder), "is a folder")
    require_refusal(roam("explain", tracked, "--frame", 1003, "--term", "local"), "--picture OUT.png, too")
    require_refusal(roam("explain", tracked.parent / "none.roam", "--frame", 1003), "does not exist")
    (plate.folder / "plate.1003.png").unlink()
    require_refusal(roam(*ask, "--frame", 1003), "1003 is missing")
    assert not why.exists()


def test_a_stale_key_and_a_project_without_a_clip_are_refused(roam: Roam, tracked: Path) -> None:
    document = json.loads(tracked.read_text())
    document["root"]["children"][0]["keys"][0]["points"][0][0] += 2.0
    tracked.write_text(json.dumps(document))
    require_refusal(roam("explain", tracked, "--frame", 1003), "out of date")
    file.save(type(file.load(tracked))(None, file.load(tracked).root), tracked)
    require_refusal(roam("explain", tracked, "--frame", 1003), "clip")


@pytest.mark.parametrize("name", ["out.jpg", "out"])
def test_a_picture_is_written_under_the_name_of_what_it_is(roam: Roam, tracked: Path, name: str) -> None:
    done = roam("explain", tracked, "--frame", 1003, "--picture", tracked.parent / name)
    assert (done.status, done.err) == (1, f"roam: The picture is written as PNG; {name} does not end in .png.\n")
