"""What is done to chosen keys of values and outlines: each one edit of the document, one undo step."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import partial
from typing import TypeVar

import numpy as np

from roam_core.errors import RoamError
from roam_core.roto import Interpolation, Keyframe, Project, RotoShape, ValueKey, timing
from roam_core.roto.layers import top_items
from roam_core.roto.value_curves import (
    ValuePlace,
    bend_values,
    copy_values,
    delete_values,
    interpolate_values,
    keys_at,
    move_values,
    paste_values,
    retime_values,
)

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS
from ...model.view_state import ViewState
from ...translation import N_, sentence_of, tr
from ..keys.nudging import Nudges
from ..keys.verbs import FITS_SOME, count_of, without_keys
from .selection import CopiedKeys, ValueSelection
from .shown import OUTLINES, Kind

NO_TANGENTS = N_("Outlines move straight, smoothly or not at all: opacity and feather have tangents.")
NOTHING_CHOSEN = N_("Choose keys of opacity or feather in the timeline or the curve editor first.")
FITS_NOTHING = N_("The copied keys fit nothing here: what they go to may be locked or gone.")
LOCKED = N_("It is locked; unlock it to change its keys.")

FORGETTING = frozenset({"edit.copy", "edit.cut", "key.copy"})
"""Actions that copy something else where they do not mean keys of values: what is pasted is what was copied last."""

K = TypeVar("K", ValueKey, Keyframe)


class ValueVerbs:
    """The verbs on chosen keys. `has_keyboard` tells whether value rows or curves have it: then delete means keys.

    `shown` gives the places of all keys that are seen there: what "all" means.
    """

    def __init__(
        self,
        document: Document,
        view_state: ViewState,
        chosen: ValueSelection,
        has_keyboard: Callable[[], bool],
        shown: Callable[[], frozenset[ValuePlace]],
    ) -> None:
        self._document, self._view, self._chosen = document, view_state, chosen
        self._has_keyboard, self._shown = has_keyboard, shown
        self.takes_paste: Callable[[], bool] = lambda: False
        """Whether what was copied is pasted, too, where the keyboard is now: a shape that never varied has no row."""
        self._nudges = Nudges(document, chosen, lambda project, places, frames: self.moved(project, places, frames, 0))

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {"key.tangents": self.bend}

    def taking_over(self, handlers: Mapping[str, Callable[[], object]]) -> dict[str, Callable[[], object]]:
        """Handlers that mean chosen keys of values while there are some, or while their rows have the keyboard.

        Where no key is chosen, or was copied, copying and pasting mean there what they mean elsewhere.
        """
        ways: dict[str, Callable[[], object]] = {
            f"key.{way.value}": partial(self.interpolate, way) for way in Interpolation
        }
        own = {"points.delete": self.delete, "points.select_all": self.select_all} | ways
        own |= {"edit.copy": self.copy, "edit.cut": self.cut, "edit.paste": self.paste}
        there_is = {
            "edit.copy": lambda: bool(self._chosen.places),
            "edit.cut": lambda: bool(self._chosen.places),
            "edit.paste": lambda: self._chosen.copied is not None,
        }

        def handler(action_id: str) -> Callable[[], object]:
            other = handlers[action_id]

            def call() -> None:
                is_meant = bool(self._chosen.places) if action_id in ways else self._has_keyboard()
                is_meant = is_meant or (action_id == "edit.paste" and self.takes_paste())
                if is_meant and action_id in own and there_is.get(action_id, lambda: True)():
                    own[action_id]()
                    return
                if action_id in FORGETTING:
                    self._chosen.forget()
                other()

            return call

        taken = own.keys() | FORGETTING
        return {action_id: handler(action_id) for action_id in taken if action_id in handlers}

    # ---- the verbs

    def moved(self, project: Project, places: Iterable[ValuePlace], frames: int, amount: float) -> Project:
        """The project with keys shifted in time, and by `amount` in value or, of outlines, in pixels along their axis.

        Of an outline the selected points move, or all where none is selected.
        """
        values, outlines = _parted(places)
        project = move_values(project, values, frames, amount)
        if outlines:
            project = timing.move_keys(project, {(item_id, frame) for item_id, _, frame in outlines}, frames)
        if outlines and amount:
            for kind in OUTLINES:
                shift = np.array([amount, 0.0] if kind is Kind.X else [0.0, amount])
                own = {(item_id, frame + frames) for item_id, name, frame in outlines if name == kind}
                project = timing.shift_keys(project, own, shift, self._points())
        return project

    def copied(self, project: Project, places: Iterable[ValuePlace], frames: int) -> Project:
        """The project with copies of keys, so many frames on."""
        values, outlines = _parted(places)
        keys = {(item_id, frame) for item_id, _, frame in outlines}
        return timing.copy_keys(copy_values(project, values, frames), keys, frames)

    def retimed(self, project: Project, places: Iterable[ValuePlace], goes: Mapping[int, int]) -> Project:
        """The project with keys on the frames that `goes` tells, by theirs."""
        values, outlines = _parted(places)
        keys = {(item_id, frame) for item_id, _, frame in outlines}
        return timing.retime_keys(retime_values(project, values, goes), keys, goes)

    def copy(self) -> None:
        """Remember the chosen keys."""
        project, places = self._document.project, self._chosen.places
        values, outlines = _parted(places)
        keys: dict[str, list[Keyframe]] = {}
        for shape_id, frame in sorted({(item_id, frame) for item_id, _, frame in outlines}):
            if (key := project.shape(shape_id).key_at(frame)) is not None:
                keys.setdefault(shape_id, []).append(key)
        self._chosen.copied = CopiedKeys(keys_at(project, values), keys, frozenset(kind for _, kind, _ in outlines))
        self._view.say(tr("Copied {keys}: paste puts the first one on the playhead's frame.", keys=count_of(places)))

    def cut(self) -> None:
        """Remember the chosen keys and delete them."""
        self.copy()
        self.delete(tr("Cut keys"))

    def paste(self) -> None:
        """Put the copied keys where they came from, or those of one shape or layer into the selected ones; the first
        one on the playhead's frame.
        """
        project, copied = self._document.project, self._chosen.copied
        if copied is None:
            return
        offset, goes_to = self._view.frame - min(copied.frames), self._targets(copied)
        values = {
            (item_id, name): _inside(project, keys, offset)
            for owner, item_id in goes_to
            for (own, name), keys in copied.values.items()
            if own == owner
        }
        outlines = {
            item_id: _inside(project, copied.outlines[owner], offset)
            for owner, item_id in goes_to
            if owner in copied.outlines and isinstance(project.find(item_id), RotoShape)
        }
        pasted = timing.paste_keys(paste_values(project, values, offset), outlines, offset, copied.outlines)
        if pasted == project:
            self._view.say(tr(FITS_NOTHING))
            return
        self._document.apply(tr("Paste keys"), pasted)
        put = {(item_id, name, key.frame + offset) for (item_id, name), keys in values.items() for key in keys}
        put |= {
            (item_id, kind, key.frame + offset)
            for item_id, keys in outlines.items()
            for kind in copied.curves
            for key in keys
        }
        self._chosen.select(self._chosen.places_in(pasted) & put)
        taking = {item_id for item_id, _, _ in self._chosen.places}
        if left_out := [project.find(item_id).name for _, item_id in self._wanted(copied) if item_id not in taking]:
            self._view.say(tr(FITS_SOME, names=", ".join(left_out)))

    def delete(self, text: str = "") -> None:
        """Delete the chosen keys; `text` names the step."""
        values, outlines = _parted(self._free())
        keys = {(item_id, frame) for item_id, _, frame in outlines}
        if values or keys:
            project, refused = without_keys(delete_values(self._document.project, values), keys)
            self._document.apply(text or tr("Delete keys"), project)
            if refused:
                self._view.say(refused)

    def nudge(self, frames: int, merge_key: str) -> None:
        """Move the chosen keys by some frames, not out of the clip; steps with one `merge_key` are one undo step."""
        if places := self._free():
            self._nudges.by(places, frames, merge_key)

    def raise_by(self, amount: float, merge_key: str) -> None:
        """Change the chosen keys by some amount of their value, as shown."""
        if places := self._free():
            project = self._document.project
            for kind in Kind:
                own = [place for place in places if place[1] == kind]
                project = self.moved(project, own, 0, amount / (100.0 if kind is Kind.OPACITY else 1.0))
            self._document.apply(tr("Change keys"), project, merge_key)

    def interpolate(self, interpolation: Interpolation) -> None:
        """Set how values and outlines go on from the chosen keys; values lose their tangents there."""
        values, outlines = _parted(self._free())
        keys = {(item_id, frame) for item_id, _, frame in outlines}

        def verb(project: Project) -> Project:
            return timing.set_interpolation(interpolate_values(project, values, interpolation), keys, interpolation)

        if values or keys:
            self._apply(tr(interpolation.value.capitalize()), verb)

    def bend(self) -> None:
        """Give the chosen keys tangents that run smoothly through them."""
        if not self._chosen.places:
            self._view.say(tr(NOTHING_CHOSEN))
            return
        values, outlines = _parted(self._free())
        if values:
            self._apply(tr("Tangents"), lambda project: bend_values(project, values))
        elif outlines:
            self._view.say(tr(NO_TANGENTS))

    def select_all(self) -> None:
        """Choose every key that is shown."""
        self._chosen.select(self._shown())

    # ---- the rest is private

    def _apply(self, text: str, verb: Callable[[Project], Project]) -> None:
        try:
            self._document.apply(text, verb(self._document.project))
        except RoamError as error:
            self._view.say(sentence_of(error))

    def _targets(self, copied: CopiedKeys) -> list[tuple[str, str]]:
        """Where copied keys go, after what they came from; without what is locked."""
        project, wanted = self._document.project, self._wanted(copied)
        return [(owner, item_id) for owner, item_id in wanted if not project.is_locked(item_id)]

    def _wanted(self, copied: CopiedKeys) -> list[tuple[str, str]]:
        """Where copied keys are to go, after what they came from; without what is gone."""
        project, owners = self._document.project, copied.owners
        chosen = top_items(project, self._view.layers | self._view.selection.shapes)
        around = {above.id for owner in owners if project.has(owner) for above in project.layers_above(owner)}
        goes_to = [(owner, owner) for owner in sorted(owners)]
        if len(owners) == 1 and chosen and not around & set(chosen):  # a layer is selected with the shapes in it
            goes_to = [(owner, item_id) for owner in owners for item_id in chosen]
        return [pair for pair in goes_to if project.has(pair[1])]

    def _free(self) -> frozenset[ValuePlace]:
        """The chosen keys that may be changed; says so where some are left out, and why when there is none."""
        free = unlocked(self._document.project, self._chosen.places)
        if not free:
            self._view.say(tr(LOCKED) if self._chosen.places else tr(NOTHING_CHOSEN))
        elif free != self._chosen.places:
            self._view.say(tr(LOCKED_STAYS))
        return free

    def _points(self) -> dict[str, frozenset[int]]:
        """The selected points by the id of their shape."""
        points: dict[str, set[int]] = {}
        for shape_id, index in self._view.selection.points:
            points.setdefault(shape_id, set()).add(index)
        return {shape_id: frozenset(own) for shape_id, own in points.items()}


def unlocked(project: Project, places: Iterable[ValuePlace]) -> frozenset[ValuePlace]:
    """The places of shapes and layers that are not locked, nor lie in a locked layer."""
    found = list(places)
    free = {
        item_id for item_id in {place[0] for place in found} if project.has(item_id) and not project.is_locked(item_id)
    }
    return frozenset(place for place in found if place[0] in free)


def _inside(project: Project, keys: Sequence[K], offset: int) -> list[K]:
    """Those keys that land inside the clip."""
    frames = None if project.clip is None else project.clip.frame_range
    return [key for key in keys if frames is None or key.frame + offset in frames]


def _parted(places: Iterable[ValuePlace]) -> tuple[list[ValuePlace], list[ValuePlace]]:
    """Keys of values, and of outlines."""
    values: list[ValuePlace] = []
    outlines: list[ValuePlace] = []
    for place in places:
        (outlines if place[1] in OUTLINES else values).append(place)
    return values, outlines
