"""Moving the playhead: by frames, by keys, to the ends; and the play range."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.roto import Layer, Project, RotoShape
from roam_core.roto.animated import frames_of
from roam_core.roto.value_curves import values_of_item

from ..model.document import Document
from ..model.view_state import ViewState, shapes_in_hand
from ..translation import tr


class Navigation:
    """The verbs behind the time keys. The playhead never leaves the clip."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state
        document.replaced.connect(self._begin)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "time.previous": lambda: self.step(-1),
            "time.next": lambda: self.step(1),
            "time.back_ten": lambda: self.step(-10),
            "time.on_ten": lambda: self.step(10),
            "time.previous_key": self.previous_key,
            "time.next_key": self.next_key,
            "time.first": self.first,
            "time.last": self.last,
            "time.set_in": self.set_in,
            "time.set_out": self.set_out,
            "time.clear_range": self.clear_range,
        }

    @property
    def clip_range(self) -> tuple[int, int]:
        """The clip's frames, half open; without a clip just the present one."""
        frames = clip_frames(self._document.project, self._view.frame)
        return frames.start, frames.stop

    def step(self, frames: int) -> None:
        first, stop = self.clip_range
        self._view.set_frame(min(max(self._view.frame + frames, first), stop - 1))

    def first(self) -> None:
        self._view.set_frame(self._view.play_range[0])

    def last(self) -> None:
        self._view.set_frame(self._view.play_range[1] - 1)

    def next_key(self) -> None:
        """Go to the next key by hand, or change of depth, of what is selected, or of all when nothing is."""
        if later := [frame for frame in self._stops() if frame > self._view.frame]:
            self._view.set_frame(min(later))
        else:
            self._view.say_here(tr("There is no key after this frame."))

    def previous_key(self) -> None:
        """Go to the one before, likewise."""
        if earlier := [frame for frame in self._stops() if frame < self._view.frame]:
            self._view.set_frame(max(earlier))
        else:
            self._view.say_here(tr("There is no key before this frame."))

    def set_in(self) -> None:
        frame, (_, stop) = self._view.frame, self._view.play_range
        self._view.set_play_range(frame, stop if stop > frame else self.clip_range[1])

    def set_out(self) -> None:
        frame, (first, _) = self._view.frame, self._view.play_range
        self._view.set_play_range(first if first <= frame else self.clip_range[0], frame + 1)

    def clear_range(self) -> None:
        self._view.set_play_range(*self.clip_range)

    def _begin(self) -> None:
        """Another project: its clip is the play range, its first frame or its first key's the present one."""
        clip = self._document.project.clip
        self._view.hold_inside(None if clip is None else clip.frame_range)
        frames, keys = clip_frames(self._document.project, 1), self._key_frames()
        first, stop = frames.start, frames.stop
        self._view.set_play_range(first, stop)
        self._view.set_frame(min(max(min(keys, default=first), first), stop - 1))

    def _stops(self) -> set[int]:
        """Where something is set by hand: keys, of opacity and feather too, of tracks, and changes of what hides what.

        What lies beside the clip's frames is not gone to.
        """
        project, view = self._document.project, self._view
        shapes, is_any = shapes_in_hand(project, view.selection), not (view.layers or view.selection.shapes)
        layers = [
            item for item in project.root.items() if isinstance(item, Layer) and (is_any or item.id in view.layers)
        ]
        items: list[Layer | RotoShape] = [*layers, *shapes]
        values = {frame for item in items for value in values_of_item(item).values() for frame in frames_of(value)}
        around = {layer.id: layer for shape in shapes for layer in project.layers_above(shape.id)}
        adjusted = {key for layer in around.values() if layer.transform for key in layer.transform.adjusted}
        stops = self._key_frames() | values | adjusted | {frame for shape in shapes for frame, _ in shape.depth}
        return {frame for frame in stops if project.clip is None or frame in project.clip.frame_range}

    def _key_frames(self) -> set[int]:
        shapes = shapes_in_hand(self._document.project, self._view.selection)
        return {frame for shape in shapes for frame in shape.artist_frames}


def clip_frames(project: Project, frame: int) -> range:
    """The frames of the project's clip; without a clip just `frame`."""
    return range(frame, frame + 1) if project.clip is None else project.clip.frame_range
