"""Rates and time codes of EXR files: read by hand, by OpenImageIO, and by OpenEXR's own library where it is there."""

from __future__ import annotations

from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import numpy as np
import OpenImageIO as oiio  # noqa: N813
import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, write_mattes
from roam_core.interchange.matte_style import MatteFile, MatteStyle
from roam_core.interchange.mattes.timecode import Moment, rational
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape
from tests.judges.exr_header import header, rate, time_code

SIZE = (48, 64)
EXR = MatteStyle(MatteFile.EXR)
SQUARE = np.array([(10, 10), (50, 10), (50, 40), (10, 40)], dtype=np.float64)


@pytest.fixture
def shape() -> RotoShape:
    return RotoShape("shape-1", "Square", (Keyframe(1001, np.repeat(SQUARE[:, None], 3, axis=1)),))


def written(shape: RotoShape, folder: Path, frame: int, fps: float) -> Path:
    name = f"m.{frame}.exr"
    return write_mattes([shape], [frame], folder, lambda _: name, SIZE, style=EXR, fps=fps).made[0]


@pytest.mark.parametrize(
    ("fps", "frame", "fraction", "code"),
    [
        (24.0, 1001, (24, 1), "00:00:41:17"),
        (25.0, 1001, (25, 1), "00:00:40:01"),
        (30.0, 107892, (30, 1), "00:59:56:12"),
        (23.976, 86400, (24000, 1001), "01:00:00:00"),
        (24000 / 1001, 1001, (24000, 1001), "00:00:41:17"),
        (23.98, 0, (24000, 1001), "00:00:00:00"),
        (29.97, 1799, (30000, 1001), "00:00:59;29"),
        (29.97, 1800, (30000, 1001), "00:01:00;02"),
        (29.97, 17981, (30000, 1001), "00:09:59;29"),
        (29.97, 17982, (30000, 1001), "00:10:00;00"),
        (30000 / 1001, 107892, (30000, 1001), "01:00:00;00"),
        (59.94, 3599, (60000, 1001), "00:00:59;29.2"),
        (59.94, 3600, (60000, 1001), "00:01:00;02"),
        (60.0, 3600, (60, 1), "00:01:00:00"),
        (50.0, 51, (50, 1), "00:00:01:00.2"),
        (47.952, 48, (48000, 1001), "00:00:01:00"),
        (24.0, -1, (24, 1), "23:59:59:23"),
        (24.0, 24 * 86400, (24, 1), "00:00:00:00"),
        (12.0, 13, (12, 1), "00:00:01:01"),
    ],
)
def test_an_exr_file_tells_the_rate_and_the_time_of_its_frame(
    shape: RotoShape, tmp_path: Path, fps: float, frame: int, fraction: tuple[int, int], code: str
) -> None:
    path = written(shape, tmp_path, frame, fps)
    attributes = header(path)
    assert rate(attributes) == fraction
    assert time_code(attributes) == code
    spec = oiio.ImageBuf(str(path)).spec()
    assert spec.getattribute("framesPerSecond") == fraction
    assert spec.getattribute("smpte:TimeCode")[0] == Moment(frame, fps).time_code()


@pytest.mark.parametrize("fps", [12.5, 100.0, 119.88, 33.0, 24.99, 0.3])
def test_a_rate_that_time_code_cannot_count_has_none(shape: RotoShape, tmp_path: Path, fps: float) -> None:
    attributes = header(written(shape, tmp_path, 1001, fps))
    numerator, denominator = rate(attributes)
    assert numerator / denominator == pytest.approx(fps, rel=1e-5)
    assert "timeCode" not in attributes


def counted(whole: int) -> Iterator[tuple[int, int, int, int]]:
    """Every number of a day by the words of the standard: at 30, numbers 0 and 1 of most minutes do not exist."""
    for hour in range(24):
        for minute in range(60):
            for second in range(60):
                for frame in range(whole):
                    if not (second == 0 and frame < 2 and minute % 10):
                        yield hour, minute, second, frame


def test_dropped_numbers_are_those_of_the_standard_all_day() -> None:
    for frame, (hour, minute, second, number) in enumerate(counted(30)):
        if frame % 601 < 3 or second == 0:
            digits = int(f"{hour:02d}{minute:02d}{second:02d}{number:02d}", 16)
            assert Moment(frame, 29.97).time_code() == digits | 1 << 6
            assert Moment(2 * frame + 1, 59.94).time_code() == digits | 1 << 6 | 1 << 15


def test_openexr_itself_reads_rate_and_time_code(shape: RotoShape, tmp_path: Path) -> None:
    openexr = pytest.importorskip("OpenEXR", reason="OpenEXR's own library is not installed")
    told = openexr.File(str(written(shape, tmp_path, 3601, 59.94))).header()
    assert told["framesPerSecond"] == Fraction(60000, 1001)
    code = told["timeCode"]
    assert (code.hours, code.minutes, code.seconds, code.frame) == (0, 1, 0, 2)
    assert code.dropFrame
    assert code.fieldPhase


def test_a_rate_is_the_fraction_that_its_decimals_stand_for() -> None:
    assert [rational(fps) for fps in (24.0, 14.985, 12.5, 119.88)] == [
        Fraction(24),
        Fraction(15000, 1001),
        Fraction(25, 2),
        Fraction(120000, 1001),
    ]


def test_exported_mattes_have_the_clips_rate_aspect_and_the_offset_of_their_names(
    shape: RotoShape, tmp_path: Path
) -> None:
    clip = Clip(Path("plate"), 1001, 1002, SIZE[::-1], fps=25.0, pixel_aspect=1.5)
    options = ExportOptions(frame_offset=-1000, mattes=EXR)
    EXPORTERS["mattes"].export(Project(clip, Layer("root", "Root", (shape,))), tmp_path, options)
    attributes = header(tmp_path / "matte.0002.exr")
    assert time_code(attributes) == "00:00:00:02"
    assert rate(attributes) == (25, 1)
    assert oiio.ImageBuf(str(tmp_path / "matte.0002.exr")).spec().get_float_attribute("PixelAspectRatio") == 1.5
