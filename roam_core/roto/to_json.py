"""A project as the text of its file, piece by piece: plain data of each object with its type, and JSON of that."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np

from roam_core.media.finding import origin_in
from roam_core.roto.animated import Animatable, Animated, ValueKey
from roam_core.roto.bounds import require_bounds
from roam_core.roto.migrate import VERSION
from roam_core.roto.motion_blur import MotionBlur
from roam_core.roto.packing import packed_keys, packed_numbers
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Clip, Layer, Mark, Project
from roam_core.roto.shape import BlendMode, RotoShape


class _Encoder(json.JSONEncoder):
    """JSON of plain values; a scalar of numpy's, as the engine's callers pass frames, is the number that it is."""

    def default(self, o: Any) -> Any:
        return o.item() if isinstance(o, np.generic) else super().default(o)


_ENCODER = _Encoder(ensure_ascii=False, allow_nan=False)


def pieces(project: Project, folder: Path) -> Iterator[str]:
    """The text of a project file that lies in `folder`, in pieces of a shape at most: no more is held in memory.

    Raises
    ------
    RoamError
        when the project holds more, or lies deeper, than could be read again.
    """
    require_bounds(project)
    yield from _lines({"type": "roam.Project", "version": VERSION, **_project(project, folder)})
    yield "\n"


# ---- objects as plain data; what lies in layers is made plain when it is written -----------------------------------


def _project(project: Project, folder: Path) -> dict[str, Any]:
    return {
        "clip": None if project.clip is None else _clip(project.clip, folder),
        "root": project.root,
        **({"marks": [_mark(mark) for mark in project.marks]} if project.marks else {}),
        **project.extra,
    }


def _mark(mark: Mark) -> dict[str, Any]:
    return {"type": "Mark", "frame": mark.frame, "text": mark.text, **mark.extra}


def _clip(clip: Clip, folder: Path) -> dict[str, Any]:
    path, absolute = _relative(clip.path, folder), clip.path.as_posix()
    return {
        "type": "Clip",
        "path": path,
        **({"absolute": absolute} if clip.path.is_absolute() and path != absolute else {}),
        "first": clip.first,
        "last": clip.last,
        "size": list(clip.size),
        "fps": clip.fps,
        "pixel_aspect": clip.pixel_aspect,
        "colour_space": clip.colour_space,
        **({"content": clip.content} if clip.content else {}),
        **({"layer": clip.layer} if clip.layer else {}),
        **clip.extra,
    }


def _relative(path: Path, folder: Path) -> str:
    if not path.is_absolute():
        return path.as_posix()
    try:
        return Path(os.path.relpath(path, origin_in(folder))).as_posix()
    except ValueError:  # another drive
        return path.as_posix()


def _layer(layer: Layer) -> dict[str, Any]:
    return {
        "type": "Layer",
        "id": layer.id,
        "name": layer.name,
        "visible": layer.visible,
        "locked": layer.locked,
        "opacity": _value(layer.opacity),
        "invert": layer.invert,
        **({} if layer.blend is BlendMode.ADD else {"blend": layer.blend.value}),
        **({} if layer.transform is None else {"transform": _transform(layer.transform)}),
        "children": layer.children,
        **layer.extra,
    }


def _transform(transform: LayerTransform) -> dict[str, Any]:
    return {
        "type": "LayerTransform",
        "frames": list(transform.frames),
        "matrices": packed_numbers(transform.matrices),
        **({"confidence": [list(pair) for pair in transform.confidence]} if transform.confidence else {}),
        **({"adjusted": list(transform.adjusted)} if transform.adjusted else {}),
        **({"surface": [list(corner) for corner in transform.surface]} if transform.surface else {}),
        **({"points": [list(place) for place in transform.points]} if transform.points else {}),
        **({"areas": list(transform.areas)} if transform.areas else {}),
        **transform.extra,
    }


def _value(value: Animatable) -> Any:
    if not isinstance(value, Animated):
        return value
    return {"type": "Animated", "keys": [_value_key(key) for key in value.keys], **value.extra}


def _value_key(key: ValueKey) -> dict[str, Any]:
    return {
        "type": "ValueKey",
        "frame": key.frame,
        "value": key.value,
        "interpolation": key.interpolation,
        **({} if key.slopes is None else {"slopes": list(key.slopes)}),
        **key.extra,
    }


def _blur(blur: MotionBlur) -> dict[str, Any]:
    values = {"shutter": blur.shutter, "phase": blur.phase, "samples": blur.samples}
    return {"type": "MotionBlur", **values, **blur.extra}


def _shape(shape: RotoShape) -> dict[str, Any]:
    return {
        "type": "RotoShape",
        "id": shape.id,
        "name": shape.name,
        "closed": shape.closed,
        "colour": list(shape.colour),
        "blend": shape.blend.value,
        "opacity": _value(shape.opacity),
        "invert": shape.invert,
        "feather": _value(shape.feather),
        "motion_blur": None if shape.motion_blur is None else _blur(shape.motion_blur),
        "lifetime": None if shape.lifetime is None else list(shape.lifetime),
        "visible": shape.visible,
        "locked": shape.locked,
        "spline": shape.spline.value,
        **({"link": shape.link} if shape.link else {}),
        **({} if shape.attached else {"attached": False}),
        **({"depth": [list(pair) for pair in shape.depth]} if shape.depth else {}),
        **({"compound": shape.compound} if shape.compound else {}),
        "keys": packed_keys(shape.keys),
        **shape.extra,
    }


# ---- plain data as JSON ----------------------------------------------------------------------------------------------


def _lines(value: Any, indent: str = "") -> Iterator[str]:
    """JSON with one line for each list of plain values: a project file reads, and diffs, point by point.

    What is still to be written waits on a stack: however deep layers lie, Python's own stack does not grow.
    """
    waiting: list[tuple[str, Any, str]] = [("", value, indent)]
    while waiting:
        lead, value, indent = waiting.pop()
        if isinstance(value, Layer):
            value = _layer(value)
        if isinstance(value, RotoShape):
            yield lead + "".join(_lines(_shape(value), indent))
        elif isinstance(value, dict) and value:
            items = [(f"{_ENCODER.encode(name)}: ", item) for name, item in value.items()]
            waiting.extend(_nested("{}", items, lead, indent))
        elif isinstance(value, list | tuple) and any(_is_nested(item) for item in value):
            waiting.extend(_nested("[]", [("", item) for item in value], lead, indent))
        elif value is _END:
            yield lead
        else:
            yield lead + _ENCODER.encode(value)


_END = object()


def _nested(brackets: str, items: list[tuple[str, Any]], lead: str, indent: str) -> list[tuple[str, Any, str]]:
    """The items of a list or an object with what stands before each, the last one first."""
    deeper = indent + " "
    leads = [f"{lead}{brackets[0]}\n{deeper}", *[f",\n{deeper}"] * (len(items) - 1)]
    parts = [(before + name, item, deeper) for before, (name, item) in zip(leads, items, strict=True)]
    return [(f"\n{indent}{brackets[1]}", _END, indent), *reversed(parts)]


def _is_nested(value: Any) -> bool:
    return isinstance(value, dict | list | tuple | Layer | RotoShape)
