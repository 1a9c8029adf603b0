"""Tiny plates on disk: images written with OpenImageIO, movies written with OpenCV."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Sequence
from pathlib import Path
from typing import Any

import cv2
import numpy as np
import OpenImageIO as oiio  # noqa: N813 - the name its own manual uses
import pytest
from numpy.typing import NDArray

from roam_core.arrays import Float32, UInt8
from roam_core.media import decoding
from roam_core.media.decoding.pool import Pool
from roam_core.media.numbering import folded

WIDTH, HEIGHT = 16, 12
OF_SPEC = {"x", "y", "full_x", "full_y", "full_width", "full_height"}
OF_SPEC |= {"channelnames", "channelformats", "tile_width", "tile_height"}
"""What of a file's fields are the spec's own."""


def picture(seed: int, channels: int = 3) -> Float32:
    """A picture in [0, 1] that differs in every pixel."""
    return np.random.default_rng(seed).random((HEIGHT, WIDTH, channels), dtype=np.float32)


def write_image(path: Path, pixels: NDArray[Any], pixel_format: str, **fields: Any) -> Path:
    """Write `pixels`; `fields` are the spec's own (`x`, `full_width`, ...) or metadata (`a__b` for `a:b`)."""
    path.parent.mkdir(parents=True, exist_ok=True)
    spec = oiio.ImageSpec(pixels.shape[1], pixels.shape[0], pixels.shape[2], pixel_format)
    for name, value in fields.items():
        if name in OF_SPEC:
            setattr(spec, name, value)
        else:
            spec.attribute(name.replace("__", ":"), value)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), spec), output.geterror()
    assert output.write_image(np.ascontiguousarray(pixels)), output.geterror()
    output.close()
    return path


def write_parts(path: Path, parts: list[tuple[str, str, tuple[str, ...]]], **fields: Any) -> Path:
    """An EXR of several parts (name, view, channels); channel c of part p holds p + c / 8."""
    specs = []
    for name, view, channels in parts:
        spec = oiio.ImageSpec(WIDTH, HEIGHT, len(channels), "half")
        spec.channelnames = channels
        spec.attribute("oiio:subimagename", name)
        if view:
            spec.attribute("view", view)
        for field, value in fields.items():
            setattr(spec, field, value)
        specs.append(spec)
    path.parent.mkdir(parents=True, exist_ok=True)
    output = oiio.ImageOutput.create(str(path))
    assert output.open(str(path), specs), output.geterror()
    for index, spec in enumerate(specs):
        assert index == 0 or output.open(str(path), spec, "AppendSubimage"), output.geterror()
        values = index + np.arange(spec.nchannels, dtype=np.float32) / 8.0
        assert output.write_image(np.tile(values, (HEIGHT, WIDTH, 1))), output.geterror()
    output.close()
    return path


def write_bytes_png(path: Path, seed: int = 0, size: tuple[int, int] = (WIDTH, HEIGHT)) -> Path:
    """An 8-bit PNG all of whose pixels are `seed`."""
    return write_image(path, np.full((size[1], size[0], 3), seed, np.uint8), "uint8")


WriteFrames = Callable[..., Path]


@pytest.fixture
def write_frames(tmp_path: Path) -> WriteFrames:
    """Write one small PNG for each name; the pixels of the n-th all have the value n."""

    def write(names: Sequence[str], folder: str = "plate") -> Path:
        for index, name in enumerate(names):
            write_bytes_png(tmp_path / folder / name, index)
        return tmp_path / folder

    return write


def movie_pictures(count: int) -> list[UInt8]:
    """BGR pictures with a moving block: inter-frame codecs have to predict."""
    pictures = []
    for index in range(count):
        image = np.full((48, 64, 3), (index * 6) % 200, np.uint8)
        image[10:26, index % 40 : index % 40 + 16] = (250, 20, 120)
        pictures.append(image)
    return pictures


def write_movie(path: Path, codec: str, count: int, fps: float = 24.0) -> Path:
    """Write a movie, or skip the test where OpenCV's FFmpeg lacks the codec."""
    writer = cv2.VideoWriter(str(path), cv2.CAP_FFMPEG, cv2.VideoWriter.fourcc(*codec), fps, (64, 48))
    if not writer.isOpened():
        pytest.skip(f"this OpenCV cannot write {codec}")
    for image in movie_pictures(count):
        writer.write(image)
    writer.release()
    return path


@pytest.fixture(scope="session")
def processes() -> Iterator[Pool]:
    """Processes that decode, for all tests that want some."""
    pool = Pool()
    yield pool
    pool.close()


@pytest.fixture
def apart(processes: Pool, monkeypatch: pytest.MonkeyPatch) -> Callable[[], None]:
    """From its call on, this test decodes in other processes."""
    return lambda: monkeypatch.setattr(decoding, "_pool", processes)


@pytest.fixture
def folding_disk(monkeypatch: pytest.MonkeyPatch) -> None:
    """A disk as those of Windows and macOS: a name in other case, or with its accents written otherwise, is found."""
    stat = os.stat

    def found(path: Any, **options: Any) -> os.stat_result:
        try:
            return stat(path, **options)
        except FileNotFoundError:
            place = Path(os.fsdecode(path))
            for entry in place.parent.iterdir():
                if folded(entry.name) == folded(place.name):
                    return stat(entry, **options)
            raise

    monkeypatch.setattr(os, "stat", found)
