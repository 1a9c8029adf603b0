"""File names with version numbers, as studios write them: `shot010_roto_v003.roam` is followed by `..._v004.roam`."""

from __future__ import annotations

import re
from collections.abc import Iterable
from pathlib import PurePath

from roam_core.media.numbering import folded

_NUMBER = re.compile(r"(?<![^\W\d_])[vV]([0-9]+)")
"""A v with digits that is no end of a word, as in `rev2` or `hdv1080`."""
FIRST = "_v001"
"""What a name without a version number stands for."""


def next_version(name: str, there: Iterable[str]) -> tuple[str, str]:
    """The file name of the next version of the file `name`, in a folder that holds the names `there`.

    The last number after a v counts one up; its width stays as long as it suffices, and so does all else. A name
    without one gets `_v002`. Where a file has the next number already it is the first one above all that are there;
    then that file's name is given, too, else "". Names differ by no more than their case or by how accents are written
    in no folder: some file systems do not tell them apart.
    """
    path = PurePath(name)
    stem = path.stem if (found := _last_number(path.stem)) else path.stem + FIRST
    number = found or _last_number(stem)
    assert number is not None
    before, digits, after = stem[: number.start(1)], number[1], stem[number.end(1) :] + path.suffix
    pattern = re.compile(f"{re.escape(folded(before))}([0-9]+){re.escape(folded(after))}")
    held = {int(match[1]): each for each in there if (match := pattern.fullmatch(folded(each)))}
    following = int(digits) + 1
    free = max(held) + 1 if following in held else following
    return f"{before}{free:0{len(digits)}}{after}", held.get(following, "")


def _last_number(stem: str) -> re.Match[str] | None:
    return next(reversed(list(_NUMBER.finditer(stem))), None)
