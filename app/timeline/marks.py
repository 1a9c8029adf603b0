"""KeyMarks: what a row of the timeline shows of a shape, as arrays of frame numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from roam_core.arrays import Array, Int64
from roam_core.params import DOUBTFUL
from roam_core.propagate.shapes.provenance import Stamps
from roam_core.roto import Interpolation, Origin, Project, RotoShape
from roam_core.roto.imported import is_import

from ..model.document import Document


@dataclass(frozen=True)
class KeyMarks:
    """Frames by what lies on them: `artist` keys; `engine` frames that are trusted, `doubtful` or `stale`.

    `smooth` and `held` are those of the artist's keys from which the shape does not move on evenly; `partial` those on
    which the artist set some of the points. `confidence` are
    pairs (frame, confidence) `(K, 2)` of all engine frames but those of a file that was read, in the order of time.
    On a frame on which the shape does not exist nothing is in doubt.
    """

    artist: Int64
    engine: Int64
    doubtful: Int64
    stale: Int64
    smooth: Int64
    held: Int64
    partial: Int64
    confidence: Array

    @property
    def keyed(self) -> Int64:
        """Every frame that holds a key, in the order of time."""
        return np.sort(np.concatenate([self.artist, self.engine, self.doubtful, self.stale]))

    def kind_at(self, frame: int) -> str:
        """The name of the field that tells of this frame; empty where there is no key."""
        kinds = ("artist", "engine", "doubtful", "stale")
        return next((kind for kind in kinds if frame in getattr(self, kind)), "")


def key_marks(shape: RotoShape, stale_frames: Sequence[int]) -> KeyMarks:
    """The marks of a shape whose keys on these frames are stale."""
    keys = shape.keys
    frames = _frames([key.frame for key in keys])
    by_hand = np.array([key.origin is Origin.ARTIST for key in keys], dtype=bool)
    trust = np.array([1.0 if key.confidence is None else key.confidence for key in keys], dtype=np.float64)
    read = np.array([is_import(key) for key in keys], dtype=bool)  # nobody looked for it in the plate
    first, stop = shape.lifetime or (-math.inf, math.inf)
    is_there, stale = (frames >= first) & (frames < stop), np.zeros(len(frames), dtype=bool)
    stale[np.searchsorted(frames, _frames(stale_frames))] = True
    doubtful = (trust < DOUBTFUL) & is_there
    drawn = shape.artist_keys
    return KeyMarks(
        frames[by_hand],
        frames[~by_hand & ~stale & ~doubtful],
        frames[~by_hand & ~stale & doubtful],
        frames[~by_hand & stale],
        _frames([key.frame for key in drawn if key.interpolation is Interpolation.SMOOTH]),
        _frames([key.frame for key in drawn if key.interpolation is Interpolation.HOLD]),
        _frames([key.frame for key in drawn if key.set_points]),
        np.column_stack([frames, trust])[~by_hand & is_there & ~read],
    )


def on_each_frame(worst: np.ufunc, values: Sequence[Array]) -> Array:
    """The `worst` of several shapes' values on each frame, as pairs (frame, value) `(K, 2)` in the order of time."""
    pairs = np.concatenate([*values, np.empty((0, 2))])
    if not len(pairs):
        return pairs
    pairs = pairs[np.argsort(pairs[:, 0], kind="stable")]
    starts = np.flatnonzero(np.append(True, np.diff(pairs[:, 0]) > 0))
    return np.column_stack([pairs[starts, 0], worst.reduceat(pairs[:, 1], starts)])


def _frames(numbers: Sequence[int]) -> Int64:
    return np.asarray(numbers, dtype=np.int64)


@dataclass(frozen=True, eq=False)
class _Known:
    """The marks of a shape, and what they were told from."""

    shape: RotoShape
    together: tuple[RotoShape, ...]
    stale: list[int]
    marks: KeyMarks


class MarksOf:
    """The marks of each shape, made anew only where it, or what of it is stale, is another than before.

    An edit of one shape of an object asks of all its shapes what of them is stale now: of hundreds few become others.
    """

    def __init__(self, document: Document) -> None:
        self._document = document
        self._known: dict[str, _Known] = {}
        self._stamps: tuple[Project, Stamps] | None = None
        document.replaced.connect(self._known.clear)

    def __call__(self, shape: RotoShape, preview: Project | None = None) -> KeyMarks:
        """The marks of a shape of the document's project, or of one that is shown in its place meanwhile."""
        stamps = self._of(preview or self._document.project)
        together, known = stamps.together(shape), self._known.get(shape.id)
        if known is None or not _are_same(known.together, together):
            stale = stamps.stale_frames(shape)
            is_told = known is not None and _have_same_keys(known.shape, shape) and known.stale == stale
            marks = known.marks if known is not None and is_told else key_marks(shape, stale)
            known = self._known[shape.id] = _Known(shape, together, stale, marks)
        return known.marks

    def _of(self, project: Project) -> Stamps:
        if self._stamps is None or self._stamps[0] is not project:
            self._stamps = project, Stamps.of(project.shapes, project.clip)
        return self._stamps[1]


def _have_same_keys(a: RotoShape, b: RotoShape) -> bool:
    """Whether all that marks tell of is the same: a shape that was hidden or renamed has no other ones."""
    return a is b or (a.lifetime == b.lifetime and _are_same(a.keys, b.keys))


def _are_same(a: Sequence[object], b: Sequence[object]) -> bool:
    return a is b or (len(a) == len(b) and all(x is y for x, y in zip(a, b, strict=True)))
