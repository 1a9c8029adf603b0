"""The patches of a key, learned and followed over pictures whose motion is known."""

from __future__ import annotations

import cv2
import numpy as np
import numpy.testing as npt
import pytest

from roam_core.arrays import Array, Bools
from roam_core.features import PreparedFrame, Region
from roam_core.features.grid import Grid
from roam_core.motion.flow import dense_flow
from roam_core.motion.patches import Levels, Patches, PatchMotion
from roam_core.params.patches import PatchParams

PARAMS = PatchParams()
SIZE = 120, 160
GRID = Grid.over(Region(0, 0, SIZE[1], SIZE[0]), 1.0)
TURN = cv2.getRotationMatrix2D((80.0, 60.0), 6.0, 1.05)
"""A turn and growth about the middle, with a move beside it."""
TURN[:, 2] += (4.0, -2.0)


def texture(seed: int) -> Array:
    rough = np.random.default_rng(seed).integers(0, 256, (*SIZE, 3)).astype(np.uint8)
    return np.asarray(cv2.normalize(cv2.GaussianBlur(rough, (0, 0), 2.0), None, 30, 220, cv2.NORM_MINMAX))  # type: ignore[call-overload]


def card() -> Bools:
    inside = np.zeros(SIZE, np.bool_)
    inside[30:90, 45:115] = True
    return inside


def scene(motion: Array | None = None) -> PreparedFrame:
    """A textured card before another texture, as it was, or as an affine map `(2, 3)` of pixels' corners moves it."""
    image, mask = texture(2), card().astype(np.uint8)
    if motion is not None:
        centred = motion.copy()
        centred[:, 2] += 0.5 * (motion[:, :2].sum(axis=1) - 1.0)
        image, mask = (cv2.warpAffine(each, centred, SIZE[::-1]) for each in (image, mask))
    return PreparedFrame(np.where(mask[..., None] > 0, image, texture(1)).astype(np.uint8))


def learned(visible: Bools | None = None, params: PatchParams = PARAMS) -> Patches:
    found = Patches.learned(scene(), card(), card() if visible is None else visible, GRID, 1.0, params)
    assert found is not None
    return found


def followed(patches: Patches, motion: PatchMotion, before: PreparedFrame, after: PreparedFrame) -> PatchMotion:
    forward, _ = dense_flow(before, after, GRID, is_exact=True)
    return patches.step(motion, Levels.of(after, GRID, PARAMS), GRID, forward)


def test_on_the_key_patches_lie_where_they_were_learned() -> None:
    patches = learned()
    points = np.random.default_rng(0).uniform(45.0, 75.0, (5, 3, 2))
    there, sure = patches.carried_points(patches.on_key, points)
    npt.assert_allclose(there, points, atol=1e-9)
    assert (sure > 0.3).all()


def test_no_patch_is_learned_of_what_is_hidden_or_far_from_the_outline() -> None:
    visible = card()
    visible[:, 80:] = False
    assert learned(visible).templates.places[..., 0].max() < 80.0
    deep = learned().templates.centres
    spans = np.minimum.reduce([deep[:, 0] - 45.0, 115.0 - deep[:, 0], deep[:, 1] - 30.0, 90.0 - deep[:, 1]])
    assert 0.0 < spans.max() < PARAMS.inner * PARAMS.reach * PARAMS.spacing + 1.0


def test_nothing_is_learned_of_nothing() -> None:
    none = np.zeros(SIZE, np.bool_)
    assert Patches.learned(scene(), none, none, GRID, 1.0, PARAMS) is None
    assert Patches.learned(scene(), card(), none, GRID, 1.0, PARAMS) is None


def test_patches_never_are_more_than_asked_for() -> None:
    few = learned(params=PatchParams(most=6))
    assert 0 < len(few.templates.centres) <= 6
    assert few.radius > learned().radius


def test_a_card_that_turns_and_grows_is_followed_from_the_key() -> None:
    patches, before = learned(), scene()
    motion, steps = patches.on_key, 4
    for k in range(1, steps + 1):
        part = np.eye(2, 3) + (TURN - np.eye(2, 3)) * (k / steps)
        after = scene(part)
        motion = followed(patches, motion, before, after)
        before = after
    corners = np.array([[46.0, 31.0], [114.0, 31.0], [114.0, 89.0], [46.0, 89.0], [80.0, 31.0]])[:, None]
    there, sure = patches.carried_points(motion, np.repeat(corners, 3, axis=1))
    npt.assert_allclose(there[:, 0], corners[:, 0] @ TURN[:, :2].T + TURN[:, 2], atol=0.4)
    assert (sure > 0.3).all()
    inside, outside = patches.sides(motion, Levels.of(before, GRID, PARAMS))
    truth = cv2.warpAffine(card().astype(np.uint8), TURN, SIZE[::-1]) > 0
    assert (inside > 0.3).sum() > 500
    assert truth[inside > 0.3].mean() > 0.99
    assert (outside > 0.3).sum() > 500
    assert (~truth)[outside > 0.3].mean() > 0.99


def test_what_was_hidden_is_found_again_where_its_neighbours_are() -> None:
    patches = learned()
    hidden = scene().image.copy()
    hidden[:, 84:] = texture(7)[:, 84:]
    gone = followed(patches, patches.on_key, scene(), PreparedFrame(hidden))
    right = patches.templates.centres[:, 0] > 95.0
    assert gone.likeness[right].max() < 0.7 < gone.likeness[~right].mean()
    assert patches.weights(gone)[right].max() < 0.5
    back = followed(patches, gone, PreparedFrame(hidden), scene())
    assert back.likeness.min() > 0.95
    npt.assert_allclose(back.affines[:, :2], patches.templates.centres, atol=0.2)


def test_handles_go_with_their_anchors() -> None:
    patches = learned()
    linear = np.array([[0.0, -1.0], [1.0, 0.0]])
    transform = np.eye(3)
    transform[:2, :2], transform[:2, 2] = linear, (3.0, 4.0)
    point = np.array([[[50.0, 40.0], [45.0, 38.0], [55.0, 42.0]]])
    there, sure = patches.carried_points(patches.carried(transform, 1.0), point)
    npt.assert_allclose(there, point @ linear.T + (3.0, 4.0), atol=1e-9)
    assert sure == pytest.approx(patches.carried_points(patches.on_key, point)[1])


def test_where_no_patch_is_near_nothing_is_expected() -> None:
    far = np.full((1, 3, 2), 5.0)
    there, sure = learned().carried_points(learned().on_key, far)
    assert sure == 0.0
    assert np.isfinite(there).all()


def test_what_lies_beside_the_object_is_believed_less_from_frame_to_frame() -> None:
    patches = learned()
    left = card()
    left[:, 80:] = False
    first = patches.judged(patches.on_key, left, GRID)
    second = patches.judged(first, left, GRID)
    right = patches.templates.centres[:, 0] > 105.0
    npt.assert_allclose(first.agreed[right], 0.5)
    npt.assert_allclose(second.agreed[right], 0.25)
    npt.assert_allclose(second.agreed[patches.templates.centres[:, 0] < 55.0], 1.0)
    assert patches.weights(second)[right].max() < 0.3
    there, _ = patches.carried_points(second, np.full((1, 3, 2), 60.0))
    npt.assert_allclose(there, 60.0)


def test_a_patch_beyond_the_grid_is_on_no_object() -> None:
    patches = learned()
    away = np.eye(3)
    away[0, 2] = 1000.0
    gone = patches.judged(patches.carried(away, 1.0), np.ones(SIZE, np.bool_), GRID)
    npt.assert_allclose(gone.agreed, 0.5)
