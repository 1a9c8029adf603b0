"""Plain data of a project file, of the present version, as the project: every value is of its type and bounded."""

from __future__ import annotations

import os
from pathlib import Path, PurePosixPath
from typing import Any

from roam_core.media.finding import is_there, origin_in
from roam_core.roto.animated import Animatable, Animated, Interpolation, Slopes, ValueKey
from roam_core.roto.bounds import MAX_DEPTH, MAX_SPAN, Count, require
from roam_core.roto.keyframe import Keyframe
from roam_core.roto.motion_blur import MotionBlur
from roam_core.roto.packing import number, rest, text, unpacked_keys, unpacked_numbers, whole
from roam_core.roto.placement import LayerTransform
from roam_core.roto.project import Clip, Layer, Mark, Project
from roam_core.roto.shape import BlendMode, RotoShape, Spline
from roam_core.translatable import N_, sentence

LONGEST_PATH = 1 << 15
"""Letters of a plate's path."""
LARGEST_SIDE = 1 << 16
"""Pixels."""

Document = dict[str, Any]


def read_project(document: Document, folder: Path) -> Project:
    """The project; relative media paths are taken from `folder`.

    Raises
    ------
    KeyError, TypeError, ValueError, AttributeError, OverflowError, RecursionError
        when the data are damaged.
    """
    clip, root = document["clip"], _read_layer(document["root"], Count(), 0)
    names: dict[str, str] = {}
    for item in (root, *root.items()):
        if item.id in names:
            told = sentence("{first!r} and {second!r} have one id", first=names[item.id], second=item.name)
            raise ValueError(told)
        names[item.id] = item.name
    return Project(
        clip=None if clip is None else _read_clip(clip, folder),
        root=root,
        marks=tuple(_read_mark(mark) for mark in document.get("marks", ())),
        extra=rest(document, "type", "version", "clip", "root", "marks"),
    )


def _read_mark(document: Document) -> Mark:
    return Mark(
        frame=whole(document["frame"], N_("the frame of a mark")),
        text=text(document["text"], N_("the text of a mark")),
        extra=rest(document, "type", "frame", "text"),
    )


def _read_clip(document: Document, folder: Path) -> Clip:
    width, height = document["size"]
    first, last = (
        whole(document["first"], N_("the clip's first frame")),
        whole(document["last"], N_("the clip's last frame")),
    )
    require(last - first + 1, MAX_SPAN + 1, N_("frames in its clip"))
    if last < first:
        raise ValueError(
            sentence("its clip ends, on frame {last}, before it begins, on frame {first}", last=last, first=first)
        )
    return Clip(
        path=_read_path(document, folder),
        first=first,
        last=last,
        size=(
            whole(width, N_("the clip's width"), 1, LARGEST_SIDE),
            whole(height, N_("the clip's height"), 1, LARGEST_SIDE),
        ),
        fps=number(document["fps"], N_("the clip's fps"), 1e-3, 1e6),
        pixel_aspect=number(document["pixel_aspect"], N_("the clip's pixel_aspect"), 1e-3, 1e3),
        colour_space=text(document["colour_space"], N_("the clip's colour_space")),
        content=text(document.get("content", ""), N_("the clip's content")),
        layer=text(document.get("layer", ""), N_("the clip's layer")),
        extra=rest(
            document, "type", "path", "absolute", "first", "last", "size", "fps", "pixel_aspect", "colour_space",
            "content", "layer",
        ),
    )  # fmt: skip


def _read_path(document: Document, folder: Path) -> Path:
    """Where the plate lies: from the project's folder; if it is not there, where it lay when the project was saved."""
    words = (
        text(document["path"], N_("the clip's path")),
        text(document.get("absolute", ""), N_("the clip's absolute path")),
    )
    require(max(map(len, words)), LONGEST_PATH, N_("letters in the clip's path"))
    if any("\0" in word for word in words):
        raise ValueError(sentence("the clip's path holds a null character"))
    path, absolute = (Path(PurePosixPath(word)) for word in words)
    if path.is_absolute():
        return path
    path = Path(os.path.normpath(Path(origin_in(folder)) / path))
    return absolute if words[1] and absolute.is_absolute() and not is_there(path) and is_there(absolute) else path


def _read_layer(document: Document, count: Count, depth: int) -> Layer:
    require(depth, MAX_DEPTH, N_("layers in layers"))
    children: list[Layer | RotoShape] = []
    for child in document["children"]:
        if child["type"] == "Layer":
            children.append(_read_layer(child, count, depth + 1))
        elif child["type"] == "RotoShape":
            shape = _read_shape(child, count)
            count.shape(shape)
            children.append(shape)
        else:
            raise ValueError(sentence("what stands among the layers is no layer and no shape"))
    transform = document.get("transform")
    layer = Layer(
        id=text(document["id"], N_("the id of a layer")),
        name=text(document["name"], N_("the name of a layer")),
        visible=_flag(document, "visible"),
        locked=_flag(document, "locked"),
        opacity=_read_value(document["opacity"], N_("the opacity of a layer"), count),
        invert=_flag(document, "invert"),
        blend=BlendMode(document.get("blend", BlendMode.ADD)),
        transform=None if transform is None else _read_transform(transform),
        children=tuple(children),
        extra=rest(
            document, "type", "id", "name", "visible", "locked", "opacity", "invert", "blend", "transform", "children"
        ),
    )
    count.layer(layer, depth)
    return layer


def _read_transform(document: Document) -> LayerTransform:
    return LayerTransform(
        frames=tuple(whole(frame, N_("a frame of a transform")) for frame in document["frames"]),
        matrices=unpacked_numbers(document["matrices"]),
        confidence=tuple(_read_confidence(pair) for pair in document.get("confidence", ())),
        adjusted=tuple(whole(frame, N_("an adjust key")) for frame in document.get("adjusted", ())),
        surface=tuple(_read_place(corner) for corner in document.get("surface", ())),
        points=tuple(_read_place(place) for place in document.get("points", ())),
        areas=tuple(number(size, N_("an area of a track's points"), 0.0, 1e6) for size in document.get("areas", ())),
        extra=rest(document, "type", "frames", "matrices", "confidence", "adjusted", "surface", "points", "areas"),
    )


def _read_confidence(pair: Any) -> tuple[int, float]:
    frame, value = pair
    return whole(frame, N_("a frame of a track")), number(value, N_("the confidence of a track"), 0.0, 1.0)


def _read_place(pair: Any) -> tuple[float, float]:
    x, y = pair
    return number(x, N_("a place of a track")), number(y, N_("a place of a track"))


def _read_shape(document: Document, count: Count) -> RotoShape:
    red, green, blue = document["colour"]
    blur, lifetime = document["motion_blur"], document["lifetime"]
    return RotoShape(
        id=text(document["id"], N_("the id of a shape")),
        name=text(document["name"], N_("the name of a shape")),
        closed=_flag(document, "closed"),
        colour=(number(red, N_("a colour")), number(green, N_("a colour")), number(blue, N_("a colour"))),
        blend=BlendMode(document["blend"]),
        opacity=_read_value(document["opacity"], N_("the opacity of a shape"), count),
        invert=_flag(document, "invert"),
        feather=_read_value(document["feather"], N_("the feather of a shape"), count),
        motion_blur=None if blur is None else _read_blur(blur),
        lifetime=None if lifetime is None else _read_pair(lifetime, N_("a lifetime")),
        visible=_flag(document, "visible"),
        locked=_flag(document, "locked"),
        spline=Spline(document.get("spline", Spline.BEZIER)),
        link=text(document.get("link", ""), N_("the link of a shape")),
        attached=_flag(document, "attached") if "attached" in document else True,
        depth=tuple(sorted(_read_pair(pair, N_("a depth")) for pair in document.get("depth", ()))),
        compound=text(document.get("compound", ""), N_("the compound of a shape")),
        keys=_read_keys(document["keys"], count),
        extra=rest(
            document, "type", "id", "name", "closed", "colour", "blend", "opacity", "invert", "feather", "motion_blur",
            "lifetime", "visible", "locked", "spline", "link", "attached", "depth", "compound", "keys",
        ),
    )  # fmt: skip


def _read_value(value: Any, name: str, count: Count) -> Animatable:
    if not isinstance(value, dict):
        return number(value, name)
    if value["type"] != "Animated":
        raise ValueError(sentence("{name} is no number and no animated value", name=sentence(name)))
    count.keys(len(value["keys"]))
    keys = tuple(_read_value_key(key, name) for key in value["keys"])
    return Animated(keys, extra=rest(value, "type", "keys"))


def _read_value_key(document: Document, name: str) -> ValueKey:
    return ValueKey(
        frame=whole(document["frame"], N_("a frame of {name}"), of=name),
        value=number(document["value"], name),
        interpolation=Interpolation(document["interpolation"]),
        slopes=None if "slopes" not in document else _read_slopes(document["slopes"], name),
        extra=rest(document, "type", "frame", "value", "interpolation", "slopes"),
    )


def _read_slopes(pair: Any, name: str) -> Slopes:
    arriving, leaving = pair
    return number(arriving, N_("a tangent of {name}"), of=name), number(leaving, N_("a tangent of {name}"), of=name)


def _read_keys(documents: list[Document], count: Count) -> tuple[Keyframe, ...]:
    """The keys. What was read is let go of on the way: text and numbers of a large project are not held at once."""
    keys: list[Keyframe] = []
    for index, document in enumerate(documents):
        count.keys(len(document.get("frames", "1")))
        keys.extend(unpacked_keys(document))
        documents[index] = {}
    return tuple(keys)


def _read_blur(document: Document) -> MotionBlur:
    return MotionBlur(
        shutter=number(document["shutter"], N_("the shutter of motion blur"), -1e6, 1e6),
        phase=number(document["phase"], N_("the phase of motion blur"), -1e6, 1e6),
        samples=whole(document["samples"], N_("the number of samples of motion blur")),
        extra=rest(document, "type", "shutter", "phase", "samples"),
    )


def _read_pair(pair: Any, name: str) -> tuple[int, int]:
    first, second = pair
    return whole(first, name), whole(second, name)


def _flag(document: Document, name: str) -> bool:
    value = document[name]
    if not isinstance(value, bool):
        raise ValueError(sentence("{name} is neither true nor false", name=name))
    return value
