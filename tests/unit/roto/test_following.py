"""Shapes that follow a track: nothing that the artist made moves."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import projective
from roam_core.geometry.bezier import ANCHOR, polygon_points
from roam_core.propagate.shapes.provenance import is_stale
from roam_core.roto import Keyframe, Layer, LayerTransform, Origin, Project, edit
from roam_core.roto.following import followed, pinned, still, surface_at, unpinned, with_moving_layer
from roam_core.roto.layers import grouped

SQUARE = polygon_points([(10.0, 10.0), (30.0, 10.0), (30.0, 26.0), (10.0, 26.0)])


def moved(x: float, y: float = 0.0) -> np.ndarray:
    return np.array([[1.0, 0.0, x], [0.0, 1.0, y], [0.0, 0.0, 1.0]])


@pytest.fixture
def project() -> Project:
    """Two shapes; the first has artist keys on frames 1 and 9, and engine keys on 2 and 3."""
    one, shape = edit.new_shape(Project(), SQUARE, 1)
    shape = edit.set_key(shape, 9, SQUARE + np.array([20.0, 4.0]))
    shape = edit.set_engine_keys(shape, [Keyframe(f, SQUARE + 1.0, origin=Origin.ENGINE) for f in (2, 3)])
    return edit.new_shape(one.with_shape(shape), SQUARE, 1)[0]


def test_a_new_layer_stands_still(project: Project) -> None:
    after, layer_id = with_moving_layer(project, ["shape-1"], 1)
    layer = after.find(layer_id)
    assert isinstance(layer, Layer)
    assert (layer.name, [child.id for child in layer.children]) == ("Planar 1", ["shape-1"])
    assert after.find("shape-1") == project.find("shape-1")
    assert with_moving_layer(after, ["shape-2"], 1)[0].find("layer-2").name == "Planar 2"


def test_a_moving_layer_of_just_these_is_taken_up_again(project: Project) -> None:
    after, layer_id = with_moving_layer(project, ["shape-1", "shape-2"], 1)
    assert with_moving_layer(after, ["shape-2", "shape-1"], 4) == (after, layer_id)
    inner, inner_id = with_moving_layer(after, ["shape-2"], 4)
    assert inner_id != layer_id
    assert [above.id for above in inner.layers_above("shape-2")] == ["root", layer_id, inner_id]


def test_the_shape_follows_and_no_artist_key_moves(project: Project) -> None:
    after, layer_id = with_moving_layer(project, ["shape-1"], 1)
    before = after.shape("shape-1")
    for frame in range(2, 7):
        after = followed(after, layer_id, 1, frame, moved(3.0 * (frame - 1)))
    shape = after.shape("shape-1")
    for key in (1, 9):
        np.testing.assert_allclose(shape.at(key).points, before.at(key).points, atol=1e-9)
    assert shape.frames == (1, 9)  # the engine's keys gave way
    # Between the keys it goes with the plane, and bends evenly towards the artist's next key.
    own = before.at(9).points[0, ANCHOR] - moved(15.0)[:2, 2]
    expected = (1 - 4 / 8) * np.array([10.0, 10.0]) + 4 / 8 * own + [12.0, 0.0]
    np.testing.assert_allclose(shape.at(5).points[0, ANCHOR], expected)


def test_engine_keys_on_other_frames_stay_where_they_are_seen(project: Project) -> None:
    after, layer_id = with_moving_layer(project, ["shape-1"], 1)
    after = followed(after, layer_id, 1, 2, moved(8.0))
    np.testing.assert_allclose(after.shape("shape-1").key_at(3).points, SQUARE + 1.0, atol=1e-9)


def test_the_only_key_is_never_lost() -> None:
    one, shape = edit.new_shape(Project(), SQUARE, 1)
    engine = edit.delete_keys(edit.set_engine_keys(shape, [Keyframe(4, SQUARE, origin=Origin.ENGINE)]), [1])
    after, layer_id = with_moving_layer(one.with_shape(engine), ["shape-1"], 3)
    assert followed(after, layer_id, 3, 4, moved(2.0)).shape("shape-1").frames == (4,)


def test_motion_is_told_in_the_space_around_the_layer(project: Project) -> None:
    after, outer = with_moving_layer(project, ["shape-1", "shape-2"], 1)
    turn = np.array([[0.0, -1.0, 40.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]])
    after = edit.set_properties(after, outer, transform=LayerTransform.of({1: turn, 5: moved(50.0) @ turn}))
    after, inner = with_moving_layer(after, ["shape-2"], 1)
    start = after.shape("shape-2").at(1).points
    tilt = projective.normalised([[1.02, 0.1, 5.0], [-0.1, 0.98, 2.0], [1e-4, 2e-4, 1.0]])
    after = followed(after, inner, 1, 5, tilt)
    np.testing.assert_allclose(after.shape("shape-2").at(5).points, projective.apply(tilt, start), atol=1e-9)
    again = followed(after, inner, 5, 6, moved(7.0))
    np.testing.assert_allclose(
        again.shape("shape-2").at(6).points, projective.apply(moved(7.0) @ tilt, start), atol=1e-9
    )


def test_motion_can_be_taken_away(project: Project) -> None:
    after, layer_id = with_moving_layer(project, ["shape-1"], 1)
    bake_layers = still(followed(after, layer_id, 1, 5, moved(6.0)), layer_id)
    assert bake_layers.find(layer_id).transform is None
    np.testing.assert_allclose(bake_layers.shape("shape-1").at(9).points, project.shape("shape-1").at(9).points)


def shown(project: Project, layer_id: str, frame: int) -> np.ndarray:
    """The anchors of the first shape, as they are seen."""
    return project.shape("shape-1").at(frame).points[:, ANCHOR]


@pytest.fixture
def tracked() -> tuple[Project, str]:
    """A square that a track carries 3 pixels a frame, from frame 1 to 11, sure of it."""
    project, _ = edit.new_shape(Project(), SQUARE, 1)
    project, layer_id = with_moving_layer(project, ["shape-1"], 1)
    for frame in range(2, 12):
        project = followed(project, layer_id, 1, frame, moved(3.0 * (frame - 1)), confidence=0.9)
    return project, layer_id


def transform_of(project: Project, layer_id: str) -> LayerTransform:
    layer = project.find(layer_id)
    assert isinstance(layer, Layer)
    assert layer.transform is not None
    return layer.transform


def test_a_track_keeps_its_confidence_and_where_it_began(tracked: tuple[Project, str]) -> None:
    own = transform_of(*tracked)
    assert own.adjusted == (1,)
    assert own.confidence == tuple((frame, 0.9) for frame in range(2, 12))
    assert own.with_matrices({5: np.eye(3)}).confidence == tuple((f, 0.9) for f in range(2, 12) if f != 5)
    assert own.without(range(4, 12)).confidence == ((2, 0.9), (3, 0.9))


def test_an_adjust_key_spreads_the_drift_to_its_neighbours(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    drift = np.array([0.0, 4.0])
    fixed = pinned(project, layer_id, 6, surface_at(project, layer_id, 6) + drift)
    assert transform_of(fixed, layer_id).adjusted == (1, 6)
    for frame in range(1, 12):
        share = min((frame - 1) / 5.0, 1.0)  # nothing where it began, all of it from the key on
        np.testing.assert_allclose(
            shown(fixed, layer_id, frame), shown(project, layer_id, frame) + share * drift, atol=1e-9
        )
    again = pinned(fixed, layer_id, 11, surface_at(fixed, layer_id, 11) - drift)
    np.testing.assert_allclose(shown(again, layer_id, 6), shown(fixed, layer_id, 6), atol=1e-9)
    np.testing.assert_allclose(shown(again, layer_id, 11), shown(project, layer_id, 11), atol=1e-9)
    assert [frame for frame, _ in transform_of(again, layer_id).confidence] == [2, 3, 4, 5, 7, 8, 9, 10]


def test_one_corner_alone_bends_the_surface(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    corners = surface_at(project, layer_id, 11)
    corners[2] += (3.0, 2.0)
    fixed = pinned(project, layer_id, 11, corners)
    np.testing.assert_allclose(surface_at(fixed, layer_id, 11), corners, atol=1e-9)
    np.testing.assert_allclose(shown(fixed, layer_id, 1), SQUARE[:, ANCHOR], atol=1e-9)


def test_a_track_over_an_adjust_key_is_drawn_to_it(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    fixed = pinned(project, layer_id, 6, surface_at(project, layer_id, 6) + np.array([0.0, 4.0]))
    wanted = shown(fixed, layer_id, 6)
    for frame in range(2, 7):
        fixed = followed(fixed, layer_id, 1, frame, moved(3.0 * (frame - 1), 1.0 * (frame - 1)), 0.5)
    np.testing.assert_allclose(shown(fixed, layer_id, 6), wanted, atol=1e-9)  # 5 by the track, 4 by the artist
    np.testing.assert_allclose(shown(fixed, layer_id, 3), SQUARE[:, ANCHOR] + [6.0, 2.0 - 0.4], atol=1e-9)
    assert dict(transform_of(fixed, layer_id).confidence)[3] == 0.5


def test_an_adjust_key_is_taken_away_without_a_jump(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    fixed = pinned(project, layer_id, 6, surface_at(project, layer_id, 6) + np.array([0.0, 4.0]))
    free = unpinned(fixed, layer_id, 6)
    assert transform_of(free, layer_id).adjusted == (1,)
    np.testing.assert_array_equal(shown(free, layer_id, 6), shown(fixed, layer_id, 6))


def test_corners_that_fold_the_surface_are_refused(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    corners = surface_at(project, layer_id, 6)[[0, 2, 1, 3]]
    with pytest.raises(RoamError, match="corners of one surface"):
        pinned(project, layer_id, 6, corners)


def test_a_layer_that_stands_still_is_taken_up(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    again, taken = with_moving_layer(still(project, layer_id), ["shape-1"], 4)
    assert taken == layer_id
    assert [above.id for above in again.layers_above("shape-1")] == ["root", layer_id]
    assert transform_of(again, layer_id).adjusted == (4,)
    np.testing.assert_array_equal(shown(again, layer_id, 4), SQUARE[:, ANCHOR])


def test_a_layer_in_which_another_moves_is_not_taken_up(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    project, car = grouped(project, [layer_id])
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id=car.id)
    after, moving = with_moving_layer(project, ["shape-1", "shape-2"], 1)
    assert moving not in (layer_id, car.id)
    assert [above.id for above in after.layers_above("shape-1")] == ["root", car.id, moving]


def test_a_run_beside_the_tracked_frames_goes_on_from_what_was_seen(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    seen = shown(project, layer_id, 20)  # held where the first run ended
    for frame in range(21, 31):
        project = followed(project, layer_id, 20, frame, moved(3.0 * (frame - 20)))
    for frame in (15, 20, 21, 25, 30):
        off = np.array([3.0 * max(frame - 20, 0), 0.0])
        np.testing.assert_allclose(shown(project, layer_id, frame), seen + off, atol=1e-9)


def test_a_shape_that_comes_from_another_moving_layer_stays_where_it_is_seen(tracked: tuple[Project, str]) -> None:
    project, layer_id = tracked
    project, _ = edit.new_shape(project, SQUARE, 1)
    after, moving = with_moving_layer(project, ["shape-1", "shape-2"], 5)
    for frame in range(13):
        np.testing.assert_allclose(shown(after, moving, frame), shown(project, layer_id, frame), atol=1e-9)
    assert after.shape("shape-1").artist_frames == (1,)
    assert not any(is_stale(after.shape("shape-1"), key, None) for key in after.shape("shape-1").keys)
    assert not after.has(layer_id)  # it holds nothing any more
    for frame in range(6, 9):
        after = followed(after, moving, 5, frame, moved(0.0, 2.0 * (frame - 5)))
        for each in range(5, frame + 1):
            off = [0.0, 2.0 * (each - 5)]
            np.testing.assert_allclose(shown(after, moving, each), shown(project, layer_id, 5) + off, atol=1e-9)
    for frame in (*range(1, 6), *range(9, 13)):
        np.testing.assert_allclose(shown(after, moving, frame), shown(project, layer_id, frame), atol=1e-9)


@pytest.mark.parametrize("start", [1, 12])
def test_engine_keys_beyond_a_track_do_not_draw_what_it_found_to_them(start: int) -> None:
    """They stay where they are seen, while the layer's motion ends before them."""
    project, shape = edit.new_shape(Project(), SQUARE, start)
    step = 1 if start == 1 else -1
    told = {start + step * k: SQUARE + np.array([10.0 * k, 0.0]) for k in range(1, 12)}
    shape = edit.set_engine_keys(shape, [Keyframe(f, points, origin=Origin.ENGINE) for f, points in told.items()])
    project, layer_id = with_moving_layer(project.with_shape(shape), ["shape-1"], start)
    for k in range(1, 6):
        project = followed(project, layer_id, start, start + step * k, moved(10.0 * k, 1.0))
    for k in range(1, 12):
        off = [10.0 * k, 1.0 if k < 6 else 0.0]
        np.testing.assert_allclose(shown(project, layer_id, start + step * k), SQUARE[:, ANCHOR] + off, atol=1e-9)
    found = project.shape("shape-1")
    last = start + step * 5
    assert set(found.frames) == {start, last, *(start + step * k for k in range(6, 12))}
    assert not is_stale(found, found.key_at(last), None)
