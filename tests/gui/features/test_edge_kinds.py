"""What the window knows of edges: asked for beside its thread, once for a state, and nothing without a picture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest
from pytestqt.qtbot import QtBot

from app.features.edge_kinds import EdgeKinds
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.propagate.parts.edges import Edge
from roam_core.roto import Clip, Origin, Project, edit
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

BODY, ARM = "shape-1", "shape-2"
BOXES = (60, 60, 120, 160), (100, 80, 180, 98)


@pytest.fixture
def reads() -> list[int]:
    """The frames that were read."""
    return []


@pytest.fixture
def read(reads: list[int]) -> Callable[[int], Any]:
    """A grey body and a light arm on a dark background, on every frame but the ninth."""

    def picture(frame: int) -> Any:
        reads.append(frame)
        if frame == 9:
            raise RoamError("Frame 9 is missing.")
        image = np.full((300, 400, 3), 20, dtype=np.uint8)
        for (left, top, right, bottom), level in zip(BOXES, (110, 230), strict=True):
            image[top:bottom, left:right] = level
        return image

    return picture


@pytest.fixture
def kinds(
    document: Document, view_state: ViewState, runner: Runner, read: Callable[[int], Any], qtbot: QtBot
) -> EdgeKinds:
    project = Project(clip=Clip(Path("plate"), 1, 20, (400, 300)))
    for left, top, right, bottom in BOXES:
        corners = [(left, top), (right, top), (right, bottom), (left, bottom)]
        project, _ = edit.new_shape(project, polygon_points(corners), 5)
    document.open(project, None)
    view_state.set_frame(5)
    return EdgeKinds(document, view_state, read, runner)


def asked(kinds: EdgeKinds, qtbot: QtBot) -> set[str]:
    """The shapes of which something is known once it is found out."""
    with qtbot.waitSignal(kinds.changed, timeout=WAIT):
        kinds.here()
    return set(kinds.here())


def test_all_shapes_are_measured_or_the_selected_ones(kinds: EdgeKinds, view_state: ViewState, qtbot: QtBot) -> None:
    assert kinds.here() == {}
    assert asked(kinds, qtbot) == {BODY, ARM}
    assert kinds.here()[BODY].share(Edge.HIDDEN) > 0.03
    view_state.select(frozenset({ARM}))
    assert asked(kinds, qtbot) == {ARM}
    assert kinds.here()[ARM].share(Edge.SEAM) > 0.1


def test_while_shapes_are_soloed_they_are_measured_whatever_is_selected(
    kinds: EdgeKinds, document: Document, view_state: ViewState, qtbot: QtBot
) -> None:
    view_state.select(frozenset({ARM}))
    assert asked(kinds, qtbot) == {ARM}
    view_state.solo.set({BODY}, document.project)
    assert asked(kinds, qtbot) == {BODY}
    assert kinds.here()[BODY].share(Edge.HIDDEN) > 0.03  # the arm hides it, in sight or not
    view_state.solo.set((), document.project)
    assert asked(kinds, qtbot) == {ARM}


def test_a_state_is_measured_once(
    kinds: EdgeKinds, document: Document, view_state: ViewState, reads: list[int], qtbot: QtBot
) -> None:
    asked(kinds, qtbot)
    shape = document.project.shape(ARM)
    tracked = shape.with_key(replace(shape.keys[0], frame=6, origin=Origin.ENGINE))
    document.apply("Track", document.project.with_shape(tracked))
    assert set(kinds.here()) == {BODY, ARM}
    assert reads == [5]
    moved = edit.set_key(document.project.shape(ARM), 5, shape.at(5).points + 3.0)
    document.apply("Move", document.project.with_shape(moved))
    assert set(kinds.here()) == {BODY, ARM}  # what was known stands until the new is
    asked(kinds, qtbot)
    assert reads == [5, 5]


def test_without_a_picture_nothing_is_known(
    kinds: EdgeKinds, view_state: ViewState, document: Document, qtbot: QtBot
) -> None:
    asked(kinds, qtbot)
    view_state.set_frame(9)
    assert kinds.here() == {}
    assert asked(kinds, qtbot) == set()
    view_state.set_frame(5)
    assert asked(kinds, qtbot) == {BODY, ARM}
    document.open(Project(), None)
    assert kinds.here() == {}


def test_the_window_shows_edges_when_it_is_asked_to(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "shot"), tmp_path / "state") as window:
        project = window.document.project
        for left, top, right, bottom in ((20, 20, 60, 100), (50, 40, 120, 52)):
            corners = [(left, top), (right, top), (right, bottom), (left, bottom)]
            project, _ = edit.new_shape(project, polygon_points(corners), FIRST)
        window.document.apply("Draw", project)
        switch = window.actions_by_id["view.edges"]
        switch.trigger()
        assert switch.isChecked()
        qtbot.waitUntil(lambda: set(window.edge_kinds.here()) == {BODY, ARM}, timeout=WAIT)
        assert window.edge_kinds.here()[BODY].share(Edge.HIDDEN) > 0.0
        window.view_state.set_frame(FIRST + 3)
        qtbot.waitUntil(lambda: set(window.edge_kinds.here()) == {BODY, ARM}, timeout=WAIT)
        switch.trigger()
        assert not switch.isChecked()
