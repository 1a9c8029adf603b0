"""`open_clip`: finds out what a path holds, and opens it as the right kind of plate."""

from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING

from roam_core.arguments import path_of
from roam_core.bounded import require_regular
from roam_core.errors import RoamError
from roam_core.media.content import content_hash
from roam_core.media.numbering import (
    FileSequence,
    file_names,
    find_pattern,
    find_sequences,
    listed_name,
    parse_pattern,
    varying_pattern,
)
from roam_core.media.source import PlateSource
from roam_core.system_errors import reason_of
from roam_core.translatable import enumerated, sentence

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


def open_clip(path: str | Path, layer: str = "", content: str = "") -> PlateSource:
    """Open a plate.

    Parameters
    ----------
    path : a folder of images, a pattern (`plate.%04d.exr`, `plate.####.exr`, `plate.%d.exr`), one image of a numbered
        sequence (which opens all of it), a lone image (frame 1) or a movie. In a folder with several sequences the
        longest wins. Only headers are read. `####` and `@@@@` stand for digits too, as
        do the words of other programs (`parse_pattern`).
    layer : which layer of the images is the plate, by its name (`PlateSource.layers`); the picture itself if "".
    content : hash of the plate that is meant (`roam_core.media.content`), "" where it is not known: in a folder with
        several sequences that one is taken, whatever its length, and the folder stays its path.

    Raises
    ------
    ValueError
        when the path is none.
    RoamError
        when there is nothing, nothing readable, no single longest sequence, or no layer of that name.
    """
    given = path_of(path)
    if not str(path).strip():
        raise RoamError(sentence("No plate was named; give a folder of images, a pattern, an image or a movie."))
    try:
        place = given.expanduser().absolute()
        is_folder, is_file, is_there = place.is_dir(), place.is_file(), place.exists()
    except (OSError, RuntimeError, ValueError) as error:
        raise RoamError(
            sentence("{path!r} is no path that can be opened: {reason}.", path=str(path), reason=reason_of(error))
        ) from error
    if is_folder:
        return _open_folder(place, layer, content)
    if is_file:
        return _open_file(place, layer)
    if is_there:
        require_regular(place)
    return _open_pattern(place, layer)


def files_of(path: Path, content: str = "") -> FileSequence | None:
    """The files of a plate that is a folder or a pattern, as `open_clip` finds them. Nothing is opened.

    None of a movie or one picture, and where there is nothing. Raises `RoamError` when a folder cannot be read, or has
    no single longest sequence.
    """
    if path.is_dir():
        found = find_sequences(path, _image_extensions())
        return _chosen(path, found, content) if found else None
    pattern = None if path.is_file() else parse_pattern(path.name)
    return find_pattern(path.parent, pattern) if pattern and path.parent.is_dir() else None


def _open_folder(folder: Path, layer: str, content: str) -> PlateSource:
    found = find_sequences(folder, _image_extensions())
    if not found:
        return _open_movie_in(folder, layer)
    if len(found) == len(found[0].names) == 1 and _is_animation(found[0].first_file):
        return _movie(found[0].first_file, layer)
    sequence = _chosen(folder, found, content)
    # The artist's own word for the plate is the folder, where it leads there; a pattern tells the same less readably.
    leads_there = len(found) == 1 or (content and _holds(sequence, content))
    return _images(sequence, layer, folder if leads_there else None)


def _chosen(folder: Path, found: list[FileSequence], content: str) -> FileSequence:
    """Of the sequences of a folder, longest first, the plate: the one of that content, else the longest."""
    if len(found) == 1:
        return found[0]
    if content and (known := next((sequence for sequence in found if _holds(sequence, content)), None)):
        return known
    if len(found[0].names) > len(found[1].names):
        return found[0]
    advised = _advised(found)
    if not content and advised == found[0].path.name and all(sequence.pattern is None for sequence in found):
        raise RoamError(
            sentence(
                "{folder} holds {count} images whose names do not count frames: {names}. "
                "Number them, with nine digits at most, such as shot.0001.png, or give one of them.",
                folder=folder,
                count=len(found),
                names=_listed(found),
            )
        )
    if content:
        raise RoamError(
            sentence(
                "{folder} holds several sequences, none longer than the others, and none begins as the project's "
                "plate: {names}. Leave the plate alone in its folder, or relink the clip.",
                folder=folder,
                names=_listed(found),
            )
        )
    raise RoamError(
        sentence(
            "{folder} holds several sequences, none longer than the others: {names}. "
            "Give a pattern, such as {advised}.",
            folder=folder,
            names=_listed(found),
            advised=advised,
        )
    )


def _advised(found: list[FileSequence]) -> str:
    """The pattern that takes in most files; what varies may be another group of digits than the last."""
    names = [name for sequence in found for name in sequence.names.values()]
    pattern = varying_pattern(names)
    most = sum(pattern.number_of(name) is not None for name in names) if pattern else 0
    return str(pattern) if most > len(found[0].names) else found[0].path.name


def _holds(sequence: FileSequence, content: str) -> bool:
    return content_hash(sequence.first_file) == content


def _open_movie_in(folder: Path, layer: str) -> PlateSource:
    movies = [folder / name for name in file_names(folder) if Path(name).suffix.lower() in MOVIE_EXTENSIONS]
    if not movies:
        raise RoamError(
            sentence(
                "{folder} holds no image and no movie; choose the folder that holds the plate's frames.", folder=folder
            )
        )
    if len(movies) > 1:
        names = ", ".join(movie.name for movie in movies[:MOST_LISTED])
        raise RoamError(
            sentence("{folder} holds several movies ({names}); name one of them.", folder=folder, names=names)
        )
    return _movie(movies[0], layer)


def _open_file(file: Path, layer: str) -> PlateSource:
    if file.suffix.lower() in MOVIE_EXTENSIONS or _is_animation(file):
        return _movie(file, layer)
    found = find_sequences(file.parent, {file.suffix.lower()})
    file = file.with_name(listed_name(file))
    owner = next((sequence for sequence in found if sequence.holds(file.name)), None)
    sequence = owner or FileSequence(file.parent, {1: file.name}, None)
    if file.suffix.lower() in _image_extensions():
        return _images(sequence, layer)
    try:
        return _images(sequence, layer)  # a picture under another name is known by its content
    except RoamError:
        if not os.access(file, os.R_OK):
            raise
        if file.suffix.lower() == ".roam":
            raise RoamError(
                sentence(
                    "{file} is a project, not a plate; name the plate: a folder of images, a pattern, an image or a "
                    "movie.",
                    file=file,
                )
            ) from None
        raise RoamError(
            sentence(
                "{file} is no ROAM project, no picture and no movie. Open a folder of pictures, a movie, or a project, "
                "whose name ends with .roam; shapes of other programs are imported into a project.",
                file=file,
            )
        ) from None


def _open_pattern(place: Path, layer: str) -> PlateSource:
    pattern = parse_pattern(place.name)
    if pattern is None:
        raise RoamError(
            sentence("{path} does not exist; give a folder of images, a pattern, an image or a movie.", path=place)
        )
    sequence = find_pattern(place.parent, pattern)
    if sequence is None:
        others = find_sequences(place.parent, _image_extensions())
        hint = sentence("the folder holds no image")
        if others:
            hint = sentence("the folder holds {names}", names=_listed(others))
        raise RoamError(
            sentence(
                "No file in {folder} follows the pattern {name}; {hint}.",
                folder=place.parent,
                name=place.name,
                hint=hint,
            )
        )
    return _images(sequence, layer, place)


def _is_animation(file: Path) -> bool:
    """Whether a GIF holds more than one picture: then it is a movie."""
    from roam_core.media.decoding import has_several_images

    return file.suffix.lower() == ".gif" and has_several_images(file)


def _listed(sequences: list[FileSequence]) -> str:
    return enumerated([sequence.label for sequence in sequences], MOST_LISTED)


# The decoders are large libraries: they are loaded when a clip is opened.


def _images(sequence: FileSequence, layer: str, path: Path | None = None) -> ImageSequence:
    from roam_core.media.sequence import ImageSequence

    return ImageSequence(sequence.checked(), path, layer)


def _movie(path: Path, layer: str) -> MoviePlate:
    from roam_core.media.decoding import open_movie
    from roam_core.media.layers import PLAIN

    if layer not in ("", PLAIN):
        raise RoamError(sentence("{path} is a movie: it has no layer {layer!r}.", path=path, layer=layer))
    return open_movie(path)


def _image_extensions() -> frozenset[str]:
    from roam_core.media.decoding import image_extensions

    return image_extensions()
