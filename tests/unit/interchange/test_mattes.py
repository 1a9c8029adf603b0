"""Mattes as files: pixels of every kind and depth, parts, names, whole files only, sentences."""

from __future__ import annotations

import json
from dataclasses import replace
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

from roam_core.arrays import Float32
from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, write_mattes
from roam_core.interchange.matte_style import (
    COMPRESSIONS,
    DEPTHS,
    DataWindow,
    Depth,
    Gathering,
    MatteFile,
    MatteStyle,
    Parts,
)
from roam_core.interchange.mattes.files import encode_png
from roam_core.matte import render_matte, shape_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Origin, Project, RotoShape

SIZE = (24, 32)


@pytest.fixture
def shape() -> RotoShape:
    """A triangle that moves right by a pixel a frame from 1001 to 1005; the engine made the key of 1003."""
    start = bezier.polygon_points([(4.3, 3.1), (20.7, 9.4), (7.2, 20.9)])
    frames = (1001, 1003, 1005)
    shifts = (0.0, 5.0, 4.0)
    keys = (
        Keyframe(f, start + np.array([d, 0.0]), origin=Origin.ENGINE if f == 1003 else Origin.ARTIST)
        for f, d in zip(frames, shifts, strict=True)
    )
    return RotoShape("shape-1", "Triangle", tuple(keys))


@pytest.fixture
def project(shape: RotoShape) -> Project:
    return Project(Clip(Path("/plates/shot.mov"), 1001, 1005, (SIZE[1], SIZE[0])), Layer("root", "Root", (shape,)))


def name_for(frame: int) -> str:
    return f"m.{frame}.png"


@pytest.mark.parametrize(("depth", "dtype", "white"), [("8", np.uint8, 255), ("16", np.uint16, 65535)])
def test_pixels_are_the_rendered_matte(shape: RotoShape, tmp_path: Path, depth: str, dtype: type, white: int) -> None:
    paths = write_mattes([shape], [1001, 1004], tmp_path, name_for, SIZE, style=MatteStyle(depth=Depth(depth))).made
    assert [path.name for path in paths] == ["m.1001.png", "m.1004.png"]
    for frame, path in zip([1001, 1004], paths, strict=True):
        picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        assert picture is not None
        assert picture.dtype == dtype
        assert picture.shape == SIZE
        np.testing.assert_allclose(picture / white, render_matte([shape], frame, SIZE), atol=0.5001 / white)
        assert ((picture > 0) & (picture < white)).sum() > 20  # antialiased


def test_the_folder_is_made(shape: RotoShape, tmp_path: Path) -> None:
    write_mattes([shape], [1001], tmp_path / "new" / "mattes", name_for, SIZE)
    assert (tmp_path / "new" / "mattes" / "m.1001.png").is_file()


def test_a_cancelled_run_leaves_whole_files_only(shape: RotoShape, tmp_path: Path) -> None:
    token = CancelToken()

    def progress(fraction: float, _: str) -> None:
        if fraction > 0.5:
            token.cancel()

    with pytest.raises(Cancelled):
        write_mattes([shape], range(1001, 1006), tmp_path, name_for, SIZE, progress=progress, token=token)
    names = sorted(path.name for path in tmp_path.iterdir())
    assert names == ["m.1001.png", "m.1002.png", "m.1003.png", "m.1004.png"]
    assert all(cv2.imread(str(tmp_path / name)) is not None for name in names)


def test_progress_rises_to_one(shape: RotoShape, tmp_path: Path) -> None:
    told: list[tuple[float, str]] = []
    write_mattes([shape], [1001, 1002], tmp_path, name_for, SIZE, progress=lambda *news: told.append(news))
    assert told == [(0.0, "Matte of frame 1001"), (0.5, "Matte of frame 1002"), (1.0, "Wrote 2 matte(s).")]


@pytest.mark.parametrize("name", ["", "..", "a/b.png", "/a.png", "nul\0.png"])
def test_a_name_that_leaves_the_folder_is_refused(shape: RotoShape, tmp_path: Path, name: str) -> None:
    with pytest.raises(RoamError, match="no file name"):
        write_mattes([shape], [1001], tmp_path, lambda _: name, SIZE)


def test_two_frames_of_one_name_are_refused_before_anything_is_written(shape: RotoShape, tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="frames 1001 and 1002"):
        write_mattes([shape], [1001, 1002], tmp_path, lambda _: "m.png", SIZE)
    assert list(tmp_path.iterdir()) == []


def test_a_file_in_place_of_the_folder_is_told_in_a_sentence(shape: RotoShape, tmp_path: Path) -> None:
    (tmp_path / "file").write_text("")
    with pytest.raises(RoamError, match=r"folder .* cannot be made"):
        write_mattes([shape], [1001], tmp_path / "file", name_for, SIZE)


def test_a_folder_in_place_of_a_file_is_told_in_a_sentence(shape: RotoShape, tmp_path: Path) -> None:
    (tmp_path / "m.1001.png").mkdir()
    with pytest.raises(RoamError, match="cannot be written"):
        write_mattes([shape], [1001], tmp_path, name_for, SIZE)
    assert [path.name for path in tmp_path.iterdir()] == ["m.1001.png"]


STYLES = [
    MatteStyle(file, depth, compression)
    for file in (MatteFile.EXR, MatteFile.TIFF)
    for depth in DEPTHS[file]
    for compression in COMPRESSIONS[file]
]


def read(path: Path) -> tuple[dict[str, Float32], oiio.ImageSpec]:
    """The channels of a file by OpenImageIO, as floating point over the display window."""
    picture = oiio.ImageBuf(str(path))
    assert not picture.has_error, picture.geterror()
    spec = picture.spec()
    window = oiio.ROI(0, spec.full_width, 0, spec.full_height, 0, 1, 0, spec.nchannels)
    pixels = picture.get_pixels(oiio.FLOAT, window)
    return {name: pixels[..., k] for k, name in enumerate(spec.channelnames)}, spec


@pytest.mark.parametrize("style", STYLES, ids=lambda s: f"{s.file}-{s.depth}-{s.compression}")
def test_every_kind_depth_and_compression_holds_the_matte(shape: RotoShape, tmp_path: Path, style: MatteStyle) -> None:
    (path,) = write_mattes([shape], [1004], tmp_path, name_for, SIZE, style=style, pixel_aspect=1.5).made
    (matte,), spec = (*read(path)[0].values(),), read(path)[1]
    step = {"8": 0.5 / 255, "16": 0.5 / 65535, "half": 2.0**-12, "float": 0.0}[style.depth_or_own]
    np.testing.assert_allclose(matte, render_matte([shape], 1004, SIZE), atol=1.0001 * step)
    kinds = {"8": "uint8", "16": "uint16", "half": "half", "float": "float"}
    assert str(spec.format) == kinds[style.depth_or_own]
    assert spec.get_string_attribute("compression") == style.compression_or_own
    assert spec.get_float_attribute("PixelAspectRatio") == 1.5


@pytest.fixture
def group(shape: RotoShape) -> Layer:
    """Two layers, one of them in the other, with a hole and shapes that cannot be seen."""
    other = RotoShape("shape-2", "Triangle", shape.keys, opacity=0.5, invert=True)
    hole = RotoShape("shape-3", "Hölle {name}/..", shape.keys, blend=BlendMode.SUBTRACT, opacity=0.25)
    unseen = RotoShape("shape-4", "Unseen", shape.keys, visible=False)
    inner = Layer("layer-2", "Inner", (other, unseen))
    outer = Layer("layer-1", "Outer", (shape, inner, hole), opacity=0.5)
    dark = Layer("layer-3", "Dark", (RotoShape("shape-5", "In the dark", shape.keys),), visible=False)
    return Layer("root", "Root", (outer, dark))


def test_every_shape_has_a_file_in_a_folder_of_its_own_that_shows_it_alone(group: Layer, tmp_path: Path) -> None:
    paths = write_mattes(group, [1002], tmp_path, name_for, SIZE, style=MatteStyle(parts=Parts.SHAPE)).made
    names = [path.relative_to(tmp_path).as_posix() for path in paths]
    assert names == ["Triangle/m.1002.png", "Triangle_2/m.1002.png", "Holle_name/m.1002.png"]
    alone = [shape for shape in group.shapes() if shape.name not in ("Unseen", "In the dark")]
    for shape, path in zip(alone, paths, strict=True):
        picture = cv2.imread(str(path), cv2.IMREAD_UNCHANGED)
        assert picture is not None
        np.testing.assert_allclose(picture / 255, shape_matte(shape, 1002, SIZE), atol=0.51 / 255)


def test_every_layer_has_a_file_that_shows_what_it_joins(group: Layer, tmp_path: Path) -> None:
    loose = RotoShape("shape-6", "Loose", next(group.shapes()).keys)
    root = replace(group, children=(*group.children, loose))
    style = MatteStyle(MatteFile.EXR, Depth.FLOAT, parts=Parts.LAYER)
    paths = write_mattes(root, [1002], tmp_path, lambda frame: f"{{name}}.{frame}.exr", SIZE, style=style).made
    assert [path.name for path in paths] == ["Root.1002.exr", "Outer.1002.exr", "Inner.1002.exr"]
    outer = group.children[0]
    assert isinstance(outer, Layer)
    for content, path in zip(([loose], outer, outer.children[1]), paths, strict=True):
        (matte,) = read(path)[0].values()
        np.testing.assert_array_equal(matte, render_matte(content, 1002, SIZE))  # type: ignore[arg-type]


@pytest.mark.parametrize("window", DataWindow)
def test_a_file_of_channels_holds_every_shape_by_name_and_the_joint_matte(
    group: Layer, tmp_path: Path, window: DataWindow
) -> None:
    style = MatteStyle(MatteFile.EXR, Depth.FLOAT, None, Parts.SHAPE, Gathering.CHANNELS, window)
    (path,) = write_mattes(group, [1002], tmp_path, name_for, SIZE, style=style).made
    channels, spec = read(path)
    assert set(channels) == {"A", "Triangle.A", "Triangle_2.A", "Holle_name.A"}
    np.testing.assert_array_equal(channels["A"], render_matte(group, 1002, SIZE))
    shape, other = list(group.shapes())[:2]
    np.testing.assert_array_equal(channels["Triangle.A"], shape_matte(shape, 1002, SIZE))
    np.testing.assert_array_equal(channels["Triangle_2.A"], shape_matte(other, 1002, SIZE))
    names = json.loads(spec.get_string_attribute("roam:names"))
    assert names == {"Triangle.A": "Triangle", "Triangle_2.A": "Triangle", "Holle_name.A": "Hölle {name}/.."}


def test_a_tight_window_leaves_out_the_black(shape: RotoShape, tmp_path: Path) -> None:
    style = MatteStyle(MatteFile.EXR, Depth.FLOAT, window=DataWindow.TIGHT)
    (path,) = write_mattes([shape], [1001], tmp_path, name_for, SIZE, style=style).made
    (matte,), spec = (*read(path)[0].values(),), read(path)[1]
    expected = render_matte([shape], 1001, SIZE)
    np.testing.assert_array_equal(matte, expected)
    rows, columns = expected.any(axis=1).nonzero()[0], expected.any(axis=0).nonzero()[0]
    assert (spec.x, spec.y) == (columns[0], rows[0])
    assert (spec.width, spec.height) == (columns[-1] + 1 - columns[0], rows[-1] + 1 - rows[0])
    assert (spec.full_width, spec.full_height) == (SIZE[1], SIZE[0])


def test_a_tight_window_of_nothing_is_one_pixel(shape: RotoShape, tmp_path: Path) -> None:
    away = replace(shape, lifetime=(2000, 2001))
    style = MatteStyle(MatteFile.EXR, window=DataWindow.TIGHT)
    (path,) = write_mattes([away], [1001], tmp_path, name_for, SIZE, style=style).made
    (matte,), spec = (*read(path)[0].values(),), read(path)[1]
    assert (spec.width, spec.height, matte.max()) == (1, 1, 0.0)


def test_resuming_skips_what_is_there_and_only_that(shape: RotoShape, tmp_path: Path) -> None:
    (tmp_path / "m.1001.png").write_bytes(b"finished before")
    (tmp_path / "m.1002.png").write_bytes(b"")
    told: list[str] = []

    def progress(_: float, text: str) -> None:
        told.append(text)

    style, frames = MatteStyle(resumes=True), [1001, 1002, 1003]
    written = write_mattes([shape], frames, tmp_path, name_for, SIZE, style=style, progress=progress)
    assert [path.name for path in written.made] == ["m.1002.png", "m.1003.png"]
    assert [path.name for path in written.kept] == ["m.1001.png"]
    assert told[-1] == "Wrote 2 matte(s); 1 there already."
    assert (tmp_path / "m.1001.png").read_bytes() == b"finished before"
    assert all(cv2.imread(str(tmp_path / name_for(frame))) is not None for frame in (1002, 1003))
    write_mattes([shape], [1001], tmp_path, name_for, SIZE)
    assert (tmp_path / "m.1001.png").read_bytes() != b"finished before"


@pytest.mark.parametrize(
    ("asked", "sentence"),
    [
        ({"depth": Depth.HALF}, "PNG mattes are 8 or 16 deep, not half"),
        ({"file": MatteFile.EXR, "depth": Depth.BITS_8}, "EXR mattes are half or float deep, not 8"),
        ({"file": MatteFile.TIFF, "compression": "piz"}, "TIFF mattes are compressed by zip, lzw, packbits or none"),
        ({"gathering": Gathering.CHANNELS}, "PNG files hold no channels with names; ask for EXR"),
        ({"window": DataWindow.TIGHT, "file": MatteFile.TIFF}, "TIFF files hold all pixels"),
    ],
)
def test_what_a_file_cannot_hold_is_refused_in_a_sentence(asked: dict[str, Any], sentence: str) -> None:
    with pytest.raises(RoamError, match=sentence):
        MatteStyle(**asked)


def test_other_depths_of_png_are_refused() -> None:
    with pytest.raises(RoamError, match="8 or 16 bits"):
        encode_png(np.zeros((2, 2), dtype=np.float32), 10)


def test_the_suffix_says_what_the_exporter_writes(project: Project, tmp_path: Path) -> None:
    EXPORTERS["mattes"].export(project, tmp_path / "hero.####.exr")
    assert str(read(tmp_path / "hero.1003.exr")[1].format) == "half"
    exr = ExportOptions(mattes=MatteStyle(MatteFile.EXR))
    EXPORTERS["mattes"].export(project, tmp_path / "folder", exr)
    assert (tmp_path / "folder" / "matte.1001.exr").is_file()
    with pytest.raises(RoamError, match=r"hero.tif is the name of TIFF files, but EXR is asked for"):
        EXPORTERS["mattes"].export(project, tmp_path / "hero.tif", exr)


@pytest.mark.parametrize(
    ("target", "offset", "first"),
    [
        ("out", 0, "out/matte.1001.png"),
        ("out/hero.png", 0, "out/hero.1001.png"),
        ("out/hero.######.png", 0, "out/hero.001001.png"),
        ("out/hero_%04d_v2.PNG", -1000, "out/hero_0001_v2.PNG"),
    ],
)
def test_the_exporter_numbers_its_files(project: Project, tmp_path: Path, target: str, offset: int, first: str) -> None:
    EXPORTERS["mattes"].export(project, tmp_path / target, ExportOptions(frame_offset=offset))
    assert (tmp_path / first).is_file()
    assert len(list((tmp_path / "out").iterdir())) == 5


def test_the_exporter_may_keep_to_the_artists_keys(project: Project, tmp_path: Path) -> None:
    EXPORTERS["mattes"].export(project, tmp_path, ExportOptions(keys=KeyChoice.ARTIST))
    picture = cv2.imread(str(tmp_path / "matte.1003.png"), cv2.IMREAD_UNCHANGED)
    assert picture is not None
    (shape,) = project.shapes
    two_keys = RotoShape("a", "a", (shape.keys[0], shape.keys[2]))
    np.testing.assert_allclose(picture / 255, render_matte([two_keys], 1003, SIZE), atol=0.01)
