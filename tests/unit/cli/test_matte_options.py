"""`roam render` and `roam export --to mattes`: kinds of files, parts, names, taking up again."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape, file
from tests.judges.exr_header import header, rate, time_code
from tests.unit.cli.conftest import Roam, read_matte, write_picture
from tests.unit.matte.conftest import rectangle


@pytest.fixture
def project(tmp_path: Path) -> Path:
    """Two rectangles on frames 7 to 9 of a plate that is not there."""
    left, right = rectangle(2.0, 2.0, 10.0, 10.0, frame=7), rectangle(12.0, 4.0, 20.0, 12.0, frame=7)
    shapes = (
        RotoShape("shape-1", "Left arm", left.keys),
        RotoShape("shape-2", "Right", (Keyframe(8, right.keys[0].points),)),
    )
    path = tmp_path / "p.roam"
    file.save(Project(Clip(Path("/plates/gone"), 7, 9, (24, 16)), Layer("root", "Root", shapes)), path)
    return path


def names(folder: Path) -> list[str]:
    return sorted(path.relative_to(folder).as_posix() for path in folder.rglob("*") if path.is_file())


def test_every_shape_is_rendered_into_a_folder_of_its_own(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("render", project, "--out", tmp_path / "out", "--per", "shape", "--start", 8)
    assert (done.status, done.err) == (0, f"Wrote 4 matte(s) to {tmp_path / 'out'}.\n")
    assert names(tmp_path / "out") == ["Left_arm/0008.png", "Left_arm/0009.png", "Right/0008.png", "Right/0009.png"]
    assert read_matte(tmp_path / "out" / "Right" / "0008.png")[8, 14] == 255
    assert read_matte(tmp_path / "out" / "Right" / "0008.png")[5, 5] == 0


@pytest.mark.parametrize("command", ["render", "export"])
def test_shapes_become_channels_of_an_exr_file(roam: Roam, project: Path, tmp_path: Path, command: str) -> None:
    out = tmp_path / "out"
    words = ("--out", out, "--name", "m.####.exr") if command == "render" else ("--to", "mattes", out / "m.####.exr")
    assert (
        roam(command, project, *words, "--channels", "--tight", "--depth", "float", "--compression", "rle").status == 0
    )
    assert names(out) == ["m.0007.exr", "m.0008.exr", "m.0009.exr"]
    spec = oiio.ImageBuf(str(out / "m.0008.exr")).spec()
    assert sorted(spec.channelnames) == ["A", "Left_arm.A", "Right.A"]
    assert (spec.x, spec.y, spec.width, spec.height) == (2, 2, 18, 10)
    assert (str(spec.format), spec.get_string_attribute("compression")) == ("float", "rle")
    told = header(out / "m.0008.exr")
    assert (rate(told), time_code(told)) == ((24, 1), "00:00:00:08")


@pytest.mark.parametrize("command", ["render", "export"])
def test_shapes_become_a_cryptomatte(roam: Roam, project: Path, tmp_path: Path, command: str) -> None:
    out = tmp_path / "out"
    words = ("--out", out, "--name", "m.####") if command == "render" else ("--to", "mattes", out / "m.####")
    assert roam(command, project, *words, "--cryptomatte", "--tight").status == 0
    assert names(out) == ["m.0007.exr", "m.0008.exr", "m.0009.exr"]
    spec = oiio.ImageBuf(str(out / "m.0008.exr")).spec()
    manifest = json.loads(spec.get_string_attribute("cryptomatte/986a535/manifest"))
    assert (list(manifest), str(spec.format)) == (["Left arm", "Right"], "float")
    told = header(out / "m.0008.exr")
    assert (rate(told), time_code(told)) == ((24, 1), "00:00:00:08")
    again = roam(command, project, *words, "--cryptomatte", "--resume", "--json")
    assert again.status == 0
    told = json.loads(again.out)
    assert (told["files"], len(told["kept"])) == ([], 3) if command == "render" else told


def test_a_cryptomatte_of_holes_alone_is_told_to_be_black(roam: Roam, project: Path, tmp_path: Path) -> None:
    loaded = file.load(project)
    file.save(loaded.with_shape(replace(loaded.shape("shape-2"), blend=BlendMode.SUBTRACT)), project)
    words = ("render", project, "--out", tmp_path / "out", "--shape", "Right", "--per", "shape")
    assert "show nothing by themselves" in roam(*words, "--cryptomatte").err
    assert "show nothing by themselves" not in roam(*words).err


def test_sixteen_bit_tiffs_are_written_when_asked_for(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("render", project, "--out", tmp_path, "--file", "tiff", "--depth", 16, "--end", 7)
    assert done.status == 0
    assert str(oiio.ImageBuf(str(tmp_path / "0007.tif")).spec().format) == "uint16"


@pytest.mark.parametrize(
    ("words", "first"),
    [
        (("--name", "m.####.tiff", "--depth", "float"), "m.0007.tiff"),
        (("--name", "m.####.tif", "--compression", "lzw"), "m.0007.tif"),
        (("--name", "m.####.exr", "--depth", "float", "--compression", "piz"), "m.0007.exr"),
        (("--name", "m.####", "--depth", "float"), "m.0007.exr"),
        (("--name", "m.####", "--compression", "packbits"), "m.0007.tif"),
        (("--name", "m.####", "--depth", "16"), "m.0007.png"),
    ],
)
def test_the_name_or_what_is_asked_for_says_what_kind_of_file_is_written(
    roam: Roam, project: Path, tmp_path: Path, words: tuple[str, ...], first: str
) -> None:
    assert roam("render", project, "--out", tmp_path / "out", *words).status == 0
    assert first in names(tmp_path / "out")
    words = words[2:]
    assert roam("export", project, tmp_path / "out" / f"e{first[1:]}", "--to", "mattes", *words).status == 0


def test_a_run_is_taken_up_where_it_ended(roam: Roam, project: Path, tmp_path: Path) -> None:
    (tmp_path / "0008.png").write_bytes(b"there")
    done = roam("render", project, "--out", tmp_path, "--resume")
    assert (done.status, done.err) == (0, f"Wrote 2 matte(s) to {tmp_path}; 1 there already.\n")
    assert (tmp_path / "0008.png").read_bytes() == b"there"
    assert read_matte(tmp_path / "0009.png")[5, 5] == 255
    done = roam("render", project, "--out", tmp_path, "--resume")
    assert (done.status, done.err) == (0, f"Wrote 0 matte(s) to {tmp_path}; 3 there already.\n")
    assert roam("render", project, "--out", tmp_path, "--overwrite").err == f"Wrote 3 matte(s) to {tmp_path}.\n"


def test_an_export_that_is_taken_up_tells_what_was_there(roam: Roam, project: Path, tmp_path: Path) -> None:
    words = ("export", project, tmp_path / "m.####.png", "--to", "mattes")
    (tmp_path / "m.0008.png").write_bytes(b"there")
    assert roam(*words, "--resume").err.splitlines()[1:] == ["Wrote 2 matte(s); 1 there already."]
    assert len(roam(*words, "--overwrite").err.splitlines()) == 1


@pytest.mark.parametrize(
    ("words", "sentence"),
    [
        (("--file", "png", "--channels"), "PNG files hold no channels"),
        (("--file", "tiff", "--cryptomatte"), "TIFF files hold no Cryptomatte; ask for EXR"),
        (("--depth", "half", "--cryptomatte"), "Cryptomatte is float deep, not half"),
        (("--name", "m.####.png", "--cryptomatte"), "PNG files hold no Cryptomatte"),
        (("--channels", "--cryptomatte"), "are two ways to put mattes into one file; choose one"),
        (("--file", "exr", "--depth", "8"), "EXR mattes are half or float deep, not 8"),
        (("--name", "sub/m.####.png"), "is no file name for the matte of frame 7"),
    ],
)
def test_what_does_not_fit_is_refused_before_anything_is_written(
    roam: Roam, project: Path, tmp_path: Path, words: tuple[str, ...], sentence: str
) -> None:
    done = roam("render", project, "--out", tmp_path / "out", *words)
    assert done.status == 1
    assert sentence in done.err
    assert not (tmp_path / "out").exists() or names(tmp_path / "out") == []


def test_nothing_visible_is_told(roam: Roam, project: Path, tmp_path: Path) -> None:
    loaded = file.load(project)
    file.save(Project(loaded.clip, Layer("root", "Root")), project)
    done = roam("render", project, "--out", tmp_path / "out", "--per", "shape")
    assert done.status == 1
    assert "Nothing is visible" in done.err


def test_a_named_shape_is_rendered_and_exported_alone(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("render", project, "--out", tmp_path / "out", "--start", 8, "--end", 8, "--shape", "Right")
    assert (done.status, done.err) == (0, f"Wrote 1 matte(s) to {tmp_path / 'out'}.\n")
    matte = read_matte(tmp_path / "out" / "0008.png")
    assert (matte[5, 5], matte[8, 14]) == (0, 255)
    out = tmp_path / "p.json"
    for words, count in ((("Right",), 1), (("shape-1", "Right"), 2), ((), 2)):
        asked = [word for name in words for word in ("--shape", name)]
        done = roam("export", project, "--to", "json", out, *asked)
        assert (done.status, done.err) == (0, f"Wrote {count} shape(s) to {out}.\n")
        assert [("Left arm" in out.read_text()), ("Right" in out.read_text())] == [count == 2, True]


@pytest.mark.parametrize("command", ["render", "export"])
def test_a_shape_that_is_not_there_is_named_with_those_that_are(
    roam: Roam, project: Path, tmp_path: Path, command: str
) -> None:
    out = ("--out", tmp_path / "out") if command == "render" else ("--to", "nuke", tmp_path / "out")
    done = roam(command, project, *out, "--shape", "Left")
    assert done.status == 1
    assert done.err == "roam: There is no shape 'Left'; the shapes of the project: 'Left arm', 'Right'.\n"
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("out", ["m.%04d.png", "m.####.exr", "m.mov"])
def test_a_folder_is_not_named_as_pictures_are(roam: Roam, project: Path, tmp_path: Path, out: str) -> None:
    """`--out m.%04d.png` is meant as the files' pattern; it made a folder of that name without a word."""
    done = roam("render", project, "--out", tmp_path / "out" / out)
    assert done.status == 1
    assert "is the name of pictures; name the folder that they go to. How they are called there is --name" in done.err
    assert sorted(tmp_path.iterdir()) == [project]
    (tmp_path / out).mkdir()
    assert roam("render", project, "--out", tmp_path / out, "--end", 7).status == 0
    assert names(tmp_path / out) == ["0007.png"]


@pytest.mark.parametrize(
    ("name", "words", "reason"),
    [
        ("{nope}.####.png", (), "nothing is put in place of {nope}; {name} stands for a layer or shape"),
        ("{nope}.{name}.png", ("--per", "shape"), "nothing is put in place of {nope}"),
        ("{name}.####.png", (), "{name} stands for a layer or shape, but there is one matte of all"),
        ("{name}.####.exr", ("--cryptomatte",), "{name} stands for a layer or shape, but there is one matte of all"),
        ("{name}.####.exr", ("--channels",), "{name} stands for a layer or shape, but there is one matte of all"),
    ],
)
@pytest.mark.parametrize("command", ["render", "export"])
def test_braces_that_would_stay_in_the_names_are_refused(
    roam: Roam, project: Path, tmp_path: Path, command: str, name: str, words: tuple[str, ...], reason: str
) -> None:
    out = tmp_path / "out"
    where = ("--out", out, "--name", name) if command == "render" else ("--to", "mattes", out / name)
    done = roam(command, project, *where, *words)
    assert (done.status, reason in done.err) == (1, True), done.err
    assert not out.exists()


def test_a_project_without_shapes_says_so(roam: Roam, project: Path, tmp_path: Path) -> None:
    empty = tmp_path / "empty.roam"
    file.save(Project(file.load(project).clip), empty)
    assert f"{empty} holds no shape: its mattes are black." in roam("render", empty, "--out", tmp_path / "out").err
    done = roam("export", empty, tmp_path / "p.nk", "--to", "nuke", "--json")
    assert json.loads(done.out)["notes"] == [f"{empty} holds no shape: what was written is empty."]


@pytest.mark.parametrize("blend", [BlendMode.SUBTRACT, BlendMode.INTERSECT])
def test_a_hole_by_itself_is_told_to_be_black(roam: Roam, project: Path, tmp_path: Path, blend: BlendMode) -> None:
    loaded, out = file.load(project), tmp_path / "out"
    file.save(loaded.with_shape(replace(loaded.shape("shape-2"), blend=blend)), project)
    told = "Shapes that subtract or intersect show nothing by themselves"
    assert told in roam("render", project, "--out", out, "--shape", "Right").err
    assert read_matte(out / "0008.png").max() == 0
    for words in (("--per", "shape", "--shape", "Right"), ("--shape", "Left arm"), ()):
        assert told not in roam("render", project, "--out", tmp_path / f"out-{len(words)}", *words).err
    assert read_matte(tmp_path / "out-4" / "Right" / "0008.png").max() == 255


def test_frames_without_a_picture_are_named_where_they_get_no_matte(roam: Roam, project: Path, tmp_path: Path) -> None:
    """Of a plate that is wholly out of reach, as `project`'s, every frame gets one."""
    loaded = file.load(project)
    (tmp_path / "plate").mkdir()
    for frame in (7, 9):
        write_picture(tmp_path / "plate" / f"p.{frame}.png", np.zeros((16, 24, 3), np.uint8))
    file.save(Project(replace(loaded.require_clip(), path=tmp_path / "plate"), loaded.root), project)
    done = roam("render", project, "--out", tmp_path / "out")
    assert (done.status, names(tmp_path / "out")) == (0, ["p.7.png", "p.9.png"])
    assert "The plate has no picture of frame(s) 8: no matte is written there" in done.err


def test_a_name_of_pictures_that_are_not_written_is_refused(roam: Roam, project: Path, tmp_path: Path) -> None:
    """As of an export: the mattes were called `hero.0007.jpg.png`."""
    done = roam("render", project, "--out", tmp_path / "out", "--name", "hero.####.jpg")
    assert (done.status, (tmp_path / "out").exists()) == (1, False)
    assert done.err == "roam: Mattes are written as PNG, EXR or TIFF; hero.####.jpg would be none of these.\n"


def test_many_files_are_counted_and_few_are_named(roam: Roam, project: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    mattes = out / "m.####.png"
    done = roam("export", project, "--to", "mattes", mattes, "--frames", 7, 8)
    assert done.err == "Wrote 2 shape(s) to m.0007.png, m.0008.png.\n"
    done = roam("export", project, "--to", "mattes", mattes, "--per", "shape")
    assert (
        done.err
        == f"Wrote 2 shape(s) to 6 files, {out / 'Left_arm' / 'm.0007.png'} to {out / 'Right' / 'm.0009.png'}.\n"
    )


def test_a_name_stands_in_a_folder_too(roam: Roam, project: Path, tmp_path: Path) -> None:
    pattern = tmp_path / "out" / "{name}" / "{name}.####.png"
    assert roam("export", project, "--to", "mattes", pattern, "--per", "shape", "--frames", 7, 7).status == 0
    made = sorted(str(path.relative_to(tmp_path / "out")) for path in (tmp_path / "out").rglob("*"))
    assert made == ["Left_arm", "Left_arm/Left_arm.0007.png", "Right", "Right/Right.0007.png"]
    done = roam("export", project, "--to", "mattes", pattern)
    assert "{name} stands for a layer or shape, but there is one matte of all" in done.err
    done = roam("render", project, "--out", tmp_path / "{name}", "--per", "shape")
    assert (done.status, done.err.count("{name} stands for a layer or shape in --name")) == (1, 1)
    assert not list(tmp_path.glob("{*"))


def test_one_frame_for_a_pattern_of_drawings_is_refused(roam: Roam, project: Path, tmp_path: Path) -> None:
    done = roam("export", project, "--to", "svg", tmp_path / "p.####.svg", "--frame", "8")
    assert (done.status, done.err.count("--frame asks for one; say --frames 8 8.")) == (1, 1)
    assert not list(tmp_path.glob("*.svg"))
