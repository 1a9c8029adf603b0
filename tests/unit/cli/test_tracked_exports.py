"""A shot that is really tracked, written to every format on the command line: each judge finds the outline again."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path

import pytest

from roam_core.arrays import Array
from roam_core.interchange import read_shapes
from roam_core.roto import RotoShape, file
from tests.unit.cli.conftest import Plate, Roam
from tests.unit.interchange import lua_judge, natron_judge, node_judge, nuke_judge, silhouette_judge, tcl
from tests.unit.interchange.judged import JudgedMask, farthest, overlap

Points = Callable[[int], Array]
SIZE = (110, 130)


@pytest.fixture(scope="module")
def tracked(tmp_path_factory: pytest.TempPathFactory) -> Callable[[Roam, Plate], Path]:
    """The project of the tracked plate, solved once for all formats."""
    path = tmp_path_factory.mktemp("tracked") / "p.roam"

    def solved(roam: Roam, plate: Plate) -> Path:
        if not path.exists():
            assert roam("track", plate.folder, "--init", plate.mask, "--save", path).status == 0
        return path

    return solved


def nuke(text: str, _: Path) -> Points:
    (shape,) = nuke_judge.judge(text).root.shapes()
    return shape.points


def silhouette(text: str, _: Path) -> Points:
    (shape,) = silhouette_judge.judge(text)[1].shapes()
    return lambda frame: shape.points(frame - 1001)


def fusion(text: str, _: Path) -> Points:
    (mask,) = lua_judge.judge(text)
    return mask.points


def natron(text: str, _: Path) -> Points:
    (mask,) = natron_judge.judge(text, SIZE[0])[0]
    return mask.points


def after_effects(text: str, folder: Path) -> Points:
    (mask,) = node_judge.masks(node_judge.ran(text, folder), 24.0, 1001)
    return mask.points


@pytest.mark.parametrize("judge", [nuke, silhouette, fusion, natron, after_effects], ids=lambda judge: judge.__name__)
@pytest.mark.parametrize("words", [(), ("--keys", "reduced", "--tolerance", "0.2")], ids=["every", "reduced"])
def test_a_judge_finds_the_outline(
    roam: Roam,
    plate: Plate,
    tracked: Callable[[Roam, Plate], Path],
    tmp_path: Path,
    judge: Callable[[str, Path], Points],
    words: tuple[str, ...],
) -> None:
    project = tracked(roam, plate)
    (shape,) = file.load(project).shapes
    out = tmp_path / "shapes"
    assert roam("export", project, "--to", judge.__name__.replace("_", "-"), out, *words).status == 0
    points = judge(out.read_text(encoding="utf-8"), tmp_path)
    check(shape, points, 0.25 if words else 0.01)


@pytest.mark.parametrize("name", ["nuke.nk", "silhouette.fxs", "json.json"])
def test_it_comes_back(
    roam: Roam, plate: Plate, tracked: Callable[[Roam, Plate], Path], tmp_path: Path, name: str
) -> None:
    project = tracked(roam, plate)
    loaded = file.load(project)
    out = tmp_path / name
    assert roam("export", project, "--to", out.stem, out).status == 0
    (back,) = read_shapes(out, loaded.require_clip()).layer.shapes()
    check(loaded.shapes[0], lambda frame: back.at(frame).points, 0.01)


@pytest.mark.parametrize("name", ["nuke-python", "nuke-tracks", "blender", "svg"])
def test_the_other_files_are_well_formed(
    roam: Roam, plate: Plate, tracked: Callable[[Roam, Plate], Path], tmp_path: Path, name: str
) -> None:
    """Python compiles the scripts, Tcl splits the nodes, an XML parser reads the drawing; their own tests say more."""
    out = tmp_path / "file"
    assert roam("export", tracked(roam, plate), "--to", name, out).status == 0
    text = out.read_text(encoding="utf-8")
    if name == "nuke-tracks":
        assert tcl.available().split(text.removeprefix("# Written by ROAM\n"))[3::2] == ["Tracker4", "CornerPin2D"]
    elif name == "svg":
        assert len([each for each in ET.fromstring(text).iter() if each.tag.endswith("path")]) == 1
    else:
        compile(text, name, "exec")


def check(shape: RotoShape, points: Points, within: float) -> None:
    """Outlines near each other on every other frame, and pixels the same."""
    assert len(shape.keys) == 6
    for frame in shape.frames[::2]:
        assert farthest(points(frame), shape.at(frame).points) <= within
        assert overlap(JudgedMask("", True, {frame: points(frame)}), shape, frame, SIZE) > 0.99
