"""Which frames between two keys show something to go by: filling passes over the others, so they keep no key."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from roam_core.features import PreparedFrame
from roam_core.features.blank import is_blank
from roam_core.media.partial import ReadFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RoamParams
from roam_core.propagate.engines.view import EngineView
from roam_core.roto import RotoShape


def frames_shown(
    read: ReadFrame, shape: RotoShape, gap: tuple[int, int], frames: Iterable[int], params: RoamParams
) -> Iterator[int]:
    """Those of `frames`, between the two keys of a gap, on which filling it gives `shape` a key.

    It passes over those without a picture, of which a part is damaged, and those that have gone blank
    (`features.blank`): that show nothing where the pictures of both keys show something. Each is read whole, when it is
    asked for; those of the keys as far as it takes.
    """
    key_points = [shape.at(frame).points for frame in gap]
    try:
        ends = [PreparedFrame(read(frame)) for frame in gap]
        view = EngineView.of_key(ends[0], params)
        pairs = zip(ends, key_points, strict=True)
        are_plain = any(is_blank(view.picture(end), [view.points(points)], params.blank) for end, points in pairs)
    except MissingFrame:
        yield from frames  # filling the gap says what is wrong
        return
    for frame in frames:
        try:
            picture = PreparedFrame(PreparedFrame(read(frame)).image)  # where its file is damaged shows now
        except MissingFrame:
            continue
        outline = view.points(shape.at(frame).points)
        if are_plain or not is_blank(view.picture(picture), [outline], params.blank):
            yield frame
