"""On which frames something is an object: labels are there or not, where opacities have shades between."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import groupby

from roam_core.interchange.protocol import ExportOptions
from roam_core.roto import Clip, Layer, RotoShape
from roam_core.translatable import sentence


def is_dimmed(item: Layer | RotoShape, frames: range) -> bool:
    """True where an item is neither fully there nor away on one of the `frames`: of that a label holds nothing."""
    return any(0.0 < item.opacity_at(frame) < 1.0 for frame in frames)


def stretches(shape: RotoShape, around: Sequence[Layer], frames: range) -> Iterator[tuple[int, int]]:
    """The stretches of `frames`, each a first frame and the one after its last, on which something is seen of a shape.

    It is seen within its lifetime, where neither its own opacity nor that of a layer `around` it is 0.
    """

    items: tuple[Layer | RotoShape, ...] = (shape, *around)

    def is_seen(frame: int) -> bool:
        return shape.exists_at(frame) and all(item.opacity_at(frame) > 0.0 for item in items)

    for seen, stretch in groupby(frames, is_seen):
        if seen:
            first, *rest = stretch
            yield first, (rest[-1] if rest else first) + 1


def below_zero(program: str, clip: Clip, options: ExportOptions) -> list[str]:
    """A sentence where an offset numbers frames below 0, for programs that count from the clip's first; else none."""
    if options.frames_of(clip)[0] - clip.first + options.frame_offset >= 0:
        return []
    return [
        sentence(
            "{program} counts from 0, the clip's first frame: an offset of {offset} numbers frames below that, "
            "which it does not show.",
            program=program,
            offset=options.frame_offset,
        )
    ]
