"""Frames that show nothing: black ones where a shot was cut, white ones of a flash, dropped ones of a transfer."""

from __future__ import annotations

from collections.abc import Sequence

import cv2
import numpy as np

from roam_core.arrays import Array
from roam_core.features.frame import PreparedFrame, Region
from roam_core.params.evidence import BlankParams


def is_blank(picture: PreparedFrame, outlines: Sequence[Array], params: BlankParams) -> bool:
    """Whether a picture shows nothing at all, but for grain.

    Its plate tells: levels may have cut what it shows at black. Looked at is what lies around the `outlines (P, 3, 2)`
    first: the rest of a picture that shows something there need not be decoded.
    """
    height, width = picture.size
    whole = Region(0, 0, width, height)
    places = np.concatenate([outline.reshape(-1, 2) for outline in outlines])
    around = Region.around(places, params.margin, picture.size)
    boxes = (whole,) if around.is_empty else (around, whole)
    return all(_span(picture.plate, box, params.cell) < params.span / picture.contrast for box in boxes)


def went_blank(picture: PreparedFrame, before: PreparedFrame, outlines: Sequence[Array], params: BlankParams) -> bool:
    """Whether a picture shows nothing where the one on which a run stands, `before`, did: runs pass over it.

    Where that was as plain, as a body drawn on nothing, there is nothing to be told apart.
    """
    return is_blank(picture, outlines, params) and not is_blank(before, outlines, params)


def _span(picture: PreparedFrame, box: Region, cell: int) -> float:
    """By how many levels the whole cells of a box differ at most, in the channel in which they differ most."""
    columns, rows = max((box.x1 - box.x0) // cell, 1), max((box.y1 - box.y0) // cell, 1)
    pixels = picture.within(box)[: rows * cell, : columns * cell]  # whole cells are averaged three times as fast
    means = cv2.resize(pixels, (columns, rows), interpolation=cv2.INTER_AREA)
    return max(most - least for least, most, *_ in map(cv2.minMaxLoc, cv2.split(means)))
