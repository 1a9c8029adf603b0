"""Tracks over frames on which what they follow is hidden: it is waited for, and those frames are bridged."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

from roam_core.cancel import CancelToken
from roam_core.errors import RoamError
from roam_core.media.source import MissingFrame

Step = TypeVar("Step")


class Lost(RoamError):
    """What is tracked could not be found on a frame."""


def bridged(
    first: Step,
    look: Callable[[int], Step],
    between: Callable[[Step, Step, Sequence[int]], Iterator[Step]],
    frames: Sequence[int],
    waits: int,
    token: CancelToken | None = None,
) -> Iterator[Step]:
    """What `look` finds on each of `frames`, in their order.

    A frame that raises `MissingFrame` is passed over. Those on which `look` raises `Lost` come when it finds something
    again: `between(before, after, frames)` gives their steps. `first` is where the track stands before them all.

    Raises
    ------
    Lost
        as on the first of more than `waits` frames on which nothing is found, or of fewer at the end. Cancelled: at a
        safe point after `token` was cancelled.
    """
    last, waiting = first, dict[int, Lost]()
    for frame in frames:
        if token is not None:
            token.check()
        try:
            step = look(frame)
        except MissingFrame:
            continue
        except Lost as error:
            waiting[frame] = error
            if len(waiting) > waits:
                break
            continue
        yield from between(last, step, list(waiting))
        yield step
        last = step
        waiting.clear()
    for lost in waiting.values():
        raise lost from None
