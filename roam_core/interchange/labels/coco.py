"""COCO instances for those who label data: every object on every frame as polygons, or as runs where it has holes.

An object is what lies directly in the root: a shape, or a layer with all that lies in it; its name is its category, its
`track_id` the same on all frames. Sources: the format's own description, and the code that rasterises it (`maskApi.c`):
positions are pixels from the image's top-left corner, y down, and a pixel is inside where its centre is. Runs count
pixels column after column, zeros first.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import numpy as np

from roam_core.atomic_write import write_atomically
from roam_core.interchange.flatten import is_feathered
from roam_core.interchange.labels.pictures import file_names_of, made_up_name
from roam_core.interchange.labels.polygons import JOINING, STRAYING, Flattener, area, clipped, runs_of
from roam_core.interchange.labels.presence import is_dimmed
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter, readied, settled
from roam_core.matte import render_matte
from roam_core.matte.compose import Draw, cut_patch
from roam_core.matte.rasterise import Patch, shape_patch
from roam_core.roto import Animated, BlendMode, Interpolation, Layer, Project, RotoShape, ValueKey
from roam_core.roto.animated import Animatable, value_at, values_of
from roam_core.translatable import N_, listed, sentence

Item = Layer | RotoShape

CUTTING = {BlendMode.SUBTRACT, BlendMode.INTERSECT}
"""Modes of what changes the objects under it and is none itself."""

DIGITS = 3
"""Decimals of a coordinate: a thousandth of a pixel."""


@dataclass(frozen=True)
class CocoExporter:
    """Writes the objects of a project as the instances of a data set: one file, an image a frame.

    Attributes
    ----------
    asks_plate : images have the names of the plate's files, whose folder is read; without, names are made up.
    """

    asks_plate: bool = True

    name = "coco"
    title = N_("COCO instances")
    suffix = ".json"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write the objects on all chosen frames."""
        document, notes, losses = coco_document(project, options, asks_plate=self.asks_plate)
        told = settled(notes, losses, options)
        options.advance(1.0, sentence("Writing {name}", name=path.name))
        write_atomically(path, (_dumps(document) + "\n").encode("ascii"))
        return told


def coco_document(
    project: Project, options: ExportOptions = STANDARD, *, asks_plate: bool = True
) -> tuple[dict[str, Any], list[str], list[str]]:
    """The data set as plain values, sentences on what it cannot hold, and on what it shows otherwise."""
    project = readied(project, options, are_labels=True)
    clip = project.require_clip()
    writer = _Writer(clip, replace(options, progress=None), len(project.shapes))
    if asks_plate:
        writer.name_images(file_names_of(clip))
    root = writer.prepared(project.root)
    return writer.document(root, options), writer.notes, writer.losses


@dataclass
class _Writer(ShapeWriter):
    flatteners: dict[str, Flattener] = field(default_factory=dict)
    files: Mapping[int, str] | None = None
    """The names of the plate's files by their frames; None where they are made up."""
    cut_on: int | None = None
    cut: dict[int, Patch] = field(default_factory=dict)
    """What cuts objects on the frame `cut_on`, by the identity of the shapes."""

    def name_images(self, files: Mapping[int, str] | None) -> None:
        """Images are these files of the plate, and frames without one are no images; what that leaves out is told."""
        self.files, chosen = files, self.options.frames_of(self.clip)
        if files is None:
            self.notes.append(
                sentence(
                    "{plate} gives no picture files: the images' names are made up, as {name}.",
                    plate=self.clip.name,
                    name=made_up_name(self.clip, chosen[0] + self.options.frame_offset),
                )
            )
        elif missing := [frame for frame in chosen if frame not in files]:
            self.notes.append(
                sentence(
                    "Frames without a picture are left out of the images: {count}, the first is {first}.",
                    count=len(missing),
                    first=missing[0],
                )
            )

    def prepared(self, layer: Layer) -> Layer:
        """The layer with the keys that are to be written, hard and opaque; what that leaves out is told."""
        children: list[Item] = []
        for child in layer.children:
            if not layer.visible:
                child = replace(child, visible=False)
            if isinstance(child, Layer):
                children.append(self.prepared(child))
                continue
            shape = self.begun(child)
            if not shape.closed or not shape.visible:
                self.notes.append(
                    sentence("{name!r} is open or invisible, no object: it is left out.", name=shape.name)
                )
                continue
            self._tell(shape)
            keys = tuple(replace(key, feather=None) for key in shape.keys)
            opacity = self._there(shape.opacity)
            if any(values_of(opacity)):
                children.append(replace(shape, keys=keys, feather=0.0, opacity=opacity, motion_blur=None))
        self._tell_dimmed(layer)
        return replace(layer, children=tuple(children), opacity=self._there(layer.opacity))

    def _there(self, opacity: Animatable) -> Animatable:
        """1 where something of it is seen, 0 on the frames on which nothing is: there it is no object."""
        hold, keys = Interpolation.HOLD, list[ValueKey]()
        for frame in self.options.frames_of(self.clip):
            value = float(value_at(opacity, frame) > 0.0)
            if not keys or keys[-1].value != value:
                keys.append(ValueKey(frame, value, hold))
        return Animated(tuple(keys)) if len(keys) > 1 else keys[0].value

    def _tell(self, shape: RotoShape) -> None:
        left = [
            word
            for word, is_so in (
                (sentence("feather"), is_feathered(shape)),
                (sentence("motion blur"), shape.is_blurred),
            )
            if is_so
        ]
        if left:
            self.notes.append(
                sentence("Objects are hard, without the {left} of {name!r}.", left=listed(left), name=shape.name)
            )
        self._tell_dimmed(shape)

    def _tell_dimmed(self, item: Item) -> None:
        if item.visible and is_dimmed(item, self.options.frames_of(self.clip)):
            self.notes.append(sentence("Objects are opaque: the opacity of {name!r} is left out.", name=item.name))

    def document(self, root: Layer, told_to: ExportOptions) -> dict[str, Any]:
        """The data set; `told_to` hears of each frame."""
        objects = self._objects(root)
        if root.invert or not root.visible:
            self.losses.append(sentence("The inversion and visibility of the root layer are lost: it is no object."))
        names = list(dict.fromkeys(item.name for item, _ in objects))
        chosen, (width, height) = self.options.frames_of(self.clip), self.clip.size
        frames = [frame for frame in chosen if self.files is None or frame in self.files]
        images: list[dict[str, Any]] = []
        annotations: list[dict[str, Any]] = []
        for number, frame in enumerate(frames, start=1):
            told_to.advance(number / (len(frames) + 1), sentence("Frame {frame}", frame=frame))
            told = frame + self.options.frame_offset
            file_name = made_up_name(self.clip, told) if self.files is None else self.files[frame]
            images.append({"id": number, "width": width, "height": height, "file_name": file_name, "frame": told})
            for track, (item, cutters) in enumerate(objects, start=1):
                found = self._segmentation(item, cutters, frame)
                if found is not None:
                    kind = names.index(item.name) + 1
                    ids = {"id": len(annotations) + 1, "image_id": number, "category_id": kind, "track_id": track}
                    annotations.append({**ids, **found, "iscrowd": 0})
        self.notes.append(STRAYING)
        categories = [{"id": k, "name": name, "supercategory": ""} for k, name in enumerate(names, start=1)]
        return {
            "info": {"description": "Shapes from ROAM", "version": "1.0"},
            "licenses": [],
            "images": images,
            "categories": categories,
            "annotations": annotations,
        }

    def _objects(self, root: Layer) -> list[tuple[Item, tuple[Item, ...]]]:
        """Each object, with what lies above it and cuts it."""
        objects: list[tuple[Item, tuple[Item, ...]]] = []
        items = [item for item in root.children if item.visible]
        for k, item in enumerate(items):
            if item.blend in CUTTING:
                continue
            if item.blend is BlendMode.DIFFERENCE and k:
                self.losses.append(
                    sentence("COCO has no mode 'difference': {name!r} is an object of its own.", name=item.name)
                )
            above = tuple(other for other in items[k + 1 :] if other.blend in CUTTING)
            objects.append((replace(item, blend=BlendMode.ADD), above))
        return objects

    def _segmentation(self, item: Item, cutters: tuple[Item, ...], frame: int) -> dict[str, Any] | None:
        """Polygons where shapes lie side by side, else the pixels that are inside; None where there is nothing."""
        if item.opacity_at(frame) == 0.0:
            return None
        shapes = _side_by_side(item)
        if shapes is None or any(_exists(cutter, frame) for cutter in cutters):
            return self._runs(item, cutters, frame)
        polygons, seen = [], []
        for shape in shapes:
            if not shape.exists_at(frame) or shape.opacity_at(frame) == 0.0:
                continue
            if shape.id not in self.flatteners:
                self.flatteners[shape.id] = Flattener(shape)
            places = clipped(self.flatteners[shape.id].places(shape.at(frame).points), self.clip.size)
            places = places.round(DIGITS)
            if len(places) > 2 and area(places) > 0.0:
                polygons.append(places)
                seen.append(shape)
        if not polygons:
            return None
        every = np.concatenate(polygons)
        (left, top), (right, bottom) = every.min(axis=0), every.max(axis=0)
        return {
            "segmentation": [places.ravel().tolist() for places in polygons],
            "area": round(area(polygons[0]) if len(polygons) == 1 else self._joint_area(seen, frame), DIGITS),
            "bbox": [round(float(value), DIGITS) for value in (left, top, right - left, bottom - top)],
        }

    def _joint_area(self, shapes: list[RotoShape], frame: int) -> float:
        """The area of the union: shapes of one object may overlap."""
        alone = tuple(replace(shape, blend=BlendMode.MAX) for shape in shapes)
        matte = render_matte(Layer("object", "", alone), frame, (self.clip.size[1], self.clip.size[0]))
        return float(matte.sum(dtype=np.float64))

    def _runs(self, item: Item, cutters: tuple[Item, ...], frame: int) -> dict[str, Any] | None:
        size = self.clip.size[1], self.clip.size[0]
        patch = cut_patch(item, cutters, frame, size, self._remembering(cutters, frame))
        mask = patch.values > 0.5
        if not mask.any():
            return None
        rows, columns = np.flatnonzero(mask.any(axis=1)), np.flatnonzero(mask.any(axis=0))
        corner = patch.top, patch.left
        box = [patch.left + columns[0], patch.top + rows[0], columns[-1] - columns[0] + 1, rows[-1] - rows[0] + 1]
        return {
            "segmentation": {"size": list(size), "counts": runs_of(mask, corner, size)},
            "area": int(mask.sum()),
            "bbox": [int(value) for value in box],
        }

    def _remembering(self, cutters: tuple[Item, ...], frame: int) -> Draw:
        """Fills shapes for one object: each once, and on a frame once for all objects what cuts more than one."""
        if self.cut_on != frame:
            self.cut_on, self.cut = frame, {}
        cutting = {id(shape) for cutter in cutters for shape in _shapes_of(cutter)}
        own: dict[int, Patch] = {}

        def drawn(shape: RotoShape, frame: float, size: tuple[int, int]) -> Patch:
            known = self.cut if id(shape) in cutting else own
            if id(shape) not in known:
                known[id(shape)] = shape_patch(shape, frame, size)
            return known[id(shape)]

        return drawn


def _shapes_of(item: Item) -> Iterable[RotoShape]:
    return item.shapes() if isinstance(item, Layer) else (item,)


def _side_by_side(item: Item) -> list[RotoShape] | None:
    """The shapes of an object that is their union, or None."""
    if item.invert:
        return None
    if isinstance(item, RotoShape):
        return [item]
    found: list[RotoShape] = []
    for child in item.children:
        if not child.visible:
            continue
        varies = isinstance(child, Layer) and child.opacity != 1.0
        shapes = _side_by_side(child) if child.blend in JOINING and not varies else None
        if shapes is None:
            return None
        found += shapes
    return found


def _exists(item: Item, frame: int) -> bool:
    return item.exists_at(frame) if isinstance(item, RotoShape) else True


def _dumps(document: dict[str, Any]) -> str:
    """JSON with one image, category or annotation a line."""

    def lines() -> Iterator[str]:
        for word, value in document.items():
            if isinstance(value, list) and value:
                rows = ",\n".join(f"  {json.dumps(row, separators=(',', ':'))}" for row in value)
                yield f' "{word}": [\n{rows}\n ]'
            else:
                yield f' "{word}": {json.dumps(value)}'

    return "{\n" + ",\n".join(lines()) + "\n}"
