"""Reads Fusion's masks from `.setting` files, compositions (`.comp`) and what its flow puts on the clipboard: polygons,
and how they join.

A mask that is the effect mask of another lies under it. A bitmap mask of a Background that is cut out by masks is a
layer of these. Expressions are not evaluated: what they drive is named, and the value in the file is taken.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from itertools import accumulate
from pathlib import Path

import numpy as np

from roam_core.arrays import Array
from roam_core.errors import RoamError
from roam_core.geometry import bspline
from roam_core.interchange.fusion.exporter import PAINT_MODES
from roam_core.interchange.fusion.keys import feather_of, keys_of_path, opacity_of
from roam_core.interchange.fusion.text import Table, parsed
from roam_core.interchange.reading import PLAIN, Imported, ImportOptions, ShapeReader, brief, quietly, sensible
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, MotionBlur, RotoShape, Spline
from roam_core.roto.shape import NO_COLOUR
from roam_core.translatable import N_, said_by, sentence

LARGEST = 24 << 20
"""Bytes of a setting."""

MODES = {name: blend for blend, name in PAINT_MODES.items()}
POLYGONS = ("PolylineMask", "BSplineMask")
OTHERS = ("EllipseMask", "RectangleMask", "TriangleMask", "RangesMask", "WandMask", "PaintMask", "MultiPoly")
"""Kinds of masks that are not read, and named."""

STILL = {"Size": 1.0, "Angle": 0.0, "XRotation": 0.0, "YRotation": 0.0, "ZRotation": 0.0, "XSize": 1.0, "YSize": 1.0}
"""Inputs that move a mask, and where they do not."""


class FusionImporter:
    """Reads the masks of a setting."""

    name = "fusion"
    title = N_("Fusion / DaVinci Resolve masks")
    suffixes = (".setting", ".comp")

    @quietly
    def read(self, path: Path, clip: Clip, options: ImportOptions = PLAIN) -> Imported:
        """Read all polygon masks, each chain of them in the order of joining."""
        reader = ShapeReader(path, clip, options)
        return read_setting(reader, reader.text(LARGEST))


def read_setting(reader: ShapeReader, text: str) -> Imported:
    """The masks of a setting's text, as a file or a clipboard holds it."""
    table = parsed(reader, text)
    tools = dict(_tools(table))
    if not isinstance(table.named.get("Tools"), Table):
        raise RoamError(sentence("{path} holds no tools of Fusion's.", path=reader.called))
    flow = _Flow(reader, tools, frozenset(_passed(table)))
    return reader.finished(tuple(flow.items()), flow.size)


def _tools(table: Table) -> Iterator[tuple[str, Table]]:
    """All tools by name, those of groups and macros among them."""
    for name, tool in table.table("Tools").named.items():
        if isinstance(tool, Table):
            yield str(name), tool
            yield from _tools(tool)


def _passed(table: Table, around: bool = False) -> Iterator[str]:
    """The names of all tools that are passed through, by themselves or with a group around them."""
    for name, tool in table.table("Tools").named.items():
        if isinstance(tool, Table):
            is_passed = around or tool.named.get("PassThrough") is True
            if is_passed:
                yield str(name)
            yield from _passed(tool, is_passed)


@dataclass
class _Flow:
    """The tools of a setting, and what was made of them.

    Attributes
    ----------
    passed : names of the tools that are passed through.
    size : (width, height) that the first mask speaks of, or None.
    above : names of the tools on the way from a chain's end, to refuse a circle.
    """

    reader: ShapeReader
    tools: dict[str, Table]
    passed: frozenset[str]
    size: tuple[float, float] | None = None
    above: set[str] = field(default_factory=set)
    depth: int = 0

    def __post_init__(self) -> None:
        self.places = {name: place for place, name in enumerate(self.tools)}

    def items(self) -> Iterator[Layer | RotoShape]:
        """Every chain that ends here, in the order of the file; a chain of several masks beside others is a layer."""
        kinds = (*POLYGONS, "BitmapMask")
        masks = [name for name, tool in self.tools.items() if tool.kind in kinds]
        used = {source for name in masks for source in self._sources(name)}
        ends = [name for name in masks if name not in used]
        for tool in self.tools.values():
            if tool.kind in OTHERS:
                self.reader.note(sentence("Masks of the kind {kind} are not read.", kind=tool.kind))
        chains = [(name, self._chain(name)) for name in ends]
        long = [name for name, chain in chains if len(chain) > 1]
        listed: list[tuple[int, Layer | RotoShape]] = []
        for name, chain in chains:
            if len(long) > 1 and len(chain) > 1:
                title = brief(name)[1:-1]
                listed.append(
                    (self.places[name], Layer(self.reader.fresh_id("layer"), title, tuple(i for _, i in chain)))
                )
            else:
                listed += chain
        return iter([item for _, item in sorted(listed, key=lambda pair: pair[0])])

    def _sources(self, name: str) -> Iterator[str]:
        """Masks that a mask is joined with or made of."""
        inputs = self.tools[name].table("Inputs")
        below = inputs.table("EffectMask").named.get("SourceOp")
        if isinstance(below, str):
            yield below
        if (pictured := self._pictured(inputs)) is not None:
            yield pictured

    def _pictured(self, inputs: Table) -> str | None:
        """The mask that cuts out the Background of which a bitmap mask is made."""
        picture = self.tools.get(str(inputs.table("Image").named.get("SourceOp")))
        if picture is None or picture.kind != "Background":
            return None
        source = picture.table("Inputs").table("EffectMask").named.get("SourceOp")
        return source if isinstance(source, str) else None

    def _chain(self, name: str) -> list[tuple[int, Layer | RotoShape]]:
        """What joins from the lowest mask to this one, each with its place in the file."""
        found: list[tuple[int, Layer | RotoShape]] = []
        entered: list[str] = []
        following: str | None = name
        while following is not None and following in self.tools:
            if following in self.above:
                raise RoamError(
                    sentence(
                        "{path} joins the mask {following} with itself.",
                        path=self.reader.called,
                        following=brief(following),
                    )
                )
            self.above.add(following)
            entered.append(following)
            item, below = self._item(following)
            if item is not None:
                found.append((self.places[following], item))
            following = below
        self.above.difference_update(entered)
        found.reverse()
        # No item comes before one that lies under it, wherever the file has it.
        tops = accumulate((place for place, _ in found), max)
        found = [(top, item) for top, (_, item) in zip(tops, found, strict=True)]
        if found and found[0][1].blend is not BlendMode.ADD:
            # Without an effect mask a paint mode has no meaning; hidden shapes keep theirs.
            place, lowest = found[0]
            is_aside = isinstance(lowest, RotoShape) and (not lowest.visible or not lowest.closed)
            found[0] = (place, lowest if is_aside else replace(lowest, blend=BlendMode.ADD))
        return found

    def _item(self, name: str) -> tuple[Layer | RotoShape | None, str | None]:
        """A mask as a shape or a layer, and the mask that it is joined with."""
        tool = self.tools[name]
        inputs = tool.table("Inputs")
        below = inputs.table("EffectMask").named.get("SourceOp")
        below = below if isinstance(below, str) else None
        if tool.kind == "BitmapMask":
            return self._bitmap(name, tool, below)
        if tool.kind not in POLYGONS:
            self.reader.note(
                sentence("The tool {name} is no polygon mask and was left out of its chain.", name=brief(name))
            )
            return None, below
        try:
            return self._shape(name, tool), below
        except (ValueError, KeyError, OverflowError, TypeError) as error:
            self.reader.note(
                sentence("The mask {name} was left out: {reason}.", name=brief(name), reason=said_by(error))
            )
            return None, below

    def _bitmap(self, name: str, tool: Table, below: str | None) -> tuple[Layer | None, str | None]:
        inputs = tool.table("Inputs")
        blend = self._blend(name, inputs)
        if (apart := self._difference(inputs)) is not None:
            source, below = apart
            blend, is_inverted = BlendMode.DIFFERENCE, False
        else:
            source, is_inverted = self._pictured(inputs) or "", _flag(inputs, "Invert")
        if source not in self.tools:
            self.reader.note(
                sentence("The bitmap mask {name} was left out: its picture is not made of masks.", name=brief(name))
            )
            return None, below
        self.depth += 1
        self.reader.check_depth(self.depth)
        items = tuple(item for _, item in self._chain(source))
        self.depth -= 1
        layer = Layer(
            self.reader.fresh_id("layer"),
            self._title(name, inputs),
            items,
            visible=name not in self.passed,
            opacity=opacity_of(self.reader, name, inputs, self.tools),
            invert=is_inverted,
            blend=blend,
        )
        return layer, below

    def _difference(self, inputs: Table) -> tuple[str, str] | None:
        """The mask and the chain of whose greys our writer makes the difference, by a lesser and a greater one."""
        inverse = self._tool_of(inputs, "BitmapMask")
        if inverse is None or not _flag(inputs, "Invert") or not _flag(inverse, "Invert"):
            return None
        greater = self._tool_of(inverse, "BitmapMask")
        lesser = self.tools.get(str(inverse.table("EffectMask").named.get("SourceOp")), Table()).table("Inputs")
        if greater is None or _mode(inverse) != "Add" or (_mode(greater), _mode(lesser)) != ("Maximum", "Minimum"):
            return None
        below = greater.table("EffectMask").named.get("SourceOp")
        source = self._pictured(greater)
        is_pair = source == self._pictured(lesser) and below == lesser.table("EffectMask").named.get("SourceOp")
        return (source, below) if is_pair and source is not None and isinstance(below, str) else None

    def _tool_of(self, inputs: Table, kind: str) -> Table | None:
        """The inputs of the tool that a bitmap mask pictures."""
        tool = self.tools.get(self._pictured(inputs) or "")
        return tool.table("Inputs") if tool is not None and tool.kind == kind else None

    def _shape(self, name: str, tool: Table) -> RotoShape:
        inputs = tool.table("Inputs")
        title = self._title(name, inputs)
        size = self._size_of(inputs)
        self.size = self.size or size
        self._name_what_moves(title, inputs)
        is_polygon = tool.kind == "PolylineMask"
        keys = keys_of_path(self.reader, title, inputs, self.tools, is_polygon)
        centre = inputs.table("Center").named.get("Value")
        shift = np.zeros(2)
        if isinstance(centre, Table) and _is_pair(centre):
            shift = np.array(centre.listed[:2], dtype=np.float64) - 0.5
        closed = {key.closed for key in keys}
        if len(closed) > 1:
            raise ValueError(sentence("it is closed on some keys only"))
        scale = np.array([self.size[0], -self.size[1]])
        made = tuple(
            Keyframe(
                key.frame,
                self._points(key.rows + shift, scale, key.closed, is_polygon),
                interpolation=key.interpolation,
            )
            for key in keys
        )
        if not sensible(made):
            raise ValueError(sentence("it has a point that lies nowhere near the picture"))
        is_line = closed == {True} and inputs.table("Solid").named.get("Value", 1.0) in (0, False)
        if is_line:
            self.reader.note(
                sentence("{name} is a line, whose width is not read: it came in hidden.", name=brief(title))
            )
        return RotoShape(
            self.reader.fresh_id("shape"),
            title,
            made,
            closed=closed.pop(),
            colour=self._colour(inputs),
            blend=self._blend(title, inputs),
            opacity=opacity_of(self.reader, title, inputs, self.tools),
            invert=_flag(inputs, "Invert"),
            feather=feather_of(self.reader, title, inputs, self.tools, self.size[0]),
            motion_blur=_motion_blur(inputs),
            visible=name not in self.passed and not is_line,
            locked=tool.named.get("Locked") is True,
            spline=Spline.BEZIER if is_polygon else Spline.BSPLINE,
        )

    def _points(self, rows: Array, scale: Array, closed: bool, is_polygon: bool) -> Array:
        """Points (P, 3, 2) in pixels from positions (P, 3, 2), or from control points (P, 1, 2)."""
        assert self.size is not None
        pixels = rows * scale + np.array(self.size) / 2.0
        return pixels if is_polygon else bspline.bezier_points(pixels[:, 0], closed)

    def _size_of(self, inputs: Table) -> tuple[float, float]:
        width, height = self.reader.clip.size
        own = not _flag(inputs, "UseFrameFormatSettings")
        size = (
            inputs.table("MaskWidth").number("Value", width) if own else width,
            inputs.table("MaskHeight").number("Value", height) if own else height,
        )
        if not all(0 < length < 1e6 for length in size):
            raise ValueError(
                sentence("it speaks of pictures of {width:g} x {height:g} pixels", width=size[0], height=size[1])
            )
        return size

    def _title(self, name: str, inputs: Table) -> str:
        comment = inputs.table("Comments").named.get("Value")
        return comment if isinstance(comment, str) else name

    def _blend(self, name: str, inputs: Table) -> BlendMode:
        mode = _mode(inputs)
        if mode not in MODES:
            self.reader.note(
                sentence(
                    "The paint mode {mode} of {name} is not read; the mask is added.",
                    mode=brief(mode),
                    name=brief(name),
                )
            )
        return MODES.get(mode, BlendMode.ADD)

    def _colour(self, inputs: Table) -> tuple[float, float, float]:
        spline = self.tools.get(str(inputs.table("Polyline").named.get("SourceOp")), Table()).table("SplineColor")
        try:
            shares = [spline.number(part, -1.0) / 255.0 for part in ("Red", "Green", "Blue")]
        except ValueError:
            shares = [-1.0]
        if not all(0.0 <= share <= 1.0 for share in shares):
            return NO_COLOUR
        return (shares[0], shares[1], shares[2])

    def _name_what_moves(self, title: str, inputs: Table) -> None:
        for key, made in inputs.named.items():
            if isinstance(made, Table) and "Expression" in made.named:
                self.reader.note(
                    sentence(
                        "{key} of {name} has an expression, which is not evaluated.",
                        key=brief(str(key)),
                        name=brief(title),
                    )
                )
        for key, still in STILL.items():
            made = inputs.table(key)
            if "SourceOp" in made.named or made.named.get("Value", still) != still:
                self.reader.note(
                    sentence("{key} of {name} is not read: it stays where its points are.", key=key, name=brief(title))
                )
        if "SourceOp" in inputs.table("Center").named:
            self.reader.note(
                sentence("The moving centre of {name} is not read: it stays where its points are.", name=brief(title))
            )


def _is_pair(value: Table) -> bool:
    return len(value.listed) >= 2 and all(isinstance(number, float) for number in value.listed[:2])


def _flag(inputs: Table, name: str) -> bool:
    return inputs.table(name).named.get("Value") not in (None, 0, False)


def _mode(inputs: Table) -> str:
    listed = inputs.table("PaintMode").table("Value").listed
    return str(listed[0]) if listed else "Merge"


def _motion_blur(inputs: Table) -> MotionBlur | None:
    if not _flag(inputs, "MotionBlur"):
        return None
    angle = inputs.table("ShutterAngle").number("Value", 180.0)
    samples = inputs.table("Quality").number("Value", 2.0)
    bias = inputs.table("CenterBias").number("Value", 0.0)
    shutter = min(max(angle / 360.0, 0.0), 100.0)
    return MotionBlur(
        shutter, (min(max(bias, -100.0), 100.0) - 1.0) * shutter / 2.0, round(min(max(samples, 1.0), 1024))
    )
