"""`open_clip`: finds out what a path holds, and opens it as the right kind of plate."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.numbering import FileSequence, file_names, find_pattern, find_sequences, parse_pattern
from roam_core.media.source import PlateSource

if TYPE_CHECKING:
    from roam_core.media.movie_plate import MoviePlate
    from roam_core.media.sequence import ImageSequence

MOVIE_EXTENSIONS = frozenset(
    [
        ".3gp",
        ".avi",
        ".flv",
        ".m2ts",
        ".m4v",
        ".mkv",
        ".mov",
        ".mp4",
        ".mpeg",
        ".mpg",
        ".mts",
        ".mxf",
        ".ogv",
        ".qt",
        ".ts",
        ".webm",
        ".wmv",
    ]
)
MOST_LISTED = 8
"""How many of the sequences found a message names."""


def open_clip(path: str | Path, layer: str = "") -> PlateSource:
    """Open a plate.

    Parameters
    ----------
    path : a folder of images, a pattern (`plate.%04d.exr`, `plate.####.exr`, `plate.%d.exr`), one image of a numbered
        sequence (which opens all of it), a lone image (frame 1) or a movie. In a folder with several sequences the
        longest wins. Only headers are read. `####` and `@@@@` stand for digits too.
    layer : which layer of the images is the plate, by its name (`PlateSource.layers`); the picture itself if "".

    Raises
    ------
    RoamError
        when there is nothing, nothing readable, no single longest sequence, or no layer of that name.
    """
    if not str(path).strip():
        raise RoamError("No plate was named; give a folder of images, a pattern, an image or a movie.")
    try:
        place = Path(path).expanduser().absolute()
        is_folder, is_file, is_there = place.is_dir(), place.is_file(), place.exists()
    except (OSError, RuntimeError, ValueError) as error:
        raise RoamError(f"{str(path)!r} is no path that can be opened: {error}.") from error
    if is_folder:
        return _open_folder(place, layer)
    if is_file:
        return _open_file(place, layer)
    if is_there:
        require_regular(place)
    return _open_pattern(place, layer)


def _open_folder(folder: Path, layer: str) -> PlateSource:
    found = find_sequences(folder, _image_extensions())
    if not found:
        return _open_movie_in(folder, layer)
    if len(found) == 1:
        # The artist's own word for the plate is the folder; a pattern would only tell the same less readably.
        return _images(found[0], layer, folder)
    if len(found[0].names) == len(found[1].names):
        raise RoamError(
            f"{folder} holds several sequences, none longer than the others: {_listed(found)}. "
            f"Give a pattern, such as {found[0].path.name}."
        )
    return _images(found[0], layer)


def _open_movie_in(folder: Path, layer: str) -> PlateSource:
    movies = [folder / name for name in file_names(folder) if Path(name).suffix.lower() in MOVIE_EXTENSIONS]
    if not movies:
        raise RoamError(f"{folder} holds no image and no movie; choose the folder that holds the plate's frames.")
    if len(movies) > 1:
        names = ", ".join(movie.name for movie in movies[:MOST_LISTED])
        raise RoamError(f"{folder} holds several movies ({names}); name one of them.")
    return _movie(movies[0], layer)


def _open_file(file: Path, layer: str) -> PlateSource:
    if file.suffix.lower() in MOVIE_EXTENSIONS or _is_animation(file):
        return _movie(file, layer)
    found = find_sequences(file.parent, {file.suffix.lower()})
    owner = next((sequence for sequence in found if sequence.holds(file.name)), None)
    sequence = owner or FileSequence(file.parent, {1: file.name}, None)
    if file.suffix.lower() in _image_extensions():
        return _images(sequence, layer)
    try:
        return _images(sequence, layer)  # a picture under another name is known by its content
    except RoamError:
        if not os.access(file, os.R_OK):
            raise
        raise RoamError(
            f"{file} is no ROAM project, no picture and no movie. Open a folder of pictures, a movie, or a project, "
            "whose name ends with .roam; shapes of other programs are imported into a project."
        ) from None


def _open_pattern(place: Path, layer: str) -> PlateSource:
    pattern = parse_pattern(place.name)
    if pattern is None:
        raise RoamError(f"{place} does not exist; give a folder of images, a pattern, an image or a movie.")
    sequence = find_pattern(place.parent, pattern)
    if sequence is None:
        others = find_sequences(place.parent, _image_extensions())
        hint = f"the folder holds {_listed(others)}" if others else "the folder holds no image"
        raise RoamError(f"No file in {place.parent} follows the pattern {place.name}; {hint}.")
    return _images(sequence, layer, place)


def _is_animation(file: Path) -> bool:
    """Whether a GIF holds more than one picture: then it is a movie."""
    from roam_core.media.decoding import has_several_images

    return file.suffix.lower() == ".gif" and has_several_images(file)


def _listed(sequences: list[FileSequence]) -> str:
    names = ", ".join(sequence.label for sequence in sequences[:MOST_LISTED])
    return f"{names} and {len(sequences) - MOST_LISTED} more" if len(sequences) > MOST_LISTED else names


# The decoders are large libraries: they are loaded when a clip is opened.


def _images(sequence: FileSequence, layer: str, path: Path | None = None) -> ImageSequence:
    from roam_core.media.sequence import ImageSequence

    return ImageSequence(sequence.checked(), path, layer)


def _movie(path: Path, layer: str) -> MoviePlate:
    from roam_core.media.decoding import open_movie
    from roam_core.media.layers import PLAIN

    if layer not in ("", PLAIN):
        raise RoamError(f"{path} is a movie: it has no layer {layer!r}.")
    return open_movie(path)


def _image_extensions() -> frozenset[str]:
    from roam_core.media.decoding import image_extensions

    return image_extensions()
