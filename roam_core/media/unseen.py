"""What of a plate's files is not shown, in a sentence for whoever opens it."""

from __future__ import annotations

from roam_core.errors import RoamError
from roam_core.media.decoding import has_several_images
from roam_core.media.movie_plate import MoviePlate, shortfall
from roam_core.media.source import PlateSource
from roam_core.translatable import sentence


def unseen(source: PlateSource) -> str:
    """That a movie may be cut short, or that an image has further pages; "" where all of the plate is shown."""
    return shortfall(source) or _further_pages(source)


def _further_pages(source: PlateSource) -> str:
    if isinstance(source, MoviePlate) or len(source.frames) > 1:
        return ""
    file = source.file_of(source.frames[0])
    try:
        if not has_several_images(file):
            return ""
    except RoamError:  # reading its frame will tell
        return ""
    return sentence(
        "{name} holds several pictures, of which the first is the plate: to have all, save them as numbered files.",
        name=file.name,
    )
