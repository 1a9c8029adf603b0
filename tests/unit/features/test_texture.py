"""Texture: what is even has its own colour and nothing else; stripes are steep across themselves."""

from __future__ import annotations

import numpy as np

from roam_core.features.texture import texture
from roam_core.params import TextureParams

PARAMS = TextureParams()
DEVIATION, SLOPES = slice(9, 12), slice(12, 14)


def test_an_even_picture_has_one_colour_everywhere_and_no_texture() -> None:
    even = np.full((30, 40, 3), (120, 130, 90), np.uint8)
    seen = texture(even, PARAMS)
    assert seen.shape == (14, 30, 40)
    colours = np.float32([120, 130, 90] * 3)[:, None, None]
    np.testing.assert_array_equal(seen[:9], np.broadcast_to(colours, (9, 30, 40)))
    assert not seen[9:].any()


def test_stripes_are_steep_across_themselves() -> None:
    stripes = np.full((40, 40, 3), 128, np.uint8)
    stripes[:, ::4, 0] = 200
    upright, lying = (texture(each, PARAMS)[:, 20, 20] for each in (stripes, stripes.transpose(1, 0, 2).copy()))
    assert upright[SLOPES][0] > 50
    assert upright[SLOPES][1] == 0
    np.testing.assert_array_equal(upright[SLOPES], lying[SLOPES][::-1])
    assert upright[DEVIATION][0] > 20
    assert not upright[DEVIATION][1:].any()


def test_it_is_the_same_wherever_the_picture_is_cut() -> None:
    """Sums are exact: cells far enough from the cut see the same, to the last bit."""
    picture = np.random.default_rng(1).integers(0, 256, (80, 90, 3)).astype(np.uint8)
    whole, part = texture(picture, PARAMS), texture(picture[20:, 13:].copy(), PARAMS)
    room = PARAMS.windows[-1]
    np.testing.assert_array_equal(whole[:, 20 + room : -room, 13 + room : -room], part[:, room:-room, room:-room])
