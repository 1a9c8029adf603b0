"""What is keyed of the shapes and layers in hand: their values, and where their outlines are."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from enum import StrEnum

from roam_core.roto import Animated, Layer, Project, RotoShape
from roam_core.roto.value_curves import values_of_item

from ...model.view_state import ViewState
from ...translation import N_, tr

LAYER_COLOUR = (0.72, 0.72, 0.72)


class Kind(StrEnum):
    """What a curve shows: a value, or where the outline or its selected points are, in pixels of the picture."""

    OPACITY = "opacity"
    FEATHER = "feather"
    X = "x"
    Y = "y"


KINDS = {Kind.OPACITY: N_("opacity"), Kind.FEATHER: N_("feather"), Kind.X: N_("x"), Kind.Y: N_("y")}
"""What a curve shows, within a sentence."""
OUTLINES = (Kind.X, Kind.Y)
"""Kinds whose keys are those of outlines."""
SHOWN_AS: Mapping[Kind, tuple[float, str]] = {
    Kind.OPACITY: (100.0, "%"), Kind.FEATHER: (1.0, "px"), Kind.X: (1.0, "px"), Kind.Y: (1.0, "px"),
}  # fmt: skip
"""By what a value is multiplied to be shown, and its unit then."""


@dataclass(frozen=True)
class KeyedValue:
    """A value that varies with time, of a shape or layer."""

    item: Layer | RotoShape
    kind: Kind
    value: Animated

    @property
    def name(self) -> str:
        """What is called so in the language of the window."""
        return tr(KINDS[self.kind])

    @property
    def title(self) -> str:
        return f"{self.item.name}: {self.name}"


def items_in_hand(project: Project, view: ViewState) -> list[Layer | RotoShape]:
    """The selected layers and shapes, or all where nothing is selected; the top-most first, in plate space."""
    chosen = view.layers | view.selection.shapes
    seen = {shape.id: shape for shape in project.shapes}
    items = [seen.get(item.id, item) for item in project.root.items()]
    return [item for item in reversed(items) if item.id in chosen or not chosen]


def keyed_values(project: Project, view: ViewState) -> list[KeyedValue]:
    """What varies with time of the shapes and layers in hand."""
    return [
        KeyedValue(item, Kind(name), value)
        for item in items_in_hand(project, view)
        for name, value in values_of_item(item).items()
        if isinstance(value, Animated)
    ]


def colour_of(item: Layer | RotoShape) -> tuple[float, float, float]:
    """In which a curve of it is drawn."""
    return item.colour if isinstance(item, RotoShape) else LAYER_COLOUR
