"""The engine works on shapes in plate space: a layer that moves them changes nothing of what it finds."""

from __future__ import annotations

import numpy as np

from roam_core.propagate import track
from roam_core.propagate.shapes.provenance import is_stale
from roam_core.roto import LayerTransform, Project, edit
from tests.golden.shots import Shot

TILT = np.array([[0.9, -0.2, 14.0], [0.15, 1.1, -9.0], [1e-4, 0.0, 1.0]])


def test_tracking_under_a_moving_layer_finds_the_same_outlines(box_shot: Shot) -> None:
    frames, shape = box_shot.frames[:4], box_shot.shape()
    motion = LayerTransform.of({frame: TILT + np.diag([0.0, 0.01 * k, 0.0]) for k, frame in enumerate(frames)})
    one, layer = edit.add_layer(Project())
    one = edit.add_shape(edit.set_properties(one, layer.id, transform=motion), shape, layer.id)
    placed = one.shape(shape.id)
    np.testing.assert_allclose(placed.at(frames[0]).points, shape.at(frames[0]).points, atol=1e-9)
    results = list(track(box_shot.read, [placed], frames, "baseline"))
    plain = list(track(box_shot.read, [shape], frames, "baseline"))
    project = one
    for result in results:
        project = project.with_shape(edit.set_engine_keys(project.shape(shape.id), [result.results[0].key]))
    for frame, alone in zip(frames[1:], plain, strict=True):
        found, expected = project.shape(shape.id).at(frame).points, alone.results[0].shape.at(frame).points
        np.testing.assert_allclose(found, expected, atol=0.02)
    assert project.find(shape.id).key_at(frames[0]) == one.find(shape.id).key_at(frames[0])  # bit by bit
    tracked = project.shape(shape.id)
    assert not any(is_stale(tracked, key, None) for key in tracked.keys)
    moved = edit.set_properties(project, layer.id, transform=motion.with_matrices({frames[0]: np.eye(3)}))
    assert is_stale(moved.shape(shape.id), moved.shape(shape.id).keys[1], None)
