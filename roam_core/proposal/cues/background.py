"""The background that the key shows: where the picture still shows it, and where it no longer does.

What lay around the object on the key moves with the surroundings, not with the object. So the key, carried by their
motion, tells two things that the object's own motion cannot: a patch that looks as the key's background does there is
background, though it was taken for the object on all frames since; and a cell that does not, while the background
around it is as it was, shows something else: the object.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32, UInt8
from roam_core.features.grid import Grid
from roam_core.geometry import similarity
from roam_core.kernels.background_match import best_matches
from roam_core.kernels.coverage import coverage
from roam_core.kernels.local_match import OUTSIDE
from roam_core.motion.flow import cell_flow, flow_similarity
from roam_core.params.evidence import BackgroundParams
from roam_core.proposal.cues.key_view import KeyView, lab, trimap
from roam_core.proposal.cues.known_again import known_again, local_means


@dataclass(frozen=True, eq=False)
class LaterView:
    """What lay around the object on a frame after its key.

    Attributes
    ----------
    grid : its cells. colours : (rows, columns, 3) RGB of these. known : (rows, columns) 255 where they are background,
        else 0. carried : (3, 3) similarity by which the surroundings went since.
    """

    grid: Grid
    colours: UInt8
    known: UInt8
    carried: Array

    def seen(self, grid: Grid) -> tuple[UInt8, Bools]:
        """Its picture `(rows, columns, 3)`, RGB in the cells of another grid, and which of these it knows."""
        to_image = self.carried @ self.grid.map_to_image
        return grid.warped(self.colours, to_image), grid.warped(self.known, to_image) == 255


@dataclass(frozen=True, eq=False)
class Background:
    """The background that is known as it would look on another frame.

    Attributes
    ----------
    colours : (rows, columns, 3) Lab, carried by the motion of the surroundings.
    known : (rows, columns) the cells that were seen and are known to be background. on_key : those of them that the
        key itself shows. new : those that no view has shown.
    """

    colours: UInt8
    known: Bools
    on_key: Bools
    new: Bools

    @classmethod
    def of(cls, view: KeyView, neither: Sequence[Array] = (), later: Sequence[LaterView] = ()) -> Background:
        """What a key, carried by the motion of its surroundings, shows in its cells; beyond it `later` views.

        `neither`: closed polylines `(K, 2)` on the key, beyond the object, of what need not be background.
        """
        grid, colours, in_sight = view.grid, view.seen, view.in_sight
        on_key = in_sight.copy()
        covers = (coverage(grid.to_grid(similarity.apply(view.carried[:2], line)), grid.shape) for line in neither)
        for cover in (view.coverage, *covers):
            on_key &= trimap(cover) == OUTSIDE
        known = on_key.copy()
        for each in later:
            theirs, new = each.seen(grid)
            new &= ~in_sight
            colours = np.where(new[..., None], theirs, colours)
            known |= new
            in_sight = in_sight | new
        return cls(lab(colours), known, on_key, ~in_sight)

    def log_ratio(self, now: UInt8, outside: Bools, params: BackgroundParams) -> Float32:
        """ln p(object) / p(background) of each cell `(rows, columns)`, nats: 0 where nothing is known.

        That something else hides it is told only where the key itself shows it: what a later view has beside the object
        may have been left out of that by mistake. `now (rows, columns, 3)` is the picture in Lab, `outside` the cells
        that are surely not of the object.
        """
        likeness, difference = self._compared(now, params)
        same = np.clip((likeness - params.alike) / (1.0 - params.alike), 0.0, 1.0)
        within_reach = np.ones((2 * params.reach + 1, 2 * params.reach + 1), np.uint8)
        is_known = np.isfinite(difference) & (cv2.dilate(self.on_key.astype(np.uint8), within_reach) > 0)
        other = np.where(is_known, np.clip(difference / params.unlike - 1.0, 0.0, 1.0), 0.0)
        asked = np.float32(1.0) * (outside & is_known)
        count, changed = (_sums(each, params.around) for each in (asked, asked * other))
        sound = np.where(count > 0, np.clip(1.0 - 2.0 * changed / np.maximum(count, 1.0), 0.0, 1.0), 0.0)
        return np.asarray(params.other * sound * other - params.same * same, dtype=np.float32)

    def unchanged(self, now: UInt8, params: BackgroundParams) -> Bools:
        """The cells `(rows, columns)` that are known, and have the colours of the background there, as `now` in Lab."""
        _, difference = self._compared(now, params)
        return np.asarray(difference < 0.5 * params.unlike)

    def _compared(self, now: UInt8, params: BackgroundParams) -> tuple[Float32, Float32]:
        """How like the background each cell is, `(rows, columns)` each, at the best place within reach.

        The correlation of the patches around both, which means little where there is little texture; and the difference
        of the colours, infinite where nothing is known. A shadow may have fallen on what is darker than it was.
        """
        likeness, squared = best_matches(
            now, self.colours, self.known, params.window, params.reach, params.texture, params.shade
        )
        return likeness, np.sqrt(squared)


def correction(
    view: KeyView, later: Sequence[LaterView], picture: UInt8, inside: Bools, params: BackgroundParams
) -> Array:
    """The motion `(3, 3)` that draws to the picture what the motion of the surroundings has carried there.

    That adds up from frame to frame. `view` is the key, so carried; where nothing of its background is in sight, the
    `later` views are asked. `picture (rows, columns)` is the luma and `inside (rows, columns)` the object on the frame.
    The identity where too little of the background agrees, or where less than half of it is still known again, so
    drawn: over a faint texture flow goes along with what moves beside it.
    """
    grid, seen = view.grid, view.seen
    known = view.in_sight & ~inside & (view.coverage < 0.5)
    for each in later:
        if known.any():
            break
        seen, known = each.seen(grid)
        known &= ~inside
    if not known.any():
        return np.eye(3)
    grey = np.asarray(cv2.cvtColor(seen, cv2.COLOR_RGB2GRAY), dtype=np.uint8)
    drawn, agreement = flow_similarity(cell_flow(grey, picture), known, grid)
    if agreement < params.agreed:
        return np.eye(3)
    carried = drawn @ grid.map_to_image
    moved, still_known = grid.warped(grey, carried), grid.warped(known.astype(np.uint8), carried) > 0
    before = _count_known_again(grey, known, picture, params)
    after = _count_known_again(moved, still_known, picture, params)
    return drawn if after >= 0.5 * before else np.eye(3)


def _count_known_again(grey: UInt8, known: Bools, picture: UInt8, params: BackgroundParams) -> int:
    """How many cells of a luma `(rows, columns)`, as far as it is `known`, a picture shows at their place."""
    lumas, (window, alike, flat) = (grey, picture), (params.window, params.alike, params.texture)
    means = local_means(grey, window), local_means(picture, window)
    return int(np.count_nonzero(known_again(lumas, means, known, window, alike, flat)))


def _sums(values: Float32, side: int) -> Float32:
    """Over a window around each cell of `(rows, columns)`; exact of whole numbers."""
    return np.asarray(cv2.boxFilter(values, cv2.CV_32F, (side, side), normalize=False))
