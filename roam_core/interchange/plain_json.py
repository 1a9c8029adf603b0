"""Plain JSON of shapes for pipelines, to write and to read: everything that ROAM knows of a shape, number for number.

The format is described in `docs/FORMATS.md`. Positions are pixels from the image's top-left corner, y down; handles are
absolute; frames are the plate's own.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass, replace
from itertools import islice
from typing import Any, TypeVar

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.interchange.keys.reduction import Motion
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied
from roam_core.interchange.reading import Imported, ShapeReader, are_numbers, brief, sensible
from roam_core.interchange.telling import gathered
from roam_core.interchange.text_exporter import TextExporter
from roam_core.roto import (
    Animated,
    BlendMode,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    Origin,
    Project,
    RotoShape,
    Spline,
    ValueKey,
    control_points,
)
from roam_core.roto.animated import Animatable, Slopes
from roam_core.roto.imported import IMPORT
from roam_core.roto.linking import AS_STACKED, BEHIND, IN_FRONT
from roam_core.roto.shape import NO_COLOUR
from roam_core.roto.value_curves import bounded
from roam_core.translatable import N_, said_by, sentence

Number = Callable[..., float]
"""Reads a number of a field: `_Reader._number` or `_share`."""

Kind = TypeVar("Kind", BlendMode, Interpolation, Origin, Spline)

FORMAT, VERSION = "roam-shapes", 2

WORDS = 1 << 16
"""Numbers, names and marks that are written at once."""
ROUNDING = 1e-9
"""What the last digits of a share may be beyond its bounds: it is read as the bound."""


class JsonFormat(TextExporter):
    """Writes and reads all layers and shapes of a project as plain JSON."""

    name = "json"
    title = N_("Plain JSON")
    suffix = ".json"
    suffixes = (".json",)

    def document(self, project: Project, options: ExportOptions) -> tuple[str, tuple[str, ...]]:
        """The text; nothing of a shape's look or motion is lost."""
        return json_document(project, options)

    def pieces(self, project: Project, options: ExportOptions) -> tuple[Iterable[str], tuple[str, ...]]:
        """The text in pieces: all that it is put together from at once takes five times the room of the file."""
        return _pieces(project, options)


def json_document(project: Project, options: ExportOptions = STANDARD) -> tuple[str, tuple[str, ...]]:
    """The text with all shapes of `project`, and a sentence for each thing that it cannot hold."""
    pieces, told = _pieces(project, options)
    return "".join(pieces), told


def _pieces(project: Project, options: ExportOptions) -> tuple[Iterator[str], tuple[str, ...]]:
    project = readied(project, options)
    clip, root = project.require_clip(), project.root
    writer = _Writer(clip, options, len(project.shapes))
    is_plain = root.visible and not root.locked and not root.invert and root.opacity == 1.0
    document = {
        "format": FORMAT,
        "version": VERSION,
        "width": clip.size[0],
        "height": clip.size[1],
        "pixel_aspect": clip.pixel_aspect,
        "fps": clip.fps,
        "first_frame": clip.first + options.frame_offset,
        "last_frame": clip.last + options.frame_offset,
        "items": writer.items(root) if is_plain else [writer.layer(root)],
    }
    return _written(document), gathered(writer.notes)


def _written(document: dict[str, Any]) -> Iterator[str]:
    words = json.JSONEncoder(ensure_ascii=True, allow_nan=False, indent=1).iterencode(document)
    while piece := "".join(islice(words, WORDS)):
        yield piece
    yield "\n"


@dataclass
class _Writer(ShapeWriter):
    """Turns layers and shapes into plain values, bottom first."""

    KINDS = frozenset(Spline)

    def items(self, layer: Layer) -> list[dict[str, Any]]:
        return [self.layer(child) if isinstance(child, Layer) else self.shape(child) for child in layer.children]

    def layer(self, layer: Layer) -> dict[str, Any]:
        return {
            "kind": "layer",
            "name": layer.name,
            "visible": layer.visible,
            "locked": layer.locked,
            "opacity": self._value(layer.opacity),
            "invert": layer.invert,
            "blend": layer.blend.value,
            "items": self.items(layer),
        }

    def shape(self, shape: RotoShape) -> dict[str, Any]:
        shape, _ = self.begun_for(shape, Motion.EASED)
        blur, offset = shape.motion_blur, self.options.frame_offset
        return {
            "kind": "shape",
            "name": shape.name,
            "closed": shape.closed,
            "spline": shape.spline.value,
            "visible": shape.visible,
            "locked": shape.locked,
            "colour": list(shape.colour),
            "blend": shape.blend.value,
            "opacity": self._value(shape.opacity),
            "invert": shape.invert,
            "feather": self._value(shape.feather),
            "motion_blur": None
            if blur is None
            else {"shutter": blur.shutter, "phase": blur.phase, "samples": blur.samples},
            "lifetime": None if shape.lifetime is None else [frame + offset for frame in shape.lifetime],
            **({"compound": shape.compound} if shape.compound else {}),
            **({"link": shape.link} if shape.link else {}),
            **({} if shape.attached else {"attached": False}),
            **({"depth": [[frame + offset, level] for frame, level in shape.depth]} if shape.depth else {}),
            "keys": [self._key(key) for key in shape.keys],
        }

    def _value(self, value: Animatable) -> Any:
        """A number; of what varies a list of its keys."""
        if not isinstance(value, Animated):
            return value
        offset = self.options.frame_offset
        return [
            {
                "frame": key.frame + offset,
                "value": key.value,
                "interpolation": key.interpolation.value,
                **({} if key.slopes is None else {"slopes": list(key.slopes)}),
            }
            for key in value.keys
        ]

    def _key(self, key: Keyframe) -> dict[str, Any]:
        values: dict[str, Any] = {
            "frame": key.frame + self.options.frame_offset,
            "interpolation": key.interpolation.value,
            "origin": key.origin.value,
            "points": key.points.reshape(-1, 6).tolist(),
        }
        if key.feather is not None:
            values["feather"] = key.feather.reshape(-1, 6).tolist()
        return values


# ---- reading ---------------------------------------------------------------------------------------------------------


class JsonReader(ShapeReader):
    """Turns plain values into layers and shapes; every refusal says where."""

    def shapes(self, document: dict[str, Any]) -> Imported:
        """All layers and shapes of a document of the format, which is known by its `format`."""
        version = document.get("version")
        if version not in (1, VERSION):
            raise RoamError(
                sentence(
                    "{path} has version {version} of the format; this program reads up to {newest}.",
                    path=self.called,
                    version=brief(str(version)),
                    newest=VERSION,
                )
            )
        self._sums = version == 1
        size = tuple(self._number(document, name, sentence("the file")) for name in ("width", "height"))
        if min(size) <= 0.0:
            raise self._refusal(sentence("the file"), sentence("width and height must be positive"))
        return self.finished(self._items(document, sentence("the file"), 1), (size[0], size[1]))

    def _items(self, values: dict[str, Any], place: str, depth: int) -> tuple[Layer | RotoShape, ...]:
        self.check_depth(depth)
        children: list[Layer | RotoShape] = []
        for number, item in enumerate(self._list(values, "items", place), start=1):
            inner = sentence("item {number} of {place}", number=number, place=place)
            if depth > 1:
                inner = sentence("{place}, item {number}", place=place, number=number)
            if not isinstance(item, dict) or item.get("kind") not in ("layer", "shape"):
                raise self._refusal(inner, sentence('"kind" must be "layer" or "shape"'))
            if item["kind"] == "layer":
                children.append(self._layer(item, inner, depth))
            else:
                children.append(self._shape(item, inner))
        return tuple(children[:1] + [self._as_it_was(child) for child in children[1:]])

    def _as_it_was(self, item: Layer | RotoShape) -> Layer | RotoShape:
        """In version 1 what lies on others was added by the clamped sum."""
        return replace(item, blend=BlendMode.PLUS) if self._sums and item.blend is BlendMode.ADD else item

    def _layer(self, values: dict[str, Any], place: str, depth: int) -> Layer:
        return Layer(
            self.fresh_id("layer"),
            self._text(values, "name", place),
            self._items(values, place, depth + 1),
            visible=self._truth(values, "visible", True, place),
            locked=self._truth(values, "locked", False, place),
            opacity=self._animatable(values, "opacity", 1.0, place, self._share),
            invert=self._truth(values, "invert", False, place),
            blend=self._choice(BlendMode, values, "blend", BlendMode.ADD, place),
        )

    def _shape(self, values: dict[str, Any], place: str) -> RotoShape:
        name = self._text(values, "name", place)
        place = sentence("shape {name} ({place})", name=brief(name), place=place)
        keys = tuple(self._key(key, name, place) for key in self._list(values, "keys", place))
        if not sensible(keys):
            raise self._refusal(place, sentence("a point lies nowhere near the image"))
        blend = self._choice(BlendMode, values, "blend", BlendMode.ADD, place)
        spline = self._choice(Spline, values, "spline", Spline.BEZIER, place)
        red, green, blue = self._colour(values, place)
        try:
            shape = RotoShape(
                id=self.fresh_id("shape"),
                name=name,
                keys=keys,
                closed=self._truth(values, "closed", True, place),
                colour=(red, green, blue),
                blend=blend,
                opacity=self._animatable(values, "opacity", 1.0, place, self._share),
                invert=self._truth(values, "invert", False, place),
                feather=self._animatable(values, "feather", 0.0, place, self._number),
                motion_blur=self._motion_blur(values, place),
                lifetime=self._lifetime(values, place),
                visible=self._truth(values, "visible", True, place),
                locked=self._truth(values, "locked", False, place),
                compound=self._text(values, "compound", place),
                link=self._text(values, "link", place),
                attached=self._truth(values, "attached", True, place),
                depth=self._depth(values, place),
            )
        except ValueError as error:
            raise self._refusal(place, said_by(error)) from None
        return _as_bspline(shape) if spline is Spline.BSPLINE else shape

    def _key(self, values: Any, name: str, place: str) -> Keyframe:
        if not isinstance(values, dict):
            raise self._refusal(place, sentence("a key must be an object"))
        frame = self._frame(self._number(values, "frame", place), place)
        place = sentence("{place}, key on frame {frame}", place=place, frame=frame)
        rows = self._list(values, "points", place)
        self.check_points(len(rows), name)
        points = self._points(rows, place)
        feather = None
        if values.get("feather") is not None:
            feather = self._points(self._list(values, "feather", place), place)
            if feather.shape != points.shape:
                raise self._refusal(place, sentence("the feather has other points than the outline"))
        interpolation = self._choice(Interpolation, values, "interpolation", Interpolation.LINEAR, place)
        origin = self._choice(Origin, values, "origin", Origin.ARTIST, place)
        return Keyframe(
            frame,
            points,
            feather,
            origin=origin,
            interpolation=interpolation,
            inputs=IMPORT if origin is Origin.ENGINE else "",
        )

    def _points(self, rows: list[Any], place: str) -> Array:
        if not rows or not all(isinstance(row, list) and len(row) in (2, 6) and are_numbers(row) for row in rows):
            raise self._refusal(
                place, sentence("each point must be a list of two or six numbers, and there must be one")
            )
        return np.array([row * (6 // len(row)) for row in rows], dtype=np.float64).reshape(-1, 3, 2)

    # ---- values ------------------------------------------------------------------------------------------------------

    def _refusal(self, place: str, trouble: str) -> RoamError:
        return RoamError(
            sentence("{path} cannot be read: in {place}, {trouble}.", path=self.called, place=place, trouble=trouble)
        )

    def _list(self, values: dict[str, Any], field: str, place: str) -> list[Any]:
        value = values.get(field)
        if not isinstance(value, list):
            raise self._refusal(place, sentence('"{field}" must be a list', field=field))
        return value

    def _text(self, values: dict[str, Any], field: str, place: str) -> str:
        value = values.get(field, "")
        if not isinstance(value, str):
            raise self._refusal(place, sentence('"{field}" must be a text', field=field))
        return value

    def _truth(self, values: dict[str, Any], field: str, default: bool, place: str) -> bool:
        value = values.get(field, default)
        if not isinstance(value, bool):
            raise self._refusal(place, sentence('"{field}" must be true or false', field=field))
        return value

    def _number(self, values: dict[str, Any], field: str, place: str, default: float | None = None) -> float:
        value = values.get(field, default)
        if not are_numbers([value]):
            raise self._refusal(place, sentence('"{field}" must be a number', field=field))
        assert isinstance(value, int | float)
        return float(value)

    def _animatable(self, values: dict[str, Any], field: str, default: float, place: str, read: Number) -> Animatable:
        """A number, or a list of keys: frame, value, interpolation."""
        keys = values.get(field)
        if not isinstance(keys, list):
            return read(values, field, place, default)
        self.check_keys(len(keys))
        try:
            return bounded(
                Animated(
                    tuple(
                        self._value_key(key, sentence("{place}, {field}", place=place, field=field), read)
                        for key in keys
                    )
                ),
                field,
            )
        except ValueError as error:
            raise self._refusal(place, said_by(error)) from None

    def _value_key(self, values: Any, place: str, read: Number) -> ValueKey:
        if not isinstance(values, dict):
            raise self._refusal(place, sentence("a key must be an object"))
        frame = self._frame(self._number(values, "frame", place), place)
        interpolation = self._choice(Interpolation, values, "interpolation", Interpolation.LINEAR, place)
        return ValueKey(frame, read(values, "value", place), interpolation, self._slopes(values.get("slopes"), place))

    def _slopes(self, pair: Any, place: str) -> Slopes | None:
        """Of a key's tangents, per frame; None where it has none."""
        if pair is None:
            return None
        if not isinstance(pair, list) or len(pair) != 2 or not are_numbers(pair):
            raise self._refusal(place, sentence('"slopes" must be two numbers'))
        return float(pair[0]), float(pair[1])

    def _share(self, values: dict[str, Any], field: str, place: str, default: float | None = None) -> float:
        value = self._number(values, field, place, default)
        if not -ROUNDING <= value <= 1.0 + ROUNDING:
            raise self._refusal(place, sentence('"{field}" must lie between 0 and 1', field=field))
        return min(max(value, 0.0), 1.0)

    def _choice(self, kind: type[Kind], values: dict[str, Any], field: str, default: Kind, place: str) -> Kind:
        value = values.get(field, default)
        if value not in list(kind):
            raise self._refusal(place, sentence('"{field}" must be one of {words}', field=field, words=", ".join(kind)))
        return kind(value)

    def _colour(self, values: dict[str, Any], place: str) -> list[float]:
        value = values.get("colour", list(NO_COLOUR))
        if not isinstance(value, list) or len(value) != 3 or not are_numbers(value):
            raise self._refusal(place, sentence('"colour" must be a list of three numbers'))
        return [min(max(float(share), 0.0), 1.0) for share in value]

    def _motion_blur(self, values: dict[str, Any], place: str) -> MotionBlur | None:
        blur = values.get("motion_blur")
        if blur is None:
            return None
        if not isinstance(blur, dict):
            raise self._refusal(place, sentence('"motion_blur" must be null or an object'))
        shutter, phase = (self._number(blur, field, place) for field in ("shutter", "phase"))
        samples = self._number(blur, "samples", place, 16.0)
        if not 1.0 <= samples <= 1024.0 or not abs(shutter) <= 1000.0:
            raise self._refusal(
                place, sentence("the motion blur must have 1 to 1024 samples and a shutter of at most 1000 frames")
            )
        return MotionBlur(shutter, phase, round(samples))

    def _lifetime(self, values: dict[str, Any], place: str) -> tuple[int, int] | None:
        lifetime = values.get("lifetime")
        if lifetime is None:
            return None
        if not isinstance(lifetime, list) or len(lifetime) != 2 or not are_numbers(lifetime):
            raise self._refusal(
                place, sentence('"lifetime" must be null or a first frame and the frame after the last')
            )
        start, stop = (self._frame(frame, place) for frame in lifetime)
        if stop < start:
            raise self._refusal(place, sentence('"lifetime" must not end before it begins'))
        return start, stop

    def _depth(self, values: dict[str, Any], place: str) -> tuple[tuple[int, int], ...]:
        """From which frames on a shape lies before (1) or behind (-1) the others of its object, or as stacked (0)."""
        rows = values.get("depth", [])
        if not isinstance(rows, list) or not all(map(_is_depth, rows)):
            raise self._refusal(place, sentence('"depth" must be a list of frames, each with -1, 0 or 1'))
        self.check_keys(len(rows))
        return tuple(sorted({self._frame(frame, place): int(level) for frame, level in rows}.items()))

    def _frame(self, number: float, place: str) -> int:
        try:
            return self.frame(number)
        except ValueError as error:
            raise self._refusal(place, said_by(error)) from None


def _is_depth(row: Any) -> bool:
    """Whether it is a frame and a level."""
    is_pair = isinstance(row, list) and len(row) == 2 and are_numbers(row)
    return is_pair and row[1] in (BEHIND, AS_STACKED, IN_FRONT)


def _as_bspline(shape: RotoShape) -> RotoShape:
    """The shape as a B-spline: bit by bit where its points are those of one, else the one that lies nearest."""
    most = max(float(np.abs(key.points).max()) for key in shape.keys)
    if all(bspline.is_bspline(key.points, shape.closed, 1e-9 * max(most, 1.0)) for key in shape.keys):
        return replace(shape, spline=Spline.BSPLINE)
    return control_points.with_spline(shape, Spline.BSPLINE)
