"""What a region holds and leaves out, by the key's colours: what flow led astray is as sure as what is right."""

from __future__ import annotations

import cv2
import numpy as np

from roam_core import shapes_from_mask, track
from roam_core.arrays import UInt8
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.matte import shape_matte
from roam_core.params import params_for
from roam_core.propagate.frame.redetection import AppearanceTemplate
from roam_core.proposal.cues.evidence import Field

SIZE, SIDE = (360, 480), 31


def square_that_flies(step: int, count: int = 6) -> tuple[list[UInt8], list[UInt8]]:
    """A white square over fine leaves that goes `step` pixels to the right on each frame: pictures and true masks."""
    rng = np.random.default_rng(4)
    height, width = SIZE
    coarse = rng.uniform(0.2, 0.7, (height // 3, width // 3, 3)).astype(np.float32)
    leaves = cv2.resize(coarse, (width, height), interpolation=cv2.INTER_CUBIC)
    pictures, masks = [], []
    for frame in range(count):
        mask = np.zeros(SIZE, np.float32)
        left = 60 + step * frame
        mask[120 : 120 + SIDE, left : left + SIDE] = 1.0
        seen = cv2.GaussianBlur(leaves * (1.0 - mask[..., None]) + 0.95 * mask[..., None], (0, 0), 0.6)
        noisy = seen + rng.normal(0.0, 0.008, seen.shape)
        pictures.append((np.clip(noisy, 0.0, 1.0) * 255.0).astype(np.uint8))
        masks.append((mask * 255.0).astype(np.uint8))
    return pictures, masks


def test_one_that_flies_is_followed_though_flow_finds_another_place_for_it() -> None:
    pictures, masks = square_that_flies(72)
    for tracked in track(lambda frame: pictures[frame], shapes_from_mask(masks[0]), range(len(pictures)), "best"):
        ours, true = shape_matte(tracked.results[0].shape, tracked.frame, SIZE) > 0.5, masks[tracked.frame] > 0
        assert (ours & true).sum() > 0.85 * (ours | true).sum(), tracked.frame


def field(x0: int, y0: int, x1: int, y1: int) -> Field:
    coverage = np.zeros(SIZE, np.float32)
    coverage[y0:y1, x0:x1] = 1.0
    return Field.of_coverage(Grid(Region(0, 0, SIZE[1], SIZE[0]), *SIZE), coverage)


def test_a_region_is_less_alike_the_more_it_leaves_out_or_takes_in() -> None:
    pictures, _ = square_that_flies(0, 1)
    frame, params = PreparedFrame(pictures[0]), params_for("best").region
    appearance = AppearanceTemplate(frame, field(60, 120, 91, 151), params.redetection, params.unseen)
    whole, half, double, elsewhere = (
        appearance.resemblance_of(frame, field(*box))
        for box in ((60, 120, 91, 151), (60, 120, 75, 151), (60, 120, 122, 151), (300, 200, 331, 231))
    )
    assert whole > 0.95
    assert half < 0.8
    assert double < 0.8
    assert elsewhere == 0.0
    assert appearance.resemblance_of(frame, field(0, 0, 0, 0)) == 0.0
