"""Layers of shapes as one list of shapes, for programs whose masks know no layers."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace

from roam_core.interchange.stilled import stilled
from roam_core.roto import BlendMode, Interpolation, Keyframe, Layer, Project, RotoShape
from roam_core.roto.animated import product

SCALED_BY_OPACITY = {BlendMode.ADD, BlendMode.DIFFERENCE, BlendMode.MAX}
"""Scaling these shapes scales what their layer adds alike; the others act on what is scaled already."""


@dataclass
class Flattening:
    """The shapes of a project one after the other, and what that order cannot say.

    Attributes
    ----------
    program : as sentences call it.
    shapes : in the order of compositing, bottom first; opacity, lock and visibility of their layers are folded into
        them.
    notes : one sentence for each layer whose joint matte its shapes cannot build one by one.
    """

    program: str
    shapes: list[RotoShape] = field(default_factory=list)
    notes: list[str] = field(default_factory=list)

    def add(self, layer: Layer) -> None:
        """Append the shapes of a layer and of the layers in it."""
        self._note_losses(layer)
        for child in layer.children:
            visible, locked = child.visible and layer.visible, child.locked or layer.locked
            if isinstance(child, Layer):
                self.add(replace(child, visible=visible, locked=locked, opacity=product(child.opacity, layer.opacity)))
                continue
            share = layer.opacity if child.blend in SCALED_BY_OPACITY else 1.0
            self.shapes.append(replace(child, visible=visible, locked=locked, opacity=product(child.opacity, share)))

    def _note_losses(self, layer: Layer) -> None:
        """A layer joins its shapes first and is added then: alike only above nothing, or where all are added anyway."""
        shown = [shape for shape in layer.shapes() if shape.visible]
        if layer.invert:
            self.notes.append(f"{self.program} has no layers of masks: {layer.name!r} is not inverted there.")
        is_plain = all(shape.blend is BlendMode.ADD for shape in shown)
        lies_lowest = not any(shape.visible for shape in self.shapes)
        if layer.visible and len(shown) > 1 and (layer.opacity != 1.0 or not (is_plain or lies_lowest)):
            self.notes.append(
                f"{self.program} has no layers of masks: the shapes of {layer.name!r} join what lies under them one by "
                "one there, so their joint matte may differ."
            )


def flattened(project: Project, program: str) -> Flattening:
    """The project's shapes as one list, for a program of that name."""
    project = stilled(project)
    flat = Flattening(program)
    flat.add(project.root)
    return flat


def without_holds(shape: RotoShape) -> RotoShape:
    """The shape with the key of each HOLD once more on the last frame before the next key, for programs that move
    linearly from every key: on whole frames they then show what ROAM shows."""
    return replace(shape, keys=tuple(_moving_keys(shape)))


def _moving_keys(shape: RotoShape) -> Iterator[Keyframe]:
    for key, following in zip(shape.keys, (*shape.keys[1:], None), strict=True):
        if key.interpolation is not Interpolation.HOLD:
            yield key
            continue
        yield replace(key, interpolation=Interpolation.LINEAR)
        if following is not None and following.frame - key.frame > 1:
            yield replace(key, frame=following.frame - 1, interpolation=Interpolation.LINEAR)


def lifetime_steps(shape: RotoShape) -> list[tuple[int, bool]]:
    """Frames from which a shape with a lifetime is there or not; a shape that lives always gives none."""
    if shape.lifetime is None:
        return []
    start, stop = shape.lifetime
    return [(start - 1, False), (start, True), (stop, False)]


def opacity_steps(shape: RotoShape) -> list[tuple[int, float]]:
    """The same for programs that only know opacity: frames and opacities, each of which holds to the next."""
    return [(frame, shape.opacity_at(frame) if is_there else 0.0) for frame, is_there in lifetime_steps(shape)]
