"""How much brighter the picture has become since the key, told by the background that both show."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core.arrays import Bools, UInt8
from roam_core.features.grid import Grid
from roam_core.params.evidence import ExposureParams
from roam_core.proposal.cues.key_view import KeyView


def exposure_gain(view: KeyView, picture: UInt8, inside: Bools, grid: Grid, params: ExposureParams) -> float | None:
    """The factor by which the background has become brighter since the key; None where that is not to be seen.

    A patch of it is known again by its correlation with the key's, which light does not change. A change of exposure is
    the same everywhere: where most patches do not agree on a factor, it is shadows, glitter, or something else. Told is
    the factor nearest to 1 from which the median differs by no more than two patches of one light do.

    Parameters
    ----------
    view : the key, carried by the motion of its surroundings. picture : (rows, columns) luma in the cells of `grid`.
    inside : (rows, columns) where the object may be.
    """
    seen, known = view.seen(grid)
    window = (params.window, params.window)
    known &= ~inside & (view.coverage < params.beside)
    whole = cv2.erode(known.astype(np.uint8), np.ones(window, np.uint8), borderType=cv2.BORDER_CONSTANT, borderValue=0)
    then, now = (np.asarray(each, np.float32) for each in (cv2.cvtColor(seen, cv2.COLOR_RGB2GRAY), picture))
    mean_then, mean = cv2.blur(then, window), cv2.blur(now, window)
    variance_then, variance = cv2.blur(then * then, window) - mean_then**2, cv2.blur(now * now, window) - mean**2
    covariance = cv2.blur(then * now, window) - mean_then * mean
    usable = whole > 0
    usable &= covariance > params.alike * np.sqrt(np.maximum(variance_then * variance, np.float32(params.flat**4)))
    for each in (mean_then, mean):
        usable &= (each > params.darkest) & (each < params.brightest)
    if np.count_nonzero(usable) < params.least:
        return None
    changes = np.log(mean[usable].astype(np.float64) / mean_then[usable])
    median = float(np.median(changes))
    if np.mean(np.abs(changes - median) < params.within) < params.agreed:
        return None
    return float(np.exp(median - np.clip(median, -params.within, params.within)))
