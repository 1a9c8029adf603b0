"""What the window knows of objects: the place of each shape, the joints, and when it asks again."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest
from pytestqt.qtbot import QtBot

from app.features import belonging
from app.features.belonging import Belonging, Place, bones, places
from app.jobs.runner import Runner
from app.model.document import Document
from app.model.view_state import ViewState
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import BlendMode, Clip, Keyframe, Origin, Project, RotoShape, edit
from roam_core.roto.linking import apart, attached, linked
from tests.gui.waiting import WAIT
from tests.gui.windows import FIRST, opened_window, write_clip

CLIP = Clip(Path("plate"), 1, 20, (400, 300))
TORSO, ARM, BALL = "shape-1", "shape-2", "shape-3"


def box(left: float, top: float, right: float, bottom: float) -> list[tuple[float, float]]:
    return [(left, top), (right, top), (right, bottom), (left, bottom)]


BODY = {"torso": box(60, 60, 120, 160), "arm": box(108, 80, 180, 98), "ball": box(300, 200, 330, 230)}


def drawn(outlines: dict[str, list[tuple[float, float]]], frame: int = 5) -> Project:
    """A project with a key of every outline on a frame, the first lowest."""
    project = Project(clip=CLIP)
    for name, corners in outlines.items():
        project, _ = edit.new_shape(project, polygon_points(corners), frame, name=name)
    return project


def told(project: Project) -> list[str]:
    found = places(project)
    return [str(found[shape.id]) for shape in project.shapes]


def subtracting(project: Project, shape_id: str) -> Project:
    return edit.set_properties(project, shape_id, blend=BlendMode.SUBTRACT)


def test_shapes_that_overlap_are_parts_and_one_far_away_is_an_object() -> None:
    assert told(drawn(BODY)) == ["Part of 2", "Part of 2", "One object"]


def test_the_outlines_of_one_compound_are_one_whole_and_other_shapes_nearby_their_own() -> None:
    project = drawn({"left": box(10, 10, 40, 40), "right": box(45, 10, 80, 40)})
    assert told(project) == ["One object"] * 2
    for shape_id in (TORSO, ARM):
        project = edit.set_properties(project, shape_id, compound="mask-1")
    assert told(project) == ["Whole of 2 shapes"] * 2


def test_the_artists_word_is_told_with_its_name() -> None:
    assert told(linked(drawn(BODY), [TORSO, BALL])) == [
        "Whole of 2 shapes (object-1)",
        "One object",
        "Whole of 2 shapes (object-1)",
    ]
    assert told(apart(drawn(BODY), [ARM]))[:2] == ["One object", "By itself"]


def test_what_subtracts_is_a_hole_inside_and_an_occluder_across() -> None:
    within = drawn({**BODY, "ball": box(70, 100, 90, 120)})
    assert told(subtracting(within, BALL)) == ["Part of 2", "Part of 2", "Hole of torso"]
    across = drawn({**BODY, "ball": box(20, 100, 90, 120)})
    assert told(subtracting(across, BALL)) == ["Part of 2", "Part of 2", "Occluder"]
    assert told(linked(subtracting(within, BALL), [TORSO, ARM, BALL]))[2] == "Hole of the whole (object-1)"


def test_an_open_shape_is_not_tracked() -> None:
    assert told(edit.set_properties(drawn(BODY), BALL, closed=False))[2] == "Open: not tracked"


def test_a_joint_lies_where_the_end_of_one_part_covers_the_other() -> None:
    (bone,) = bones(drawn(BODY), 5, {ARM})
    assert bone.shapes == (TORSO, ARM)
    assert 100.0 < bone.joint[0] < 125.0
    assert bone.joint[1] == pytest.approx(89.0, abs=2.0)
    assert bone.middles.ravel().tolist() == pytest.approx([90.0, 110.0, 144.0, 89.0], abs=1.0)


@pytest.mark.parametrize(
    ("change", "frame", "chosen"),
    [
        (lambda project: project, 6, {ARM}),
        (lambda project: project, 5, {BALL}),
        (lambda project: attached(project, [ARM], False), 5, {ARM}),
        (lambda project: linked(project, [TORSO, ARM]), 5, {ARM}),
        (lambda project: edit.set_properties(project, ARM, lifetime=(6, 20)), 5, {ARM}),
    ],
    ids=["no key here", "another object", "detached", "one whole", "not there"],
)
def test_nothing_hangs(change: object, frame: int, chosen: set[str]) -> None:
    assert callable(change)
    assert bones(change(drawn(BODY)), frame, chosen) == ()


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> list[Project]:
    """The projects whose places were looked for."""
    found: list[Project] = []
    monkeypatch.setattr(belonging, "places", lambda project: (found.append(project), places(project))[1])
    return found


def with_engine_key(shape: RotoShape, frame: int) -> RotoShape:
    return shape.with_key(replace(shape.keys[0], frame=frame, origin=Origin.ENGINE))


def test_a_tracked_frame_asks_for_nothing_again(document: Document, view_state: ViewState, asked: list) -> None:
    document.open(drawn(BODY), None)
    known = Belonging(document, view_state)
    assert str(known.places()[ARM]) == "Part of 2"
    document.apply("Track", document.project.with_shape(with_engine_key(document.project.shape(ARM), 6)))
    known.places()
    assert len(asked) == 1
    document.apply("Link", linked(document.project, [TORSO, ARM]))
    assert known.places()[ARM].link == "object-1"
    assert len(asked) == 2


def test_the_worker_finds_it_and_tells(qtbot: QtBot, document: Document, view_state: ViewState, runner: Runner) -> None:
    document.open(drawn(BODY), None)
    view_state.set_frame(5)
    known = Belonging(document, view_state, runner)
    assert (known.places(), known.bones()) == ({}, ())
    qtbot.waitUntil(lambda: bool(known.places()) and bool(known.bones()), timeout=WAIT)
    view_state.set_frame(6)
    assert known.bones() == ()
    document.open(Project(), None)
    assert known.places() == {}


def test_joints_follow_a_key_of_the_engine_on_the_same_frame(document: Document, view_state: ViewState) -> None:
    project = drawn(BODY)
    far = Keyframe(8, polygon_points(box(300, 80, 372, 98)), origin=Origin.ENGINE)
    keyed = project.with_shape(project.shape(TORSO).with_key(replace(project.shape(TORSO).keys[0], frame=8)))
    document.open(keyed, None)
    view_state.set_frame(8)
    known = Belonging(document, view_state)
    assert len(known.bones()) == 1
    document.apply("Track", keyed.with_shape(keyed.shape(ARM).with_key(far)))
    assert known.bones() == ()


def test_a_place_reads_as_a_few_words() -> None:
    assert str(Place(belonging.Kind.HOLE, host="arm")) == "Hole of arm"


def test_the_window_shows_joints_when_it_is_asked_to(qtbot: QtBot, tmp_path: Path) -> None:
    with opened_window(qtbot, write_clip(tmp_path / "shot"), tmp_path / "state") as window:
        project = window.document.project
        for corners in (box(20, 20, 60, 100), box(50, 40, 120, 52)):
            project, _ = edit.new_shape(project, polygon_points(corners), FIRST)
        window.document.apply("Draw", project)
        window.view_state.select(frozenset({ARM}))
        qtbot.waitUntil(lambda: window.properties.object_form.place.text() == "Part of 2", timeout=WAIT)
        switch = window.actions_by_id["view.joints"]
        switch.trigger()
        assert switch.isChecked()
        qtbot.waitUntil(lambda: len(window.belonging.bones()) == 1, timeout=WAIT)
        window.actions_by_id["object.detach"].trigger()
        qtbot.waitUntil(lambda: len(window.belonging.bones()) == 0, timeout=WAIT)
