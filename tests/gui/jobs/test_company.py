"""What a run is solved with: a shape that comes to belong to its object meanwhile ends a track, a fill begins again."""

from __future__ import annotations

from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.jobs.propagation import Propagation
from app.jobs.runner import Runner
from app.jobs.solving.company import Company
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Clip, Project, edit
from tests.gui.engines import GlidingEngine, put_in
from tests.gui.waiting import WAIT

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
FRAMES = range(1, 9)
CLIP = Clip(Path("shot"), 1, 12, (64, 48))


@pytest.fixture
def project() -> Project:
    """One square, keyed on 1 and 4."""
    project, drawn = edit.new_shape(Project(clip=CLIP), SQUARE, 1)
    return project.with_shape(edit.set_key(drawn, 4, SQUARE + 3.0))


@pytest.fixture
def under_way(
    qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner, monkeypatch: pytest.MonkeyPatch,
    project: Project,
) -> tuple[Propagation, GlidingEngine]:  # fmt: skip
    """A track of the square that has done one frame and waits."""
    engine = put_in(monkeypatch, GlidingEngine())
    document.open(project, None)
    propagation = Propagation(document, view_state, runner, lambda frame: None)
    engine.allow(1)
    with qtbot.waitSignal(propagation.solved, timeout=WAIT):
        propagation.start(["shape-1"], FRAMES)
    return propagation, engine


def names(company: Company, project: Project, reached: int | None = None) -> list[str]:
    return [shape.name for shape in company.joined(project, reached)]


def test_a_shape_drawn_over_another_on_the_frame_where_its_track_began_joins(project: Project) -> None:
    company = Company(project, ["shape-1"], frames=FRAMES)
    drawn, _ = edit.new_shape(project, SQUARE + 5.0, 1)
    assert names(company, project) == []
    assert names(company, drawn) == ["Shape 2"]
    assert names(Company(project, ["shape-1"], frames=FRAMES, alone=True), drawn) == []


def test_one_drawn_far_off_joins_once_it_is_moved_there(project: Project) -> None:
    far, other = edit.new_shape(project, SQUARE + 30.0, 1)
    company = Company(far, ["shape-1"], frames=FRAMES)
    assert names(company, far) == []
    assert names(company, far.with_shape(edit.set_key(other, 1, SQUARE + 5.0))) == ["Shape 2"]


def test_one_drawn_later_joins_once_the_track_begins_anew_from_a_key(project: Project) -> None:
    """Until then the run, which began before it was there, does not hear of it; nor do the stamps of its keys."""
    company = Company(project, ["shape-1"], frames=FRAMES)
    drawn, _ = edit.new_shape(project, SQUARE + 5.0, 3)
    assert [frame for frame in FRAMES if company.begins_anew(frame)] == [4]
    assert names(company, drawn, 3) == []
    assert names(company, drawn, 4) == ["Shape 2"]
    assert names(company, edit.new_shape(project, SQUARE + 5.0, 6)[0], 8) == []


def test_of_a_fill_joins_what_takes_part_between_its_keys(project: Project) -> None:
    company = Company(project, ["shape-1"], [(1, 4)])
    drawn, other = edit.new_shape(project, SQUARE + 5.0, 1)
    assert names(company, drawn) == []
    assert names(company, drawn.with_shape(edit.set_key(other, 4, SQUARE + 8.0))) == ["Shape 2"]


def test_a_track_over_which_a_part_is_drawn_ends_and_says_of_what(
    qtbot: QtBot, document: Document, under_way: tuple[Propagation, GlidingEngine]
) -> None:
    propagation, _ = under_way
    document.apply("Draw", edit.new_shape(document.project, SQUARE + 5.0, 3)[0])
    assert propagation.is_running
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        document.apply("Draw", edit.new_shape(document.project, SQUARE + 5.0, 1)[0])
    assert finished.args is not None
    assert finished.args[1] == (
        "Tracking stopped at frame 2; the finished frames stay. Shape 3 belongs to the same object now."
    )


def test_a_track_that_begins_anew_ends_where_a_part_was_drawn_meanwhile(
    qtbot: QtBot, document: Document, under_way: tuple[Propagation, GlidingEngine]
) -> None:
    propagation, engine = under_way
    document.apply("Draw", edit.new_shape(document.project, SQUARE + 5.0, 3)[0])
    with qtbot.waitSignal(propagation.finished, timeout=WAIT) as finished:
        engine.allow(6)
    assert finished.args is not None
    assert finished.args[1].startswith("Tracking stopped at frame 4")
