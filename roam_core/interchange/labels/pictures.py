"""Which file holds a frame of the plate: data sets name their pictures, and loaders open them by that."""

from __future__ import annotations

from collections.abc import Mapping

from roam_core.errors import RoamError
from roam_core.media.opening import MOVIE_EXTENSIONS, files_of
from roam_core.roto import Clip


def file_names_of(clip: Clip) -> Mapping[int, str] | None:
    """The name of the plate's file for each frame that has one, without its folder.

    None where no file is a frame: of movies, of a plate that is not at hand, and where other frames lie in its place.
    The plate's folder is read, which takes as long as its disk takes to answer.
    """
    try:
        if clip.path.is_file():
            is_movie = clip.first != clip.last or clip.path.suffix.lower() in MOVIE_EXTENSIONS
            return None if is_movie else {clip.first: clip.path.name}
        found = files_of(clip.path, clip.content)
    except (RoamError, OSError):
        return None
    names = found.names if found is not None else {}
    # The first and the last frame of a clip are never missing ones; one file for a long clip is an animation.
    return names if clip.first in names and clip.last in names else None


def made_up_name(clip: Clip, number: int) -> str:
    """A name for the picture of a frame that is no file."""
    return f"{clip.path.stem.rstrip('.#%0123456789d') or 'frame'}.{number:06d}.png"
