"""Drawn regions with the colour fields and the gradient that an engine sure of its colours would see."""

from __future__ import annotations

from dataclasses import replace

import cv2
import numpy as np

from roam_core.arrays import Array, Bools, Float32
from roam_core.energy.colour_fields import ColourFields
from roam_core.energy.total import CurveContext
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.params import AppearanceParams, ProposalParams, RoamParams

SIZE = (120, 160)
PARAMS = RoamParams(
    appearance=AppearanceParams(), lambda_local=0.03, lambda_global=0.03, proposals=ProposalParams(grid_factor=0.5)
)
GRID = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 0.5)


def drawn(*boxes: tuple[int, int, int, int]) -> Bools:
    """The union of boxes `(x0, y0, x1, y1)` with rounded corners, `(h, w)`."""
    mask = np.zeros(SIZE, dtype=np.uint8)
    for x0, y0, x1, y1 in boxes:
        mask[y0:y1, x0:x1] = 1
    return np.asarray(cv2.morphologyEx(mask, cv2.MORPH_OPEN, np.ones((3, 3), np.uint8)) > 0)


def spline(mask: Bools) -> Array:
    """Control points `(P, 3, 2)` of the outline of a mask's largest part."""
    return np.array(shapes_from_mask(mask)[0].keys[0].points)


def picture(mask: Bools) -> PreparedFrame:
    """A grey object on a darker background."""
    return PreparedFrame(np.where(mask[..., None], np.uint8(190), np.uint8(60)).repeat(3, axis=2))


def context(truth: Bools, ratio: Float32 | None = None) -> CurveContext:
    """What colours sure of `truth` say - or of `ratio (h, w)`, nats - at a spacing of 8 pixels."""
    local = np.where(truth, np.float32(2.0), np.float32(-2.0)) if ratio is None else ratio
    whole = Region(0, 0, SIZE[1], SIZE[0])
    colours = ColourFields(Grid.over(whole, 1.0), local, np.zeros_like(local), 6.0, 0.5 * local)
    return CurveContext(picture(truth).squared_gradient(whole, 1.0, 144.0, 98.0), (0, 0), 8.0, 1.0, colours)


def with_price(price: float) -> RoamParams:
    """The parameters with another price of a node."""
    assert PARAMS.proposals is not None
    return replace(PARAMS, proposals=replace(PARAMS.proposals, node_price=price))
