"""ActionSpec: what an action of the window is called, where its keys work and what it shows."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum

from ..translation import tr


class Reach(StrEnum):
    """Where an action's keys work: transport and files in the whole window, edits in the viewer only."""

    WINDOW = "window"
    VIEWER = "viewer"


@dataclass(frozen=True)
class ActionSpec:
    """What an action is called and where its keys work; `tip` is a sentence for the tooltip, if the title needs one."""

    id: str
    title: str
    reach: Reach = Reach.WINDOW
    icon: str = ""
    tip: str = ""
    checkable: bool = False

    @property
    def label(self) -> str:
        """The title in the window's language, with dots where a question follows."""
        return tr(self.title)

    @property
    def name(self) -> str:
        """The title in the window's language, as sentences name it."""
        return self.label.rstrip("…")

    @property
    def sentence(self) -> str:
        """What it does, in the window's language."""
        return tr(self.tip) if self.tip else self.name
