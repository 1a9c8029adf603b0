"""The pose of a part: a motion that was planted is found, what is hidden does not disturb, what is not seen is told."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from roam_core.arrays import Array, Bools
from roam_core.features import PreparedFrame, Region
from roam_core.features.pyramid import Pyramid
from roam_core.geometry import polyline
from roam_core.kernels.posing import Ties
from roam_core.motion.pose import NOTHING, Pose, Surroundings
from roam_core.motion.template import Template
from roam_core.params import CONFIGS, PoseParams, PyramidParams, RegionParams
from tests.golden.shots import texture

SIZE = 120, 160
WHOLE = Region(0, 0, 160, 120)
BODY, BACKGROUND = texture(3, 0.45, 1.0, 24), texture(4, 0.0, 0.35, 24)


def part_params() -> PoseParams:
    region = CONFIGS["best"].region
    assert region is not None
    assert region.part is not None
    return region.part


PARAMS = part_params()


def box(x: float, y: float, width: float, height: float) -> Array:
    corners = np.array([(x, y), (x + width, y), (x + width, y + height), (x, y + height)], dtype=np.float64)
    return polyline.resample(corners, 160)


PATCH = box(55, 40, 44, 36)
LIMB = box(40, 52, 76, 16)


def centres() -> Array:
    return np.stack(np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5), axis=-1)


def shown(template: Template, pose: Array, line: Array, *, blind: Array | None = None) -> PreparedFrame:
    """A picture of the part under a pose: each pixel shows the place of the key that the pose brings there."""
    key = centres()
    for _ in range(30):  # fixed point: the place whose image this pixel is
        key = key - (template.chain.carried(pose, key.reshape(-1, 2)).reshape(key.shape) - centres())
    inside = polyline_mask(key, line)[..., None]
    image = np.where(inside, BODY.at(key), BACKGROUND.at(centres()))
    if blind is not None:
        image = np.where(polyline_mask(centres(), blind)[..., None], (0.9, 0.1, 0.1), image)
    return PreparedFrame(np.round(255.0 * image).astype(np.uint8))


def polyline_mask(places: Array, line: Array) -> Bools:
    """Which places lie inside an upright box."""
    low, high = line.min(axis=0), line.max(axis=0)
    return np.asarray(((places > low) & (places < high)).all(axis=-1))


def learned(line: Array, params: PoseParams = PARAMS) -> Template:
    """The template of a part on its key, where it is at rest."""
    image = np.where(polyline_mask(centres(), line)[..., None], BODY.at(centres()), BACKGROUND.at(centres()))
    frame = PreparedFrame(np.round(255.0 * image).astype(np.uint8))
    template = Template.of(Pyramid.of(frame, WHOLE, 1.0, PyramidParams()), line, params, 1.0)
    assert template is not None
    return template


def unhidden(pyramid: Pyramid) -> Surroundings:
    """A frame on which nothing is known to lie around the part."""
    return Surroundings(pyramid, pyramid.nothing)


def off(template: Template, found: Array, planted: Array, line: Array) -> float:
    """How far apart two poses put the part's outline, pixels, at most."""
    ours, true = (template.chain.carried(pose, line) for pose in (found, planted))
    return float(np.hypot(*(ours - true).T).max())


@pytest.mark.parametrize(
    "planted",
    [
        (0.0, 0.0, 0.0, 0.0, 0.0, 0.0),
        (1.4, -0.8, 0.0, 0.0, 0.0, 0.0),
        (6.3, 4.1, 0.0, 0.0, 0.0, 0.0),
        (2.0, -3.0, 0.15, 0.0, 0.0, 0.0),
        (1.0, 1.0, -0.1, 0.04, -0.03, 0.0),
        (-1.0, 2.0, 0.05, 0.02, 0.02, 0.02),
    ],
    ids=["still", "little", "far", "turned", "stretched", "sheared"],
)
def test_a_motion_that_was_planted_is_found(planted: tuple[float, ...]) -> None:
    template, pose = learned(PATCH), np.array(planted)
    frame = shown(template, pose, PATCH)
    around = unhidden(Pyramid.of(frame, WHOLE, 1.0, PyramidParams()))
    found = Pose.on_key(template, PARAMS).step(around, PARAMS)
    assert off(template, found.values, pose, PATCH) < 0.5
    assert found.cost < PARAMS.lost
    assert found.since == 0
    assert found.seen == 1.0
    np.testing.assert_array_equal(found.velocity[:3], found.values[:3])
    assert found.support(found.carried(PATCH)).min() > 0.6


@pytest.mark.parametrize("bend", [0.2, -0.25])
def test_a_bend_that_was_planted_is_found(bend: float) -> None:
    template = learned(LIMB)
    assert template.chain.count == 2
    pose = np.array([1.0, -1.0, 0.0, bend, 0.0, 0.0, 0.0])
    around = unhidden(Pyramid.of(shown(template, pose, LIMB), WHOLE, 1.0, PyramidParams()))
    found = Pose.on_key(template, PARAMS).step(around, PARAMS)
    assert off(template, found.values, pose, LIMB) < 0.8
    assert found.values[3] - found.values[2] == pytest.approx(bend, abs=0.05)


def test_it_does_not_drift() -> None:
    """Frame after frame it is matched to its key: in the end it is as close as in the beginning."""
    template, pose = learned(PATCH), Pose.on_key(learned(PATCH), PARAMS)
    for k in range(1, 9):
        planted = np.array([1.6 * k, -0.9 * k, 0.04 * k, 0.0, 0.0, 0.0])
        pose = pose.step(unhidden(Pyramid.of(shown(template, planted, PATCH), WHOLE, 1.0, PyramidParams())), PARAMS)
        assert off(template, pose.values, planted, PATCH) < 0.5


@pytest.mark.parametrize("told", [True, False])
def test_a_half_that_is_hidden_does_not_disturb(told: bool) -> None:
    template, planted = learned(PATCH), np.array([2.0, -1.5, 0.06, 0.0, 0.0, 0.0])
    cover = box(78, 20, 60, 80)
    pyramid = Pyramid.of(shown(template, planted, PATCH, blind=cover), WHOLE, 1.0, PyramidParams())
    around = Surroundings(pyramid, pyramid.outlined([cover]) if told else pyramid.nothing)
    found = Pose.on_key(template, PARAMS).step(around, PARAMS)
    assert off(template, found.values, planted, PATCH) < 0.8
    if told:
        assert found.seen == pytest.approx(0.5, abs=0.15)
        assert found.unlike < 0.2
    else:
        assert found.seen == 1.0
        assert found.unlike > 0.3


def test_what_hides_a_part_unknown_does_not_pass_for_a_new_look_of_it() -> None:
    """In doubt it learns nothing where more may lie before it than is known."""
    template, planted = learned(PATCH), np.array([2.0, -1.5, 0.06, 0.0, 0.0, 0.0])
    pyramid = Pyramid.of(shown(template, planted, PATCH, blind=box(40, 10, 98, 98)), WHOLE, 1.0, PyramidParams())
    likes = {}
    for is_complete in (True, False):
        around = Surroundings(pyramid, pyramid.nothing, is_complete=is_complete)
        found = Pose.on_key(template, PARAMS).step(around, PARAMS)
        likes[is_complete] = found.like / PARAMS.like[0], found.since
    assert likes[False] == (1.0, 1)
    assert likes[True][0] > 1.3


def test_where_another_picture_is_the_part_is_in_doubt_and_looked_for_farther() -> None:
    template = learned(PATCH)
    blank = PreparedFrame(np.full((*SIZE, 3), (230, 20, 20), np.uint8))
    around = unhidden(Pyramid.of(blank, WHOLE, 1.0, PyramidParams()))
    first = Pose.on_key(template, PARAMS).step(around, PARAMS)
    second = first.step(around, PARAMS)
    assert first.unlike > 0.8
    assert (first.since, second.since) == (1, 2)
    assert first.reach(PARAMS) < second.reach(PARAMS) <= PARAMS.widened
    assert np.isfinite(second.values).all()


def test_behind_everything_it_goes_on_as_expected() -> None:
    template = learned(PATCH)
    pyramid = Pyramid.of(shown(template, template.chain.rest, PATCH), WHOLE, 1.0, PyramidParams())
    hidden = tuple(np.ones_like(each) for each in pyramid.nothing)
    before = replace(Pose.on_key(template, PARAMS), velocity=np.array([2.0, 1.0, 0.0, 0.0, 0.0, 0.0]))
    found = before.step(Surroundings(pyramid, hidden), PARAMS)
    np.testing.assert_allclose(found.values, before.expected(PARAMS), atol=0.1)
    assert (found.seen, found.unlike) == (0.0, 1.0)
    np.testing.assert_array_equal(found.support(PATCH), 0.0)


def test_missed_is_told() -> None:
    pose = Pose.on_key(learned(PATCH), PARAMS)
    missed = pose.missed()
    assert (missed.cost, missed.since, missed.seen, missed.unlike) == (1.0, 1, 0.0, 1.0)
    assert missed.look is NOTHING
    np.testing.assert_array_equal(missed.values, pose.values)
    np.testing.assert_array_equal(missed.velocity, 0.0)


def test_a_spring_pulls_where_nothing_is_to_be_seen() -> None:
    template = learned(PATCH)
    pyramid = Pyramid.of(shown(template, template.chain.rest, PATCH), WHOLE, 1.0, PyramidParams())
    hidden = tuple(np.ones_like(each) for each in pyramid.nothing)
    middle = PATCH.mean(axis=0)[None]
    ties = Ties(middle, template.chain.skin(middle), middle + np.array([[3.0, 0.0]]), np.array([PARAMS.tie]), 6.0)
    found = Pose.on_key(template, PARAMS).step(Surroundings(pyramid, hidden, None, ties), PARAMS)
    assert 0.3 < found.carried(middle)[0, 0] - middle[0, 0] <= 3.05
    assert found.values[1] == pytest.approx(0.0, abs=0.05)


def test_too_little_of_a_part_is_no_template() -> None:
    frame = shown(learned(PATCH), np.zeros(6), PATCH)
    pyramid = Pyramid.of(frame, WHOLE, 1.0, PyramidParams())
    assert Template.of(pyramid, box(60, 60, 4, 4), PARAMS, 1.0) is None
    assert Template.of(pyramid, PATCH, PARAMS, 1.0, [box(0, 0, 160, 120)]) is None
    assert Template.of(pyramid, box(-500, -500, 40, 40), PARAMS, 1.0) is None
    assert Template.of(pyramid, PATCH, PARAMS, 1.0, [box(0, 0, 80, 120)]) is not None


def test_the_same_part_gives_the_same_samples() -> None:
    one, other = learned(PATCH), learned(PATCH)
    for a, b in zip(one.levels, other.levels, strict=True):
        for mine, theirs in zip(a, b, strict=True):
            np.testing.assert_array_equal(mine, theirs)
        assert a.weights[a.weights > 0].sum() == pytest.approx(1.0)
    assert one.seam < 0.5


def test_a_part_like_its_ground_has_a_seam_all_around() -> None:
    frame = PreparedFrame(np.full((*SIZE, 3), 90, np.uint8))
    template = Template.of(Pyramid.of(frame, WHOLE, 1.0, PyramidParams()), PATCH, PARAMS, 1.0)
    assert template is not None
    assert (template.seam, template.densest_seam) == (1.0, 1.0)


def bordered(nothing: Callable[[int, int], bool]) -> Template:
    """Of a square before grey ground, whose border is as grey at the places (x, y) that `nothing` names."""
    picture = np.full((*SIZE, 3), 90, np.uint8)
    picture[40:80, 60:100] = (200, 60, 40)
    for y in range(40, 80):
        for x in range(60, 100):
            if nothing(x, y):
                picture[y, x] = 90
    frame = PreparedFrame(picture)
    template = Template.of(Pyramid.of(frame, WHOLE, 1.0, PyramidParams()), box(60, 40, 40, 40), PARAMS, 1.0)
    assert template is not None
    return template


def test_a_seam_in_one_place_is_where_a_limb_hangs_on() -> None:
    in_one = bordered(lambda x, y: y >= 66)
    here_and_there = bordered(lambda x, y: min(abs(x - 80), abs(y - 60)) < 5 and max(abs(x - 80), abs(y - 60)) > 8)
    assert here_and_there.seam > 0.1
    assert in_one.densest_seam == 1.0
    assert here_and_there.densest_seam < RegionParams().pose_densest_seam


def still_over(pyramid: Pyramid, drift: Array) -> Surroundings:
    """A frame of a lone part: what lies around it moved by `drift`."""
    return Surroundings(pyramid, pyramid.nothing, is_complete=False, drift=lambda _: drift)


def test_a_lone_part_that_something_hides_goes_along_with_it_and_is_found_again() -> None:
    template, drift = learned(PATCH), np.array([2.0, 1.0])
    blank = PreparedFrame(np.full((*SIZE, 3), (230, 20, 20), np.uint8))
    behind = still_over(Pyramid.of(blank, WHOLE, 1.0, PyramidParams()), drift)
    first = Pose.on_key(template, PARAMS).step(behind, PARAMS)
    assert first.is_gone
    assert first.cost == 1.0
    np.testing.assert_allclose(first.values[:2], (1.0 - PARAMS.momentum) * drift)
    second = first.step(behind, PARAMS)
    assert second.is_gone
    np.testing.assert_allclose(second.velocity[:2], (1.0 - PARAMS.momentum) * (1.0 + PARAMS.momentum) * drift)
    planted = np.array([3.0, 2.0, 0.0, 0.0, 0.0, 0.0])
    out = still_over(Pyramid.of(shown(template, planted, PATCH), WHOLE, 1.0, PyramidParams()), drift)
    found = second.step(out, PARAMS)
    assert not found.is_gone
    assert off(template, found.values, planted, PATCH) < 0.5


def test_a_lone_part_that_slowly_changed_its_look_is_not_taken_for_hidden() -> None:
    template = learned(PATCH)
    blank = PreparedFrame(np.full((*SIZE, 3), (230, 20, 20), np.uint8))
    around = still_over(Pyramid.of(blank, WHOLE, 1.0, PyramidParams()), np.zeros(2))
    changed = replace(Pose.on_key(template, PARAMS), unclear=5).step(around, PARAMS)
    assert not changed.is_gone
    assert changed.since == 1


def test_a_quarter_that_looks_as_on_the_key_is_enough_to_be_seen_clearly() -> None:
    template, planted = learned(PATCH), np.array([2.0, -1.5, 0.0, 0.0, 0.0, 0.0])
    pyramid = Pyramid.of(shown(template, planted, PATCH, blind=box(40, 10, 40, 98)), WHOLE, 1.0, PyramidParams())
    found = Pose.on_key(template, PARAMS).step(still_over(pyramid, np.zeros(2)), PARAMS)
    assert not found.is_gone
    assert found.look is not None
    assert found.look.closest < PARAMS.clear < PARAMS.gone < found.look.difference


COVER = box(20, 30, 120, 50)
"""What hides the limb where it lies on its key."""


def gone_behind(template: Template) -> Pose:
    """The pose of the limb after eight frames behind the cover."""
    behind = Pyramid.of(shown(template, np.zeros(7), LIMB, blind=COVER), WHOLE, 1.0, PyramidParams())
    pose = Pose.on_key(template, PARAMS)
    for _ in range(8):
        pose = pose.step(Surroundings(behind, behind.outlined([COVER])), PARAMS)
    assert pose.seen < PARAMS.glimpse
    return pose


@pytest.mark.parametrize("darker", [0, 14], ids=["the limb", "what is darker throughout"])
def test_a_hidden_part_is_found_where_it_is_clearly_seen_again(darker: int) -> None:
    """It comes out turned, far from where it was expected. What is like it, but nowhere clearly, is not taken."""
    template, planted = learned(LIMB), np.array([0.0, 42.0, 0.5, 0.5, 0.0, 0.0, 0.0])
    pose, image = gone_behind(template), shown(template, planted, LIMB, blind=COVER).image
    out = Pyramid.of(PreparedFrame(np.maximum(image, darker) - np.uint8(darker)), WHOLE, 1.0, PyramidParams())
    around = Surroundings(out, out.outlined([COVER]))
    found = pose.step(around, PARAMS)
    if darker:
        assert found.seen < PARAMS.glimpse
    else:
        assert off(template, found.values, planted, LIMB) < 1.5
        assert found.seen > PARAMS.glimpse


def test_a_part_is_looked_for_far_away_only_where_it_is_sought() -> None:
    template, planted = learned(LIMB), np.array([0.0, 42.0, 0.5, 0.5, 0.0, 0.0, 0.0])
    out = Pyramid.of(shown(template, planted, LIMB, blind=COVER), WHOLE, 1.0, PyramidParams())
    around = Surroundings(out, out.outlined([COVER]), is_sought=False)
    assert gone_behind(template).step(around, PARAMS).seen < PARAMS.glimpse
