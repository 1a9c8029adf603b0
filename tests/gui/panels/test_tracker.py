"""The tracker panel and the track verbs: which frames a key means, what is said when nothing can be tracked."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget
from pytestqt.qtbot import QtBot

from app.actions.actions import Actions
from app.actions.keymaps import load_keymap
from app.features.tracking import NO_CLIP, Tracking
from app.model.document import Document
from app.model.view_state import ViewState
from app.panels.tracker import WORDS, TrackerPanel
from roam_core.dials import dials_of
from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG
from roam_core.roto import Clip, Keyframe, LayerTransform, Origin, Project, edit
from roam_core.roto.layers import grouped

SQUARE = polygon_points([(0, 0), (10, 0), (10, 10), (0, 10)])
CLIP = Clip(Path("shot"), 1001, 1048, (64, 48))


class Propagation:
    """Notes what it is asked to track."""

    def __init__(self) -> None:
        self.asked: list[tuple[list[str], range, str]] = []
        self.filled: list[list[tuple[int, int]]] = []
        self.alone: list[bool] = []

    def start(self, shape_ids: Sequence[str], frames: range, config: str, *, alone: bool) -> None:
        self.asked.append((list(shape_ids), frames, config))
        self.alone.append(alone)

    def fill(self, shape_ids: Sequence[str], gaps: Sequence[tuple[int, int]], config: str, *, alone: bool) -> None:
        self.filled.append(list(gaps))
        self.alone.append(alone)


@pytest.fixture
def propagation() -> Propagation:
    return Propagation()


@pytest.fixture
def tracking(document: Document, view_state: ViewState, propagation: Propagation) -> Tracking:
    """A square with artist keys at 1001 and 1020, engine keys between, of which 1005 and 1010 are doubtful."""
    project, shape = edit.new_shape(Project(CLIP), SQUARE, 1001)
    doubts = {1005: 0.3, 1010: 0.2}
    keys = [Keyframe(f, SQUARE, origin=Origin.ENGINE, confidence=doubts.get(f, 0.9)) for f in range(1002, 1020)]
    project = project.with_shape(edit.set_engine_keys(edit.key_here(shape, 1020), keys))
    document.open(project, None)
    view_state.set_play_range(1001, 1049)
    view_state.set_frame(1010)
    return Tracking(document, view_state, propagation)  # type: ignore[arg-type]


@pytest.mark.parametrize(
    ("verb", "frames"),
    [
        ("forward", range(1010, 1049)),
        ("backward", range(1010, 1000, -1)),
        ("forward_one", range(1010, 1012)),
        ("backward_one", range(1010, 1008, -1)),
        ("to_next_key", range(1010, 1020)),
    ],
)
def test_a_verb_means_these_frames(tracking: Tracking, propagation: Propagation, verb: str, frames: range) -> None:
    getattr(tracking, verb)()
    assert propagation.asked == [(["shape-1"], frames, DEFAULT_CONFIG)]


@pytest.mark.parametrize(
    ("frame", "verb", "frames"),
    [
        (1011, "forward", range(1009, 1049)),
        (1010, "backward", range(1012, 1000, -1)),
        (1010, "forward_one", range(1009, 1012)),
        (1048, "backward", range(1048, 1000, -1)),
        (1009, "forward", range(1009, 1049)),
    ],
)
def test_in_a_gap_of_the_plate_a_run_begins_where_the_gap_does(
    document: Document, view_state: ViewState, tracking: Tracking, propagation: Propagation,
    frame: int, verb: str, frames: range,
) -> None:  # fmt: skip
    """There a run stops, or one frame after the other is tracked: it goes on from what it found last."""
    gappy = Tracking(document, view_state, propagation, lambda: (1010, 1011, 1047, 1048))  # type: ignore[arg-type]
    document.apply("Key", document.project.with_shape(edit.key_here(document.project.shape("shape-1"), 1048)))
    view_state.set_frame(frame)
    getattr(gappy, verb)()
    assert propagation.asked == [(["shape-1"], frames, DEFAULT_CONFIG)]


def test_a_key_that_lies_in_a_gap_of_the_plate_is_told_so(
    document: Document, view_state: ViewState, tracking: Tracking, propagation: Propagation
) -> None:
    gappy = Tracking(document, view_state, propagation, lambda: (1009, 1010))  # type: ignore[arg-type]
    project, _ = edit.new_shape(Project(CLIP), SQUARE, 1010)
    document.open(project, None)
    view_state.set_frame(1010)
    gappy.forward()
    assert propagation.asked == []
    assert view_state.message.startswith("Shape 1 is not tracked: the plate has no picture of frame 1010")


def test_between_keys_beyond_its_lifetime_a_shape_is_said_not_to_exist(
    document: Document, view_state: ViewState, tracking: Tracking
) -> None:
    """To set keys was asked for, where there were some."""
    document.apply("Lifetime", edit.set_properties(document.project, "shape-1", lifetime=(1001, 1003)))
    project = document.project.with_shape(edit.key_here(document.project.shape("shape-1"), 1006))
    document.apply("Key", project)
    view_state.set_frame(1010)
    tracking.fill()
    assert view_state.message == "'Shape 1' does not exist on frame 1010: its lifetime is in the Shape panel."


def test_in_and_out_bound_a_run_that_begins_between_them(
    tracking: Tracking, propagation: Propagation, view_state: ViewState
) -> None:
    view_state.set_play_range(1005, 1015)
    tracking.forward()
    tracking.backward()
    view_state.set_frame(1030)
    tracking.forward()
    assert [frames for _, frames, _ in propagation.asked] == [
        range(1010, 1015),
        range(1010, 1004, -1),
        range(1030, 1049),
    ]


@pytest.mark.parametrize(
    ("lifetime", "frame", "verb", "frames"),
    [
        ((1003, 1015), 1010, "forward", range(1010, 1015)),
        ((1003, 1015), 1010, "backward", range(1010, 1002, -1)),
        ((1012, 1015), 1010, "forward", range(1010, 1015)),
        ((1003, 1015), 1014, "forward", None),
        ((1003, 1015), 1014, "forward_one", None),
        ((1003, 1015), 1030, "forward", None),
        ((1003, 1015), 1003, "backward", None),
    ],
)
def test_a_run_ends_with_the_lifetimes_of_its_shapes(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState,
    lifetime: tuple[int, int], frame: int, verb: str, frames: range | None,
) -> None:  # fmt: skip
    document.apply("Lifetime", edit.set_properties(document.project, "shape-1", lifetime=lifetime))
    view_state.set_frame(frame)
    getattr(tracking, verb)()
    assert [asked for _, asked, _ in propagation.asked] == ([] if frames is None else [frames])
    beyond = frame - 1 if verb == "backward" else frame + 1
    told = f"'Shape 1' does not exist on frame {beyond}: its lifetime is in the Shape panel."
    assert (view_state.message == told) is (frames is None)


@pytest.mark.parametrize(("frame", "frames"), [(1010, range(1010, 1015)), (1014, None), (1020, None)])
def test_a_shape_that_is_left_out_makes_no_run_longer_than_those_that_it_takes(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState,
    frame: int, frames: range | None,
) -> None:  # fmt: skip
    """Behind the lifetimes of its shapes it made no keys, and told of frames to the end of the clip."""
    project = edit.set_properties(document.project, "shape-1", lifetime=(1003, 1015))
    document.apply("Hat", edit.new_shape(project, SQUARE, 1030, name="Hat")[0])
    view_state.set_frame(frame)
    tracking.forward()
    assert [asked for _, asked, _ in propagation.asked] == ([] if frames is None else [frames])
    assert view_state.message.startswith("Hat is not tracked: its first key lies on frame 1030.")


@pytest.mark.parametrize(
    ("frame", "verb", "told"),
    [
        (1004, "forward", "Hat is not tracked: its first key lies on frame 1015."),
        (1004, "to_next_key", "Hat is not tracked: its first key lies on frame 1015."),
        (1030, "backward", "Hat is not tracked: its last key lies on frame 1015."),
        (1015, "forward", ""),
        (1015, "backward", ""),
        (1030, "forward", ""),
        (1004, "backward", ""),
    ],
)
def test_a_run_begins_with_no_copy_of_a_key_that_lies_ahead(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState,
    frame: int, verb: str, told: str,
) -> None:  # fmt: skip
    """There the shape stands still, wherever the object is: keys were tracked from what lies beside it."""
    document.apply("Hat", edit.new_shape(document.project, SQUARE, 1015, name="Hat")[0])
    view_state.set_frame(frame)
    view_state.select(frozenset({"shape-2"}))
    getattr(tracking, verb)()
    assert [ids for ids, *_ in propagation.asked] == ([] if told else [["shape-2"]])
    assert view_state.message.startswith(told)


def test_shapes_that_a_run_cannot_begin_with_are_left_out_and_said(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState
) -> None:
    project, _ = edit.new_shape(document.project, SQUARE, 1015)
    document.apply("Draw", project)
    tracking.forward()
    assert [ids for ids, *_ in propagation.asked] == [["shape-1"]]
    assert view_state.message == (
        "Shape 2 is not tracked: its first key lies on frame 1015. Track from there, or set a key here (S)."
    )
    document.apply("Draw", edit.new_shape(project, SQUARE, 1016)[0])
    tracking.forward()
    assert view_state.message == (
        "2 shapes not tracked: their first keys lie ahead. Track from there, or set keys here (S)."
    )


def test_the_first_key_of_a_shape_that_is_not_tracked_is_no_next_key(
    tracking: Tracking, propagation: Propagation, document: Document
) -> None:
    document.apply("Draw", edit.new_shape(document.project, SQUARE, 1015)[0])
    tracking.to_next_key()
    assert propagation.asked == [(["shape-1"], range(1010, 1020), DEFAULT_CONFIG)]


def test_before_a_key_there_is_nothing_to_track_up_to_it(
    tracking: Tracking, propagation: Propagation, view_state: ViewState
) -> None:
    view_state.set_frame(1019)
    tracking.to_next_key()
    assert propagation.asked == []
    assert view_state.message == "The next frame is a key already: there is nothing to track before it."


@pytest.mark.parametrize("way", ["locked", "open", "beside the clip"])
def test_keys_of_shapes_that_are_not_tracked_or_beside_the_clip_are_no_next_key(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState, way: str
) -> None:
    frame = {"locked": 1011, "open": 1012, "beside the clip": 1090}[way]
    view_state.set_frame(1010 if way != "beside the clip" else 1020)
    project, _ = edit.new_shape(document.project, SQUARE, frame, name="Hat")
    document.apply("Hat", edit.set_properties(project, "shape-2", locked=way == "locked", closed=way != "open"))
    tracking.to_next_key()
    ((_, frames, _),) = propagation.asked
    assert frames == (range(1010, 1020) if way != "beside the clip" else range(1020, 1049))


@pytest.mark.parametrize(
    ("frame", "play_range", "gaps"),
    [
        (1010, (1001, 1049), [(1001, 1020)]),  # in a gap
        (1020, (1001, 1049), [(1020, 1030)]),  # on a key: the gap after it
        (1030, (1001, 1049), [(1020, 1030)]),  # on the last key: the gap before it
        (1010, (1001, 1031), [(1001, 1020), (1020, 1030)]),  # in and out around the playhead
        (1025, (1001, 1021), [(1020, 1030)]),  # in and out elsewhere
    ],
)
def test_fill_means_these_gaps(
    tracking: Tracking,
    propagation: Propagation,
    document: Document,
    view_state: ViewState,
    frame: int,
    play_range: tuple[int, int],
    gaps: list[tuple[int, int]],
) -> None:
    shape = document.project.shape("shape-1")
    document.apply("Key", document.project.with_shape(edit.key_here(shape, 1030)))
    view_state.set_play_range(*play_range)
    view_state.set_frame(frame)
    tracking.fill()
    assert propagation.filled == [gaps]


def test_where_there_is_no_gap_it_is_said(tracking: Tracking, propagation: Propagation, view_state: ViewState) -> None:
    view_state.set_frame(1040)
    tracking.fill()
    assert propagation.filled == []
    assert view_state.message.startswith("There is no gap to fill here: set a key (S)")


def test_at_the_clips_end_there_is_nothing_to_track(
    tracking: Tracking, propagation: Propagation, view_state: ViewState
) -> None:
    view_state.set_frame(1048)
    tracking.forward()
    tracking.forward_one()
    assert propagation.asked == []
    assert view_state.message == "The clip ends here: there is no frame to track to."


def test_at_in_and_out_nothing_is_tracked_beyond_them(
    tracking: Tracking, propagation: Propagation, view_state: ViewState
) -> None:
    """A run leaves the playhead on the out point: the same key once more went on to the end of the clip."""
    view_state.set_play_range(1005, 1011)
    for verb, frame, word in ((tracking.forward, 1010, "The out point is here"), (tracking.backward, 1005, "The in")):
        view_state.set_frame(frame)
        verb()
        assert view_state.message.startswith(word)
    assert propagation.asked == []
    view_state.set_frame(1020)
    tracking.forward()
    assert propagation.asked == [(["shape-1"], range(1020, 1049), DEFAULT_CONFIG)]


def test_that_a_gap_reaches_beyond_in_and_out_is_said(
    tracking: Tracking, propagation: Propagation, view_state: ViewState
) -> None:
    view_state.set_play_range(1005, 1011)
    view_state.set_frame(1008)
    tracking.fill()
    assert propagation.filled == []
    assert view_state.message.startswith("No gap lies wholly between in and out")


def test_what_cannot_be_tracked_is_said(
    tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState
) -> None:
    for values, word in (({"locked": True}, "locked"), ({"locked": False, "closed": False}, "open")):
        document.apply("Change", edit.set_properties(document.project, "shape-1", **values))
        tracking.forward()
        assert word in view_state.message
    project, _ = edit.new_shape(Project(CLIP), np.zeros((1, 3, 2)), 1001, name="Tip")
    document.open(project, None)
    for verb in (tracking.forward, tracking.fill):
        view_state.say("")
        verb()
        assert view_state.message == "Tip is a single point; draw an outline around the object to track it."
    document.open(Project(CLIP), None)
    tracking.forward()
    assert view_state.message == "Draw a shape first: press B in the viewer."
    document.open(Project(), None)
    tracking.forward()
    assert view_state.message == NO_CLIP
    assert propagation.asked == []


def test_n_goes_from_one_doubt_to_the_next(tracking: Tracking, view_state: ViewState) -> None:
    view_state.set_frame(1001)
    visited = []
    for step in (tracking.next_doubtful, tracking.next_doubtful, tracking.next_doubtful, tracking.previous_doubtful):
        step()
        visited.append((view_state.frame, view_state.message))
    assert visited == [
        (1005, "Frame 1005: the confidence of Shape 1 is 0.30."),
        (1010, "Frame 1010: the confidence of Shape 1 is 0.20."),
        (1010, "No doubtful frame after frame 1010."),
        (1005, "Frame 1005: the confidence of Shape 1 is 0.30."),
    ]


def test_the_worst_frame_may_be_one_of_a_planar_track(
    tracking: Tracking, document: Document, view_state: ViewState
) -> None:
    tracking.most_doubtful()
    assert view_state.frame == 1010
    project, layer = grouped(document.project, ["shape-1"], "Planar 1")
    moves = replace(LayerTransform.of({1001: np.eye(3), 1007: np.eye(3)}), confidence=((1007, 0.1),))
    document.apply("Track", edit.set_properties(project, layer.id, transform=moves))
    tracking.most_doubtful()
    assert view_state.frame == 1007
    assert view_state.message == "Frame 1007: the confidence of the track Planar 1 is 0.10."


def test_n_looks_at_the_selected_shapes_and_tells_the_least_sure_one(
    tracking: Tracking, document: Document, view_state: ViewState
) -> None:
    project, arm = edit.new_shape(document.project, SQUARE, 1001, name="Arm")
    doubts = {1005: 0.1, 1008: 0.4}
    keys = [Keyframe(frame, SQUARE, origin=Origin.ENGINE, confidence=value) for frame, value in doubts.items()]
    document.apply("Arm", project.with_shape(edit.set_engine_keys(arm, keys)))
    view_state.set_frame(1001)
    tracking.next_doubtful()
    assert view_state.message == "Frame 1005: the confidence of Arm is 0.10."
    view_state.select(frozenset({"shape-1"}))
    tracking.next_doubtful()
    assert view_state.frame == 1010


def test_no_doubt_is_told_of_frames_on_which_a_shape_does_not_exist(
    tracking: Tracking, document: Document, view_state: ViewState
) -> None:
    document.apply("Lifetime", edit.set_properties(document.project, "shape-1", lifetime=(1001, 1008)))
    view_state.set_frame(1006)
    tracking.next_doubtful()
    assert (view_state.frame, view_state.message) == (1006, "No doubtful frame after frame 1006.")
    tracking.most_doubtful()
    assert view_state.frame == 1005


def test_the_most_doubtful_frame_is_the_one_that_is_trusted_least(
    tracking: Tracking, document: Document, view_state: ViewState
) -> None:
    view_state.set_frame(1001)
    tracking.most_doubtful()
    assert view_state.frame == 1010
    assert view_state.message == "Frame 1010: the confidence of Shape 1 is 0.20."
    document.open(Project(CLIP), None)
    tracking.most_doubtful()
    assert view_state.message == "No frame is tracked yet."


@pytest.fixture
def panel(qtbot: QtBot, tracking: Tracking, document: Document, view_state: ViewState) -> Iterator[TrackerPanel]:
    window = QWidget()
    qtbot.addWidget(window)
    panel = TrackerPanel(document, view_state, tracking, Actions(window, window, load_keymap()), window)
    yield panel
    window.close()  # it holds the panel up to here


def test_the_panel_says_what_is_out_of_sight(panel: TrackerPanel, document: Document, view_state: ViewState) -> None:
    view_state.set_frame(1010)
    shape = document.project.shapes[0]
    shut = Keyframe(1010, 1e-4 * SQUARE, origin=Origin.ENGINE, confidence=0.0)
    document.apply("Track", document.project.with_shape(edit.set_engine_keys(shape, [shut])))
    assert panel._confidence.text() == "0.00  out of sight"
    assert panel._confidence.toolTip().startswith("Nothing of it was found")


def test_the_panel_shows_the_confidence_and_sets_the_mode(
    panel: TrackerPanel, tracking: Tracking, view_state: ViewState
) -> None:
    shown = []
    for frame in (1001, 1002, 1005):
        view_state.set_frame(frame)
        shown.append(panel._confidence.text())
    assert shown == ["–", "0.90", "0.30  doubtful"]
    assert [panel.mode.itemData(row) for row in range(panel.mode.count())] == list(CONFIGS)
    panel.mode.setCurrentIndex(panel.mode.count() - 1)
    assert tracking.config == list(CONFIGS)[-1]


def test_every_mode_says_what_it_is_good_for(panel: TrackerPanel) -> None:
    assert set(WORDS) == set(CONFIGS)
    for row in range(panel.mode.count()):
        panel.mode.setCurrentIndex(row)
        assert panel.words.text() == WORDS[panel.mode.currentData()]


def test_all_shapes_are_tracked_where_that_is_chosen(
    panel: TrackerPanel, tracking: Tracking, propagation: Propagation, document: Document, view_state: ViewState
) -> None:
    document.apply("Add", edit.new_shape(document.project, SQUARE, 1001)[0])
    view_state.select(frozenset({"shape-2"}))
    asked = []
    for row in range(panel.scope.count()):
        panel.scope.setCurrentIndex(row)
        tracking.forward()
        asked.append(propagation.asked[-1][0])
        tracking.fill()
        assert panel.scope.toolTip() == ("Now: Shape 2", "Now: Shape 2", "Now: Shape 1, Shape 2")[row]
    assert asked == [["shape-2"], ["shape-2"], ["shape-1", "shape-2"]]
    assert propagation.alone == [False, True, False, False]  # filling has no gap but that of the first shape


def test_dials_are_turned_for_the_run_and_turned_back(
    qtbot: QtBot, panel: TrackerPanel, tracking: Tracking, propagation: Propagation
) -> None:
    dials, left = panel.dials, Qt.MouseButton.LeftButton
    panel.mode.setCurrentIndex(panel.mode.findData("best"))
    assert not dials.is_unfolded
    qtbot.mouseClick(dials.arrow, left)
    assert dials.is_unfolded
    field = dials.fields["reach"]
    qtbot.keyClick(field, Qt.Key.Key_Up)
    qtbot.keyClick(dials.fields["key"], Qt.Key.Key_Down)
    tracking.forward()
    assert propagation.asked[-1][2] == "best+reach=1.1+key=0.9"
    assert dials.arrow.text() == "Fine tuning, changed"
    qtbot.mouseClick(dials.reset, left)
    tracking.forward()
    assert propagation.asked[-1][2] == "best"
    assert field.value() == 100
    assert not dials.reset.isEnabled()


def test_only_dials_that_turn_something_are_offered_and_each_mode_has_its_own(
    qtbot: QtBot, panel: TrackerPanel, tracking: Tracking
) -> None:
    panel.dials.unfold(True)
    tracking.turn("reach", 2.0)
    panel.mode.setCurrentIndex(panel.mode.findData("baseline"))
    seen = {name for name, field in panel.dials.fields.items() if field.isVisibleTo(panel)}
    assert seen == {dial.name for dial in dials_of(CONFIGS["baseline"])}
    assert tracking.configuration == "baseline"
    panel.mode.setCurrentIndex(panel.mode.findData(DEFAULT_CONFIG))
    assert tracking.configuration == f"{DEFAULT_CONFIG}+reach=2"


def test_turned_dials_are_kept_and_nonsense_is_left_out_in_one_sentence(
    tracking: Tracking, view_state: ViewState
) -> None:
    tracking.turn("reach", 1.5)
    tracking.turn("key", 1.0)
    assert tracking.remembered() == {DEFAULT_CONFIG: {"reach": "1.5"}}
    tracking.reset()
    tracking.recall(
        {DEFAULT_CONFIG: {"reach": "1.5", "speed": "2", "key": "many", "firmness": "2"}, "abacus": {"reach": "2"}}
    )
    assert tracking.factors == {DEFAULT_CONFIG: {"reach": 1.5}}
    told = (f"{DEFAULT_CONFIG}+{word}" for word in ("speed=2", "key=many", "firmness=2"))
    assert view_state.message.endswith(f"stay at 100 %: {', '.join(told)}, abacus+reach=2.")


def test_the_list_of_shapes_tells_what_a_run_leaves_out(
    panel: TrackerPanel, document: Document, view_state: ViewState
) -> None:
    document.apply("Add", edit.new_shape(document.project, SQUARE, 1001)[0])
    view_state.select(frozenset())
    document.apply("Lock", edit.set_properties(document.project, "shape-1", locked=True))
    said = "Left out, for they are locked or no closed outlines: "
    assert panel.scope.toolTip() == f"Now: Shape 2\n{said}Shape 1"
    document.apply("Open", edit.set_properties(document.project, "shape-2", closed=False))
    assert panel.scope.toolTip() == f"{said}Shape 1, Shape 2"
