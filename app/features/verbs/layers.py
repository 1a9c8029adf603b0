"""What menus and keys do to layers: grouping, dissolving, adding; and to the order in which they and shapes lie."""

from __future__ import annotations

from collections.abc import Callable

from roam_core.roto import BlendMode, Layer, RotoShape, edit
from roam_core.roto.layers import grouped, raised, ungrouped

from ...model.document import Document
from ...model.reasons import outdated_by
from ...model.view_state import ViewState
from ...translation import N_, tr
from .shapes import NOTHING_SELECTED, rows_in_hand

NO_LAYER = N_("Select a layer first: click it in the list of shapes.")


class LayerVerbs:
    """The verbs on the selected layers. What cannot be done is said in the status bar."""

    def __init__(self, document: Document, view_state: ViewState) -> None:
        self._document, self._view = document, view_state

    def handlers(self) -> dict[str, Callable[[], object]]:
        """What the actions of this part call, by id."""
        return {
            "shape.group": self.group,
            "layer.ungroup": self.ungroup,
            "layer.add": self.add,
            "shape.raise": lambda: self.restack(1),
            "shape.lower": lambda: self.restack(-1),
        }

    def group(self) -> None:
        """Put the selected layers and shapes into a new layer, which is then selected."""
        chosen = self._view.selection.shapes | self._layers()
        if not chosen:
            self._view.say_here(tr(NOTHING_SELECTED))
            return
        project, layer = grouped(self._document.project, chosen)
        outdated = outdated_by(self._document.project, project)  # what lies between them lies below them now
        self._document.apply(tr("Group"), project)
        self._view.select(self._view.selection.shapes, layers=frozenset({layer.id}))
        if outdated:
            self._view.say(outdated)

    def ungroup(self) -> None:
        """Dissolve the selected layers, or those that hold the selected shapes; the shapes stay selected."""
        project = self._document.project
        layers = self._layers() or {
            project.layers_above(shape_id)[-1].id for shape_id in self._view.selection.shapes
        } - {project.root.id}
        if not layers:
            self._view.say_here(tr(NO_LAYER))
            return
        ordered = sorted(layers, key=lambda layer_id: len(project.layers_above(layer_id)))
        lost = [word for layer_id in ordered if (word := _lost_with(project.find(layer_id)))]
        for layer_id in ordered:
            project = ungrouped(project, layer_id)
        self._document.apply(tr("Ungroup"), project)
        if lost:
            self._view.say(tr("Gone with what was dissolved: {what}.", what="; ".join(lost)))

    def add(self) -> None:
        """Add an empty layer on top, or inside the selected one."""
        project, inside = self._document.project, sorted(self._layers())
        project, layer = edit.add_layer(project, parent_id=inside[0] if len(inside) == 1 else project.root.id)
        self._document.apply(tr("New layer"), project)
        self._view.select(frozenset(), layers=frozenset({layer.id}))

    def restack(self, step: int) -> None:
        """Put the selected layers and shapes one place higher (1) or lower (-1) in what holds them."""
        project, rows = self._document.project, rows_in_hand(self._document.project, self._view)
        after = raised(project, rows, step)
        if not rows:
            self._view.say_here(tr(NOTHING_SELECTED))
        elif after == project:
            self._view.say_here(tr("It lies on top already.") if step > 0 else tr("It lies at the bottom already."))
        outdated = outdated_by(project, after)
        self._document.apply(tr("Restack"), after)
        if outdated:
            self._view.say(outdated)

    def _layers(self) -> frozenset[str]:
        """The selected layers that are still there."""
        there = {item.id for item in self._document.project.root.items() if isinstance(item, Layer)}
        return self._view.layers & there


def _lost_with(layer: Layer | RotoShape) -> str:
    """What of a layer's own look nothing holds any more once it is dissolved, after its name; empty where it had none.

    Its motion, and whether it is hidden or locked, what lay in it has by itself.
    """
    assert isinstance(layer, Layer)
    looks = [
        tr("Opacity") if layer.opacity != 1.0 else "",
        tr("Invert") if layer.invert else "",
        tr("Blend") if layer.blend is not BlendMode.ADD else "",
    ]
    words = ", ".join(filter(None, looks))
    return f"{layer.name} ({words})" if words else ""
