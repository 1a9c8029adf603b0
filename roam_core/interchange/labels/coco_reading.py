"""COCO instances as shapes: polygons become polygon shapes with keys on their frames, runs go through fitted masks."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Any

import cv2
import numpy as np

from roam_core.arrays import Array, Bools
from roam_core.errors import RoamError
from roam_core.interchange.labels.polygons import mask_of, polygon_key, runs_of_text
from roam_core.interchange.reading import Imported, ShapeReader, are_numbers, brief, sensible
from roam_core.matte.vectorise import shapes_from_mask
from roam_core.roto import Layer, RotoShape
from roam_core.translatable import said_by, sentence

MAX_RUNS, MAX_RUNS_OF_ONE = 40_000, 12_000
"""Of all masks of a file, and of one: noise has more, and shapes are not fitted to it in any time."""

MAX_OUTLINES, MAX_OUTLINES_OF_ONE = 256, 48
"""Of all masks of a file, and of one, holes among them: to fit a shape to one takes about a tenth of a second."""

MAX_PIXELS = 1 << 24
"""Of all masks of a file that are given as runs: fitting shapes to more takes too long without a word of progress."""


def is_coco(document: Any) -> bool:
    """True for what has the lists of a data set of instances."""
    return isinstance(document, dict) and all(isinstance(document.get(w), list) for w in ("images", "annotations"))


@dataclass
class CocoReader(ShapeReader):
    """Gathers annotations by track, or by category and number where the file knows no tracks."""

    _frames_told: list[int] = field(default_factory=list)
    _edges: int = 0
    _outlines: int = 0
    _follows: dict[int, int] = field(default_factory=dict)

    def shapes(self, document: dict[str, Any]) -> Imported:
        """All instances: a layer for each track that has several shapes."""
        self.check_parts(len(document["images"]) + len(document["annotations"]))
        images = [image for image in document["images"] if isinstance(image, dict)]
        frames, size = self._frames(images), self._size(images)
        categories = document.get("categories")
        names = {
            category.get("id"): str(category.get("name", ""))
            for category in (categories if isinstance(categories, list) else ())
            if isinstance(category, dict) and isinstance(category.get("id"), int)
        }
        tracks: dict[tuple[Any, ...], dict[int, Any]] = {}
        for row in document["annotations"]:
            if not isinstance(row, dict) or (image := _id(row.get("image_id"))) not in frames:
                self.note(sentence("Annotations without an image of the file were left out."))
                continue
            frame, name = frames[image], names.get(_id(row.get("category_id")), "Object")
            if row.get("segmentation") in (None, []):
                self.note(sentence("{name} has boxes without outlines, which were left out.", name=brief(name)))
                continue
            key = self._track(row, name)
            number = 0
            while frame in tracks.get((*key, number), {}):
                number += 1
                self.check_parts()
            tracks.setdefault((*key, number), {})[frame] = row.get("segmentation")
        self._frames_told = sorted(set(frames.values()))
        self._follows = dict(pairwise(self._frames_told))
        items = [item for key, rows in tracks.items() for item in self._object(key[0], rows)]
        if not items:
            self.note(sentence("There are no instances with an outline in the file."))
        return self.finished(tuple(items), size)

    def _track(self, row: dict[str, Any], name: str) -> tuple[Any, ...]:
        attributes = row.get("attributes")
        inner = attributes.get("track_id") if isinstance(attributes, dict) else None
        track = row.get("track_id", row.get("instance_id", inner))
        return (name, str(track)) if isinstance(track, int | str) else (name,)

    def _size(self, images: list[dict[str, Any]]) -> tuple[float, float] | None:
        sizes = {(image.get("width"), image.get("height")) for image in images if are_numbers(_sides(image))}
        if len(sizes) > 1:
            raise RoamError(
                sentence(
                    "{path} speaks of pictures of several sizes, which cannot be frames of one clip.", path=self.called
                )
            )
        if not sizes:
            return None
        width, height = sizes.pop()
        if not (1 <= float(width or 0) < 1e6 and 1 <= float(height or 0) < 1e6):
            raise RoamError(
                sentence("{path} cannot be read: width and height of its images must be positive.", path=self.called)
            )
        return float(width or 0), float(height or 0)

    def _frames(self, images: list[dict[str, Any]]) -> dict[Any, int]:
        """The clip's frame of each image: by its `frame`, else by the number in its name, else by its place."""
        ids = [_id(image.get("id")) for image in images]
        told = [image.get("frame") for image in images]
        if images and all(isinstance(frame, int) and not isinstance(frame, bool) for frame in told):
            found = [self._framed(frame) for frame in told]
        else:
            found = self._numbered([str(image.get("file_name", "")) for image in images])
            if not found:
                found = [self.clip.first + k for k in range(len(images))]
                self.note(
                    sentence("The images' names do not number the clip's frames: they were taken in their order.")
                )
        return {key: frame for key, frame in zip(ids, found, strict=True) if key is not None}

    def _numbered(self, names: list[str]) -> list[int]:
        """The clip's frames by the group of digits that counts the images, the last that does; none without one."""
        words = [re.findall(r"\d{1,9}", re.sub(r"\.(?!\d+$)\w+$", "", name)[-200:]) for name in names]
        for place in range(1, min(map(len, words), default=0) + 1):
            numbers = [int(word[-place]) for word in words]
            if len(set(numbers)) == len(names):
                frames = [self._framed(number) for number in numbers]
                if set(frames) & set(self.clip.frame_range):
                    return frames
        return []

    def _framed(self, number: Any) -> int:
        try:
            return self.frame(float(number))
        except (ValueError, OverflowError) as error:
            raise RoamError(
                sentence("{path} cannot be read: {reason}.", path=self.called, reason=said_by(error))
            ) from None

    # ---- objects -----------------------------------------------------------------------------------------------------

    def _object(self, name: str, rows: dict[int, Any]) -> list[Layer | RotoShape]:
        """The shapes of one object, in a layer of its name where they are several."""
        masks = {frame: row for frame, row in rows.items() if isinstance(row, dict)}
        parts: dict[int, dict[int, Array]] = {}
        for frame, row in rows.items():
            if isinstance(row, list):
                for number, polygon in enumerate(row):
                    if (places := self._places(polygon, name)) is not None:
                        parts.setdefault(number, {})[frame] = places
        shapes = [shape for part in parts.values() for shape in self._keyed(name, part)]
        shapes += self._masked(name, masks)
        if len(shapes) < 2:
            return [*shapes]
        compound = self.fresh_id("compound")
        pieces = tuple(replace(shape, compound=compound) for shape in shapes)
        return [Layer(self.fresh_id("layer"), name, pieces)]

    def _places(self, polygon: Any, name: str) -> Array | None:
        if not isinstance(polygon, list) or len(polygon) < 6 or len(polygon) % 2 or not are_numbers(polygon):
            self.note(sentence("A polygon of {name} is damaged and was left out.", name=brief(name)))
            return None
        return np.array(polygon, dtype=np.float64).reshape(-1, 2)

    def _keyed(self, name: str, part: dict[int, Array]) -> list[RotoShape]:
        """Shapes with keys on the frames of one part: a new one where it was away or its points change in number."""
        follows = self._follows
        runs: list[list[int]] = []
        for frame in sorted(part):
            if runs and follows.get(runs[-1][-1]) == frame and len(part[frame]) == len(part[runs[-1][-1]]):
                runs[-1].append(frame)
            else:
                runs.append([frame])
        made = []
        for run in runs:
            self.check_points(len(run) * len(part[run[0]]), name, len(run))
            keys = tuple(polygon_key(frame, part[frame]) for frame in run)
            if sensible(keys):
                lifetime = None if len(run) == len(self._frames_told) else (run[0], follows.get(run[-1], run[-1] + 1))
                made.append(RotoShape(self.fresh_id("shape"), name, keys, lifetime=lifetime))
            else:
                self.note(sentence("{name} was left out: it lies nowhere near the image.", name=brief(name)))
        if len(made) > 1:
            self.note(
                sentence(
                    "{name} comes and goes, or changes its number of points: it became several shapes.",
                    name=brief(name),
                )
            )
        return made

    def _masked(self, name: str, masks: dict[int, Any]) -> list[RotoShape]:
        """Shapes fitted to what is given as runs, anew after a frame without."""
        runs: list[list[int]] = []
        for frame in sorted(masks):
            if runs and self._follows.get(runs[-1][-1]) == frame:
                runs[-1].append(frame)
            else:
                runs.append([frame])
        return [shape for run in runs for shape in self._fitted(name, masks, run)]

    def _fitted(self, name: str, masks: dict[int, Any], run: list[int]) -> list[RotoShape]:
        from roam_core.proposal.mask_keys.keys import keys_from_mask  # numba: a command's help must not wait for it

        shapes: list[RotoShape] = []
        for frame in run:
            self.options.advance(0.0, sentence("Mask of frame {frame}", frame=frame))
            try:
                mask = self._mask(masks[frame])
            except (ValueError, TypeError, OverflowError) as error:
                self.note(
                    sentence(
                        "A mask of {name} is damaged and was left out ({reason}).",
                        name=brief(name),
                        reason=said_by(error),
                    )
                )
                continue
            if not mask.any():
                continue
            picture = mask.astype(np.uint8) * 255
            shapes = keys_from_mask(shapes, picture, frame) if shapes else shapes_from_mask(picture, frame)
            self.check_points(sum(shape.point_count for shape in shapes), name, len(shapes))
        whole = (run[0], self._follows.get(run[-1], run[-1] + 1))
        made = []
        for shape in shapes:
            start, stop = whole if shape.lifetime is None else shape.lifetime
            lifetime = (max(start, whole[0]), min(stop, whole[1]))
            always = len(run) == len(self._frames_told) and lifetime == whole
            made.append(
                RotoShape(
                    self.fresh_id("shape"),
                    name,
                    shape.keys,
                    blend=shape.blend,
                    lifetime=None if always else lifetime,
                )
            )
        return [shape for shape in made if shape.lifetime is None or shape.lifetime[0] < shape.lifetime[1]]

    def _mask(self, values: dict[str, Any]) -> Bools:
        size, runs = values.get("size"), values.get("counts")
        if not isinstance(size, list) or len(size) != 2 or not all(type(n) is int and 0 < n < 1 << 16 for n in size):
            raise ValueError(sentence("its size must be a height and a width"))
        self.check_parts(size[0] * size[1] * 1_000_000 // MAX_PIXELS // 2 + 1)
        if isinstance(runs, str):
            self.check_parts(len(runs) // 8)
            runs = runs_of_text(runs)
        if not isinstance(runs, list) or not all(type(run) is int for run in runs):
            raise ValueError(sentence("its counts must be whole numbers"))
        self._edges += len(runs)
        if self._edges > MAX_RUNS:
            raise RoamError(
                sentence(
                    "{path} holds masks of more than {most} runs; bring them in as pictures of masks.",
                    path=self.called,
                    most=MAX_RUNS,
                )
            )
        if len(runs) > MAX_RUNS_OF_ONE:
            raise ValueError(sentence("it has more than {most} runs", most=MAX_RUNS_OF_ONE))
        mask = mask_of(runs, size[0], size[1])
        outlines = cv2.findContours(mask.astype(np.uint8), cv2.RETR_CCOMP, cv2.CHAIN_APPROX_NONE)[0]
        if len(outlines) > MAX_OUTLINES_OF_ONE:
            raise ValueError(sentence("it falls into more than {most} parts and holes", most=MAX_OUTLINES_OF_ONE))
        self._outlines += len(outlines)
        if self._outlines > MAX_OUTLINES:
            raise RoamError(
                sentence(
                    "{path} holds masks of more than {most} parts and holes; bring them in as pictures of masks.",
                    path=self.called,
                    most=MAX_OUTLINES,
                )
            )
        return mask


def _id(value: Any) -> int | str | None:
    """A number or word by which a file names one of its parts; None for what is neither."""
    return value if isinstance(value, int | str) else None


def _sides(image: dict[str, Any]) -> list[Any]:
    return [image.get("width"), image.get("height")]
