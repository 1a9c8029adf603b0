"""A lone limb that something else hides on both keys of a span is known by how it looks on a key beyond them."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core import RotoShape, fill_span, render_matte
from roam_core.arrays import Array, UInt8
from roam_core.geometry.bezier import polygon_points
from roam_core.params import params_for
from roam_core.propagate.shapes.provenance import Stamp, Stamps, keys_beyond
from roam_core.roto import Keyframe
from tests.golden.shots import texture
from tests.unit.motion.test_pose import polyline_mask

SIZE = 120, 200
SEEN, FIRST, LAST = 0, 4, 12
"""The key that shows the limb, and those on which three quarters of it are hidden."""
LIMB, COVER, BACKGROUND = texture(3, 0.35, 0.75, 24), texture(9, 0.35, 0.75, 14), texture(4, 0.0, 0.35, 24)
CORNERS = np.array([(0.0, 0.0), (16.0, 0.0), (16.0, 56.0), (0.0, 56.0)])
BEFORE = np.array([(0.0, 0.0), (40.0, 0.0), (40.0, 92.0), (0.0, 92.0)])


def place(frame: int) -> Array:
    """Where the limb is: in the open on the first frame, then it comes out from behind its cover and goes back."""
    if frame <= FIRST:
        return np.array([30.0 + 80.0 * frame / FIRST, 14.0])
    u = (frame - FIRST) / (LAST - FIRST)
    return np.array([110.0 + 8.0 * u + 14.0 * np.sin(np.pi * u), 14.0 + 24.0 * u])


def picture(frame: int) -> UInt8:
    places = np.stack(np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5), axis=-1)
    image = BACKGROUND.at(places)
    for pattern, line, at in ((LIMB, CORNERS, place(frame)), (COVER, BEFORE, np.array([80.0 + frame, 15.0]))):
        image = np.where(polyline_mask(places - at, line)[..., None], pattern.at(places - at), image)
    return np.round(255.0 * image).astype(np.uint8)


PICTURES = {frame: picture(frame) for frame in range(LAST + 1)}


def keyed(*frames: int) -> RotoShape:
    return RotoShape("limb", "Limb", tuple(Keyframe(frame, outline(frame)) for frame in frames))


def outline(frame: int) -> Array:
    return polygon_points(CORNERS + place(frame))


def overlaps(shape: RotoShape) -> list[float]:
    """IoU with the true limb on the frames between."""
    found = []
    for frame in range(FIRST + 1, LAST):
        true = RotoShape("true", "True", (Keyframe(frame, outline(frame)),))
        ours, theirs = (render_matte([each], frame, SIZE) > 0.5 for each in (shape, true))
        found.append(float((ours & theirs).sum() / (ours | theirs).sum()))
    return found


@pytest.fixture(scope="module")
def filled() -> RotoShape:
    [shape] = fill_span(PICTURES, [keyed(SEEN, FIRST, LAST)], FIRST, LAST)
    return shape


def test_the_key_that_shows_it_tells_its_look(filled: RotoShape) -> None:
    [without] = fill_span(PICTURES, [keyed(FIRST, LAST)], FIRST, LAST)
    assert np.mean(overlaps(without)) < 0.5
    assert min(overlaps(filled)) > 0.85


def test_its_keys_are_stale_once_that_key_changes(filled: RotoShape) -> None:
    key = filled.key_at(FIRST + 1)
    assert key is not None
    assert Stamp.read(key.inputs).asked_beyond
    stamps = Stamps([filled])
    assert stamps.is_filled(filled, key, (FIRST, LAST), params_for("best"))
    assert not stamps.is_stale(filled, key)
    seen = filled.key_at(SEEN)
    assert seen is not None
    moved = filled.with_keys([Keyframe(SEEN, seen.points + 1.0)])
    assert Stamps([moved]).is_stale(moved, key)
    earlier = filled.with_keys([Keyframe(SEEN - 9, seen.points)])  # not the nearest one: it was not asked
    assert not Stamps([earlier]).is_stale(earlier, key)


def test_where_the_picture_of_that_key_is_not_to_be_had_the_two_keys_tell_alone() -> None:
    images = {frame: image for frame, image in PICTURES.items() if frame >= FIRST}
    [lacking] = fill_span(images, [keyed(SEEN, FIRST, LAST)], FIRST, LAST)
    [without] = fill_span(images, [keyed(FIRST, LAST)], FIRST, LAST)
    for frame in range(FIRST + 1, LAST):
        np.testing.assert_array_equal(lacking.at(frame).points, without.at(frame).points)


def test_the_nearest_keys_beyond_a_gap_are_those_that_all_shapes_have() -> None:
    shape, other = keyed(SEEN, FIRST, 6, LAST), keyed(SEEN, 6, 8, LAST)
    assert keys_beyond([shape], (FIRST, 6)) == [SEEN, LAST]
    assert keys_beyond([shape, other], (6, LAST)) == [SEEN]
