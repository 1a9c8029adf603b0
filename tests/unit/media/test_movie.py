"""Movies: every frame the same picture however it is reached, and containers that lie."""

from __future__ import annotations

import pickle
import random
import struct
import threading
from collections.abc import Callable
from copy import copy, deepcopy
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.arrays import Image, UInt8
from roam_core.errors import RoamError
from roam_core.media import MissingFrame, PlateSource, decoding, open_clip
from roam_core.media.decoding.isolated_movie import IsolatedMovie
from roam_core.media.decoding.pool import Pool
from roam_core.media.movie import LONGEST_STEP
from roam_core.media.movie_plate import shortfall
from roam_core.media.source import USUAL_SPEED, likely_speed
from tests.unit.media.conftest import movie_pictures, write_movie

COUNT = 40
CODECS = [("avi", "MJPG"), ("mp4", "mp4v"), ("avi", "XVID"), ("mkv", "FFV1"), ("webm", "VP80")]


def decoded_in_order(path: Path) -> list[Image]:
    """The RGB pictures of a movie, read straight through."""
    movie = RealCapture(str(path), cv2.CAP_FFMPEG)
    pictures = []
    while movie.grab():
        pictures.append(movie.retrieve()[1][..., ::-1])
    return pictures


@pytest.mark.parametrize(("extension", "codec"), CODECS)
def test_any_order_gives_the_pictures_of_decoding_in_order(tmp_path: Path, extension: str, codec: str) -> None:
    path = write_movie(tmp_path / f"shot.{extension}", codec, COUNT)
    expected = decoded_in_order(path)
    plate = open_clip(path)
    assert plate.frames == tuple(range(1, COUNT + 1))
    assert plate.missing == ()
    assert (plate.path, plate.size, plate.pixel_aspect, plate.colour_space) == (path, (64, 48), 1.0, "sRGB")
    assert plate.fps == pytest.approx(24.0)
    shuffled = list(plate.frames)
    random.Random(7).shuffle(shuffled)
    for frame in [*plate.frames, *reversed(plate.frames), *shuffled, 1, COUNT, 1, COUNT - 1]:
        np.testing.assert_array_equal(plate.read(frame), expected[frame - 1], err_msg=f"frame {frame}")


@pytest.mark.parametrize("fps", [0.01, 0.5, 1000.0])
def test_slow_and_fast_movies_keep_their_speed(tmp_path: Path, fps: float) -> None:
    assert open_clip(write_movie(tmp_path / "lapse.mp4", "mp4v", 3, fps)).fps == pytest.approx(fps)


@pytest.mark.parametrize("told", [0.0, -24.0, 0.009, 1000.5, float("nan"), float("inf")])
def test_what_is_no_speed_is_taken_for_the_usual_one(told: float) -> None:
    assert likely_speed(told) == USUAL_SPEED


def test_the_first_picture_read_may_be_any(tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.mp4", "mp4v", COUNT)
    expected = decoded_in_order(path)
    for frame in (COUNT, 33, 2):
        np.testing.assert_array_equal(open_clip(path).read(frame), expected[frame - 1])


def test_pictures_are_rgb_of_8_bits(tmp_path: Path) -> None:
    image = open_clip(write_movie(tmp_path / "shot.mkv", "FFV1", 3)).read(2)
    assert image.dtype == np.uint8
    assert np.abs(image.astype(int) - movie_pictures(3)[1][..., ::-1]).max() <= 3


def test_frames_outside_the_movie_are_missing(tmp_path: Path) -> None:
    plate = open_clip(write_movie(tmp_path / "shot.avi", "MJPG", 5))
    for frame in (-1, 0, 6):
        with pytest.raises(MissingFrame, match=f"Frame {frame} of .* has the frames 1 to 5"):
            plate.read(frame)


def test_frames_are_named_by_padded_numbers(tmp_path: Path) -> None:
    plate = open_clip(write_movie(tmp_path / "shot.avi", "MJPG", 5))
    assert [plate.frame_name(frame) for frame in (1, 5)] == ["00001", "00005"]


def write_gif(path: Path, rates: list[int]) -> Path:
    """An animated GIF, each frame of which is shown for as long as its rate says; a band moves down."""
    specs = []
    for rate in rates:
        spec = oiio.ImageSpec(32, 24, 3, "uint8")
        spec.attribute("FramesPerSecond", oiio.TypeRational, (rate, 1))
        specs.append(spec)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), specs), output.geterror()
    for index, spec in enumerate(specs):
        assert index == 0 or output.open(str(path), spec, "AppendSubimage"), output.geterror()
        assert output.write_image(gif_picture(index))
    output.close()
    return path


def gif_picture(index: int) -> UInt8:
    picture = np.zeros((24, 32, 3), np.uint8)
    picture[3 * index : 3 * index + 6] = (255, 0, 0)
    return picture


def test_an_animated_gif_is_a_movie_each_picture_of_which_is_a_frame(tmp_path: Path) -> None:
    plate = open_clip(write_gif(tmp_path / "walk.0001.gif", [10, 2, 10, 5, 10]))
    assert (plate.frames, plate.size) == ((1, 2, 3, 4, 5), (32, 24))
    for frame in (1, 2, 3, 4, 5, 2, 5, 1):
        np.testing.assert_allclose(plate.read(frame), gif_picture(frame - 1), atol=8)


def test_a_gif_of_one_picture_is_an_image(tmp_path: Path) -> None:
    for frame in (1, 2):
        write_gif(tmp_path / f"p.{frame}.gif", [10])
    plate = open_clip(tmp_path / "p.1.gif")
    assert plate.frames == (1, 2)
    assert plate.frame_name(2) == "p.2"


RealCapture = cv2.VideoCapture


class UnreliableCapture:
    """A capture that answers wrongly, as some containers do: of its length, its clock, or where a seek led."""

    opened = sought = 0
    claimed: float | None = None
    stamp_scale, stamp_power = 1.0, 1.0
    seek_error = 0
    damaged = False

    def __init__(self, *arguments: Any) -> None:
        type(self).opened += 1
        self._capture = RealCapture(*arguments)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._capture, name)

    def get(self, key: int) -> float:
        if key == cv2.CAP_PROP_FRAME_COUNT and self.claimed is not None:
            return self.claimed
        value = self._capture.get(key)
        return float(value**self.stamp_power) * self.stamp_scale if key == cv2.CAP_PROP_POS_MSEC else value

    def set(self, key: int, value: float) -> bool:
        type(self).sought += 1
        return bool(self._capture.set(key, max(value + self.seek_error, 0)))

    def retrieve(self) -> Any:
        return (False, None) if self.damaged else self._capture.retrieve()


@pytest.fixture
def capture(monkeypatch: pytest.MonkeyPatch) -> type[UnreliableCapture]:
    """The class that movies decode with; a test sets what it gets wrong."""

    class Capture(UnreliableCapture):
        pass

    monkeypatch.setattr(cv2, "VideoCapture", Capture)
    return Capture


@pytest.mark.parametrize(
    "lies",
    [
        *({"claimed": claimed} for claimed in (0.0, 1.0, 39.0, 41.0, 1000.0, -3.0, float("nan"), float("inf"))),
        *({"stamp_scale": scale, "seek_error": error} for scale in (0.0, 0.5, 1.0) for error in (-3, 0, 1)),
        *({"stamp_power": power, "seek_error": error} for power in (0.5, 1.2) for error in (-3, 0, 1)),
    ],
    ids=str,
)
def test_a_container_that_lies_changes_no_frame(
    tmp_path: Path, capture: type[UnreliableCapture], lies: dict[str, float]
) -> None:
    path = write_movie(tmp_path / "shot.mp4", "mp4v", COUNT)
    expected = decoded_in_order(path)
    for name, value in lies.items():
        setattr(capture, name, value)
    plate = open_clip(path)
    assert plate.frames == tuple(range(1, COUNT + 1))
    for frame in (COUNT, 3, 30, 29, 1, 38, 2):
        np.testing.assert_array_equal(plate.read(frame), expected[frame - 1], err_msg=f"frame {frame}")


def test_the_pixels_of_a_turned_movie_are_turned_too(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capture: type[UnreliableCapture]
) -> None:
    told, get = {cv2.CAP_PROP_SAR_NUM: 4.0, cv2.CAP_PROP_SAR_DEN: 3.0}, capture.get
    monkeypatch.setattr(capture, "get", lambda self, key: told[key] if key in told else get(self, key))
    path = write_movie(tmp_path / "shot.mp4", "mp4v", 3)
    upright = open_clip(path)
    turn(path)
    turned = open_clip(path)
    assert (upright.size, turned.size) == ((64, 48), (48, 64))
    assert (upright.pixel_aspect, turned.pixel_aspect) == pytest.approx((4.0 / 3.0, 3.0 / 4.0))


def turn(path: Path) -> None:
    """Have an MP4 say that its pictures are shown a quarter turned: the matrix of its track's header."""
    content = path.read_bytes()
    whole, one, unit = 1 << 16, -(1 << 16), 1 << 30
    upright, quarter = (whole, 0, 0, 0, whole, 0, 0, 0, unit), (0, whole, 0, one, 0, 0, 0, 0, unit)
    start = content.index(struct.pack(">9i", *upright), content.index(b"tkhd"))
    path.write_bytes(content[:start] + struct.pack(">9i", *quarter) + content[start + 36 :])


def test_a_reliable_movie_is_sought_in_and_not_decoded_again(tmp_path: Path, capture: type[UnreliableCapture]) -> None:
    plate = open_clip(write_movie(tmp_path / "shot.mp4", "mp4v", 3 * LONGEST_STEP))
    opened = capture.opened
    for frame in (3 * LONGEST_STEP, 1, 2 * LONGEST_STEP, 3, 2, 1):
        plate.read(frame)
    assert capture.opened == opened


def test_reading_in_order_does_not_seek(tmp_path: Path, capture: type[UnreliableCapture]) -> None:
    plate = open_clip(write_movie(tmp_path / "shot.mp4", "mp4v", COUNT))
    sought = capture.sought
    for frame in plate.frames:
        plate.read(frame)
    assert capture.sought == sought


def test_a_frame_that_cannot_be_decoded_is_named(tmp_path: Path, capture: type[UnreliableCapture]) -> None:
    plate = open_clip(write_movie(tmp_path / "shot.avi", "MJPG", 5))
    capture.damaged = True
    with pytest.raises(RoamError, match=r"Frame 3 of .*shot\.avi cannot be decoded"):
        plate.read(3)
    capture.damaged = False
    assert plate.read(3).shape == (48, 64, 3)


def test_many_threads_read_one_movie(tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.mp4", "mp4v", COUNT)
    expected = decoded_in_order(path)
    plate = open_clip(path)
    wrong: list[int] = []

    def read(seed: int) -> None:
        for frame in random.Random(seed).sample(plate.frames, 15):
            if not np.array_equal(plate.read(frame), expected[frame - 1]):
                wrong.append(frame)

    threads = [threading.Thread(target=read, args=(seed,)) for seed in range(4)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert wrong == []


@pytest.mark.parametrize("content", [b"", b"no movie, only words " * 200])
def test_text_in_a_movies_name_is_told(tmp_path: Path, content: bytes) -> None:
    path = tmp_path / "shot.mov"
    path.write_bytes(content)
    with pytest.raises(RoamError, match=r"shot\.mov is no movie that can be decoded"):
        open_clip(path)


def test_a_movie_cut_short_gives_the_frames_that_are_whole(tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.avi", "MJPG", COUNT)
    expected = decoded_in_order(path)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    plate = open_clip(path)
    assert 1 < len(plate.frames) < COUNT
    for frame in (plate.frames[-2], 2, 1):
        np.testing.assert_array_equal(plate.read(frame), expected[frame - 1])


@pytest.mark.parametrize("isolated", [False, True])
def test_a_movie_shorter_than_its_header_says_is_told(
    tmp_path: Path, isolated: bool, request: pytest.FixtureRequest
) -> None:
    if isolated:
        request.addfinalizer(decoding.trust)
        decoding.isolate()
    path = write_movie(tmp_path / "shot.avi", "MJPG", COUNT)
    assert shortfall(open_clip(path)) == ""
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    plate = open_clip(path)
    assert len(plate.frames) < COUNT
    assert shortfall(plate) == (
        f"shot.avi has {len(plate.frames)} frames that can be read, its header says {COUNT}: it may be cut short."
    )


def test_of_a_movie_that_was_trimmed_nothing_is_missed(tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.mp4", "mp4v", COUNT)
    expected = decoded_in_order(path)
    trim(path, 13)
    plate = open_clip(path)
    assert plate.frames == tuple(range(1, COUNT - 12))
    assert shortfall(plate) == ""
    for frame in (COUNT - 13, 1, 20, 2):
        np.testing.assert_array_equal(plate.read(frame), expected[frame + 12])


def trim(path: Path, frames: int) -> None:
    """Have an MP4's edit list leave out the first frames, as a trim without encoding anew does."""
    content = bytearray(path.read_bytes())
    place = content.index(b"elst") + 12
    length, start = struct.unpack_from(">Ii", content, place)
    (ticks,) = struct.unpack_from(">I", content, content.index(b"mdhd") + 16)
    struct.pack_into(">Ii", content, place, length * (COUNT - frames) // COUNT, start + frames * ticks // 24)
    path.write_bytes(content)


def test_a_movie_without_its_index_is_told(tmp_path: Path) -> None:
    path = write_movie(tmp_path / "shot.mp4", "mp4v", COUNT)
    path.write_bytes(path.read_bytes()[: path.stat().st_size // 2])
    with pytest.raises(RoamError, match=r"shot\.mp4 is no movie that can be decoded"):
        open_clip(path)


@pytest.mark.parametrize("copied", [copy, deepcopy, lambda plate: pickle.loads(pickle.dumps(plate))])  # noqa: S301
def test_a_copy_of_a_movie_is_opened_anew(tmp_path: Path, copied: Callable[[PlateSource], PlateSource]) -> None:
    plate = open_clip(write_movie(tmp_path / "a.avi", "MJPG", 4))
    other = copied(plate)
    assert (other.frames, other.size, other.fps) == (plate.frames, plate.size, plate.fps)
    for frame in (4, 1):
        np.testing.assert_array_equal(other.read(frame), plate.read(frame))


def test_a_movie_that_another_process_decodes_is_copied_but_not_pickled(tmp_path: Path, processes: Pool) -> None:
    plate = IsolatedMovie(write_movie(tmp_path / "a.avi", "MJPG", 4), processes)
    for other in (copy(plate), deepcopy(plate)):
        np.testing.assert_array_equal(other.read(3), plate.read(3))
    with pytest.raises(TypeError, match=r"a\.avi is decoded by a process of this one, .* open it there with open_clip"):
        pickle.dumps(plate)
