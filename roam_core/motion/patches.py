"""Patches of an object's key, each followed by itself: which side of the outline the picture near them lies on.

An object is no plane, but small pieces of its surface are nearly one. Each is matched with the key's own picture on
every frame (`kernels.patch_alignment`), from where the flow takes it and from where those around it lie; so one that
was hidden or blurred is found again, and nothing adds up. What still looks as on the key says more exactly than any
colour where the outline runs beside it, also where that has no edge in the picture.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import NamedTuple

import cv2
import numpy as np
from numpy.typing import NDArray

from roam_core.arrays import Array, Bools, Float32, Int32, UInt8
from roam_core.features import PreparedFrame
from roam_core.features.grid import Grid, signed_distance
from roam_core.geometry import similarity
from roam_core.kernels.patch_alignment import Alignment, Picture, Templates, aligned, sides
from roam_core.params.patches import PatchParams


class Levels(NamedTuple):
    """A part of a picture in cells of about a pixel of a 480-line image, blurred coarsely and finely."""

    coarse: Picture
    fine: Picture

    @classmethod
    def of(cls, frame: PreparedFrame, grid: Grid, params: PatchParams) -> Levels:
        """The picture in the cells of `grid`."""
        colours = grid.colours_of(frame)
        (fx, fy), (left, top) = grid.factor, grid.region.origin
        blurred = (cv2.GaussianBlur(colours, (0, 0), sigma) for sigma in (params.coarse, params.fine))
        return cls(*(Picture(np.asarray(each, np.uint8), fx, fy, float(left), float(top)) for each in blurred))


@dataclass(frozen=True, eq=False)
class PatchMotion:
    """Where patches lie on a frame.

    Attributes
    ----------
    affines : (M, 6) `(q_x, q_y, L_xx, L_xy, L_yx, L_yy)`: the place k of the key lies at q + L (k - centre), pixels.
    likeness : (M,) how much each looks there as on the key, in [0, 1].
    open_by : (M,) what its own texture leaves open of its place, pixels of a 480-line image.
    agreed : (M,) how far each lay on the object, as that was found on the last frames, in [0, 1].
    """

    affines: Array
    likeness: Array
    open_by: Array
    agreed: Array


@dataclass(frozen=True, eq=False)
class Patches:
    """What was learned of an object on its key.

    Attributes
    ----------
    templates : places, colours and slopes of the M patches. radius : of a patch, pixels.
    picture : the key's, blurred finely, and `depth (rows, columns)` the signed distance of its cells from the outline,
        cells of about a pixel of a 480-line image.
    """

    templates: Templates
    radius: float
    picture: Picture
    depth: Float32
    scale: float
    params: PatchParams

    @classmethod
    def learned(
        cls, frame: PreparedFrame, inside: Bools, visible: Bools, grid: Grid, scale: float, params: PatchParams
    ) -> Patches | None:
        """The patches of what is `inside (rows, columns)`, as far as it is `visible`; None where nothing is.

        `grid` has cells of about a pixel of a 480-line image, `scale` is `params.scale_for(size)`.
        """
        depth = signed_distance(inside, float(max(inside.shape)))
        seen = visible & (depth > params.rim)
        cells, spacing = _centres(seen, depth, params)
        if len(cells) == 0:
            return None
        radius = params.reach * spacing
        places = np.stack([_places(seen, cell, radius, params.places) for cell in cells])
        levels = Levels.of(frame, grid, params)
        colours, slopes = zip(*(_looks(each.image, places, grid) for each in levels), strict=True)
        neighbours, nearness = _neighbours(cells, spacing, params.neighbours)
        templates = Templates(
            grid.to_image(cells),
            grid.to_image(places.astype(np.float64) + 0.5),
            np.stack(colours),
            np.stack(slopes),
            neighbours,
            nearness,
        )
        return cls(templates, radius * scale, levels.fine, depth, scale, params)

    @property
    def on_key(self) -> PatchMotion:
        """Their motion on the key itself."""
        return self.carried(np.eye(3), 1.0)

    def carried(self, transform: Array, likeness: float) -> PatchMotion:
        """As if all had gone by one similarity `(3, 3)`, and matched there as well as that."""
        count = len(self.templates.centres)
        linear = np.tile(transform[:2, :2].reshape(1, 4), (count, 1))
        affines = np.hstack([similarity.apply(transform[:2], self.templates.centres), linear])
        return PatchMotion(affines, np.full(count, likeness), np.zeros(count), np.ones(count))

    @property
    def alignment(self) -> Alignment:
        """How they are aligned, in pixels of the image."""
        params, scale = self.params, self.scale
        return Alignment(
            rounds=params.rounds,
            like_least=params.like_least,
            like_most=params.like_most,
            like=params.like,
            shift=params.shift,
            move=params.move * scale,
            strain=params.strain,
            independent=params.independent,
            parted=params.parted * scale,
            step=params.step * scale,
            step_strain=params.step_strain,
            own=params.own,
            beyond=params.beyond,
        )

    def step(self, motion: PatchMotion, now: Levels, grid: Grid, flow: Float32) -> PatchMotion:
        """Their motion on the next frame, `now`, from that on the last one.

        `flow (rows, columns, 2)` leads there from the last frame, in the cells of `grid`.
        """
        carried = self._by_flow(motion, grid, flow)
        affines, likeness, open_by = aligned(
            self.templates, now.coarse, now.fine, carried, motion.affines, motion.likeness, self.alignment
        )
        return PatchMotion(affines, likeness, open_by / self.scale, motion.agreed)

    def sides(self, motion: PatchMotion, now: Levels) -> tuple[Float32, Float32]:
        """How surely the cells of a frame lie inside the outline, and outside, `(rows, columns)` each, in [0, 1]."""
        weights = self.weights(motion)
        said = self.params.alike, self.params.ramp
        return sides(
            self.templates.centres, motion.affines, weights, self.radius, self.picture, self.depth, now.fine, *said
        )

    def weights(self, motion: PatchMotion) -> Array:
        """How far each patch is believed `(M,)`, in [0, 1]: as it matches, as its texture tells where it lies, and as
        it lay on the object before.
        """
        params = self.params
        matched = np.clip((motion.likeness - params.believed) / (1.0 - params.believed), 0.0, 1.0)
        return np.asarray(motion.agreed * np.sqrt(matched) / (1.0 + (motion.open_by / params.open_by) ** 2))

    def carried_points(self, motion: PatchMotion, points: Array) -> tuple[Array, Array]:
        """Where the patches about them have the `points (P, 3, 2)` of the key, and how surely `(P,)`, in [0, 1].

        The handles of a point go with its anchor.
        """
        away = points[:, 0, None] - self.templates.centres
        near = 1.0 - (away**2).sum(axis=-1) / self.radius**2
        heard = self.weights(motion) * np.maximum(near, 0.0)
        shares = heard / np.maximum(heard.sum(axis=1, keepdims=True), 1e-9)
        linear = motion.affines[:, 2:].reshape(-1, 2, 2)
        shift = motion.affines[:, :2] - np.einsum("mab,mb->ma", linear, self.templates.centres)
        blended, moved = np.einsum("pm,mab->pab", shares, linear), shares @ shift
        return np.einsum("pab,pkb->pka", blended, points) + moved[:, None], heard.max(axis=1)

    def judged(self, motion: PatchMotion, inside: Bools, grid: Grid) -> PatchMotion:
        """The same motion once it was decided which cells of a grid are `inside (rows, columns)` the object.

        What lies beside the object has found its like there, and is believed the less.
        """
        rows, columns = self._cells(motion, grid)
        in_sight = (rows >= 0) & (rows < grid.rows) & (columns >= 0) & (columns < grid.columns)
        share = (in_sight & inside[rows.clip(0, grid.rows - 1), columns.clip(0, grid.columns - 1)]).mean(axis=1)
        return replace(motion, agreed=0.5 * (motion.agreed + share))

    def _by_flow(self, motion: PatchMotion, grid: Grid, flow: Float32) -> Array:
        """`(M, 6)` the patches, moved by the median of the flow in them."""
        rows, columns = self._cells(motion, grid)
        there = flow[rows.clip(0, grid.rows - 1), columns.clip(0, grid.columns - 1)]
        affines = motion.affines.copy()
        affines[:, :2] += np.median(there, axis=1) / grid.factor
        return affines

    def _cells(self, motion: PatchMotion, grid: Grid) -> tuple[NDArray[np.intp], NDArray[np.intp]]:
        """Rows and columns of the cells where some places of each patch lie, `(M, K)` each; maybe beyond the grid."""
        linear = motion.affines[:, 2:].reshape(-1, 2, 2)
        away = self.templates.places[:, :: self.params.asked] - self.templates.centres[:, None]
        lie = motion.affines[:, None, :2] + np.einsum("mab,mnb->mna", linear, away)
        cells = np.floor(grid.to_grid(lie)).astype(np.intp)
        return cells[..., 1], cells[..., 0]


def _centres(seen: Bools, depth: Float32, params: PatchParams) -> tuple[Array, float]:
    """`(M, 2)` cells about which patches lie, and their spacing: the narrowest that needs no more than `most`."""
    spacing = params.spacing
    while True:
        cells = _middles(seen, spacing, params.least)
        columns, rows = cells.astype(np.intp).T
        cells = cells[depth[rows, columns] < params.inner * params.reach * spacing]
        if len(cells) <= params.most:
            return cells, spacing
        spacing *= 1.1


def _middles(seen: Bools, spacing: float, least: float) -> Array:
    """`(M, 2)` the middles of what is seen in the squares of a grid, every other row shifted by half of one."""
    rows, columns = np.nonzero(seen)
    if len(rows) == 0:
        return np.zeros((0, 2))
    spots = np.stack([columns, rows], axis=1) + 0.5
    row = np.floor((spots[:, 1] - spots[:, 1].min()) / spacing).astype(np.intp)
    column = np.floor((spots[:, 0] - spots[:, 0].min()) / spacing + 0.5 * (row % 2)).astype(np.intp)
    _, square = np.unique(row * (column.max() + 1) + column, return_inverse=True)
    count = np.bincount(square)
    middles = np.stack([np.bincount(square, spots[:, axis]) / count for axis in (0, 1)], axis=1)
    return np.asarray(middles[count >= least * spacing**2])


def _places(seen: Bools, centre: Array, radius: float, count: int) -> Int32:
    """`(count, 2)` cells (column, row) within `radius` of the centre that are seen, evenly through them."""
    low, high = np.maximum(np.floor(centre - radius).astype(np.intp), 0), np.ceil(centre + radius).astype(np.intp)
    rows, columns = np.nonzero(seen[low[1] : high[1], low[0] : high[0]])
    cells = np.stack([columns, rows], axis=1) + low
    cells = cells[np.hypot(*(cells + 0.5 - centre).T) < radius]
    # In the order of a golden ratio sequence: a low discrepancy, whatever the number.
    chosen = np.floor((0.5 + np.arange(count) / ((1.0 + np.sqrt(5.0)) / 2.0)) % 1.0 * len(cells)).astype(np.intp)
    return np.asarray(cells[chosen], dtype=np.int32)


def _looks(image: UInt8, places: Int32, grid: Grid) -> tuple[Float32, Float32]:
    """The colours `(M, N, 3)` at places, cells, and how they change a pixel of the image, `(M, N, 3, 2)`."""
    columns, rows = places[..., 0], places[..., 1]
    colours = image.astype(np.float32)
    across, down = (cv2.Sobel(colours, cv2.CV_32F, *order, ksize=1, scale=0.5) for order in ((1, 0), (0, 1)))
    fx, fy = grid.factor.astype(np.float32)
    return colours[rows, columns], np.stack([fx * across[rows, columns], fy * down[rows, columns]], axis=-1)


def _neighbours(cells: Array, spacing: float, most: int) -> tuple[Int32, Array]:
    """The nearest of each patch `(M, most)`, -1 where there are fewer, and how much each is heard `(M, most)`."""
    away = np.hypot(*np.moveaxis(cells[:, None] - cells[None], -1, 0))
    nearest = np.argsort(away, axis=1, kind="stable")[:, 1 : most + 1]
    distance = np.take_along_axis(away, nearest, axis=1)
    missing = ((0, 0), (0, most - nearest.shape[1]))
    who = np.pad(np.where(distance < 2.2 * spacing, nearest, -1), missing, constant_values=-1)
    return who.astype(np.int32), np.pad(np.exp(-0.25 * (distance / spacing) ** 2), missing)
