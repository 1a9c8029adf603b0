"""Where a run from a frame that shows nothing begins: on the last one before it that does, as if it had gone on."""

from __future__ import annotations

from bisect import bisect_left, bisect_right
from collections.abc import Sequence

from roam_core.cli.plate import Plate, tell
from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media import MissingFrame
from roam_core.params import params_for
from roam_core.propagate.shapes.taking_part import has_begun
from roam_core.roto import RotoShape


def shown_start(
    start: int, shapes: Sequence[RotoShape], plate: Plate, config: str | None = None, *, backward: bool
) -> int:
    """Where a run from `start` begins: in a gap of the clip on the frame before it, as in the window; that is told.

    So a run that ended in a gap goes on from what it found last. With the name of a configuration a frame without a key
    is as good as a gap where it cannot be decoded, or shows nothing: runs bridge these alike. Elsewhere, and where none
    of the shapes has a key behind, it is `start`.
    """
    frames = plate.source.frames
    if not frames[0] <= start <= frames[-1]:
        return start
    before = list(frames[bisect_right(frames, start) :] if backward else reversed(frames[: bisect_left(frames, start)]))
    if start in frames:
        if config is None or any(shape.key_at(start) for shape in shapes) or _shows(plate, start, shapes, config):
            return start
        why = f"frame {start} cannot be read, or shows nothing"
    else:
        why = f"the clip has no picture of frame {start}"
    for behind in before:
        if not any(has_begun(shape, behind, not backward) for shape in shapes):
            return start
        keyed = any(shape.key_at(behind) for shape in shapes)
        if config is None or keyed or _shows(plate, behind, shapes, config):
            tell(f"The run begins on frame {behind}: {why}.")
            return behind
    return start


def _shows(plate: Plate, frame: int, shapes: Sequence[RotoShape], config: str) -> bool:
    """Whether a frame can be decoded, and shows something."""
    try:
        outlines = [shape.at(frame).points for shape in shapes]
        return not is_blank(PreparedFrame(plate.parts(frame)), outlines, params_for(config).blank)
    except MissingFrame:
        return False
