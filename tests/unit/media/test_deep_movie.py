"""Movies of more than 8 bits, by PyAV where that is installed: all bits, by any way to a frame, evenly timed or not."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.media import deep_movie, open_clip
from roam_core.media.movie_plate import shortfall
from tests.unit.media.conftest import write_movie

HEIGHT, WIDTH, COUNT = 48, 64, 30
EVEN = [round(1000 * k / 24) for k in range(COUNT)]
UNEVEN = [40 * k + 17 * (k % 3) for k in range(COUNT)]
"""Milliseconds."""


@pytest.fixture(scope="module")
def av() -> Any:
    return pytest.importorskip("av", reason="PyAV is not installed; ROAM never installs it, an artist may")


def codes(index: int) -> np.ndarray:
    """A picture of 10-bit codes `(h, w, 3)`, another one for each frame."""
    picture = np.empty((HEIGHT, WIDTH, 3), np.uint16)
    picture[..., 0] = np.arange(WIDTH) * 1023 // (WIDTH - 1)
    picture[..., 1] = (np.arange(HEIGHT) * 19 + index * 3)[:, None]
    picture[..., 2] = 1023 - index * 30
    return picture


def write_deep(
    av: Any, path: Path, times: list[int] = EVEN, kind: str = "gbrp10le", codec: str = "ffv1", **options: str
) -> Path:
    """A movie of 10 bits, lossless as RGB, whose frames are shown at these milliseconds."""
    container = av.open(str(path), "w")
    stream = container.add_stream(codec, rate=24, options=options)
    stream.width, stream.height, stream.pix_fmt = WIDTH, HEIGHT, kind
    stream.codec_context.time_base = Fraction(1, 1000)
    for index, time in enumerate(times):
        scaled = np.round(codes(index) * (65535.0 / 1023.0)).astype(np.uint16)
        frame = av.VideoFrame.from_ndarray(scaled, format="rgb48le").reformat(format=kind)
        frame.pts, frame.time_base = time, Fraction(1, 1000)
        container.mux(stream.encode(frame))
    container.mux(stream.encode())
    container.close()
    return path


@pytest.mark.parametrize("times", [EVEN, UNEVEN], ids=["evenly timed", "unevenly timed"])
def test_all_ten_bits_of_every_frame_in_any_order(av: Any, tmp_path: Path, times: list[int]) -> None:
    plate = open_clip(write_deep(av, tmp_path / "m.mkv", times))
    assert (plate.depth, plate.size, plate.frames) == ("10 bits", (WIDTH, HEIGHT), tuple(range(1, COUNT + 1)))
    shuffled = list(plate.frames)
    random.Random(3).shuffle(shuffled)
    for frame in [COUNT, *plate.frames, *reversed(plate.frames), *shuffled]:
        picture = plate.read(frame)
        assert picture.dtype == np.uint16
        np.testing.assert_array_equal(np.round(picture * (1023.0 / 65535.0)), codes(frame - 1))


def test_unevenly_timed_frames_of_eight_bits_are_frames_too(av: Any, tmp_path: Path) -> None:
    plate = open_clip(write_deep(av, tmp_path / "m.mkv", UNEVEN, kind="bgr0"))
    assert (plate.depth, plate.frames) == ("8 bits", tuple(range(1, COUNT + 1)))
    for frame in (COUNT, 2, 17, 1, 16, 29):
        np.testing.assert_allclose(plate.read(frame) * (1023.0 / 255.0), codes(frame - 1), atol=8.0)


def test_frames_that_are_predicted_from_others(av: Any, tmp_path: Path) -> None:
    path = write_deep(av, tmp_path / "m.mov", kind="yuv422p10le", codec="prores_ks")
    plate = open_clip(path)
    in_order = {frame: plate.read(frame) for frame in plate.frames}
    assert len(in_order) == COUNT
    for frame in (29, 3, 17, 30, 1):
        np.testing.assert_array_equal(open_clip(path).read(frame), in_order[frame])
    assert np.abs(in_order[5] * (1023.0 / 65535.0) - codes(4)).mean() < 8.0


def test_other_processes_give_the_same(av: Any, tmp_path: Path, apart: Callable[[], None]) -> None:
    path = write_deep(av, tmp_path / "m.mkv", UNEVEN)
    here = open_clip(path)
    apart()
    there = open_clip(path)
    assert (there.depth, there.frames, there.fps) == (here.depth, here.frames, here.fps)
    np.testing.assert_array_equal(there.read(7), here.read(7))


def test_a_movie_that_is_marked_as_interlaced_is_refused(av: Any, tmp_path: Path) -> None:
    path = write_deep(av, tmp_path / "m.mov", kind="yuv422p10le", codec="prores_ks", flags="+ildct")
    with pytest.raises(RoamError, match=r"m\.mov is interlaced"):
        open_clip(path)


def test_what_is_cut_short_has_the_frames_that_are_whole(av: Any, tmp_path: Path) -> None:
    path = write_deep(av, tmp_path / "m.mkv")
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    plate = open_clip(path)
    assert 5 < len(plate.frames) < COUNT
    np.testing.assert_array_equal(np.round(plate.read(3) * (1023.0 / 65535.0)), codes(2))
    path.write_bytes(path.read_bytes()[:300])
    with pytest.raises(RoamError, match=r"m\.mkv"):
        open_clip(path)


def test_a_movie_trimmed_without_encoding_begins_where_it_is_shown(av: Any, tmp_path: Path) -> None:
    whole = open_clip(write_deep(av, tmp_path / "m.mov", kind="yuv422p10le", codec="prores_ks"))
    plate = open_clip(trimmed(av, tmp_path / "m.mov", tmp_path / "trimmed.mov", 7))
    assert plate.frames == tuple(range(1, COUNT - 6))
    assert shortfall(plate) == ""
    for frame in (COUNT - 7, 1, 12, 2):
        np.testing.assert_array_equal(plate.read(frame), whole.read(frame + 7))


def trimmed(av: Any, path: Path, target: Path, frames: int) -> Path:
    """A movie whose first frames are in the file and not shown: before time 0, where the edit list begins."""
    with av.open(str(path)) as source, av.open(str(target), "w") as container:
        stream = source.streams.video[0]
        kept = container.add_stream_from_template(stream)
        packets = [packet for packet in source.demux(stream) if packet.pts is not None]
        start = packets[frames].pts
        for packet in packets:
            packet.pts, packet.dts, packet.stream = packet.pts - start, packet.dts - start, kept
            container.mux(packet)
    return target


def test_eight_bits_are_read_as_before(av: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write_movie(tmp_path / "m.mp4", "mp4v", 6)
    with_it = open_clip(path)
    monkeypatch.setattr(deep_movie, "LIBRARY", "no_such_library")
    without = open_clip(path)
    assert type(with_it) is type(without)
    np.testing.assert_array_equal(with_it.read(4), without.read(4))


def test_without_the_library_ten_bits_are_read_as_eight(
    av: Any, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    path = write_deep(av, tmp_path / "m.mkv")
    monkeypatch.setattr(deep_movie, "LIBRARY", "no_such_library")
    plate = open_clip(path)
    assert (plate.depth, plate.read(2).dtype) == ("8 bits", np.uint8)
