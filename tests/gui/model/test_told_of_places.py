"""What is told of a place goes when the artist leaves it, and not before."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from app.model.view_state import ViewState

HINT = "Click an outline."
PLACE, SHAPES = "Frame 4: the confidence of Hat is .2.", frozenset({"hat"})


@pytest.fixture
def view(view_state: ViewState) -> ViewState:
    """On frame 4, with a shape selected."""
    view_state.say_hint(HINT)
    view_state.set_play_range(1, 10)
    view_state.set_frame(4)
    view_state.select(SHAPES)
    return view_state


@pytest.mark.parametrize(
    "leave",
    [
        lambda view: view.set_frame(5),
        lambda view: view.select(frozenset({"coat"})),
        lambda view: view.select(SHAPES, layers=frozenset({"body"})),
        lambda view: view.set_play_range(1, 5),
    ],
)
def test_it_goes_with_the_frame_the_selection_or_in_and_out(
    view: ViewState, leave: Callable[[ViewState], None]
) -> None:
    view.say("Saved a.roam.")
    leave(view)
    assert view.message == "Saved a.roam."
    view.set_frame(4)
    view.select(SHAPES, layers=frozenset())
    view.set_play_range(1, 10)
    view.say_here(PLACE)
    leave(view)
    assert view.message == HINT


def test_it_stays_while_a_run_takes_the_playhead_along(view: ViewState) -> None:
    view.say_here(PLACE)
    view.set_frame(4)
    view.select(SHAPES, frozenset({("hat", 1)}))
    view.set_frame(5, is_of_run=True)
    assert view.message == PLACE


def test_what_is_said_on_the_way_there_stays(view: ViewState) -> None:
    """As that there is no picture of the frame."""
    view.say_here(PLACE)
    view.frame_changed.connect(lambda: view.say("The frame cannot be read."))
    view.set_frame(5)
    assert view.message == "The frame cannot be read."


def test_a_sentence_names_the_keys_that_hold_now(view_state: ViewState) -> None:
    """Where keys were set anew, the hint of the tool in the hand went on telling the old ones."""
    told = []
    view_state.message_changed.connect(lambda: told.append(view_state.message))
    view_state.say_hint("Press <tool.bezier> to draw.")
    view_state.set_keymap({**view_state.keymap, "tool.bezier": ("Ctrl+9",)})
    assert told == ["Press B to draw.", "Press Ctrl+9 to draw."]
    view_state.say("Hat is locked.")
    view_state.say_hint("", is_shy=True)
    view_state.set_keymap({**view_state.keymap, "tool.bezier": ("Ctrl+8",)})
    assert told[2:] == ["Hat is locked."]
