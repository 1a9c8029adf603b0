"""What menus leave out: actions that would find nothing to do on what is selected."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from app.features.possible import is_possible
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Keyframe, Origin, Project, RotoShape, Spline, edit

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
SECOND, TRACKED = Keyframe(5, SQUARE), Keyframe(3, SQUARE, origin=Origin.ENGINE)
SOFT = Keyframe(1, SQUARE, np.ones_like(SQUARE))


@pytest.mark.parametrize(
    ("action", "change"),
    [
        ("key.delete", lambda shape: shape.with_key(SECOND)),
        ("track.fill", lambda shape: shape.with_key(SECOND)),
        ("feather.all_keys", lambda shape: shape.with_key(SECOND)),
        ("track.delete_engine_keys", lambda shape: shape.with_key(TRACKED)),
        ("feather.reset", lambda shape: shape.with_key(SOFT)),
        ("shape.to_bezier", lambda shape: replace(shape, spline=Spline.BSPLINE)),
        ("object.parts", lambda shape: replace(shape, link="body")),
        ("object.as_stacked", lambda shape: replace(shape, depth=((1, 1),))),
    ],
)
def test_it_is_offered_only_where_there_is_something_to_do(
    view_state: ViewState, action: str, change: Callable[[RotoShape], RotoShape]
) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    view_state.select(frozenset({shape.id}))
    assert not is_possible(project, view_state, action)
    assert is_possible(project.with_shape(change(shape)), view_state, action)
    view_state.select(frozenset())
    assert not is_possible(project.with_shape(change(shape)), view_state, action)


def test_a_layer_can_be_dissolved_where_there_is_one(view_state: ViewState) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    view_state.select(frozenset({shape.id}))
    assert not is_possible(project, view_state, "layer.ungroup")
    project, layer = edit.add_layer(project)
    project, inner = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    view_state.select(frozenset({inner.id}))
    assert is_possible(project, view_state, "layer.ungroup")


def test_what_lies_on_top_is_lowered_only(view_state: ViewState) -> None:
    project, _ = edit.new_shape(Project(), SQUARE, 1)
    project, upper = edit.new_shape(project, SQUARE, 1)
    view_state.select(frozenset({upper.id}))
    assert not is_possible(project, view_state, "shape.raise")
    assert is_possible(project, view_state, "shape.lower")


def test_what_is_hidden_can_be_shown(view_state: ViewState) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    assert not is_possible(project, view_state, "shape.show_all")
    assert is_possible(edit.set_properties(project, shape.id, visible=False), view_state, "shape.show_all")


def test_what_needs_nothing_is_always_offered(view_state: ViewState) -> None:
    assert is_possible(Project(), view_state, "view.fit")


@pytest.mark.parametrize("action", ["key.set", "key.set_points"])
def test_a_key_is_offered_only_where_the_shape_exists(view_state: ViewState, action: str) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    view_state.select(frozenset({shape.id}))
    assert is_possible(project, view_state, action)
    assert not is_possible(edit.set_properties(project, shape.id, lifetime=(5, 9)), view_state, action)


@pytest.mark.parametrize("action", ["key.set", "track.forward", "edit.cut", "shape.delete", "shape.reverse"])
def test_what_is_locked_is_offered_no_edit(view_state: ViewState, action: str) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    project, other = edit.new_shape(project, SQUARE, 1)
    locked = edit.set_properties(project, shape.id, locked=True)
    view_state.select(frozenset({shape.id}))
    assert is_possible(project, view_state, action)
    assert not is_possible(locked, view_state, action)
    view_state.select(frozenset({shape.id, other.id}))
    assert is_possible(locked, view_state, action)
