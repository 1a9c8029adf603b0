"""KeyMarks: what a row of the timeline shows of a shape, as arrays of frame numbers."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from weakref import ref

import numpy as np

from roam_core.arrays import Array, Int64
from roam_core.params import DOUBTFUL
from roam_core.propagate.shapes.known_stamps import stamps_of
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
        self._of_projects: dict[int, tuple[ref[Project], dict[int, KeyMarks]]] = {}
        """Of each project that lives the marks of its shapes, by identities: undo and redo bring it back."""
        document.replaced.connect(self._known.clear)

    def __call__(self, shape: RotoShape, preview: Project | None = None) -> KeyMarks:
        """The marks of a shape of the document's project, or of one that is shown in its place meanwhile."""
        project = preview or self._document.project
        if not (project.has(shape.id) and project.shape(shape.id) is shape):  # a value that no project keeps alive
            return self._told(shape, project)
        marks = self._of(project)
        if id(shape) not in marks:
            marks[id(shape)] = self._told(shape, project)
        return marks[id(shape)]

    def _of(self, project: Project) -> dict[int, KeyMarks]:
        """What is known of a project."""
        own, known = id(project), self._of_projects
        if own not in known or known[own][0]() is not project:
            known[own] = ref(project, lambda gone: _forget(known, own, gone)), {}
        return known[own][1]

    def _told(self, shape: RotoShape, project: Project) -> KeyMarks:
        """The marks, by those of the last value of the shape as far as these hold."""
        stamps = stamps_of(project)
        together, known = stamps.together(shape), self._known.get(shape.id)
        if known is None or not _are_same(known.together, together):
            stale = stamps.stale_frames(shape)
            is_told = known is not None and _have_same_keys(known.shape, shape) and known.stale == stale
            marks = known.marks if known is not None and is_told else key_marks(shape, stale)
            known = self._known[shape.id] = _Known(shape, together, stale, marks)
        return known.marks


def _forget(known: dict[int, tuple[ref[Project], dict[int, KeyMarks]]], own: int, gone: ref[Project]) -> None:
    """Let go of what is known of a project that is gone, unless another one has its identity already."""
    if own in known and known[own][0] is gone:
        del known[own]


def _have_same_keys(a: RotoShape, b: RotoShape) -> bool:
    """Whether all that marks tell of is the same: a shape that was hidden or renamed has no other ones."""
    return a is b or (a.lifetime == b.lifetime and _are_same(a.keys, b.keys))


def _are_same(a: Sequence[object], b: Sequence[object]) -> bool:
    return a is b or (len(a) == len(b) and all(x is y for x, y in zip(a, b, strict=True)))
