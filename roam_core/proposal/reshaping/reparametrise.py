"""Where a segmentation and the curve differ markedly: nodes displaced, inserted or removed, if the energy falls."""

from __future__ import annotations

from dataclasses import dataclass

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.energy import total
from roam_core.energy.total import CurveContext
from roam_core.features.grid import Grid
from roam_core.geometry import bezier, polyline
from roam_core.kernels.coverage import coverage
from roam_core.params import ProposalParams, RoamParams
from roam_core.proposal.cues.evidence import Field
from roam_core.proposal.segment.region import outlines
from roam_core.proposal.segment.segmentation import Segmentation


@dataclass(frozen=True, eq=False)
class Piece:
    """A connected region `cells (rows, columns)` that the segmentation has and the curve has not, or the reverse."""

    cells: Bools
    added: bool


@dataclass(frozen=True, eq=False)
class Reshaped:
    """An outline after the pieces that were accepted.

    Attributes
    ----------
    ring : (K, 2) pixels, running as the curve did. changed : (rows, columns) the cells that changed sides.
    energy_before, energy : of the curve and of the ring, by `energy_of`.
    """

    ring: Array
    changed: Bools
    energy_before: float
    energy: float

    @property
    def is_new(self) -> bool:
        return bool(self.changed.any())


def energy_of(line: Array, context: CurveContext, params: RoamParams) -> float:
    """E^C of the closed polyline `line (K, 2)`, comparable between curves of different length.

    The line is sampled at the context's spacing, so a longer one has more nodes: this is where nodes are inserted and
    removed. While N stands still the energy is defined up to a constant for each node; where N changes, that constant
    is a choice, `ProposalParams.node_price`. At the weight of the gradient an edge costs 1 - |grad I|^2 >= 0, as in
    geodesic active contours (Caselles, Kimmel and Sapiro, IJCV 1997), and a curve gains nothing by growing.
    """
    assert params.proposals is not None
    if polyline.signed_area(line) * context.orientation < 0:
        line = line[::-1]
    count = max(3, round(polyline.length(line) / context.spacing))
    nodes = polyline.resample(line, count)
    return total.energies(nodes, context, params)["total"] + params.proposals.node_price * count


def differences(current: Bools, proposed: Segmentation, params: ProposalParams) -> list[Piece]:
    """The marked differences between the curve's inside `current (rows, columns)` and the segmentation, largest first.

    Marked are connected pieces of at least `area` cells that are `depth` cells deep somewhere. Of what is added, a
    share of `overlap` must lie in or beside the expected region: a tentacle does not.
    """
    disc = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (5, 5))
    near = cv2.dilate(proposed.expected.astype(np.uint8), disc) > 0
    found: list[tuple[int, Piece]] = []
    for added, side in ((True, proposed.inside & ~current), (False, current & ~proposed.inside)):
        picture = side.astype(np.uint8)
        _, labels, stats, _ = cv2.connectedComponentsWithStats(picture, connectivity=4)
        depth = cv2.distanceTransform(np.pad(picture, 1), cv2.DIST_L2, 3)[1:-1, 1:-1]
        for label in np.flatnonzero(stats[1:, cv2.CC_STAT_AREA] >= params.area) + 1:
            cells, area = labels == label, int(stats[label, cv2.CC_STAT_AREA])
            stray = added and np.count_nonzero(near[cells]) < params.overlap * area
            if depth[cells].max() >= params.depth and not stray:
                found.append((area, Piece(cells, added)))
    found.sort(key=lambda each: -each[0])
    return [piece for _, piece in found[: params.most]]


def reshaped(
    line: Array, proposed: Segmentation, context: CurveContext, params: RoamParams, least_area: float = 0.0
) -> Reshaped:
    """The closed polyline `line (K, 2)` with each marked difference carried out that lowers the energy.

    Piece by piece, the largest first: the stretch of the curve that runs around the piece is replaced by the
    proposal's. A piece that would cut the region in two is left alone: that is for the artist
    (`proposal.reshaping.topology`). Nothing is taken away that would leave less than `least_area` square pixels.
    """
    assert params.proposals is not None
    grid = proposed.grid
    covered = coverage(grid.to_grid(line), grid.shape)
    before = energy = energy_of(line, context, params)
    ring, changed = line, np.zeros(grid.shape, dtype=bool)
    for piece in differences(covered > 0.5, proposed, params.proposals):
        parts = outlines(toggled(covered, piece, grid, params.proposals.soft))
        if not parts:
            continue
        if not piece.added and len(parts) > 1 and cells_in(parts[1][0], grid) >= params.proposals.area:
            continue
        if not piece.added and abs(polyline.signed_area(parts[0][0])) < least_area:
            continue
        reached = energy_of(parts[0][0], context, params)
        if reached < energy:
            ring, energy = parts[0][0], reached
            changed |= piece.cells
            covered = coverage(grid.to_grid(ring), grid.shape)
    if polyline.signed_area(ring) * polyline.signed_area(line) < 0:
        ring = ring[::-1]
    return Reshaped(ring, changed, before, energy)


def toggled(covered: Float32, piece: Piece, grid: Grid, soft: float) -> Field:
    """The region of the coverage `covered (rows, columns)` with the piece put in or taken out.

    Away from the piece the field is the coverage itself, whose contour is the curve; there it is a Gaussian of `soft`
    cells.
    """
    inside = covered > 0.5
    wanted = (inside | piece.cells) if piece.added else (inside & ~piece.cells)
    even = cv2.GaussianBlur(wanted.astype(np.float32), (0, 0), soft)
    near = cv2.dilate(piece.cells.astype(np.uint8), np.ones((3, 3), np.uint8)) > 0
    return Field(grid, np.where(near, even, covered).astype(np.float32) - np.float32(0.5))


def cells_in(ring: Array, grid: Grid) -> float:
    """The area of a ring in image coordinates, in cells."""
    return abs(polyline.signed_area(ring)) * float(np.prod(grid.factor))


def untouched(points: Array, changed: Bools, grid: Grid, samples: int, reach: int = 2) -> Bools:
    """Control points `(P,)` of a spline neither of whose segments comes within `reach` cells of what changed.

    `samples` places on each segment are looked at."""
    near = cv2.dilate(changed.astype(np.uint8), np.ones((2 * reach + 1, 2 * reach + 1), np.uint8)) > 0
    count = len(points)
    places = grid.to_grid(bezier.evaluate(points, *bezier.even_pairs(np.full(count, samples))))
    rows, columns = grid.shape
    x = np.clip(places[:, 0].astype(np.intp), 0, columns - 1)
    y = np.clip(places[:, 1].astype(np.intp), 0, rows - 1)
    touched = near[y, x].reshape(count, samples).any(axis=1)
    return np.asarray(~(touched | np.roll(touched, 1)))
