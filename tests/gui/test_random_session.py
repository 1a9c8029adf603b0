"""A whole session at random: edits, runs, stops, saves and openings mixed; nothing of it is lost or comes twice."""

from __future__ import annotations

import random
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.shell.main_window import MainWindow
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit, file
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.waiting import WAIT
from tests.gui.windows import COUNT, FIRST, opened_window, write_clip

STEPS, MOST_SHAPES = 300, 5
SQUARE = polygon_points([(20, 20), (60, 20), (60, 60), (20, 60)])


@pytest.fixture
def engine(monkeypatch: pytest.MonkeyPatch) -> GlidingEngine:
    return put_in(monkeypatch, GlidingEngine())


@pytest.fixture
def window(engine: GlidingEngine, qtbot: QtBot, tmp_path: Path) -> Iterator[MainWindow]:
    with opened_window(qtbot, write_clip(tmp_path / "plate"), tmp_path / "state") as window:
        yield window


class Session:
    """An artist who does anything at all, and does not wait for what is under way."""

    def __init__(self, window: MainWindow, engine: GlidingEngine, qtbot: QtBot, path: Path, seed: int) -> None:
        self.window, self.engine, self.qtbot, self.path = window, engine, qtbot, path
        self.random = random.Random(seed)
        self.first = window.document.project
        self.asked: list[str] = []
        """What the file may hold: the project as it was at each request to save it."""
        window.document.replaced.connect(self.replaced)
        act = window.actions_by_id
        self.commands: tuple[Callable[[], object], ...] = (
            *(self.move,) * 8,
            *(self.draw,) * 2,
            self.delete,
            *(act["edit.undo"].trigger,) * 5,
            *(act["edit.redo"].trigger,) * 3,
            *(act["track.forward"].trigger,) * 3,
            act["track.backward"].trigger,
            *(act["track.stop"].trigger,) * 2,
            *(lambda: engine.allow(self.random.randint(1, 4)),) * 5,
            *(lambda: window.view_state.set_frame(self.random.randint(FIRST, FIRST + COUNT - 1)),) * 3,
            *(lambda: qtbot.wait(self.random.randint(1, 15)),) * 4,
            *(self.save,) * 2,
        )

    def replaced(self) -> None:
        self.first = self.window.document.project

    def go(self, steps: int) -> None:
        for _ in range(steps):
            self.random.choice(self.commands)()

    def quiet(self) -> None:
        """Stop what is under way, and wait for what cannot be stopped."""
        self.window.propagation.drop()
        self.engine.allow(100)
        self.qtbot.waitUntil(
            lambda: all(r.is_idle for r in (self.window.solver, self.window.writer, self.window.saver)), timeout=WAIT
        )

    def move(self) -> None:
        document = self.window.document
        if document.project.shapes:
            shape = self.random.choice(document.project.shapes)
            frame = self.random.randint(FIRST, FIRST + COUNT - 1)
            moved = edit.set_key(shape, frame, shape.at(frame).points + self.random.uniform(-2.0, 2.0))
            document.apply("Move", document.project.with_shape(moved))

    def draw(self) -> None:
        document = self.window.document
        if len(document.project.shapes) < MOST_SHAPES:
            points = SQUARE + self.random.uniform(0.0, 40.0)
            project, shape = edit.new_shape(document.project, points, self.window.view_state.frame)
            document.apply("Draw", project)
            self.window.view_state.select(frozenset([shape.id]))

    def delete(self) -> None:
        document = self.window.document
        if document.project.shapes:
            gone = self.random.choice(document.project.shapes).id
            document.apply("Delete", edit.remove_items(document.project, [gone]))

    def save(self) -> None:
        self.asked.append(told(self.window.document.project))
        self.window.files.save(self.path)


def told(project: Project) -> str:
    """The whole project as its file would be."""
    return file.dumps(project, Path("/shots"))


@pytest.mark.parametrize("seed", range(3))
def test_whatever_happens_beside_an_edit_is_undone_redone_and_saved_as_one_sees_it(
    window: MainWindow, engine: GlidingEngine, qtbot: QtBot, tmp_path: Path, seed: int
) -> None:
    session = Session(window, engine, qtbot, tmp_path / "work.roam", seed)
    document, stack = window.document, window.document.undo_stack
    session.go(STEPS)
    session.quiet()
    assert session.asked
    assert told(file.load(session.path)) in session.asked
    last, index = told(document.project), stack.index()
    stack.setIndex(0)
    assert told(document.project) == told(session.first)
    stack.setIndex(index)
    assert told(document.project) == last
    session.save()
    session.quiet()
    assert told(file.load(session.path)) == last
    assert not document.is_modified
    window.files.open(session.path)
    qtbot.waitUntil(lambda: document.path == session.path and not stack.count(), timeout=WAIT)
    assert told(document.project) == last
    session.go(STEPS // 3)
    session.quiet()
    stack.setIndex(0)
    assert told(document.project) == last
