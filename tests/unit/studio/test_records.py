"""What was done is known by content: the same input, settings and results, and no other."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from roam_core.errors import RoamError
from roam_core.media.content import content_hash
from roam_core.roto import Clip, Project, file
from roam_core.studio.jobs import Job, Jobs, Step
from roam_core.studio.records import Record, Seen, digest_of, inputs_of
from roam_core.studio.tasks import Task, tasks_of
from tests.unit.media.conftest import write_bytes_png


@pytest.fixture
def record(tmp_path: Path) -> Record:
    """A step that read `in.txt` and wrote `out.txt`."""
    (tmp_path / "in.txt").write_text("given")
    (tmp_path / "out.txt").write_text("made")
    outputs = {"out.txt": digest_of(tmp_path / "out.txt")}
    return Record({"pair": (1, 2)}, (Seen.of(tmp_path / "in.txt"),), outputs, {"said": "done"})


def holds(record: Record, folder: Path, **settings: object) -> bool:
    inputs = inputs_of([str(folder / "in.txt")], "", "", record)
    return record.holds({"pair": (1, 2), **settings}, inputs, folder)


def test_a_record_holds_as_long_as_nothing_changes(record: Record, tmp_path: Path) -> None:
    assert holds(record, tmp_path)
    os.utime(tmp_path / "in.txt", ns=(1, 1))  # touched, and the same
    os.utime(tmp_path / "out.txt", ns=(1, 1))
    assert holds(record, tmp_path)
    assert not holds(record, tmp_path, more=1)


@pytest.mark.parametrize(("name", "text"), [("in.txt", "other"), ("in.txt", "longer than that"), ("out.txt", "mode")])
def test_it_does_not_hold_of_other_content(record: Record, tmp_path: Path, name: str, text: str) -> None:
    (tmp_path / name).write_text(text)
    assert not holds(record, tmp_path)


def test_it_does_not_hold_without_its_results(record: Record, tmp_path: Path) -> None:
    (tmp_path / "out.txt").unlink()
    assert not holds(record, tmp_path)
    assert not Record(record.settings, record.inputs, {}, {}).holds(record.settings, record.inputs, tmp_path)


def test_a_record_comes_back_from_its_file(record: Record, tmp_path: Path) -> None:
    record.write(tmp_path / "r.json")
    found = Record.read(tmp_path / "r.json")
    assert found is not None
    assert holds(found, tmp_path)
    assert found.outcome == {"said": "done"}


@pytest.mark.parametrize(
    "text", ["", "{}", "[]", '{"type": "roam.StepDone", "version": 1, "inputs": 3}', "[" * 100_000]
)
def test_a_damaged_record_is_none(tmp_path: Path, text: str) -> None:
    (tmp_path / "r.json").write_text(text)
    assert Record.read(tmp_path / "r.json") is None


def test_input_that_is_missing_is_told(tmp_path: Path) -> None:
    with pytest.raises(RoamError, match=r"in\.txt cannot be read"):
        inputs_of([str(tmp_path / "in.txt")], "", "", None)


def test_the_plate_is_known_by_its_content_among_others_of_its_folder(tmp_path: Path) -> None:
    for name in ("a.1.png", "b.1.png", "b.2.png"):
        write_bytes_png(tmp_path / name)
    (tmp_path / "a.1.png").write_bytes((tmp_path / "a.1.png").read_bytes() + b"more")
    content = content_hash(tmp_path / "a.1.png")
    assert [seen.name for seen in inputs_of([], str(tmp_path), "", None)] == ["b.1.png", "b.2.png"]
    assert [seen.name for seen in inputs_of([], str(tmp_path), "", None, content)] == ["a.1.png"]


def test_a_job_of_a_project_knows_its_plate_by_content(tmp_path: Path) -> None:
    clip = Clip(tmp_path / "plate", 1, 2, (64, 48), content="0" * 32)
    file.save(Project(clip), tmp_path / "p.roam")
    jobs = Jobs((Job("p", (Step("fill"),), init=tmp_path / "p.roam"),), tmp_path / "out")
    ((task,),) = tasks_of(jobs)
    assert (task.plate, task.content) == (str(tmp_path / "plate"), "0" * 32)
    assert Task.of(task.plain()) == task


def test_the_configuration_of_colours_is_read_with_a_plate(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    plate, colours = tmp_path / "p.1.png", tmp_path / "config.ocio"
    write_bytes_png(plate)
    monkeypatch.delenv("OCIO", raising=False)
    alone = inputs_of([], str(plate), "", None)
    digests = []
    for text in ("one", "other"):
        colours.write_text(text)
        monkeypatch.setenv("OCIO", str(colours))
        digests.append(inputs_of([], str(plate), "", None)[-1].digest)
    assert [seen.name for seen in alone] == ["p.1.png"]
    assert digests[0] != digests[1]


@pytest.mark.parametrize("name", ["m.%04d.png", "m.####.png", "m.1001.png"])
def test_of_a_sequence_of_masks_every_file_is_known(tmp_path: Path, name: str) -> None:
    """Of a pattern it was said that the file is missing, and of a numbered file no other was looked at."""
    for other in ("m.1001.png", "m.1002.png", "m.1003.png", "n.1001.png"):
        write_bytes_png(tmp_path / other)
    (tmp_path / "m.1001.txt").touch()
    found = inputs_of([str(tmp_path / name)], "", "", None)
    assert [seen.name for seen in found] == ["m.1001.png", "m.1002.png", "m.1003.png"]
    before = Record({}, tuple(found), {"m.1001.txt": digest_of(tmp_path / "m.1001.txt")}, {})
    assert before.holds({}, inputs_of([str(tmp_path / name)], "", "", before), tmp_path)
    (tmp_path / "m.1002.png").write_bytes(b"another")
    assert not before.holds({}, inputs_of([str(tmp_path / name)], "", "", before), tmp_path)


def test_a_file_that_is_no_picture_is_known_alone(tmp_path: Path) -> None:
    for name in ("p.1.roam", "p.2.roam"):
        (tmp_path / name).touch()
    assert [seen.name for seen in inputs_of([str(tmp_path / "p.1.roam")], "", "", None)] == ["p.1.roam"]
