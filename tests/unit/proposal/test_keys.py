"""Artist keys fitted to a mask: same points, in correspondence, parts that begin and end."""

from __future__ import annotations

import numpy as np

from roam_core import keys_from_mask, render_matte, shapes_from_mask
from roam_core.roto import Origin
from tests.golden.shots import Shot, blob, overlap, pose

RADII = [40.0, 52.0, 38.0, 45.0, 55.0, 43.0, 37.0]
SHOT = Shot(blob(RADII), (pose(90.0, 80.0), pose(140.0, 100.0, 4.0, 1.1)), size=(220, 260))


def test_a_key_far_away_keeps_its_points() -> None:
    start = SHOT.shape()
    (shape,) = keys_from_mask([start], SHOT.matte(1002), 1002)
    key = shape.key_at(1002)
    assert key is not None
    assert key.origin is Origin.ARTIST
    assert shape.key_at(1001) == start.key_at(1001)
    assert overlap(render_matte([shape], 1002, SHOT.size) > 0.5, SHOT.matte(1002) > 0.5) > 0.98
    assert np.hypot(*(key.points - SHOT.truth(1002))[:, 0].T).mean() < 4.0


def test_parts_begin_and_end() -> None:
    first, second = np.zeros((120, 160), dtype=bool), np.zeros((120, 160), dtype=bool)
    first[20:60, 20:70] = second[22:62, 23:73] = True
    first[30:45, 35:50] = True
    first[80:100, 110:140] = True
    second[32:47, 38:53] = False
    shapes = keys_from_mask(shapes_from_mask(first, 1), second, 11)
    assert [shape.exists_at(1) for shape in shapes] == [True, False, True]
    assert [shape.exists_at(11) for shape in shapes] == [True, True, False]
    for frame, mask in ((1, first), (11, second)):
        assert overlap(render_matte(shapes, frame, mask.shape) > 0.5, mask) > 0.97


def test_nothing_is_left_of_an_empty_mask() -> None:
    shapes = keys_from_mask([SHOT.shape()], np.zeros(SHOT.size, dtype=np.uint8), 1002)
    assert [shape.frames for shape in shapes] == [(1001,)]
    assert not render_matte(shapes, 1002, SHOT.size).any()
    assert render_matte(shapes, 1001, SHOT.size).any()
