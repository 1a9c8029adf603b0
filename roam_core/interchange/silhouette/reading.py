"""Reads Silhouette's shapes, from `.fxs` files and whole `.sfx` projects: their keys, and the transforms of layers."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.interchange.keys.keying import Key, animated_of, keys_of
from roam_core.interchange.layer_motion import layer_motion, tell_strays
from roam_core.interchange.reading import (
    PLAIN,
    Imported,
    ImportOptions,
    ShapeReader,
    brief,
    origin_of,
    quietly,
    sensible,
)
from roam_core.interchange.silhouette.exporter import MODES, PATH_KINDS, VEIL
from roam_core.interchange.silhouette.project import project_session, project_shapes, unpacked
from roam_core.interchange.silhouette.values import (
    MATRIX,
    TRANSFORMS,
    LayerTransform,
    Track,
    in_order,
    move_of,
    number,
    pairs,
    says,
    track,
    unknown_moves,
    words_of,
)
from roam_core.interchange.telling import MOST_NAMES, gathered
from roam_core.interchange.xml import local_name, parsed
from roam_core.roto import (
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    RotoShape,
    Spline,
    control_points,
)
from roam_core.roto import LayerTransform as Motion
from roam_core.roto.animated import Animatable
from roam_core.roto.shape import NO_COLOUR
from roam_core.translatable import N_, enumerated, said_by, sentence

UNKNOWN_PROPERTIES: dict[str, tuple[str, tuple[float, ...]]] = {
    "transform.pin_ul": (N_("its corner pin"), (0.0, 0.0)),
    "transform.pin_ur": (N_("its corner pin"), (1.0, 0.0)),
    "transform.pin_lr": (N_("its corner pin"), (1.0, 1.0)),
    "transform.pin_ll": (N_("its corner pin"), (0.0, 1.0)),
    "feather": (N_("its feather"), (0.0,)),
    "blur": (N_("its blur"), (0.0,)),
    "adjust": (N_("its shrinking or growing"), (0.0,)),
    "strokeWidth": (N_("the width of its stroke"), (0.0,)),
}
"""Properties that change what is rendered and whose meaning in a file is not known, and where they change nothing."""


class SilhouetteImporter:
    """Reads Silhouette shape files, and the shapes of all Roto nodes of its projects."""

    name = "silhouette"
    title = N_("Silhouette shapes")
    suffixes = (".fxs", ".sfx")

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read all shapes, Bezier ones and B-splines, each as what it is."""
        reader = ShapeReader(path, clip, options)
        root = parsed(reader, content=unpacked(reader))
        if local_name(root) == "Project":
            return _SessionReader(reader, _Session.of(project_session(root), clip, reader.called)).read(
                project_shapes(root)
            )
        if local_name(root) != "Silhouette":
            raise RoamError(
                sentence(
                    "{path} is no Silhouette shape file (it begins with {element}).",
                    path=reader.called,
                    element=brief(local_name(root)),
                )
            )
        return _SessionReader(reader, _Session.of(root, clip, reader.called)).read(root)


@dataclass(frozen=True)
class _Session:
    """What a file says of its pictures and numbering."""

    size: tuple[float, float]
    pixel_aspect: float
    start: float

    @classmethod
    def of(cls, element: Element, clip: Clip, path: str) -> _Session:
        defaults = {"width": clip.size[0], "height": clip.size[1], "pixelAspect": 1.0, "sessionStartFrame": clip.first}
        try:
            values = {name: number(element.get(name, str(default))) for name, default in defaults.items()}
        except ValueError as error:
            raise RoamError(
                sentence(
                    "{path} does not say what pictures its shapes belong to: {reason}.",
                    path=path,
                    reason=said_by(error),
                )
            ) from None
        width, height, aspect, start = values.values()
        if not (0 < width < 1e6 and 0 < height < 1e6 and 0 < aspect < 1e3):
            raise RoamError(
                sentence(
                    "{path} speaks of pictures of {width:g} x {height:g} pixels; that cannot be.",
                    path=path,
                    width=width,
                    height=height,
                )
            )
        return cls((width, height), aspect, start)

    @property
    def matrix(self) -> Array:
        """The same as a map of the plane `(3, 3)`."""
        width, height = self.size
        return np.array([[height / self.pixel_aspect, 0.0, width / 2.0], [0.0, height, height / 2.0], [0.0, 0.0, 1.0]])

    def pixels(self, positions: Array) -> Array:
        """Positions `(..., 2)` in image heights from the centre, y down, as pixels."""
        result: Array = positions * self.size[1] / [self.pixel_aspect, 1.0] + np.array(self.size) / 2.0
        return result


@dataclass
class _SessionReader:
    """Layers and shapes of a session."""

    reader: ShapeReader
    session: _Session

    def read(self, root: Element) -> Imported:
        """All of it; the one layer that a file wraps around everything is taken off where it says nothing."""
        children = tuple(self._items(root, []))
        if len(children) == 1 and isinstance(children[0], Layer):
            layer = children[0]
            is_plain = layer.visible and not layer.locked and not layer.invert and layer.transform is None
            if is_plain and layer.opacity == 1.0:
                children = layer.children
        imported = self.reader.finished(children, self.session.size)
        tell_strays(imported.layer, self.reader)
        return replace(imported, notes=gathered(self.reader.notes))

    def _items(self, parent: Element, outer: Sequence[LayerTransform]) -> Iterator[Layer | RotoShape]:
        for element in parent:
            kind = element.get("type", local_name(element))
            if local_name(element) not in ("Layer", "Shape", "Object"):
                continue
            label = element.get("label", kind)
            if kind == "Layer":
                yield self._layer(element, label, outer)
                continue
            try:
                yield self._shape(element, label, outer)
            except (ValueError, KeyError, OverflowError) as error:
                self.reader.note(
                    sentence("The shape {name} was left out: {reason}.", name=brief(label), reason=said_by(error))
                )

    def _layer(self, element: Element, label: str, outer: Sequence[LayerTransform]) -> Layer:
        subject = sentence("layer {name}", name=brief(label))
        properties = self._properties(element, subject)
        parts = {}
        for name, count in {**{name: len(default) for name, default in TRANSFORMS.items()}, MATRIX: 16}.items():
            found = properties.get(f"transform.{name}")
            if found is not None and any(words_of(entry) for entry in found):
                try:
                    parts[name] = track(found, count)
                except ValueError as error:
                    self.reader.note(
                        sentence(
                            "The {property} of the layer {name} was left out: {reason}.",
                            property=name,
                            name=brief(label),
                            reason=said_by(error),
                        )
                    )
        form, motion, inner = LayerTransform(parts), None, outer
        if form.times and not outer:  # the motion stays that of the layer
            motion = self._motion(form)
        if parts and motion is None:
            inner = [form, *outer]
        objects = properties.get("objects")
        layer = Layer(
            self.reader.fresh_id("layer"),
            label,
            () if objects is None else tuple(self._items(objects, inner)),
            visible=not _truth(element.get("hidden")),
            locked=_truth(element.get("locked")),
            opacity=self._percent(properties, subject, may_begin=False)[0],
            invert=_truth(self._constant(properties, "invert", subject)),
            blend=self._blend(self._constant(properties, "mode", subject), subject),
            transform=motion,
        )
        return _unveiled(layer)

    def _motion(self, form: LayerTransform) -> Motion | None:
        """What moves a layer, in pixels; None where our layers cannot move so."""
        pixels, units = self.session.matrix, np.linalg.inv(self.session.matrix)
        return layer_motion(
            lambda moments: pixels @ form.matrices(moments) @ units,
            form.times,
            self.session.size,
            self._frame,
            self.reader,
        )

    def _shape(self, element: Element, label: str, outer: Sequence[LayerTransform]) -> RotoShape:
        subject = sentence("shape {name}", name=brief(label))
        properties = self._properties(element, subject)
        if "path" not in properties:
            raise ValueError(sentence("it has no path"))
        keys, closed, spline = self._keys(properties["path"], label, outer)
        shape_id = self.reader.fresh_id("shape")
        colour = NO_COLOUR
        if "outlineColor" in properties:
            colour = tuple(np.clip(track(properties["outlineColor"], 3).values[0], 0.0, 1.0).tolist())
        opacity, lifetime = self._percent(properties, subject)
        if _truth(_text(properties, "motionBlur", "")):
            self.reader.note(
                sentence("Silhouette's shutter is the session's: {name} has ROAM's own.", name=brief(label))
            )
        return RotoShape(
            shape_id,
            label,
            keys,
            closed=closed,
            spline=spline,
            colour=colour,
            blend=self._blend(self._constant(properties, "mode", subject), subject),
            opacity=opacity,
            invert=_truth(self._constant(properties, "invert", subject)),
            motion_blur=MotionBlur() if _truth(_text(properties, "motionBlur", "")) else None,
            lifetime=lifetime,
            visible=not _truth(element.get("hidden")),
            locked=_truth(element.get("locked")),
        )

    def _properties(self, element: Element, subject: str) -> dict[str, Element]:
        found = {
            each.get("id", ""): each
            for group in element
            if local_name(group) == "Properties"
            for each in group
            if local_name(each) == "Property"
        }
        for name, (meaning, default) in UNKNOWN_PROPERTIES.items():
            if name in found and says(found[name], default):
                self.reader.note(
                    sentence("The {subject}: {meaning} was left out.", subject=subject, meaning=sentence(meaning))
                )
        read = ("path", "opacity", *(f"transform.{part}" for part in (*TRANSFORMS, MATRIX)))
        if kinds := sorted({brief(kind) for name in read if name in found for kind in unknown_moves(found[name])}):
            told = enumerated(kinds, MOST_NAMES)
            self.reader.note(
                sentence("The {subject}: keys of the kind {kinds} were read as linear.", subject=subject, kinds=told)
            )
        return found

    def _constant(self, properties: dict[str, Element], name: str, subject: str) -> str:
        """What a property says that cannot vary in ROAM; "" for nothing. Where its keys differ that is told."""
        words = _texts(properties, name)
        if len(set(words)) > 1:
            self.reader.note(
                sentence(
                    "The {property} of the {subject} varies: it was read as {value}, its first key.",
                    property=name,
                    subject=subject,
                    value=brief(words[0]),
                )
            )
        return words[0] if words else ""

    def _blend(self, mode: str, subject: str) -> BlendMode:
        mode = mode or MODES[BlendMode.ADD]
        for blend, name in MODES.items():
            if name.lower() == mode.strip().lower():
                return blend
        self.reader.note(
            sentence("The mode {mode} of the {subject} is none of ROAM's; it adds.", mode=brief(mode), subject=subject)
        )
        return BlendMode.ADD

    def _percent(
        self, properties: dict[str, Element], subject: str, *, may_begin: bool = True
    ) -> tuple[Animatable, tuple[int, int] | None]:
        """Opacity in [0, 1], and the lifetime where keys begin and end with a zero that is held, as our writer's do."""
        if "opacity" not in properties:
            return 1.0, None
        try:
            keyed = track(properties["opacity"], 1)
        except ValueError as error:
            self.reader.note(
                sentence("The opacity of the {subject} was left out: {reason}.", subject=subject, reason=said_by(error))
            )
            return 1.0, None
        keyed = replace(keyed, values=np.clip(keyed.values / 100.0, 0.0, 1.0))
        lifetime = None
        if may_begin and _comes_and_goes(keyed):
            lifetime = (self._frame(keyed.frames[1]), self._frame(keyed.frames[-1]))
            keyed = Track(keyed.frames[1:-1], keyed.values[1:-1], keyed.moves[1:-1])
        if (keyed.values == keyed.values[0]).all():
            return float(keyed.values[0, 0]), lifetime
        opacity = animated_of(lambda moments: keyed.at(moments)[:, 0], keyed.times, self._frame, self.reader.check_keys)
        return opacity, lifetime

    # ---- points ------------------------------------------------------------------------------------------------------

    def _keys(
        self, path: Element, label: str, outer: Sequence[LayerTransform]
    ) -> tuple[tuple[Keyframe, ...], bool, Spline]:
        """Keys of a path, whether it closes, and its kind; where layers move it, as few keys as show the same."""
        found = [(key, inner) for key in path for inner in key if local_name(inner) == "Path"]
        found += [(path, inner) for inner in path if local_name(inner) == "Path"]
        closed = not any(inner.get("closed", "True").lower().startswith("f") for _, inner in found[-1:])
        spline = _kind([inner for _, inner in found])
        rows = [self._control_points(inner, label, spline) for _, inner in found]
        if not rows or len({len(row) for row in rows}) != 1:
            raise ValueError(sentence("its keys have no path, or differ in their number of points"))
        outlines = in_order(
            [number(key.get("frame", "0")) for key, _ in found],
            [row.ravel().tolist() for row in rows],
            [move_of(key) for key, _ in found],
        )
        is_plain = not outer and not outlines.bends and outlines.is_on_frames
        raw = self._plain(outlines) if is_plain else self._moved(outlines, label, outer)
        keys = tuple(
            Keyframe(
                self._frame(key.frame),
                control_points.points_of(self.session.pixels(key.value), spline, closed),
                interpolation=key.interpolation,
                **origin_of(key),
            )
            for key in raw
        )
        if not sensible(keys):
            raise ValueError(sentence("a point of it lies nowhere near the image"))
        return keys, closed, spline

    def _plain(self, outlines: Track) -> list[Key]:
        frames = [int(frame) for frame in outlines.frames.tolist()]
        return [
            Key(frame, Interpolation.HOLD if outlines.holds(k) else Interpolation.LINEAR, value.reshape(-1, 3, 2), True)
            for k, (frame, value) in enumerate(zip(frames, outlines.values, strict=True))
        ]

    def _moved(self, outlines: Track, label: str, outer: Sequence[LayerTransform]) -> list[Key]:
        count = outlines.values.shape[1] // 6
        scale = self.session.size[1]

        def values(moments: Array) -> Array:
            held = outlines.at(moments).reshape(len(moments), -1, 3, 2)
            for form in outer:
                held = form.apply(held, moments)
            return np.asarray(held * scale)

        times = set(outlines.frames.tolist()).union(*(form.times for form in outer))
        keys = keys_of(values, times, lambda made: self.reader.check_points(made * count, label, made))
        return [key._replace(value=key.value / scale) for key in keys]

    def _control_points(self, path: Element, label: str, spline: Spline) -> Array:
        """What the artist holds of one path, `(P, 3, 2)`, in the file's units: that is what layers move."""
        texts = [point.text or "" for point in path if local_name(point) == "Point"]
        self.reader.check_points(len(texts), label)
        each = 3 if spline is Spline.BEZIER else 1
        rows = np.array([pairs(text, each) for text in texts]).reshape(len(texts), -1, 2)
        if len(rows) < 2:
            raise ValueError(sentence("it has fewer than two points"))
        return rows if spline is Spline.BEZIER else rows[:, None, 0].repeat(3, axis=1)

    def _frame(self, number: float) -> int:
        return self.reader.frame(number + self.session.start)


def _unveiled(layer: Layer) -> Layer:
    """The layer with the opacity that our writer gave it by a shape inside of all others."""
    veil = layer.children[-1] if layer.children else None
    if not isinstance(veil, RotoShape) or (veil.name, veil.blend) != (f"{VEIL}{layer.name}", BlendMode.INTERSECT):
        return layer
    held = layer.children[:-1]
    inner = held[0] if len(held) == 1 else None
    if isinstance(inner, Layer) and inner.invert and inner.name == layer.name and not layer.invert:
        return replace(layer, children=inner.children, invert=True, opacity=veil.opacity)
    return replace(layer, children=held, opacity=veil.opacity)


def _comes_and_goes(opacity: Track) -> bool:
    """True for keys that hold zero up to a frame, and from another one on."""
    ends = opacity.values[[0, -1], 0]
    return len(opacity.frames) > 2 and not ends.any() and opacity.holds(0) and opacity.holds(len(opacity.frames) - 2)


def _kind(paths: Sequence[Element]) -> Spline:
    """The one kind of all paths of a shape."""
    named = {path.get("type", PATH_KINDS[Spline.BEZIER]) for path in paths}
    known = {name.lower(): spline for spline, name in PATH_KINDS.items()}
    if unknown := sorted(name for name in named if name.lower() not in known):
        raise ValueError(sentence("it is of the kind {kind}", kind=brief(unknown[0])))
    kinds = {known[name.lower()] for name in named}
    if len(kinds) > 1:
        raise ValueError(sentence("its keys are of several kinds"))
    return kinds.pop() if kinds else Spline.BEZIER


# ---- words -----------------------------------------------------------------------------------------------------------


def _texts(properties: dict[str, Element], name: str) -> list[str]:
    """The values of a property as text: one where it is constant, else one a key, by their frames."""
    entries = [entry for entry in properties.get(name, ()) if local_name(entry) in ("Value", "Key") and entry.text]
    return [(entry.text or "").strip() for entry in sorted(entries, key=_frame_of)]


def _frame_of(entry: Element) -> float:
    """The frame of a key; 0 for a constant, and for what says no number."""
    try:
        return number(entry.get("frame", "0"))
    except ValueError:
        return 0.0


def _text(properties: dict[str, Element], name: str, default: str) -> str:
    """The first value of a property as text."""
    return next(iter(_texts(properties, name)), default)


def _truth(text: str | None) -> bool:
    return text is not None and text.strip().lower() in ("true", "1", "yes")
