"""Reverse direction and first point in the window: one step, what is tracked holds, what is locked is refused."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest

from app.features.possible import is_possible
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.tools.edit.order_actions import OrderActions
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import Keyframe, Layer, LayerTransform, Origin, Project, RotoShape, edit
from tests.unit.propagate.shapes.test_restamping import CLIP, tracked

BIG = polygon_points([(10, 10), (150, 10), (150, 110), (10, 110)])


@pytest.fixture
def actions(document: Document, view_state: ViewState) -> OrderActions:
    return OrderActions(document, view_state)


def stale(project: Project) -> list[tuple[str, int]]:
    stamps = Stamps.of(project.shapes, project.clip)
    return [(shape.id, key.frame) for shape in project.shapes for key in shape.keys if stamps.is_stale(shape, key)]


def opened(document: Document, *shapes: RotoShape, transform: LayerTransform | None = None) -> None:
    inner = Layer("layer-1", "Layer 1", shapes, transform=transform)
    document.open(Project(CLIP, Layer("root", "Root", (inner,))), None)


def test_reversed_in_one_step_with_what_is_tracked_as_fresh_as_it_was(
    actions: OrderActions, document: Document, view_state: ViewState
) -> None:
    opened(document, tracked())
    before = document.project
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 2)}))
    actions.reverse()
    after = document.project.shapes[0]
    assert [np.array_equal(a.points[0], b.points[0]) for a, b in zip(after.keys, before.shapes[0].keys, strict=True)]
    assert np.array_equal(after.keys[3].points[1, 0], before.shapes[0].keys[3].points[3, 0])
    assert stale(before) == stale(document.project) == []
    assert view_state.selection == Selection(frozenset({"shape-1"})), "the points have other numbers"
    assert view_state.message == "1 shape is reversed now, on all keys."
    document.undo_stack.undo()
    assert document.project == before


def test_a_run_that_ends_for_it_has_the_word(actions: OrderActions, document: Document, view_state: ViewState) -> None:
    opened(document, tracked())
    view_state.select(frozenset({"shape-1"}))
    document.changed.connect(lambda _: view_state.say("Filling stopped."))
    actions.reverse()
    assert view_state.message == "Filling stopped."


def test_undo_and_redo_let_go_of_points_that_have_other_numbers_after_it(
    actions: OrderActions, document: Document, view_state: ViewState
) -> None:
    opened(document, tracked(), replace(tracked(), id="shape-2"))
    view_state.select(frozenset({"shape-1"}))
    actions.reverse()
    both = frozenset({"shape-1", "shape-2"})
    for step in (document.undo_stack.undo, document.undo_stack.redo):
        view_state.select(both, frozenset({("shape-1", 1), ("shape-2", 1)}))
        step()
        assert view_state.selection == Selection(both, frozenset({("shape-2", 1)}))
    view_state.select(both, frozenset({("shape-1", 1)}))
    moved = edit.set_key(
        document.project.shape("shape-1"), 1003, document.project.shape("shape-1").at(1003).points + 2.0
    )
    document.apply("Move", document.project.with_shape(moved))
    document.undo_stack.undo()
    assert view_state.selection.points == {("shape-1", 1)}, "an edit gives points no other numbers"


@pytest.mark.parametrize("verb", [lambda s: edit.insert_point(s, 0, 0.5), lambda s: edit.delete_points(s, [1])])
def test_a_step_back_over_an_inserted_or_deleted_point_selects_no_other_one(
    actions: OrderActions, document: Document, view_state: ViewState, verb: Callable[[RotoShape], RotoShape]
) -> None:
    opened(document, tracked())
    shape = document.project.shapes[0]
    other = replace(shape, id="shape-2")
    opened(document, shape, other)
    document.apply("Change", document.project.with_shape(verb(shape)))
    for step in (document.undo_stack.undo, document.undo_stack.redo):
        view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1), ("shape-2", 2)}))
        step()
        assert view_state.selection.points == frozenset({("shape-2", 2)})
        assert "shape-1" in view_state.selection.shapes


def test_what_was_out_of_date_stays_so(actions: OrderActions, document: Document, view_state: ViewState) -> None:
    shape = tracked()
    opened(document, shape.with_key(replace(shape.keys[0], inputs="backward:best:0:from=1003")))
    assert stale(document.project) == [("shape-1", 1001)]
    view_state.select(frozenset({"shape-1"}))
    actions.reverse()
    assert stale(document.project) == [("shape-1", 1001)]


def test_the_others_of_the_object_are_not_out_of_date_either(
    actions: OrderActions, document: Document, view_state: ViewState
) -> None:
    arm = RotoShape("shape-1", "Arm", tuple(key for key in tracked().keys if key.origin is Origin.ARTIST))
    body = RotoShape("shape-2", "Body", (Keyframe(1003, BIG),))
    params, clip = CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP)
    members = Stamps.of((arm, body), CLIP).together(body)
    assert len(members) == 2
    made = stamp(members, 1004, 1003, params, clip, forward=True)
    opened(document, arm, body.with_key(Keyframe(1004, BIG, origin=Origin.ENGINE, inputs=made)))
    assert not stale(document.project)
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 2)}))
    actions.begin_here()
    assert not stale(document.project)
    assert document.project.shapes[0].keys[0].points[0, 0].tolist() == arm.keys[0].points[2, 0].tolist()


def test_in_a_layer_that_moves_nothing_moves_nor_is_out_of_date(
    actions: OrderActions, document: Document, view_state: ViewState
) -> None:
    turn = np.array([[0.8, -0.3, 11.7], [0.25, 0.9, -4.1], [1e-4, 2e-4, 1.0]])
    opened(document, tracked(), transform=LayerTransform.of({1001: np.eye(3), 1012: turn}))
    params, stamps = CONFIGS[DEFAULT_CONFIG], Stamps.of(document.project.shapes, CLIP)
    made = {frame: stamps.tracked(0, frame, 1008, params, forward=True) for frame in (1009, 1010)}
    own = document.project.find("shape-1")
    assert isinstance(own, RotoShape)
    own = own.with_keys(replace(key, inputs=made[key.frame]) for key in own.keys if key.frame in made)
    project = document.project.map_item("shape-1", lambda _: own)
    document.open(project, None)
    assert ("shape-1", 1010) not in stale(project)
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1)}))
    actions.begin_here()
    after = document.project
    for frame in (1001, 1004, 1006.5, 1010):
        np.testing.assert_allclose(
            after.shapes[0].at(frame).points, np.roll(project.shapes[0].at(frame).points, -1, axis=0), atol=1e-9
        )
    assert stale(after) == stale(project)
    assert after.find("shape-1").key_at(1003).points.tolist() == np.roll(own.key_at(1003).points, -1, axis=0).tolist()


def test_what_is_locked_is_refused(actions: OrderActions, document: Document, view_state: ViewState) -> None:
    opened(document, tracked(), replace(tracked(), id="shape-2"))
    document.open(edit.set_properties(document.project, "shape-1", locked=True), None)
    project = document.project
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1)}))
    for verb in (actions.reverse, actions.begin_here):
        verb()
        assert "is locked; unlock it first" in view_state.message
        assert document.project is project
    view_state.select(frozenset({"shape-1", "shape-2"}))
    actions.reverse()
    assert "What is locked stays" in view_state.message
    assert document.project.shape("shape-1") == project.shape("shape-1")
    assert document.project.shape("shape-2") != project.shape("shape-2")


def test_what_is_lacking_is_told(actions: OrderActions, document: Document, view_state: ViewState) -> None:
    opened(document, tracked(), replace(tracked(), id="shape-2", closed=False))
    project = document.project
    actions.reverse()
    assert "Select a shape first" in view_state.message
    for points in ((), (1, 2)):
        view_state.select(frozenset({"shape-1"}), frozenset(("shape-1", index) for index in points))
        actions.begin_here()
        assert view_state.message == "Select the one point with which a shape is to begin."
        assert not is_possible(project, view_state, "points.first")
    view_state.select(frozenset({"shape-2"}), frozenset({("shape-2", 1)}))
    actions.begin_here()
    assert "is open and begins at one of its ends" in view_state.message
    assert not is_possible(project, view_state, "points.first")
    assert document.project is project
    view_state.select(frozenset({"shape-1"}), frozenset({("shape-1", 1)}))
    assert is_possible(project, view_state, "points.first")
