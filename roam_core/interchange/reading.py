"""What a format to read is: the protocol, its options, and the limits within which all readers keep.

A file that comes in is data of strangers: nothing in it runs, nothing outside it is followed, and its size, its depth
and the number of its points are bounded before memory is spent on them.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any, Protocol

import numpy as np

from roam_core.bounded import bounded_bytes
from roam_core.cancel import CancelToken, Progress, Reporting
from roam_core.errors import RoamError
from roam_core.interchange.keys.keying import Key
from roam_core.interchange.protocol import MAX_FRAMES, KeyChoice
from roam_core.interchange.recognition import text_of
from roam_core.interchange.telling import gathered
from roam_core.params import scale_for
from roam_core.roto import Clip, Keyframe, Layer, Origin, RotoShape
from roam_core.roto.animated import mapped
from roam_core.roto.bounds import is_near
from roam_core.roto.imported import IMPORT, stamped
from roam_core.translatable import sentence

MAX_BYTES = 48 << 20
"""Larger files are refused before they are read; a format whose text takes longer to read has a lower bound."""

MAX_DEPTH = 200
"""Lists, elements or layers that lie in one another: real files need about fifteen."""

MAX_NUMBER = 1e12
"""No coordinate, slope or factor of a file beyond this, either way: what is reckoned with them stays finite."""

MAX_POINTS, MAX_KEYS, MAX_ITEMS = 500_000, 200_000, 20_000
"""Control points over all keys, keys, and shapes with layers of a file: each about four seconds of work."""

MAX_PARTS = 1_000_000
"""Whatever else a reader makes an object of: elements, words, curves, transforms, lists; about three seconds."""


SPECK = 64.0
"""Square pixels of a 480-line mask: what is smaller is a speck, unless the artist says otherwise."""


@dataclass(frozen=True)
class MaskOptions:
    """How sequences of masks become shapes.

    Attributes
    ----------
    tolerance : pixels of the masks between their outline and the curve, either way, on every frame; of masks that
        tremble a fifth of the outline may lie farther off (`roam_core.interchange.masks.sequence`).
    keys : a key on every frame, or as few as hold the tolerance (`KeyChoice.EVERY`, `KeyChoice.REDUCED`).
    speckle : square pixels; smaller parts and holes are left out, and what lies beyond three tolerances at one
        place may be half as large in all. 0 follows everything; None is `SPECK`, larger for masks of more lines.
    """

    tolerance: float = 1.0
    keys: KeyChoice = KeyChoice.REDUCED
    speckle: float | None = None

    def __post_init__(self) -> None:
        object.__setattr__(self, "keys", KeyChoice(self.keys))

    def speckle_for(self, size: tuple[int, int]) -> float:
        """The area below which something is a speck in masks of `size` (width, height), in square pixels."""
        return SPECK * scale_for(size[::-1]) ** 2 if self.speckle is None else self.speckle


@dataclass(frozen=True)
class ImportOptions(Reporting):
    """What an artist may choose, and the channels to whoever waits.

    Attributes
    ----------
    frame_offset : what was added to the plate's frame numbers when the file was written; reading takes it off again.
    content : what is read in place of a file, such as a text of the clipboard; the path is then its name alone.
    masks : how masks become shapes.
    progress : called with the finished fraction and a few words.
    token : cancels the reading at its next safe point.
    """

    frame_offset: int = 0
    content: bytes | None = field(default=None, repr=False)
    masks: MaskOptions = field(default_factory=MaskOptions)
    progress: Progress | None = None
    token: CancelToken | None = None


PLAIN = ImportOptions()

CLIPBOARD = Path("The clipboard")
"""The path of a text of the clipboard."""

quietly = np.errstate(over="ignore", invalid="ignore", divide="ignore")
"""Around what reckons with a file's numbers: layers in layers may send a point beyond all of them. Its shape is then
left out and named (`sensible`); nobody is warned of the sums besides."""


@dataclass(frozen=True)
class Imported:
    """What a file gave.

    Attributes
    ----------
    layer : its shapes and layers, bottom first, in pixels of the clip. Ids are unique in here only:
        `roam_core.roto.edit.add_items` gives them those that are free in a project.
    notes : one sentence for each thing that was left out or changed.
    """

    layer: Layer
    notes: tuple[str, ...] = ()


class Importer(Protocol):
    """One format to read: one room or file of this package, one line in `registry.py`.

    Attributes
    ----------
    name : how the command line calls it: lower case, one word.
    title : how a menu calls it.
    suffixes : of the files that it reads, with the dot, lower case.
    """

    @property
    def name(self) -> str: ...

    @property
    def title(self) -> str: ...

    @property
    def suffixes(self) -> tuple[str, ...]: ...

    def read(self, path: Path, clip: Clip, options: ImportOptions = ...) -> Imported:
        """Read all shapes of a file into pixels and frames of `clip`.

        What cannot be understood is named in a note and left out; the rest is kept.

        Raises
        ------
        RoamError
            when the file cannot be read, is none of the format, or goes beyond the limits of this module.
        """
        ...


@dataclass
class ShapeReader:
    """What the readers of formats share: the file, the clip, limits, fresh ids, notes.

    Attributes
    ----------
    path : of the file, for sentences.
    clip : whose pixels and frames the shapes are to be in.
    points, keys, parts : control points, keys and other parts counted so far.
    notes : a sentence for each loss, in the order of the file; `gathered` makes one of those that are alike.
    """

    path: Path
    clip: Clip
    options: ImportOptions = PLAIN
    notes: list[str] = field(default_factory=list)
    points: int = 0
    keys: int = 0
    parts: int = 0
    _ids: dict[str, int] = field(default_factory=dict)
    _told: set[str] = field(default_factory=set)

    def __post_init__(self) -> None:
        if abs(self.options.frame_offset) > MAX_FRAMES:
            raise RoamError(
                sentence(
                    "No frame is numbered {offset} too high; choose a smaller offset.", offset=self.options.frame_offset
                )
            )

    @property
    def called(self) -> str:
        """What sentences call the file."""
        return sentence("The clipboard") if self.path == CLIPBOARD else str(self.path)

    def content(self, most: int | None = None) -> bytes:
        """The whole file; one sentence when it is missing, no file, or larger than `most` (`MAX_BYTES` for None)."""
        most, given = MAX_BYTES if most is None else most, self.options.content
        if given is None:
            return bounded_bytes(self.path, most)
        if len(given) > most:
            raise RoamError(
                sentence(
                    "{path} holds more than {most} MiB; copy fewer shapes at once.", path=self.called, most=most >> 20
                )
            )
        return given

    def text(self, most: int | None = None) -> str:
        """The whole file as text (`text_of`)."""
        return text_of(self.content(most)).removeprefix("\ufeff")

    def check_depth(self, depth: int) -> None:
        """Refuse a file whose parts lie deeper in one another than `MAX_DEPTH`."""
        if depth > MAX_DEPTH:
            raise RoamError(
                sentence(
                    "{path} nests its parts more than {most} deep; no program writes such a file.",
                    path=self.called,
                    most=MAX_DEPTH,
                )
            )

    def check_parts(self, count: int = 1) -> None:
        """Count `count` more parts of any kind, and refuse more than `MAX_PARTS`."""
        self.parts += count
        if self.parts > MAX_PARTS:
            raise RoamError(
                sentence(
                    "{path} holds more than {most} parts; split it into several files.",
                    path=self.called,
                    most=MAX_PARTS,
                )
            )

    def check_points(self, count: int, shape: str, keys: int = 1) -> None:
        """A safe point: count `count` more control points of `keys` keys; refuse more than a file may hold.

        Call it before the arrays are made.
        """
        self.points += count
        self.keys += keys
        if self.points > MAX_POINTS or self.keys > MAX_KEYS:
            much = sentence("{count} keys", count=MAX_KEYS)
            if self.points > MAX_POINTS:
                much = sentence("{count} points over all keys", count=MAX_POINTS)
            raise RoamError(
                sentence(
                    "{path} holds more than {much} (at shape {shape}); split it into several files.",
                    path=self.called,
                    much=much,
                    shape=brief(shape),
                )
            )
        self.options.advance(0.0, sentence("Shape {name}", name=brief(shape)))

    def check_keys(self, count: int) -> None:
        """Count the keys of an animated value with those of shapes; refuse more than a file may hold."""
        self.keys += count
        if self.keys > MAX_KEYS:
            raise RoamError(
                sentence(
                    "{path} holds more than {most} keys; split it into several files.", path=self.called, most=MAX_KEYS
                )
            )

    def fresh_id(self, kind: str) -> str:
        """`shape-1`, `shape-2`, ...: unique within this file; more than `MAX_ITEMS` are refused."""
        self._ids[kind] = self._ids.get(kind, 0) + 1
        if sum(self._ids.values()) > MAX_ITEMS:
            raise RoamError(
                sentence(
                    "{path} holds more than {most} shapes and layers; split it into several files.",
                    path=self.called,
                    most=MAX_ITEMS,
                )
            )
        return f"{kind}-{self._ids[kind]}"

    def frame(self, number: float) -> int:
        """The plate's frame for a whole frame number of the file, the offset taken off; absurd numbers are refused."""
        if not abs(number) <= MAX_FRAMES:
            raise ValueError(sentence("{number} is no frame number", number=number))
        return round(number) - self.options.frame_offset

    def note(self, told: str) -> None:
        """Remember a loss, once: a sentence, of which `name`, or the `name` of `subject`, is the shape or layer."""
        if told not in self._told:
            self._told.add(told)
            self.notes.append(told)

    def fitted(self, layer: Layer, size: tuple[float, float] | None) -> Layer:
        """A layer of shapes of pictures of this size (width, height; None: the clip's) as it lies in the clip's.

        Where that differs, the shapes are scaled to it, each axis by its own ratio, and a note says so.
        """
        width, height = self.clip.size
        if size is None or tuple(size) == (width, height):
            return layer
        self.note(
            sentence(
                "The file speaks of pictures of {width:g} x {height:g} pixels, the clip has {clip_width} x "
                "{clip_height}: the shapes were scaled.",
                width=size[0],
                height=size[1],
                clip_width=width,
                clip_height=height,
            )
        )
        return _scaled(layer, np.array([width / size[0], height / size[1]]))

    def finished(self, children: tuple[Layer | RotoShape, ...], size: tuple[float, float] | None = None) -> Imported:
        """What was read, bottom first, as the reader's answer.

        `size` (width, height) is that of the pictures which the file speaks of (`fitted`).
        """
        layer = self.fitted(Layer("root", self.path.stem, children), size)
        self._tell_frames(layer)
        return Imported(
            Layer(layer.id, layer.name, tuple(stamped(child) for child in layer.children)), gathered(self.notes)
        )

    def _tell_frames(self, layer: Layer) -> None:
        """A note where shapes move, but on none of the clip's frames: they would stand still there."""
        frames = [frame for shape in layer.shapes() if len(shape.keys) > 1 for frame in shape.frames]
        frames += [
            at for item in layer.items() if isinstance(item, Layer) and item.transform for at in item.transform.frames
        ]
        first, last = self.clip.first, self.clip.last
        if frames and not any(first <= frame <= last for frame in frames):
            shift = self.options.frame_offset + min(frames) - first
            self.note(
                sentence(
                    "The keys lie on frames {begins} to {ends}, none of them on the clip's {first} to {last}: "
                    "the shapes stand still there. 'roam import --frame-offset {shift}' would begin with the "
                    "clip.",
                    begins=min(frames),
                    ends=max(frames),
                    first=first,
                    last=last,
                    shift=shift,
                )
            )


def origin_of(key: Key) -> dict[str, Any]:
    """The fields of a `Keyframe` that say who made it: the file's own are the artist's, those between them are not."""
    return {} if key.is_own else {"origin": Origin.ENGINE, "inputs": IMPORT}


def brief(name: str) -> str:
    """A name of a file as it may stand in a sentence: quoted, on one line, and short."""
    return repr(name if len(name) <= 60 else name[:57] + "...")


def number_of(text: str) -> float:
    """The number that a text of a file is, in the program's own words where it is none (`ValueError`)."""
    try:
        return float(text)
    except ValueError:
        raise ValueError(sentence("{text!r} is no number", text=text[:20])) from None


def are_numbers(values: list[Any]) -> bool:
    """True when all values of a JSON are finite numbers that a float can hold."""
    return all(
        isinstance(v, int | float) and not isinstance(v, bool) and abs(v) < 1e30 and math.isfinite(v) for v in values
    )


def sensible(keys: tuple[Keyframe, ...]) -> bool:
    """True when every coordinate of every key is a number and lies somewhere near an image."""
    arrays = (array for key in keys for array in (key.points, key.feather) if array is not None)
    return all(is_near(array) for array in arrays)


def _scaled(layer: Layer, ratio: np.ndarray[tuple[int], np.dtype[np.float64]]) -> Layer:
    mean = float(np.sqrt(ratio.prod()))

    def scaled(shape: RotoShape) -> RotoShape:
        feather = mapped(shape.feather, lambda width: width * mean)
        return replace(shape.map_points(lambda points: points * ratio), feather=feather)

    children = (_scaled(child, ratio) if isinstance(child, Layer) else scaled(child) for child in layer.children)
    motion = layer.transform
    if motion is not None:
        larger, smaller = np.diag([*ratio, 1.0]), np.diag([*(1.0 / ratio), 1.0])
        motion = replace(motion, matrices=larger @ motion.matrices @ smaller)
    return replace(layer, children=tuple(children), transform=motion)
