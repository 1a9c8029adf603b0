"""KeyHand: the gestures over the key rows: keys dragged or copied along time, boxes drawn around keys."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QMouseEvent

from roam_core.roto import Project, timing
from roam_core.roto.timing import Place

from ...model.document import Document
from ...translation import N_, tr
from ..axis import TimeAxis
from ..scale import LABEL_WIDTH
from .selection import KeySelection
from .stretch import End, Stretch, told
from .verbs import count_of, unlocked

MOVING = N_("Move {keys} {frames}: {first} to {last}.")
COPYING = N_("Copy {keys} {frames}: {first} to {last}.")

STILL = 3
"""Pixels that the pointer may move between press and release of a click."""

ADDS = Qt.KeyboardModifier.ShiftModifier | Qt.KeyboardModifier.ControlModifier
COPIES = Qt.KeyboardModifier.AltModifier

KeyAt = Callable[[QPointF], Place | None]
KeysIn = Callable[[QRectF], frozenset[Place]]
EndAt = Callable[[QPointF], End | None]


class KeyHand:
    """One gesture at a time: a key or bracket is held, or a box is drawn. A drag previews; release is one undo step.

    `key_at` and `keys_in` tell which keys lie under a point or inside a box of the rows, `end_at` which bracket beside
    the chosen ones; `show` repaints them.
    """

    def __init__(
        self,
        document: Document,
        axis: TimeAxis,
        keys: KeySelection,
        key_at: KeyAt,
        keys_in: KeysIn,
        end_at: EndAt,
        show: Callable[[], None],
    ) -> None:
        self._document, self._axis, self._keys = document, axis, keys
        self._key_at, self._keys_in, self._end_at, self._show = key_at, keys_in, end_at, show
        self._start: QPointF | None = None
        self._start_time = 0.0
        self._held: Place | None = None
        self._before: frozenset[Place] = frozenset()
        self._is_drag = False
        self._boxed_to: tuple[QPointF, Qt.KeyboardModifier] = QPointF(), Qt.KeyboardModifier.NoModifier
        """Where the box was drawn to last, and with which keys held."""
        self._stretch: Stretch | None = None
        self._goes: Mapping[int, int] = {}
        """Where the chosen keys go by the drag, by their frames; those that it tells nothing of stay."""
        self._made: tuple[Project, Mapping[int, int], bool] | None = None
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
        return frozenset(self._goes.get(frame, frame) for frame in self._keys.frames_of(shape_id))

    def movable(self) -> list[int]:
        """The frames of the chosen keys that may be changed, where the drag has them now."""
        return [self._goes.get(frame, frame) for _, frame in self._moving()]

    def press(self, event: QMouseEvent) -> None:
        """Take hold of the bracket or key under the pointer, or begin a box beside the keys."""
        at = event.position()
        self._start, self._before, self._is_drag = at, self._keys.places, False
        self._start_time = self._axis.scale.time(at.x())
        end = self._end_at(at)
        self._stretch = None if end is None else Stretch(self._axis, end, at.x())
        self._held = self._key_at(at) if end is None else None
        if self._held is not None:
            self._keys.select(_with(self._keys.places, self._held, event.modifiers()))

    def move(self, event: QMouseEvent) -> None:
        """Drag what is held, or draw the box on; nothing while the pointer has hardly moved."""
        if self._start is None:
            return
        self._is_drag = self._is_drag or (event.position() - self._start).manhattanLength() > STILL
        if not self._is_drag:
            return
        if self._held is not None or self._stretch is not None:
            self._drag(event)
        else:
            self._boxed_to = event.position(), event.modifiers()
            self._draw_box()

    def scrolled(self, by: float) -> None:
        """The rows were scrolled down by so many pixels: the box keeps the row in which it was begun."""
        if self._start is not None:
            self._start -= QPointF(0.0, by)
        if self.box is not None:
            self._draw_box()

    def release(self, event: QMouseEvent) -> None:
        """Do what was previewed, once; a mere click goes to the frame under it."""
        start, held = self._start, self._held
        if start is None:
            return
        if self._is_drag and (held is not None or self._stretch is not None):
            self._drop(event)
        elif not self._is_drag and self._stretch is None:
            self._click(start, event.modifiers())
        self._forget()

    def cancel(self) -> None:
        """Let go and leave everything as it was before the press."""
        if self._start is not None:
            self._keys.restore(self._before)
            self._forget()

    # ---- the rest is private

    def _drag(self, event: QMouseEvent) -> None:
        self._axis.bring_in(event.position().x())
        x, places = event.position().x(), self._moving()
        own, copies, before = {frame for _, frame in places}, self._copies(event), self._document.project
        if self._stretch is not None:
            goes, offset = self._stretch.goes(own, x), 0
        else:
            offset = self._offset(x)
            goes = {frame: frame + offset for frame in own}
        if self._made == (before, goes, copies):
            return
        self._made, is_moved = (before, goes, copies), any(frame != to for frame, to in goes.items())
        if not is_moved:
            self.preview = None
        elif copies:
            self.preview = timing.copy_keys(before, places, offset)
        else:
            self.preview = timing.retime_keys(before, places, goes)
        self._goes = goes if is_moved else {}
        self._axis.view_state.set_preview(self.preview)
        self._tell(places, goes, offset, copies)
        self._show()

    def _drop(self, event: QMouseEvent) -> None:
        self._drag(event)
        project, goes, places = self.preview, self._goes, self._moving()
        self._axis.view_state.set_preview(None)
        if project is not None:
            moving = tr("Move keys") if self._stretch is None else tr("Stretch keys")
            self._document.apply(tr("Copy keys") if self._copies(event) else moving, project)
            self._keys.select(frozenset((shape_id, goes[frame]) for shape_id, frame in places))

    def _copies(self, event: QMouseEvent) -> bool:
        return self._stretch is None and bool(event.modifiers() & COPIES)

    def _draw_box(self) -> None:
        assert self._start is not None
        at, modifiers = self._boxed_to
        self.box = QRectF(self._start, at).normalized()
        found = self._keys_in(self.box)
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

    def _tell(self, places: frozenset[Place], goes: dict[int, int], offset: int, copies: bool) -> None:
        if not places:
            sentence = tr("The shape is locked; unlock it to move its keys.")
        elif self._held is None:
            sentence = told(count_of(places), goes)
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
        self._start = self._held = self.box = self.preview = self._made = self._stretch = None
        self._is_drag, self._goes = False, {}
        self._show()


def _with(places: frozenset[Place], held: Place, modifiers: Qt.KeyboardModifier) -> frozenset[Place]:
    """What a press on a key chooses: it alone unless it is chosen already; with Shift or Ctrl it is added or taken."""
    if modifiers & ADDS:
        return places ^ {held}
    return places if held in places else frozenset({held})
