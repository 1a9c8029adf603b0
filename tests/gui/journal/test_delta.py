"""Deltas: what an edit changed and no more, and the later project put together again, bit by bit."""

from __future__ import annotations

import random
from collections.abc import Iterable
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest

from app.journal.delta import applied, between
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Keyframe, Origin, Project, edit, file, timing
from roam_core.roto.following import followed, pinned, still, surface_at, unpinned, with_moving_layer, with_points
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Layer

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("/plate"), 1, 50, (200, 100))


def engine_key(frame: int, points: np.ndarray = SQUARE) -> Keyframe:
    return Keyframe(frame, points + frame, origin=Origin.ENGINE, confidence=0.5, inputs="stamp")


@pytest.fixture
def project() -> Project:
    project = Project(CLIP)
    for _ in range(3):
        project = edit.new_shape(project, SQUARE, 1)[0]
    return project


def test_a_tracked_frame_is_one_key_and_known_as_such(project: Project) -> None:
    shape = project.shapes[1]
    long = project.with_shape(edit.set_engine_keys(shape, [engine_key(frame) for frame in range(2, 40)]))
    after = long.with_shape(edit.set_engine_keys(long.shape(shape.id), [engine_key(40)]))
    delta = between(long, after)
    assert (delta.ids, delta.tree, delta.tracked) == ((shape.id,), None, 1)
    (part,) = delta.parts.shapes
    assert part.frames == (40,)
    assert applied(long, delta) == after


def test_what_an_edit_did_not_touch_stays_the_same_object(project: Project) -> None:
    after = project.with_shape(replace(project.shapes[0], name="New"))
    again = applied(project, between(project, after))
    assert again == after
    assert again.shapes[1] is project.shapes[1]
    assert between(project, after).tracked == 0


def moving(project: Project, frames: Iterable[int]) -> tuple[Project, str]:
    """The project with a planar track of its first shape on some frames."""
    project, layer_id = with_moving_layer(project, [project.shapes[0].id], 1)
    for frame in frames:
        project = followed(project, layer_id, 1, frame, affine_of(frame), 0.5 + frame / 100)
    return project, layer_id


def affine_of(frame: int) -> np.ndarray:
    return np.array([[1.0, 0.01, frame], [0.0, 1.0, frame / 3], [1e-5, 0.0, 1.0]])


def test_a_frame_of_a_planar_track_is_one_matrix_and_known_as_such(project: Project) -> None:
    before, layer_id = moving(project, range(2, 40))
    after = followed(before, layer_id, 1, 40, affine_of(40), 0.7)
    delta = between(before, after)
    assert (delta.ids, delta.tree, delta.tracked, delta.partly) == ((layer_id,), None, 1, (layer_id,))
    (part,) = delta.parts.root.children
    assert isinstance(part, Layer)
    assert part.transform is not None
    assert part.transform.frames == (40,)
    assert applied(before, delta) == after


def test_what_becomes_of_a_motion_comes_back_whole(project: Project) -> None:
    start, layer_id = moving(project, range(2, 12))
    corners = surface_at(start, layer_id, 8) + np.array([(3.0, 1.0), (0.0, 0.0), (0.0, 2.0), (1.0, 0.0)])
    states = [start]
    states.append(pinned(states[-1], layer_id, 8, corners))
    states.append(followed(states[-1], layer_id, 8, 9, affine_of(1), 0.9))
    states.append(unpinned(states[-1], layer_id, 8))
    states.append(with_points(states[-1], layer_id, 1, np.array([(2.0, 3.0)]), (5.0, 9.0)))
    states.append(states[-1].map_item(layer_id, lambda item: replace(item, name="Plane", opacity=0.5)))
    states.append(still(states[-1], layer_id))
    for before, after in (*pairwise(states), *pairwise(reversed(states))):
        delta = between(before, after)
        again = replace(delta, parts=file.loads(file.dumps(delta.parts, Path("/")), Path("/")))
        assert applied(before, again) == after


def random_edit(project: Project, choose: random.Random) -> Project:
    shapes = project.shapes
    shape = choose.choice(shapes) if shapes else None
    kind = choose.randrange(9)
    if shape is None or kind == 0:
        return edit.new_shape(project, SQUARE + choose.random(), choose.randrange(1, 9))[0]
    if kind == 1:
        return project.with_shape(shape.with_key(engine_key(choose.randrange(1, 50), shape.keys[0].points)))
    if kind == 2 and len(shape.keys) > 1:
        return project.with_shape(replace(shape, keys=shape.keys[1:]))
    if kind == 3:  # another number of points
        points = polygon_points([(choose.random() * 9, i) for i in range(choose.randrange(3, 7))])
        return project.with_shape(replace(shape, keys=tuple(replace(key, points=points) for key in shape.keys)))
    if kind == 4:
        return timing.set_mark(project, choose.randrange(9))
    if kind == 5:
        moved = LayerTransform.of({1: np.eye(3), 9: np.eye(3) * [[1, choose.random(), 1]] * 2})
        layer = Layer(project.free_id("layer"), "Moving", tuple(project.root.children[:2]), transform=moved)
        return replace(project, root=replace(project.root, children=(layer, *project.root.children[2:])))
    if kind == 6:
        children = list(project.root.children)
        choose.shuffle(children)
        return replace(project, root=replace(project.root, children=tuple(children)))
    if kind == 7 and len(project.root.children) > 2:
        return replace(project, root=replace(project.root, children=project.root.children[1:]))
    return project.map_item(shape.id, lambda item: replace(item, opacity=choose.random(), extra={"newer": 1}))


@pytest.mark.parametrize("seed", range(4))
def test_any_row_of_edits_comes_back_from_its_texts(seed: int) -> None:
    choose, project = random.Random(seed), Project(CLIP)
    again = project
    for _ in range(60):
        after = random_edit(project, choose)
        delta = between(project, after)
        parts = file.loads(file.dumps(delta.parts, Path("/")), Path("/"))
        again = applied(again, replace(delta, parts=parts))
        project = after
        assert again == project
    assert file.digest(again) == file.digest(project)
