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
    (`features.blank`): that show nothing where the pictures of the keys show something. Each is read whole, when it is
    asked for.
    """
    ends = [(picture, frame) for frame in gap if (picture := _whole(read, frame)) is not None]
    if not ends:
        yield from frames  # filling the gap says what is wrong
        return
    view = EngineView.of_key(ends[0][0], params)

    def shows_nothing(picture: PreparedFrame, frame: int) -> bool:
        return is_blank(view.picture(picture), [view.points(shape.at(frame).points)], params.blank)

    are_plain = any(shows_nothing(*end) for end in ends)
    for frame in frames:
        picture = _whole(read, frame)
        if picture is not None and (are_plain or not shows_nothing(picture, frame)):
            yield frame


def _whole(read: ReadFrame, frame: int) -> PreparedFrame | None:
    """The picture of a frame, read whole: where its file is damaged shows then. None where there is none."""
    try:
        return PreparedFrame(PreparedFrame(read(frame)).image)
    except MissingFrame:
        return None
