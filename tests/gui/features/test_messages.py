"""The message log: every sentence once, as it was said, and no more of them than are worth keeping."""

from __future__ import annotations

from app.features.messages import MOST, MessageLog
from app.jobs.runner import Ending
from app.jobs.under_way import UnderWay
from app.model.view_state import ViewState


def test_the_message_log_keeps_ends_of_work_drops_repetitions_and_is_bounded(qapp: object) -> None:
    view_state, under_way = ViewState(), UnderWay()
    messages = MessageLog(view_state, under_way, clock=lambda: 0.0)
    under_way.ended.emit(Ending.DONE, "Saved a.roam.")
    view_state.say("Saved a.roam.")
    view_state.say("")
    assert [message.text for message in messages.all] == ["Saved a.roam."]
    for number in range(MOST + 5):
        view_state.say(f"Message {number}.")
    assert len(messages.all) == MOST
    assert messages.all[-1].text == f"Message {MOST + 4}."


def test_the_end_of_work_is_kept_as_it_is_said_with_the_keys_that_hold(qapp: object) -> None:
    view_state, under_way = ViewState(), UnderWay()
    view_state.set_keymap({"track.stop": ("Esc",)})
    messages = MessageLog(view_state, under_way)
    under_way.ended.connect(lambda _ending, sentence: view_state.say(sentence))  # as the status bar does
    under_way.ended.emit(Ending.DONE, "Press <track.stop> to stop.")
    assert [message.text for message in messages.all] == ["Press Esc to stop."]


def test_a_measure_that_changes_with_the_hand_is_no_message(qapp: object) -> None:
    view_state = ViewState()
    messages = MessageLog(view_state, UnderWay())
    for width in range(5):
        view_state.say(f"{width} × 9 pixels.", is_reading=True)
    view_state.say("Ellipse 1 is drawn.")
    assert [message.text for message in messages.all] == ["Ellipse 1 is drawn."]
