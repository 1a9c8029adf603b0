"""What can be found out about a clip without opening it: its headers and its first picture."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roam_core.errors import RoamError

from ..translation import sentence_of

if TYPE_CHECKING:
    from roam_core.media import PlateSource
    from roam_core.roto import Clip

LARGEST = (800, 450)
"""Width and height of the picture that is kept: sharp where half of it is shown, on screens of any density."""


@dataclass(frozen=True)
class FoundClip:
    """A clip that was looked at: it is not open yet, or it is the one of the project, `held`.

    `picture` is its first frame `(h, w, 3)`, small, with the values of the files; None where that frame cannot be read,
    and `trouble` says why. `spaces` are the colour spaces that an artist may say it has.
    """

    path: Path
    source: PlateSource
    picture: Any
    spaces: tuple[str, ...]
    trouble: str = ""
    held: Clip | None = None


def looked_at(path: Path, layer: str = "", held: Clip | None = None) -> FoundClip:
    """Look at a clip: its headers and its first picture, of one layer of its files or of the one that is found.

    Of several sequences in the folder of the project's clip, `held`, at that one.

    Raises `RoamError` when there is no clip at `path`, or no such layer.
    """
    from roam_core.media import open_clip
    from roam_core.media.colour_spaces import offered_spaces

    source, spaces = open_clip(path, layer, held.content if held else ""), offered_spaces()
    try:
        return FoundClip(path, source, _small(source.read(source.frames[0])), spaces, held=held)
    except RoamError as error:
        return FoundClip(path, source, None, spaces, sentence_of(error), held)


def _small(picture: Any) -> Any:
    """A picture no larger than is worth showing before a clip is open."""
    import cv2

    from roam_core.media.colour import unit_floats

    if picture.dtype == "float16":  # OpenCV scales no halves
        picture = unit_floats(picture)
    height, width = picture.shape[:2]
    scale = min(LARGEST[0] / width, LARGEST[1] / height, 1.0)
    size = max(round(width * scale), 1), max(round(height * scale), 1)
    return picture if scale == 1.0 else cv2.resize(picture, size, interpolation=cv2.INTER_AREA)
