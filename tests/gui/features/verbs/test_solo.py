"""Solo: what is shown and can be taken hold of, what is told, how it ends, and that nothing else knows of it."""

from __future__ import annotations

import numpy as np
import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.canvas.view import CanvasView
from app.canvas.words import label_of
from app.features.possible import is_possible
from app.features.verbs.shapes import ShapeVerbs
from app.features.verbs.solo import SoloVerbs
from app.model.document import Document
from app.model.reasons import why_not
from app.model.shown import lacks_base, shown_shapes
from app.model.view_state import ViewState
from app.model.viewing import ViewMode
from app.panels.shape_rows import NAME, SOLO
from app.panels.shapes import ShapesPanel
from roam_core.geometry.bezier import polygon_points
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Project, edit
from roam_core.roto.file import digest
from tests.gui.hand import Hand
from tests.gui.waiting import WAIT

SQUARES = {"a": 10.0, "b": 75.0, "c": 140.0}
"""Three squares beside each other: where they begin."""


def square(left: float) -> np.ndarray:
    return polygon_points([(left, 20.0), (left + 50.0, 20.0), (left + 50.0, 70.0), (left, 70.0)])


@pytest.fixture
def ids(canvas: CanvasView, document: Document) -> dict[str, str]:
    """The squares, by name; `c` lies in the layer `l`."""
    project = document.project
    found = {}
    for name, left in SQUARES.items():
        layer_id = "root"
        if name == "c":
            project, layer = edit.add_layer(project, "l")
            found["l"] = layer_id = layer.id
        project, shape = edit.new_shape(project, square(left), 1, name=name, layer_id=layer_id)
        found[name] = shape.id
    document.open(project, None)
    return found


@pytest.fixture
def verbs(document: Document, view_state: ViewState) -> SoloVerbs:
    return SoloVerbs(document, view_state)


def shown(document: Document, view_state: ViewState) -> list[str]:
    return [item.shape.name for item in shown_shapes(view_state.solo.seen(document.project), 1)]


def test_what_is_selected_is_shown_alone_and_all_again(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    verbs.toggle()
    assert "Select a shape first" in view_state.message
    assert not is_possible(document.project, view_state, "shape.solo")
    view_state.select(frozenset({ids["a"]}))
    verbs.toggle()
    assert shown(document, view_state) == ["a"]
    view_state.select(frozenset())
    assert is_possible(document.project, view_state, "shape.solo")
    verbs.toggle()
    assert shown(document, view_state) == ["a", "b", "c"]


def test_a_layer_is_soloed_with_what_lies_in_it_and_what_is_hidden_stays_so(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    document.apply("Hide", edit.set_properties(document.project, ids["a"], visible=False))
    view_state.select(frozenset({ids["a"], ids["c"]}), layers=frozenset({ids["l"]}))
    verbs.toggle()
    assert shown(document, view_state) == ["c"]


def test_the_project_its_matte_and_its_file_do_not_know_it(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    before, project = digest(document.project), document.project
    view_state.select(frozenset({ids["b"]}))
    verbs.toggle()
    assert document.project is project
    assert digest(document.project) == before
    whole, alone = (render_matte(each, 1, (150, 200)) for each in (project, view_state.solo.seen(project)))
    assert whole.sum() == pytest.approx(3 * 2500.0)
    assert alone.sum() == pytest.approx(2500.0)
    assert not document.undo_stack.count()


def test_the_viewer_shows_the_matte_of_what_is_soloed(
    qtbot: QtBot, verbs: SoloVerbs, canvas: CanvasView, ids: dict[str, str], view_state: ViewState
) -> None:
    canvas.viewing.set_mode(ViewMode.MATTE)
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        canvas.repaint()
    assert canvas.stage.shown_picture() is not None
    view_state.select(frozenset({ids["b"]}))
    with qtbot.waitSignal(canvas.matte_ready, timeout=WAIT):
        verbs.toggle()
        canvas.repaint()
    pixels = canvas.stage.shown_picture().pixels
    assert pixels[45, 100].max() == 255
    assert pixels[45, 35].max() == 0
    assert "Solo: b" in label_of(canvas._snapshot())


def test_what_is_not_shown_is_not_taken_hold_of(
    verbs: SoloVerbs, canvas: CanvasView, hand: Hand, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({ids["a"]}))
    verbs.toggle()
    hand.click((100.0, 20.0))
    assert ids["b"] not in view_state.selection.shapes
    view_state.select(frozenset({ids["a"], ids["b"]}))
    hand.drag((35.0, 20.0), (35.0, 40.0))
    tops = {shape.name: shape.at(1).anchors[0, 1] for shape in document.project.shapes}
    assert tops == {"a": 40.0, "b": 20.0, "c": 20.0}
    ShapeVerbs(document, view_state).select_all()
    assert view_state.selection.shapes == {ids["a"]}


def test_why_nothing_is_edited_is_told(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({ids["a"]}))
    verbs.toggle()
    view_state.select(frozenset({ids["b"]}))
    assert "'b' is not shown while others are soloed" in why_not(document.project, view_state)
    document.apply("Lock", edit.set_properties(document.project, ids["b"], locked=True))
    assert "'b' is locked" in why_not(document.project, view_state)


def test_what_is_drawn_is_soloed_too_and_what_an_undo_brings_back_is_not(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({ids["a"]}))
    verbs.toggle()
    project, _ = edit.new_shape(document.project, square(20.0), 1, name="new")
    document.apply("Draw", project)
    assert shown(document, view_state) == ["a", "new"]
    document.apply("Delete", edit.remove_items(document.project, [ids["b"]]))
    document.undo_stack.undo()
    assert shown(document, view_state) == ["a", "new"]
    document.undo_stack.undo()
    document.undo_stack.redo()
    assert shown(document, view_state) == ["a", "new"]


def test_it_ends_with_the_last_that_is_soloed_and_with_the_project(
    verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    view_state.select(frozenset({ids["a"]}))
    verbs.toggle()
    document.apply("Delete", edit.remove_items(document.project, [ids["a"]]))
    assert shown(document, view_state) == ["b", "c"]
    view_state.select(frozenset({ids["b"]}))
    verbs.toggle()
    document.open(Project(), None)
    assert not view_state.solo.ids


def test_rows_are_soloed_one_by_one_and_tell_it(
    qtbot: QtBot, verbs: SoloVerbs, ids: dict[str, str], document: Document, view_state: ViewState
) -> None:
    panel = ShapesPanel(document, view_state)
    qtbot.addWidget(panel)
    panel.resize(260, 300)
    with qtbot.waitExposed(panel, timeout=WAIT):
        panel.show()
    tree = panel.tree

    def press(name: str) -> None:
        place = tree.visualRect(tree.indexFromItem(tree.item(ids[name]), SOLO)).center()
        qtbot.mouseClick(tree.viewport(), Qt.MouseButton.LeftButton, pos=place)

    def dim() -> set[str]:
        colours = {name: tree.item(ids[name]).foreground(NAME).color().name() for name in ids}
        return {name for name, colour in colours.items() if colour != "#d8d8d8"}

    assert not dim()
    press("a")
    press("c")
    assert shown(document, view_state) == ["a", "c"]
    assert dim() == {"b"}
    press("l")
    assert view_state.solo.ids == {ids["a"], ids["l"]}, "what lies in a soloed layer is soloed with it"
    press("a")
    press("l")
    assert shown(document, view_state) == ["a", "b", "c"]
    assert not view_state.selection.shapes
    document.apply("Hide", edit.set_properties(document.project, ids["b"], visible=False))
    assert dim() == {"b"}


@pytest.mark.parametrize("blend", [BlendMode.SUBTRACT, BlendMode.INTERSECT])
def test_a_soloed_shape_that_only_takes_away_says_why_its_matte_is_empty(
    ids: dict[str, str], canvas: CanvasView, document: Document, view_state: ViewState, blend: BlendMode
) -> None:
    document.apply("Blend", edit.set_properties(document.project, ids["b"], blend=blend))
    empty = "Empty: what is shown only takes away, and nothing lies below it"
    view_state.solo.set({ids["b"]}, document.project)
    assert label_of(canvas._snapshot()) == "Solo: b"
    for mode, name in ((ViewMode.MATTE, "Matte"), (ViewMode.CUTOUT, "Cut-out")):
        canvas.viewing.set_mode(mode)
        assert label_of(canvas._snapshot()) == f"{name}  ·  Solo: b  ·  {empty}"
    view_state.solo.set({ids["a"], ids["b"]}, document.project)
    assert empty not in label_of(canvas._snapshot())
    view_state.solo.set({ids["l"]}, document.project)
    document.apply("Blend", edit.set_properties(document.project, ids["l"], blend=blend))
    assert empty in label_of(canvas._snapshot())
    document.apply("Hide", edit.set_properties(document.project, ids["c"], visible=False))
    assert empty not in label_of(canvas._snapshot())  # nothing is shown at all
    view_state.solo.set((), document.project)
    assert label_of(canvas._snapshot()) == "Cut-out"


@pytest.mark.parametrize("invert", [False, True])
def test_what_is_told_of_an_empty_matte_is_so(document: Document, ids: dict[str, str], invert: bool) -> None:
    project = edit.set_properties(document.project, ids["c"], blend=BlendMode.SUBTRACT)
    for name in "ab":
        project = edit.set_properties(project, ids[name], visible=False)
    project = edit.set_properties(project, ids["l"], invert=invert)
    assert lacks_base(project, 1) is not invert
    assert (render_matte(project, 1, (100, 200)).max() == 0.0) is not invert
