"""KeyMarks: every key falls into its kind, stale ones as the engine's own provenance tells."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from app.model.document import Document
from app.timeline import marks as marks_room
from app.timeline.marks import KeyMarks, MarksOf, key_marks
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.propagate.shapes import provenance
from roam_core.propagate.shapes.provenance import Stamps, clip_stamp, fill_stamp, is_stale, stamp
from roam_core.roto import Clip, Keyframe, Origin, Project, RotoShape, edit
from roam_core.roto.imported import import_stamp

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1, 30, (64, 48))


def tracked() -> RotoShape:
    """Artist keys at 5 and 15; engine keys both ways from them, frame 8 doubtful, frame 20 of unknown origin."""
    shape = RotoShape("s", "s", (Keyframe(5, SQUARE), Keyframe(15, SQUARE + 1)))
    keys = []
    for frame, begun, forward in [(2, 5, False), (7, 5, True), (8, 5, True), (12, 15, False), (16, 15, True)]:
        inputs = stamp([shape], frame, begun, CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP), forward)
        confidence = 0.3 if frame == 8 else 0.9
        keys.append(Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=confidence, inputs=inputs))
    keys.append(Keyframe(20, SQUARE, origin=Origin.ENGINE, inputs="forward:abacus:0"))
    return edit.set_engine_keys(shape, keys)


def stamps(*shapes: RotoShape, clip: Clip | None = CLIP) -> Stamps:
    return Stamps.of(shapes, clip)


def marks_of(shape: RotoShape, of: Stamps) -> KeyMarks:
    return key_marks(shape, of.stale_frames(shape))


def test_every_key_falls_into_its_kind() -> None:
    marks = marks_of(tracked(), stamps(tracked()))
    assert marks.artist.tolist() == [5, 15]
    assert marks.engine.tolist() == [2, 7, 12, 16]
    assert marks.doubtful.tolist() == [8]
    assert marks.stale.tolist() == [20]
    assert marks.confidence[:, 0].tolist() == [2, 7, 8, 12, 16, 20]
    assert marks.confidence[2, 1] == 0.3


def test_nothing_is_in_doubt_on_frames_on_which_the_shape_does_not_exist() -> None:
    ended = replace(tracked(), lifetime=(1, 8))
    marks = marks_of(ended, stamps(ended))
    assert marks.doubtful.tolist() == []
    assert marks.engine.tolist() == [2, 7, 8, 12, 16]
    assert marks.confidence[:, 0].tolist() == [2, 7]


def test_stale_keys_are_those_that_provenance_tells() -> None:
    moved = edit.set_key(tracked(), 5, SQUARE * 1.5)
    for shape in (tracked(), moved, edit.delete_keys(tracked(), [15]), replace(tracked(), closed=False)):
        for clip in (CLIP, replace(CLIP, size=(32, 24)), None):
            ref_stale = [key.frame for key in shape.keys if is_stale(shape, key, clip)]
            comp_stale = marks_of(shape, stamps(shape, clip=clip)).stale.tolist()
            assert comp_stale == ref_stale


def test_marks_are_made_anew_only_for_another_value(document: Document) -> None:
    document.open(edit.add_shape(Project(CLIP), tracked()), None)
    marks = MarksOf(document)
    shape = document.project.shape("s")
    first = marks(shape)
    assert marks(shape) is first
    document.apply("Key", document.project.with_shape(edit.set_key(shape, 9, SQUARE)))
    assert np.array_equal(marks(document.project.shape("s")).artist, [5, 9, 15])


def test_marks_follow_the_others_of_an_object(document: Document) -> None:
    shapes = [RotoShape(name, name, (Keyframe(5, SQUARE + at),)) for name, at in (("a", 0), ("near", 8), ("far", 500))]
    inputs = stamps(*shapes).tracked(0, 7, 5, CONFIGS[DEFAULT_CONFIG], True)
    shapes[0] = edit.set_engine_keys(shapes[0], [Keyframe(7, SQUARE, origin=Origin.ENGINE, inputs=inputs)])
    project = Project(CLIP)
    for shape in shapes:
        project = edit.add_shape(project, shape)
    document.open(project, None)
    marks = MarksOf(document)
    first = marks(document.project.shape("a"))
    for name, stale in (("far", []), ("near", [7])):
        moved = edit.set_key(document.project.shape(name), 5, document.project.shape(name).at(5).points + 2)
        document.apply("Move", document.project.with_shape(moved))
        assert marks(document.project.shape("a")).stale.tolist() == stale
        assert (marks(document.project.shape("a")) is first) == (name == "far")


def test_an_edit_of_one_shape_leaves_the_marks_of_its_object_that_stay_what_they_are(
    document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With hundreds of shapes in one object a drag of one made the marks of all anew."""
    project = Project(CLIP)
    for name in ("a", "b", "c"):
        project = edit.add_shape(project, RotoShape(name, name, (Keyframe(5, SQUARE),)))
    document.open(project, None)
    marks, made, told = MarksOf(document), list[str](), list[int]()
    make, given_on = marks_room.key_marks, provenance._given_on
    monkeypatch.setattr(marks_room, "key_marks", lambda shape, stale: made.append(shape.id) or make(shape, stale))
    monkeypatch.setattr(provenance, "_given_on", lambda shapes: told.append(len(shapes)) or given_on(shapes))
    first = [marks(shape) for shape in document.project.shapes]
    document.apply("Key", document.project.with_shape(edit.set_key(document.project.shape("b"), 9, SQUARE)))
    again = [marks(shape) for shape in document.project.shapes]
    assert made == ["a", "b", "c", "b"]
    assert [a is b for a, b in zip(first, again, strict=True)] == [True, False, True]
    assert told == [3, 3], "what the artist did to an object is told once for all its shapes"


def test_a_shape_that_was_hidden_or_renamed_has_the_same_marks(
    document: Document, monkeypatch: pytest.MonkeyPatch
) -> None:
    """To hide hundreds of shapes with thousands of keys made the marks of all of them anew."""
    document.open(edit.add_shape(Project(CLIP), tracked()), None)
    marks, made, make = MarksOf(document), list[str](), marks_room.key_marks
    monkeypatch.setattr(marks_room, "key_marks", lambda shape, stale: made.append(shape.name) or make(shape, stale))
    first = marks(document.project.shape("s"))
    for values in ({"visible": False}, {"name": "Other", "colour": (1.0, 0.0, 0.0)}):
        document.apply("Change", edit.set_properties(document.project, "s", **values))
        assert np.array_equal(marks(document.project.shape("s")).keyed, first.keyed)
    assert len(made) == 1
    document.apply("Life", edit.set_properties(document.project, "s", lifetime=(1, 6)))
    told = marks(document.project.shape("s"))
    assert len(made) == 2
    assert set(told.confidence[:, 0]) <= set(range(1, 6))


def test_what_was_filled_is_fresh_until_a_key_on_either_side_changes() -> None:
    shape = RotoShape("s", "s", (Keyframe(5, SQUARE), Keyframe(15, SQUARE + 1)))
    inputs = fill_stamp([shape], (5, 15), CONFIGS[DEFAULT_CONFIG], clip_stamp(CLIP))
    filled = edit.set_engine_keys(shape, [Keyframe(f, SQUARE, origin=Origin.ENGINE, inputs=inputs) for f in (8, 9)])
    assert marks_of(filled, stamps(filled)).engine.tolist() == [8, 9]
    for frame in (5, 15):
        moved = edit.set_key(filled, frame, SQUARE * 2)
        assert marks_of(moved, stamps(moved)).stale.tolist() == [8, 9]


def test_what_a_file_put_between_its_keys_is_a_tick_without_confidence() -> None:
    read = RotoShape("s", "s", (Keyframe(5, SQUARE), Keyframe(9, SQUARE + 1)))
    between = Keyframe(7, SQUARE, origin=Origin.ENGINE, inputs=import_stamp(read, 7))
    shape = edit.set_engine_keys(read, [between])
    moved = edit.set_key(shape, 9, SQUARE + 4)
    marks = marks_of(shape, stamps(shape))
    assert (marks.artist.tolist(), marks.engine.tolist()) == ([5, 9], [7])
    assert marks.confidence.shape == (0, 2)
    assert marks_of(moved, stamps(moved)).stale.tolist() == [7]


def test_an_undo_brings_marks_back_that_were_told_before(document: Document, monkeypatch: pytest.MonkeyPatch) -> None:
    """Each undo and redo of an edit of hundreds of shapes asked for the stamps of all, and made all marks anew."""
    document.open(edit.add_shape(Project(CLIP), tracked()), None)
    marks, asked, stale = MarksOf(document), list[str](), Stamps.stale_frames
    monkeypatch.setattr(Stamps, "stale_frames", lambda self, shape: asked.append(shape.id) or stale(self, shape))
    before = marks(document.project.shape("s"))
    moved = edit.set_key(document.project.shape("s"), 5, SQUARE + 3.0)
    document.apply("Move", document.project.with_shape(moved))
    after = marks(document.project.shape("s"))
    assert asked == ["s", "s"]
    assert before.stale.tolist() != after.stale.tolist()
    for step, told in ((document.undo_stack.undo, before), (document.undo_stack.redo, after)):
        step()
        assert marks(document.project.shape("s")) is told
    assert asked == ["s", "s"]
    assert marks(moved, Project(CLIP)).artist.tolist() == [5, 15], "of a value that is in no project, told by itself"


def test_marks_of_projects_that_are_gone_go(document: Document) -> None:
    document.open(edit.add_shape(Project(CLIP), tracked()), None)
    marks = MarksOf(document)
    for by in range(3):
        preview = document.project.with_shape(edit.set_key(document.project.shape("s"), 5, SQUARE + by))
        marks(preview.shape("s"), preview)
    assert len(marks._of_projects) <= 2
