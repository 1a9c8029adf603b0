"""Two passes that do not agree: how far the picture is heard."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Float32
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.geometry.bezier import polygon_points
from roam_core.matte import shape_matte
from roam_core.params import RegionParams, scale_for
from roam_core.params.evidence import BackgroundParams
from roam_core.propagate.between.directional_pass import DirectionalPass, Stop
from roam_core.propagate.between.endpoint_consistency import Key, Span
from roam_core.propagate.between.merge import merged
from roam_core.propagate.between.merged_region import Colours
from roam_core.propagate.engines.protocol import Motion
from roam_core.propagate.frame.covering import learned_colours
from roam_core.propagate.frame.result import Part
from roam_core.proposal.cues.evidence import SURE, Field, KeyMemory
from roam_core.roto import Keyframe, RotoShape

SIZE = (120, 160)
GRID = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 1.0)
SQUARE = polygon_points([(40, 40), (90, 40), (90, 80), (40, 80)])
STRIP = (slice(40, 80), slice(90, 94))
"""Cells on the right of the square: of the object on the frame, and of the background on both keys."""
RED, GREEN = (200, 60, 40), (60, 140, 60)


def picture(right: int) -> PreparedFrame:
    image = np.full((*SIZE, 3), GREEN, np.uint8)
    image[40:80, 40:right] = RED
    return PreparedFrame(image)


def region(strip: float) -> Field:
    """The square, surely, and nothing else; what is said of the strip, nats."""
    values = np.full(SIZE, -SURE, np.float32)
    values[40:80, 40:90] = SURE
    values[STRIP] = strip
    return Field(GRID, values)


def memory() -> KeyMemory:
    """What either key knows: the square, and that the strip beside it is background."""
    key, field = picture(90), region(-SURE)
    return KeyMemory(key, field, learned_colours(key.image, field, ()), np.eye(3), np.eye(3))


def strip_taken(onwards: float, back: float, keys_weight: float, background: BackgroundParams | None = None) -> float:
    """The share of the strip in the outline half way between two keys, where the passes say so much of it."""

    def directional_pass(key: int, strip: float) -> DirectionalPass:
        def seen(frame: int) -> Field:
            return region(strip if frame == 3 else -SURE)

        stops = {
            frame: Stop(
                (SQUARE,),
                (1.0,),
                np.eye(3),
                Motion(np.eye(3), seen(frame), (True,), pose_costs=(None,), key=memory()),
            )
            for frame in (1, 3, 5)
        }
        return DirectionalPass(stops, picture(90))

    params = replace(RegionParams(), keys_weight=keys_weight, sweeps=0, background=background)
    keys = [Key(frame, (Part(SQUARE),)) for frame in (1, 5)]
    span = Span(*keys, directional_pass(1, onwards), directional_pass(5, back), SIZE, scale_for(SIZE), params)
    [outline] = merged(span, 3, colours=Colours(picture(94), params))
    assert outline is not None
    matte: Float32 = shape_matte(RotoShape("x", "x", (Keyframe(3, outline.points),)), 3, SIZE)
    return float(matte[STRIP].mean())


@pytest.mark.parametrize("turned", [False, True], ids=["onwards inside", "back inside"])
def test_where_the_passes_disagree_the_picture_is_heard_over_what_would_stand_where_they_agree(turned: bool) -> None:
    """Planar motion says outside and weighs as much as both passes: together half of sure, whatever these say.

    The picture's three nats for the object are enough against half of that, and not against all of it.
    """
    at_odds = (-SURE, SURE) if turned else (SURE, -SURE)
    at_one = (-0.01, -0.01)
    heard = 0.75 * (SURE / 2.0) / 3.0
    assert strip_taken(*at_odds, heard) > 0.6
    assert strip_taken(*at_one, heard) < 0.2
    assert strip_taken(*at_odds, 0.5 * heard) < 0.2
    assert strip_taken(*at_one, 2.0 * heard) > 0.6


@pytest.mark.parametrize("at_odds", [(SURE, -SURE), (-SURE, SURE)], ids=["onwards inside", "back inside"])
def test_what_hides_the_background_of_both_keys_is_taken_in(at_odds: tuple[float, float]) -> None:
    """The strip is the object's on the frame, and green on both keys, as all around it still is."""
    assert strip_taken(*at_odds, 0.0) < 0.2
    assert strip_taken(*at_odds, 0.0, BackgroundParams()) > 0.6
    assert strip_taken(*at_odds, 0.0, replace(BackgroundParams(), unlike=250.0)) < 0.2


@pytest.mark.parametrize(("onwards", "back", "x"), [(0.4, 0.8, 30.0), (0.8, 0.4, 0.0), (0.6, 0.8, 0.0)])
def test_a_pass_by_poses_that_is_more_likely_wrong_is_not_heard(onwards: float, back: float, x: float) -> None:
    """The pass onwards has the part at 0 half way, the one back at 30, which missed its other key by more."""

    def led(key: int, at: float, end: float, sure: float) -> DirectionalPass:
        places = {key: (0.0, 1.0), 3: (at, sure), 6 - key: (end, 0.9)}
        motion = Motion(None, None, (False,), pose_costs=(0.4,))
        return DirectionalPass(
            {
                frame: Stop((SQUARE + np.array([by, 0.0]),), (sure,), np.eye(3), motion)
                for frame, (by, sure) in places.items()
            },
            picture(90),
        )

    keys = [Key(frame, (Part(SQUARE),)) for frame in (1, 5)]
    passes = led(1, 0.0, 0.0, onwards), led(5, 30.0, 4.0, back)
    span = Span(*keys, *passes, SIZE, scale_for(SIZE), RegionParams())
    [outline] = merged(span, 3)
    assert outline is not None
    np.testing.assert_allclose(outline.points, SQUARE + np.array([x, 0.0]))
