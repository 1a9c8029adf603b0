"""What of a plate's files, or of a mask's, is not looked at, in a sentence for whoever opens it."""

from __future__ import annotations

from pathlib import Path

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
    if not _has_further_pages(file):
        return ""
    return sentence(
        "{name} holds several pictures, of which the first is the plate: to have all, save them as numbered files.",
        name=file.name,
    )


def unseen_of_mask(file: Path) -> str:
    """That a mask has further pages; "" where it has not."""
    if not _has_further_pages(file):
        return ""
    return sentence(
        "{name} holds several pictures, of which the first is the mask: to have all, save them as numbered files.",
        name=file.name,
    )


def _has_further_pages(file: Path) -> bool:
    try:
        return has_several_images(file)
    except RoamError:  # reading it will tell
        return False
