"""CanvasView: shows the plate with the shapes on it, pans and zooms, and hands events to the tool."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence

from PySide6.QtCore import QEvent, QPoint, QPointF, QRectF, QSizeF, Qt, QTimer, Signal
from PySide6.QtGui import QContextMenuEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from roam_core.arrays import UInt8
from roam_core.propagate.frame.topology_proposals import Proposal
from roam_core.propagate.parts.edges import Edges
from roam_core.roto import Project

from ..actions.context import Place
from ..actions.key_names import NUDGES, is_modifier, key_name
from ..features.belonging import Bone
from ..model.document import Document
from ..model.shown import selection_bounds
from ..model.view_state import Selection, ViewState
from ..model.viewing import Viewing, ViewMode
from ..paint.feather import paint_feather
from ..paint.viewport import Viewport
from ..tools.edit.point_actions import PointActions
from ..tools.in_hand import ToolInHand
from ..tools.menu_place import taken_up
from ..tools.reshape import pruned
from ..tools.tool import Pointer, Tool
from ..translation import tr
from .items.joints import paint_joints
from .items.proposal import ProposalPainter, Side
from .magnifier import Magnifier, Scene
from .plate.stage import Stage
from .pointed import PointedWidget
from .repaint import Repaint
from .stabiliser import Stabiliser
from .view_snapshot import SnapshotPainter, ViewSnapshot
from .wipe import Wipe
from .words import Words

PATIENCE = 25
"""Milliseconds in which the picture of another frame should come; then the shapes go there without it."""

TAKE_BACK = "Backspace"


class CanvasView(PointedWidget):
    """The picture and the curves on it.

    It pulls what it paints: the document's project (or the view state's drag preview), frame and selection. Events of
    the left button go to the tool that `view_state.tool` names.

    Signals
    -------
    pointer_moved(position) : the pointer's image position `(x, y)`, or None when it left.
    matte_ready() : the matte that the view wants has been rendered, beside the window's thread.
    menu_asked(place, where) : a right click on that `Place`, at this place of the screen.
    """

    pointer_moved = Signal(object)
    matte_ready = Signal()
    menu_asked = Signal(object, QPoint)

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        parent: QWidget | None = None,
        in_hand: ToolInHand | None = None,
    ) -> None:
        super().__init__(parent)
        self._document, self._view_state = document, view_state
        self.in_hand = in_hand or ToolInHand(document, view_state, self)
        """The tools, which viewers may share."""
        self.points = PointActions(document, view_state)
        self.viewing = Viewing(self)
        """Which view, channel and exposure; what lies under a cut-out; which frames the onion skin shows."""
        self.stage, self.wipe = Stage(self.viewing), Wipe(self._snapshot, view_state.say, self)
        self.words = Words(self.stage, view_state)
        going = self._project, lambda: self._viewport, self.go_along
        self.stabiliser = Stabiliser(view_state, self.viewing, *going, self)
        self._repaint = Repaint(self)
        self._present, self._pinned, self._proposed = SnapshotPainter(), SnapshotPainter(), ProposalPainter()
        self.proposed: Callable[[], Proposal | None] = lambda: None
        """Gives what the engine proposes for the present frame."""
        self.bones: Callable[[], Sequence[Bone]] = tuple
        """Gives where the parts in hand hang together on the present frame."""
        self.edges: Callable[[], Mapping[str, Edges]] = dict
        """Gives the kinds of edge of the shapes in hand on the present frame."""
        self.magnifier = Magnifier(self, self.in_hand, self._scene, self._present.paths)
        self._proposal_side = Side.BOTH
        self._is_pressed, self._key_presses = False, 0
        self._patience = QTimer(self, interval=PATIENCE, singleShot=True)
        self._patience.timeout.connect(self._show_frame)
        self._listen()
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_OpaquePaintEvent)
        self.setMinimumSize(160, 120)
        self._show_tool()

    def _listen(self) -> None:
        view, document = self._view_state, self._document
        document.changed.connect(self._pull)
        document.replaced.connect(self._begin_anew)
        view.frame_changed.connect(self._follow_frame)
        for signal in (view.selection_changed, view.keymap_changed, view.editing.changed, self.stage.changed):
            signal.connect(self.update)
        view.preview_changed.connect(self._follow_preview)
        self.in_hand.changed.connect(self._take_tool)
        self.in_hand.looked.connect(self._show_tool)
        self.feel_after(document.changed, view.frame_changed, view.selection_changed, self.in_hand.changed)
        self.in_hand.used.connect(self._follow_hand)
        view.solo.changed.connect(self._pull)
        self.viewing.changed.connect(self._announce)
        self.wipe.changed.connect(self._announce)
        self.stage.matte_ready.connect(self.matte_ready)
        self.stage.background.refused.connect(view.say)
        self.destroyed.connect(self.stage.close)
        moving = self.view_changed, self.stage.changed, view.frame_changed, view.preview_changed, document.changed
        for signal in moving:
            signal.connect(self.magnifier.follow)

    # ---- what is shown

    def set_image(self, frame: int, image: UInt8 | None) -> None:
        """Show the plate's picture of `frame`: (h, w, 3) uint8 display values, or None where the plate has none.

        A proxy with fewer pixels than the clip is stretched to the clip's size.
        """
        self._patience.stop()
        self.stage.set_image(frame, image)
        self._follow_plate()
        self._show_frame()

    def _show_tool(self) -> None:
        self.setCursor(self.tool.cursor)
        self.update()

    @property
    def tool(self) -> Tool:
        """The tool in the hand."""
        return self.in_hand.tool

    @property
    def mode(self) -> ViewMode:
        return self.viewing.mode

    def show_proposal(self, side: Side) -> None:
        """Show a proposal before and after, or one of both alone."""
        self._proposal_side = side
        self.update()

    def set_waiting(self, waits: bool, lacks_plate: bool) -> None:
        """What the empty canvas says: a plate is being opened, or that of the project could not be."""
        self.words.is_waiting, self.words.lacks_plate = waits, lacks_plate
        self.update()

    def fit_selection(self) -> None:
        """Show the selected points or shapes as large as can be; without a selection, the whole picture."""
        selection = self._view_state.selection
        box = selection_bounds(self._project(), self._view_state.frame, selection.shapes, selection.points)
        self.fit() if box is None else self.show_area(QRectF(QPointF(*box[:2]), QPointF(*box[2:])))

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of the viewer do, by id."""
        return {
            **self.points.handlers(),
            "view.fit_selection": self.fit_selection,
            **super().handlers(),
            **self.viewing.handlers(),
            **self.wipe.handlers(),
            **self.stabiliser.handlers(),
        }

    def _announce(self) -> None:
        self.view_changed.emit()
        self.update()

    # ---- what it pulls

    def _project(self) -> Project:
        return self._view_state.solo.seen(self._view_state.preview or self._document.project)

    def _image_size(self) -> QSizeF | None:
        """The plate's size in full-resolution pixels, or None where there is no plate."""
        if clip := self._document.project.clip:
            return QSizeF(*clip.size)
        return self.stage.picture.size if self.stage.picture else None

    def plate_size(self) -> QSizeF:
        return self._image_size() or QSizeF(self.size())

    def _pull(self, _ids: object = None) -> None:
        """The project changed."""
        self._prepare()
        self._repaint.everything(self._project(), self._view_state.frame)

    def _prepare(self) -> None:
        """Nothing may stay selected or grabbed that is gone."""
        selection = pruned(self._view_state.selection, self._document.project)
        self._view_state.select(selection.shapes, selection.points)
        self.tool.refresh()
        self._follow_plate()

    def _follow_frame(self) -> None:
        """Another frame: shapes and picture change together, unless the picture lets the artist wait for it."""
        if self.stage.frame is None and self.words.is_waiting:  # nothing was seen yet of what is being opened
            self.stabiliser.forget()
        waits = self.stage.frame is not None and self.stage.frame != self._view_state.frame
        self._prepare()
        self._patience.start() if waits else self._show_frame()

    def _show_frame(self) -> None:
        """Another frame is seen from now on, if need be without its picture: a stabilised view goes along."""
        self.stabiliser.follow()
        self.update()

    def set_viewport(self, viewport: Viewport) -> None:
        """Beyond that, another pixel lies under a pointer that stands still."""
        super().set_viewport(viewport)
        if self._pointer is not None:
            self.pointer_moved.emit(self.widget_to_image(self._pointer))

    def _begin_anew(self) -> None:
        """Another project was opened."""
        self.tool.drop()
        self._view_state.select(frozenset())
        self.stage.clear()
        self.wipe.end()
        self.stabiliser.forget()
        self._follow_plate()
        self.fit()

    def _follow_plate(self) -> None:
        """Another plate than the one that was framed is shown whole."""
        clip = self._document.project.clip
        self.frame_plate(self._image_size() or QSizeF(), clip.pixel_aspect if clip else 1.0)

    def _follow_preview(self) -> None:
        """A drag goes on: only what it moved is painted again, where nothing but the plate lies below."""
        is_plain = self.mode is ViewMode.OVERLAY and self.wipe.pinned is None and not self.viewing.shows_edges
        self._repaint.follow_project(self._project(), self._view_state.frame, self._viewport, is_plain=is_plain)

    def _take_tool(self) -> None:
        """Another tool is in the hand."""
        self._is_pressed = False
        self._show_tool()

    def _follow_hand(self, viewer: object, position: tuple[float, float] | None) -> None:
        """The tool was used in some viewer: its marks are the same in all."""
        if viewer is self or not self.isVisible():
            return
        if position is None:
            self.update()
        else:
            spot = self.image_to_widget(*position)
            self._repaint.follow_tool(self.tool, self._viewport, self._view_state.hovered, spot)

    def _snapshot(self) -> ViewSnapshot:
        """What is shown now."""
        project, frame, image, viewing = self._project(), self._view_state.frame, self._image_size(), self.viewing
        below, whole = self.stage.below(project, frame, image), self.stage.is_whole(project, frame)
        edges = self.edges() if viewing.shows_edges and viewing.shows_shapes else {}
        look = viewing.mode, viewing.onion, project, frame, viewing.shows_shapes, edges
        alone, chosen = self._view_state.solo.told(project), self._view_state.selection
        return ViewSnapshot(below, image, *look, alone, self.stabiliser.travelled, whole, chosen, viewing.shows_joints)

    def _scene(self) -> Scene | None:
        """What is to be shown magnified of what is shown now."""
        if not (self.viewing.shows_magnifier and self.viewing.shows_shapes):
            return None
        look, frame = self.viewing.look, self._view_state.frame
        return Scene(self.stage.picture, self.plate_size(), look, self._project(), frame, self._viewport)

    # ---- painting

    def paintEvent(self, event: QPaintEvent) -> None:
        painter, view, size = QPainter(self), self._view_state, QSizeF(self.size())
        painter.setClipRect(event.rect())
        ratio, viewport, snapshot = self.devicePixelRatioF(), self._viewport, self._snapshot()
        if (pinned := self.wipe.pinned) is not None:
            painter.setClipRect(self.wipe.left(size) & QRectF(event.rect()))
            there = viewport.with_picture_moved(self.stabiliser.aside(pinned.travelled, pinned.frame))
            self._pinned.paint(painter, pinned, there, ratio, Selection(), whose=pinned.chosen)
            right = QRectF(self.rect()).adjusted(self.wipe.left(size).width(), 0, 0, 0)
            painter.setClipRect(right & QRectF(event.rect()))
        self._present.paint(painter, snapshot, viewport, ratio, view.selection, view.hovered)
        if self.viewing.shows_shapes:
            if (proposal := self.proposed()) is not None:
                self._proposed.paint(painter, viewport, proposal, self._proposal_side)
            paint_feather(painter, viewport, self._project(), view.frame, view.selection.shapes)
            if self.viewing.shows_joints:
                paint_joints(painter, viewport, self._project(), view.frame, self.bones())
            self.tool.paint(painter, viewport)
        painter.setClipping(False)
        if pinned is None:
            self.words.paint(painter, size, viewport, snapshot, is_idle=view.tool == "select")
        else:
            self.wipe.paint(painter, size, snapshot)
        painter.end()

    # ---- events: the view's own, then the tool's

    def event(self, event: QEvent) -> bool:
        if (
            isinstance(event, QKeyEvent)
            and event.type() is QEvent.Type.ShortcutOverride
            and (self._is_pressed or key_name(event) in self.tool.claimed_keys)
        ):
            # It comes to `keyPressEvent`, not to the window's shortcut: while something is held, others mean nothing.
            event.accept()
            return True
        return super().event(event)

    def point(self, event: QMouseEvent) -> None:
        kind = event.type()
        if kind is QEvent.Type.MouseMove:
            self._move(event)
        elif kind is QEvent.Type.MouseButtonRelease:
            self._release(event)
        else:
            self._press(event, self.tool.press if kind is QEvent.Type.MouseButtonPress else self.tool.double_press)

    def erase(self, event: QMouseEvent) -> None:
        """It takes back what is being drawn, point by point, else deletes what it touches."""
        if event.type() is QEvent.Type.MouseButtonRelease:
            self.point(event)
            self.in_hand.turn_pen(False)
            self._show_tool()
        elif TAKE_BACK in self.tool.claimed_keys:
            self.tool.key(TAKE_BACK)
            self.update()
        else:
            self.in_hand.turn_pen(True)
            self._press(event, self.tool.press)

    def _move(self, event: QMouseEvent) -> None:
        self._pointer = position = event.position()
        if self.is_panning:
            self.pan(event)
            return
        self.pointer_moved.emit(self.widget_to_image(position))
        if self.wipe.is_held:
            self.wipe.move(position, QSizeF(self.size()))
        elif self._is_pressed:
            self._hand(self.tool.drag, position, event.modifiers())
        else:
            self._hover(position, event.modifiers())

    def _release(self, event: QMouseEvent) -> None:
        if self.is_panning and event.button() is not Qt.MouseButton.RightButton:
            self.end_pan()
            self._hover(event.position(), event.modifiers())
        elif self.wipe.is_held:
            self.wipe.is_held = False
            self._hover(event.position(), event.modifiers())
        elif self._is_pressed and event.button() is Qt.MouseButton.LeftButton:
            self._is_pressed = False
            self._hand(self.tool.release, event.position(), event.modifiers())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """Ctrl and the wheel belong to the tool, where it has a size to change; the wheel alone zooms."""
        takes = event.modifiers() & Qt.KeyboardModifier.ControlModifier and self.viewing.shows_shapes
        if takes and self.tool.wheel(self._at(event.position(), event.modifiers()), event.angleDelta().y() / 120.0):
            event.accept()
            self.update()
        else:
            super().wheelEvent(event)

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """A right click means what lies under it; while something is in the hand it means nothing."""
        if self._is_pressed or self.is_panning or self.tool.is_busy or self._document.project.clip is None:
            return
        spot, place = QPointF(event.pos()), Place.BACKGROUND
        if self.viewing.shows_shapes:
            place = taken_up(self._view_state, self._document.project, self._at(spot, event.modifiers()))
        self.menu_asked.emit(place, event.globalPos())

    def leaveEvent(self, event: QEvent) -> None:
        self._pointer = None
        self.tool.leave()
        self.pointer_moved.emit(None)
        self.update()
        self.in_hand.used.emit(self, None)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        name = key_name(event)
        self._key_presses += not event.isAutoRepeat()
        if is_modifier(event):
            self._feel_modifiers(event)
        elif name in self.tool.claimed_keys:
            self._is_pressed = False
            self.tool.key(name)
            self.update()
            self.in_hand.used.emit(self, None)
        elif name in NUDGES and not self._is_pressed:
            # All repeats of a held key are one undo step; each viewer counts its own keys.
            self.points.nudge(*NUDGES[name], merge_key=f"nudge {id(self)} {self._key_presses}")
        else:
            event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        if is_modifier(event):
            self._feel_modifiers(event)
        else:
            event.ignore()

    def _press(self, event: QMouseEvent, call: Callable[[Pointer], None]) -> None:
        """Give a press to the tool, unless it begins a pan."""
        if self._is_pressed or self.is_panning or self.begin_pan(event):
            return
        if event.button() is not Qt.MouseButton.LeftButton:
            event.ignore()
            return
        if self.wipe.is_under(event.position(), QSizeF(self.size())):
            self.wipe.is_held = True
            self.update()
            return
        if not self.viewing.shows_shapes:
            self._view_state.say(tr("The shapes are hidden; show them (overlay view) to draw and edit."))
            return
        self._is_pressed = True
        self._hand(call, event.position(), event.modifiers())

    def _hover(self, position: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        if self.wipe.is_under(position, QSizeF(self.size())):
            self.setCursor(Qt.CursorShape.SplitHCursor)
        elif self.viewing.shows_shapes:
            self._hand(self.tool.hover, position, modifiers)
        else:
            self.setCursor(Qt.CursorShape.ArrowCursor)

    def _hand(self, call: Callable[[Pointer], None], position: QPointF, modifiers: Qt.KeyboardModifier) -> None:
        """Give the pointer to the tool, then show what it made of it."""
        self._pointer = position
        call(self._at(position, modifiers))
        self.setCursor(self.tool.cursor)
        self._repaint.follow_tool(self.tool, self._viewport, self._view_state.hovered, position)
        self.in_hand.used.emit(self, self.widget_to_image(position))

    def _at(self, position: QPointF, modifiers: Qt.KeyboardModifier) -> Pointer:
        """The pointer as tools know it."""
        return Pointer(self.widget_to_image(position), self._viewport.pixel, modifiers, self.pen.pressure)

    def _feel_modifiers(self, event: QKeyEvent) -> None:
        """A modifier was pressed or let go: the tool may now do something else at the same place."""
        if self._pointer is not None and not self.is_panning and self.viewing.shows_shapes:
            self._hand(self.tool.drag if self._is_pressed else self.tool.hover, self._pointer, event.modifiers())
