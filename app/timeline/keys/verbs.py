"""What keys and menus do to the chosen keys of the timeline: each one edit of the document, one undo step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import partial

from roam_core.errors import RoamError
from roam_core.roto import Interpolation, Keyframe, Layer, Project, timing
from roam_core.roto.timing import Place

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS
from ...model.view_state import ViewState, selected_shapes
from ...translation import N_, sentence_of, tr
from .nudging import Nudges
from .selection import KeySelection

WAYS = {
    Interpolation.LINEAR: N_("Linear"),
    Interpolation.SMOOTH: N_("Smooth"),
    Interpolation.HOLD: N_("Hold"),
}
NO_KEYS = N_("Choose keys in the timeline first: click one, or drag a box around several.")
NOTHING_COPIED = N_("There is no key to paste; copy keys in the timeline first.")
FITS_SOME = N_("The copied keys do not fit {names}: locked, or of other points, or beside the clip.")
NONE_BEFORE = N_("There is no key before this frame.")
NOTHING_HERE = N_("Select a shape first, or choose keys in the timeline.")


class KeyVerbs:
    """The verbs on chosen keys. `has_keyboard` tells whether the key rows have it: then copy means keys."""

    def __init__(
        self, document: Document, view_state: ViewState, keys: KeySelection, has_keyboard: Callable[[], bool]
    ) -> None:
        self._document, self._view, self._keys, self._has_keyboard = document, view_state, keys, has_keyboard
        self._nudges = Nudges(document, keys, timing.move_keys)
        self._copied: dict[str, tuple[Keyframe, ...]] = {}
        document.replaced.connect(self._forget)

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {f"key.{each.value}": partial(self.interpolate, each) for each in Interpolation}

    def taking_over(self, handlers: Mapping[str, Callable[[], object]]) -> dict[str, Callable[[], object]]:
        """Handlers that mean keys while the key rows have the keyboard, and what they meant elsewhere.

        Where no key is chosen, or was copied, copying and pasting mean shapes in the key rows, too: a click on a
        shape's name has selected it.
        """
        own: dict[str, tuple[Callable[[], object], Callable[[], bool]]] = {
            "edit.copy": (self.copy, lambda: bool(self._keys.places)),
            "edit.cut": (self.cut, lambda: bool(self._keys.places)),
            "edit.paste": (self.paste, lambda: bool(self._copied)),
            "points.delete": (self.delete, lambda: True),
            "points.select_all": (self.select_all, lambda: True),
        }

        def chosen(action_id: str) -> Callable[[], object]:
            (mine, is_meant), other = own[action_id], handlers.get(action_id)

            def call() -> None:
                if other is None or (self._has_keyboard() and is_meant()):
                    mine()
                    return
                if action_id in ("edit.copy", "edit.cut"):
                    self._forget()
                other()

            return call

        def copy_here() -> None:
            self._forget()
            handlers["key.copy"]()

        here = {"key.copy": copy_here} if "key.copy" in handlers else {}
        return {action_id: chosen(action_id) for action_id in own} | here

    def _forget(self) -> None:
        """What was copied last is what is pasted; and shapes of another project may have the same ids."""
        self._copied = {}

    # ---- the verbs

    def copy(self) -> bool:
        """Remember the chosen keys; False when there is none."""
        project, places = self._document.project, self._keys.places
        if not places:
            self._view.say(tr(NO_KEYS))
            return False
        self._copied = {
            shape.id: tuple(key for key in shape.keys if (shape.id, key.frame) in places)
            for shape in project.shapes
            if self._keys.frames_of(shape.id)
        }
        self._view.say(tr("Copied {keys}: paste puts the first one on the playhead's frame.", keys=count_of(places)))
        return True

    def cut(self) -> None:
        """Remember the chosen keys and delete them."""
        if self.copy():
            self.delete(tr("Cut keys"))

    def paste(self) -> None:
        """Put the copied keys into their shapes, or into the selected ones (`_targets`); the first one here."""
        if not self._copied:
            self._view.say(tr(NOTHING_COPIED))
            return
        project, copied = self._document.project, self._targets()
        offset = self._view.frame - min(key.frame for keys in copied.values() for key in keys)
        pasted = timing.paste_keys(project, _inside(project, copied, offset), offset, self._copied)
        places = timing.artist_places(pasted) & {
            (shape_id, key.frame + offset) for shape_id, keys in copied.items() for key in keys
        }
        if pasted == project or not places:
            self._view.say(tr("The copied keys fit no shape here: shapes may be locked, or have other points."))
            return
        self._document.apply(tr("Paste keys"), pasted)
        self._keys.select(places)
        taking = {shape_id for shape_id, _ in places}
        if left_out := [shape.name for shape in project.shapes if shape.id in copied and shape.id not in taking]:
            self._view.say(tr(FITS_SOME, names=", ".join(left_out)))
        elif len(copied) > 1 and not self._copied.keys() & copied.keys():
            names = ", ".join(project.shape(shape_id).name for shape_id in copied)
            self._view.say(tr("Pasted into the selected shapes, in their order: {names}.", names=names))

    def delete(self, text: str = "") -> None:
        """Delete the chosen keys; the engine's stay, and are shown as stale. `text` names the step.

        A shape that would have no key left keeps its own, and that is said.
        """
        project, refused = without_keys(self._document.project, self._unlocked(self._keys.places))
        self._document.apply(text or tr("Delete keys"), project)
        if refused:
            self._view.say(refused)

    def nudge(self, frames: int, merge_key: str = "") -> None:
        """Move the chosen keys by some frames, not out of the clip; steps with one `merge_key` are one undo step."""
        if places := self._unlocked(self._keys.places):
            self._nudges.by(places, frames, merge_key)

    def interpolate(self, interpolation: Interpolation) -> None:
        """Set how shapes move on: from the chosen keys, or from the key before the playhead where none is chosen."""
        chosen = self._meant() or self._governing()
        if not chosen:
            self._view.say_here(tr(NONE_BEFORE) if self._view.selection.shapes else tr(NOTHING_HERE))
        elif places := self._unlocked(chosen):
            project = timing.set_interpolation(self._document.project, places, interpolation)
            self._document.apply(tr(WAYS[interpolation]), project)

    def select_all(self) -> None:
        """Choose every artist's key of the selected shapes, or of all where none is selected."""
        project, shapes = self._document.project, self._view.selection.shapes
        self._keys.select(
            frozenset(place for place in timing.artist_places(project) if not shapes or place[0] in shapes)
        )

    # ---- the rest is private

    def _unlocked(self, places: Iterable[Place]) -> frozenset[Place]:
        """The places of shapes that may be edited; says so where some are left out, and why when there is none."""
        wanted = frozenset(places)
        free = unlocked(self._document.project, wanted)
        if not free:
            self._view.say(tr("The shape is locked; unlock it to change its keys.") if wanted else tr(NO_KEYS))
        elif free != wanted:
            self._view.say(tr(LOCKED_STAYS))
        return free

    def _targets(self) -> dict[str, tuple[Keyframe, ...]]:
        """The copied keys by the shape that they go to.

        Those of one shape go to all that are selected; those of several to as many others that are, in their order,
        as in the viewer; else to their own.
        """
        selected = [shape.id for shape in selected_shapes(self._document.project, self._view.selection)]
        if len(self._copied) == 1 and selected:
            return dict.fromkeys(selected, next(iter(self._copied.values())))
        if len(self._copied) == len(selected) and not self._copied.keys() & set(selected):
            return dict(zip(selected, self._copied.values(), strict=True))
        return self._copied

    def _meant(self) -> frozenset[Place]:
        """The chosen keys; while the rows have not the keyboard, and shapes are selected, those of these shapes."""
        shapes = self._view.selection.shapes
        if not shapes or self._has_keyboard():
            return self._keys.places
        return frozenset(place for place in self._keys.places if place[0] in shapes)

    def _governing(self) -> frozenset[Place]:
        """The key at or before the playhead of each selected shape."""
        frame, places = self._view.frame, set()
        for shape in selected_shapes(self._document.project, self._view.selection):
            earlier = [key for key in shape.artist_frames if key <= frame]
            places |= {(shape.id, max(earlier))} if earlier else set()
        return frozenset(places)


def unlocked(project: Project, places: Iterable[Place]) -> frozenset[Place]:
    """Those places whose shapes are not locked, nor lie in a locked layer."""
    free = set(_unlocked_ids(project.root))
    return frozenset(place for place in places if place[0] in free)


def without_keys(project: Project, places: Iterable[Place]) -> tuple[Project, str]:
    """The project without the artist's keys at these places, and why the first shape that keeps its own does so."""
    refused, chosen = "", frozenset(places)
    for shape_id in sorted({shape_id for shape_id, _ in chosen}):
        try:
            project = timing.delete_keys(project, [place for place in chosen if place[0] == shape_id])
        except RoamError as error:
            refused = refused or sentence_of(error)
    return project, refused


def count_of(places: Iterable[object]) -> str:
    """`1 key`, `3 keys`."""
    number = len(list(places))
    return tr("%n key(s)", "", number)


def _unlocked_ids(layer: Layer) -> Iterable[str]:
    if layer.locked:
        return
    for child in layer.children:
        if isinstance(child, Layer):
            yield from _unlocked_ids(child)
        elif not child.locked:
            yield child.id


def _inside(
    project: Project, copied: Mapping[str, tuple[Keyframe, ...]], offset: int
) -> dict[str, tuple[Keyframe, ...]]:
    """Those keys that land inside the clip and on shapes that may be edited."""
    frames = None if project.clip is None else project.clip.frame_range
    free = unlocked(project, [(shape_id, 0) for shape_id in copied])
    return {
        shape_id: tuple(key for key in keys if frames is None or key.frame + offset in frames)
        for shape_id, keys in copied.items()
        if (shape_id, 0) in free
    }
