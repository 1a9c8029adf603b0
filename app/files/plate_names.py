"""What files are called that are written of a plate: after the plate."""

from __future__ import annotations

from roam_core.media.numbering import parse_pattern
from roam_core.media.opening import MOVIE_EXTENSIONS
from roam_core.roto import Clip
from roam_core.system_errors import is_folder

from ..folders import called

SEPARATORS = "._- "
"""What stands between a name and its frame number."""


def file_stem(clip: Clip) -> str:
    """What files of this plate begin with: its name without the place of the frame number and the suffix of a file.

    A folder keeps all of its name, `plate.v002` too; of a pattern without a name, `%04d.exr`, the folder has one.
    """
    if is_folder(clip.path):
        return called(clip.path)
    if clip.path.suffix.lower() in MOVIE_EXTENSIONS or (pattern := parse_pattern(clip.name)) is None:
        return clip.path.stem
    return pattern.prefix.rstrip(SEPARATORS) or clip.path.parent.name or clip.path.stem
