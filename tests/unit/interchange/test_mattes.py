"""PNG mattes: pixels, names, whole files only, sentences."""

from __future__ import annotations

from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice, write_mattes
from roam_core.matte import render_matte
from roam_core.roto import Clip, Keyframe, Layer, Origin, Project, RotoShape

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


@pytest.mark.parametrize(("bits", "dtype", "white"), [(8, np.uint8, 255), (16, np.uint16, 65535)])
def test_pixels_are_the_rendered_matte(shape: RotoShape, tmp_path: Path, bits: int, dtype: type, white: int) -> None:
    paths = write_mattes([shape], [1001, 1004], tmp_path, name_for, SIZE, bits=bits)
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
    assert told == [(0.0, "Matte of frame 1001"), (0.5, "Matte of frame 1002"), (1.0, "2 mattes written")]


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


def test_other_depths_are_refused(shape: RotoShape, tmp_path: Path) -> None:
    with pytest.raises(RoamError, match="8 or 16 bits"):
        write_mattes([shape], [1001], tmp_path, name_for, SIZE, bits=10)


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
