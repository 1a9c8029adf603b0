"""Document.amend: a change joins its own step, below what was done since."""

from __future__ import annotations

from collections.abc import Callable

from app.model.document import Document
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, timing

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])


def marking(frame: int) -> Callable[[Project], Project]:
    return lambda project: timing.set_mark(project, frame)


def frames(document: Document) -> list[int]:
    return [mark.frame for mark in document.project.marks]


def test_without_its_step_the_change_becomes_one(document: Document) -> None:
    document.amend("Run", marking(1), "run-1")
    document.amend("Run", marking(2), "run-1")
    assert document.undo_stack.count() == 1
    assert frames(document) == [1, 2]
    document.undo_stack.undo()
    assert frames(document) == []


def test_it_joins_its_step_below_later_ones_and_spares_what_can_be_redone(document: Document) -> None:
    stack, shown = document.undo_stack, []
    document.amend("Run", marking(1), "run-1")
    document.apply("Shape", edit.new_shape(document.project, SQUARE, 1)[0])
    document.apply("Mark", timing.set_mark(document.project, 9))
    stack.undo()
    document.changed.connect(lambda ids: shown.append(document.project))
    document.amend("Run", marking(2), "run-1")
    assert shown == [document.project]
    assert frames(document) == [1, 2]
    assert len(document.project.shapes) == 1
    stack.redo()
    assert frames(document) == [1, 2, 9]
    stack.undo()
    stack.undo()
    assert frames(document) == [1, 2]
    assert document.project.shapes == ()
    stack.undo()
    assert frames(document) == []


def test_a_step_that_was_undone_is_not_amended(document: Document) -> None:
    document.amend("Run", marking(1), "run-1")
    document.undo_stack.undo()
    document.amend("Run", marking(2), "run-1")
    assert frames(document) == [2]
    assert document.undo_stack.count() == 1
