"""Pasting the properties of what was copied: onto what is selected, as one step, by the clipboard of shapes."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path

import pytest
from PySide6.QtGui import QGuiApplication

from app.features.clipboards.shapes import ShapeClipboard
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import (
    Animated,
    BlendMode,
    Clip,
    Keyframe,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    ValueKey,
    edit,
)
from roam_core.roto.layers import grouped
from roam_core.roto.placement import LayerTransform
from roam_core.roto.properties import set_motion_blur

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
FADE = Animated((ValueKey(1, 0.0), ValueKey(9, 1.0)))
LOOK = {
    "blend": BlendMode.MAX,
    "opacity": FADE,
    "feather": 4.0,
    "invert": True,
    "motion_blur": MotionBlur(0.8),
    "colour": (0.0, 0.0, 1.0),
}


@pytest.fixture(autouse=True)
def nothing_is_copied() -> Iterator[None]:
    QGuiApplication.clipboard().clear()
    yield
    QGuiApplication.clipboard().clear()


class Desk:
    """A document with shapes, of which the first has a look of its own, and what pastes onto the others."""

    def __init__(self, document: Document, view_state: ViewState, count: int = 4) -> None:
        self.document, self.view = document, view_state
        project = Project(Clip(Path("plate"), 1, 9, (64, 48)))
        for _ in range(count):
            project, _shape = edit.new_shape(project, SQUARE, 1)
        self.ids = [shape.id for shape in project.shapes]
        document.open(edit.set_properties(project, self.ids[0], **LOOK), None)
        self.clipboard = ShapeClipboard(document, view_state)

    def act(self, verb: str, *shapes: str, layers: tuple[str, ...] = ()) -> str:
        """Do it with these selected; what is said of it."""
        self.view.say("")
        self.view.select(frozenset(shapes), layers=frozenset(layers))
        self.clipboard.handlers()[f"edit.{verb}"]()
        return self.view.message

    def change(self, shape_id: str, **values: object) -> None:
        self.document.open(edit.set_properties(self.document.project, shape_id, **values), None)

    def look(self, shape_id: str) -> dict[str, object]:
        return {name: getattr(self.document.project.find(shape_id), name) for name in LOOK}


@pytest.fixture
def desk(document: Document, view_state: ViewState) -> Desk:
    return Desk(document, view_state)


def test_all_properties_go_to_all_selected_shapes_in_one_step(desk: Desk) -> None:
    model, a, b, other = desk.ids
    before = desk.document.project
    desk.act("copy", model)
    told = desk.act("paste_properties", a, b)
    assert [desk.look(each) for each in (a, b)] == [LOOK, LOOK]
    assert desk.document.project.shape(other) is before.shape(other)
    assert all(desk.document.project.shape(each).keys == before.shape(each).keys for each in desk.ids)
    assert [shape.name for shape in desk.document.project.shapes] == [shape.name for shape in before.shapes]
    assert told == "Pasted onto 2 shapes: Colour, Blend, Opacity, Feather, Invert, Motion blur."
    assert (desk.document.undo_stack.count(), desk.document.undo_stack.undoText()) == (1, "Paste all properties")
    desk.document.undo_stack.undo()
    assert desk.document.project == before


@pytest.mark.parametrize(
    ("verb", "names"), [("paste_colour", {"colour"}), ("paste_matte_properties", set(LOOK) - {"colour"})]
)
def test_colour_or_the_matte_alone(desk: Desk, verb: str, names: set[str]) -> None:
    model, a, *_ = desk.ids
    plain = desk.look(a)
    desk.act("copy", model)
    desk.act(verb, a)
    assert desk.look(a) == {name: LOOK[name] if name in names else plain[name] for name in LOOK}


def test_what_is_locked_is_left_out_and_said(desk: Desk) -> None:
    model, a, locked, _ = desk.ids
    desk.change(locked, locked=True)
    plain = desk.look(locked)
    desk.act("copy", model)
    assert desk.act("paste_properties", a, locked).startswith("Pasted onto 1 shape: ")
    assert desk.view.message.endswith("What is locked stays; unlock it first (Ctrl+L).")
    assert (desk.look(a), desk.look(locked)) == (LOOK, plain)
    assert desk.act("paste_properties", locked).startswith("What is selected is locked")


def test_a_locked_one_does_not_shift_what_goes_where(desk: Desk) -> None:
    model, locked, b, plain = desk.ids
    desk.change(locked, locked=True)
    desk.act("copy", model, plain)
    desk.act("paste_properties", locked, b)
    assert desk.look(b)["opacity"] == 1.0


def test_several_looks_for_another_number_of_shapes_are_refused(desk: Desk) -> None:
    model, a, b, c = desk.ids
    before = desk.document.project
    desk.act("copy", model, a)
    assert "copy one shape, or select as many" in desk.act("paste_properties", a, b, c)
    assert desk.document.project is before


def test_copied_shapes_get_their_look_back(desk: Desk) -> None:
    model, a, *_ = desk.ids
    looks = [desk.look(each) for each in desk.ids]
    desk.act("copy", *desk.ids)
    for each in (model, a):
        desk.change(each, opacity=0.5, blend=BlendMode.SUBTRACT)
    desk.act("paste_properties", model, a)
    assert [desk.look(each) for each in desk.ids] == looks


def test_with_nothing_copied_or_selected_or_changed_that_is_said(desk: Desk) -> None:
    model, a, *_ = desk.ids
    assert "copy one first" in desk.act("paste_properties", a)
    QGuiApplication.clipboard().setText("Roto { a }")
    assert "copy one first" in desk.act("paste_properties", a)
    desk.act("copy", model)
    assert desk.act("paste_properties").startswith("Select a shape first")
    assert desk.act("paste_properties", model).startswith("Nothing changed")
    assert desk.document.undo_stack.count() == 0


def test_the_shape_of_a_copied_key_is_a_copied_shape(desk: Desk) -> None:
    model, a, *_ = desk.ids
    desk.view.select(frozenset({model}))
    desk.clipboard.keys.copy()
    desk.act("paste_properties", a)
    assert desk.look(a) == LOOK


def test_values_keep_their_keys_and_are_told_where_these_lie_beside_the_clip(desk: Desk) -> None:
    model = desk.ids[0]
    desk.act("copy", model)
    other = Project(Clip(Path("other"), 1001, 1048, (64, 48)))
    other, shape = edit.new_shape(other, SQUARE, 1001)
    desk.document.open(other, None)
    told = desk.act("paste_properties", shape.id)
    assert desk.document.project.shape(shape.id).opacity == FADE
    assert told.endswith(
        "Their keys lie on frames 1 to 9, none of them on the clip's 1001 to 1048: nothing varies here."
    )
    assert "keys lie" not in desk.act("paste_colour", shape.id)


def test_properties_of_a_layer_go_to_layers_and_those_of_a_shape_into_them(desk: Desk) -> None:
    model, a, b, c = desk.ids
    project, first = grouped(desk.document.project, [a], "First")
    project, second = grouped(project, [b, c], "Second")
    moves = LayerTransform.of({1: [[1.0, 0.0, 8.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]})
    project = edit.set_properties(project, second.id, transform=moves)
    desk.document.open(edit.set_properties(project, first.id, opacity=0.5, invert=True), None)
    before = desk.document.project
    desk.act("copy", a, layers=(first.id,))
    assert "select one, or copy a shape" in desk.act("paste_properties", b)
    told = desk.act("paste_properties", b, c, layers=(second.id,))
    assert told == "Pasted onto 1 layer: Opacity, Invert."
    assert desk.document.project.find(second.id) == replace(before.find(second.id), opacity=0.5, invert=True)
    assert desk.act("paste_colour", layers=(second.id,)).startswith("A layer has no colour of its own")
    desk.act("copy", model)
    assert desk.act("paste_properties", b, c, layers=(second.id,)).startswith("Pasted onto 2 shapes")
    assert [desk.look(each) for each in (b, c)] == [LOOK, LOOK]
    assert [desk.document.project.find(each).keys for each in (b, c)] == [before.find(each).keys for each in (b, c)]


def test_tracked_frames_that_another_blend_puts_out_of_date_are_told(document: Document, view_state: ViewState) -> None:
    desk = Desk(document, view_state, 1)
    clip = desk.document.project.require_clip()
    drawn = RotoShape("car", "Car", (Keyframe(1, SQUARE),))
    inputs = stamp([drawn], 2, 1, CONFIGS[DEFAULT_CONFIG], clip_stamp(clip), forward=True)
    tracked = drawn.with_key(Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=inputs))
    other = RotoShape("other", "Other", (Keyframe(1, SQUARE + 30.0),), blend=BlendMode.DIFFERENCE)
    document.open(edit.add_items(Project(clip), [tracked, other])[0], None)
    project = document.project
    assert not Stamps.of(project.shapes, clip).is_stale(project.shape("car"), project.shape("car").keys[1])
    desk.act("copy", "other")
    assert "Tracked frames of Car are out of date" in desk.act("paste_properties", "car")
    document.undo_stack.undo()
    desk.change("other", blend=BlendMode.ADD)
    document.open(document.project.with_shape(set_motion_blur(document.project.shape("other"), True)), None)
    desk.act("copy", "other")
    assert "Tracked" not in desk.act("paste_properties", "car")
