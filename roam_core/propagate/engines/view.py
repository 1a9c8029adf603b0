"""How an engine that works with regions sees pictures: without bars, few lines enlarged, little contrast stretched.

Lengths of the engine are those of a picture of 480 lines. In one of fewer, seen as it is, a cell would be two of its
pixels: too coarse for what is small there. Its differences of colour are those of a picture of the usual contrast
(`features.levels`). Black bars around a picture are beyond its edge (`features.active_area`). The key tells, and all
frames that are reached from it are seen so.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING

import numpy as np

from roam_core.arrays import Array
from roam_core.cancel import CancelToken
from roam_core.features import PreparedFrame, Region
from roam_core.features.active_area import active_area
from roam_core.features.levels import Levels
from roam_core.params import RoamParams, enlargement_for

if TYPE_CHECKING:  # whole engines: which frames are blank is told without them
    from roam_core.propagate.engines.protocol import Account, Engine, Step
    from roam_core.propagate.frame.result import Part, StepResult


@dataclass(frozen=True)
class EngineView:
    """How an engine sees the pictures of a shot, and the outlines on them.

    Attributes
    ----------
    size : (h, w) of the pictures. window : what the engine sees of them.
    seen : (h, w) at which it sees that.
    levels : by which it sees it; None: as it is.
    """

    size: tuple[int, int]
    window: Region
    seen: tuple[int, int]
    levels: Levels | None = None

    @classmethod
    def of_key(cls, picture: PreparedFrame, params: RoamParams) -> EngineView:
        """For all frames that are reached from a key, of which this is the picture.

        An engine of curves alone sees them as they are.
        """
        size, region = picture.size, params.region
        whole = Region(0, 0, size[1], size[0])
        if region is None:
            return cls(size, whole, size)
        window = whole if region.bars is None else active_area(picture, region.bars)
        shown = picture.cropped(window)
        factor = enlargement_for(shown.size)
        seen = round(shown.size[0] * factor), round(shown.size[1] * factor)
        return cls(size, window, seen, None if region.levels is None else Levels.of(shown, region.levels))

    @cached_property
    def factor(self) -> Array:
        """`(2,)`: how much longer lengths along x and y are for the engine."""
        width, height = self.window.x1 - self.window.x0, self.window.y1 - self.window.y0
        return np.asarray(np.divide(self.seen[::-1], (width, height)))

    def picture(self, picture: PreparedFrame) -> PreparedFrame:
        """A picture as the engine sees it."""
        shown = picture.cropped(self.window)
        levelled = shown if self.levels is None else shown.levelled(self.levels.table)
        return levelled.resized(self.seen)

    def points(self, points: Array) -> Array:
        """Image positions `(..., 2)` for the engine."""
        return (points - self.window.origin) * self.factor

    def back(self, points: Array) -> Array:
        """Positions `(..., 2)` of the engine in the image."""
        return points / self.factor + self.window.origin

    def parts(self, parts: Sequence[Part]) -> tuple[Part, ...]:
        """Outlines for the engine."""
        return tuple(replace(part, points=self.points(part.points)) for part in parts)

    def step(
        self, engine: Engine, picture: PreparedFrame, order: Sequence[int], token: CancelToken | None = None
    ) -> Step:
        """The engine's step to the frame of `picture`; its results and accounts in pixels of that."""
        return _Step(engine.step(self.picture(picture), order, token), self)


@dataclass(frozen=True, eq=False)
class _Step:
    """A step of an engine that sees enlarged pictures; the engine `after` it goes on seeing them."""

    step: Step
    view: EngineView

    @property
    def after(self) -> Engine:
        return self.step.after

    @cached_property
    def results(self) -> tuple[StepResult, ...]:
        return tuple(replace(each, points=self.view.back(each.points)) for each in self.step.results)

    def account(self, k: int, points: Array, subtracts: bool) -> Account:
        account = self.step.account(k, self.view.points(points), subtracts)
        return replace(account, nodes=self.view.back(account.nodes))
