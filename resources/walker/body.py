"""How the figure is built and how it walks: ten parts on joints, each drawn once in coordinates of its own.

A part lies along +x from the joint that it hangs on; lengths are in hundredths of the figure's height. The torso
stands on the hips. The figure walks to the right; a mirrored one is turned over as a whole.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ORDER = (
    "far upper arm",
    "far lower arm",
    "far lower leg",
    "far upper leg",
    "near lower leg",
    "near upper leg",
    "head",
    "torso",
    "near lower arm",
    "near upper arm",
)
"""The parts as they are stacked, the farthest first."""

_ANCHORS = {
    "upper arm": "-4.2,0 -2.5,-3.7 6,-3.7 14,-3 18.6,-2.5 19.9,0 18.6,2.6 13,3.2 5,3.9 -2.5,3.8",
    "lower arm": "-3,0 -1.8,-2.6 5,-3 13,-2.1 17.5,-2.7 22,-2 24,0 22,1.9 17.5,2.3 13,2 5,2.9 -1.8,2.6",
    "upper leg": "-6,0 -3.5,-6.2 8,-6.5 19,-4.8 26.4,-3.8 28.6,0 26.4,4 17,5 7,7 -3.5,6.4",
    "lower leg": "-4,0 -2.6,-3.5 6,-3.5 17,-2.8 22.3,-3.2 24.6,-9 27.1,-9.8 27.5,-2 26.9,3 23,3.4 17,3 8,4.7 -1,4.1",
    "torso": "-7,0 -5,6.2 4,6.6 14,6.4 23,6.9 29,5.4 32.5,1.6 32.4,-2.6 29,-6.2 22,-7.5 12,-6.5 3,-6.3 -5,-6.7",
    "head": "-2.6,0 -1.5,2.7 3.6,3 4.8,6.3 8.5,6.7 10,8 13.5,6.8 18,4.3 20,0 18,-5 13.5,-7.3 7.4,-6 2.8,-3.5 -1.5,-3",
}
"""Places `x,y` through which the outline of a part runs, in its own coordinates."""

_JOINTS = {"lower arm": 16.5, "lower leg": 24.5}
"""How far from its own joint a limb's upper part carries its lower one."""


@dataclass(frozen=True)
class Gait:
    """What one figure does its own way: angles in radians, `period` in frames, `phase` where the walk begins."""

    period: float
    phase: float
    hips: float
    knees: float
    arms: float
    elbows: float
    lean: float
    turn: float
    swell: float

    @classmethod
    def drawn(cls, rng: np.random.Generator) -> Gait:
        """A gait that begins with the legs apart and the far arm ahead, so that all ten parts can be seen."""
        degrees = np.radians
        return cls(
            period=rng.uniform(27.0, 34.0),
            phase=rng.uniform(-0.35, 0.25),
            hips=float(degrees(rng.uniform(24.0, 29.0))),
            knees=float(degrees(rng.uniform(38.0, 52.0))),
            arms=float(degrees(rng.uniform(31.0, 40.0))),
            elbows=float(degrees(rng.uniform(12.0, 24.0))),
            lean=float(degrees(rng.uniform(2.0, 6.0))),
            turn=rng.uniform(0.0, 2.0 * np.pi),
            swell=rng.uniform(0.03, 0.05),
        )

    @property
    def speed(self) -> float:
        """Hundredths of the height walked in a frame: two steps a period."""
        return 4.0 * 51.0 * float(np.sin(self.hips)) / self.period


@lru_cache(maxsize=len(_ANCHORS))
def rest_points(kind: str) -> Array:
    """The outline `(P, 3, 2)` of a part in its own coordinates: anchor, in- and out-handle."""
    anchors = np.array([[float(v) for v in word.split(",")] for word in _ANCHORS[kind].split()])
    ahead, behind = np.roll(anchors, -1, axis=0), np.roll(anchors, 1, axis=0)
    along = ahead - behind
    along /= np.hypot(*along.T)[:, None]
    # Handles a third of the way to either neighbour: smooth, and without loops where neighbours lie close.
    back, on = (np.hypot(*(other - anchors).T)[:, None] / 3.0 for other in (behind, ahead))
    return np.stack([anchors, anchors - back * along, anchors + on * along], axis=1)


def kind_of(part: str) -> str:
    """What a part is, whichever side it is on: "far upper arm" -> "upper arm"."""
    return part.removeprefix("far ").removeprefix("near ")


def pose(gait: Gait, time: float) -> dict[str, Array]:
    """The affine motion `(3, 3)` of every part at `time` in frames: own coordinates to those of the hips, y down."""
    walk = gait.phase + 2.0 * np.pi * time / gait.period
    torso = _placed(-np.pi / 2.0 + gait.lean + 0.02 * np.sin(2.0 * walk), (0.0, 0.0), *_swollen(gait, walk, 1.0))
    nod = torso @ _placed(0.05 * np.sin(2.0 * walk + 0.8) - gait.lean, (30.0, 0.0), *_swollen(gait, walk, 2.0))
    found = {"torso": torso, "head": nod}
    for side, angle, shoulder, hip in (("near", walk, -1.8, 1.2), ("far", walk + np.pi, 5.6, -2.2)):
        thigh = np.pi / 2.0 - gait.hips * np.cos(angle) - 0.06
        bent = 0.12 + gait.knees * ((1.0 + np.cos(angle - 1.42 * np.pi)) / 2.0) ** 2
        found |= _limb(gait, f"{side} upper leg", f"{side} lower leg", thigh, bent, np.array([hip, 0.5]), angle)
        # The arm of a side swings against the leg of that side; an elbow bends to the front, a knee to the back.
        arm = np.pi / 2.0 + gait.arms * np.cos(angle) - 0.16
        bent = -gait.elbows * (1.3 - np.cos(angle + 0.5))
        place = (torso @ (27.0, shoulder, 1.0))[:2]
        found |= _limb(gait, f"{side} upper arm", f"{side} lower arm", arm, bent, place, angle + 1.0)
    return found


def _limb(
    gait: Gait, upper: str, lower: str, angle: float, bend: float, place: Array, phase: float
) -> dict[str, Array]:
    """Two parts in a row; the lower one keeps the width of its own."""
    first = _placed(angle, place, *_swollen(gait, phase, 3.0))
    joint = (first @ (_JOINTS[kind_of(lower)], 0.0, 1.0))[:2]
    return {upper: first, lower: _placed(angle + bend, joint, *_swollen(gait, phase, 4.0))}


def _swollen(gait: Gait, walk: float, which: float) -> tuple[float, float]:
    """How long and how wide a part looks: it turns towards the camera and away, and its cloth hangs anew."""
    return (
        1.0 - gait.swell * (1.0 + float(np.sin(walk + gait.turn + which))),
        1.0 + gait.swell * float(np.sin(walk + 2.0 * gait.turn + 1.7 * which)),
    )


def _placed(angle: float, place: Array | tuple[float, float], length: float, width: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c * length, -s * width, place[0]], [s * length, c * width, place[1]], [0.0, 0.0, 1.0]])
