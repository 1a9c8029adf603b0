"""A project's plate after a move, and whether a plate is the one that the project was made on."""

from __future__ import annotations

from dataclasses import replace
from itertools import islice
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.media.content import content_hash
from roam_core.media.finding import is_there, places_near
from roam_core.media.opening import files_of, open_clip
from roam_core.media.source import PlateSource
from roam_core.roto.project import Clip, Project
from roam_core.translatable import said_by, sentence

MOST_OPENED = 16
"""Places of which the plate is looked at."""


def relinked(project: Project, folder: Path) -> Project:
    """The project with its clip where the plate lies now, if it is gone from its place and lies near `folder`.

    A plate is taken only if its content is that of the project's; where the project tells no content, if size, frames
    and its folder's name are. The project itself is given back where there is nothing to find, or nothing was found.
    """
    if project.clip is None or is_there(project.clip.path):
        return project
    for place in islice(places_near(folder.absolute(), project.clip.path), MOST_OPENED):
        try:
            found = Clip.of(open_clip(place, project.clip.layer, project.clip.content))
        except RoamError:
            continue
        if _is_same(project.clip, found):
            return replace(project, clip=replace(project.clip, path=found.path))
    return project


def open_plate(clip: Clip) -> PlateSource:
    """The plate of a project: of several sequences in its folder the one that the project was made on.

    Raises
    ------
    RoamError
        as `open_clip` does.
    """
    return open_clip(clip.path, clip.layer, clip.content)


def other_size(clip: Clip, found: Clip) -> str:
    """A sentence where the plate `found` is of another size than `clip`, on which the project was made; else ""."""
    if found.size == clip.size:
        return ""
    return sentence(
        "The clip {path} is {size} now; the project was made for {before}. "
        "Put the old clip back, or open the project and choose another.",
        path=found.path,
        size=f"{found.size[0]}x{found.size[1]}",
        before=f"{clip.size[0]}x{clip.size[1]}",
    )


def other_content(clip: Clip, found: Clip) -> str:
    """A sentence where the plate `found` shows something else than the one of the project, `clip`; else ""."""
    return _other_content(clip, found.path, found.content)


def other_content_now(clip: Clip) -> str:
    """As `other_content`, of what lies at the clip's path now; of pictures and movies none is opened for it.

    A folder of which it cannot be told which sequence is the plate is told as `open_clip` tells it.
    """
    try:
        sequence = files_of(clip.path, clip.content)
    except RoamError as error:
        return said_by(error)
    return _other_content(clip, clip.path, content_hash(sequence.first_file if sequence else clip.path))


def is_renumbered(before: Clip, after: Clip) -> bool:
    """Whether a clip has the pictures of the one `before` under other numbers: as far as can be told without decoding.

    The content of the first picture, size, layer, colours and the number of frames are the same.
    """

    def told(clip: Clip) -> tuple[object, ...]:
        return clip.content, clip.size, clip.layer, clip.colour_space, clip.last - clip.first

    return bool(before.content) and before.first != after.first and told(before) == told(after)


def numbers_now(clip: Clip) -> str:
    """A sentence where the pictures at the clip's path bear other numbers now, by the same signs; else "".

    None of a movie. Nothing is opened.
    """
    try:
        sequence = files_of(clip.path, clip.content)
    except RoamError:
        return ""
    if sequence is None or not clip.content:
        return ""
    first, last = min(sequence.names), max(sequence.names)
    is_other = first != clip.first and last - first == clip.last - clip.first
    if not is_other or content_hash(sequence.first_file) != clip.content:
        return ""
    return f"The plate {clip.path} is numbered from {first} now, not from {clip.first}; roam shift follows it."


def missing_now(clip: Clip) -> frozenset[int]:
    """The clip's frames of which no file lies at its path; none of a movie, nor where the files cannot be told."""
    try:
        sequence = files_of(clip.path, clip.content)
    except RoamError:
        return frozenset()
    return frozenset(clip.frame_range) - sequence.names.keys() if sequence else frozenset()


def _other_content(clip: Clip, path: Path, content: str) -> str:
    if not clip.content or not content or content == clip.content:
        return ""
    return sentence(
        "The first frame of {path} is not that of the plate that the project was made on ({before}); "
        "check that the shapes fit the picture.",
        path=path,
        before=clip.path,
    )


def _is_same(clip: Clip, found: Clip) -> bool:
    if clip.size != found.size:
        return False
    if clip.content:
        return found.content == clip.content
    same_place = found.path.parts[-2:] == clip.path.parts[-2:]
    return same_place and (found.first, found.last) == (clip.first, clip.last)
