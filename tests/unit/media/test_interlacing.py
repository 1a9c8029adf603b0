"""Interlaced movies are refused in words, measured or marked; what only looks a little like it is opened."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.arrays import UInt8
from roam_core.errors import RoamError
from roam_core.media import open_clip
from roam_core.media.interlacing import PROBED, is_combed, require_progressive, thinned

WIDTH, HEIGHT, COUNT = 96, 64, 12
TEXTURE = cv2.resize(np.random.default_rng(0).integers(30, 120, (8, 12, 3), dtype=np.uint8), (WIDTH, HEIGHT))


def moment(time: float) -> UInt8:
    """A bright box that glides over a texture."""
    picture = TEXTURE.copy()
    left = int(4 + 4 * time)
    picture[12:52, left : left + 24] = (230, 190, 60)
    return picture


def progressive(frame: int) -> UInt8:
    return moment(frame)


def interlaced(frame: int) -> UInt8:
    """Rows of two moments, half a frame apart."""
    picture = moment(frame).copy()
    picture[1::2] = moment(frame + 0.5)[1::2]
    return picture


def striped(frame: int) -> UInt8:
    """Blinds of two rows each behind a box that glides over them."""
    picture = moment(frame).copy()
    still = picture.copy()
    still[(np.arange(HEIGHT) // 2) % 2 == 0] //= 3
    picture[12:52, :] = np.where((picture == TEXTURE).all(-1)[..., None], still, picture)[12:52, :]
    return picture


def still(frame: int) -> UInt8:
    """The same picture at every time, combed as a frame of two moments is."""
    return interlaced(3)


def write(path: Path, codec: str, drawn: Callable[[int], UInt8]) -> Path:
    """A movie of 12 frames, or a skipped test where OpenCV's FFmpeg lacks the codec."""
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*codec), 25.0, (WIDTH, HEIGHT))
    if not writer.isOpened():
        pytest.skip(f"this OpenCV cannot write {codec}")
    for frame in range(COUNT):
        writer.write(drawn(frame))
    writer.release()
    return path


def mark_interlaced(path: Path) -> None:
    """Mark every frame of an MPEG-2 stream as interlaced, by H.262: `progressive_sequence` and `progressive_frame`."""
    content = bytearray(path.read_bytes())
    at = content.find(b"\0\0\1\xb5")
    while at >= 0:
        kind = content[at + 4] >> 4
        if kind == 1:
            content[at + 5] &= 0xF7
        elif kind == 8:
            content[at + 8] &= 0x7F
        at = content.find(b"\0\0\1\xb5", at + 4)
    path.write_bytes(content)


def grainy(frame: int) -> UInt8:
    """Noise that is another one in every picture."""
    return np.random.default_rng(frame).integers(0, 255, (HEIGHT, WIDTH, 3), dtype=np.uint8)


def dithered(frame: int) -> UInt8:
    """Four levels of each colour and an ordered pattern of them for those between, as in a GIF."""
    pattern = np.array([[0, 8, 2, 10], [12, 4, 14, 6], [3, 11, 1, 9], [15, 7, 13, 5]]) / 16
    levels = progressive(frame) / 255 * 3 + np.tile(pattern, (HEIGHT // 4, WIDTH // 4))[..., None]
    return np.asarray(np.floor(levels).clip(0, 3) * 85, np.uint8)


@pytest.mark.parametrize("drawn", [progressive, striped, still, grainy, dithered])
def test_pictures_of_one_moment_are_not_combed(drawn: Callable[[int], UInt8]) -> None:
    assert not is_combed([drawn(frame) for frame in range(COUNT)])


@pytest.mark.parametrize("first", [0, 1])
def test_pictures_of_two_moments_are_combed(first: int) -> None:
    assert is_combed([interlaced(frame)[first:] for frame in range(COUNT)])


def test_wide_pictures_of_two_moments_are_combed() -> None:
    """They are looked at in pieces of columns that lie side by side."""
    wide = [thinned(np.repeat(interlaced(frame), 20, 1)) for frame in range(COUNT)]
    assert wide[0].shape == (HEIGHT, 18 * 16, 3)
    assert is_combed(wide)


def test_nothing_is_combed_that_is_no_picture_yet() -> None:
    assert not is_combed([])
    assert not is_combed([progressive(0)])
    assert not is_combed([np.full((3, 4, 3), value, np.uint8) for value in (0, 200)])


@pytest.mark.parametrize("size", [(2, 2), (14, 40), (40, 2)])
def test_a_movie_too_small_to_be_looked_at_is_opened(tmp_path: Path, size: tuple[int, int]) -> None:
    path = tmp_path / "small.avi"
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*"MJPG"), 25.0, size)
    if not writer.isOpened():
        pytest.skip("this OpenCV cannot write MJPG")
    for frame in range(3):
        writer.write(np.full((size[1], size[0], 3), 60 * frame, np.uint8))
    writer.release()
    assert open_clip(path).size == size


def test_a_combed_movie_is_refused_though_nothing_marks_it(tmp_path: Path) -> None:
    path = write(tmp_path / "shot.mkv", "FFV1", interlaced)
    with pytest.raises(RoamError, match=r"shot\.mkv is interlaced: .* Deinterlace it in another program"):
        open_clip(path)


def test_a_gif_is_never_interlaced() -> None:
    pictures = [interlaced(frame) for frame in range(PROBED)]
    require_progressive(Path("shot.GIF"), pictures)
    with pytest.raises(RoamError, match="is interlaced"):
        require_progressive(Path("shot.mkv"), pictures)


@pytest.mark.parametrize("drawn", [progressive, striped, still, dithered])
def test_a_movie_of_one_moment_a_frame_is_opened(tmp_path: Path, drawn: Callable[[int], UInt8]) -> None:
    plate = open_clip(write(tmp_path / "shot.mkv", "FFV1", drawn))
    assert len(plate.frames) == COUNT
    assert np.abs(plate.read(5)[..., ::-1].astype(int) - drawn(4)).mean() < 3.0


def test_a_marked_movie_is_refused_in_place_of_memory_without_a_picture(tmp_path: Path) -> None:
    path = write(tmp_path / "shot.mpg", "mpg2", progressive)
    assert len(open_clip(path).frames) == COUNT
    mark_interlaced(path)
    with pytest.raises(RoamError, match=r"shot\.mpg is interlaced"):
        open_clip(path)


def test_a_still_movie_is_no_broken_one(tmp_path: Path) -> None:
    for name, codec in (("still.mpg", "mpg2"), ("still.mkv", "FFV1"), ("still.avi", "MJPG")):
        assert len(open_clip(write(tmp_path / name, codec, still)).frames) == COUNT
