"""What a tool expects is told while it is in the hand, and goes with it."""

from __future__ import annotations

import pytest

from app.actions.keymaps import told
from app.canvas.view import CanvasView
from app.model.view_state import ViewState
from app.tools.toolbox import TOOLS


@pytest.mark.parametrize(
    "name", [name for name, tool in TOOLS.items() if tool.hint and name not in ("select", "transform", "adjust")]
)
def test_a_hint_goes_with_its_tool(canvas: CanvasView, view_state: ViewState, name: str) -> None:
    view_state.set_tool(name)
    assert view_state.message == told(TOOLS[name].hint, view_state.keymap)
    view_state.set_tool("select")
    assert view_state.message == TOOLS["select"].hint != ""


def test_what_the_transform_box_lacks_goes_with_it(canvas: CanvasView, view_state: ViewState) -> None:
    view_state.set_tool("transform")
    assert view_state.message.startswith("Select a shape or points to transform")
    view_state.set_tool("select")
    assert view_state.message == TOOLS["select"].hint


def test_what_the_adjust_tool_lacks_goes_with_it(canvas: CanvasView, view_state: ViewState) -> None:
    view_state.set_tool("adjust")
    assert view_state.message.startswith("Select a shape whose plane is tracked")
    view_state.set_tool("select")
    assert view_state.message == TOOLS["select"].hint


def test_another_message_stays_when_the_tool_goes(canvas: CanvasView, view_state: ViewState) -> None:
    view_state.set_tool("polygon")
    view_state.say("Saved a.roam.")
    view_state.set_tool("select")
    assert view_state.message == "Saved a.roam."
    view_state.set_tool("polygon")
    assert view_state.message == TOOLS["polygon"].hint
