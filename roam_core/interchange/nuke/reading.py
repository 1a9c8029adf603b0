"""Reads the shapes of Nuke's Roto and RotoPaint nodes, wherever they stand in a script."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass, replace
from pathlib import Path

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.interchange.keys.keying import Key, keys_of
from roam_core.interchange.layer_motion import layer_motion
from roam_core.interchange.nuke.attributes import Attributes
from roam_core.interchange.nuke.curves import (
    Curve,
    FollowsExpressionError,
    FormError,
    Transform,
    curve,
    refuse_expression,
    shared_times,
    transform,
)
from roam_core.interchange.nuke.joined import is_joined, joined
from roam_core.interchange.nuke.names import KNOB, true_names
from roam_core.interchange.nuke.outlines import OutlineMotion, Points
from roam_core.interchange.nuke.script import Nested, Script, Word
from roam_core.interchange.nuke.text import LOCKED, OPEN, RELATIVE_TANGENTS, RENDERABLE
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
from roam_core.interchange.telling import MOST_NAMES
from roam_core.roto import Clip, Keyframe, Layer, LayerTransform, RotoShape
from roam_core.translatable import N_, Sentence, enumerated, said_by, sentence

PER_CURVE = 2
"""Parts that the curve of one coordinate counts for."""


WARPS = "SplineWarp"
"""How the species of nodes begin whose curves say where a picture is pulled from and to."""


class NukeImporter:
    """Reads `.nk` scripts and gizmos: every node with a knob of curves."""

    name = "nuke"
    title = N_("Nuke script")
    suffixes = (".nk", ".gizmo")

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read all shapes of all Roto nodes; paint strokes, expressions and the like are named and left out.

        Each node is scaled from its own format to the clip's. One without is taken to have that of the script, or else
        the clip's size; where its pivot speaks of another, that is told. Formats mean nothing to a node that has an
        input: where its pivot is the middle of the clip's pictures, that is its plate.
        """
        reader = ShapeReader(path, clip, options)
        script = Script(reader)
        every = [(species, _switched(_readable(knobs), groups)) for species, knobs, groups in script.nodes()]
        if script.cut is not None:
            reader.note(
                sentence("The file ends within the node {name}: what is whole was read.", name=brief(script.cut))
            )
        nodes = [each for each in every if "curves" in each[1] and each[0] not in ("Root", "Viewer")]
        if not nodes:
            raise RoamError(sentence("{path} holds no Roto or RotoPaint node.", path=reader.called))
        scripts = [_size(knobs["format"]) for species, knobs in every if species == "Root" and "format" in knobs]
        script_size = scripts[-1] if scripts else None

        is_ours = is_joined(every)
        views: list[tuple[str, frozenset[int]]] = []

        def root_of(knobs: dict[str, Word]) -> Layer:
            told = (_size(knobs["format"]) if "format" in knobs else None) or script_size
            if _is_of_the_plate(knobs, clip):
                told = clip.size
            names = true_names(knobs[KNOB].value) if KNOB in knobs else {}
            size = told or clip.size
            node = _NodeReader(reader, size, _name(knobs), names, views, told is not None, not is_ours)
            return reader.fitted(node.root(knobs["curves"], knobs.get("disable")), told)

        whole = joined(every, root_of, reader) if is_ours else None
        layers = [whole] if whole is not None else [_shown(root_of(knobs), species, reader) for species, knobs in nodes]
        _tell_views(views, reader)
        if len(layers) == 1 and _says_nothing(layers[0]):
            return reader.finished(layers[0].children)
        return reader.finished(tuple(reversed(layers)))


def _tell_views(views: Sequence[tuple[str, frozenset[int]]], reader: ShapeReader) -> None:
    """Tell of shapes that are in some views of a stereo script alone: which of them ours is, no file says."""
    every = frozenset[int]().union(*(own for _, own in views))
    if some := [brief(name) for name, own in views if own != every]:
        told = enumerated(list(dict.fromkeys(some)), MOST_NAMES)
        reader.note(
            sentence("ROAM has one view, and shows what Nuke shows in some of the script's alone: {names}.", names=told)
        )


def _shown(layer: Layer, species: str, reader: ShapeReader) -> Layer:
    """The layer of a node; hidden where the curves of its species make no matte."""
    if not species.startswith(WARPS):
        return layer
    reader.note(
        sentence(
            "{species} {name} warps by its curves, which make no matte: they came in hidden.",
            species=species,
            name=brief(layer.name),
        ),
    )
    return replace(layer, visible=False)


def _readable(knobs: dict[str, Word]) -> dict[str, Word]:
    """The knobs of a node without its curves, where the end of the file left nothing of them."""
    curves = knobs.get("curves")
    if curves is None or curves.is_whole or _root(curves) is not None:
        return knobs
    return {name: word for name, word in knobs.items() if name != "curves"}


def _switched(knobs: dict[str, Word], groups: Sequence[dict[str, Word]]) -> dict[str, Word]:
    """The knobs of a node, where it lies in groups with the switch of the one that is disabled, or varies."""
    words = [each["disable"] for each in (knobs, *groups) if "disable" in each]
    if not words:
        return knobs
    return {**knobs, "disable": min(words, key=lambda word: _SWITCHES.get(_switch(word), 1))}


_SWITCHES = {"true": 0, "1": 0, "false": 2, "0": 2}
"""What disables a node first, what leaves it on last; expressions and keys between."""


def _switch(word: Word) -> str:
    return word.value.strip().lower()


def _root(curves: Word) -> Word | None:
    """The root layer of a knob of curves, or None where it has another form."""
    documents = [word for word in curves.words() if word.is_braced]
    for item in documents[-1].words() if documents else []:
        parts = item.words() if item.is_braced else []
        if len(parts) > 1 and parts[0].raw == "n" and parts[1].is_braced:
            return parts[1]
    return None


def _is_of_the_plate(knobs: dict[str, Word], clip: Clip) -> bool:
    """Whether a node has an input, which its script need not say, whose pictures are as large as the clip's."""
    root = _root(knobs["curves"])
    if root is None or ("inputs" in knobs and knobs["inputs"].value == "0"):
        return False
    form = next((item for item in root.words()[2:] if item.raw.lstrip().startswith("t")), None)
    try:
        middle = None if form is None else transform(form.nested()).pivot
    except (ValueError, IndexError):
        return False
    return middle is not None and _is_middle_of(middle, clip)


def _is_middle_of(middle: Array, clip: Clip) -> bool:
    return bool(np.abs(2.0 * middle - clip.size).max() <= 1.0)


def _offsets(value: Array) -> Array | None:
    """The feather's offsets among `(1 | 2, P, 3, 2)` of outline and feather curve; None where there are none."""
    return None if len(value) == 1 or not np.abs(value[1] - value[0]).max() > 1e-6 else value[1] - value[0]


def _name(knobs: dict[str, Word]) -> str:
    return knobs["name"].value if "name" in knobs else "Roto"


def _says_nothing(layer: Layer) -> bool:
    is_plain = layer.visible and not layer.locked and not layer.invert and layer.transform is None
    return is_plain and layer.opacity == 1.0


def _reason(error: Exception) -> str:
    """What a list lacks that cannot be read: in a sentence of ours, never in Python's words."""
    told = said_by(error)
    return told if isinstance(told, Sentence) else sentence("it has none of the known forms")


def _flags(words: list[Word]) -> int:
    return int(words[0].raw) if words and words[0].raw.isdecimal() else 0


def _size(word: Word) -> tuple[float, float] | None:
    """Width and height of a format knob, if it is one that says numbers."""
    try:
        width, height = (float(part) for part in word.value.split()[:2])
    except ValueError:
        return None
    return (width, height) if 0 < width < 1e6 and 0 < height < 1e6 else None


@dataclass
class _NodeReader:
    """Layers and shapes of one node."""

    reader: ShapeReader
    size: tuple[float, float]
    node: str
    true_names: dict[str, str]
    views: list[tuple[str, frozenset[int]]]
    tells_size: bool
    keeps_motion: bool

    def root(self, curves: Word, disabled: Word | None = None) -> Layer:
        """The node's layers and shapes, in a layer that bears its name; of a node that is disabled it is hidden."""
        root = _root(curves)
        if root is None:
            raise RoamError(
                sentence(
                    "{path}: the curves of the node {node} are not in the form of Nuke 7 and later; save the "
                    "script with such a version.",
                    path=self.reader.called,
                    node=brief(self.node),
                )
            )
        layer = self._layer(root, [], is_root=True)
        return replace(layer, name=self.node, visible=layer.visible and not self._is_off(disabled))

    def _is_off(self, disabled: Word | None) -> bool:
        """Whether the node is disabled; where that varies it is taken to be on."""
        switch = "false" if disabled is None else _switch(disabled)
        if switch not in _SWITCHES:
            self.reader.note(
                sentence("Whether the node {name} is disabled varies: it was read as on.", name=brief(self.node))
            )
        return _SWITCHES.get(switch) == 0

    def _layer(self, word: Word, outer: Sequence[Transform], *, is_root: bool = False) -> Layer:
        items = word.words()[1:]
        name = self._true(items.pop(0).value) if items else "?"
        flags, attributes = 0, Attributes([], self._teller("layer", name))
        motion, inner = None, list(outer)
        children: list[Layer | RotoShape] = []
        for item in items:
            parts = item.words()
            head = parts[0].raw if parts else ""
            if head == "f":
                flags = _flags(parts[1:])
            elif head in ("t", "tx"):
                form = self._transform(item, "layer", name)
                if is_root and not self.tells_size:
                    self._doubt_size(form)
                motion = self._motion(form) if not outer else None
                inner = [form, *outer] if motion is None and form.moves else [*outer]
            elif head == "a":
                attributes = Attributes(item.nested(), self._teller("layer", name))
            elif head == "layer":
                children.append(self._layer(item, inner))
            elif head in ("curvegroup", "cubiccurve"):
                children += self._shape(item, parts, inner)
        visible, opacity = attributes.seen(self.reader)
        return Layer(
            self.reader.fresh_id("layer"),
            name,
            tuple(reversed(children)),
            visible=visible,
            locked=bool(flags & LOCKED),
            opacity=opacity,
            invert=attributes.number("inv", 0) != 0,
            blend=attributes.blend(),
            transform=motion,
        )

    def _motion(self, form: Transform) -> LayerTransform | None:
        """What moves a layer, y down; None where nothing does, or our layers cannot move so."""
        if not self.keeps_motion or not form.moves or not form.times:
            return None
        over = np.array([[1.0, 0.0, 0.0], [0.0, -1.0, self.size[1]], [0.0, 0.0, 1.0]])  # its own inverse
        return layer_motion(
            lambda moments: over @ form.matrices(moments) @ over,
            form.times,
            self.size,
            self.reader.frame,
            self.reader,
        )

    def _doubt_size(self, form: Transform) -> None:
        """Tell where the root turns about the middle of other pictures than the clip's: Nuke puts its pivot there."""
        middle = form.pivot
        if middle is None or _is_middle_of(middle, self.reader.clip):
            return
        (width, height), (own_width, own_height) = np.rint(2.0 * middle), self.reader.clip.size
        self.reader.note(
            sentence(
                "The node {node} names no format, and was read as of the clip's, {own_width} x {own_height} "
                "pixels; its middle is that of {width:g} x {height:g}. If its shapes lie askew, set its "
                "format in Nuke.",
                node=brief(self.node),
                own_width=own_width,
                own_height=own_height,
                width=width,
                height=height,
            )
        )

    def _shape(self, word: Word, parts: list[Word], outer: Sequence[Transform]) -> Iterator[RotoShape]:
        """The shape, or nothing and a note when it is none that we can hold."""
        name = self._true(parts[1].value) if len(parts) > 1 else "?"
        try:
            if not word.is_whole:
                raise FormError(sentence("it is cut off"))
            yield self._whole_shape(name, parts, outer)
        except FollowsExpressionError as expression:
            self.reader.note(
                sentence(
                    "The shape {name} follows the expression {expression}, which is not run: it was left out.",
                    name=brief(name),
                    expression=brief(str(expression)),
                ),
            )
        except (ValueError, IndexError, OverflowError) as error:
            self.reader.note(
                sentence("The shape {name} was left out: {reason}.", name=brief(name), reason=_reason(error))
            )

    def _whole_shape(self, name: str, parts: list[Word], outer: Sequence[Transform]) -> RotoShape:
        flags, species = _flags(parts[2:]), parts[3].raw
        if species != "bezier":
            is_stroke = parts[0].raw == "cubiccurve"
            raise FormError(
                sentence("it is a {species} stroke", species=species)
                if is_stroke
                else sentence("it is a {species} shape", species=species)
            )
        form, attributes = Transform({}), Attributes([], self._teller("shape", name))
        for item in parts[5:]:
            head = item.nested()
            if head and head[0] in ("t", "tx"):
                form = self._transform(item, "shape", name)
            elif head and head[0] == "a":
                attributes = Attributes(head, self._teller("shape", name))
        if parts[0].raw == "curvegroup":
            outline, feather = parts[4].words()
        else:
            outline, feather = parts[4], parts[4]
            self.reader.note(sentence("The stroke {name} came as an open shape, without its brush.", name=brief(name)))
        curve_flags, points = self._points(outline, name)
        own = None if outline is feather or not feather.is_braced else self._points(feather, name)[1]
        if own is not None and len(own.curves) != len(points.curves):
            raise FormError(sentence("its feather has not as many points as its outline"))
        motion = OutlineMotion(points, own, [form, *outer], self.size[1], bool(curve_flags & RELATIVE_TANGENTS))
        keys = self._keys(motion, name)
        if not sensible(keys):
            raise FormError(sentence("a point of it lies nowhere near the image"))
        shape_id = self.reader.fresh_id("shape")
        fields = attributes.shape_fields(self.reader)
        fields["visible"] = fields["visible"] and bool(flags & RENDERABLE)
        self.views.append((name, attributes.views()))
        return RotoShape(shape_id, name, keys, closed=not curve_flags & OPEN, locked=bool(flags & LOCKED), **fields)

    def _points(self, word: Word, name: str) -> tuple[int, Points]:
        """Flags and points of a `cc` list."""
        flags, form = 0, None
        for item in word.words()[1:]:
            if item.is_braced and item.raw.lstrip()[:1] == "f":
                flags = _flags(item.words()[1:])
            elif item.is_braced:
                form = item.nested()
        if not form or form[0] not in ("p", "px"):
            raise FormError(sentence("its points have none of the known forms"))
        times = shared_times(form[1]) if form[0] == "px" else None
        entries = form[2:] if form[0] == "px" else form[1:]
        if not entries or len(entries) % 3:
            raise FormError(sentence("it has {count} entries of points, not three for each point", count=len(entries)))
        self.reader.check_points(len(entries) // 3, name)
        self.reader.check_parts(PER_CURVE * 2 * len(entries))
        curves: list[Curve] = []
        for entry in entries:
            x, y = self._pair(entry, name)
            curves += [curve(x, times), curve(y, times)]
        return flags, Points(times or [], curves)

    def _pair(self, entry: str | Nested, name: str) -> Nested:
        """The two coordinates of an entry: `{}` is zero, attributes before and pressure after them are passed over."""
        if isinstance(entry, str):
            raise FormError(sentence("a word stands where a point belongs"))
        if entry and isinstance(entry[0], list) and entry[0][:1] == ["a"]:
            self.reader.note(
                sentence("The width and feather of single points of {name} were left out.", name=brief(name))
            )
            entry = entry[1:]
        if not entry:
            return ["0", "0"]
        refuse_expression(entry)
        return entry[:2]

    def _keys(self, motion: OutlineMotion, name: str) -> tuple[Keyframe, ...]:
        count = len(motion.points.curves) // 6
        times = motion.times or {float(self.reader.clip.first + self.reader.options.frame_offset)}
        raw: list[Key] = keys_of(motion.at, times, lambda keys: self.reader.check_points(keys * count, name, keys))
        return tuple(
            Keyframe(
                self.reader.frame(key.frame),
                key.value[0],
                _offsets(key.value),
                interpolation=key.interpolation,
                **origin_of(key),
            )
            for key in raw
        )

    def _transform(self, word: Word, kind: str, name: str) -> Transform:
        """A transform; one that cannot be read is named and left out."""
        try:
            form = transform(word.nested())
        except FollowsExpressionError as expression:
            self._teller(kind, name)(
                sentence(
                    "its transform follows the expression {expression} and was left out",
                    expression=brief(str(expression)),
                )
            )
            return Transform({})
        except (ValueError, IndexError) as error:
            self._teller(kind, name)(sentence("its transform was left out, {reason}", reason=_reason(error)))
            return Transform({})
        for part in form.unknown:
            self._teller(kind, name)(sentence("the {part} of its transform was left out", part=sentence(part)))
        return form

    def _true(self, name: str) -> str:
        return self.true_names.get(name, name)

    def _teller(self, kind: str, name: str) -> Callable[[str], None]:
        called = brief(name)
        subject = sentence("layer {name}", name=called) if kind == "layer" else sentence("shape {name}", name=called)
        return lambda told: self.reader.note(sentence("The {subject}: {told}.", subject=subject, told=told))
