"""CVAT's XML, of videos and of images, as polygon shapes: the keys are the file's keyframes."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import pairwise
from pathlib import Path
from xml.etree.ElementTree import Element

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.interchange.labels.cvat import NAME
from roam_core.interchange.labels.polygons import polygon_key
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, ShapeReader, brief, quietly, sensible
from roam_core.interchange.svg.path import Spline, ellipse
from roam_core.interchange.xml import local_name, parsed
from roam_core.roto import Clip, Interpolation, Keyframe, Layer, RotoShape
from roam_core.translatable import N_, sentence

MAX_XML = 24 << 20
"""Bytes of a file that is read."""

OUTLINES = {"polygon", "polyline", "box", "ellipse"}


class CvatImporter:
    """Reads annotations of videos and of images."""

    name = "cvat"
    title = N_("CVAT")
    suffixes = (".xml",)

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read every track, and every outline of single images; CVAT's frame 0 is the clip's first."""
        return _Reader(path, clip, options).shapes()


@dataclass
class _Moment:
    """An outline on a frame of the clip, or that it is away from there on."""

    frame: int
    points: Array
    outside: bool
    z_order: int


_Run = tuple[list[_Moment], int | None]
"""Keyframes that make one shape, and the frame on which it is gone: None where it stays."""


@dataclass
class _Reader(ShapeReader):
    _made: list[tuple[int, str, RotoShape]] = field(default_factory=list)
    _groups: dict[int, str] = field(default_factory=dict)
    """The compound of each of CVAT's groups, by its number."""

    def shapes(self) -> Imported:
        """All outlines in layers of their labels, where a label has other names than its own."""
        root = parsed(self, content=self.content(MAX_XML))
        if local_name(root) != "annotations":
            raise RoamError(
                sentence(
                    "{path} is no file of CVAT's (its root element is {element}).",
                    path=self.called,
                    element=brief(local_name(root)),
                )
            )
        stop = self._stop(root)
        for element in root:
            if local_name(element) == "track":
                self._track(element, stop)
            elif local_name(element) == "image":
                self._image(element)
        if not self._made:
            self.note(sentence("There are no outlines in the file."))
        self._made.sort(key=lambda made: made[0])
        layers: dict[str, list[RotoShape]] = {}
        for _, label, shape in self._made:
            layers.setdefault(label, []).append(shape)
        items: list[Layer | RotoShape] = []
        for label, shapes in layers.items():
            if len(shapes) == 1 and shapes[0].name == label:
                items.append(shapes[0])
            else:
                items.append(Layer(self.fresh_id("layer"), label, tuple(shapes)))
        return self.finished(tuple(items), self._size(root))

    def _stop(self, root: Element) -> int:
        """The frame after the last of the task, or of the clip where the file does not say.

        A task of a part of a film counts its frames in `size`, and numbers them from the film's first.
        """
        size, last = (self._count(root, word) for word in ("size", "stop_frame"))
        stops = [self.clip.first + size] if size else []
        if last is not None:
            stops.append(self.clip.first + last + 1 - self.options.frame_offset)
        return max(stops, default=self.clip.last + 1)

    def _count(self, root: Element, word: str) -> int | None:
        """The first whole number that an element of that name holds."""
        texts = ((child.text or "").strip() for child in root.iter(word))
        return next((int(text) for text in texts if re.fullmatch(r"[0-9]{1,8}", text)), None)

    def _size(self, root: Element) -> tuple[float, float] | None:
        told = root.find(".//original_size")
        source: Element | None = told
        if told is not None:
            words = [told.findtext(word) for word in ("width", "height")]
        else:
            source = root.find("image")
            words = [] if source is None else [source.get(word) for word in ("width", "height")]
        try:
            sides = [float(word or "") for word in words]
        except ValueError:
            return None
        return (sides[0], sides[1]) if len(sides) == 2 and all(0 < side < 1e6 for side in sides) else None

    # ---- tracks and images -------------------------------------------------------------------------------------------

    def _track(self, track: Element, stop: int) -> None:
        label = track.get("label") or "Object"
        moments: dict[str, list[_Moment]] = {}
        name = label
        for element in track:
            kind = local_name(element)
            if kind not in OUTLINES:
                self._note_left_out(kind)
                continue
            name = self._name(element, name)
            if element.get("keyframe", "1") == "1" and (moment := self._moment(element, kind, label)) is not None:
                moments.setdefault(kind, []).append(moment)
        for kind, found in moments.items():
            found.sort(key=lambda moment: moment.frame)
            self._add_runs(label, name, kind != "polyline", list(_runs(found)), stop, self._compound(track))

    def _add_runs(
        self,
        label: str,
        name: str,
        closed: bool,
        runs: list[tuple[list[_Moment], int | None]],
        stop: int,
        compound: str,
    ) -> None:
        for run, end in runs:
            self.check_points(sum(len(moment.points) for moment in run), name, len(run))
            keys = tuple({moment.frame: Keyframe(moment.frame, moment.points) for moment in run}.values())
            if not sensible(keys):
                self.note(sentence("{name} was left out: it lies nowhere near the image.", name=brief(name)))
                continue
            begins = run[0].frame
            is_always = begins <= self.clip.first and end is None
            lifetime = None if is_always else (begins, max(stop if end is None else end, begins + 1))
            shape = RotoShape(self.fresh_id("shape"), name, keys, closed=closed, lifetime=lifetime, compound=compound)
            self._made.append((run[0].z_order, label, shape))
        if len(runs) > 1:
            self.note(
                sentence(
                    "{name} comes and goes, or changes its number of points: it became several shapes.",
                    name=brief(name),
                )
            )

    def _image(self, image: Element) -> None:
        try:
            frame = self.frame(float(image.get("id", ""))) + self.clip.first
        except (ValueError, OverflowError):
            raise RoamError(sentence("{path} cannot be read: an image has no number.", path=self.called)) from None
        for element in image:
            kind, label = local_name(element), element.get("label") or "Object"
            if kind not in OUTLINES:
                self._note_left_out(kind)
                continue
            found = self._outline(element, kind, label)
            if found is None:
                continue
            self.check_points(len(found), label)
            key = Keyframe(frame, found, interpolation=Interpolation.HOLD)
            if sensible((key,)):
                name = self._name(element, label)
                shape = RotoShape(
                    self.fresh_id("shape"),
                    name,
                    (key,),
                    closed=kind != "polyline",
                    lifetime=(frame, frame + 1),
                    compound=self._compound(element),
                )
                self._made.append((self._whole(element, "z_order"), label, shape))

    def _note_left_out(self, kind: str) -> None:
        if kind == "mask":
            self.note(sentence("CVAT's masks were left out; export the task as COCO, whose masks ROAM reads."))
        else:
            self.note(sentence("CVAT's {kind} was left out: ROAM reads outlines only.", kind=brief(kind)))

    def _moment(self, element: Element, kind: str, label: str) -> _Moment | None:
        points = self._outline(element, kind, label)
        try:
            frame = self.frame(float(element.get("frame", ""))) + self.clip.first
        except (ValueError, OverflowError):
            self.note(sentence("A keyframe of {name} has no frame number: it was left out.", name=brief(label)))
            return None
        if points is None:
            return None
        return _Moment(frame, points, element.get("outside") == "1", self._whole(element, "z_order"))

    def _outline(self, element: Element, kind: str, label: str) -> Array | None:
        """The points `(P, 3, 2)` of an outline, or None and a sentence."""
        try:
            if kind == "box":
                return self._box(element)
            if kind == "ellipse":
                cx, cy, rx, ry = (_number(element.get(word)) for word in ("cx", "cy", "rx", "ry"))
                return _turned(ellipse(cx, cy, rx, ry), element)
            text = element.get("points", "")
            self.check_parts(text.count(";") + text.count(","))
            words = re.split("[;,]", text)
            places = np.array([_number(word) for word in words], dtype=np.float64)
            if len(places) % 2 or len(places) < (4 if kind == "polyline" else 6):
                raise ValueError
            return polygon_key(0, places.reshape(-1, 2)).points
        except ValueError:
            self.note(sentence("An outline of {name} is damaged and was left out.", name=brief(label)))
            return None

    def _box(self, element: Element) -> Array:
        left, top, right, bottom = (_number(element.get(word)) for word in ("xtl", "ytl", "xbr", "ybr"))
        places = [(left, top), (right, top), (right, bottom), (left, bottom)]
        return _turned(Spline([[place] * 3 for place in places], True), element)

    def _compound(self, element: Element) -> str:
        """That of its group: CVAT's word for the outlines of one thing; 0 is none."""
        group = self._whole(element, "group_id")
        if group and group not in self._groups:
            self._groups[group] = self.fresh_id("compound")
        return self._groups.get(group, "")

    def _name(self, element: Element, default: str) -> str:
        found = (child.text for child in element if child.get("name") == NAME and child.text)
        return next(found, default)

    def _whole(self, element: Element, word: str) -> int:
        value = element.get(word, "0").strip()
        return int(value) if re.fullmatch(r"-?\d{1,9}", value) else 0


def _runs(moments: list[_Moment]) -> Iterator[_Run]:
    """The shapes that keyframes make."""
    run: list[_Moment] = []
    for before, moment in pairwise([None, *moments]):
        assert moment is not None
        if run and (moment.outside or (before is not None and len(moment.points) != len(run[-1].points))):
            yield run, moment.frame
            run = []
        if not moment.outside:
            run.append(moment)
    if run:
        yield run, None


def _turned(spline: Spline, element: Element) -> Array:
    """The points of an outline, turned about its middle by the element's degrees."""
    points = spline.points
    turn = math.radians(_number(element.get("rotation", "0")))
    middle = points[:, 0].mean(axis=0)
    matrix = np.array([[math.cos(turn), -math.sin(turn)], [math.sin(turn), math.cos(turn)]])
    return np.asarray((points - middle) @ matrix.T + middle)


def _number(text: str | None) -> float:
    """A finite number; `ValueError` for what is none."""
    value = float(text or "")
    if not abs(value) < 1e12:
        raise ValueError(text)
    return value
