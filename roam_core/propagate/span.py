"""Between two keys: an object carried from both ends of a span at once, and the two passages merged on every frame."""

from __future__ import annotations

import threading
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import cached_property, partial
from itertools import pairwise
from typing import Any

from numpy.typing import NDArray

from roam_core.cancel import CancelToken, Progress
from roam_core.errors import RoamError
from roam_core.features import PreparedFrame
from roam_core.media.source import MissingFrame
from roam_core.params import RegionParams, RoamParams, params_for, scale_for
from roam_core.propagate import provenance
from roam_core.propagate.merge import Colours, Merged, merged
from roam_core.propagate.objects import objects
from roam_core.propagate.passage import Passage, passage
from roam_core.propagate.result import Part
from roam_core.propagate.run import NEAR
from roam_core.propagate.witness import Key, Span
from roam_core.roto import BlendMode, Keyframe, Origin, RotoShape
from roam_core.roto.edit import set_engine_keys
from roam_core.threads import each


def fill_span(
    images: Mapping[int, NDArray[Any]],
    shapes: Sequence[RotoShape],
    start: int,
    stop: int,
    config: str | RoamParams = "best",
    token: CancelToken | None = None,
    progress: Progress | None = None,
    clip: str = "",
) -> list[RotoShape]:
    """The shapes with ENGINE keys on the frames between their artist keys, from `start` to `stop`.

    Each gap between two neighbouring artist keys is one span: the object is carried forward from the first and
    backward from the second, each on a thread of its own, and both are merged with the motion of the object as one
    piece, each believed as far as it met the other key (`propagate.witness`), and with what the colours of both keys
    say (`proposal.key_colours`). Shapes of one object with the same keys are filled together. A shape that ends between
    two keys of its object is carried on from its last key; one that begins or ends on a key gets no keys, but tells how
    much of the object the others do not show there.

    Parameters
    ----------
    images : gives the picture of a frame, (h, w, 3) RGB, uint8 or float32 in [0, 1]; each is asked for three times,
        in no particular order, by one thread at a time. A `MissingFrame` is passed over.
    start, stop : the first and the last frame, both of which hold artist keys. Artist keys come back as they were.

    Raises
    ------
    RoamError
        when no shape has artist keys on two frames of the range, or a shape to be filled is open.
    Cancelled
        at a safe point after `token` was cancelled.
    """
    gaps = spans(shapes, start, stop)
    if not gaps:
        raise RoamError(
            f"There is nothing to fill from frame {start} to {stop}: no shape has artist keys on two frames of that "
            "range. Set a key at both ends first."
        )
    meter = _Meter(sum(2 * (last - first) for first, last, _ in gaps), progress)
    filling = Filling(Reader(images), params_for(config), clip, meter, token)
    result = list(shapes)
    for first, last, members in gaps:
        for k, shape in zip(members, filling.filled([result[k] for k in members], first, last), strict=True):
            result[k] = shape
    return result


def spans(shapes: Sequence[RotoShape], start: int, stop: int) -> list[tuple[int, int, list[int]]]:
    """`(first, last, which shapes)` for every gap between neighbouring artist keys in the range.

    With the shapes that have keys on both ends go those that end, or begin, there.
    """
    gaps: dict[tuple[int, int], list[int]] = {}
    for k, shape in enumerate(shapes):
        frames = [frame for frame in shape.artist_frames if start <= frame <= stop]
        for pair in pairwise(frames):
            if pair[1] - pair[0] > 1 and any(shape.exists_at(frame) for frame in range(*pair)):
                gaps.setdefault(pair, []).append(k)
    for k, shape in enumerate(shapes):
        for gap, members in gaps.items():
            if k not in members and _is_on_one_end(shape, gap):
                members.append(k)
    return [(first, last, sorted(members)) for (first, last), members in sorted(gaps.items())]


def _is_on_one_end(shape: RotoShape, gap: tuple[int, int]) -> bool:
    """True for a shape that is keyed on one end of the gap only, and does not live on to the other.

    If it does not even live within, it still says which part of the object the others do not show there.
    """
    first, last = (frame in shape.artist_frames for frame in gap)
    if first == last or not shape.closed:
        return False
    there, here = (shape.exists_at(frame) for frame in gap)
    return there != here


class Reader:
    """Pictures made ready, asked for by one thread at a time; none is kept, for a span may be long and its plate 4K."""

    def __init__(self, images: Mapping[int, NDArray[Any]]) -> None:
        self._images = images
        self._lock = threading.Lock()

    def __call__(self, frame: int) -> PreparedFrame:
        with self._lock:
            try:
                image = self._images[frame]
            except KeyError:
                raise RoamError(f"There is no image of frame {frame}; every frame of a span is looked at.") from None
        return PreparedFrame(image)


class _Meter:
    """Progress over all passages, whichever thread they run on."""

    def __init__(self, total: int, progress: Progress | None) -> None:
        self._total, self._done, self._progress = max(total, 1), 0, progress
        self._lock = threading.Lock()

    def passed(self) -> None:
        with self._lock:
            self._done += 1
            if self._progress is not None:
                self._progress(self._done / self._total, "Filling between keys")


@dataclass(frozen=True, eq=False)
class Filling:
    """What all spans of one call share."""

    read: Reader
    params: RoamParams
    clip: str = ""
    meter: _Meter | None = None
    token: CancelToken | None = None

    def filled(self, shapes: Sequence[RotoShape], first: int, last: int) -> list[RotoShape]:
        """The shapes of one gap with its ENGINE keys, solved object by object."""
        result = list(shapes)
        for members, span in self.objects(shapes, first, last):
            made: list[list[Keyframe]] = [[] for _ in members]
            between = range(first + 1, last)
            ours = [shapes[k] for k in members]
            for frame, solved in zip(between, each(partial(self.solved, span, ours), between), strict=True):
                for shape, keyed, found in zip(ours, made, solved, strict=True):
                    if found is not None:
                        keyed.append(_engine_key(shape, frame, found, self.params, self.clip))
            for k, keyed in zip(members, made, strict=True):
                result[k] = set_engine_keys(shapes[k], keyed)
        return result

    @cached_property
    def finer(self) -> RoamParams:
        """The parameters for cells as they are between keys."""
        region = self.params.region
        if region is None:
            return self.params
        return replace(self.params, region=replace(region, grid_factor=region.fill_factor))

    def objects(self, shapes: Sequence[RotoShape], first: int, last: int) -> Iterator[tuple[list[int], Span]]:
        """Each object of a gap that lives in it, by the indices of its shapes, with both of its passages."""
        keys = _key(shapes, first), _key(shapes, last)
        size = self.read(first).size
        for members in _grouped(keys, NEAR * scale_for(size)):
            if not any(shapes[k].exists_at(frame) for k in members for frame in range(first + 1, last)):
                continue
            ends = [Key(key.frame, tuple(key.parts[k] for k in members)) for key in keys]
            yield members, self._passed(ends[0], ends[1], size)

    def solved(self, span: Span, shapes: Sequence[RotoShape], frame: int) -> list[Merged | None]:
        """The outlines of an object's shapes on a frame between its keys; None for those that are not there."""
        if self.token is not None:
            self.token.check()
        alive = [k for k, shape in enumerate(shapes) if shape.exists_at(frame)]
        return merged(span, frame, alive, self._colours(frame) if alive else None)

    def _colours(self, frame: int) -> Colours | None:
        """The picture of a frame as something to go by; None where it is missing, or not asked."""
        params = self.finer.region
        if params is None or params.keys_weight == 0:
            return None
        try:
            return Colours(self.read(frame), params)
        except MissingFrame:
            return None

    def _passed(self, first: Key, last: Key, size: tuple[int, int]) -> Span:
        """Both passages of one object, side by side."""
        frames = range(first.frame, last.frame + 1)
        ahead, behind = each(lambda way: self._passage(*way), [(first, frames), (last, frames[::-1])])
        return Span(first, last, ahead, behind, size, scale_for(size), self.params.region or RegionParams())

    def _passage(self, key: Key, frames: range) -> Passage | None:
        parts = [part for part in key.parts if part is not None]
        if not parts:
            return None
        return passage(
            self.read, parts, frames, self.finer, self.token, None if self.meter is None else self.meter.passed
        )


def _key(shapes: Sequence[RotoShape], frame: int) -> Key:
    parts: list[Part | None] = []
    for shape in shapes:
        key = shape.key_at(frame)
        if key is None or key.origin is not Origin.ARTIST:
            parts.append(None)
            continue
        if not shape.closed:
            raise RoamError(f"{shape.name!r} is open; close it (C) before it can be filled.")
        parts.append(Part(key.points, shape.blend is BlendMode.SUBTRACT))
    return Key(frame, tuple(parts))


def _grouped(keys: tuple[Key, Key], gap: float) -> list[list[int]]:
    """Which outlines belong to one object: those that do on either key."""
    count = len(keys[0].parts)
    owner = list(range(count))
    for key in keys:
        for group in objects([part for part in key.parts if part is not None], gap):
            members = [key.members[k] for k in group]
            first = min(owner[k] for k in members)
            joined = {owner[k] for k in members}
            owner = [first if each in joined else each for each in owner]
    return [[k for k in range(count) if owner[k] == each] for each in sorted(set(owner))]


def _engine_key(shape: RotoShape, frame: int, merged: Merged, params: RoamParams, clip: str) -> Keyframe:
    """The key for a merged outline; feather goes over from the one artist key to the other."""
    artist = RotoShape(shape.id, shape.name, tuple(key for key in shape.keys if key.origin is Origin.ARTIST))
    return Keyframe(
        frame,
        merged.points,
        feather=artist.at(frame).feather,
        origin=Origin.ENGINE,
        confidence=merged.confidence,
        vertex_confidence=merged.vertex_confidence,
        inputs=provenance.fill_stamp(shape, frame, params, clip),
    )
