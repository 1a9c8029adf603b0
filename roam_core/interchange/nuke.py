"""Nuke `.nk`: one Roto node as text that can be pasted into a script or imported.

The node's `curves` knob is a Tcl list (Foundry, NDK developer guide, "Roto serialisation format"). Numbers are single
precision in hexadecimal; y points up from the image's lower edge; handles are relative to their anchor, in the order
incoming handle, anchor, outgoing handle; keys carry a value and a slope in units per frame on either side.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from roam_core.errors import RoamError
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.interchange.protocol import STANDARD, ExportOptions, ShapeWriter
from roam_core.roto import BlendMode, Interpolation, Keyframe, Layer, Project, RotoShape
from roam_core.roto.file import write_atomically

Array = NDArray[np.float64]

ROOT_FLAGS = 1 << 21
OPEN, RENDERABLE, LOCKED, RELATIVE_TANGENTS = 1 << 5, 1 << 9, 1 << 10, 1 << 13
"""Bits of a flag word, of which the shape's and layer's are RENDERABLE and LOCKED, the curve's the other two."""

BLEND_MODES = {
    BlendMode.ADD: 0,
    BlendMode.MAX: 4,
    BlendMode.INTERSECT: 5,
    BlendMode.SUBTRACT: 12,
    BlendMode.DIFFERENCE: 13,
}
FRAME_RANGE_LIFETIME = 4
CUSTOM_SHUTTER_OFFSET = 3
BEZIER_TOOL = 4
STANDARD_SAMPLES = 16
"""Our motion-blur samples that correspond to Nuke's quality 1."""

LAST_EXACT_FRAME = 1 << 24
"""Single precision counts whole frames exactly up to here."""


class NukeExporter:
    """Writes all layers and shapes of a project as one Roto node."""

    name = "nuke"
    title = "Nuke Roto node"
    suffix = ".nk"

    def export(self, project: Project, path: Path, options: ExportOptions = STANDARD) -> tuple[str, ...]:
        """Write `project` to `path`; everything that ROAM knows of a shape has its place in the format."""
        text = roto_script(project, options)
        options.advance(1.0, f"Writing {path.name}")
        write_atomically(path, text.encode("utf-8"))
        return ()


def roto_script(project: Project, options: ExportOptions = STANDARD) -> str:
    """The text of a script with one Roto node that holds all shapes of `project`."""
    clip = project.require_clip()
    width, height = clip.size
    first, last = (frame + options.frame_offset for frame in (clip.first, clip.last))
    return "\n".join(
        [
            "version 9.0 v1",
            "Roto {",
            " inputs 0",
            " output alpha",
            f' format "{width} {height} 0 0 {width} {height} {clip.pixel_aspect:g} ROAM_{width}x{height}"',
            f" curves {{{{{{v {_number(1.2)}}}",
            "  {f 0}",
            "  {n",
            *_Writer(clip, options, len(project.shapes)).layer(project.root, "   ", is_root=True),
            "  }}}",
            " name Roto1",
            " selected true",
            " xpos 0",
            " ypos 0",
            " addUserKnob {20 ROAM}",
            ' addUserKnob {3 first_frame l "first frame"}',
            f" first_frame {first}",
            ' addUserKnob {3 last_frame l "last frame"}',
            f" last_frame {last}",
            "}",
            "",
        ]
    )


class _Writer(ShapeWriter):
    """Turns layers and shapes into lines of nested lists."""

    def layer(self, layer: Layer, indent: str, *, is_root: bool = False) -> list[str]:
        width, height = self.clip.size
        attributes: list[tuple[str, float]] = []
        if not layer.visible:
            attributes.append(("vis", 0))
        if not is_root or layer.opacity != 1.0:
            attributes.append(("opc", layer.opacity))
        if layer.invert:
            attributes.append(("inv", 1))
        flags = (ROOT_FLAGS if is_root else RENDERABLE) | (LOCKED if layer.locked else 0)
        lines = [
            f"{indent}{{layer {'Root' if is_root else tcl_word(layer.name)}",
            f"{indent} {{f {flags}}}",
            f"{indent} {{t {_number(width / 2)} {_number(height / 2)}}}",
            f"{indent} {_attributes(attributes)}",
        ]
        for child in reversed(layer.children):  # Nuke lists what lies on top first
            inner = indent + " "
            lines += self.layer(child, inner) if isinstance(child, Layer) else self.shape(child, inner)
        lines[-1] += "}"
        return lines

    def shape(self, shape: RotoShape, indent: str) -> list[str]:
        shape = self.begun(shape)
        height = self.clip.size[1]
        times, flat, keys = _timed(shape, self.options.frame_offset)
        outline = np.stack([_outline(key, height) for key in keys])
        pivot = shape.keys[0].points[:, ANCHOR].mean(axis=0)
        flags = RELATIVE_TANGENTS | (0 if shape.closed else OPEN)
        feather = [indent + "  idem"]
        if any(key.feather is not None for key in keys):
            feather = _control_curve(times, flat, np.stack([_feather(key) for key in keys]), flags, indent + "  ")
        return [
            f"{indent}{{curvegroup {tcl_word(shape.name)} {RENDERABLE | (LOCKED if shape.locked else 0)} bezier",
            f"{indent} {{",
            *_control_curve(times, flat, outline, flags, indent + "  "),
            *feather,
            f"{indent} }}",
            f"{indent} {{tx {_number(times[0])} {_number(pivot[0])} {_number(height - pivot[1])}}}",
            f"{indent} {_attributes(self._shape_attributes(shape))}}}",
        ]

    def _shape_attributes(self, shape: RotoShape) -> list[tuple[str, float]]:
        """Name and value of what an artist sees in the shape's properties; `opc` is always there.

        A shape without a word on its opacity is said to arrive transparent in some versions.
        """
        width, height = self.clip.size
        red, green, blue = shape.colour
        values: list[tuple[str, float]] = [
            ("vis", float(shape.visible)),
            ("opc", shape.opacity),
            ("bm", BLEND_MODES[shape.blend]),
            ("inv", float(shape.invert)),
            *zip(("ro", "go", "bo", "ao"), (red, green, blue, 1.0), strict=True),
        ]
        blur = shape.motion_blur
        values.append(("mbo", float(blur is not None)))
        if blur is not None:
            values += [("mb", blur.samples / STANDARD_SAMPLES), ("mbs", blur.shutter)]
            values += [("mbsot", CUSTOM_SHUTTER_OFFSET), ("mbso", blur.phase)]
        if shape.feather:
            values += [("fo", 1), ("fx", shape.feather), ("fy", shape.feather)]
        if shape.lifetime is not None:
            start, stop = (frame + self.options.frame_offset for frame in shape.lifetime)
            values += [("ltt", FRAME_RANGE_LIFETIME), ("ltn", start), ("ltm", stop - 1)]
        values += [("osw", 10), ("osf", 0), ("str", 1), ("spx", width / 2), ("spy", height / 2)]
        return [*values, ("sb", 1), ("tt", BEZIER_TOOL)]


# ---- points and keys -------------------------------------------------------------------------------------------------


def _outline(key: Keyframe, height: int) -> Array:
    """A key's points as `(P, 3, 2)` incoming handle, anchor, outgoing handle: handles relative, y up."""
    anchor = key.points[:, ANCHOR]
    centre = np.stack([anchor[:, 0], height - anchor[:, 1]], axis=1)
    up = np.array([1.0, -1.0])
    return np.stack([(key.points[:, IN] - anchor) * up, centre, (key.points[:, OUT] - anchor) * up], axis=1)


def _feather(key: Keyframe) -> Array:
    """A key's feather curve as `(P, 3, 2)`: its points relative to the outline's, its handles to its own points."""
    offsets = np.zeros_like(key.points) if key.feather is None else key.feather
    curve = key.points + offsets
    incoming, outgoing = (curve[:, part] - curve[:, ANCHOR] for part in (IN, OUT))
    result: Array = np.stack([incoming, offsets[:, ANCHOR], outgoing], axis=1) * np.array([1.0, -1.0])
    return result


def _timed(shape: RotoShape, offset: int) -> tuple[list[int], list[bool], list[Keyframe]]:
    """Frames and keys of a shape, and for each span between two of them whether both its slopes are zero.

    A cubic with the secant's slope at both ends is the straight line; one with zero slopes is the smoothstep of a
    SMOOTH key. Nuke's list has no word for a hold, so the key of a HOLD stands once more on the last frame before the
    next key.
    """
    keys: list[Keyframe] = []
    times: list[int] = []
    flat: list[bool] = []
    for key, following in zip(shape.keys, (*shape.keys[1:], None), strict=True):
        keys.append(key)
        times.append(key.frame + offset)
        if following is None:
            break
        flat.append(key.interpolation is not Interpolation.LINEAR)
        if key.interpolation is Interpolation.HOLD and following.frame - key.frame > 1:
            keys.append(key)
            times.append(following.frame - 1 + offset)
            flat.append(True)
    if max(abs(time) for time in times) > LAST_EXACT_FRAME:
        raise RoamError(f"The shape {shape.name!r} has keys on frames beyond {LAST_EXACT_FRAME}, which Nuke rounds.")
    return times, flat, keys


def _control_curve(times: Sequence[int], flat: Sequence[bool], values: Array, flags: int, indent: str) -> list[str]:
    """The `cc` list of an outline or feather curve; `values (keys, P, 3, 2)`."""
    rows = values.reshape(len(times), -1, 2)
    stamps = " ".join(_number(time) for time in times)
    if len(times) == 1:
        numbers = _numbers(rows[0].ravel())
        points = [f"{indent}  {{{x} {y}}}" for x, y in zip(numbers[::2], numbers[1::2], strict=True)]
        return [f"{indent}{{cc", f"{indent} {{f {flags}}}", f"{indent} {{px {stamps}", *points, f"{indent} }}}}"]
    curves = _keyed_curves(np.array(times, dtype=np.float64), np.array(flat), rows.reshape(len(times), -1))
    points = [f"{indent}  {{{x} {y}}}" for x, y in zip(curves[::2], curves[1::2], strict=True)]
    return [f"{indent}{{cc", f"{indent} {{f {flags}}}", f"{indent} {{px {{{stamps}}}", *points, f"{indent} }}}}"]


def _keyed_curves(times: Array, flat: NDArray[np.bool_], values: Array) -> list[str]:
    """The key lists of all columns of `values (keys, M)`. A column that never changes has one key for all times."""
    slopes = np.where(flat[:, None], 0.0, np.diff(values, axis=0) / np.diff(times)[:, None])
    still = np.zeros((1, values.shape[1]))
    table = np.stack([values, np.vstack([still, slopes]), np.vstack([slopes, still])], axis=-1)
    constant = (values.astype(np.float32) == values[0].astype(np.float32)).all(axis=0)
    curves = []
    for column in range(values.shape[1]):
        if constant[column]:
            curves.append(f"{{{{{_number(values[0, column])} -}}}}")
            continue
        numbers = iter(_numbers(table[:, column].ravel()))
        keys = (f"{{{value} {left} 1 {right} 1}}" for value, left, right in zip(numbers, numbers, numbers, strict=True))
        curves.append(f"{{{' '.join(keys)}}}")
    return curves


# ---- words -----------------------------------------------------------------------------------------------------------


def tcl_word(text: str) -> str:
    """`text` as one word of a Tcl list, which reads back as the same text and runs nothing.

    Whatever Tcl might take for syntax gets a backslash, white space and control characters become escapes: such a word
    keeps braces balanced however deep the lists around it are. A lone surrogate, which UTF-8 cannot hold, becomes
    U+FFFD.
    """
    return _SPECIAL.sub(_escaped, text.encode("utf-16-le", "surrogatepass").decode("utf-16-le", "replace")) or "{}"


_SPECIAL = re.compile(r"""[\x00-\x20\x7f-\x9f\u2028\u2029{}\[\]$"\\;#]""")


def _escaped(match: re.Match[str]) -> str:
    character = match.group()
    if character.isprintable() and character != " ":
        return "\\" + character
    return {" ": "\\ ", "\n": "\\n", "\t": "\\t", "\r": "\\r"}.get(character, f"\\u{ord(character):04x}")


def _attributes(values: Iterable[tuple[str, float]]) -> str:
    return "{" + " ".join(["a", *(f"{name} {_number(value)}" for name, value in values)]) + "}"


def _number(value: float) -> str:
    return _numbers(np.array([value], dtype=np.float64))[0]


def _numbers(values: Array) -> list[str]:
    """Single-precision numbers in Nuke's notation: 0 and 1 as they are, others as `x` and eight hexadecimal digits."""
    digits = (values.astype(">f4") + np.float32(0.0)).astype(">f4").tobytes().hex()  # adding zero takes -0 to 0
    return [_PLAIN.get(word, f"x{word}") for word in (digits[i : i + 8] for i in range(0, len(digits), 8))]


_PLAIN = {"00000000": "0", "3f800000": "1"}
