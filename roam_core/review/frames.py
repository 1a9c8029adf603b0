"""Which frames of a project are meant: by their numbers, or by what is on them."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable
from functools import reduce

from roam_core.errors import RoamError
from roam_core.review.findings import boiling, doubtful
from roam_core.roto import Project
from roam_core.translatable import N_, sentence

_NUMBERS = re.compile(r"(-?\d+)(?:-(-?\d+))?(?:x(\d+))?")
"""1001, 1001-1048, 1001-1048x5."""
_EVERY = re.compile(r"x(\d+)")


def _keys(project: Project) -> Iterable[int]:
    return (frame for shape in project.shapes for frame in shape.artist_frames)


def _notes(project: Project) -> Iterable[int]:
    return (mark.frame for mark in project.marks)


WORDS: dict[str, Callable[[Project], Iterable[int]]] = {
    "all": lambda project: project.require_clip().frame_range,
    "keys": _keys,
    "notes": _notes,
    "doubtful": lambda project: (found.frame for found in doubtful(project.shapes)),
    "boil": lambda project: (found.frame for found in boiling(project.shapes)),
}
"""What frames may be called beside their numbers."""
HINT = N_("1001,1010-1020 or 1001-1048x5, x10 for every tenth, all, keys, notes, doubtful or boil")


def chosen_frames(project: Project, words: str, within: range | None = None) -> tuple[int, ...]:
    """The frames that `words` name, with commas between them, in the order of time; only those of the clip.

    Of `within`, a range of the clip's frames, only those that lie in it: every tenth then counts from its first. Keys
    and notes that lie beside the clip are passed over; numbers beside it are a mistake.

    Raises
    ------
    RoamError
        for a word that names no frames, for numbers beside the clip, and where none is left.
    """
    clip = project.require_clip().frame_range
    frames = clip if within is None else within
    found: set[int] = set()
    for word in (part.strip() for part in words.split(",")):
        if word in WORDS:
            found.update(WORDS[word](project))
        elif (every := _EVERY.fullmatch(word)) and int(every[1]):
            found.update(frames[:: int(every[1])])
        elif (numbers := _NUMBERS.fullmatch(word)) and numbers[3] != "0":
            first, last = int(numbers[1]), int(numbers[2] or numbers[1])
            step = int(numbers[3] or 1)
            _require_of(clip, word, first, last)
            found.update(frame for frame in frames if first <= frame <= last and (frame - first) % step == 0)
        else:
            raise RoamError(sentence("{word!r} names no frames; say {words}.", word=word, words=sentence(HINT)))
    chosen = tuple(sorted(frame for frame in found if frame in frames))
    if not chosen:
        raise RoamError(
            sentence(
                "There is no frame of {words!r} between {first} and {last}.",
                words=_said(words),
                first=frames.start,
                last=frames.stop - 1,
            )
        )
    return chosen


def _said(words: str) -> str:
    """The words, in another language as it calls them."""
    parts = [sentence(part) if part in WORDS else part for part in (word.strip() for word in words.split(","))]
    return reduce(lambda before, after: sentence("{before}, {after}", before=before, after=after), parts)


def _require_of(clip: range, word: str, first: int, last: int) -> None:
    """A sentence for the numbers of a word that are no frames of the clip, or in the wrong order."""
    if last < first:
        raise RoamError(sentence("{word!r} ends before it begins; the first frame comes first.", word=word))
    if not (first in clip and last in clip):
        raise RoamError(
            sentence(
                "{word!r} lies outside the clip's frames {first}-{last}.",
                word=word,
                first=clip.start,
                last=clip.stop - 1,
            )
        )
