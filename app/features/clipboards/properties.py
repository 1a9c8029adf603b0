"""Paste of the properties alone of what was copied: onto the shapes, or layers, that are selected."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from PySide6.QtGui import QGuiApplication

from roam_core.errors import RoamError
from roam_core.roto import Layer, Project, RotoShape, file
from roam_core.roto.animated import frames_of
from roam_core.roto.layers import Item
from roam_core.roto.pasting import MATTE_PROPERTIES, PROPERTIES, models, with_properties

from ...model.document import Document
from ...model.reasons import LOCKED_STAYS, outdated_by_blend
from ...model.view_state import ViewState, selected_shapes
from ...translation import N_, tr
from ..verbs.shapes import ALL_LOCKED, NOTHING_SELECTED

LABELS = {
    "colour": N_("Colour"),
    "blend": N_("Blend"),
    "opacity": N_("Opacity"),
    "feather": N_("Feather"),
    "invert": N_("Invert"),
    "motion_blur": N_("Motion blur"),
}
"""What the Shape panel calls them."""

OF_SEVERAL = N_("What was copied differs in its properties: copy one shape, or select as many.")


class PropertyClipboard:
    """The verbs that paste properties. What was copied is what Paste would put in: whole shapes and layers."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "edit.paste_properties": partial(self.paste, PROPERTIES, N_("Paste all properties")),
            "edit.paste_matte_properties": partial(self.paste, MATTE_PROPERTIES, N_("Paste matte properties")),
            "edit.paste_colour": partial(self.paste, ("colour",), N_("Paste colour")),
        }

    def paste(self, names: Sequence[str], text: str) -> None:
        """Give what is selected the properties `names` of what was copied, but for what is locked; says what changed.

        Those of shapes go to shapes, also to those in selected layers; those of layers to layers.
        """
        copied = _copied()
        if not copied:
            self._view.say(tr("There is no shape whose properties could be pasted; copy one first."))
            return
        project = self._document.project
        chosen = [item for item in self._chosen(copied) if any(hasattr(item, name) for name in names)]
        free = [item for item in chosen if not project.is_locked(item.id)]
        if not free:
            self._view.say_here(tr(ALL_LOCKED) if chosen else self._why_none(names))
            return
        given = models(_shapes(copied), _shapes(chosen), names) | models(_layers(copied), _layers(chosen), names)
        put = [(item, with_properties(item, given[item.id], names)) for item in free if item.id in given]
        after = project.with_shapes(_shapes([new for _, new in put]))
        for layer in _layers([old for old, _ in put]):
            after = after.map_item(layer.id, partial(with_properties, model=given[layer.id], names=names))
        self._document.apply(tr(text), after)
        told = (
            _what_changed(put) if put else "",
            tr(LOCKED_STAYS) if len(free) < len(chosen) else "",
            tr(OF_SEVERAL) if len(given) < len(chosen) else "",
            _keys_beside(project, list(given.values()), names),
            outdated_by_blend(project, after),
        )
        self._view.say(" ".join(filter(None, told)))

    def _chosen(self, copied: Sequence[Item]) -> list[Item]:
        """What is selected of the kinds that were copied; shapes of a layer that takes its own are left alone."""
        project, view = self._document.project, self._view
        shapes: list[Item] = list(selected_shapes(project, view.selection)) if _shapes(copied) else []
        if not _layers(copied):
            return shapes
        layers = [item for item in project.root.items() if item.id in view.layers]
        return [s for s in shapes if not any(layer.id in view.layers for layer in project.layers_above(s.id))] + layers

    def _why_none(self, names: Sequence[str]) -> str:
        if self._view.layers and not any(hasattr(self._document.project.root, name) for name in names):
            return tr("A layer has no colour of its own: copy a shape, and select shapes.")
        if self._view.selection.shapes:
            return tr("A layer was copied, and its properties go to layers: select one, or copy a shape.")
        return tr(NOTHING_SELECTED)


def _copied() -> Sequence[Item]:
    """The layers and shapes that the clipboard holds, bottom first."""
    try:
        return file.loads(QGuiApplication.clipboard().text(), Path(), tr("the clipboard")).root.children
    except RoamError:
        return ()


def _shapes(items: Sequence[Item]) -> list[RotoShape]:
    return [item for item in items if isinstance(item, RotoShape)]


def _layers(items: Sequence[Item]) -> list[Layer]:
    return [item for item in items if isinstance(item, Layer)]


def _what_changed(pairs: Sequence[tuple[Item, Item]]) -> str:
    """What each was and is now: how many changed, and in what."""
    changed = [(old, new) for old, new in pairs if old != new]
    if not changed:
        return tr("Nothing changed: what is selected has these properties already.")
    layers = sum(isinstance(item, Layer) for item, _ in changed)
    shapes = len(changed) - layers
    counted = (tr("%n layer(s)", "", layers), layers), (tr("%n shape(s)", "", shapes), shapes)
    labels = [
        tr(label)
        for name, label in LABELS.items()
        if any(getattr(old, name, None) != getattr(new, name, None) for old, new in changed)
    ]
    return tr(
        "Pasted onto {items}: {properties}.",
        items=", ".join(words for words, number in counted if number),
        properties=", ".join(labels),
    )


def _keys_beside(project: Project, pasted: Sequence[Item], names: Sequence[str]) -> str:
    """A sentence where values that vary have no key on the clip: they were copied in another shot."""
    clip = project.clip
    frames = [frame for item in pasted for name in names for frame in frames_of(getattr(item, name, 0.0))]
    if clip is None or not frames or any(frame in clip.frame_range for frame in frames):
        return ""
    return tr(
        "Their keys lie on frames {low} to {high}, none of them on the clip's {first} to {last}: nothing varies here.",
        low=min(frames),
        high=max(frames),
        first=clip.first,
        last=clip.last,
    )
