"""Articulated templates, against plain NumPy, against finite differences, and on poses that were planted."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.kernels import posing
from roam_core.kernels.posing import RIM, Costs, Prior, Samples, Ties, View, affines, energies, refined
from tests.reference.posing import ref_affines, ref_carried, ref_energy
from tests.unit.kernels.conftest import EXACT, needs_compiler

ONE = np.array([[30.0, 25.0, -1.0, 0.4]])
TWO = np.array([[24.0, 25.0, -1.0, 0.1], [32.0, 26.0, 0.0, 0.2]])
FOUR = np.array([[24.0, 25.0, -1.0, 0.1], [32.0, 26.0, 0.0, 0.2], [40.0, 27.0, 1.0, 0.0], [18.0, 24.0, 0.0, 3.0]])
CHAINS = pytest.mark.parametrize("bones", [ONE, TWO, FOUR], ids=["one", "two", "branching"])
COSTS = Costs(12.0, 8.0, 0.6, 0.7, 0.2, 0.01)
SIZE = 64, 80
NO_TIES = Ties(np.zeros((0, 2)), np.zeros((0, 1)), np.zeros((0, 2)), np.zeros(0), 1.0)


def picture(places: Array) -> Array:
    """A smooth pattern `(..., 3)` at real places `(..., 2)`, with one period for each channel."""
    x, y = np.moveaxis(places, -1, 0)
    waves = [np.sin(x / 3.1) + np.cos(y / 4.3), np.sin((x + y) / 5.7), np.cos((x - 2.0 * y) / 7.9) + np.sin(y / 2.9)]
    return 50.0 + 20.0 * np.stack(waves, axis=-1)


def centres(scale: float = 1.0, left: float = 0.0, top: float = 0.0) -> Array:
    """Where the cells of a view lie in the whole picture `(h, w, 2)`."""
    columns, rows = np.meshgrid(np.arange(SIZE[1]) + 0.5, np.arange(SIZE[0]) + 0.5)
    return np.stack([columns, rows], axis=-1) / scale + (left, top)


def a_view(bones: Array, pose: Array, *, hidden: bool = False, needs: bool = False) -> View:
    """A view that shows the pattern as the first bone carries it."""
    matrix = ref_affines(bones, pose)[0]
    back = (centres() - matrix[:, 2]) @ np.linalg.inv(matrix[:, :2]).T
    cover, need = np.zeros(SIZE, np.uint8), np.zeros(SIZE, np.float32)
    if hidden:
        cover[20:30, 20:36] = 1
    if needs:
        need[:] = np.exp(-((centres() - (32.0, 28.0)) ** 2).sum(axis=-1) / 200.0)
    return View(picture(back).astype(np.float32), 1.0, 1.0, 0.0, 0.0, cover, need)


def samples_of(bones: Array, count: int = 120, seed: int = 0) -> Samples:
    """Places around the middle with the colours of the pattern; the last fifth lies beside the outline."""
    rng = np.random.default_rng(seed)
    places = rng.uniform((14.0, 14.0), (46.0, 36.0), (count, 2))
    weights = np.full(count, 1.0 / (count - count // 5))
    weights[-(count // 5) :] = -rng.uniform(0.0, 0.01, count // 5)
    skin = rng.dirichlet(np.ones(len(bones)), count)
    skin[: count // 2] = np.eye(len(bones))[rng.integers(0, len(bones), count // 2)]
    return Samples(places, picture(places), weights, skin)


def prior_of(bones: Array, firmness: float = 0.01) -> Prior:
    size, rng = 5 + len(bones), np.random.default_rng(1)
    loose = firmness * rng.uniform(0.5, 1.5, size)
    return Prior(0.01 * rng.normal(size=size), loose, 0.5 * loose, firmness, 0.5 * firmness)


def ties_of(bones: Array) -> Ties:
    skin = np.random.default_rng(2).dirichlet(np.ones(len(bones)), 2)
    places = np.array([[16.0, 20.0], [44.0, 30.0]])
    return Ties(places, skin, places + np.array([1.5, -2.0]), np.array([0.3, 0.05]), 6.0)


def poses_of(bones: Array, count: int = 6, spread: float = 1.0) -> Array:
    count_of, rng = len(bones), np.random.default_rng(3)
    scales = np.array([3.0, 3.0, *[0.2] * count_of, 0.05, 0.05, 0.05]) * spread
    return np.vstack([np.zeros(5 + count_of), rng.normal(size=(count - 1, 5 + count_of)) * scales])


@CHAINS
def test_affines_are_those_of_the_twin(bones: Array) -> None:
    for pose in poses_of(bones, 12, 2.0):
        np.testing.assert_allclose(affines(bones, pose), ref_affines(bones, pose), atol=1e-9)


@CHAINS
def test_the_rest_pose_moves_nothing_and_a_joint_holds(bones: Array) -> None:
    rest = affines(bones, np.zeros(5 + len(bones)))
    np.testing.assert_allclose(rest, np.tile(np.eye(2, 3), (len(bones), 1, 1)), atol=1e-12)
    moved = affines(bones, poses_of(bones)[1])
    for k, (x, y, parent, _) in enumerate(bones):
        if parent >= 0:
            np.testing.assert_allclose(moved[k] @ [x, y, 1.0], moved[int(parent)] @ [x, y, 1.0], atol=1e-9)


@CHAINS
@pytest.mark.parametrize("spread", [1.0, 12.0], ids=["inside", "partly outside"])
@pytest.mark.parametrize("known", [False, True], ids=["free", "hidden and needed"])
def test_energies_are_those_of_the_twin(bones: Array, spread: float, known: bool) -> None:
    view, samples = a_view(bones, poses_of(bones)[1], hidden=known, needs=known), samples_of(bones)
    poses, prior, ties = poses_of(bones, 8, spread), prior_of(bones), ties_of(bones)
    found = energies(view, samples, bones, poses, COSTS, prior, ties)
    expected = [ref_energy(view, samples, bones, pose, COSTS, prior, ties) for pose in poses]
    np.testing.assert_allclose(found, expected, rtol=EXACT, atol=1e-12)
    assert np.ptp(found) > 1e-3


def test_a_part_of_a_picture_at_a_coarser_scale_is_the_same_place() -> None:
    pose, samples = np.zeros(6), samples_of(ONE)
    whole = energies(a_view(ONE, pose), samples, ONE, pose[None], COSTS, prior_of(ONE), NO_TIES)
    fine = View(
        picture(centres(2.0, 12.0, 10.0)).astype(np.float32), 2.0, 2.0, 12.0, 10.0,
        np.zeros(SIZE, np.uint8), np.zeros(SIZE, np.float32),
    )  # fmt: skip
    seen = (samples.places > (14.0, 12.0)).all(axis=1) & (samples.places < (50.0, 40.0)).all(axis=1)
    assert seen.all()
    np.testing.assert_allclose(
        energies(fine, samples, ONE, pose[None], COSTS, prior_of(ONE), NO_TIES), whole, atol=0.02
    )


@CHAINS
@pytest.mark.parametrize("known", [False, True], ids=["free", "hidden and needed"])
def test_what_a_refined_pose_costs_is_the_twins_and_no_more_than_the_start(bones: Array, known: bool) -> None:
    view, samples = a_view(bones, poses_of(bones)[1], hidden=known, needs=known), samples_of(bones)
    prior, ties = prior_of(bones), ties_of(bones)
    for start in poses_of(bones):
        pose, cost = refined(view, samples, bones, start, COSTS, prior, ties, 12)
        assert cost == pytest.approx(ref_energy(view, samples, bones, pose, COSTS, prior, ties, RIM), rel=EXACT)
        assert cost <= ref_energy(view, samples, bones, start, COSTS, prior, ties, RIM) + 1e-12


@CHAINS
def test_it_ends_where_prior_and_ties_have_no_slope(bones: Array) -> None:
    samples, prior, ties = samples_of(bones), prior_of(bones, 1.0), ties_of(bones)
    image, hidden = np.zeros((*SIZE, 3), np.float32), np.ones(SIZE, np.uint8)
    view = View(image, 1.0, 1.0, 0.0, 0.0, hidden, np.zeros(SIZE, np.float32))
    for start in poses_of(bones, 4, 0.3):
        pose, _ = refined(view, samples, bones, start, COSTS, prior, ties, 60)
        slopes = [slope(view, samples, bones, each, COSTS, prior, ties) for each in (start, pose)]
        assert np.abs(slopes[1]).max() < 0.05 * np.abs(slopes[0]).max() + 2e-3


@CHAINS
def test_a_short_step_goes_down_the_slope_that_finite_differences_tell(bones: Array) -> None:
    """Where the prior is much firmer than the picture, the step is the slope over the firmness."""
    size = 5 + len(bones)
    start, samples = poses_of(bones)[2] * 0.1, samples_of(bones, 400)
    view, costs = a_view(bones, poses_of(bones)[1]), COSTS._replace(like=60.0, needless=0.0, needed=0.0)
    firmness = 0.3 * np.array([1.0, 1.0, *[200.0] * (size - 2)])
    prior = Prior(start, firmness, np.zeros(size), 0.0, 0.0)
    ties = NO_TIES._replace(skin=np.zeros((0, len(bones))))
    pose, _ = refined(view, samples, bones, start, costs, prior, ties, 2)
    expected = -slope(view, samples, bones, start, costs, prior, ties) / firmness
    assert np.abs(expected[:2]).max() > 0.02
    np.testing.assert_allclose(pose - start, expected, rtol=0.15, atol=0.05 * np.abs(expected[2:]).max())


def slope(view: View, samples: Samples, bones: Array, pose: Array, costs: Costs, prior: Prior, ties: Ties) -> Array:
    """The derivative `(P,)` of the twin's energy by finite differences."""
    ends = [
        [ref_energy(view, samples, bones, pose + side * step, costs, prior, ties, RIM) for side in (1.0, -1.0)]
        for step in 1e-5 * np.eye(len(pose))
    ]
    return np.array([(ahead - behind) / 2e-5 for ahead, behind in ends])


@pytest.mark.parametrize("planted", [(1.7, -2.3, 0.0, 0.0, 0.0, 0.0), (0.6, 1.1, 0.12, 0.0, 0.0, 0.0),
                                     (-1.2, 0.4, -0.08, 0.04, -0.03, 0.02)])  # fmt: skip
def test_a_planted_pose_is_found(planted: tuple[float, ...]) -> None:
    pose, samples = np.array(planted), samples_of(ONE, 400)
    view = a_view(ONE, pose)
    loose = Prior(np.zeros(6), np.full(6, 1e-6), np.full(6, 1e-6), 0.0, 0.0)
    found, cost = refined(view, samples, ONE, np.zeros(6), COSTS._replace(needless=0.0), loose, NO_TIES, 60)
    own = samples.weights > 0
    ours, true = (ref_carried(ONE, each, samples.places[own], samples.skin[own]) for each in (found, pose))
    assert np.hypot(*(ours - true).T).max() < 0.25
    assert cost <= ref_energy(view, samples, ONE, pose, COSTS._replace(needless=0.0), loose, NO_TIES, RIM) + 1e-3


@pytest.mark.parametrize("way", [(1, 0), (0, 1), (-1, 0), (0, -1)])
def test_places_that_need_the_part_draw_it_and_what_lies_beside_it_is_driven_off(way: tuple[int, int]) -> None:
    """In a picture of one colour nothing else tells where it lies."""
    samples = samples_of(ONE)
    samples = samples._replace(colours=np.full_like(samples.colours, 50.0))
    spot = samples.places.mean(axis=0) + 8.0 * np.array(way)
    need = np.exp(-((centres() - spot) ** 2).sum(axis=-1) / 200.0).astype(np.float32)
    view = View(np.full((*SIZE, 3), 50.0, np.float32), 1.0, 1.0, 0.0, 0.0, np.zeros(SIZE, np.uint8), need)
    stiff = Prior(np.zeros(6), np.array([1e-3, 1e-3, 10.0, 10.0, 10.0, 10.0]), np.zeros(6), 0.0, 0.0)
    for costs, sign in ((COSTS._replace(needed=0.0), 1.0), (COSTS._replace(needless=0.0, needed=0.05), -1.0)):
        pose, cost = refined(view, samples, ONE, np.zeros(6), costs, stiff, NO_TIES, 4)
        assert cost < ref_energy(view, samples, ONE, np.zeros(6), costs, stiff, NO_TIES, RIM) - 1e-5
        along, across = pose[:2] @ np.array(way), pose[:2] @ np.array(way[::-1])
        assert sign * along > 0.3
        assert abs(across) < 0.7 * abs(along)


def test_a_prior_alone_is_met_within_a_few_rounds() -> None:
    """It is quadratic: with the right curvature one step of Newton would do, and damping leaves a thousandth of it."""
    bones, size = FOUR, 5 + len(FOUR)
    samples = samples_of(bones)._replace(weights=np.zeros(120))
    view = View(
        np.zeros((*SIZE, 3), np.float32), 1.0, 1.0, 0.0, 0.0, np.ones(SIZE, np.uint8), np.zeros(SIZE, np.float32)
    )
    expected = np.random.default_rng(4).normal(0.0, 0.04, size)
    prior = Prior(expected, np.full(size, 0.2), np.full(size, 0.1), 3.0, 2.0)
    none = NO_TIES._replace(skin=np.zeros((0, len(bones))))
    pose, _ = refined(view, samples, bones, np.zeros(size), COSTS, prior, none, 3)
    before, after = (slope(view, samples, bones, each, COSTS, prior, none) for each in (np.zeros(size), pose))
    assert np.abs(after).max() < 1e-3 * np.abs(before).max()


def test_a_bend_that_was_planted_is_found() -> None:
    """Two bones, each with samples of its own: one turns, the other stays."""
    bones, rng = TWO, np.random.default_rng(5)
    left = rng.uniform((14.0, 18.0), (31.0, 32.0), (200, 2))
    right = rng.uniform((33.0, 18.0), (50.0, 32.0), (200, 2))
    places, skin = np.vstack([left, right]), np.repeat(np.eye(2), 200, axis=0)
    samples = Samples(places, picture(places), np.full(400, 1.0 / 400), skin)
    pose = np.array([0.0, 0.0, 0.0, 0.15, 0.0, 0.0, 0.0])
    matrix = ref_affines(bones, pose)[1]
    back = (centres() - matrix[:, 2]) @ np.linalg.inv(matrix[:, :2]).T
    image = np.where((back[..., :1] > 32.0), picture(back), picture(centres())).astype(np.float32)
    view = View(image, 1.0, 1.0, 0.0, 0.0, np.zeros(SIZE, np.uint8), np.zeros(SIZE, np.float32))
    none = NO_TIES._replace(skin=np.zeros((0, 2)))
    loose = Prior(np.zeros(7), np.full(7, 1e-6), np.full(7, 1e-6), 1e-6, 1e-6)
    found, _ = refined(view, samples, bones, np.zeros(7), COSTS._replace(needless=0.0), loose, none, 60)
    np.testing.assert_allclose(found[2:4], pose[2:4], atol=0.01)
    np.testing.assert_allclose(found[:2], 0.0, atol=0.2)


def test_nothing_to_go_by_leaves_the_pose_where_it_is_expected() -> None:
    samples = samples_of(ONE)
    image, hidden = np.zeros((*SIZE, 3), np.float32), np.ones(SIZE, np.uint8)
    view = View(image, 1.0, 1.0, 0.0, 0.0, hidden, np.zeros(SIZE, np.float32))
    prior = prior_of(ONE, 1.0)._replace(rest=np.zeros(6))
    found, cost = refined(view, samples, ONE, np.zeros(6), COSTS, prior, NO_TIES, 40)
    np.testing.assert_allclose(found, prior.expected, atol=2e-3)
    assert cost == pytest.approx(COSTS.hidden, abs=1e-4)


def test_outside_the_picture_nothing_is_seen_and_nothing_breaks() -> None:
    samples, view = samples_of(ONE), a_view(ONE, np.zeros(6))
    for far in (1e3, -1e3, 1e9):
        start = np.array([far, 0.0, 0.0, 0.0, 0.0, 0.0])
        pose, cost = refined(view, samples, ONE, start, COSTS, prior_of(ONE, 0.0), NO_TIES, 10)
        assert np.isfinite(pose).all()
        assert cost == pytest.approx(COSTS.beyond)


@needs_compiler
@CHAINS
def test_whatever_the_layout_of_its_arrays_a_kernel_is_compiled_once(bones: Array) -> None:
    """Templates are cut to every second place, and shares of bones stand in columns: each was compiled for."""
    pose, samples = np.zeros(5 + len(bones)), samples_of(bones)
    view, prior = a_view(bones, pose), prior_of(bones)
    cut, packed = Samples(*(each[::2] for each in samples)), Samples(*(each[::2].copy() for each in samples))
    rows = Ties(samples.places[:6], samples.skin[:6], samples.places[:6] + 1.0, np.ones(6), 3.0)
    columns = rows._replace(skin=np.asfortranarray(rows.skin))

    def solved(samples: Samples, ties: Ties) -> tuple[Array, Array]:
        best, _ = refined(view, samples, bones, pose, COSTS, prior, ties, 5)
        return best, energies(view, samples, bones, pose[None], COSTS, prior, ties)

    expected = solved(packed, rows)
    counts = len(posing._refined.signatures), len(posing._energies.signatures)
    found = solved(cut, columns)
    assert (len(posing._refined.signatures), len(posing._energies.signatures)) == counts
    np.testing.assert_array_equal(found[0], expected[0])
    np.testing.assert_array_equal(found[1], expected[1])
