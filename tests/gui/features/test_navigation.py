"""Moving the playhead: by frames and keys, of the selected shapes alone; in and out."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from app.features.navigation import Navigation
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Animated, Clip, Keyframe, Origin, Project, ValueKey, edit
from roam_core.roto.following import followed, pinned, surface_at, with_moving_layer
from roam_core.roto.layers import grouped
from roam_core.roto.linking import BEHIND, set_depth

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1001, 1048, (64, 48))


@pytest.fixture
def navigation(document: Document, view_state: ViewState) -> Navigation:
    """Two shapes: keys by hand on 1005 and 1020, and on 1012; a tracked frame on 1008."""
    navigation = Navigation(document, view_state)
    project, first = edit.new_shape(Project(CLIP), SQUARE, 1005)
    tracked = edit.set_engine_keys(edit.key_here(first, 1020), [Keyframe(1008, SQUARE, origin=Origin.ENGINE)])
    document.open(edit.new_shape(project.with_shape(tracked), SQUARE, 1012)[0], None)
    return navigation


def test_a_project_opens_on_its_first_key(navigation: Navigation, view_state: ViewState) -> None:
    assert view_state.frame == 1005
    assert view_state.play_range == (1001, 1049)


def test_keys_by_hand_are_visited_of_all_shapes_or_of_the_selected_ones(
    navigation: Navigation, view_state: ViewState
) -> None:
    visited, told = [], []
    for shapes in (frozenset[str](), frozenset({"shape-1"})):
        view_state.select(shapes)
        view_state.set_frame(1001)
        for step in (navigation.next_key, navigation.next_key, navigation.next_key, navigation.previous_key):
            step()
            visited.append(view_state.frame)
            told.append(view_state.message)
    assert visited == [1005, 1012, 1020, 1012, 1005, 1020, 1020, 1005]
    assert told == [""] * 6 + ["There is no key after this frame.", ""]  # it is untrue on the frame before


def test_changes_of_depth_are_visited_like_keys(
    navigation: Navigation, document: Document, view_state: ViewState
) -> None:
    document.apply("Behind", set_depth(document.project, ["shape-1"], 1015, BEHIND))
    view_state.select(frozenset({"shape-1"}))
    visited = []
    for step in (navigation.next_key, navigation.next_key, navigation.previous_key):
        step()
        visited.append(view_state.frame)
    assert visited == [1015, 1020, 1015]
    document.open(document.project, None)
    assert view_state.frame == 1005  # a project opens on its first key


def test_keys_of_a_layers_opacity_are_visited_with_it(
    navigation: Navigation, document: Document, view_state: ViewState
) -> None:
    project, layer = grouped(document.project, {"shape-1"})
    fades = Animated((ValueKey(1003, 0.0), ValueKey(1030, 1.0)))
    document.open(edit.set_properties(project, layer.id, opacity=fades), None)
    view_state.set_frame(1020)
    navigation.next_key()
    assert view_state.frame == 1030  # nothing is selected: all that varies is meant
    view_state.select(frozenset({"shape-1"}), layers=frozenset({layer.id}))
    navigation.previous_key()
    navigation.next_key()
    assert view_state.frame == 1030
    view_state.select(frozenset({"shape-1"}), layers=frozenset())
    navigation.previous_key()
    navigation.next_key()
    assert view_state.frame == 1020
    assert "no key after" in view_state.message


def test_adjust_keys_of_a_track_are_visited_with_its_shapes(
    navigation: Navigation, document: Document, view_state: ViewState
) -> None:
    project, layer_id = with_moving_layer(document.project, ["shape-1"], 1005)
    for frame in range(1006, 1016):
        project = followed(project, layer_id, 1005, frame, np.eye(3))
    document.apply("Adjust key", pinned(project, layer_id, 1014, surface_at(project, layer_id, 1014) + 2.0))
    visited = []
    for shapes in (frozenset({"shape-1"}), frozenset({"shape-2"})):
        view_state.select(shapes)
        view_state.set_frame(1005)
        navigation.next_key()
        visited.append(view_state.frame)
    assert visited == [1014, 1012]


def test_keys_beside_the_clip_are_not_visited(
    navigation: Navigation, document: Document, view_state: ViewState
) -> None:
    """A plate may be shorter than the shapes on it, as where they come with handles, or from another shot."""
    project = document.project
    for frame in (900, 1101):
        project = project.with_shape(edit.key_here(project.shape("shape-1"), frame))
    document.open(project, None)
    assert view_state.frame == 1001
    navigation.previous_key()
    assert view_state.frame == 1001
    assert "no key before" in view_state.message
    view_state.set_frame(1020)
    navigation.next_key()
    assert view_state.frame == 1020
    view_state.set_frame(1101)  # whoever asks for it
    assert view_state.frame == 1048


def test_steps_stay_inside_the_clip(navigation: Navigation, view_state: ViewState) -> None:
    navigation.step(-10)
    assert view_state.frame == 1001
    navigation.step(100)
    assert view_state.frame == 1048


def test_in_leaves_out_where_it_is_and_out_leaves_in(navigation: Navigation, view_state: ViewState) -> None:
    for set_end, frame in ((navigation.set_out, 1030), (navigation.set_in, 1010), (navigation.set_out, 1020)):
        view_state.set_frame(frame)
        set_end()
    assert view_state.play_range == (1010, 1021)
    navigation.set_in()
    assert view_state.play_range == (1020, 1021)


def test_an_end_that_passes_the_other_one_frees_it(navigation: Navigation, view_state: ViewState) -> None:
    view_state.set_frame(1010)
    navigation.set_out()
    view_state.set_frame(1020)
    navigation.set_in()
    assert view_state.play_range == (1020, 1049)
    view_state.set_frame(1015)
    navigation.set_out()
    assert view_state.play_range == (1001, 1016)
    navigation.first()
    assert view_state.frame == 1001
    navigation.last()
    assert view_state.frame == 1015
    navigation.clear_range()
    assert view_state.play_range == (1001, 1049)
