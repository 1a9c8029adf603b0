"""Decoding what is not trusted: the one door to the libraries that read pictures and movies.

`isolate` has them run in processes of their own, as `roam` does: one that crashes, hangs or asks for too much memory
is ended, and the file that it read is told as damaged. Those who embed the library decode in their own process unless
they ask for the same: their program may be none that can be started again as `python -m`. Both ways run the same
code and give the same values.
"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING

from roam_core.arrays import Image
from roam_core.media.area import Area
from roam_core.media.decoding.pool import Pool
from roam_core.media.source import ImageHeader

if TYPE_CHECKING:
    from roam_core.media.movie_plate import MoviePlate

_pool: Pool | None = None


def isolate() -> None:
    """From now on, decode in processes of their own: see `roam_core.media.decoding.pool`."""
    global _pool
    _pool = _pool or Pool()


def prepare() -> None:
    """Start a process now, so that the first picture does not wait for it; does not wait itself."""
    if _pool is not None:
        _pool.prepare()


def trust() -> None:
    """From now on, decode in this process again; the others end."""
    global _pool
    if _pool is not None:
        _pool.close()
    _pool = None


def is_isolated() -> bool:
    """Whether other processes decode."""
    return _pool is not None


def image_extensions() -> frozenset[str]:
    """The extensions of the images that can be read (`roam_core.media.image_file.image_extensions`)."""
    from roam_core.media.image_file import image_extensions

    return image_extensions()


def read_header(file: Path, layer: str = "") -> ImageHeader:
    """What an image says of one of its layers (`roam_core.media.image_file.read_header`)."""
    if _pool is None:
        from roam_core.media.image_file import read_header

        return read_header(file, layer)
    told = _pool.ask(file, "header", {"layer": layer})
    return ImageHeader(
        told.size(),
        told.number("fps"),
        told.number("pixel_aspect"),
        told.text("colour_space"),
        told.text("depth"),
        told.text("layer"),
        told.texts("layers"),
    )


def read_image(file: Path, layer: str = "", area: Area | None = None) -> Image:
    """The pixels of an image, or an area of them (`roam_core.media.image_file.read_image`)."""
    if _pool is None:
        from roam_core.media.image_file import read_image

        return read_image(file, layer, area)
    return _pool.ask(file, "image", {"layer": layer, "area": area}).picture


def size_in_areas(file: Path, layer: str = "") -> tuple[int, int] | None:
    """The size of an image of which areas can be read (`roam_core.media.image_file.size_in_areas`)."""
    if _pool is None:
        from roam_core.media.image_file import size_in_areas

        return size_in_areas(file, layer)
    told = _pool.ask(file, "size in areas", {"layer": layer})
    return None if told.fields.get("size") is None else told.size()


def read_channels(file: Path) -> Image | None:
    """All channels of an image as they are stored (`roam_core.media.image_file.read_channels`)."""
    if _pool is None:
        from roam_core.media.image_file import read_channels

        return read_channels(file)
    return _pool.ask(file, "channels", {}).pixels


def has_several_images(file: Path) -> bool:
    """Whether a file holds more than one picture (`roam_core.media.image_file.has_several_images`)."""
    if _pool is None:
        from roam_core.media.image_file import has_several_images

        return has_several_images(file)
    return bool(_pool.ask(file, "several images", {}).fields.get("several"))


def software_of(file: Path) -> str:
    """What an image says it was written by (`roam_core.media.image_file.software_of`)."""
    if _pool is None:
        from roam_core.media.image_file import software_of

        return software_of(file)
    return _pool.ask(file, "software", {}).text("software")


def open_movie(path: Path) -> MoviePlate:
    """A movie as a plate. Where other processes decode it has one for itself."""
    if _pool is None:
        from roam_core.media.deep_movie import opened_movie

        return opened_movie(path)
    from roam_core.media.decoding.isolated_movie import IsolatedMovie

    return IsolatedMovie(path, _pool)
