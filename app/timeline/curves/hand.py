"""CurveHand: the gestures over the curves: keys dragged in time and value, tangents turned, boxes drawn around keys."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QMouseEvent

from roam_core.roto import Animated, Project
from roam_core.roto.animated import Slopes
from roam_core.roto.value_curves import ValuePlace, set_slopes, values_of_item
from roam_core.roto.value_keys import keyed, with_value

from ...model.document import Document
from ...translation import tr
from ..axis import TimeAxis
from ..scale import LABEL_WIDTH
from ..values.drag import KeyDrag
from ..values.selection import ValueSelection
from ..values.shown import SHOWN_AS, Kind
from ..values.verbs import LOCKED, ValueVerbs, unlocked

STILL = 3
"""Pixels that the pointer may move between press and release of a click."""
SHIFT, CTRL = Qt.KeyboardModifier.ShiftModifier, Qt.KeyboardModifier.ControlModifier
COPIES = Qt.KeyboardModifier.AltModifier
INSERTS = CTRL | COPIES
"""With these a click on a curve sets a key there."""


@dataclass(frozen=True)
class Handle:
    """An end of a tangent: the key that it belongs to, and on which of its sides it lies."""

    place: ValuePlace
    is_leaving: bool


@dataclass(frozen=True)
class Found:
    """What lies under the pointer: a handle, a key, or the curve of an item; nothing of these over empty ground."""

    handle: Handle | None = None
    key: ValuePlace | None = None
    curve: tuple[str, Kind] | None = None


class CurveHand:
    """One gesture at a time. A drag previews; its release is one undo step.

    `found_at` tells what lies under a place, `keys_in` which keys in a box, `value_at` the value shown at a height;
    `show` repaints.
    """

    def __init__(
        self,
        document: Document,
        axis: TimeAxis,
        chosen: ValueSelection,
        verbs: ValueVerbs,
        found_at: Callable[[QPointF], Found],
        keys_in: Callable[[QRectF], frozenset[ValuePlace]],
        value_at: Callable[[float], float],
        show: Callable[[], None],
    ) -> None:
        self._document, self._axis, self._chosen, self._verbs = document, axis, chosen, verbs
        self._found_at, self._keys_in, self._value_at, self._show = found_at, keys_in, value_at, show
        self._start: QPointF | None = None
        self._start_time = 0.0
        self._found = Found()
        self._before: frozenset[ValuePlace] = frozenset()
        self._is_drag = False
        self._drag: KeyDrag | None = None
        self.box: QRectF | None = None
        """The box that is being drawn, or None."""

    @property
    def is_busy(self) -> bool:
        """True between press and release."""
        return self._start is not None

    @property
    def shift(self) -> int:
        """By how many frames the chosen keys are shown away from where they lie."""
        return 0 if self._drag is None else self._drag.frames

    def press(self, event: QMouseEvent) -> None:
        """Take hold of what lies under the pointer; with Ctrl and Alt set a key on the curve there."""
        at = event.position()
        self._start, self._before, self._is_drag = at, self._chosen.places, False
        self._start_time, self._found = self._axis.scale.time(at.x()), self._found_at(at)
        if self._found.handle is None and self._found.key is None and event.modifiers() & INSERTS == INSERTS:
            self._insert(at)
        elif self._found.key is not None and self._found.key not in self._before:
            adds = bool(event.modifiers() & (SHIFT | CTRL))
            self._chosen.select((self._before if adds else frozenset()) | {self._found.key})

    def move(self, event: QMouseEvent) -> None:
        """Drag what is held, or draw the box on; nothing while the pointer has hardly moved."""
        if self._start is None:
            return
        self._is_drag = self._is_drag or (event.position() - self._start).manhattanLength() > STILL
        if not self._is_drag:
            return
        if self._found.handle is not None:
            self._axis.view_state.set_preview(self._turned(self._found.handle, event))
        elif self._found.key is not None:
            self._drag_keys(event)
        else:
            self._draw_box(event)
        self._show()

    def release(self, event: QMouseEvent) -> None:
        """Do what was previewed, once; a mere click goes to the frame of its key, or to the one under it."""
        if self._start is None:
            return
        if not self._is_drag:
            self._click(event)
        elif self._drag is not None:
            self._drag.finish()
        elif self._found.handle is not None and self._axis.view_state.preview is not None:
            turned = self._turned(self._found.handle, event)
            self._axis.view_state.set_preview(None)
            if turned is not None:
                self._document.apply(tr("Turn tangent"), turned)
        self._forget()

    def cancel(self) -> None:
        """Let go and leave everything as it was before the press."""
        if self._start is not None:
            self._chosen.restore(self._before)
            self._forget()

    # ---- the rest is private

    def _drag_keys(self, event: QMouseEvent) -> None:
        """Keys, with Alt copies of them, go with the pointer; with Shift only where it went farther."""
        assert self._start is not None
        if self._drag is None:
            self._drag = KeyDrag(self._document, self._axis, self._chosen, self._verbs)
        assert self._found.key is not None
        factor, away = SHOWN_AS[Kind(self._found.key[1])][0], event.position() - self._start
        self._axis.bring_in(event.position().x() + LABEL_WIDTH)
        frames = round(self._axis.scale.time(event.position().x()) - self._start_time)
        amount = (self._value_at(event.position().y()) - self._value_at(self._start.y())) / factor
        if event.modifiers() & SHIFT:
            frames, amount = (frames, 0.0) if abs(away.x()) > abs(away.y()) else (0, amount)
        copies = bool(event.modifiers() & COPIES)
        self._drag.to(frames, amount if abs(away.y()) > STILL else 0.0, copies=copies)

    def _turned(self, handle: Handle, event: QMouseEvent) -> Project | None:
        """The project with a tangent turned; None where it is there no more.

        It follows the pointer, the other side with it; with Ctrl, and once they differ, alone. With Shift both sides
        become one again.
        """
        project, (item_id, name, frame) = self._document.project, handle.place
        if not unlocked(project, [handle.place]):
            self._axis.view_state.say(tr(LOCKED))
            return None
        value = values_of_item(project.find(item_id))[name]
        key = value.key_at(frame) if isinstance(value, Animated) else None
        if key is None or key.slopes is None or not isinstance(value, Animated):
            return None
        index = value.keys.index(key) + (1 if handle.is_leaving else -1)
        if not 0 <= index < len(value.keys):
            return None
        beside = value.keys[index]
        reach = (beside.frame - frame) / 3.0
        seen = self._value_at(event.position().y()) / SHOWN_AS[Kind(name)][0]
        slope = (seen - key.value) / reach
        arriving, leaving = key.slopes
        is_alone = (arriving != leaving or event.modifiers() & CTRL) and not event.modifiers() & SHIFT
        slopes: Slopes = (slope, slope)
        if is_alone:
            slopes = (arriving, slope) if handle.is_leaving else (slope, leaving)
        return set_slopes(project, handle.place, slopes)

    def _draw_box(self, event: QMouseEvent) -> None:
        assert self._start is not None
        self.box = QRectF(self._start, event.position()).normalized()
        found, modifiers = self._keys_in(self.box), event.modifiers()
        if modifiers & CTRL:
            found = self._before - found
        elif modifiers & SHIFT:
            found = self._before | found
        self._chosen.select(found)

    def _click(self, event: QMouseEvent) -> None:
        adds = event.modifiers() & (SHIFT | CTRL)
        if self._found.key is None:
            if self._found.handle is None and not adds:
                self._chosen.clear()
                self._axis.scrub(self._axis.scale.left + event.position().x())
        elif not adds:
            self._chosen.select(frozenset({self._found.key}))
            self._axis.view_state.set_frame(self._found.key[2])
        elif self._found.key in self._before:
            self._chosen.select(self._before - {self._found.key})

    def _insert(self, at: QPointF) -> None:
        """A key of a value on the frame under the pointer, where the value is what it is there."""
        if self._found.curve is None or self._found.curve[1] not in (Kind.OPACITY, Kind.FEATHER):
            self._axis.view_state.say(tr("Point at a curve of opacity or feather to set a key on it."))
            return
        item_id, kind = self._found.curve
        frame = self._axis.scale.frame(at.x() + self._axis.scale.left)
        place, project = (item_id, kind.value, frame), self._document.project
        if not unlocked(project, [place]):
            self._axis.view_state.say(tr(LOCKED))
            return
        after = project.map_item(item_id, lambda item: with_value(item, kind.value, lambda value: keyed(value, frame)))
        self._document.apply(tr("Set key"), after)
        self._chosen.select(frozenset({place}))
        self._found = Found(key=place)

    def _forget(self) -> None:
        self._axis.view_state.set_preview(None)
        self._start = self._drag = self.box = None
        self._is_drag = False
        self._show()
