"""KeyHand: the gestures over the key rows: keys dragged or copied along time, boxes drawn around keys."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QMouseEvent

from roam_core.roto import Project, timing
from roam_core.roto.timing import Place

from ...model.document import Document
from ...translation import N_, tr
from ..axis import TimeAxis
from ..scale import LABEL_WIDTH
from .selection import KeySelection
from .verbs import count_of, unlocked

MOVING = N_("Move {keys} {frames}: {first} to {last}.")
COPYING = N_("Copy {keys} {frames}: {first} to {last}.")

STILL = 3
"""Pixels that the pointer may move between press and release of a click."""

ADDS = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier
COPIES = Qt.KeyboardModifier.AltModifier

KeyAt = Callable[[QPointF], Place | None]
KeysIn = Callable[[QRectF], frozenset[Place]]


class KeyHand:
    """One gesture at a time: a key is held, or a box is drawn. A drag previews; its release is one undo step.

    `key_at` and `keys_in` tell which keys lie under a point or inside a box of the rows; `show` repaints them.
    """

    def __init__(
        self,
        document: Document,
        axis: TimeAxis,
        keys: KeySelection,
        key_at: KeyAt,
        keys_in: KeysIn,
        show: Callable[[], None],
    ) -> None:
        self._document, self._axis, self._keys = document, axis, keys
        self._key_at, self._keys_in, self._show = key_at, keys_in, show
        self._start: QPointF | None = None
        self._start_time = 0.0
        self._held: Place | None = None
        self._before: frozenset[Place] = frozenset()
        self._is_drag = False
        self._shift = 0
        self._made: tuple[Project, int, bool] | None = None
        """What the preview was made of: within a frame the pointer moves often, and nothing with it."""
        self.box: QRectF | None = None
        """The box that is being drawn, or None."""
        self.preview: Project | None = None
        """The project as the drag would leave it, or None."""

    @property
    def is_busy(self) -> bool:
        """True between press and release."""
        return self._start is not None

    def chosen(self, shape_id: str) -> frozenset[int]:
        """The chosen frames of a shape, where the drag has them now."""
        return frozenset(frame + self._shift for frame in self._keys.frames_of(shape_id))

    def press(self, event: QMouseEvent) -> None:
        """Take hold of the key under the pointer, or begin a box beside the keys."""
        at = event.position()
        self._start, self._before, self._is_drag = at, self._keys.places, False
        self._start_time = self._axis.scale.time(at.x())
        self._held = self._key_at(at)
        if self._held is not None:
            self._keys.select(_with(self._keys.places, self._held, event.modifiers()))

    def move(self, event: QMouseEvent) -> None:
        """Drag what is held, or draw the box on; nothing while the pointer has hardly moved."""
        if self._start is None:
            return
        self._is_drag = self._is_drag or (event.position() - self._start).manhattanLength() > STILL
        if not self._is_drag:
            return
        if self._held is not None:
            self._drag(event)
        else:
            self._draw_box(event)

    def release(self, event: QMouseEvent) -> None:
        """Do what was previewed, once; a mere click goes to the frame under it."""
        start, held = self._start, self._held
        if start is None:
            return
        if self._is_drag and held is not None:
            self._drop(event)
        elif not self._is_drag:
            self._click(start, event.modifiers())
        self._forget()

    def cancel(self) -> None:
        """Let go and leave everything as it was before the press."""
        if self._start is not None:
            self._keys.select(self._before)
            self._forget()

    # ---- the rest is private

    def _drag(self, event: QMouseEvent) -> None:
        self._axis.bring_in(event.position().x())
        places, offset = self._moving(), self._offset(event.position().x())
        copies, before = bool(event.modifiers() & COPIES), self._document.project
        if self._made == (before, offset, copies):
            return
        self._made = before, offset, copies
        verb = timing.copy_keys if copies else timing.move_keys
        self.preview = verb(before, places, offset) if offset and places else None
        self._shift = 0 if self.preview is None else offset
        self._axis.view_state.set_preview(self.preview)
        self._tell(places, offset, copies)
        self._show()

    def _drop(self, event: QMouseEvent) -> None:
        self._drag(event)
        project, places, offset = self.preview, self._moving(), self._offset(event.position().x())
        self._axis.view_state.set_preview(None)
        if project is not None:
            self._document.apply(tr("Copy keys") if event.modifiers() & COPIES else tr("Move keys"), project)
            self._keys.select(frozenset((shape_id, frame + offset) for shape_id, frame in places))

    def _draw_box(self, event: QMouseEvent) -> None:
        assert self._start is not None
        self.box = QRectF(self._start, event.position()).normalized()
        found, modifiers = self._keys_in(self.box), event.modifiers()
        if modifiers & Qt.KeyboardModifier.ControlModifier:
            found = self._before - found
        elif modifiers & Qt.KeyboardModifier.ShiftModifier:
            found = self._before | found
        self._keys.select(found)
        self._show()

    def _click(self, at: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        view = self._axis.view_state
        if self._held is None:
            self._keys.select(frozenset())
            if at.x() >= LABEL_WIDTH:
                self._axis.scrub(at.x())
        elif not modifiers & ADDS:
            self._keys.select(frozenset({self._held}))
            view.set_frame(self._held[1])

    def _moving(self) -> frozenset[Place]:
        """The chosen keys of shapes that may be edited."""
        return unlocked(self._document.project, self._keys.places)

    def _offset(self, x: float) -> int:
        """Whole frames from the held key to the pointer, such that no key leaves the clip."""
        scale = self._axis.scale
        frames, (first, stop) = [frame for _, frame in self._moving()], scale.clip
        if not frames:
            return 0
        # A key that lies outside of the clip already may come in, and goes no further out.
        least, most = min(first - min(frames), 0), max(stop - 1 - max(frames), 0)
        return max(min(round(scale.time(x) - self._start_time), most), least)

    def _tell(self, places: frozenset[Place], offset: int, copies: bool) -> None:
        assert self._held is not None
        if not places:
            sentence = tr("The shape is locked; unlock it to move its keys.")
        else:
            on, back = tr("%n frame(s) on", "", abs(offset)), tr("%n frame(s) back", "", abs(offset))
            sentence = tr(
                COPYING if copies else MOVING,
                keys=count_of(places),
                frames=on if offset >= 0 else back,
                first=self._held[1],
                last=self._held[1] + offset,
            )
        self._axis.view_state.say(sentence)

    def _forget(self) -> None:
        if self.preview is not None:
            self._axis.view_state.set_preview(None)
        self._start = self._held = self.box = self.preview = self._made = None
        self._is_drag, self._shift = False, 0
        self._show()


def _with(places: frozenset[Place], held: Place, modifiers: Qt.KeyboardModifier) -> frozenset[Place]:
    """What a press on a key chooses: it alone unless it is chosen already; with Shift or Ctrl it is added or taken."""
    if modifiers & ADDS:
        return places ^ {held}
    return places if held in places else frozenset({held})
