"""In what order jobs are begun: the longest first, so that none of them begins when the others have ended."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from pathlib import Path

from roam_core.errors import RoamError
from roam_core.media import open_clip
from roam_core.studio.tasks import SOLVING, Task


def longest_first(jobs: Sequence[Sequence[Task]]) -> list[Sequence[Task]]:
    """Jobs by the pixels that they solve, most first; those that solve nothing keep their order, behind the others.

    The length of a movie is not known before it is opened, which takes long: jobs on movies come first, the largest
    files before the others.
    """
    return sorted(jobs, key=_length, reverse=True)


def _length(tasks: Sequence[Task]) -> tuple[int, int]:
    """Bytes of a job's movies, and pixels of its sequences, that are gone through."""
    solving = [task for task in tasks if task.verb in SOLVING and task.plate]
    movies = sum(_bytes_of(task.plate) for task in solving)
    return movies, sum(_pixels(task) for task in solving)


def _pixels(task: Task) -> int:
    frames, pixels = _sequence(task.plate, task.layer, task.content)
    options = task.settings["options"]
    first, last = (options.get(name) for name in ("start", "end"))
    asked = [frame for frame in frames if (first is None or frame >= first) and (last is None or frame <= last)]
    return pixels * len(asked)


@lru_cache(1024)
def _sequence(plate: str, layer: str, content: str) -> tuple[Sequence[int], int]:
    """The frames of a sequence of pictures, and the pixels of each; none of what cannot be opened: its step says so."""
    if Path(plate).is_file():
        return (), 0
    try:
        source = open_clip(plate, layer, content)
    except RoamError:
        return (), 0
    width, height = source.size
    return source.frames, width * height


@lru_cache(1024)
def _bytes_of(plate: str) -> int:
    try:
        return Path(plate).stat().st_size if Path(plate).is_file() else 0
    except OSError:
        return 0
