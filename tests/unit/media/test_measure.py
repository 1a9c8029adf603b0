"""Pictures that claim more than can be worked with: refused by their header, before anything is decoded."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.errors import RoamError
from roam_core.matte.vectorise import read_mask
from roam_core.media import measure, movie, open_clip
from roam_core.media.measure import MAX_PIXELS, require_size
from tests.unit.media.conftest import picture, write_image, write_movie


def png(width: int, height: int) -> bytes:
    """A PNG of 16 bits whose header says this size, with the pixels of one line."""
    chunks = (
        (b"IHDR", struct.pack(">IIBBBBB", width, height, 16, 6, 0, 0, 0)),
        (b"IDAT", zlib.compress(bytes(1 + 8 * width))),
        (b"IEND", b""),
    )
    return b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(data)) + name + data + struct.pack(">I", zlib.crc32(name + data)) for name, data in chunks
    )


def jp2(width: int, height: int) -> bytes:
    """The first boxes of a JPEG 2000 file."""
    header = b"\0\0\0\x16ihdr" + struct.pack(">II", height, width) + b"\0\x03\x07\x07\0\0"
    return b"\0\0\0\x0cjP  \r\n\x87\n\0\0\0\x14ftypjp2 \0\0\0\0jp2 " + b"\0\0\0\x1ejp2h" + header


def codestream(width: int, height: int) -> bytes:
    """The first marker segments of a bare JPEG 2000 stream."""
    return b"\xff\x4f\xff\x51\0\x2f\0\0" + struct.pack(">IIII", width, height, 0, 0)


def gif(width: int, height: int) -> bytes:
    """The first bytes of a GIF."""
    return b"GIF89a" + struct.pack("<HH", width, height) + b"\0\0\0"


@pytest.mark.parametrize(
    ("name", "content"),
    [("a.png", png), ("a.jp2", jp2), ("a.j2k", codestream), ("a.gif", gif)],
)
def test_a_picture_that_claims_too_much_is_refused(tmp_path: Path, name: str, content: object) -> None:
    assert callable(content)
    (tmp_path / name).write_bytes(content(15000, 14000))
    for read in (open_clip, read_mask):
        # A PNG that is shorter than it can be is refused by OpenImageIO itself.
        words = "claims a 1602 MB" if name == "a.png" else "claims to be 15000 x 14000 pixels, more than the 50 million"
        with pytest.raises(RoamError, match=words if read is open_clip else "claims|cannot be read as a mask"):
            read(tmp_path / name)


def test_a_window_of_380_bytes_is_refused(tmp_path: Path) -> None:
    file = write_image(tmp_path / "a.exr", picture(1), "half", full_width=13000, full_height=13000)
    with pytest.raises(RoamError, match="claims to be 13000 x 13000 pixels"):
        open_clip(file)


def test_the_pixels_that_are_stored_count_as_well_as_their_window(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(measure, "MAX_PIXELS", 100)
    file = write_image(tmp_path / "a.exr", picture(1), "half", full_width=4, full_height=4)
    with pytest.raises(RoamError, match="claims to be 16 x 12 pixels"):
        open_clip(file)


def test_plates_of_todays_cameras_pass() -> None:
    for width, height in ((7680, 4320), (8192, 4320), (8192, 5464), (8640, 5760)):
        require_size(Path("a.exr"), width, height)
    with pytest.raises(RoamError, match="scale it down"):
        require_size(Path("a.exr"), MAX_PIXELS, 2)


def test_a_movie_is_measured_before_its_first_frame_is_decoded(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    path = write_movie(tmp_path / "a.avi", "MJPG", 2)
    monkeypatch.setattr(measure, "MAX_PIXELS", 64 * 48 - 1)
    monkeypatch.setattr(movie.Movie, "_first_size", lambda _: pytest.fail("a frame was decoded"))
    with pytest.raises(RoamError, match="claims to be 64 x 48 pixels"):
        open_clip(path)


def test_a_mask_of_many_channels_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    file = write_image(tmp_path / "a.exr", picture(1, 40), "float")
    assert oiio.ImageInput.open(str(file)).spec().image_bytes() > 20_000
    monkeypatch.setattr("roam_core.media.image_file.MOST_BYTES", 20_000)
    with pytest.raises(RoamError, match="give a mask of one channel"):
        read_mask(file)
