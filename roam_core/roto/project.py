"""Project, Layer and Clip: what a `.roam` file holds, as one immutable value."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roam_core.errors import RoamError
from roam_core.roto.shape import RotoShape

if TYPE_CHECKING:
    from roam_core.media.source import PlateSource

PALETTE: tuple[tuple[float, float, float], ...] = (
    (0.90, 0.62, 0.00),
    (0.34, 0.71, 0.91),
    (0.00, 0.62, 0.45),
    (0.94, 0.89, 0.26),
    (0.00, 0.45, 0.70),
    (0.84, 0.37, 0.00),
    (0.80, 0.47, 0.65),
    (0.85, 0.85, 0.85),
)
"""Eight outline colours that stay apart for colour-blind eyes (Okabe and Ito)."""


@dataclass(frozen=True)
class Clip:
    """A reference to the plate: where it lies and what it is.

    `path` is a folder, a pattern (`plate.%04d.exr`) or a movie; `first` and `last` are the plate's own frame numbers,
    both inclusive (frames may be missing between them); `size` is (width, height).
    """

    path: Path
    first: int
    last: int
    size: tuple[int, int]
    fps: float = 24.0
    pixel_aspect: float = 1.0
    colour_space: str = "sRGB"
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    @classmethod
    def of(cls, source: PlateSource) -> Clip:
        """The reference to a plate that is open."""
        return cls(
            path=source.path,
            first=source.frames[0],
            last=source.frames[-1],
            size=source.size,
            fps=source.fps,
            pixel_aspect=source.pixel_aspect,
            colour_space=source.colour_space,
        )

    @property
    def name(self) -> str:
        return self.path.name

    @property
    def frame_range(self) -> range:
        return range(self.first, self.last + 1)


@dataclass(frozen=True)
class Mark:
    """A frame that the artist marked on the timeline, with a word on it where there is one."""

    frame: int
    text: str = ""


@dataclass(frozen=True)
class Layer:
    """A group of shapes and layers in the order of compositing: the first lies at the bottom."""

    id: str
    name: str
    children: tuple[Layer | RotoShape, ...] = ()
    visible: bool = True
    locked: bool = False
    opacity: float = 1.0
    invert: bool = False
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def shapes(self) -> Iterator[RotoShape]:
        """All shapes below this layer, bottom first."""
        for child in self.children:
            if isinstance(child, RotoShape):
                yield child
            else:
                yield from child.shapes()

    def items(self) -> Iterator[Layer | RotoShape]:
        """This layer's descendants, parents before children."""
        for child in self.children:
            yield child
            if isinstance(child, Layer):
                yield from child.items()


ROOT = Layer("root", "Root")


@dataclass(frozen=True)
class Project:
    """One immutable value: the clip, the tree of layers and shapes. Every edit is a function to a new one."""

    clip: Clip | None = None
    root: Layer = ROOT
    marks: tuple[Mark, ...] = ()
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    @property
    def shapes(self) -> tuple[RotoShape, ...]:
        """All shapes in the order of compositing, bottom first."""
        return tuple(self.root.shapes())

    def find(self, item_id: str) -> Layer | RotoShape:
        """The layer or shape with this id."""
        if item_id == self.root.id:
            return self.root
        for item in self.root.items():
            if item.id == item_id:
                return item
        raise KeyError(item_id)

    def shape(self, shape_id: str) -> RotoShape:
        """The shape with this id."""
        item = self.find(shape_id)
        if not isinstance(item, RotoShape):
            raise KeyError(shape_id)
        return item

    def has(self, item_id: str) -> bool:
        return any(item.id == item_id for item in self.root.items())

    def free_id(self, kind: str) -> str:
        """The next unused id of a kind: `shape-1`, `layer-3`. Deterministic, so that equal work gives equal files."""
        taken = {item.id for item in self.root.items()}
        number = 1 + sum(item_id.startswith(f"{kind}-") for item_id in taken)
        while f"{kind}-{number}" in taken:
            number += 1
        return f"{kind}-{number}"

    def free_name(self, stem: str) -> str:
        """`stem 1`, `stem 2`, ...: the first that no shape or layer bears."""
        taken = {item.name for item in self.root.items()}
        number = 1
        while f"{stem} {number}" in taken:
            number += 1
        return f"{stem} {number}"

    def with_shape(self, shape: RotoShape) -> Project:
        """The project with `shape` in place of the one of the same id."""
        return self.map_item(shape.id, lambda _: shape)

    def map_item(self, item_id: str, function: Callable[[Any], Layer | RotoShape]) -> Project:
        """The project with the layer or shape `item_id` replaced by `function(item)`."""
        if item_id == self.root.id:
            root = function(self.root)
            assert isinstance(root, Layer)
            return replace(self, root=root)
        root, found = _map_item(self.root, item_id, function)
        if not found:
            raise KeyError(item_id)
        return replace(self, root=root)

    def require_clip(self) -> Clip:
        """The clip, or a sentence that there is none."""
        if self.clip is None:
            raise RoamError("The project has no clip yet; open a folder of images or a movie first.")
        return self.clip


def _map_item(layer: Layer, item_id: str, function: Callable[[Any], Layer | RotoShape]) -> tuple[Layer, bool]:
    for index, child in enumerate(layer.children):
        if child.id == item_id:
            replacement: Layer | RotoShape = function(child)
        elif isinstance(child, Layer):
            replacement, found = _map_item(child, item_id, function)
            if not found:
                continue
        else:
            continue
        children = (*layer.children[:index], replacement, *layer.children[index + 1 :])
        return replace(layer, children=children), True
    return layer, False
