"""Smoothing through time: closer to the true motion, never beyond the reach, the artist's keys untouched."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import cv2
import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.cancel import Cancelled, CancelToken
from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.interchange import EXPORTERS, ExportOptions, KeyChoice
from roam_core.interchange.keys.reduction import reduced
from roam_core.interchange.keys.smoothing import SLIDE, STIFFNESS, smoothed
from roam_core.roto import Clip, Interpolation, Keyframe, Layer, LayerTransform, Origin, Project, RotoShape, Spline
from tests.golden.shots import blob, outline_distance
from tests.unit.interchange.judged import farthest

ROUND = blob([30.0, 22.0, 26.0, 34.0, 20.0])
COUNT = 40


def true_points(frame: float) -> Array:
    """A shape that drifts and swings."""
    return ROUND + np.array([200.0 + 20.0 * np.sin(frame / 9.0), 150.0 + 2.0 * frame])


def tracked(shiver: float, *, artist: tuple[int, ...] = (0,), closed: bool = True, soft: bool = False) -> RotoShape:
    """The true motion with noise on every point of the engine's keys."""
    rng = np.random.default_rng(7)
    keys = []
    for frame in range(COUNT):
        noise = rng.normal(0.0, shiver, (2, len(ROUND), 1, 2))
        is_artist = frame in artist
        points = true_points(frame) + (0.0 if is_artist else noise[0])
        feather = np.full_like(ROUND, 5.0) + (0.0 if is_artist else noise[1])
        origin = Origin.ARTIST if is_artist else Origin.ENGINE
        keys.append(Keyframe(frame, points, feather if soft else None, origin))
    return RotoShape("shape-1", "Tracked", tuple(keys), closed=closed)


def away(shape: RotoShape) -> float:
    """Mean distance of the shape's outlines to the true ones."""
    return float(np.mean([outline_distance(shape.at(f).points, true_points(f)) for f in range(COUNT)]))


def test_a_shiver_goes_and_the_motion_stays() -> None:
    shape = tracked(0.5)
    smoothing = smoothed(shape, 3.0)
    assert away(smoothing.shape) < 0.6 * away(shape)
    assert 0.0 < smoothing.mean_error < smoothing.max_error < 3.0
    assert len(reduced(smoothing.shape, 0.5).shape.keys) < 0.6 * len(reduced(shape, 0.5).shape.keys)


@pytest.mark.parametrize("reach", [0.05, 0.3, 1.0])
@pytest.mark.parametrize(("closed", "soft"), [(True, False), (False, False), (True, True)])
def test_nothing_goes_beyond_the_reach(reach: float, closed: bool, soft: bool) -> None:
    shape = tracked(1.0, closed=closed, soft=soft)
    smoothing = smoothed(shape, reach)
    assert 0.5 * reach < smoothing.max_error <= reach
    for frame in range(0, COUNT, 3):
        was, now = shape.at(frame), smoothing.shape.at(frame)
        assert farthest(now.points, was.points, closed=closed) <= reach + 0.05  # between the places compared
        if soft:
            curves = (now.points + now.feather, was.points + was.feather)
            assert farthest(*curves, closed=closed) <= reach + 0.05


def test_keys_of_the_artist_are_the_same_bit_by_bit() -> None:
    shape = tracked(1.0, artist=(0, 13, 14, 30))
    smoothing = smoothed(shape, 2.0)
    assert smoothing.shape.frames == shape.frames
    for before, after in zip(shape.keys, smoothing.shape.keys, strict=True):
        assert (before == after) is (before.origin is Origin.ARTIST)


def test_the_answer_is_the_penalised_least_squares_one() -> None:
    """All keys and points of a small shape at once, by plain normal equations."""
    shape = replace(tracked(0.5), keys=tracked(0.5).keys[:9])
    smoothing = smoothed(shape, 50.0)
    rows = np.diff(np.eye(9), 2, axis=0)
    stiffness = np.kron(STIFFNESS * rows.T @ rows, np.eye(2))
    values = np.stack([key.points for key in shape.keys])
    for p in range(len(ROUND)):
        along = values[:, p, 2] - values[:, p, 1]
        unit = along / np.linalg.norm(along, axis=1)[:, None]
        weight = np.zeros((18, 18))
        for k in range(9):
            across = np.array([-unit[k, 1], unit[k, 0]])
            block = np.outer(across, across) + SLIDE * np.outer(unit[k], unit[k])
            weight[2 * k : 2 * k + 2, 2 * k : 2 * k + 2] = block
        for c in range(3):
            start = values[:, p, c].ravel()
            free = np.arange(2, 18)  # the first key is the artist's
            system = (stiffness + weight)[np.ix_(free, free)]
            step = np.linalg.solve(system, -(stiffness @ start)[free])
            expected = start[free] + step
            found = np.stack([key.points[p, c] for key in smoothing.shape.keys]).ravel()[free]
            np.testing.assert_allclose(found, expected, atol=1e-6)


def test_nothing_is_evened_out_across_a_held_span() -> None:
    keys = [Keyframe(f, ROUND + 100.0, origin=Origin.ENGINE) for f in range(5)]
    keys[-1] = replace(keys[-1], interpolation=Interpolation.HOLD)
    keys += [Keyframe(f, ROUND + 140.0, origin=Origin.ENGINE) for f in range(8, 13)]
    shape = RotoShape("shape-1", "Jump", tuple(keys))
    smoothing = smoothed(shape, 5.0)
    assert smoothing.max_error < 1e-9


def test_keys_that_lie_apart_weigh_as_the_time_between_them() -> None:
    """Even motion over uneven frames is even already."""
    frames = (1, 2, 5, 6, 11, 30)
    keys = tuple(Keyframe(f, ROUND + np.array([3.0 * f, f]), origin=Origin.ENGINE) for f in frames)
    assert smoothed(RotoShape("shape-1", "Even", keys), 5.0).max_error < 1e-9


def test_polygons_stay_polygons_and_splines_stay_splines() -> None:
    rng = np.random.default_rng(3)
    control = ROUND[:, 0] + 200.0 + rng.normal(0.0, 1.0, (12, len(ROUND), 2))
    corners = [Keyframe(f, np.repeat(c[:, None], 3, axis=1), origin=Origin.ENGINE) for f, c in enumerate(control)]
    polygon = smoothed(RotoShape("shape-1", "Polygon", tuple(corners)), 2.0).shape
    for key in polygon.keys:
        np.testing.assert_allclose(key.points[:, 1:], key.points[:, :1].repeat(2, axis=1), atol=1e-9)
    curves = [Keyframe(f, bspline.bezier_points(c), origin=Origin.ENGINE) for f, c in enumerate(control)]
    spline = smoothed(RotoShape("shape-1", "Spline", tuple(curves), spline=Spline.BSPLINE), 0.5)
    assert 0.1 < spline.max_error <= 0.5
    assert all(bspline.is_bspline(key.points) for key in spline.shape.keys)


def test_what_the_artist_made_is_left_alone() -> None:
    shape = tracked(1.0, artist=tuple(range(COUNT)))
    assert smoothed(shape, 1.0).shape is shape
    assert smoothed(replace(shape, keys=tracked(1.0).keys[:2]), 1.0).max_error == 0.0


@pytest.mark.parametrize("reach", [0.0, -1.0, float("nan"), float("inf")])
def test_a_senseless_reach_is_refused(reach: float) -> None:
    with pytest.raises(RoamError, match="reach of smoothing"):
        smoothed(tracked(1.0), reach)


def test_smoothing_can_be_cancelled() -> None:
    token = CancelToken()
    token.cancel()
    with pytest.raises(Cancelled):
        smoothed(tracked(1.0), 1.0, token)


@pytest.mark.parametrize("name", EXPORTERS)
def test_every_format_writes_what_is_smoothed_and_says_so(name: str, tmp_path: Path) -> None:
    project = Project(Clip(Path("plate"), 0, 5, (400, 300)), Layer("root", "Root", (tracked(1.0),)))
    options = [ExportOptions(smoothing=smoothing, keys=KeyChoice.EVERY, frame=3) for smoothing in (0.0, 2.0)]
    contents, notes = [], ()
    for index, option in enumerate(options):
        out = tmp_path / str(index) / f"p{EXPORTERS[name].suffix}"
        out.parent.mkdir()
        notes = EXPORTERS[name].export(project, out, option)
        contents.append([path.read_bytes() for path in sorted(out.parent.iterdir())])
    assert sum("'Tracked': smoothed through time; the engine's outlines moved by at most" in n for n in notes) == 1
    assert len(contents[0]) == len(contents[1])
    assert contents[0] != contents[1]


def test_mattes_are_those_of_the_smoothed_shape(tmp_path: Path) -> None:
    project = Project(Clip(Path("plate"), 0, 5, (400, 300)), Layer("root", "Root", (tracked(1.0),)))
    EXPORTERS["mattes"].export(project, tmp_path / "a", ExportOptions(smoothing=2.0))
    shown = project.with_shape(smoothed(tracked(1.0), 2.0).shape)
    EXPORTERS["mattes"].export(shown, tmp_path / "b", ExportOptions())
    for name in sorted(path.name for path in (tmp_path / "a").iterdir()):
        pictures = [cv2.imread(str(tmp_path / place / name), cv2.IMREAD_UNCHANGED) for place in "ab"]
        np.testing.assert_array_equal(*pictures)


@pytest.mark.parametrize("keys", [KeyChoice.EVERY, KeyChoice.ARTIST])
@pytest.mark.parametrize("name", ["json", "nuke"])
def test_what_a_moving_layer_made_is_left_alone(name: str, keys: KeyChoice, tmp_path: Path) -> None:
    """A hand-drawn shape that shakes with its layer drifted off the picture that the layer follows."""
    shakes = np.random.default_rng(1).normal(0.0, 2.0, (COUNT, 2))
    moves = LayerTransform.of({f: [[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]] for f, (x, y) in enumerate(shakes)})
    drawn = RotoShape("shape-1", "Drawn", (Keyframe(0, true_points(0)), Keyframe(COUNT - 1, true_points(0) + 20.0)))
    root = Layer("root", "Root", (Layer("layer-1", "Shakes", (drawn,), transform=moves),))
    project = Project(Clip(Path("plate"), 0, COUNT - 1, (400, 300)), root)
    path = tmp_path / f"p{EXPORTERS[name].suffix}"
    texts = []
    for reach in (0.0, 2.0):
        EXPORTERS[name].export(project, path, ExportOptions(keys=keys, smoothing=reach))
        texts.append(path.read_bytes())
    assert texts[0] == texts[1]
