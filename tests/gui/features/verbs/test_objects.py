"""Solving as one, as parts, by itself; joints and depth: one undo step each, and sentences for what cannot be done."""

from __future__ import annotations

import pytest

from app.features.clipboards.shapes import ShapeClipboard
from app.features.verbs.layers import LayerVerbs
from app.features.verbs.objects import ObjectVerbs
from app.features.verbs.shapes import NOTHING_SELECTED, ShapeVerbs
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from roam_core.roto.linking import AS_STACKED, BEHIND, IN_FRONT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
A, B, C = "shape-1", "shape-2", "shape-3"


@pytest.fixture
def verbs(document: Document, view_state: ViewState) -> ObjectVerbs:
    """Three shapes on each other, two of them selected, on frame 7."""
    project = Project()
    for _ in range(3):
        project, _shape = edit.new_shape(project, SQUARE, 1)
    document.open(project, None)
    view_state.set_frame(7)
    view_state.select(frozenset({A, B}))
    return ObjectVerbs(document, view_state)


def told(document: Document) -> list[str]:
    return [shape.link for shape in document.project.shapes]


@pytest.mark.parametrize(
    ("action", "field", "value"),
    [
        ("object.one", "link", ["object-1", "object-1", ""]),
        ("object.apart", "link", ["object-1", "object-2", ""]),
        ("object.detach", "attached", [False, False, True]),
        ("object.in_front", "depth", [((7, 1),), ((7, 1),), ()]),
    ],
)
def test_a_verb_is_one_step(
    verbs: ObjectVerbs, document: Document, action: str, field: str, value: list[object]
) -> None:
    before = document.project
    verbs.handlers()[action]()
    assert [getattr(shape, field) for shape in document.project.shapes] == value
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project is before


@pytest.mark.parametrize(
    "pair", [("one", "parts"), ("apart", "parts"), ("detach", "attach"), ("in_front", "as_stacked")]
)
def test_a_verb_is_taken_back_by_its_counterpart(verbs: ObjectVerbs, document: Document, pair: tuple[str, str]) -> None:
    before = document.project
    for name in pair:
        verbs.handlers()[f"object.{name}"]()
    assert document.project == before
    assert document.undo_stack.count() == 2


@pytest.mark.parametrize("action", ["object.parts", "object.attach", "object.as_stacked"])
def test_what_changes_nothing_is_no_step(verbs: ObjectVerbs, document: Document, action: str) -> None:
    verbs.handlers()[action]()
    assert document.undo_stack.count() == 0


def test_a_layers_shapes_become_one_object(verbs: ObjectVerbs, document: Document, view_state: ViewState) -> None:
    LayerVerbs(document, view_state).group()
    assert view_state.layers
    verbs.link()
    assert {shape.name: shape.link for shape in document.project.shapes} == {
        "Shape 1": "object-1",
        "Shape 2": "object-1",
        "Shape 3": "",
    }


def test_what_cannot_be_done_is_said(verbs: ObjectVerbs, document: Document, view_state: ViewState) -> None:
    view_state.select(frozenset({A}))
    verbs.link()
    assert "two shapes or more" in view_state.message
    document.open(edit.set_properties(document.project, A, locked=True), None)
    verbs.set_apart()
    assert view_state.message == "What is selected is locked; unlock it first (Ctrl+L)."
    view_state.select(frozenset())
    verbs.set_apart()
    assert view_state.message == NOTHING_SELECTED
    assert document.undo_stack.count() == 0


def test_locked_shapes_are_left_alone(verbs: ObjectVerbs, document: Document, view_state: ViewState) -> None:
    document.open(edit.set_properties(document.project, A, locked=True), None)
    view_state.select(frozenset({A, B, C}))
    verbs.link()
    assert told(document) == ["", "object-1", "object-1"]
    assert view_state.message == "What is locked stays; unlock it first (Ctrl+L)."
    verbs.set_depth(BEHIND)
    assert "2 shapes lie behind" in view_state.message
    assert view_state.message.endswith("What is locked stays; unlock it first (Ctrl+L).")


def test_duplicates_are_an_object_of_their_own(verbs: ObjectVerbs, document: Document, view_state: ViewState) -> None:
    verbs.link()
    ShapeVerbs(document, view_state).duplicate()
    assert told(document) == ["object-1", "object-1", "", "object-2", "object-2"]


def test_pasted_shapes_are_an_object_of_their_own(
    verbs: ObjectVerbs, document: Document, view_state: ViewState
) -> None:
    verbs.link()
    clipboard = ShapeClipboard(document, view_state)
    clipboard.copy()
    clipboard.paste()
    assert told(document) == ["object-1", "object-1", "", "object-2", "object-2"]
    document.open(Project(), None)
    clipboard.paste()
    assert told(document) == ["object-1", "object-1"]


@pytest.mark.parametrize(
    ("level", "shape", "message"),
    [
        (BEHIND, A, "Nothing lies under what is selected from this frame on; it is behind already."),
        (IN_FRONT, C, "Nothing lies over what is selected from this frame on; it is in front already."),
    ],
)
def test_a_depth_that_brings_a_shape_past_no_other_is_no_step(
    verbs: ObjectVerbs, document: Document, view_state: ViewState, level: int, shape: str, message: str
) -> None:
    view_state.select(frozenset({shape}))
    verbs.set_depth(level)
    assert (document.undo_stack.count(), view_state.message) == (0, message)
    verbs.set_depth(-level)  # past both of the others
    verbs.set_depth(AS_STACKED)
    assert document.undo_stack.count() == 2
    assert document.project.shape(shape).depth == ()
