"""One frame of the paper's engine: what its state remembers of the artist's key, and when."""

from __future__ import annotations

from dataclasses import fields, replace

import numpy as np

from roam_core.energy import total
from roam_core.features import PreparedFrame
from roam_core.geometry import bezier
from roam_core.geometry.similarity import IDENTITY
from roam_core.motion.klt import Warp
from roam_core.params import CONFIGS, RoamParams
from roam_core.propagate.curves.step import TrackerState, begin, observed, step
from tests.golden.shots import Shot, blob, gliding, outline_distance

LEAN = CONFIGS["lean"]
SHOT = gliding(blob([30.0, 24.0, 20.0, 26.0, 32.0, 22.0]), 4, (60.0, 56.0), (2.5, 1.0))


def prepared(shot: Shot, frame: int) -> PreparedFrame:
    return PreparedFrame(shot.read(frame))


def carried(params: RoamParams, frames: int = 3) -> TrackerState:
    """The state some frames after the key."""
    state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), params)
    for frame in SHOT.frames[1 : frames + 1]:
        state = step(state, prepared(SHOT, frame), params).state
    return state


def test_lean_learns_on_the_key_adapts_and_keeps_the_key() -> None:
    key, later = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), LEAN).models, carried(LEAN).models
    assert key is not None
    assert later is not None
    assert len(later.edges.inside) == len(key.edges.inside)
    np.testing.assert_array_equal(later.edges.key_inside.mean, key.edges.key_inside.mean)
    assert not np.array_equal(later.edges.inside.mean, key.edges.inside.mean)


def test_a_doubtful_frame_teaches_nothing() -> None:
    assert LEAN.appearance is not None
    strict = replace(LEAN, appearance=replace(LEAN.appearance, trusted=1.1))
    models = carried(strict).models
    assert models is not None
    np.testing.assert_array_equal(models.edges.inside.mean, models.edges.key_inside.mean)


def test_baseline_knows_no_colour() -> None:
    assert carried(CONFIGS["baseline"]).models is None


def test_every_term_has_its_share_of_the_energy() -> None:
    state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), LEAN)
    result = step(state, prepared(SHOT, SHOT.frames[1]), LEAN).result
    assert set(result.energies) >= {"gradient", "l2", "local", "total"}
    assert result.energies["local"] < 0.0


def test_a_step_hands_every_term_what_it_looks_at() -> None:
    """A field of the context that stays None is a term that no run evaluates."""
    weights = {each.name: 0.01 for each in fields(RoamParams) if each.name.startswith("lambda_")}
    params = replace(LEAN, **weights)
    state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), params)
    seen = observed(state, prepared(SHOT, SHOT.frames[1]), Warp(IDENTITY, 0, 1.0), state.points, params)
    assert seen is not None
    assert [each.name for each in fields(seen.curve) if getattr(seen.curve, each.name) is None] == []
    energies = total.energies(seen.nodes, seen.curve, params)
    assert [term for term, energy in energies.items() if energy == 0.0] == []
    assert len(energies) == len({"mu", *weights}) + 1


def test_the_global_term_takes_part_where_it_has_a_weight() -> None:
    both = replace(LEAN, lambda_global=0.01)
    state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), both)
    stepped = step(state, prepared(SHOT, SHOT.frames[1]), both)
    after, result = stepped.state, stepped.result
    assert result.energies["global"] < 0.0
    assert outline_distance(after.points, SHOT.truth(SHOT.frames[1])) < 1.0


def test_the_nearest_colours_speak_in_place_of_the_mixtures() -> None:
    assert LEAN.appearance is not None
    nearest = replace(LEAN, appearance=replace(LEAN.appearance, local_kind="nearest"))
    state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), nearest)
    assert begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), LEAN).nearest is None
    assert state.nearest is not None
    stepped = step(state, prepared(SHOT, SHOT.frames[1]), nearest)
    after, result = stepped.state, stepped.result
    assert after.nearest is not None
    assert after.nearest.frame is after.frame
    assert after.nearest.key.frame is state.frame
    assert result.energies["local"] < 0.0
    assert outline_distance(after.points, SHOT.truth(SHOT.frames[1])) < 1.0


def test_each_kind_of_local_colour_says_its_own_and_both_the_mean() -> None:
    assert LEAN.appearance is not None
    ratios = {}
    for kind in ("mixture", "nearest", "both"):
        params = replace(LEAN, appearance=replace(LEAN.appearance, local_kind=kind))
        state = begin(prepared(SHOT, SHOT.first), SHOT.truth(SHOT.first), params)
        seen = observed(state, prepared(SHOT, SHOT.frames[1]), Warp(IDENTITY, 0, 1.0), state.points, params)
        assert seen is not None
        assert seen.curve.colours is not None
        ratios[kind] = seen.curve.colours.log_ratio
    assert np.abs(ratios["nearest"] - ratios["mixture"]).max() > 0.5
    np.testing.assert_allclose(ratios["both"], 0.5 * (ratios["nearest"] + ratios["mixture"]), atol=1e-5)


def soft_disc(x: float) -> PreparedFrame:
    """A disc around (x, 60) that differs little from the background."""
    image = np.full((120, 140, 3), 90.0)
    rows, columns = np.mgrid[:120, :140] + 0.5
    image[(rows - 60.0) ** 2 + (columns - x) ** 2 < 25.0**2] = 125.0
    image += np.random.default_rng(0).normal(0.0, 2.0, image.shape)
    return PreparedFrame(np.clip(image, 0, 255).astype(np.uint8))


def test_colour_alone_finds_an_object_ten_pixels_aside() -> None:
    """Neither pre-warp nor gradient: a ribbon of eight pixels could not see it, region competition does."""
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    disc = 25.0 * np.stack([np.cos(angles), np.sin(angles)], axis=1)
    params = replace(LEAN, warp="none", lambda_gradient=0.0)
    state = begin(soft_disc(60.0), bezier.polygon_points(disc + np.array([60.0, 60.0])), params)
    after = step(state, soft_disc(70.0), params).state
    assert outline_distance(after.points, bezier.polygon_points(disc + np.array([70.0, 60.0]))) < 1.5
