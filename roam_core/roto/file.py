"""The project file `.roam`: JSON in a stable order, every object with its type, written whole or not at all."""

from __future__ import annotations

import hashlib
import json
import math
import os
import tempfile
from collections.abc import Callable, Mapping
from pathlib import Path, PurePosixPath
from typing import Any

import numpy as np

from roam_core.errors import RoamError
from roam_core.roto.migrate import VERSION, migrate
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Clip, Layer, Mark, Project
from roam_core.roto.shape import BlendMode, Interpolation, Keyframe, MotionBlur, Origin, RotoShape, Spline

MAX_BYTES = 1 << 30
"""Larger files are refused before they are read."""


def save(project: Project, path: Path) -> None:
    """Write `project` to `path`: to a temporary file beside it, flushed, then put in place in one step.

    Raises
    ------
    RoamError
        when the folder is missing or may not be written to; a file that was there is then still there, whole.
    """
    write_atomically(path, _encoded(dumps(project, path.parent)))


def load(path: Path) -> Project:
    """Read a project file.

    Raises
    ------
    RoamError
        when it is missing, not a project, damaged, or of a newer version.
    """
    try:
        if path.stat().st_size > MAX_BYTES:
            raise RoamError(f"{path} is larger than {MAX_BYTES >> 20} MiB; that is no ROAM project.")
        text = path.read_text(encoding="utf-8")
    except FileNotFoundError:
        raise RoamError(f"{path} does not exist.") from None
    except IsADirectoryError:
        raise RoamError(f"{path} is a folder, not a project file.") from None
    except UnicodeDecodeError:
        raise RoamError(f"{path} is not a ROAM project (it is no text file).") from None
    except OSError as error:
        raise RoamError(f"{path} cannot be read: {error.strerror}.") from None
    return loads(text, path.parent, str(path))


def dumps(project: Project, folder: Path) -> str:
    """The text of a project file that lies in `folder`."""
    document = {"type": "roam.Project", "version": VERSION, **_project(project, folder)}
    return _lines(document) + "\n"


def loads(text: str, folder: Path, name: str = "the file") -> Project:
    """The project that `text` describes; relative media paths are taken from `folder`."""
    try:
        document = json.loads(text, parse_float=_finite, parse_constant=_finite)
    except (ValueError, RecursionError):
        raise RoamError(f"{name} is not a ROAM project (it is not valid JSON).") from None
    if not isinstance(document, dict) or document.get("type") != "roam.Project":
        raise RoamError(f"{name} is not a ROAM project.")
    version = document.get("version")
    if not isinstance(version, int) or version < 1:
        raise RoamError(f"{name} says no valid version; it may be damaged.")
    if version > VERSION:
        raise RoamError(
            f"{name} was written by a newer ROAM (file version {version}, this program reads up to {VERSION}); "
            "open it with that version."
        )
    try:
        return _read_project(migrate(document, version), folder)
    except (KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError) as error:
        raise RoamError(f"{name} is damaged: {_reason(error)}.") from None


def digest(project: Project) -> str:
    """A hash of everything in the project: equal projects, and only they, have equal digests."""
    return hashlib.sha256(_encoded(dumps(project, Path("/")))).hexdigest()


def _encoded(text: str) -> bytes:
    """UTF-8. A file name that is no UTF-8 reaches us as lone surrogates, which JSON writes as escapes."""
    return text.encode("utf-8", "backslashreplace")


def write_atomically(path: Path, content: bytes) -> None:
    """Put `content` at `path` by way of a temporary file in the same folder, flushed to the disk and then renamed."""
    try:
        handle, temporary = tempfile.mkstemp(prefix=f".{path.name}.", suffix=".tmp", dir=path.parent)
    except OSError as error:
        raise RoamError(f"{path} cannot be written: {error.strerror} ({path.parent}).") from None
    try:
        with os.fdopen(handle, "wb") as file:
            file.write(content)
            file.flush()
            os.fsync(file.fileno())
        Path(temporary).chmod(_mode_for(path))
        Path(temporary).replace(path)
    except OSError as error:
        Path(temporary).unlink(missing_ok=True)
        raise RoamError(f"{path} cannot be written: {error.strerror}.") from None
    except BaseException:
        Path(temporary).unlink(missing_ok=True)
        raise


def _mode_for(path: Path) -> int:
    if path.exists():
        return path.stat().st_mode & 0o777
    mask = os.umask(0)
    os.umask(mask)
    return 0o666 & ~mask


# ---- writing ---------------------------------------------------------------------------------------------------------


def _project(project: Project, folder: Path) -> dict[str, Any]:
    return {
        "clip": None if project.clip is None else _clip(project.clip, folder),
        "root": _layer(project.root),
        **({"marks": [{"type": "Mark", **vars(mark)} for mark in project.marks]} if project.marks else {}),
        **project.extra,
    }


def _clip(clip: Clip, folder: Path) -> dict[str, Any]:
    return {
        "type": "Clip",
        "path": _relative(clip.path, folder),
        "first": clip.first,
        "last": clip.last,
        "size": list(clip.size),
        "fps": clip.fps,
        "pixel_aspect": clip.pixel_aspect,
        "colour_space": clip.colour_space,
        **clip.extra,
    }


def _relative(path: Path, folder: Path) -> str:
    if not path.is_absolute():
        return path.as_posix()
    try:
        return Path(os.path.relpath(path, folder.resolve())).as_posix()
    except ValueError:  # another drive
        return path.as_posix()


def _layer(layer: Layer) -> dict[str, Any]:
    moves = {} if layer.transform is None else {"transform": _transform(layer.transform)}
    return {
        "type": "Layer",
        "id": layer.id,
        "name": layer.name,
        "visible": layer.visible,
        "locked": layer.locked,
        "opacity": layer.opacity,
        "invert": layer.invert,
        **moves,
        "children": [_layer(c) if isinstance(c, Layer) else _shape(c) for c in layer.children],
        **layer.extra,
    }


def _transform(transform: LayerTransform) -> dict[str, Any]:
    return {
        "type": "LayerTransform",
        "frames": list(transform.frames),
        "matrices": transform.matrices.reshape(-1, 9).tolist(),
    }


def _shape(shape: RotoShape) -> dict[str, Any]:
    return {
        "type": "RotoShape",
        "id": shape.id,
        "name": shape.name,
        "closed": shape.closed,
        "colour": list(shape.colour),
        "blend": shape.blend.value,
        "opacity": shape.opacity,
        "invert": shape.invert,
        "feather": shape.feather,
        "motion_blur": None if shape.motion_blur is None else {"type": "MotionBlur", **vars(shape.motion_blur)},
        "lifetime": None if shape.lifetime is None else list(shape.lifetime),
        "visible": shape.visible,
        "locked": shape.locked,
        "spline": shape.spline.value,
        **({"link": shape.link} if shape.link else {}),
        **({} if shape.attached else {"attached": False}),
        **({"depth": [list(pair) for pair in shape.depth]} if shape.depth else {}),
        "keys": [_key(key) for key in shape.keys],
        **shape.extra,
    }


def _key(key: Keyframe) -> dict[str, Any]:
    document: dict[str, Any] = {
        "type": "Keyframe",
        "frame": key.frame,
        "origin": key.origin.value,
        "interpolation": key.interpolation.value,
        "points": key.points.reshape(-1, 6).tolist(),
    }
    if key.feather is not None:
        document["feather"] = key.feather.reshape(-1, 6).tolist()
    if key.confidence is not None:
        document["confidence"] = key.confidence
    if key.vertex_confidence is not None:
        document["vertex_confidence"] = key.vertex_confidence.tolist()
    if key.inputs:
        document["inputs"] = key.inputs
    return {**document, **key.extra}


def _lines(value: Any, indent: str = "") -> str:
    """JSON with one line for each list of plain values: a project file reads, and diffs, point by point."""
    deeper = indent + " "
    if isinstance(value, dict) and value:
        names = (json.dumps(name, ensure_ascii=False) for name in value)
        items = (f"{deeper}{name}: {_lines(item, deeper)}" for name, item in zip(names, value.values(), strict=True))
        return "{\n" + ",\n".join(items) + f"\n{indent}}}"
    if isinstance(value, list | tuple) and any(isinstance(item, dict | list | tuple) for item in value):
        return "[\n" + ",\n".join(deeper + _lines(item, deeper) for item in value) + f"\n{indent}]"
    return json.dumps(value, ensure_ascii=False, allow_nan=False)


# ---- reading ---------------------------------------------------------------------------------------------------------


def _finite(text: str) -> float:
    """A number of the file. JSON has no NaN and no infinity, though Python's reader lets them pass."""
    number = float(text)
    if not math.isfinite(number):
        raise ValueError(f"{text} is no number")
    return number


def _read_project(document: dict[str, Any], folder: Path) -> Project:
    clip, root = document["clip"], _read_layer(document["root"])
    ids = [root.id, *(item.id for item in root.items())]
    if len(set(ids)) < len(ids):
        raise ValueError("two of its layers or shapes have one id")
    return Project(
        clip=None if clip is None else _read_clip(clip, folder),
        root=root,
        marks=tuple(Mark(int(mark["frame"]), str(mark["text"])) for mark in document.get("marks", ())),
        extra=_rest(document, "type", "version", "clip", "root", "marks"),
    )


def _read_clip(document: dict[str, Any], folder: Path) -> Clip:
    path = Path(PurePosixPath(document["path"]))
    width, height = document["size"]
    return Clip(
        path=path if path.is_absolute() else Path(os.path.normpath(folder.resolve() / path)),
        first=int(document["first"]),
        last=int(document["last"]),
        size=(int(width), int(height)),
        fps=float(document["fps"]),
        pixel_aspect=float(document["pixel_aspect"]),
        colour_space=str(document["colour_space"]),
        extra=_rest(document, "type", "path", "first", "last", "size", "fps", "pixel_aspect", "colour_space"),
    )


def _read_layer(document: dict[str, Any]) -> Layer:
    readers: dict[str, Callable[[dict[str, Any]], Layer | RotoShape]]
    readers = {"Layer": _read_layer, "RotoShape": _read_shape}
    return Layer(
        id=str(document["id"]),
        name=str(document["name"]),
        visible=bool(document["visible"]),
        locked=bool(document["locked"]),
        opacity=float(document["opacity"]),
        invert=bool(document["invert"]),
        transform=_read_transform(document.get("transform")),
        children=tuple(readers[child["type"]](child) for child in document["children"]),
        extra=_rest(document, "type", "id", "name", "visible", "locked", "opacity", "invert", "transform", "children"),
    )


def _read_transform(document: dict[str, Any] | None) -> LayerTransform | None:
    if document is None:
        return None
    matrices = np.asarray(document["matrices"], dtype=np.float64).reshape(-1, 3, 3)
    return LayerTransform(tuple(int(frame) for frame in document["frames"]), matrices)


def _read_shape(document: dict[str, Any]) -> RotoShape:
    red, green, blue = document["colour"]
    blur, lifetime = document["motion_blur"], document["lifetime"]
    return RotoShape(
        id=str(document["id"]),
        name=str(document["name"]),
        closed=bool(document["closed"]),
        colour=(float(red), float(green), float(blue)),
        blend=BlendMode(document["blend"]),
        opacity=float(document["opacity"]),
        invert=bool(document["invert"]),
        feather=float(document["feather"]),
        motion_blur=None if blur is None else _read_blur(blur),
        lifetime=None if lifetime is None else (int(lifetime[0]), int(lifetime[1])),
        visible=bool(document["visible"]),
        locked=bool(document["locked"]),
        spline=Spline(document.get("spline", Spline.BEZIER)),
        link=str(document.get("link", "")),
        attached=bool(document.get("attached", True)),
        depth=tuple((int(frame), int(level)) for frame, level in document.get("depth", ())),
        keys=tuple(_read_key(key) for key in document["keys"]),
        extra=_rest(
            document, "type", "id", "name", "closed", "colour", "blend", "opacity", "invert", "feather", "motion_blur",
            "lifetime", "visible", "locked", "spline", "link", "attached", "depth", "keys",
        ),
    )  # fmt: skip


def _read_blur(document: dict[str, Any]) -> MotionBlur:
    return MotionBlur(float(document["shutter"]), float(document["phase"]), int(document["samples"]))


def _read_key(document: dict[str, Any]) -> Keyframe:
    feather, vertices, confidence = (document.get(k) for k in ("feather", "vertex_confidence", "confidence"))
    return Keyframe(
        frame=int(document["frame"]),
        origin=Origin(document["origin"]),
        interpolation=Interpolation(document["interpolation"]),
        points=_read_points(document["points"]),
        feather=None if feather is None else _read_points(feather),
        confidence=None if confidence is None else float(confidence),
        vertex_confidence=None if vertices is None else np.asarray(vertices, dtype=np.float64),
        inputs=str(document.get("inputs", "")),
        extra=_rest(
            document, "type", "frame", "origin", "interpolation", "points", "feather", "confidence",
            "vertex_confidence", "inputs",
        ),
    )  # fmt: skip


def _read_points(rows: list[list[float]]) -> Any:
    return np.asarray(rows, dtype=np.float64).reshape(-1, 3, 2)


def _rest(document: Mapping[str, Any], *known: str) -> dict[str, Any]:
    return {name: value for name, value in document.items() if name not in known}


def _reason(error: BaseException) -> str:
    if isinstance(error, KeyError):
        return f"{error.args[0]!r} is missing or unknown"
    text = str(error)
    return text[:200] if text else type(error).__name__
