"""`roam import`: shapes of other programs' files in a project, and one sentence for what cannot be."""

from __future__ import annotations

import os
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.cli.export import condensed
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape, file
from roam_core.roto.project import PALETTE
from roam_core.translatable import sentence
from tests.unit.cli.conftest import Roam
from tests.unit.cli.test_bad_input import require_refusal
from tests.unit.interchange.conftest import points


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """A project with one shape in a layer."""
    shape = RotoShape("shape-1", "Arm", (Keyframe(1001, points(1)), Keyframe(1011, points(2))))
    clip = Clip(tmp_path / "plate", 1001, 1040, (1920, 1080))
    path = tmp_path / "p.roam"
    file.save(Project(clip, Layer("root", "Root", (Layer("layer-1", "Body", (shape,)),))), path)
    return path


@pytest.mark.parametrize(("name", "suffix"), [("nuke", ".nk"), ("silhouette", ".fxs")])
def test_shapes_that_were_exported_come_back_on_top(roam: Roam, project: Path, name: str, suffix: str) -> None:
    middle, target = project.with_suffix(suffix), project.parent / "more.roam"
    roam("export", project, middle, "--to", name, "--frame-offset", "-1000")
    done = roam("import", middle, "--into", project, "--save", target, "--frame-offset", "-1000")
    assert (done.status, done.out) == (0, "")
    assert done.err.endswith(f"Read 1 shape(s) from {middle} into {target}.\n")
    first, second = file.load(target).shapes
    assert (first.name, second.name) == ("Arm", "Arm")
    assert first.id != second.id
    assert second.frames == (1001, 1011)
    np.testing.assert_allclose(second.at(1006).points, first.at(1006).points, atol=0.01)
    assert len(file.load(project).shapes) == 1


def test_shapes_come_back_from_a_file_without_a_suffix(roam: Roam, project: Path) -> None:
    """What was asked for is written, and it is told how programs know such files."""
    bare = project.parent / "hero"
    done = roam("export", project, bare, "--to", "nuke")
    assert done.status == 0
    assert f"{bare} has no suffix: other programs know such files by names that end in .nk." in done.err
    assert bare.is_file()
    assert roam("import", bare, "--into", project).status == 0
    assert len(file.load(project).shapes) == 2
    with_suffix = roam("export", project, project.with_suffix(".nk"), "--to", "nuke")
    assert "suffix" not in with_suffix.err


def test_a_project_that_is_not_there_is_told_with_what_makes_one(roam: Roam, project: Path) -> None:
    middle, none = project.with_suffix(".nk"), project.with_name("none.roam")
    roam("export", project, middle, "--to", "nuke")
    require_refusal(roam("import", middle, "--into", none), f"{none} does not exist; name its plate, by --clip")
    assert not none.exists()


def test_what_is_so_with_many_shapes_is_told_once(roam: Roam, tmp_path: Path) -> None:
    shapes = [
        RotoShape(f"shape-{k}", f"Arm {k}", (Keyframe(1001, points(1)),), blend=BlendMode.SUBTRACT) for k in range(20)
    ]
    path = tmp_path / "many.roam"
    clip = Clip(tmp_path / "plate", 1001, 1040, (1920, 1080))
    file.save(Project(clip, Layer("root", "Root", tuple(shapes))), path)
    told = roam("export", path, tmp_path / "a.xml", "--to", "cvat", "--lossy").err.splitlines()
    alike = [line for line in told if "the mode 'subtract' of" in line or "mode 'subtract'" in line]
    assert alike == [
        "Polygons of CVAT only add: the mode 'subtract' of 'Arm 0' is lost. So it is with 'Arm 1', 'Arm 2', 'Arm 3', "
        "'Arm 4', 'Arm 5', 'Arm 6' and 13 more."
    ]


def test_many_notes_of_one_kind_do_not_bury_others() -> None:
    alike = [sentence("{name!r} moves by {px} px.", name=f"Arm {k}", px=k) for k in range(20)]
    assert list(condensed([*alike, "Else."]))[11:] == [alike[11], "(and 8 more like this; --json lists all)", "Else."]


def test_an_earlier_version_of_a_project_is_one(roam: Roam, project: Path, tmp_path: Path) -> None:
    """`P.roam.1` is told by its content: its shapes are tracked from, and `import` says what it is."""
    earlier, plate = project.rename(tmp_path / "p.roam.1"), tmp_path / "frames"
    plate.mkdir()
    for frame in (1001, 1002):
        cv2.imwrite(str(plate / f"plate.{frame}.png"), np.full((1080, 1920, 3), 90, np.uint8))
    done = roam("track", plate, "--init", earlier, "--config", "baseline", "--end", 1001, "--save", tmp_path / "n.roam")
    assert done.status == 0, done.err
    assert [shape.name for shape in file.load(tmp_path / "n.roam").shapes] == ["Arm"]
    require_refusal(roam("import", earlier, "--into", tmp_path / "n.roam"), earlier, "is a project")


@pytest.mark.parametrize("words", ["import {pipe} --into {project}", "track {folder} --init {pipe}"])
def test_a_pipe_is_told_as_what_it_is(roam: Roam, project: Path, words: str) -> None:
    """As a shell gives it for `<(cat mask.png)`; nobody waits for its other end."""
    pipe, folder = project.parent / "63", project.parent / "plate"
    os.mkfifo(pipe)
    folder.mkdir()
    cv2.imwrite(str(folder / "plate.1001.png"), np.zeros((8, 8, 3), np.uint8))
    require_refusal(roam(*words.format(pipe=pipe, project=project, folder=folder).split()), pipe, "is a pipe")


def test_the_project_itself_grows_when_no_other_is_named(roam: Roam, project: Path) -> None:
    roam("export", project, project.with_suffix(".nk"), "--to", "nuke")
    assert roam("import", project.with_suffix(".nk"), "--into", project).status == 0
    assert len(file.load(project).shapes) == 2


@pytest.mark.parametrize(
    ("name", "content", "message"),
    [
        ("a.nk", "Blur {\n size 3\n}\n", "no Roto"),
        ("a.fxs", "<Other/>", "no Silhouette shape file"),
        ("a.fxs", "<Silhouette/>", "no shape that ROAM can read"),
        ("a.obj", "v 1 2 3", "no suffix that ROAM reads"),
        ("missing.nk", None, "does not exist"),
        ("mattes", None, "does not exist; give a file of shapes, a mask or a folder of masks"),
    ],
)
def test_bad_files_are_one_sentence(roam: Roam, project: Path, name: str, content: str | None, message: str) -> None:
    source, before = project.parent / name, project.read_bytes()
    if content is not None:
        source.write_text(content)
    done = roam("import", source, "--into", project)
    assert (done.status, done.out) == (1, "")
    assert done.err.startswith("roam: ")
    assert message in done.err
    assert len(done.err.splitlines()) == 1
    assert project.read_bytes() == before


def test_shapes_of_files_without_colours_go_on_in_the_palette(roam: Roam, project: Path, tmp_path: Path) -> None:
    """Also those of a second file: no two of them look alike."""
    text = '{"format": "roam-shapes", "version": 1, "width": 1920, "height": 1080, "items": [%s, %s]}'
    item = '{"kind": "shape", "name": "A", "keys": [{"frame": 1001, "points": [[10, 10], [90, 10], [50, 90]]}]}'
    (tmp_path / "plain.json").write_text(text % (item, item), encoding="utf-8")
    for _ in range(2):
        assert roam("import", tmp_path / "plain.json", "--into", project).status == 0
    assert [shape.colour for shape in file.load(project).shapes[1:]] == list(PALETTE[1:5])


def test_masks_become_few_keys_or_every_one_and_what_was_achieved_is_told(roam: Roam, project: Path) -> None:
    folder = project.parent / "mattes"
    folder.mkdir()
    for f in range(5):
        mask = np.zeros((1080, 1920), np.uint8)
        cv2.circle(mask, (300 + 9 * f, 300), 60, 255, -1, cv2.LINE_AA)
        cv2.imwrite(str(folder / f"m.{1001 + f}.png"), mask)
    for keys, count in (("reduced", 2), ("every", 5)):
        target = project.parent / f"{keys}.roam"
        words = ("--tolerance", 1, "--keys", keys)
        done = roam("import", folder, "--into", project, "--save", target, *words)
        assert done.status == 0
        assert f"{count} keys for 5 frames; at least 100 % of the outline within 1 px on every frame" in done.err
        assert len(file.load(target).shapes[-1].keys) == count


def test_a_tolerance_that_is_none_is_refused(roam: Roam, project: Path) -> None:
    folder = project.parent / "mattes"
    folder.mkdir()
    cv2.imwrite(str(folder / "m.1001.png"), np.full((1080, 1920), 255, np.uint8))
    done = roam("import", folder, "--into", project, "--tolerance", -1)
    assert done.status != 0
    assert "positive number of pixels" in done.err
    assert len(file.load(project).shapes) == 1


@pytest.mark.parametrize("words", [(), ("--json",)])
def test_why_nothing_could_be_read_is_told(roam: Roam, project: Path, words: tuple[str, ...]) -> None:
    """With --json too, of which no line comes then: a script has the reason in its log."""
    path = project.with_name("p.svg")
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="48" height="36"><text x="5" y="9">A</text></svg>')
    done = roam("import", path, "--into", project, *words)
    assert (done.status, done.out) == (1, "")
    *reasons, refusal = done.err.splitlines()
    assert any("text" in reason for reason in reasons)
    assert "holds no shape that ROAM can read" in refusal


def test_a_folder_in_the_place_of_the_project_is_said_to_be_one(roam: Roam, project: Path) -> None:
    """It was said to be there already and to have a clip of its own."""
    roam("export", project, project.with_suffix(".nk"), "--to", "nuke")
    (project.parent / "shots").mkdir()
    words = ("--into", project.parent / "shots", "--clip", project.parent)
    require_refusal(roam("import", project.with_suffix(".nk"), *words), "is a folder; name the project")
