"""What Nuke says of a layer or shape beside its points: opacity, blend mode, blur, lifetime, both ways."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from typing import Any

import numpy as np

from roam_core.arrays import Array
from roam_core.interchange.keys.keying import animated_of
from roam_core.interchange.nuke.curves import CUBIC, Curve, FollowsExpressionError, constant, curve
from roam_core.interchange.nuke.script import Nested, decoded
from roam_core.interchange.reading import ShapeReader
from roam_core.interchange.timing import right_before
from roam_core.roto import Animated, BlendMode, Clip, Interpolation, MotionBlur, RotoShape, ValueKey
from roam_core.roto.animated import Animatable, product
from roam_core.roto.shape import NO_COLOUR
from roam_core.roto.value_curves import opacity_as_seen
from roam_core.translatable import N_, sentence

BLEND_MODES = {
    BlendMode.ADD: 0,
    BlendMode.PLUS: 0,
    BlendMode.MAX: 4,
    BlendMode.INTERSECT: 5,
    BlendMode.SUBTRACT: 12,
    BlendMode.DIFFERENCE: 13,
}

ALWAYS, TO_FRAME, ONE_FRAME, FROM_FRAME, FRAME_RANGE = range(5)
"""Types of lifetime."""

CENTRED, AT_START, AT_END, CUSTOM = range(4)
"""Where the shutter opens."""

MOST_VIEWS = 64
"""More than scripts have; what a file says beyond is no number of views."""

BEZIER_TOOL = 4
STANDARD_SAMPLES = 16
"""Our motion-blur samples that correspond to Nuke's quality 1."""

UNKNOWN = {
    N_("the colour of its paint"): {"r": 1.0, "g": 1.0, "b": 1.0, "a": 1.0},
    N_("the fall-off of its feather"): {"ff": 1.0, "ft": 0.0},
}
"""Attributes, and their defaults, that change what is rendered and that ROAM has no word for."""

Tell = Callable[[str], None]


def shape_attributes(shape: RotoShape, clip: Clip, frame_offset: int) -> list[tuple[str, Animatable]]:
    """Name and value of what an artist sees in the shape's properties; `opc` is always there.

    A shape without a word on its opacity is said to arrive transparent in some versions. An open one has no width: it
    has no area in ROAM.
    """
    width, height = clip.size
    red, green, blue = shape.colour
    values: list[tuple[str, Animatable]] = [
        ("vis", float(shape.visible)),
        ("opc", shape.opacity),
        ("bm", BLEND_MODES[shape.blend]),
        ("inv", float(shape.invert)),
        *zip(("ro", "go", "bo", "ao"), (red, green, blue, 1.0), strict=True),
    ]
    blur = shape.motion_blur
    values.append(("mbo", float(shape.is_blurred)))
    if blur is not None:
        values += [("mb", blur.samples / STANDARD_SAMPLES), ("mbs", blur.shutter)]
        values += [("mbsot", CUSTOM), ("mbso", blur.phase)]
    if shape.feather:
        values += [("fo", 1), ("fx", shape.feather), ("fy", shape.feather)]
    if shape.lifetime is not None:
        start, stop = (frame + frame_offset for frame in shape.lifetime)
        values += [("ltt", FRAME_RANGE), ("ltn", start), ("ltm", right_before(stop))]  # its range is closed
    values += [("osw", 10 if shape.closed else 0), ("osf", 0), ("str", 1), ("spx", width / 2), ("spy", height / 2)]
    return [*values, ("sb", 1), ("tt", BEZIER_TOOL)]


class Attributes:
    """The attributes of a layer or shape as a file has them; asking for one tells what is lost of it."""

    def __init__(self, items: Nested, tell: Tell) -> None:
        self._tell = tell
        self._items: dict[str, str | Nested] = {
            name: value for name, value in zip(items[1::2], items[2::2], strict=False) if isinstance(name, str)
        }

    def number(self, name: str, default: float) -> float:
        """A value, or its first one where it is animated; the default where the file says nothing sensible."""
        values = self._curve(name, default)
        if not values.is_constant:
            self._tell(sentence("its {name!r} is animated; it has the first value", name=name))
        return float(values.values[0])

    def animatable(self, names: Sequence[str], default: float, reader: ShapeReader) -> Animatable:
        """The mean of some values through time, with their own keys."""
        curves = [self._curve(name, default) for name in names]
        if all(each.is_constant for each in curves):
            return float(np.mean([each.values[0] for each in curves]))

        def mean(moments: Array) -> Array:
            return np.asarray(np.mean([each.at(moments) for each in curves], axis=0))

        times = {time for each in curves if not each.is_constant for time in each.times.tolist()}
        found = animated_of(mean, times, reader.frame, reader.check_keys)
        if len(curves) == 1 and len(found.keys) > len(times):
            return _by_tangents(curves[0], reader.frame) or found
        return found

    def _curve(self, name: str, default: float) -> Curve:
        item = self._items.get(name)
        if item is None:
            return constant(default)
        try:
            if isinstance(item, list) and item and isinstance(item[0], str) and item[0].lstrip('"').startswith("="):
                self._tell(
                    sentence("its {name!r} follows an expression, which is not run; it has its last value", name=name)
                )
                return constant(decoded(item[-1]) if isinstance(item[-1], str) else default)
            return curve(item, None)
        except (FollowsExpressionError, ValueError, IndexError):
            self._tell(sentence("its {name!r} cannot be read", name=name))
            return constant(default)

    def seen(self, reader: ShapeReader) -> tuple[bool, Animatable]:
        """Whether a shape or layer is visible, and its opacity in [0, 1].

        One whose visibility is switched by keys is visible with an opacity of 0 where it is off: we have no such keys.
        """
        opacity = opacity_as_seen(self.animatable(("opc",), 1.0, reader))
        keyed = self._curve("vis", 1.0)
        is_on = keyed.values != 0.0
        if is_on.all() or not is_on.any():
            return bool(is_on[0]), opacity
        self._tell(sentence("its visibility is switched by keys; its opacity has them"))
        on = {
            reader.frame(math.ceil(time)): float(shown)
            for time, shown in zip(keyed.times.tolist(), is_on.tolist(), strict=True)
        }
        if isinstance(opacity, Animated):  # their product may have a key on every frame
            frames = [*on, *opacity.frames]
            reader.check_keys(max(frames) - min(frames) + 1)
        return True, product(opacity, Animated(tuple(ValueKey(*key, Interpolation.HOLD) for key in on.items())))

    def views(self) -> frozenset[int]:
        """The views of a stereo script in which a shape is, by their numbers; the first one where it says nothing."""
        count = min(max(int(self.number("nv", 1)), 1), MOST_VIEWS)
        return frozenset(int(self.number(f"view{k}", 1)) for k in range(1, count + 1))

    def shape_fields(self, reader: ShapeReader) -> dict[str, Any]:
        """What the attributes make of a `RotoShape`."""
        self._note_unknown()
        visible, opacity = self.seen(reader)
        return {
            "visible": visible,
            "opacity": opacity,
            "invert": self.number("inv", 0) != 0,
            "blend": self.blend(),
            "colour": self._colour(),
            "feather": self._feather(reader),
            "motion_blur": self._blur(),
            "lifetime": self._lifetime(reader.clip, reader.frame),
        }

    def _note_unknown(self) -> None:
        for meaning, defaults in UNKNOWN.items():
            given = {name: self._items[name] for name in defaults if name in self._items}
            silent = Attributes(["a", *(part for item in given.items() for part in item)], lambda _: None)
            if any(silent.number(name, np.nan) != defaults[name] for name in given):
                self._tell(sentence("{meaning} was left out", meaning=sentence(meaning)))

    def blend(self) -> BlendMode:
        """How a shape or layer joins what lies under it; told where it is in none of our modes."""
        value = self.number("bm", 0)
        for mode, number in BLEND_MODES.items():
            if number == value:
                return mode
        self._tell(sentence("its blend mode {value:g} is none of ROAM's; it adds", value=value))
        return BlendMode.ADD

    def _colour(self) -> tuple[float, float, float]:
        red, green, blue, alpha = (min(max(self.number(name, 0), 0.0), 1.0) for name in ("ro", "go", "bo", "ao"))
        return (red, green, blue) if alpha > 0 else NO_COLOUR

    def _feather(self, reader: ShapeReader) -> Animatable:
        if self.number("fo", 1) == 0:
            return 0.0
        across, down = (self.animatable((name,), 0.0, reader) for name in ("fx", "fy"))
        if across == down:
            return across
        self._tell(sentence("its feather differs in x and y; it has the mean"))
        return self.animatable(("fx", "fy"), 0.0, reader)

    def _blur(self) -> MotionBlur | None:
        """None where it is off, but for what blurs nothing however it is set: our writer turns that off, too."""
        is_on = self.number("mbo", 0) != 0
        if not is_on and "mbs" not in self._items:
            return None
        shutter = self.number("mbs", 0.5)
        phases = {CENTRED: -0.5 * shutter, AT_START: 0.0, AT_END: -shutter, CUSTOM: self.number("mbso", 0)}
        phase = phases.get(int(self.number("mbsot", CENTRED)), -0.5 * shutter)
        blur = MotionBlur(shutter, phase, min(max(round(self.number("mb", 1) * STANDARD_SAMPLES), 1), 1024))
        return blur if is_on or not blur.is_seen else None

    def _lifetime(self, clip: Clip, frame: Callable[[float], int]) -> tuple[int, int] | None:
        kind = int(self.number("ltt", ALWAYS))
        if kind not in (TO_FRAME, ONE_FRAME, FROM_FRAME, FRAME_RANGE):
            return None
        first, last = frame(self.number("ltn", clip.first)), frame(math.floor(self.number("ltm", clip.last)))
        if kind == ONE_FRAME:
            return first, first + 1
        if kind == TO_FRAME:  # up to the first of its two numbers
            return min(clip.first, first), first + 1
        if kind == FROM_FRAME:
            return first, max(clip.last, first) + 1
        return first, max(last + 1, first)  # one that ends before it begins holds no frame


def _by_tangents(curve: Curve, frame: Callable[[float], int]) -> Animated | None:
    """A curve by the very tangents that it has; None where its keys lie between frames or its handles are no thirds."""
    reaches = np.concatenate([curve.left[1:, 1], curve.right[:-1, 1]])
    if (curve.times % 1.0).any() or (reaches != 1.0).any() or (curve.kinds != CUBIC).any():
        return None
    keys = zip(curve.times.tolist(), curve.values.tolist(), curve.left.tolist(), curve.right.tolist(), strict=True)
    return Animated(
        tuple(ValueKey(frame(time), value, slopes=(left[0], right[0])) for time, value, left, right in keys)
    )
