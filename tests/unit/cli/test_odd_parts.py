"""Objects of which little is to be seen, on the command line: tracked, explained and filled, with sentences alone."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest

from roam_core.roto import Keyframe, Origin, file
from tests.unit.cli.conftest import Roam
from tests.unit.propagate.figures import odd_objects, written

OBJECTS = odd_objects()


@pytest.mark.parametrize("name", list(OBJECTS))
def test_odd_parts_are_tracked_and_explained(roam: Roam, tmp_path: Path, name: str) -> None:
    figure, shapes = OBJECTS[name]
    path, last = written(figure, shapes, tmp_path), figure.count - 1
    done = roam("track", path.parent / "plate", "--init", path, "--save", path, "--json")
    assert done.status == 0, done.err
    assert "Traceback" not in done.err
    assert [json.loads(line)["frame"] for line in done.out.splitlines()] == list(figure.frames)
    found = file.load(path)
    assert [shape.frames for shape in found.shapes] == [tuple(figure.frames)] * len(shapes)
    for shape in found.shapes:
        assert all(np.isfinite(key.points).all() for key in shape.keys)
        assert all(key.confidence is not None for key in shape.keys if key.origin is Origin.ENGINE)
    told = roam("explain", path, "--frame", last, "--json")
    assert told.status == 0, told.err
    lines = [json.loads(line) for line in told.out.splitlines()]
    assert [line["shape"] for line in lines] == [shape.name for shape in shapes]
    assert all(sum(line["edges"].values()) == pytest.approx(1.0, abs=1e-4) for line in lines)


def test_the_words_hold_for_odd_parts_too(roam: Roam, tmp_path: Path) -> None:
    """A shape without an area lies on itself: no share of its outline is seen inside."""
    figure, shapes = OBJECTS["without an area"]
    path = written(figure, shapes, tmp_path)
    roam("track", path.parent / "plate", "--init", path, "--save", path)
    done = roam("explain", path, "--frame", 2, "--shape", "odd")
    assert done.status == 0
    assert "Of its outline" in done.out


@pytest.mark.parametrize("name", [name for name in OBJECTS if name != "many"])
def test_odd_parts_are_filled(roam: Roam, tmp_path: Path, name: str) -> None:
    figure, shapes = OBJECTS[name]
    last = figure.count - 1
    keyed = [shape.with_key(Keyframe(last, part.truth(last))) for shape, part in zip(shapes, figure.parts, strict=True)]
    path = written(figure, keyed, tmp_path)
    done = roam("fill", path)
    assert done.status == 0, done.err
    assert [shape.frames for shape in file.load(path).shapes] == [tuple(figure.frames)] * len(shapes)
