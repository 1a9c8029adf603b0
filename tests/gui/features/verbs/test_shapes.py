"""The verbs on whole shapes: which of them "all" are."""

from __future__ import annotations

from functools import partial
from pathlib import Path

import pytest
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QAbstractItemView, QWidget
from pytestqt.qtbot import QtBot

from app.features.clipboards.shapes import ShapeClipboard
from app.features.possible import is_possible
from app.features.verbs.finishing import finish_shape
from app.features.verbs.layers import LayerVerbs
from app.features.verbs.shapes import ShapeVerbs, delete
from app.model.document import Document
from app.model.view_state import Selection, ViewState
from app.panels.shapes import ShapesPanel
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, stamp
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit
from roam_core.roto.layers import grouped
from tests.gui.panels.test_shapes import drop

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


@pytest.fixture
def widget(qtbot: QtBot) -> QWidget:
    widget = QWidget()
    qtbot.addWidget(widget)
    return widget


def opened(document: Document, count: int) -> list[str]:
    """A project of so many shapes; gives their ids, bottom first."""
    project = Project()
    for _ in range(count):
        project, _shape = edit.new_shape(project, SQUARE, 1)
    document.open(project, None)
    return [shape.id for shape in project.shapes]


def test_all_shapes_are_those_in_sight_that_are_not_locked(document: Document, view_state: ViewState) -> None:
    plain, locked, hidden, gone, below = opened(document, 5)
    project = edit.set_properties(document.project, locked, locked=True)
    project = edit.set_properties(project, hidden, visible=False)
    project = edit.set_properties(project, gone, lifetime=(5, 9))
    document.open(project, None)
    view_state.select(frozenset({locked}), frozenset({(plain, 1)}))
    ShapeVerbs(document, view_state).select_all()
    assert view_state.selection == Selection(frozenset({plain, below}))


def test_nothing_is_selected_where_that_is_asked_for(document: Document, view_state: ViewState) -> None:
    (only,) = opened(document, 1)
    project, layer = grouped(document.project, [only])
    document.open(project, None)
    view_state.select(frozenset({only}), frozenset({(only, 1)}), frozenset({layer.id}))
    assert is_possible(project, view_state, "shape.select_none")
    ShapeVerbs(document, view_state).handlers()["shape.select_none"]()
    assert (view_state.selection, view_state.layers) == (Selection(), frozenset())
    assert not is_possible(project, view_state, "shape.select_none")


def test_where_none_can_be_selected_it_is_said(document: Document, view_state: ViewState) -> None:
    (only,) = opened(document, 1)
    document.open(edit.set_properties(document.project, only, locked=True), None)
    ShapeVerbs(document, view_state).select_all()
    assert view_state.selection == Selection()
    assert "No shape is in sight" in view_state.message


def test_selected_points_become_a_key_of_theirs(document: Document, view_state: ViewState) -> None:
    plain, other = opened(document, 2)
    verbs = ShapeVerbs(document, view_state)
    view_state.set_frame(7)
    view_state.select(frozenset({plain, other}))
    verbs.set_key_of_points()
    assert "Select the points" in view_state.message
    view_state.select(frozenset({plain, other}), frozenset({(plain, 1), (plain, 2)}))
    verbs.set_key_of_points()
    key = document.project.shape(plain).key_at(7)
    assert key is not None
    assert key.set_points == (1, 2)
    assert document.project.shape(other).frames == (1,)
    assert document.undo_stack.undoText() == "Set key for points"
    verbs.set_key()
    key = document.project.shape(plain).key_at(7)
    assert key is not None
    assert key.set_points == ()


def test_what_is_locked_is_not_deleted_and_that_is_said(document: Document, view_state: ViewState) -> None:
    """Neither a locked shape, nor one in a locked layer, nor the layer of one."""
    plain, locked, inside, kept = opened(document, 4)
    project = edit.set_properties(document.project, locked, locked=True)
    project, layer = grouped(project, [inside], "Done")
    project, other = grouped(project, [kept], "Other")
    project = edit.set_properties(edit.set_properties(project, layer.id, locked=True), kept, locked=True)
    document.open(project, None)
    view_state.select(frozenset({plain, locked, inside}))
    ShapeVerbs(document, view_state).delete()
    assert {shape.id for shape in document.project.shapes} == {locked, inside, kept}
    assert "What is locked stays" in view_state.message
    before = document.project
    delete(document, view_state, [layer.id, other.id])
    assert document.project is before


def test_a_selected_layer_is_hidden_and_locked_itself(document: Document, view_state: ViewState) -> None:
    """Not the shapes in it: those keep their own eyes and locks. A shape beside it goes along."""
    inside, beside, other = opened(document, 3)
    project, layer = grouped(document.project, [inside])
    document.open(project, None)
    view_state.select(frozenset({inside, beside}), layers=frozenset({layer.id}))
    verbs = ShapeVerbs(document, view_state)
    verbs.hide()
    items = document.project.root.items()
    assert {item.id for item in items if not item.visible} == {layer.id, beside}
    document.undo_stack.undo()
    verbs.toggle_lock()
    assert {item.id for item in document.project.root.items() if item.locked} == {layer.id, beside}
    verbs.toggle_lock()
    assert not any(item.locked for item in document.project.root.items())
    project, empty = edit.add_layer(document.project)
    document.open(project, None)
    view_state.select(frozenset(), layers=frozenset({empty.id}))
    verbs.hide()
    assert [item.id for item in document.project.root.items() if not item.visible] == [empty.id]
    assert document.project.shape(other).visible


def test_of_several_shapes_the_first_says_whether_all_are_locked_or_unlocked(
    document: Document, view_state: ViewState
) -> None:
    free, locked = opened(document, 2)
    document.open(edit.set_properties(document.project, locked, locked=True), None)
    view_state.select(frozenset({free, locked}))
    ShapeVerbs(document, view_state).toggle_lock()
    assert [shape.locked for shape in document.project.shapes] == [True, True]
    assert document.undo_stack.undoText() == "Lock"
    document.open(edit.set_properties(document.project, locked, locked=False), None)
    view_state.select(frozenset({free, locked}))
    ShapeVerbs(document, view_state).toggle_lock()
    assert [shape.locked for shape in document.project.shapes] == [False, False]
    assert document.undo_stack.undoText() == "Unlock"


def test_where_there_is_no_key_to_delete_it_is_said(document: Document, view_state: ViewState) -> None:
    plain, other = opened(document, 2)
    document.open(document.project.with_shape(edit.key_here(document.project.shape(plain), 7)), None)
    view_state.select(frozenset({plain, other}))
    view_state.set_frame(6)
    ShapeVerbs(document, view_state).delete_key()
    assert "no key on frame 6" in view_state.message
    view_state.set_frame(7)
    ShapeVerbs(document, view_state).delete_key()
    assert document.project.shape(plain).frames == (1,)


def test_a_shape_with_one_key_keeps_no_other_from_losing_theirs(document: Document, view_state: ViewState) -> None:
    """As where a figure's parts are selected, and one of them is new."""
    first, single, last = opened(document, 3)
    project = document.project
    for shape_id in (first, last):
        project = project.with_shape(edit.key_here(project.shape(shape_id), 7))
    document.open(project, None)
    view_state.select(frozenset({first, single, last}))
    view_state.set_frame(1)
    ShapeVerbs(document, view_state).delete_key()
    assert [shape.frames for shape in document.project.shapes] == [(7,), (1,), (7,)]
    name = document.project.shape(single).name
    assert view_state.message == f"{name!r} needs at least one key; delete the shape instead."


def test_shapes_get_no_key_where_they_do_not_exist_and_that_is_said(document: Document, view_state: ViewState) -> None:
    lasting, ended = opened(document, 2)
    document.open(edit.set_properties(document.project, ended, lifetime=(1, 5)), None)
    view_state.set_frame(7)
    verbs = ShapeVerbs(document, view_state)
    view_state.select(frozenset({lasting, ended}))
    verbs.set_key()
    assert [shape.frames for shape in document.project.shapes] == [(1, 7), (1,)]
    before = document.project
    view_state.select(frozenset({ended}), frozenset({(ended, 0)}))
    for verb in (verbs.set_key, verbs.set_key_of_points):
        verb()
        assert document.project is before
        assert "does not exist on frame 7" in view_state.message


def test_without_a_selection_copy_cut_and_delete_ask_for_one(document: Document, view_state: ViewState) -> None:
    opened(document, 1)
    clipboard = ShapeClipboard(document, view_state)
    for verb in (clipboard.copy, clipboard.cut, partial(delete, document, view_state, [])):
        view_state.say("")
        verb()
        assert view_state.message.startswith("Select a shape first")


def test_what_is_locked_gets_no_key_and_that_is_said(document: Document, view_state: ViewState) -> None:
    (only,) = opened(document, 1)
    document.open(edit.set_properties(document.project, only, locked=True), None)
    view_state.select(frozenset({only}))
    view_state.set_frame(7)
    ShapeVerbs(document, view_state).set_key()
    assert document.project.shape(only).frames == (1,)
    assert "is locked" in view_state.message


def test_of_several_shapes_the_locked_one_gets_no_key_and_that_is_said(
    document: Document, view_state: ViewState
) -> None:
    """It was passed over in silence."""
    free, locked = opened(document, 2)
    document.open(edit.set_properties(document.project, locked, locked=True), None)
    view_state.select(frozenset({free, locked}))
    view_state.set_frame(7)
    ShapeVerbs(document, view_state).set_key()
    assert document.project.shape(free).frames == (1, 7)
    assert document.project.shape(locked).frames == (1,)
    assert "What is locked stays" in view_state.message


def test_points_of_a_locked_shape_get_no_key_and_that_is_what_is_said(
    document: Document, view_state: ViewState
) -> None:
    (only,) = opened(document, 1)
    document.open(edit.set_properties(document.project, only, locked=True), None)
    view_state.select(frozenset({only}))
    ShapeVerbs(document, view_state).set_key_of_points()
    assert "is locked" in view_state.message


def test_what_is_locked_is_not_cut_nor_copied_by_that(
    document: Document, view_state: ViewState, widget: QWidget
) -> None:
    plain, locked = opened(document, 2)
    document.open(edit.set_properties(document.project, locked, locked=True), None)
    clipboard = ShapeClipboard(document, view_state, widget, lambda _text: False)
    QGuiApplication.clipboard().setText("before")
    view_state.select(frozenset({locked}))
    clipboard.cut()
    assert QGuiApplication.clipboard().text() == "before"
    view_state.select(frozenset({plain, locked}))
    clipboard.cut()
    assert [shape.id for shape in document.project.shapes] == [locked]
    assert '"shape-1"' in QGuiApplication.clipboard().text()
    assert '"shape-2"' not in QGuiApplication.clipboard().text()


def test_shapes_pasted_from_another_shot_say_where_their_keys_lie(
    document: Document, view_state: ViewState, widget: QWidget
) -> None:
    (only,) = opened(document, 1)
    view_state.select(frozenset({only}))
    clipboard = ShapeClipboard(document, view_state, widget, lambda _text: False)
    clipboard.copy()
    document.open(Project(Clip(Path("shot"), 1001, 1048, (64, 48))), None)
    view_state.say("")
    clipboard.paste()
    assert [shape.frames for shape in document.project.shapes] == [(1,)]
    assert "on frames 1 to 1, none of them on the clip's 1001 to 1048" in view_state.message
    document.open(Project(Clip(Path("shot"), 1, 48, (64, 48))), None)
    view_state.say("")
    clipboard.paste()
    assert view_state.message == ""


def test_a_layer_is_duplicated_cut_and_pasted_whole(document: Document, view_state: ViewState, widget: QWidget) -> None:
    (inside,) = opened(document, 1)
    project, layer = grouped(document.project, [inside], "Arm")
    document.open(edit.set_properties(project, layer.id, opacity=0.5), None)
    view_state.select(frozenset({inside}), layers=frozenset({layer.id}))
    ShapeVerbs(document, view_state).duplicate()
    assert [item.name for item in document.project.root.children] == ["Arm", "Arm 1"]
    assert len(view_state.layers) == 1
    assert view_state.selection.shapes == {shape.id for shape in document.project.shapes} - {inside}
    clipboard = ShapeClipboard(document, view_state, widget, lambda _text: False)
    clipboard.cut()
    assert view_state.message == "Copied 1 layer."
    assert [item.name for item in document.project.root.children] == ["Arm"]
    clipboard.paste()
    (back,) = view_state.layers
    found = document.project.find(back)
    assert (found.name, found.opacity) == ("Arm 1", 0.5)
    assert len(document.project.shapes) == 2
    document.open(edit.set_properties(document.project, inside, locked=True), None)
    view_state.select(frozenset({inside}), layers=frozenset({layer.id}))
    clipboard.cut()
    assert document.project.has(layer.id)
    assert "What is locked stays" in view_state.message


@pytest.mark.parametrize("how", ["duplicate", "paste"])
def test_locked_copies_are_told(document: Document, view_state: ViewState, how: str) -> None:
    (name,) = opened(document, 1)
    document.open(edit.set_properties(document.project, name, locked=True), None)
    view_state.select(frozenset({name}))
    if how == "duplicate":
        ShapeVerbs(document, view_state).duplicate()
    else:
        clipboard = ShapeClipboard(document, view_state)
        clipboard.copy()
        clipboard.paste()
    assert [shape.locked for shape in document.project.shapes] == [True, True]
    assert view_state.message == "What is locked gives locked copies; Ctrl+L unlocks them."


@pytest.mark.parametrize("how", ["duplicate", "paste", "draw", "draw apart"])
def test_what_lies_on_a_tracked_shape_and_makes_its_frames_stale_is_told(
    document: Document, view_state: ViewState, how: str
) -> None:
    clip = Clip(Path("plate"), 1, 9, (120, 80))
    drawn = RotoShape("shape-1", "Car", (Keyframe(1, SQUARE),))
    inputs = stamp([drawn], 2, 1, CONFIGS[DEFAULT_CONFIG], clip_stamp(clip), forward=True)
    tracked = drawn.with_key(Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=inputs))
    document.open(edit.add_items(Project(clip), [tracked])[0], None)
    view_state.select(frozenset({"shape-1"}))
    if how == "duplicate":
        ShapeVerbs(document, view_state).duplicate()
    elif how == "paste":
        clipboard = ShapeClipboard(document, view_state)
        clipboard.copy()
        clipboard.paste()
    else:
        finish_shape(document, view_state, "polygon", SQUARE + (5.0 if how == "draw" else 60.0), 1)
    assert len(document.project.shapes) == 2
    is_told = view_state.message.startswith("Tracked frames of Car are out of date")
    assert is_told is (how != "draw apart")
    assert not is_told or "Solve by itself" in view_state.message


@pytest.mark.parametrize(
    ("in_out", "left", "told"),
    [
        ((1, 10), (1,), "Deleted 8 tracked frames."),
        ((4, 7), (1, 2, 3, 7, 8, 9), "Deleted 3 tracked frames from 4 to 6."),
        ((1, 2), tuple(range(1, 10)), "Between in and out, 1 to 1, no frame is tracked."),
    ],
)
def test_tracked_frames_are_deleted_between_in_and_out(
    document: Document, view_state: ViewState, in_out: tuple[int, int], left: tuple[int, ...], told: str
) -> None:
    keys = [Keyframe(1, SQUARE), *(Keyframe(frame, SQUARE, origin=Origin.ENGINE) for frame in range(2, 10))]
    tracked = RotoShape("shape-1", "Car", tuple(keys))
    document.open(edit.add_items(Project(Clip(Path("plate"), 1, 9, (120, 80))), [tracked])[0], None)
    view_state.select(frozenset({"shape-1"}))
    view_state.set_play_range(*in_out)
    ShapeVerbs(document, view_state).delete_engine_keys()
    assert document.project.shapes[0].frames == left
    assert view_state.message == told
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    before = document.project
    ShapeVerbs(document, view_state).delete_engine_keys()
    assert document.project is before
    assert "locked" in view_state.message


def test_locked_shapes_keep_their_tracked_frames_and_that_is_said(document: Document, view_state: ViewState) -> None:
    keys = Keyframe(1, SQUARE), Keyframe(2, SQUARE, origin=Origin.ENGINE)
    shapes = [RotoShape("shape-1", "Car", keys), RotoShape("shape-2", "Hat", keys, locked=True)]
    document.open(edit.add_items(Project(Clip(Path("plate"), 1, 9, (120, 80))), shapes)[0], None)
    view_state.select(frozenset({"shape-1", "shape-2"}))
    view_state.set_play_range(1, 10)
    ShapeVerbs(document, view_state).delete_engine_keys()
    assert [shape.frames for shape in document.project.shapes] == [(1,), (1, 2)]
    assert view_state.message.startswith("Deleted 1 tracked frame. What is locked stays")


@pytest.mark.parametrize(
    ("copied", "selected", "home"),
    [
        (("shape-1", ()), ("", ("layer-1",)), "layer-1"),  # cut or copied here, pasted into another layer
        (("shape-2", ()), ("shape-2", ()), "layer-1"),  # beside what was copied
        (("shape-2", ()), ("", ()), "root"),
        (("", ("layer-1",)), ("", ("layer-1",)), "root"),  # no copy of a layer in the layer itself
        (("", ("layer-2",)), ("", ("layer-2",)), "layer-1"),
        (("", ("layer-1",)), ("", ("layer-2",)), "layer-2"),
    ],
)
def test_what_is_pasted_comes_into_the_layer_in_hand(
    document: Document, view_state: ViewState,
    copied: tuple[str, tuple[str, ...]], selected: tuple[str, tuple[str, ...]], home: str,
) -> None:  # fmt: skip
    opened(document, 3)
    project, outer = grouped(document.project, {"shape-2", "shape-3"})
    project, inner = grouped(project, {"shape-3"})
    assert (outer.id, inner.id) == ("layer-1", "layer-2")
    document.open(project, None)
    clipboard = ShapeClipboard(document, view_state)
    for (shape_id, layers), call in ((copied, clipboard.copy), (selected, clipboard.paste)):
        held = {shape.id for layer in layers for shape in project.find(layer).shapes()} | ({shape_id} - {""})
        view_state.select(frozenset(held), layers=frozenset(layers))
        call()
    new = view_state.layers or view_state.selection.shapes
    assert {document.project.layers_above(item_id)[-1].id for item_id in new} == {home}
    assert len(new) == 1
    assert not any(project.has(item_id) for item_id in new)


def test_what_is_gone_and_was_a_part_of_a_tracked_object_is_told(document: Document, view_state: ViewState) -> None:
    clip = Clip(Path("plate"), 1, 9, (120, 80))
    parts = [RotoShape(f"shape-{k}", f"Part {k}", (Keyframe(1, SQUARE + 5.0 * k),)) for k in (1, 2)]
    inputs = stamp(parts, 2, 1, CONFIGS[DEFAULT_CONFIG], clip_stamp(clip), forward=True)
    tracked = [part.with_key(Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=inputs)) for part in parts]
    document.open(edit.add_items(Project(clip), tracked)[0], None)
    delete(document, view_state, ["shape-2"])
    assert view_state.message == "Tracked frames of Part 1 are out of date: what is gone was a part of its object."


def test_of_hundreds_of_shapes_that_an_edit_outdates_a_few_are_asked(
    document: Document, view_state: ViewState, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Three names are told; to find them each copy of a tracked shape was asked for the stamps of all its frames."""
    clip = Clip(Path("plate"), 1, 9, (900, 900))
    parts = [RotoShape(f"shape-{k}", f"Part {k}", (Keyframe(1, SQUARE + 40.0 * k),)) for k in range(1, 21)]
    stamps = Stamps.of(parts, clip)
    keys = [
        Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=stamps.tracked(k, 2, 1, CONFIGS[DEFAULT_CONFIG], True))
        for k in range(20)
    ]
    document.open(
        edit.add_items(Project(clip), [part.with_key(key) for part, key in zip(parts, keys, strict=True)])[0], None
    )
    asked, stale = list[str](), Stamps.stale_frames
    monkeypatch.setattr(Stamps, "stale_frames", lambda self, shape: asked.append(shape.id) or stale(self, shape))
    view_state.select(frozenset(part.id for part in parts))
    ShapeVerbs(document, view_state).duplicate()
    assert view_state.message.startswith("Tracked frames of Part 1, Part 2, Part 3 … are out of date")
    assert set(asked) == {"shape-1", "shape-2", "shape-3", "shape-4"}


def test_what_is_pasted_is_taken_out_of_the_clipboard_once(
    document: Document, view_state: ViewState, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Hundreds of shapes are 100 MB of text."""
    (only,) = opened(document, 1)
    view_state.select(frozenset({only}))
    clipboard = ShapeClipboard(document, view_state)
    clipboard.copy()
    taken, text = list[int](), QGuiApplication.clipboard().text()

    class Counted:
        def text(self) -> str:
            taken.append(len(text))
            return text

    monkeypatch.setattr(QGuiApplication, "clipboard", Counted)
    clipboard.paste()
    assert len(document.project.shapes) == 2
    assert taken == [len(text)]


@pytest.mark.parametrize("way", ["key", "drop", "group"])
def test_parts_of_a_tracked_object_that_are_stacked_otherwise_are_told(
    qtbot: QtBot, document: Document, view_state: ViewState, way: str
) -> None:
    clip = Clip(Path("plate"), 1, 9, (120, 80))
    parts = [RotoShape(f"shape-{k}", f"Part {k}", (Keyframe(1, SQUARE + 5.0 * k),)) for k in (1, 2, 3)]
    stamps = Stamps.of(parts, clip)
    inputs = [stamps.tracked(k, 2, 1, CONFIGS[DEFAULT_CONFIG], True) for k in (0, 1, 2)]
    tracked = [
        part.with_key(Keyframe(2, SQUARE, origin=Origin.ENGINE, inputs=own))
        for part, own in zip(parts, inputs, strict=True)
    ]
    document.open(edit.add_items(Project(clip), tracked)[0], None)
    view_state.select(frozenset({"shape-1", "shape-3"} if way == "group" else {"shape-1"}))
    if way != "drop":
        LayerVerbs(document, view_state).handlers()["shape.raise" if way == "key" else "shape.group"]()
    else:
        panel = ShapesPanel(document, view_state)
        qtbot.addWidget(panel)
        drop(panel, "shape-2", QAbstractItemView.DropIndicatorPosition.AboveItem)
    assert [shape.id for shape in document.project.shapes] == ["shape-2", "shape-1", "shape-3"]
    assert view_state.message == (
        "Tracked frames of Part 1, Part 2, Part 3 are out of date: what hides what goes by the order in the list."
    )


def test_to_unlock_a_shape_in_a_locked_layer_names_the_layer(document: Document, view_state: ViewState) -> None:
    project, shape = edit.new_shape(Project(), SQUARE, 1)
    project, layer = grouped(project, [shape.id])
    document.open(edit.set_properties(project, layer.id, name="Body", locked=True), None)
    view_state.select(frozenset({shape.id}))
    lock = ShapeVerbs(document, view_state).handlers()["shape.lock"]
    lock()
    assert view_state.message == "'Shape 1' lies in 'Body', which is locked: unlock that layer in the list."
    view_state.say("")
    view_state.select(frozenset({shape.id}), layers=frozenset({layer.id}))
    lock()
    assert not document.project.find(layer.id).locked
    assert view_state.message == ""
