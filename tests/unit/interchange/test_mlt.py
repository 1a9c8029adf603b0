"""MLT's splines: what is written is what ours reads back, and what its filters need is told."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.protocol import LossyExport
from roam_core.roto import BlendMode, Layer
from tests.judges.scenes import blob
from tests.unit.interchange.test_labels import CLIP, SIZE, back, car, project


def test_mlts_splines_come_back_with_their_keys(tmp_path: Path) -> None:
    made = back("mlt", project(car()), tmp_path)
    (shape,) = made.layer.shapes()
    assert shape.frames == (1001, 1006, 1012)
    for frame in (1001, 1004, 1012):
        np.testing.assert_allclose(shape.at(frame).points, car().at(frame).points, atol=1e-5)
    text = json.loads((tmp_path / "p.json").read_text())
    first = text["00"][0]
    np.testing.assert_allclose(np.array(first) * SIZE, car().keys[0].points[0][[1, 0, 2]], atol=1e-5)


@pytest.mark.parametrize(
    "point", [[[0.1, 0.2], [0.3, 0.4]], [[0.1, 0.2], [0.3, 0.4], [0.5]], [[0, 1], [2, "x"], [3, 4]], 7]
)
def test_a_spline_of_mlt_with_a_point_that_is_none_is_refused(tmp_path: Path, point: Any) -> None:
    good = [[0.1, 0.2], [0.3, 0.4], [0.5, 0.6]]
    path = tmp_path / "a.json"
    path.write_text(json.dumps({"00": [good, good, point]}))
    with pytest.raises(RoamError, match="each point must be a handle, a point and a handle of two numbers"):
        read_shapes(path, CLIP)


def test_mlt_writes_a_file_a_shape_and_says_what_its_filter_needs(tmp_path: Path) -> None:
    cut = blob("Cut", 120.0, 120.0, 20.0, 20.0, blend=BlendMode.SUBTRACT, feather=8.0)
    exporter = EXPORTERS["mlt"]
    notes = exporter.export(project(car(), cut), tmp_path / "p.json")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["p.Car.json", "p.Cut.json"]
    assert any("'Cut': alpha operation 'sub' and a feather of about 4" in note for note in notes)


@pytest.mark.parametrize(
    ("named", "written"), [("hero", "hero.Car.json"), ("hero.v2", "hero.v2.Car.json"), ("p.JSON", "p.Car.JSON")]
)
def test_files_of_mlt_always_bear_the_suffix_by_which_programs_know_them(named: str, written: str) -> None:
    two = project(car(), blob("Cut", 120.0, 120.0, 20.0, 20.0))
    assert EXPORTERS["mlt"].files(two, Path(named))[0] == Path(written)  # type: ignore[attr-defined]


def test_mlt_loses_nothing_of_what_is_hidden(tmp_path: Path) -> None:
    """Its filter is to be switched off, and that is told; a mode of it refused the whole export."""
    hidden = car(blend=BlendMode.DIFFERENCE, opacity=0.5, visible=False)
    off = Layer("l", "Off", (blob("Other", 60.0, 60.0),), visible=False, invert=True)
    told = EXPORTERS["mlt"].export(project(blob("Seen", 200.0, 90.0), hidden, off), tmp_path / "a.json")
    assert any(note.startswith("A spline is always there: switch off or cut the filter of 'Car'") for note in told)


def test_mlt_loses_what_a_layer_takes_away_within_itself(tmp_path: Path) -> None:
    """Its filters stand in one row: the hole was cut into what lies under the layer, without a word."""
    outer, hole = blob("Outer", 200.0, 90.0), blob("Hole", 180.0, 100.0, 30.0, 20.0, blend=BlendMode.SUBTRACT)
    ring = Layer("l", "Ring", (replace(outer, id="o"), replace(hole, id="h")))
    with pytest.raises(LossyExport) as refusal:
        EXPORTERS["mlt"].export(project(car(), ring), tmp_path / "a.json")
    assert "'Ring' takes away within itself" in refusal.value.losses[0]
    told = EXPORTERS["mlt"].export(project(ring), tmp_path / "a.json")
    assert [note for note in told if "'sub'" in note] == [
        "A spline is a path alone; give the filter of 'Hole': alpha operation 'sub'."
    ]


def test_the_lowest_filter_of_mlt_has_the_alpha_operation_that_it_begins_with(tmp_path: Path) -> None:
    """It joined with the opaque picture, where what lies under its shape is hidden, or takes from nothing."""
    for under in (car(visible=False), car(blend=BlendMode.SUBTRACT)):
        told = EXPORTERS["mlt"].export(project(under, blob("Seen", 200.0, 90.0)), tmp_path / "a.json")
        assert not any("'Seen'" in note for note in told)
        assert any("switch off or cut the filter of 'Car'" in note for note in told)


def test_a_layer_of_one_shape_goes_to_mlt_as_that_shape(tmp_path: Path) -> None:
    body = Layer("layer", "Body", (replace(car(), id="one"),), blend=BlendMode.INTERSECT, invert=True)
    told = EXPORTERS["mlt"].export(project(blob("Seen", 200.0, 90.0), body), tmp_path / "a.json")
    assert told == ("A spline is a path alone; give the filter of 'Car': alpha operation 'min' and inversion.",)


@pytest.mark.parametrize(("name", "named"), [("mlt", "MLT"), ("cvat", "CVAT")])
def test_frames_below_those_that_a_program_counts_are_told(name: str, named: str, tmp_path: Path) -> None:
    """Both count from 0, the clip's first: less than that is shown by neither."""
    told = EXPORTERS[name].export(project(car()), tmp_path / "a.file", ExportOptions(frame_offset=-1001))
    assert any(note.startswith(f"{named} counts from 0, the clip's first frame") for note in told)
    rest = ExportOptions(frame_offset=-2, frames=range(1003, 1006))
    assert not any(
        "counts from 0" in note for note in EXPORTERS[name].export(project(car()), tmp_path / "b.file", rest)
    )
