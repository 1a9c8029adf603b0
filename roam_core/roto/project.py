"""Project, Layer and Clip: what a `.roam` file holds, as one immutable value."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from pathlib import Path
from typing import TYPE_CHECKING, Any

from roam_core.arguments import shown
from roam_core.errors import RoamError
from roam_core.media.content import content_of
from roam_core.media.layers import PLAIN
from roam_core.roto.animated import Animatable, checked, share_at
from roam_core.roto.free_names import counted_on, next_id
from roam_core.roto.keyframe import Keyframe
from roam_core.roto.placement import LayerTransform, Placement
from roam_core.roto.shape import BlendMode, RotoShape, placed, stored_before, unplaced
from roam_core.translatable import sentence

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
    both inclusive (frames may be missing between them); `size` is (width, height). `content` tells the plate from
    others of its name (`roam_core.media.content`); "" where it is not known. `layer` is the one of the files' layers
    (`roam_core.media.layers`) that is the plate; "" for plain red, green and blue.
    """

    path: Path
    first: int
    last: int
    size: tuple[int, int]
    fps: float = 24.0
    pixel_aspect: float = 1.0
    colour_space: str = "sRGB"
    content: str = ""
    layer: str = ""
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "path", Path(self.path))

    @classmethod
    def of(cls, source: PlateSource) -> Clip:
        """The reference to a plate that is open.

        Raises
        ------
        ValueError
            when it is none.
        """
        if not hasattr(source, "frames"):
            raise ValueError(f"a Clip is that of an open plate, as open_clip gives it, not of {shown(source)}")
        return cls(
            path=source.path,
            first=source.frames[0],
            last=source.frames[-1],
            size=source.size,
            fps=source.fps,
            pixel_aspect=source.pixel_aspect,
            colour_space=source.colour_space,
            content=content_of(source),
            layer="" if source.layer == PLAIN else source.layer,
        )

    @property
    def name(self) -> str:
        """The last part of its path."""
        return self.path.name

    @property
    def frame_range(self) -> range:
        """All frames from the first to the last, those that are missing too."""
        return range(self.first, self.last + 1)


@dataclass(frozen=True)
class Mark:
    """A frame that the artist marked on the timeline, with a word on it where there is one."""

    frame: int
    text: str = ""
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)


@dataclass(frozen=True)
class Layer:
    """A group of shapes and layers in the order of compositing: the first lies at the bottom.

    Its children are joined in it, inverted where it says so, scaled by its `opacity`, and joined with what lies under
    it by its `blend`. `transform` moves all that lies in it; None leaves it where it is. The keys of its shapes are in
    layer space.
    """

    id: str
    name: str
    children: tuple[Layer | RotoShape, ...] = ()
    visible: bool = True
    locked: bool = False
    opacity: Animatable = 1.0
    invert: bool = False
    blend: BlendMode = BlendMode.ADD
    transform: LayerTransform | None = None
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "opacity", checked(self.opacity, f"the opacity of {self.name!r}"))
        object.__setattr__(self, "children", tuple(self.children))
        if not isinstance(self.blend, BlendMode):
            object.__setattr__(self, "blend", BlendMode(self.blend))

    def opacity_at(self, frame: float) -> float:
        """The opacity of its joint matte at `frame`, in [0, 1]."""
        return share_at(self.opacity, frame)

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

    def in_plate_space(self, above: Placement = ()) -> Layer:
        """The layer without transforms, its shapes placed where they and the layers `above` it put them."""
        placement = above if self.transform is None else (*above, self.transform)
        children = tuple(
            child.in_plate_space(placement) if isinstance(child, Layer) else placed(child, placement)
            for child in self.children
        )
        if self.transform is None and all(a is b for a, b in zip(children, self.children, strict=True)):
            return self
        return replace(self, children=children, transform=None)


ROOT = Layer("root", "Root")


@dataclass(frozen=True)
class Project:
    """One immutable value: the clip, the tree of layers and shapes. Every edit is a function to a new one.

    `root` holds shapes as they lie in their layers. `shapes`, `shape` and `plate_root` give them in plate space, and
    `with_shape` takes them in plate space: whoever looks at shapes or edits them knows nothing of moving layers.
    """

    clip: Clip | None = None
    root: Layer = ROOT
    marks: tuple[Mark, ...] = ()
    extra: Mapping[str, Any] = field(default_factory=dict, hash=False)

    @cached_property
    def plate_root(self) -> Layer:
        """The tree with every shape in plate space and no transforms."""
        return self.root.in_plate_space()

    @cached_property
    def shapes(self) -> tuple[RotoShape, ...]:
        """All shapes in the order of compositing, bottom first, in plate space."""
        return tuple(self.plate_root.shapes())

    def find(self, item_id: str) -> Layer | RotoShape:
        """The layer or shape with this id."""
        return self._found[item_id][0]

    def shape(self, shape_id: str) -> RotoShape:
        """The shape with this id, in plate space."""
        return self._shapes_by_id[shape_id]

    @cached_property
    def _shapes_by_id(self) -> dict[str, RotoShape]:
        return {shape.id: shape for shape in reversed(self.shapes)}  # the lowest of those that share one

    def layers_above(self, item_id: str) -> tuple[Layer, ...]:
        """The layers that an item lies in, the root first; of the root itself none."""
        return self._found[item_id][1]

    @cached_property
    def _found(self) -> dict[str, tuple[Layer | RotoShape, tuple[Layer, ...]]]:
        """By its id each item, and the layers that it lies in: commands ask for hundreds, one by one."""
        found: dict[str, tuple[Layer | RotoShape, tuple[Layer, ...]]] = {self.root.id: (self.root, ())}
        for item, above in _with_layers(self.root, ()):
            found.setdefault(item.id, (item, above))
        return found

    def is_locked(self, item_id: str) -> bool:
        """Whether a layer or a shape is locked, or lies in a layer that is."""
        return any(item.locked for item in (self.find(item_id), *self.layers_above(item_id)))

    def holds_locked(self, item_id: str) -> bool:
        """Whether a layer or a shape is locked, or a layer holds something that is."""
        item = self.find(item_id)
        inside = item.items() if isinstance(item, Layer) else ()
        return self.is_locked(item_id) or any(each.locked for each in inside)

    def placement_in(self, layer_id: str) -> Placement:
        """The transforms that move what lies in a layer, the outermost first."""
        layers = (*self.layers_above(layer_id), self.find(layer_id))
        return tuple(layer.transform for layer in layers if isinstance(layer, Layer) and layer.transform is not None)

    def stored(self, shape: RotoShape, layer_id: str) -> RotoShape:
        """A shape in plate space as a layer holds it.

        Keys that the layer's shape of the same id holds already come back bit by bit, and the points of those that an
        edit changed in all but their points.
        """
        placement = self.placement_in(layer_id)
        if not placement:
            return replace(shape, placement=()) if shape.placement else shape
        kept: dict[int, Keyframe] = {}
        if self.has(shape.id):
            held = self.find(shape.id)
            assert isinstance(held, RotoShape)
            known = dict(zip(held.frames, zip(placed(held, placement).keys, held.keys, strict=True), strict=True))
            kept = {k.frame: own for k in shape.keys if (own := stored_before(k, *known.get(k.frame, (None, None))))}
        taken = dict(kept)
        if fresh := [key for key in shape.keys if key.frame not in kept]:
            taken |= {key.frame: key for key in unplaced(replace(shape, keys=tuple(fresh), placement=placement)).keys}
        return replace(shape, keys=tuple(taken[key.frame] for key in shape.keys), placement=())

    def has(self, item_id: str) -> bool:
        """True when a layer or shape has this id."""
        return item_id in self._found and item_id != self.root.id

    def free_id(self, kind: str) -> str:
        """The next unused id of a kind: `shape-1`, `layer-3`. Deterministic, so that equal work gives equal files."""
        return next_id(kind, {item.id for item in self.root.items()})

    def free_name(self, stem: str) -> str:
        """`stem 1`, `stem 2`, ...: the first that no shape or layer bears."""
        return counted_on(f"{stem} 1", {item.name for item in self.root.items()})

    def free_colour(self, after: int = 0) -> tuple[float, float, float]:
        """The palette's colour in turn for the next shape, or for one that comes `after` so many more."""
        return PALETTE[(len(self.shapes) + after) % len(PALETTE)]

    def with_shape(self, shape: RotoShape) -> Project:
        """The project with `shape`, in plate space, in place of the one of the same id."""
        return self.with_shapes((shape,))

    def with_shapes(self, shapes: Iterable[RotoShape]) -> Project:
        """The project with each of `shapes`, in plate space, in place of the one of the same id."""
        return self.with_held(self.stored(shape, self.layers_above(shape.id)[-1].id) for shape in shapes)

    def with_held(self, shapes: Iterable[RotoShape]) -> Project:
        """The project with each of `shapes`, as their layers hold them, in place of the one of the same id."""
        held = {shape.id: shape for shape in shapes}
        return replace(self, root=_with_items(self.root, held)) if held else self

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
            raise RoamError(sentence("The project has no clip yet; open a folder of images or a movie first."))
        return self.clip


def _with_layers(layer: Layer, above: tuple[Layer, ...]) -> Iterator[tuple[Layer | RotoShape, tuple[Layer, ...]]]:
    """What lies in a layer that lies in those `above` it, parents before children, each with the layers around it."""
    around = (*above, layer)
    for child in layer.children:
        yield child, around
        if isinstance(child, Layer):
            yield from _with_layers(child, around)


def _with_items(layer: Layer, items: dict[str, RotoShape]) -> Layer:
    """The layer with these shapes, which are taken out of `items`, in place of the lowest of their ids.

    A layer without any of them is the very same.
    """
    children = tuple(
        _with_items(child, items) if isinstance(child, Layer) else items.pop(child.id, child)
        for child in layer.children
    )
    if all(a is b for a, b in zip(children, layer.children, strict=True)):
        return layer
    return replace(layer, children=children)


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
