"""The texture model: what has the same colours is told apart, later looks are learned, the key is not forgotten."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from roam_core.appearance.texture_model import TextureModel
from roam_core.arrays import Bools, Float32
from roam_core.features.texture import texture
from roam_core.params import TextureParams

PARAMS = TextureParams()
SIZE = 120, 160
CLIP = 3.0


def disc(x: float, y: float, radius: float = 36.0) -> Bools:
    rows, columns = np.indices(SIZE)
    return np.asarray(np.hypot(rows - y, columns - x) < radius)


def picture(inside: Bools, within: float = 40.0, without: float = 4.0, mean: int = 128, seed: int = 1) -> Float32:
    """Noise of one mean colour everywhere, of one strength inside and of another outside."""
    rng = np.random.default_rng(seed)
    noise = rng.normal(size=(*SIZE, 1)) * np.where(inside, within, without)[..., None]
    lab = np.clip(mean + noise + np.zeros(3), 0, 255)
    lab[..., 1:] = 128
    return texture(lab.astype(np.uint8), PARAMS)


def learned(inside: Bools, **seen: float) -> TextureModel:
    model = TextureModel.learned(picture(inside, **seen), inside, ~inside, PARAMS)  # type: ignore[arg-type]
    assert model is not None
    return model


EVERYWHERE = np.ones(SIZE, bool)
KEY, LATER = disc(50, 60), disc(100, 55)


def right(model: TextureModel, seen: Float32, inside: Bools) -> float:
    """The share of the cells that are told their side."""
    return float(((model.log_ratio(seen, EVERYWHERE, CLIP) > 0) == inside).mean())


def test_what_has_the_same_colours_is_told_apart_by_its_texture() -> None:
    assert right(learned(KEY), picture(LATER, seed=2), LATER) > 0.95


def test_only_wanted_cells_are_told_and_never_more_than_the_bound() -> None:
    told = learned(KEY).log_ratio(picture(LATER, seed=2), LATER, CLIP)
    assert not told[~LATER].any()
    assert 2.0 < np.abs(told).max() <= CLIP + 1e-5


def test_the_same_key_gives_the_same_trees() -> None:
    one, other = learned(KEY), learned(KEY)
    np.testing.assert_array_equal(one.features, other.features)
    np.testing.assert_array_equal(one.bounds, other.bounds)
    np.testing.assert_array_equal(one.key, other.key)


def test_a_later_look_is_learned_and_the_keys_is_not_forgotten() -> None:
    model, now, then = learned(KEY), picture(LATER, without=14.0, within=22.0, seed=3), picture(LATER, seed=2)
    before = right(model, now, LATER)
    for _ in range(20):
        model = model.adapted(now, LATER, ~LATER, 0.1)
    assert right(model, now, LATER) > before + 0.02
    assert right(model, then, LATER) > 0.93
    np.testing.assert_array_equal(model.key, learned(KEY).key)
    assert not model.as_on_key().since.any()


def test_the_key_counts_as_much_as_it_is_told() -> None:
    model = learned(KEY).adapted(picture(LATER, within=4.0, without=40.0, seed=3), LATER, ~LATER, 1.0)
    seen = picture(LATER, seed=2)
    ratios = [
        float(replace(model, params=replace(PARAMS, key=key)).log_ratio(seen, LATER, CLIP)[LATER].mean())
        for key in (0.0, 1.0, 10.0)
    ]
    assert ratios[0] < -1.0 < ratios[1] < 1.0 < ratios[2]


def test_the_more_is_taken_to_be_unseen_the_less_is_said() -> None:
    model, seen = learned(KEY), picture(LATER, seed=2)
    told = [
        float(np.abs(replace(model, params=replace(PARAMS, unseen=unseen)).log_ratio(seen, LATER, CLIP)[LATER]).mean())
        for unseen in (1e-4, 1e-2, 1.0)
    ]
    assert told[0] > told[1] > 4.0 * told[2]


def test_one_side_alone_teaches_nothing() -> None:
    seen = picture(KEY)
    nothing = np.zeros(SIZE, bool)
    assert TextureModel.learned(seen, nothing, EVERYWHERE, PARAMS) is None
    assert TextureModel.learned(seen, EVERYWHERE, nothing, PARAMS) is None
    model = learned(KEY)
    assert model.adapted(seen, nothing, EVERYWHERE, 0.1) is model
