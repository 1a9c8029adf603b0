"""Reads Silhouette's `.fxs`: layers and shapes, their keys, and the plain transforms of layers."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np
from numpy.typing import NDArray

from roam_core.errors import RoamError
from roam_core.interchange.keying import Key, keys_of
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, ShapeReader, brief, sensible
from roam_core.interchange.silhouette import MODES
from roam_core.interchange.xml import local_name, parsed
from roam_core.roto import BlendMode, Clip, Interpolation, Keyframe, Layer, MotionBlur, RotoShape
from roam_core.roto.project import PALETTE

Array = NDArray[np.float64]

UNKNOWN_PROPERTIES = {
    "transform.matrix": "its matrix",
    "transform.pin_ul": "its corner pin",
    "feather": "its feather",
}
"""Properties that change what is rendered and whose meaning in a file is not known."""


class SilhouetteImporter:
    """Reads Silhouette shape files."""

    name = "silhouette"
    title = "Silhouette shapes"
    suffixes = (".fxs",)

    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read all shapes; B-splines become Beziers on the same curve."""
        reader = ShapeReader(path, clip, options)
        session = parsed(reader)
        if local_name(session) != "Silhouette":
            raise RoamError(f"{path} is no Silhouette shape file (it begins with {brief(local_name(session))}).")
        return _SessionReader(reader, _Session.of(session, clip, path)).read(session)


@dataclass(frozen=True)
class _Session:
    """What a file says of its pictures and numbering."""

    size: tuple[float, float]
    pixel_aspect: float
    start: float

    @classmethod
    def of(cls, element: Element, clip: Clip, path: Path) -> _Session:
        defaults = {"width": clip.size[0], "height": clip.size[1], "pixelAspect": 1.0, "sessionStartFrame": clip.first}
        try:
            values = {name: _number(element.get(name, str(default))) for name, default in defaults.items()}
        except ValueError as error:
            raise RoamError(f"{path} does not say what pictures its shapes belong to: {error}.") from None
        width, height, aspect, start = values.values()
        if not (0 < width < 1e6 and 0 < height < 1e6 and 0 < aspect < 1e3):
            raise RoamError(f"{path} speaks of pictures of {width:g} x {height:g} pixels; that cannot be.")
        return cls((width, height), aspect, start)

    def pixels(self, positions: Array) -> Array:
        """Positions `(..., 2)` in image heights from the centre, y down, as pixels."""
        result: Array = positions * self.size[1] / [self.pixel_aspect, 1.0] + np.array(self.size) / 2.0
        return result


@dataclass(frozen=True)
class _Property:
    """Keys of numbers `(n, M)` on the file's own frames; a constant has one, of no meaning."""

    frames: Array
    values: Array
    holds: NDArray[np.bool_]

    @property
    def times(self) -> list[float]:
        """Of its keys; nothing for a constant."""
        return self.frames.tolist() if len(self.frames) > 1 else []

    def at(self, moments: Array) -> Array:
        """Values `(T, M)`, linear or held; before the first and after the last key it stands still."""
        if len(self.frames) == 1:
            return np.repeat(self.values, len(moments), axis=0)
        inside = np.clip(moments, self.frames[0], self.frames[-1])
        k = np.clip(np.searchsorted(self.frames, inside, side="right") - 1, 0, len(self.frames) - 2)
        u = (inside - self.frames[k]) / (self.frames[k + 1] - self.frames[k])
        u = np.where(self.holds[k] & (u < 1.0), 0.0, u)[:, None]
        return np.asarray((1.0 - u) * self.values[k] + u * self.values[k + 1])


@dataclass(frozen=True)
class _Transform:
    """Position, anchor, scale and rotation of a layer."""

    parts: dict[str, _Property]

    @property
    def times(self) -> set[float]:
        return {time for part in self.parts.values() for time in part.times}

    def apply(self, positions: Array, moments: Array) -> Array:
        """Positions `(T, P, 3, 2)` about the anchor scaled, then turned clockwise, then moved."""
        defaults = {"anchor": [0.0, 0.0], "position": [0.0, 0.0], "scale": [1.0, 1.0], "rotate": [0.0]}
        anchor, position, scale, rotate = (
            self.parts[name].at(moments) if name in self.parts else np.tile(default, (len(moments), 1))
            for name, default in defaults.items()
        )
        angle = np.radians(rotate[:, 0])
        turn = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]).transpose(2, 0, 1)
        about = (positions - anchor[:, None, None]) * scale[:, None, None]
        moved = (turn[:, None, None] @ about[..., None])[..., 0]
        return np.asarray(moved + (anchor + position)[:, None, None])


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
            if layer.visible and not layer.locked and not layer.invert:
                children = layer.children
        return self.reader.finished(children, self.session.size)

    def _items(self, parent: Element, outer: Sequence[_Transform]) -> Iterator[Layer | RotoShape]:
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
                self.reader.note(f"The shape {brief(label)} was left out: {error}.")

    def _layer(self, element: Element, label: str, outer: Sequence[_Transform]) -> Layer:
        properties = self._properties(element, f"The layer {brief(label)}")
        parts = {}
        for name in ("anchor", "position", "scale", "rotate"):
            found = properties.get(f"transform.{name}")
            if found is not None:
                try:
                    parts[name] = _numbers(found, 1 if name == "rotate" else 2)
                except ValueError as error:
                    self.reader.note(f"The {name} of the layer {brief(label)} was left out: {error}.")
        inner = [_Transform(parts), *outer] if parts else outer
        objects = properties.get("objects")
        if _text(properties, "mode", MODES[BlendMode.ADD]) != MODES[BlendMode.ADD]:
            self.reader.note(f"The blend mode of the layer {brief(label)} was left out: ROAM's layers add.")
        return Layer(
            self.reader.fresh_id("layer"),
            label,
            () if objects is None else tuple(self._items(objects, inner)),
            visible=not _truth(element.get("hidden")),
            locked=_truth(element.get("locked")),
            invert=_truth(_text(properties, "invert", "")),
        )

    def _shape(self, element: Element, label: str, outer: Sequence[_Transform]) -> RotoShape:
        properties = self._properties(element, f"The shape {brief(label)}")
        if "path" not in properties:
            raise ValueError("it has no path")
        keys, closed = self._keys(properties["path"], label, outer)
        shape_id = self.reader.fresh_id("shape")
        colour = PALETTE[(int(shape_id.rpartition("-")[2]) - 1) % len(PALETTE)]
        if "outlineColor" in properties:
            colour = tuple(np.clip(_numbers(properties["outlineColor"], 3).values[0], 0.0, 1.0).tolist())
        opacity, lifetime = self._opacity(properties, label)
        if _truth(_text(properties, "motionBlur", "")):
            self.reader.note(f"Silhouette's shutter is the session's: {brief(label)} has ROAM's own.")
        return RotoShape(
            shape_id,
            label,
            keys,
            closed=closed,
            colour=colour,
            blend=self._blend(_text(properties, "mode", MODES[BlendMode.ADD]), label),
            opacity=min(max(opacity / 100.0, 0.0), 1.0),
            invert=_truth(_text(properties, "invert", "")),
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
        for name, meaning in UNKNOWN_PROPERTIES.items():
            if name in found:
                self.reader.note(f"{subject}: {meaning} was left out.")
        return found

    def _blend(self, mode: str, label: str) -> BlendMode:
        for blend, name in MODES.items():
            if name == mode:
                return blend
        self.reader.note(f"The mode {brief(mode)} of the shape {brief(label)} is none of ROAM's; it adds.")
        return BlendMode.ADD

    def _opacity(self, properties: dict[str, Element], label: str) -> tuple[float, tuple[int, int] | None]:
        """Percent, and the lifetime where the keys are zero, one value held, and zero again."""
        if "opacity" not in properties:
            return 100.0, None
        opacity = _numbers(properties["opacity"], 1)
        values = opacity.values[:, 0]
        if len(values) == 3 and values[0] == values[2] == 0.0 and opacity.holds[:2].all():
            return float(values[1]), (self._frame(opacity.frames[1]), self._frame(opacity.frames[2]))
        if len(values) == 1 or (values == values[0]).all():
            return float(values[0]), None
        self.reader.note(f"The opacity of the shape {brief(label)} is animated; it has the largest value.")
        return float(values.max()), None

    # ---- points ------------------------------------------------------------------------------------------------------

    def _keys(self, path: Element, label: str, outer: Sequence[_Transform]) -> tuple[tuple[Keyframe, ...], bool]:
        """Keys of a path, and whether it closes; where layers move it, as few as show the same."""
        found = [(key, inner) for key in path for inner in key if local_name(inner) == "Path"]
        found += [(path, inner) for inner in path if local_name(inner) == "Path"]
        rows, closed = [], True
        for _, inner in found:
            closed = not inner.get("closed", "True").lower().startswith("f")
            rows.append(self._points(inner, label, closed))
        if not rows or len({len(row) for row in rows}) != 1:
            raise ValueError("its keys have no path, or differ in their number of points")
        order = np.argsort([_number(key.get("frame", "0")) for key, _ in found], kind="stable")
        outlines = _Property(
            np.array([_number(found[i][0].get("frame", "0")) for i in order]),
            np.stack([rows[i].ravel() for i in order]),
            np.array([found[i][0].get("interp", "linear") == "hold" for i in order]),
        )
        if (np.diff(outlines.frames) <= 0).any():
            raise ValueError("it has two keys on one frame")
        raw = self._plain(outlines) if not outer else self._moved(outlines, label, outer)
        keys = tuple(Keyframe(self._frame(f), self.session.pixels(v), interpolation=i) for f, i, v in raw)
        if not sensible(keys):
            raise ValueError("a point of it lies nowhere near the image")
        return keys, closed

    def _plain(self, outlines: _Property) -> list[Key]:
        modes = [Interpolation.HOLD if hold else Interpolation.LINEAR for hold in outlines.holds]
        frames = [round(frame) for frame in outlines.frames.tolist()]
        return [(f, m, v.reshape(-1, 3, 2)) for f, m, v in zip(frames, modes, outlines.values, strict=True)]

    def _moved(self, outlines: _Property, label: str, outer: Sequence[_Transform]) -> list[Key]:
        count = outlines.values.shape[1] // 6
        scale = self.session.size[1]

        def values(moments: Array) -> Array:
            points = outlines.at(moments).reshape(len(moments), -1, 3, 2)
            for form in outer:
                points = form.apply(points, moments)
            return np.asarray(points * scale)

        times = set(outlines.frames.tolist()).union(*(form.times for form in outer))
        keys = keys_of(values, times, lambda made: self.reader.check_points(made * count, label))
        return [(frame, interpolation, value / scale) for frame, interpolation, value in keys]

    def _points(self, path: Element, label: str, closed: bool) -> Array:
        """Points `(P, 3, 2)` of one path, in the file's units."""
        texts = [point.text or "" for point in path if local_name(point) == "Point"]
        self.reader.check_points(len(texts), label)
        is_spline = path.get("type", "Bezier").lower() == "bspline"
        rows = np.array([_tuples(text, 1 if is_spline else 3) for text in texts]).reshape(len(texts), -1, 2)
        if len(rows) < 2:
            raise ValueError("it has fewer than two points")
        return _from_b_spline(rows[:, 0], closed) if is_spline else rows

    def _frame(self, number: float) -> int:
        return self.reader.frame(number + self.session.start)


def _from_b_spline(controls: Array, closed: bool) -> Array:
    """The Bezier points `(P, 3, 2)` of the uniform cubic B-spline with `controls (P, 2)`; open ones keep their ends."""
    if closed:
        before, after = np.roll(controls, 1, axis=0), np.roll(controls, -1, axis=0)
    else:
        extended = np.vstack([2 * controls[0] - controls[1], controls, 2 * controls[-1] - controls[-2]])
        before, after = extended[:-2], extended[2:]
    return np.stack(
        [(before + 4 * controls + after) / 6.0, (2 * controls + before) / 3.0, (2 * controls + after) / 3.0], axis=1
    )


# ---- words -----------------------------------------------------------------------------------------------------------


def _number(text: str) -> float:
    number = float(text)
    if not abs(number) < float("inf"):
        raise ValueError(f"{text[:20]!r} is no finite number")
    return number


def _tuples(text: str, count: int) -> list[float]:
    """The numbers of `count` pairs `(x,y)`; more than these are passed over."""
    pairs = re.findall(r"\(([^(),]*),([^(),]*)\)", text)[:count]
    if len(pairs) < count:
        raise ValueError(f"a point of it has {len(pairs)} positions, not {count}")
    return [_number(value) for pair in pairs for value in pair]


def _numbers(element: Element, count: int) -> _Property:
    """A property of `count` numbers, constant or keyed."""
    entries = [entry for entry in element if local_name(entry) in ("Value", "Key")]
    rows = []
    for entry in entries:
        words = re.findall(r"[^\s(),]+", entry.text or "")
        if len(words) < count:
            raise ValueError(f"{element.get('id', 'a property')!r} has {len(words)} numbers, not {count}")
        rows.append([_number(word) for word in words[:count]])
    if not rows:
        raise ValueError(f"{element.get('id', 'a property')!r} has no value")
    frames = np.array([_number(entry.get("frame", "0")) for entry in entries])
    if (np.diff(frames) <= 0).any():
        raise ValueError(f"the keys of {element.get('id', 'a property')!r} are not in order")
    return _Property(frames, np.array(rows), np.array([entry.get("interp") == "hold" for entry in entries]))


def _text(properties: dict[str, Element], name: str, default: str) -> str:
    """The first value of a property as text."""
    for entry in properties.get(name, ()):
        if local_name(entry) in ("Value", "Key") and entry.text:
            return entry.text.strip()
    return default


def _truth(text: str | None) -> bool:
    return text is not None and text.strip().lower() in ("true", "1", "yes")
