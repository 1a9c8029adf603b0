"""Solo: the layers and shapes that alone are shown for a while. Never saved, never undone; exports do not know it."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from PySide6.QtCore import QObject, Signal

from roam_core.roto import Layer, Project, RotoShape
from roam_core.roto.layers import top_items

from ..translation import tr

MOST_NAMES = 3
"""Of what is soloed, told by their names."""


class Solo(QObject):
    """The ids that are soloed; nothing is where there are none. `changed` carries nothing: listeners pull."""

    changed = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._ids = self._chosen = self._known = frozenset[str]()
        self._seen: list[tuple[Project, Project]] = []

    @property
    def ids(self) -> frozenset[str]:
        """The soloed layers, with all that lies in them, and shapes."""
        return self._ids

    def set(self, ids: Iterable[str], project: Project) -> None:
        """Solo these of the project, and nothing else; none ends it."""
        self._chosen, self._known = frozenset(ids), _all_ids(project)
        self._show(self._chosen)

    def follow(self, project: Project) -> None:
        """The project was edited: what is new is soloed, too, or it would vanish as it is drawn.

        With the last that is soloed it ends; what an undo brings back is as it was.
        """
        if not self._chosen:
            return
        there = _all_ids(project)
        if self._ids:
            self._chosen |= there - self._known
        self._known |= there
        self._show(self._chosen & there)

    def _show(self, ids: frozenset[str]) -> None:
        if ids != self._ids:
            self._ids = ids
            self._seen.clear()
            self.changed.emit()

    def told(self, project: Project) -> str:
        """The names of what is soloed; of more than a few their number; empty where nothing is."""
        names = [project.find(item_id).name for item_id in top_items(project, self._ids) if project.has(item_id)]
        return ", ".join(names) if len(names) <= MOST_NAMES else tr("{count} shapes and layers", count=len(names))

    def seen(self, project: Project) -> Project:
        """The project as it is shown: what is not soloed is hidden. The same one for the same project."""
        if not self._ids:
            return project
        for whole, seen in self._seen:
            if whole is project:
                return seen
        seen = replace(project, root=_only(project.root, self._ids))
        self._seen = [*self._seen[-1:], (project, seen)]  # the document's, and that of a drag
        return seen

    def left_out(self, project: Project) -> frozenset[str]:
        """The shapes that are out of sight for it, by their ids; hidden ones among what is soloed are not."""
        if not self._ids:
            return frozenset()
        soloed = [project.find(item_id) for item_id in self._ids if project.has(item_id)]
        kept = {shape.id for item in soloed for shape in (item.shapes() if isinstance(item, Layer) else [item])}
        return frozenset(shape.id for shape in project.shapes if shape.id not in kept)


def _all_ids(project: Project) -> frozenset[str]:
    return frozenset(item.id for item in project.root.items())


def _only(layer: Layer, ids: frozenset[str]) -> Layer:
    """The layer with all in it hidden that is not soloed, and holds nothing that is."""
    children = list[Layer | RotoShape]()
    for child in layer.children:
        if child.id in ids:
            children.append(child)
        elif isinstance(child, Layer) and any(item.id in ids for item in child.items()):
            children.append(_only(child, ids))
        else:
            children.append(_hidden(child))
    return replace(layer, children=tuple(children))


def _hidden(item: Layer | RotoShape) -> Layer | RotoShape:
    """The item hidden, with all that lies in it."""
    if isinstance(item, Layer):
        item = replace(item, children=tuple(_hidden(child) for child in item.children))
    return replace(item, visible=False)
