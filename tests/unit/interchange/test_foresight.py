"""What an export would lose is found out without writing it."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice
from roam_core.interchange.foresight import foreseen, trimmed
from roam_core.interchange.protocol import LossyExport
from roam_core.roto import Interpolation, Origin
from tests.judges.scenes import SCENES


@pytest.mark.parametrize("name", EXPORTERS)
@pytest.mark.parametrize("scene", ["curves", "modes", "layers", "inverted", "soft edges", "names"])
def test_losses_are_those_of_the_export_itself(name: str, scene: str, tmp_path: Path) -> None:
    exporter, path = EXPORTERS[name], tmp_path / "out" / f"shapes{EXPORTERS[name].suffix}"
    path.parent.mkdir()
    project = SCENES[scene].project
    found = foreseen(exporter, project)
    assert list(path.parent.iterdir()) == []
    try:
        exporter.export(project, path, ExportOptions(frames=range(1001, 1003) if name == "mattes" else None))
        losses: tuple[str, ...] = ()
    except LossyExport as refusal:
        losses = refusal.losses
    assert found.losses == losses
    assert not set(found.losses) & set(found.notes)


def test_tracks_say_what_they_are_before_they_are_written() -> None:
    found = foreseen(EXPORTERS["nuke-tracks"], SCENES["modes"].project)
    assert found.losses == ()
    assert found.notes == ("Tracks hold how shapes and layers move, not their outlines.",)


def test_few_keys_are_tried_whatever_keys_are_asked_for() -> None:
    project = next(iter(SCENES.values())).project
    shape = project.shapes[0]
    key = shape.keys[0]
    keys = [replace(key, frame=frame, interpolation=Interpolation.LINEAR) for frame in range(1001, 1010)]
    keys[4] = replace(keys[4], interpolation=Interpolation.HOLD)
    keys[6] = replace(keys[6], origin=Origin.ENGINE)
    long = project.with_shape(replace(shape, keys=tuple(keys)))
    assert trimmed(long).shape(shape.id).frames == (1001, 1005, 1007, 1009)
    found = foreseen(EXPORTERS["nuke"], long, ExportOptions(keys=KeyChoice.REDUCED, smoothing=2.0))
    assert [note for note in found.notes if "keys" in note] == []


@pytest.mark.parametrize("name", ["coco", "cvat"])
def test_the_plate_is_not_asked_for_what_is_foreseen(
    name: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its server may not answer, and an export waits behind this."""
    asked: list[object] = []
    monkeypatch.setattr(f"roam_core.interchange.labels.{name}.file_names_of", asked.append)
    project = SCENES["curves"].project
    foreseen(EXPORTERS[name], project)
    assert asked == []
    EXPORTERS[name].export(project, tmp_path / "labels")
    assert asked == [project.clip]
