"""Keys nudged by the keyboard pass others as a drag does: what they go over is there again behind them."""

from __future__ import annotations

from dataclasses import replace

import pytest
from PySide6.QtCore import Qt
from pytestqt.qtbot import QtBot

from app.model.document import Document
from app.timeline.timeline import Timeline
from roam_core.roto import Animated, Keyframe, Project, ValueKey, edit
from tests.gui.waiting import WAIT

ALT = Qt.KeyboardModifier.AltModifier
FADES = Animated((ValueKey(1005, 0.2), ValueKey(1007, 0.8), ValueKey(1035, 0.5)))


@pytest.fixture
def keyed(qtbot: QtBot, timeline: Timeline, document: Document) -> None:
    """The lower shape has keys of the artist's on 1001, 1003 and 1030, and an opacity that varies."""
    shape = document.project.shape("shape-1")
    third = replace(shape.keys[0], frame=1003, points=shape.keys[0].points + 5.0)
    document.apply("Keys", document.project.with_shape(replace(shape.with_key(third), opacity=FADES)))
    timeline.activateWindow()


def keys(document: Document) -> tuple[Keyframe, ...]:
    return document.project.shape("shape-1").keys


def fades(document: Document) -> Animated:
    found = document.project.shape("shape-1").opacity
    assert isinstance(found, Animated)
    return found


def press(qtbot: QtBot, timeline: Timeline, *arrows: Qt.Key) -> None:
    timeline.rows.setFocus()
    qtbot.waitUntil(timeline.rows.hasFocus, timeout=WAIT)
    for arrow in arrows:
        qtbot.keyClick(timeline.rows, arrow, ALT)


def test_a_key_passes_those_of_the_artist_and_of_the_engine(
    qtbot: QtBot, timeline: Timeline, document: Document, keyed: None
) -> None:
    before, beside = keys(document), [key for key in keys(document) if key.frame != 1001]
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    press(qtbot, timeline, *[Qt.Key.Key_Right] * 4)
    assert timeline.keys.places == {("shape-1", 1005)}
    assert [key for key in keys(document) if key.frame != 1005] == [key for key in beside if key.frame != 1005]
    press(qtbot, timeline, *[Qt.Key.Key_Left] * 9)  # no farther than the clip begins
    assert keys(document) == before
    for _ in range(4):
        document.undo_stack.undo()  # each press is a step of its own
    assert document.project.shape("shape-1").artist_frames == (1003, 1005, 1030)


def test_another_edit_ends_the_row(qtbot: QtBot, timeline: Timeline, document: Document, keyed: None) -> None:
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    press(qtbot, timeline, Qt.Key.Key_Right, Qt.Key.Key_Right)
    assert document.project.shape("shape-1").artist_frames == (1003, 1030)
    shape = document.project.shape("shape-1")
    document.apply("Rename", document.project.with_shape(replace(shape, name="Hand")))
    press(qtbot, timeline, Qt.Key.Key_Right)
    assert document.project.shape("shape-1").name == "Hand"
    assert document.project.shape("shape-1").artist_frames == (1004, 1030)


def test_what_is_tracked_of_another_shape_does_not_end_the_row(
    qtbot: QtBot, timeline: Timeline, document: Document, keyed: None
) -> None:
    """A key that is passed is there again behind those that move, and what was tracked stays."""
    passed = keys(document)[[key.frame for key in keys(document)].index(1003)]
    timeline.keys.select(frozenset({("shape-1", 1001)}))
    press(qtbot, timeline, Qt.Key.Key_Right, Qt.Key.Key_Right)

    def tracked(project: Project) -> Project:
        other = project.shape("shape-2")
        return project.with_shape(edit.set_engine_keys(other, [replace(other.keys[1], frame=1025)]))

    document.amend("Track", tracked, "run")
    press(qtbot, timeline, Qt.Key.Key_Right)
    assert document.project.shape("shape-1").artist_frames == (1003, 1004, 1030)
    assert document.project.shape("shape-1").key_at(1003) == passed
    assert document.project.shape("shape-2").key_at(1025) is not None


def test_a_key_of_opacity_passes_others(timeline: Timeline, document: Document, keyed: None) -> None:
    timeline.values.select(frozenset({("shape-1", "opacity", 1005)}))
    for step in range(5):
        timeline.value_rows.verbs.nudge(1, f"step-{step}")
    assert [(key.frame, key.value) for key in fades(document).keys] == [(1007, 0.8), (1010, 0.2), (1035, 0.5)]
    assert timeline.values.places == {("shape-1", "opacity", 1010)}


def test_a_key_of_an_outline_passes_others_in_its_curve(timeline: Timeline, document: Document, keyed: None) -> None:
    timeline.values.select(frozenset({("shape-1", "x", 1001)}))
    for step in range(4):
        timeline.curves.plot.verbs.nudge(1, f"step-{step}")
    assert document.project.shape("shape-1").artist_frames == (1003, 1005, 1030)
