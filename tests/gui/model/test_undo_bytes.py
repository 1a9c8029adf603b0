"""The undo stack holds no more bytes than it may: the oldest steps go, the newest stay and work."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from app.model.document import Document
from app.model.holding import held_only_by
from roam_core.roto import Keyframe, Project, RotoShape, edit

POINTS = np.zeros((500, 3, 2))
STEP = POINTS.nbytes
"""Bytes that one step of these tests replaces, at least."""


@pytest.fixture
def shape_id(document: Document) -> str:
    project, shape = edit.new_shape(Project(), POINTS, 1)
    document.open(project, None)
    return shape.id


def move(document: Document, shape_id: str, by: float) -> Project:
    shape = document.project.shape(shape_id)
    document.apply(f"Move {by}", document.project.with_shape(shape.with_key(Keyframe(1, POINTS + by))))
    return document.project


def test_shared_keys_count_nothing(document: Document, shape_id: str) -> None:
    project = document.project
    renamed = project.with_shape(replace(project.shape(shape_id), name="New"))
    assert held_only_by(project, renamed) < STEP / 5
    assert held_only_by(project, Project()) > STEP
    assert held_only_by(project, project) == 0


def test_the_oldest_steps_go_and_the_others_work(document: Document, shape_id: str) -> None:
    document.undo_bytes = 10 * STEP
    forgot: list[bool] = []
    document.forgot.connect(lambda: forgot.append(True))
    states = [document.project, *(move(document, shape_id, number) for number in range(1, 41))]
    stack = document.undo_stack
    assert 5 <= stack.count() <= 10
    assert forgot
    assert stack.undoText() == "Move 40"
    for back in range(1, stack.count() + 1):
        stack.undo()
        assert document.project is states[40 - back]
    assert not stack.canUndo()
    while stack.canRedo():
        stack.redo()
    assert document.project is states[40]


def test_what_is_undone_counts_too_and_stays_while_done_steps_can_go(document: Document, shape_id: str) -> None:
    states = [document.project, *(move(document, shape_id, number) for number in range(1, 21))]
    for _ in range(5):
        document.undo_stack.undo()
    document.undo_bytes = 12 * STEP
    document.amend("Run", lambda project: project.with_shape(replace(project.shape(shape_id), name="N")), "none")
    assert document.undo_stack.count() <= 12
    document.undo_stack.undo()
    assert document.project is states[15]


def test_the_newest_step_stays_however_large(document: Document, shape_id: str) -> None:
    before = document.project
    document.undo_bytes = 1
    move(document, shape_id, 1.0)
    move(document, shape_id, 2.0)
    assert document.undo_stack.count() == 1
    document.undo_stack.undo()
    assert document.project is not before
    assert document.project.shape(shape_id).keys[0].points[0, 0, 0] == 1.0


def test_steps_are_not_gone_through_while_they_hold_little(
    document: Document, shape_id: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    gone_through: list[bool] = []
    monkeypatch.setattr(document, "_forget_oldest", lambda: gone_through.append(True))
    document.undo_bytes = 100 * STEP
    for number in range(30):
        move(document, shape_id, number)
    assert not gone_through
    document.undo_bytes = 10 * STEP
    move(document, shape_id, 30.0)
    assert gone_through


def test_arrays_of_keys_count_that_are_no_keys_of_the_other_project() -> None:
    soft = Keyframe(2, POINTS, feather=POINTS)
    keys = (Keyframe(1, POINTS), soft, Keyframe(3, POINTS, vertex_confidence=np.ones(500)))
    project = edit.add_shape(Project(), RotoShape("s", "s", keys))
    arrays = [a.nbytes for key in keys for a in (key.points, key.feather, key.vertex_confidence) if a is not None]
    assert sum(arrays) < held_only_by(project, Project()) < sum(arrays) + 10_000
    other = project.with_shape(project.shape("s").with_key(Keyframe(2, POINTS)))
    assert held_only_by(project, other) - held_only_by(other, project) == POINTS.nbytes  # the feather of the one key
