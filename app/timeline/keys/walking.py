"""Keys chosen by the keyboard: one after the other, or on from those that are chosen."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Generic, TypeGuard, TypeVar

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QKeyEvent

from ...actions.key_names import key_name
from ...model.view_state import ViewState
from ..chosen import ChosenPlaces

P = TypeVar("P", bound=tuple[object, ...])

CHOOSES = {Qt.Key.Key_Tab: 1, Qt.Key.Key_Backtab: -1}
EXTENDS = {"Ctrl+Shift+Right": 1, "Ctrl+Shift+Left": -1}
"""What chooses the next key or the one before it, and what takes it to those that are chosen."""


class KeyWalk(Generic[P]):
    """Goes from key to key, in the order of `places`, each of which names its frame last; the playhead goes along.

    `from_end_to_end`: behind the last one the first one comes, in place of nothing.
    """

    def __init__(
        self,
        view_state: ViewState,
        chosen: ChosenPlaces[P],
        places: Callable[[], Sequence[P]],
        *,
        from_end_to_end: bool = False,
    ) -> None:
        self._view, self._chosen, self._places, self._is_ring = view_state, chosen, places, from_end_to_end
        self._kept: frozenset[P] = frozenset()
        """What stays chosen while the walk is extended."""
        self._anchor: P | None = None
        self.at: P | None = None
        """The key to which it went last; it reaches there from the anchor."""
        self._left: frozenset[P] = frozenset()
        """What the walk left chosen: other keys begin another one."""

    def take(self, event: QKeyEvent) -> bool:
        """Whether a key of the keyboard went to another key; not behind the last one, nor where there is none."""
        if step := CHOOSES.get(Qt.Key(event.key()), 0):
            return self.choose(step)
        step = EXTENDS.get(key_name(event), 0)
        return bool(step) and self.extend(step)

    def choose(self, step: int) -> bool:
        """Choose the key after the chosen one, or before it; False where there is none."""
        places = self._places()
        held = self._held(places)
        if held and self._is_under_way(places):
            held = [places.index(self.at)]
        index = (held[-1 if step > 0 else 0] + step) if held else (0 if step > 0 else len(places) - 1)
        if places and self._is_ring:
            index %= len(places)
        if not 0 <= index < len(places):
            return False
        self._kept, self._anchor = frozenset(), places[index]
        self._reach(places, index)
        return True

    def extend(self, step: int) -> bool:
        """Take the next key, or the one before, to those that are chosen; on the way back they go. False at the end."""
        places = self._places()
        held = self._held(places)
        if not held:
            return self.choose(step)
        if not self._is_under_way(places):
            self._kept, self._anchor = self._chosen.places, places[held[-1 if step > 0 else 0]]
            self.at = self._anchor
        index = places.index(self.at) + step
        if not 0 <= index < len(places):
            return False
        self._reach(places, index)
        return True

    def _is_under_way(self, places: Sequence[P]) -> bool:
        """Whether what is chosen is what the walk left."""
        return self._left == self._chosen.places and self._anchor in places and self.at in places

    def _held(self, places: Sequence[P]) -> list[int]:
        return [index for index, place in enumerate(places) if place in self._chosen.places]

    def _reach(self, places: Sequence[P], index: int) -> None:
        """Choose what lies between the anchor and a place, and go there."""
        assert self._anchor is not None
        low, high = sorted((places.index(self._anchor), index))
        self.at, self._left = places[index], self._kept | frozenset(places[low : high + 1])
        self._chosen.select(self._left)
        frame = places[index][-1]
        assert isinstance(frame, int)
        self._view.set_frame(frame)


def is_key_press(event: QEvent) -> TypeGuard[QKeyEvent]:
    """Whether a key of the keyboard went down."""
    return isinstance(event, QKeyEvent) and event.type() == QEvent.Type.KeyPress


def is_of_walk(event: QEvent) -> bool:
    """Whether an event is a key of the keyboard that goes from key to key, which means another thing elsewhere."""
    return isinstance(event, QKeyEvent) and Qt.Key(event.key()) in CHOOSES
