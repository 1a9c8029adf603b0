"""Which files ROAM wrote: told by what is in them, for names and suffixes say nothing of whose work a file is."""

from __future__ import annotations

import re
from enum import StrEnum
from pathlib import Path

from roam_core.interchange.recognition import head_of

SOFTWARE = "ROAM"
"""The `Software` tag of every picture that ROAM writes."""
MARK = "Written by ROAM"
"""The comment by which exports are known whose format says nothing of where a file comes from."""
HEAD_BYTES = 1024

_PROJECT = re.compile(rb'\s*\{(?:[^{\0]*?"type"\s*:\s*"roam\.Project"|\s*"clip"\s*:\s*\{[^\0]*?"type"\s*:\s*"Clip")')
"""A script that writes the fields in another order, as sorted, begins with the clip."""
_SHAPES = re.compile(
    rb"# Written by ROAM\n"  # Nuke
    rb"|# (?:Shapes|Masks) from ROAM\b"  # scripts for Nuke, Blender and Natron
    rb"|// Masks from ROAM"  # After Effects
    rb"|<!-- Silhouette Shape File -->\n<!-- Written by ROAM -->"
    rb"|\{\n Tools = ordered\(\) \{\n"  # Fusion knows no comments everywhere; it lays out its own files otherwise
    rb"|<\?xml[^>]*\?>\n<svg [^>\n]*data-roam-frame="  # an editor that saves it again breaks this line
    rb'|\{\n "format": "roam-shapes"'
    rb'|\{\n "info": \{"description": "Shapes from ROAM"'  # COCO
    rb"|<\?xml[^>]*\?>\n<!-- Written by ROAM -->"  # CVAT
    rb'|\{\n "\d+": \[\[\['  # MLT's splines hold nothing but frames; it lays them out otherwise
)
_PICTURE = re.compile(rb"\x89PNG|\x76\x2f\x31\x01|II\*\x00|MM\x00\*|II\+\x00|MM\x00\+")
"""How PNG, EXR and TIFF files begin."""
_MOVIE = re.compile(rb"....ftyp|RIFF....AVI ", re.DOTALL)
"""How MPEG-4, QuickTime and AVI files begin; our mark stands at their end."""


class Kind(StrEnum):
    """What ROAM writes."""

    PROJECT = "project"
    SHAPES = "shapes"
    PICTURE = "picture"
    MOVIE = "movie"


def written_by_us(path: Path) -> Kind | None:
    """What ROAM wrote to the file at `path`; None for what somebody else did, or for no plain, readable file."""
    head = head_of(path, HEAD_BYTES)
    if head is None:
        return None
    if _PROJECT.match(head):
        return Kind.PROJECT
    if _SHAPES.match(head):
        return Kind.SHAPES
    if _MOVIE.match(head):
        return Kind.MOVIE if _ends_in_mark(path) else None
    return Kind.PICTURE if _PICTURE.match(head) and _software(path) == SOFTWARE else None


def is_project(path: Path) -> bool:
    """Whether the file at `path` is a project of ROAM's, whatever its name."""
    return written_by_us(path) is Kind.PROJECT


def _ends_in_mark(movie: Path) -> bool:
    try:
        with movie.open("rb") as file:
            file.seek(max(movie.stat().st_size - len(MARK), 0))
            return file.read(len(MARK)) == MARK.encode()
    except OSError:
        return False


def _software(picture: Path) -> str:
    """The `Software` tag of a picture, from its header."""
    from roam_core.media.decoding import software_of  # large: only where there is a picture

    return software_of(picture)
