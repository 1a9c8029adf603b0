"""Parameters of looking for an object that was lost."""

from __future__ import annotations

from dataclasses import dataclass

from roam_core.params.stamped import later


@dataclass(frozen=True)
class KeypointParams:
    """Parameters of keypoints that are known again (`motion.keypoints`). Lengths are pixels of a 480-line image.

    Attributes
    ----------
    clearly : share of the distance of the next best one that the best one's may have (Lowe, 7.1).
    fewest : keypoints that must agree. near : pixels by which they may miss. trials : pairs that are tried.
    sizes : times that the object may have become larger or smaller since it was last seen.
    """

    clearly: float = 0.8
    fewest: int = 5
    near: float = 4.0
    trials: int = 512
    sizes: float = 2.0


@dataclass(frozen=True)
class RedetectionParams:
    """Parameters of looking for an object as it was on its key (`propagate.frame.redetection`).

    Attributes
    ----------
    across : cells across the object (the root of its area) at which it is looked for.
    sizes : sizes that are tried, in relation to the last one that was sure; and of more, each by the last of them, up
        to the largest that was.
    alike : share of the key's own score from which a place is the object's.
    alone : share of the best score that no other place may have.
    ring : width of the surroundings that must look unlike the object, in roots of its area.
    clip : bound on the log-ratio of a cell, nats.
    lost : share of the area that it should have under which an object is lost.
    whole : share of it from which its size and turn are sure; of less, all that the key expects is looked at.
    almost : resemblance from which they are.
    least, distinct : root of its area on the key in pixels, and nats by which it differs there from its
        surroundings, from which it can be known again by its colours.
    posed : share of `RegionParams.doubted` under which an object is looked for that is held to its pose.
    long_gone, sometimes : frames unseen after which an object is looked for on every fourth frame only; and frames on
        which what has come back is still looked for.
    near, pace : roots of its area around its last place within which an object is looked for, and by how many more
        a frame unseen.
    keypoints : of the object, by which it is known again.
    """

    across: float = 16.0
    sizes: tuple[float, float, float] = (0.8, 1.0, 1.25)
    alike: float = 0.6
    alone: float = 0.8
    ring: float = 0.5
    clip: float = 3.0
    lost: float = 0.1
    whole: float = 0.5
    almost: float = 0.8
    least: float = 12.0
    distinct: float = 2.0
    posed: float = later(0.85)
    long_gone: int = 8
    sometimes: int = 4
    near: float = 2.0
    pace: float = 0.5
    keypoints: KeypointParams = later(KeypointParams())
