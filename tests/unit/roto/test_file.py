"""The project file: what is kept, what is refused and in which words, and that a failed save harms nothing."""

from __future__ import annotations

import json
import ntpath
import os
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path, PureWindowsPath
from types import SimpleNamespace
from typing import Any, cast

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.media import finding
from roam_core.roto import (
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    file,
    to_json,
)
from roam_core.roto.migrate import VERSION

POINTS = bezier.polygon_points([(0.1, 0.2), (10.0, 1 / 3), (-7.25, 1e-17)])
Document = dict[str, Any]


@pytest.fixture
def project(tmp_path: Path) -> Project:
    """Every field of every kind of object away from its default."""
    keys = (
        Keyframe(1001, POINTS, POINTS + 3.0, interpolation=Interpolation.SMOOTH),
        Keyframe(
            1002,
            POINTS + 1.0,
            origin=Origin.ENGINE,
            interpolation=Interpolation.HOLD,
            confidence=0.75,
            vertex_confidence=np.array([0.1, 0.2, 0.3]),
            inputs="forward:baseline:0123456789abcdef",
        ),
    )
    shape = RotoShape(
        "shape-1", 'Füße "links"', keys, False, (0.1, 0.2, 0.3), BlendMode.DIFFERENCE, 0.25, True, -2.5,
        MotionBlur(0.7, -0.1, 12), (1001, 1049), False, True,
    )  # fmt: skip
    layer = Layer("layer-1", "Inner", (shape,), visible=False, locked=True, opacity=0.5, invert=True)
    clip = Clip(tmp_path / "plates" / "plate.%04d.exr", 1001, 1048, (960, 540), 23.976, 2.0, "linear")
    return Project(clip, Layer("root", "Root", (layer,)))


def edited(project: Project, folder: Path, change: Callable[[Document], object]) -> str:
    """The text of a project file after `change` was made to its document."""
    document = json.loads(file.dumps(project, folder))
    change(document)
    return json.dumps(document)


# ---- what is kept ----------------------------------------------------------------------------------------------------


def test_everything_comes_back(project: Project, tmp_path: Path) -> None:
    file.save(project, tmp_path / "a.roam")
    again = file.load(tmp_path / "a.roam")
    assert again == project
    key, same = project.shapes[0].keys[0], again.shapes[0].keys[0]
    assert key.points.tobytes() == same.points.tobytes()


def test_saving_twice_gives_the_same_bytes(project: Project, tmp_path: Path) -> None:
    file.save(project, tmp_path / "a.roam")
    file.save(file.load(tmp_path / "a.roam"), tmp_path / "b.roam")
    assert (tmp_path / "a.roam").read_bytes() == (tmp_path / "b.roam").read_bytes()


def test_the_file_is_json_with_types_and_a_version(project: Project, tmp_path: Path) -> None:
    document = json.loads(file.dumps(project, tmp_path))
    assert (document["type"], document["version"]) == ("roam.Project", VERSION)
    layer = document["root"]["children"][0]
    shape = layer["children"][0]
    kinds = [part["type"] for part in (document["clip"], layer, shape, shape["keys"][0], shape["motion_blur"])]
    assert kinds == ["Clip", "Layer", "RotoShape", "Keyframe", "MotionBlur"]


def test_the_file_reads_point_by_point(project: Project, tmp_path: Path) -> None:
    lines = file.dumps(project, tmp_path).splitlines()
    assert any(line.strip() == "[0.1, 0.2, 0.1, 0.2, 0.1, 0.2]," for line in lines)


def test_media_are_found_from_where_the_project_lies(project: Project, tmp_path: Path) -> None:
    (tmp_path / "shot").mkdir()
    file.save(project, tmp_path / "shot" / "a.roam")
    text = (tmp_path / "shot" / "a.roam").read_text()
    assert '"../plates/plate.%04d.exr"' in text
    (tmp_path / "moved").mkdir()
    (tmp_path / "shot").rename(tmp_path / "moved" / "shot")
    moved = file.load(tmp_path / "moved" / "shot" / "a.roam")
    assert moved.require_clip().path == tmp_path / "moved" / "plates" / "plate.%04d.exr"


NETWORK = "//server/share/"
"""What Windows leads the letter `Z:` to; `os.path.realpath` says so there."""


@pytest.mark.parametrize(
    ("plate", "folder", "written"),
    [
        ("Z:/show/plates/a.%04d.exr", "Z:/show/work", "../plates/a.%04d.exr"),
        ("z:/show/plates/a.%04d.exr", "Z:/show/work", "../plates/a.%04d.exr"),
        ("//server/share/show/plates/a.%04d.exr", "//server/share/show/work", "../plates/a.%04d.exr"),
        ("C:/plates/a.%04d.exr", "C:/work", "../plates/a.%04d.exr"),
        ("D:/plates/a.%04d.exr", "Z:/show/work", "D:/plates/a.%04d.exr"),
    ],
)
def test_a_plate_on_the_projects_drive_of_windows_is_relative_to_it(
    monkeypatch: pytest.MonkeyPatch, plate: str, folder: str, written: str
) -> None:
    """A letter that stands for a network folder, as studios have them, led to another drive: the path was absolute."""
    windows = SimpleNamespace(**vars(ntpath))
    windows.realpath = lambda path: re.sub(r"^[zZ]:[\\/]", NETWORK, str(path)).replace("/", "\\")
    for module in (finding, to_json):
        monkeypatch.setattr(module, "os", SimpleNamespace(path=windows))
    monkeypatch.setattr(to_json, "Path", PureWindowsPath)
    clip = Clip(Path("plate"), 1001, 1002, (8, 6))
    object.__setattr__(clip, "path", PureWindowsPath(plate))  # it makes a path of this system of what it is given
    document = json.loads("".join(to_json.pieces(Project(clip), cast(Path, PureWindowsPath(folder)))))
    assert document["clip"]["path"] == written
    lies = windows.normpath(windows.join(finding.origin_in(cast(Path, folder)), written))
    assert lies.lower() == windows.normpath(plate).lower(), "read again it has the letter that the artist knows"


def test_an_absolute_path_in_a_file_is_taken_as_it_is(project: Project, tmp_path: Path) -> None:
    text = edited(project, tmp_path, lambda d: d["clip"].update(path="/plates/x"))
    assert file.loads(text, tmp_path).require_clip().path == Path("/plates/x")


def test_fields_of_a_later_program_survive(project: Project, tmp_path: Path) -> None:
    def extend(document: Document) -> None:
        layer = document["root"]["children"][0]
        shape = layer["children"][0]
        for number, part in enumerate((document, document["clip"], layer, shape, shape["keys"][0])):
            part["later"] = {"number": number, "list": [1, [2.5, None]], "text": "ä"}

    again = file.loads(edited(project, tmp_path, extend), tmp_path)
    document = json.loads(file.dumps(again, tmp_path))
    shape = document["root"]["children"][0]["children"][0]
    assert document["later"]["number"] == 0
    assert document["clip"]["later"]["number"] == 1
    assert shape["keys"][0]["later"] == {"number": 4, "list": [1, [2.5, None]], "text": "ä"}
    assert "later" not in shape["keys"][1]


def test_a_plate_whose_name_is_no_text_survives(project: Project, tmp_path: Path) -> None:
    odd = Path(os.fsdecode(b"/plates/caf\xe9"))
    named = replace(project, clip=replace(project.require_clip(), path=odd))
    file.save(named, tmp_path / "a.roam")
    assert file.load(tmp_path / "a.roam") == named


# ---- digest ----------------------------------------------------------------------------------------------------------


def test_equal_projects_have_equal_digests(project: Project, tmp_path: Path) -> None:
    again = file.loads(file.dumps(project, tmp_path), tmp_path)
    assert file.digest(again) == file.digest(project)


@pytest.mark.parametrize(
    "change",
    [
        {"name": "other"},
        {"opacity": 0.26},
        {"lifetime": None},
        {"keys": (Keyframe(1001, np.nextafter(POINTS, np.inf)),)},
    ],
    ids=["name", "opacity", "lifetime", "one bit of a point"],
)
def test_any_difference_shows_in_the_digest(project: Project, change: Document) -> None:
    changed = project.with_shape(replace(project.shapes[0], **change))
    assert file.digest(changed) != file.digest(project)


# ---- what is refused -------------------------------------------------------------------------------------------------


def refused(path: Path) -> str:
    """The one sentence in which `path` is refused."""
    with pytest.raises(RoamError) as caught:
        file.load(path)
    sentence = str(caught.value)
    assert str(path) in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence
    return sentence


@pytest.mark.parametrize(
    ("content", "word"),
    [
        (b"", "a.roam is empty: it was cut short"),
        (b"\0" * 4096, "is empty"),
        (b"not a project", "not valid JSON"),
        (b"\x89PNG\r\n\x1a\n\xff\xfe", "no text file"),
        (b"[1, 2]", "not a ROAM project"),
        (b'{"type": "something.Else", "version": 1}', "not a ROAM project"),
        (b'{"type": "roam.Project"}', "no valid version"),
        (b'{"type": "roam.Project", "version": "one"}', "no valid version"),
        (b'{"type": "roam.Project", "version": 0}', "no valid version"),
        (b'{"type": "roam.Project", "version": true}', "no valid version"),
        (b'{"type": "roam.Project", "version": 1}', "damaged"),
        (b"[" * 100_000, "not valid JSON"),
        (b'{"type": "roam.Project", "version": ' + b"1" * 5000 + b"}", "not valid JSON"),
        (b'{"type": "roam.Project", "ver', "damaged or cut short"),
    ],
)
def test_what_is_no_project_is_refused(tmp_path: Path, content: bytes, word: str) -> None:
    (tmp_path / "a.roam").write_bytes(content)
    assert word in refused(tmp_path / "a.roam")


def test_of_a_project_that_is_cut_short_the_newest_backup_is_named(project: Project, tmp_path: Path) -> None:
    path, backup = tmp_path / "a.roam", tmp_path / "a.roam.1"
    file.save(project, path)
    content = path.read_bytes()
    path.write_bytes(content[: len(content) // 2])
    assert "backup" not in refused(path)
    backup.write_bytes(content)
    for rest in (content[: len(content) // 2], b"", content.replace(b'"root"', b'"boot"')):
        path.write_bytes(rest)
        assert refused(path).endswith(f" Its newest backup is {backup}.")
    path.write_bytes(content[:40] + b"\xe2")
    assert "is damaged or cut short (it is no text file)." in refused(path)
    path.write_bytes(b"notes")
    assert "backup" not in refused(path)


def test_a_byte_order_mark_is_passed_over(project: Project, tmp_path: Path) -> None:
    file.save(project, tmp_path / "a.roam")
    content = (tmp_path / "a.roam").read_bytes()
    (tmp_path / "b.roam").write_bytes(b"\xef\xbb\xbf" + content)
    assert file.load(tmp_path / "b.roam") == file.load(tmp_path / "a.roam")


def test_a_newer_version_is_refused_with_advice(project: Project, tmp_path: Path) -> None:
    text = edited(project, tmp_path, lambda document: document.update(version=VERSION + 1))
    (tmp_path / "a.roam").write_text(text)
    sentence = refused(tmp_path / "a.roam")
    assert "newer ROAM" in sentence
    assert f"file version {VERSION + 1}" in sentence
    assert "open it with that version" in sentence


def first_shape(document: Document) -> Document:
    shape: Document = document["root"]["children"][0]["children"][0]
    return shape


@pytest.mark.parametrize(
    "damage",
    [
        lambda d: d.pop("root"),
        lambda d: d.update(root=None),
        lambda d: d["clip"].pop("size"),
        lambda d: d["clip"].update(size=[1, 2, 3]),
        lambda d: d["clip"].update(fps=10**400),
        lambda d: d["root"]["children"].append({"type": "Sphere"}),
        lambda d: d["root"]["children"].append(7),
        lambda d: d["root"]["children"].append(d["root"]["children"][0]),
        lambda d: first_shape(d).update(keys=[]),
        lambda d: first_shape(d).update(colour=[1.0]),
        lambda d: first_shape(d).update(blend="glue"),
        lambda d: first_shape(d)["motion_blur"].update(samples="many"),
        lambda d: first_shape(d)["keys"][0]["points"].pop(),
        lambda d: first_shape(d)["keys"][0].update(points=[[1.0, 2.0]]),
        lambda d: first_shape(d)["keys"][0].update(points="round"),
        lambda d: first_shape(d)["keys"][1].update(frame=1001),
        lambda d: first_shape(d)["keys"][0].update(feather=[[0.0] * 6]),
        lambda d: first_shape(d)["keys"][0]["points"][0].__setitem__(0, 10**400),
    ],
)
def test_a_damaged_project_is_refused(project: Project, tmp_path: Path, damage: Callable[[Document], object]) -> None:
    (tmp_path / "a.roam").write_text(edited(project, tmp_path, damage))
    assert "is damaged: " in refused(tmp_path / "a.roam")


@pytest.mark.parametrize("number", ["NaN", "Infinity", "-Infinity", "1e999"])
@pytest.mark.parametrize("field", ["opacity", "feather", "later"])
def test_what_is_no_number_is_refused(project: Project, tmp_path: Path, number: str, field: str) -> None:
    text = edited(project, tmp_path, lambda document: first_shape(document).update({field: "here"}))
    (tmp_path / "a.roam").write_text(text.replace('"here"', number))
    assert "not valid JSON" in refused(tmp_path / "a.roam")


def test_paths_that_are_no_file_are_refused(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    assert "does not exist" in refused(tmp_path / "none.roam")
    assert "is a folder" in refused(tmp_path)
    assert "cannot be read" in refused(tmp_path / "file" / "a.roam")


# ---- saving safely ---------------------------------------------------------------------------------------------------


def test_a_save_that_fails_says_so_and_leaves_nothing(project: Project, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    (tmp_path / "folder.roam").mkdir()
    for path in (tmp_path / "none" / "a.roam", tmp_path / "file" / "a.roam", tmp_path / "folder.roam"):
        with pytest.raises(RoamError, match=r"cannot be written: .*\.$"):
            file.save(project, path)
    assert sorted(entry.name for entry in tmp_path.iterdir()) == ["file", "folder.roam"]


def test_the_old_file_survives_a_disk_that_fills_up(
    project: Project, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = tmp_path / "a.roam"
    file.save(Project(), path)
    before = path.read_bytes()

    def full(_: int) -> None:
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(os, "fsync", full)
    with pytest.raises(RoamError, match="No space left"):
        file.save(project, path)
    assert path.read_bytes() == before
    assert [entry.name for entry in tmp_path.iterdir()] == ["a.roam"]


@pytest.mark.skipif(
    not hasattr(os, "geteuid") or os.geteuid() == 0,
    reason="root, and Windows, may write to any folder; the full-disk test stands in",
)
def test_a_read_only_folder_is_told_and_the_old_file_survives(project: Project, tmp_path: Path) -> None:
    path = tmp_path / "a.roam"
    file.save(Project(), path)
    before = path.read_bytes()
    tmp_path.chmod(0o555)
    try:
        with pytest.raises(RoamError, match="cannot be written"):
            file.save(project, path)
    finally:
        tmp_path.chmod(0o755)
    assert path.read_bytes() == before


def test_a_project_that_cannot_be_written_leaves_the_old_file(tmp_path: Path) -> None:
    path = tmp_path / "a.roam"
    file.save(Project(), path)
    before = path.read_bytes()
    with pytest.raises(TypeError):
        file.save(Project(extra={"later": object()}), path)
    assert path.read_bytes() == before


def test_a_saved_file_keeps_the_permissions_it_had(project: Project, tmp_path: Path) -> None:
    path = tmp_path / "a.roam"
    file.save(Project(), path)
    path.chmod(0o640)
    file.save(project, path)
    assert path.stat().st_mode & 0o777 == 0o640


def test_scalars_of_numpy_are_the_numbers_that_they_are(tmp_path: Path) -> None:
    keys = (Keyframe(np.int64(7), POINTS, confidence=np.float64(0.5)),)
    shape = RotoShape("shape-1", "A", keys, opacity=np.float32(0.5), lifetime=(np.int32(3), np.int32(9)))
    file.save(Project(root=Layer("root", "Root", (shape,))), tmp_path / "a.roam")
    (back,) = file.load(tmp_path / "a.roam").shapes
    assert (back.keys[0].frame, back.keys[0].confidence, back.opacity, back.lifetime) == (7, 0.5, 0.5, (3, 9))
