"""The landmarks of a tracking run as tracks of Nuke's Tracker4: a node for each shape, a track for each landmark."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

import numpy as np

from roam_core.arrays import Array
from roam_core.atomic_write import write_atomically
from roam_core.errors import RoamError
from roam_core.interchange.nuke.text import HEAD
from roam_core.interchange.nuke.tracks import Track, tracker_node
from roam_core.propagate.frame.result import FrameResult, Landmarks
from roam_core.roto import Clip
from roam_core.translatable import sentence

LEAST_FRAMES = 5
"""Frames on which a landmark must be found to become a track; all of them in a shorter run.

What is lost sooner says little of the motion. Where it has too few, the pool detects new landmarks every five frames,
and some of these are never found again.
"""

MOST_TRACKS = 100
"""Tracks of one node: those of the longest lives. A pool holds 40 at a time but is renewed through a long shot, and
nobody finds what he looks for among hundreds of rows."""


class Mark(NamedTuple):
    """Who a landmark of a shape is: the frame of the outline that it goes back to, and its id among those that do."""

    learned_on: int
    id: int


@dataclass
class ShapePaths:
    """Where the landmarks of one shape were.

    Attributes
    ----------
    name : of the shape. frames : on which its landmarks were looked for, in the order of the run.
    places : for each landmark its position (2,) on the frames on which it was found.
    """

    name: str
    frames: list[int] = field(default_factory=list)
    places: dict[Mark, dict[int, Array]] = field(default_factory=dict)

    @property
    def least(self) -> int:
        """Frames on which a landmark must have been found to become a track."""
        return max(1, min(LEAST_FRAMES, len(self.frames)))

    @property
    def lasting(self) -> list[Mark]:
        """The landmarks that were found on enough frames, the oldest first."""
        return sorted(mark for mark, known in self.places.items() if len(known) >= self.least)

    def add(self, frame: int, landmarks: Landmarks) -> None:
        """Take up the landmarks of one more frame, or others for one that is known."""
        if frame in self.frames:
            for known in self.places.values():
                known.pop(frame, None)
        else:
            self.frames.append(frame)
        for number, position in zip(landmarks.ids.tolist(), landmarks.positions, strict=True):
            self.places.setdefault(Mark(landmarks.learned_on, number), {})[frame] = position

    def tracks(self) -> list[Track]:
        """One track for each of the landmarks of the longest lives, the oldest first."""
        longest = sorted(self.lasting, key=lambda mark: -len(self.places[mark]))[:MOST_TRACKS]
        return [self._track(mark) for mark in sorted(longest)]

    def _track(self, mark: Mark) -> Track:
        known = self.places[mark]
        frames = sorted(known)
        return Track(f"{self.name} {mark.learned_on}-{mark.id}", frames, np.stack([known[frame] for frame in frames]))

    def notes(self) -> list[str]:
        """What somebody who opens the tracks should know."""
        found, of = self.lasting, f"of {self.name!r}"
        if not found:
            return [f"No landmark {of} was found on {self.least} frames or more; it has no tracks."]
        notes = []
        if len(found) > MOST_TRACKS:
            notes.append(f"Of {len(found)} landmarks {of} the {MOST_TRACKS} of the longest lives were written.")
        if max(len(self.places[mark]) for mark in found) < len(self.frames):
            notes.append(f"No landmark {of} was found on every frame: in Nuke, tick T, R and S of those to go by.")
        return notes


class LandmarkPaths:
    """Where the landmarks of all shapes were, gathered from the results of a run, or of one in each direction."""

    def __init__(self) -> None:
        self._shapes: dict[str, ShapePaths] = {}

    @classmethod
    def of(cls, results: Iterable[FrameResult]) -> LandmarkPaths:
        """Those of finished results, the run's first frame (`begun` of `roam_core.propagate.run.track`) among them."""
        paths = cls()
        for result in results:
            paths.add(result)
        return paths

    @property
    def shapes(self) -> tuple[ShapePaths, ...]:
        """Those of each shape, in the order in which the shapes are tracked."""
        return tuple(self._shapes.values())

    def add(self, result: FrameResult) -> None:
        """Take up one more frame."""
        for each in result.results:
            paths = self._shapes.setdefault(each.shape.id, ShapePaths(each.shape.name))
            if each.landmarks is not None:
                paths.add(each.frame, each.landmarks)


def write_landmarks(paths: LandmarkPaths, clip: Clip, path: Path, frame_offset: int = 0) -> tuple[str, ...]:
    """Write a script with one Tracker4 node for each shape; it appears under its name only when it is whole.

    A track has keys on the frames on which its landmark was found and is enabled on those; it is called after the
    shape, the frame of the outline that the landmark goes back to, and its id. T, R and S are ticked for landmarks that
    were found on every frame; the node's transform is none on the run's first.

    Parameters
    ----------
    paths : of the landmarks (`LandmarkPaths.of` the results of a run).
    clip : that was tracked.
    path : of the `.nk` file.
    frame_offset : added to all frames.

    Returns
    -------
    One sentence for each shape that has no track, for one with too many, and for one of whose none lasts to the end.

    Raises
    ------
    RoamError
        when no landmark was found on enough frames, or the file cannot be written.
    """
    nodes = []
    for shape in paths.shapes:
        tracks = shape.tracks()
        if tracks:
            label = f"Landmarks of {shape.name}"
            nodes.append(tracker_node(tracks, clip, shape.frames[0], frame_offset, shape.frames, label))
    if not nodes:
        least = max((shape.least for shape in paths.shapes), default=1)
        raise RoamError(
            sentence(
                "No landmark was found on {least} frame(s) or more; {path} was not written.", least=least, path=path
            )
        )
    write_atomically(path, (HEAD + "".join(nodes)).encode("utf-8"))
    return tuple(note for shape in paths.shapes for note in shape.notes())
