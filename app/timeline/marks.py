"""KeyMarks: what a row of the timeline shows of a shape, as arrays of frame numbers."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from app.document import Document
from roam_core.params import DOUBTFUL
from roam_core.propagate import provenance
from roam_core.roto import Clip, Interpolation, Keyframe, Origin, RotoShape

Frames = NDArray[np.int64]
UNKNOWN = "unknown"
"""The stamp that no key bears."""


@dataclass(frozen=True)
class KeyMarks:
    """Frames by what lies on them: `artist` keys; `engine` frames that are trusted, `doubtful` or `stale`.

    `smooth` and `held` are those of the artist's keys from which the shape does not move on evenly. `confidence` are
    pairs (frame, confidence) `(K, 2)` of all engine frames, in the order of time.
    """

    artist: Frames
    engine: Frames
    doubtful: Frames
    stale: Frames
    smooth: Frames
    held: Frames
    confidence: NDArray[np.float64]

    @property
    def keyed(self) -> Frames:
        """Every frame that holds a key, in the order of time."""
        return np.sort(np.concatenate([self.artist, self.engine, self.doubtful, self.stale]))

    def kind_at(self, frame: int) -> str:
        """The name of the field that tells of this frame; empty where there is no key."""
        kinds = ("artist", "engine", "doubtful", "stale")
        return next((kind for kind in kinds if frame in getattr(self, kind)), "")


def key_marks(shape: RotoShape, clip: Clip | None) -> KeyMarks:
    """The marks of a shape of a project with this clip."""
    artist, engine, doubtful, stale = [], [], [], []
    confidence = []
    stamps = _Stamps(shape, clip)
    for key in shape.keys:
        if key.origin is Origin.ARTIST:
            artist.append(key.frame)
            continue
        trust = 1.0 if key.confidence is None else key.confidence
        confidence.append((key.frame, trust))
        if stamps.is_stale(key, len(artist)):
            stale.append(key.frame)
        elif trust < DOUBTFUL:
            doubtful.append(key.frame)
        else:
            engine.append(key.frame)
    moves = {key.frame: key.interpolation for key in shape.keys}
    return KeyMarks(
        _frames(artist),
        _frames(engine),
        _frames(doubtful),
        _frames(stale),
        _frames([frame for frame in artist if moves[frame] is Interpolation.SMOOTH]),
        _frames([frame for frame in artist if moves[frame] is Interpolation.HOLD]),
        np.asarray(confidence, dtype=np.float64).reshape(-1, 2),
    )


def _frames(numbers: list[int]) -> Frames:
    return np.asarray(numbers, dtype=np.int64)


class MarksOf:
    """The marks of each shape, made anew only for a shape that is another value than before."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._known: dict[str, tuple[RotoShape, KeyMarks]] = {}
        document.replaced.connect(self._known.clear)

    def __call__(self, shape: RotoShape) -> KeyMarks:
        known = self._known.get(shape.id)
        if known is None or known[0] is not shape:
            known = self._known[shape.id] = (shape, key_marks(shape, self._document.project.clip))
        return known[1]


class _Stamps:
    """`provenance.is_stale` for all keys of one shape, asked once for each stamp in each span instead of for each key.

    A span is told by the number of artist's keys before it.
    """

    def __init__(self, shape: RotoShape, clip: Clip | None) -> None:
        self._shape, self._clip = shape, provenance.clip_stamp(clip)
        self._artist = [key for key in shape.keys if key.origin is Origin.ARTIST]
        self._known: dict[tuple[str, int], bool] = {}

    def is_stale(self, key: Keyframe, span: int) -> bool:
        known = self._known.get((key.inputs, span))
        if known is None:
            known = self._known[key.inputs, span] = self._stamp(key, span) != key.inputs
        return known

    def _stamp(self, key: Keyframe, span: int) -> str:
        """What the key would bear if it were made now; nothing where it could not be, or nobody knows how it was."""
        direction, _, rest = key.inputs.partition(":")
        params = provenance.known_params(rest.partition(":")[0])
        if params is None:
            return UNKNOWN
        if direction == "fill":
            return provenance.fill_stamp(self._shape, key.frame, params, self._clip)
        source = span - 1 if direction == "forward" else span
        if not 0 <= source < len(self._artist):
            return UNKNOWN
        return provenance.stamp(
            self._artist[source], self._shape.closed, params, self._clip, forward=direction == "forward"
        )
