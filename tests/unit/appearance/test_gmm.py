"""Mixtures: densities and EM against scikit-learn, the update against its twin."""

from __future__ import annotations

import warnings

import numpy as np
import pytest
from sklearn.exceptions import ConvergenceWarning
from sklearn.mixture import GaussianMixture

from roam_core.appearance import gmm
from roam_core.appearance.gmm import FLOOR, Mixtures, Samples
from roam_core.appearance.update import adapted
from roam_core.arrays import Array
from roam_core.kernels.gmm_density import em_steps, matches
from roam_core.params import AppearanceParams
from tests.reference.gmm_density import ref_components, ref_match

FLOORLESS = AppearanceParams(variance_floor=0.0)


def mixtures(count: int, seed: int = 0) -> Mixtures:
    rng = np.random.default_rng(seed)
    weight = rng.dirichlet([2.0, 2.0, 2.0], count)
    return Mixtures(weight, rng.uniform(60.0, 190.0, (count, 3, 3)), rng.uniform(20.0, 400.0, (count, 3, 3)))


def judge(one: Mixtures, n: int) -> GaussianMixture:
    """Mixture `n` as scikit-learn's."""
    model = GaussianMixture(3, covariance_type="diag")
    model.weights_, model.means_, model.covariances_ = one.weight[n], one.mean[n], one.variance[n]
    model.precisions_cholesky_ = 1.0 / np.sqrt(one.variance[n])
    return model


def drawn(one: Mixtures, n: int, count: int, seed: int = 1) -> Array:
    """Colours drawn from mixture `n`."""
    rng = np.random.default_rng(seed)
    k = rng.choice(3, count, p=one.weight[n])
    return np.asarray(one.mean[n, k] + np.sqrt(one.variance[n, k]) * rng.normal(size=(count, 3)))


def test_densities_are_scikit_learns() -> None:
    many = mixtures(5)
    for n in range(len(many)):
        colours = drawn(many, n, 60)
        ours = many.log_density(colours.astype(np.float32), np.full(60, n, np.int32))
        theirs = judge(many, n).score_samples(colours)
        np.testing.assert_allclose(ours, np.maximum(theirs, FLOOR), atol=2e-4)


def test_the_greatest_component_lies_at_most_ln_k_below_the_sum() -> None:
    one = mixtures(1)
    colours, index = drawn(one, 0, 200).astype(np.float32), np.zeros(200, np.int32)
    both = one.log_density(colours, index, "sum"), one.log_density(colours, index, "maximum")
    assert (both[1] <= both[0] + 1e-5).all()
    assert (both[1] >= both[0] - np.log(3.0) - 1e-5).all()
    greatest = [np.log(ref_components(c, (one.weight[0], one.mean[0], one.variance[0])).max()) for c in colours]
    np.testing.assert_allclose(both[1], np.maximum(greatest, FLOOR), atol=2e-4)


def test_unasked_and_unexplained_colours_have_the_floor() -> None:
    colours = np.full((2, 3), 1e4, dtype=np.float32)
    assert mixtures(1).log_density(colours, np.array([0, -1], np.int32)).tolist() == pytest.approx([FLOOR, FLOOR])


def test_joined_mixtures_share_the_density() -> None:
    one, other = mixtures(1, 3), mixtures(1, 4)
    colours, index = drawn(one, 0, 50).astype(np.float32), np.zeros(50, np.int32)
    apart = 0.7 * np.exp(judge(one, 0).score_samples(colours)) + 0.3 * np.exp(judge(other, 0).score_samples(colours))
    np.testing.assert_allclose(
        one.joined(other, 0.3).log_density(colours, index), np.maximum(np.log(apart), FLOOR), atol=2e-4
    )


def test_a_step_of_expectation_maximisation_is_scikit_learns() -> None:
    truth, start = mixtures(3, 5), mixtures(3, 6)
    groups = [drawn(truth, n, 80, seed=n) for n in range(3)]
    samples = Samples.of(np.concatenate(groups), np.repeat(np.arange(3, dtype=np.int32), 80), 3)
    stepped = (start.weight.copy(), start.mean.copy(), start.variance.copy())
    em_steps(samples.colours, samples.starts, 0, stepped, 0.0, 1)
    for n in range(3):
        model = GaussianMixture(
            3,
            covariance_type="diag",
            reg_covar=0.0,
            max_iter=1,
            weights_init=start.weight[n],
            means_init=start.mean[n],
            precisions_init=1.0 / start.variance[n],
        )
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", ConvergenceWarning)
            model.fit(groups[n])
        for ours, theirs in zip(stepped, (model.weights_, model.means_, model.covariances_), strict=True):
            np.testing.assert_allclose(ours[n], theirs, rtol=1e-6, atol=1e-9)


def test_steps_never_make_the_colours_less_likely() -> None:
    colours = drawn(mixtures(1, 8), 0, 300)
    samples = Samples.of(colours, np.zeros(300, np.int32), 1)
    index = np.zeros(300, np.int32)
    likely = [
        float(gmm.learned(samples, 3, 1.0, steps=steps).log_density(colours.astype(np.float32), index).sum())
        for steps in (0, 1, 3, 10)
    ]
    assert (np.diff(likely) >= -1e-2).all()
    assert likely[-1] > likely[0]


def test_neighbours_on_both_sides_lend_their_colours() -> None:
    groups = np.arange(5).repeat(20).astype(np.int32)
    colours = np.repeat(10.0 * groups[:, None], 3, axis=1) + np.random.default_rng(2).normal(size=(100, 3))
    samples = Samples.of(colours, groups, 5)
    alone, with_others = gmm.learned(samples, 3, 1.0), gmm.learned(samples, 3, 1.0, spread=1)
    middle = (alone.weight[:, :, None] * alone.mean).sum(axis=1)[:, 0]
    np.testing.assert_allclose(middle, [0.0, 10.0, 20.0, 30.0, 40.0], atol=1.0)
    wide = (with_others.weight[:, :, None] * with_others.mean).sum(axis=1)[:, 0]
    np.testing.assert_allclose(wide, [50.0 / 3, 10.0, 20.0, 30.0, 70.0 / 3], atol=1.0)


def test_an_edge_without_colours_knows_nothing() -> None:
    colours = np.random.default_rng(2).normal(100.0, 5.0, (30, 3))
    model = gmm.learned(Samples.of(colours, np.zeros(30, np.int32), 2), 3, 20.0)
    asked = model.log_density(np.full((2, 3), 100.0, np.float32), np.array([0, 1], np.int32))
    assert asked[0] > FLOOR + 3.0
    assert asked[1] == pytest.approx(FLOOR)


def test_matches_equal_the_twin() -> None:
    start = mixtures(2, 9)
    colours = np.random.default_rng(3).uniform(50.0, 200.0, (90, 3))
    index = np.random.default_rng(4).integers(0, 2, 90).astype(np.int32)
    samples = Samples.of(colours, index, 2)
    bound = AppearanceParams().matched
    sums = matches(samples.colours, samples.starts, 0, (start.weight, start.mean, start.variance), bound)
    twin = np.zeros_like(sums)
    for colour, n in zip(colours, index, strict=True):
        k = ref_match(colour, (start.weight[n], start.mean[n], start.variance[n]), bound)
        twin[n, k] += [*colour, *colour**2, 1.0]
    np.testing.assert_allclose(sums, twin)
    assert sums[:, :, 6].min() > 0


@pytest.mark.parametrize("spread", [1, 2, 7])
def test_matches_count_the_colours_of_neighbours_once_each(spread: int) -> None:
    """With five edges there are two on either side, however many are asked for."""
    start, rng = mixtures(5, 9), np.random.default_rng(3)
    colours, index = rng.uniform(50.0, 200.0, (90, 3)), rng.integers(0, 5, 90).astype(np.int32)
    samples = Samples.of(colours, index, 5)
    sums = matches(
        samples.colours, samples.starts, spread, (start.weight, start.mean, start.variance), AppearanceParams().matched
    )
    for n in range(5):
        near = [(n + off) % 5 for off in range(-min(spread, 2), min(spread, 2) + 1)]
        assert sums[n, :, 6].sum() == np.isin(index, near).sum()
        np.testing.assert_allclose(sums[n, :, :3].sum(axis=0), colours[np.isin(index, near)].sum(axis=0))


def test_what_stays_the_same_teaches_nothing_new_and_what_changes_is_learned() -> None:
    rng = np.random.default_rng(11)
    index = np.zeros(400, np.int32)
    old, new = rng.normal(80.0, 6.0, (400, 3)), rng.normal(160.0, 6.0, (400, 3))
    model = gmm.learned(Samples.of(old, index, 1), 3, 20.0)

    def likely(mixture: Mixtures, colours: Array) -> float:
        return float(mixture.log_density(colours.astype(np.float32), index).mean())

    same = adapted(model, Samples.of(old, index, 1), 0.1, AppearanceParams())
    assert likely(same, old) == pytest.approx(likely(model, old), abs=0.1)
    changed = model
    for _ in range(20):
        changed = adapted(changed, Samples.of(new, index, 1), 0.1, AppearanceParams())
        assert changed.weight.sum() == pytest.approx(1.0)
    assert likely(model, new) == pytest.approx(FLOOR)
    assert likely(changed, new) > likely(model, old) - 1.0
    assert likely(changed, old) > FLOOR


def test_a_rate_of_zero_and_a_frame_without_colours_change_nothing() -> None:
    start = mixtures(2, 12)
    colours = np.random.default_rng(3).uniform(50.0, 200.0, (60, 3))
    none = Samples.of(np.empty((0, 3)), np.empty(0, np.int32), 2)
    for after in (
        adapted(start, none, 0.1, FLOORLESS),
        adapted(start, Samples.of(colours, np.zeros(60, np.int32), 2), 0.0, FLOORLESS),
    ):
        np.testing.assert_allclose(after.mean[1], start.mean[1])
        np.testing.assert_allclose(after.weight[1], start.weight[1])
    np.testing.assert_allclose(adapted(start, none, 0.1, FLOORLESS).variance, start.variance)


def test_a_component_grows_as_wide_as_the_colours_that_it_takes_in() -> None:
    """Colours on both sides of its mean leave the mean; how far they lie from it goes into the variance (a frame's own
    spread, and the way from the mean to theirs)."""
    model = Mixtures(np.ones((1, 1)), np.full((1, 1, 3), 100.0), np.full((1, 1, 3), 64.0))
    rng, rate = np.random.default_rng(6), 0.25
    colours = rng.normal(110.0, 3.0, (500, 3))  # all of them within the component's reach
    after = adapted(model, Samples.of(colours, np.zeros(500, np.int32), 1), rate, AppearanceParams(variance_floor=1.0))
    mean = (1.0 - rate) * 100.0 + rate * colours.mean(axis=0)
    np.testing.assert_allclose(after.mean[0, 0], mean)
    # Stauffer and Grimson: (1 - rho) sigma^2 + rho |x - mu|^2, with the new mean, over all of the colours.
    apart = ((colours - mean) ** 2).mean(axis=0)
    np.testing.assert_allclose(after.variance[0, 0], (1.0 - rate) * 64.0 + rate * apart)
