"""ViewState: what the window looks at and holds in its hand. Never saved in the project, never undone."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cached_property

from PySide6.QtCore import QObject, QTimer, Signal

from roam_core.roto import Project, RotoShape

from ..actions.keymaps import Keymap, load_keymap, told
from .editing import EditingModes
from .solo import Solo
from .track_points import TrackPoints


@dataclass(frozen=True)
class Selection:
    """Selected shapes by id, and the selected points as (shape id, point index)."""

    shapes: frozenset[str] = frozenset()
    points: frozenset[tuple[str, int]] = frozenset()

    def indices_of(self, shape_id: str) -> Sequence[int]:
        """The selected points of one shape, in order."""
        return self._by_shape.get(shape_id, ())

    @cached_property
    def _by_shape(self) -> dict[str, list[int]]:
        """Each shape is asked about in turn: of hundreds all have thousands of points selected."""
        found: dict[str, list[int]] = {}
        for shape_id, index in sorted(self.points):
            found.setdefault(shape_id, []).append(index)
        return found


Place = tuple[int, tuple[int, int], frozenset[str], frozenset[str]]
"""A frame, in and out, and the ids of the shapes and of the layers that are selected."""


class ViewState(QObject):
    """Frame, selection, tool, drag preview, play range.

    Signals carry nothing: listeners pull. `preview` is the project as a drag would make it, or None.
    """

    frame_changed = Signal()
    selection_changed = Signal()
    tool_changed = Signal()
    preview_changed = Signal()
    range_changed = Signal()
    message_changed = Signal()
    keymap_changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._frame = 1
        self._clip: range | None = None
        self._selection = Selection()
        self._layers: frozenset[str] = frozenset()
        self._tool = "select"
        self._preview: Project | None = None
        self._is_hand_busy: Callable[[], bool] = lambda: False
        self._range = (1, 2)
        self.is_playing = False
        """Whether the clip is played: the playhead goes its own way."""
        self._said = self._hint = self._advice = self._of_picture = ""
        self._is_said_just_now = self._is_said_in_drag = self._is_reading = self._can_wait = self._is_left = False
        self._told_of: Place | None = None
        """What the sentence is about, where it is about a place."""
        self._keymap = load_keymap()
        self.editing = EditingModes(self)
        """How edits reach points and keys."""
        self.solo = Solo(self)
        """What alone is shown."""
        self.hovered: tuple[str, int, int] | None = None
        """(shape id, point index, part) under the pointer, or None."""
        self.track_points: TrackPoints | None = None
        """What a point track is to follow; None: what the track of the shapes in hand followed."""
        self.follows_points = False
        """Whether a point track goes on: Esc stops it, and takes no points away."""

    @property
    def frame(self) -> int:
        return self._frame

    def set_frame(self, frame: int, *, is_of_run: bool = False) -> None:
        """Show a frame; of those that the clip does not have, the one at its nearer end.

        Where a run takes the playhead along (`is_of_run`), what was told of the frame before is still to be read.
        """
        if self._clip is not None:
            frame = min(max(frame, self._clip[0]), self._clip[-1])
        if frame != self._frame:
            self._frame = frame
            self.frame_changed.emit()
            if not is_of_run:
                self._leave_place()

    def hold_inside(self, frames: range | None) -> None:
        """The clip has these frames, and no other is shown from now on; None: there is no clip."""
        self._clip = frames

    @property
    def selection(self) -> Selection:
        return self._selection

    @property
    def layers(self) -> frozenset[str]:
        """The ids of the layers that are selected as such; their shapes are in `selection`."""
        return self._layers

    def select(
        self,
        shapes: frozenset[str],
        points: frozenset[tuple[str, int]] = frozenset(),
        layers: frozenset[str] | None = None,
    ) -> None:
        """Select shapes and points; a selected point's shape is selected with it.

        Layers stay selected as long as the same shapes and points do, unless `layers` says which are.
        """
        selection = Selection(shapes | {shape_id for shape_id, _ in points}, points)
        if layers is None:
            layers = self._layers if selection == self._selection else frozenset()
        if (selection, layers) != (self._selection, self._layers):
            self._selection, self._layers = selection, layers
            self.selection_changed.emit()
            self._leave_place()

    @property
    def tool(self) -> str:
        return self._tool

    def set_tool(self, name: str) -> None:
        if name != self._tool:
            self._tool = name
            self.tool_changed.emit()

    @property
    def preview(self) -> Project | None:
        return self._preview

    @property
    def is_in_use(self) -> bool:
        """Whether the artist drags or draws something on the frame that is shown."""
        return self._preview is not None or self._is_hand_busy()

    @property
    def keeps_frame(self) -> bool:
        """Whether no run takes the playhead along: the artist is busy on the frame that is shown, or plays."""
        return self.is_playing or self.is_in_use

    def ask_hand(self, is_busy: Callable[[], bool]) -> None:
        """Let `is_busy()` tell whether a tool has something half done in the picture."""
        self._is_hand_busy = is_busy

    def set_preview(self, project: Project | None) -> None:
        if project is not self._preview:
            self._preview = project
            self.preview_changed.emit()

    @property
    def play_range(self) -> tuple[int, int]:
        """In and out frame, half open."""
        return self._range

    def set_play_range(self, first: int, stop: int) -> None:
        if (first, stop) != self._range and stop > first:
            self._range = (first, stop)
            self.range_changed.emit()
            self._leave_place()

    @property
    def keymap(self) -> Keymap:
        """The keys that hold: sentences tell them."""
        return self._keymap

    def set_keymap(self, keymap: Keymap) -> None:
        if keymap != self._keymap:
            before, self._keymap = self.message, keymap
            self.keymap_changed.emit()
            if self.message != before:
                self.message_changed.emit()

    @property
    def message(self) -> str:
        """The sentence in the status bar: an error, or what to do next; it names the keys that hold now."""
        return told(self._said, self._keymap)

    @property
    def is_reading(self) -> bool:
        """Whether the sentence is a measure that changes with the hand: no message to look up later."""
        return self._is_reading

    @property
    def can_wait(self) -> bool:
        """Whether the sentence, the end of some work, may wait until what stands in the status bar has been read."""
        return self._can_wait

    @property
    def is_left(self) -> bool:
        """Whether the sentence is what was left when another one went: no news to be read before work that goes on."""
        return self._is_left

    def say(self, sentence: str, *, is_reading: bool = False, can_wait: bool = False, is_left: bool = False) -> None:
        """Tell the artist something; `<tool.bezier>` in it stands for the key that this action has at present."""
        self._is_reading, self._can_wait, self._is_left = is_reading, can_wait, is_left
        self._told_of = None
        self._said = sentence
        self._is_said_just_now, self._is_said_in_drag = True, self._preview is not None
        QTimer.singleShot(0, self, self._age)
        self.message_changed.emit()

    def say_here(self, sentence: str) -> None:
        """Tell something of this frame, of in and out or of what is selected; when these are others, it goes."""
        self.say(sentence)
        self._told_of = self._place

    @property
    def _place(self) -> Place:
        return self._frame, self._range, self._selection.shapes, self._layers

    def _leave_place(self) -> None:
        """What was told of a place that is left is untrue now, or about nothing that is looked at."""
        if self._told_of not in (None, self._place):
            self.say(self._hint, is_left=True)

    def advise(self, sentence: str) -> None:
        """Tell what to do next with the shapes that are selected, on this frame; the artist's edits leave it."""
        self.say_here(sentence)
        self._advice = sentence

    def say_of_picture(self, sentence: str) -> None:
        """Tell why there is no picture; where there is one again, it goes."""
        self.say(sentence)
        self._of_picture = sentence

    def note_picture(self, _frame: int, picture: object) -> None:
        """A frame is shown, or has no picture (None)."""
        if picture is not None and self._of_picture:
            if self._said == self._of_picture:
                self.say(self._hint, is_left=True)
            self._of_picture = ""

    def go_on(self) -> None:
        """The artist edits something: what was told of something before that goes.

        The tool's hint and advice stay, and so does what was said just now, or in the drag that ends with this edit.
        """
        is_of_drag = self._is_said_in_drag and self._preview is not None
        if not self._is_said_just_now and not is_of_drag and self._said not in (self._hint, self._advice):
            self.say(self._hint, is_left=True)

    def _age(self) -> None:
        self._is_said_just_now = False

    def say_hint(self, hint: str, *, is_shy: bool = False) -> None:
        """Tell what the tool in the hand expects, in place of the last tool's hint, which goes also where `hint` is
        empty; any other message then stays, as it does where the hint `is_shy`.
        """
        if (hint and not is_shy) or (self._hint and self._said == self._hint):
            self.say(hint)
        self._hint = hint


def selected_shapes(project: Project, selection: Selection) -> list[RotoShape]:
    """The selected shapes, bottom first."""
    return [shape for shape in project.shapes if shape.id in selection.shapes]


def shapes_in_hand(project: Project, selection: Selection) -> list[RotoShape]:
    """What tracking and navigation act on: the selected shapes, or all where none is selected; bottom first."""
    return selected_shapes(project, selection) or list(project.shapes)


def shapes_looked_at(project: Project, view: ViewState) -> list[RotoShape]:
    """What marks of the viewer are about: the shapes in hand; while some are soloed, of these alone."""
    if not (left_out := view.solo.left_out(project)):
        return shapes_in_hand(project, view.selection)
    shown = [shape for shape in project.shapes if shape.id not in left_out]
    return [shape for shape in shown if shape.id in view.selection.shapes] or shown
