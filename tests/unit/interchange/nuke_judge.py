"""Reads a `.nk` file back by Nuke's rules and with nothing of the exporter's; Tcl itself splits the lists."""

from __future__ import annotations

import struct
from dataclasses import dataclass, field

import numpy as np

from roam_core.arrays import Array
from tests.unit.interchange import tcl


@dataclass
class JudgedShape:
    """A `curvegroup`: what Nuke would show, in the image's own coordinates again."""

    name: str
    flags: int
    curve_flags: int
    attributes: dict[str, float]
    times: list[float]
    outline: list[list[tuple[float, float, float]]]
    feather: list[list[tuple[float, float, float]]] | None
    pivot: list[float]
    height: int

    def points(self, frame: float) -> Array:
        """(P, 3, 2) anchor, in-handle, out-handle, absolute, y down."""
        triples = self._triples(self.outline, frame)
        centre = triples[:, 1]
        up = np.stack([centre, centre + triples[:, 0], centre + triples[:, 2]], axis=1)
        up[..., 1] = self.height - up[..., 1]
        return up

    def feather_points(self, frame: float) -> Array:
        """The feather curve (P, 3, 2), absolute, y down."""
        assert self.feather is not None
        triples = self._triples(self.feather, frame) * [1.0, -1.0]
        centre = self.points(frame)[:, 0] + triples[:, 1]
        return np.stack([centre, centre + triples[:, 0], centre + triples[:, 2]], axis=1)

    def _triples(self, curves: list[list[tuple[float, float, float]]], frame: float) -> Array:
        values = [evaluate(self.times, curve, frame) for curve in curves]
        return np.array(values).reshape(-1, 3, 2)


@dataclass
class JudgedLayer:
    """A `layer` with what lies in it, top first."""

    name: str
    flags: int
    attributes: dict[str, float]
    children: list[JudgedLayer | JudgedShape] = field(default_factory=list)

    def shapes(self) -> list[JudgedShape]:
        """All shapes below, top first."""
        return [
            shape
            for child in self.children
            for shape in (child.shapes() if isinstance(child, JudgedLayer) else [child])
        ]


@dataclass
class JudgedNode:
    """The Roto node: its plain knobs and the root of its curves."""

    knobs: dict[str, str]
    root: JudgedLayer
    size: tuple[int, int]


def judge(script: str) -> JudgedNode:
    """Parse a script with one Roto node; anything unexpected in it is an error."""
    (node,) = judge_all(script)
    return node


def judge_all(script: str) -> list[JudgedNode]:
    """The Roto nodes of a script, in its order."""
    interpreter = tcl.available()
    return [_node(interpreter, body) for body in interpreter.node_bodies(script)]


def judged_shapes(script: str) -> list[JudgedShape]:
    """The shapes of all Roto nodes of a script, bottom first."""
    return [shape for node in judge_all(script) for shape in reversed(node.root.shapes())]


def _node(interpreter: tcl.Tcl, text: str) -> JudgedNode:
    words = interpreter.split(text)
    body = list(zip(words[::2], words[1::2], strict=True))
    knobs = {name: value for name, value in body if name != "addUserKnob"}
    width, height = (int(word) for word in knobs["format"].split()[:2])
    (document,) = interpreter.split(knobs["curves"])
    version, flags, items = (interpreter.split(item) for item in interpreter.split(document))
    assert [version[0], flags, items[0]] == ["v", ["f", "0"], "n"]
    (root,) = items[1:]
    return JudgedNode(knobs, _Reader(interpreter, height).layer(root), (width, height))


def number(word: str) -> float:
    """`x` and eight hexadecimal digits, or a decimal."""
    if word.startswith("x"):
        assert len(word) == 9
        return float(struct.unpack(">f", bytes.fromhex(word[1:]))[0])
    return float(word)


def evaluate(times: list[float], keys: list[tuple[float, float, float]], frame: float) -> float:
    """The cubic through keys (value, left slope, right slope); one key is a constant, outside the keys it holds."""
    if len(keys) == 1:
        return keys[0][0]
    assert len(keys) == len(times)
    if frame <= times[0]:
        return keys[0][0]
    for index in range(len(times) - 1):
        if frame <= times[index + 1]:
            span = times[index + 1] - times[index]
            u = (frame - times[index]) / span
            (a, _, out), (b, into, _) = keys[index], keys[index + 1]
            first, second = a + out * span / 3.0, b - into * span / 3.0
            return (1 - u) ** 3 * a + 3 * (1 - u) ** 2 * u * first + 3 * (1 - u) * u**2 * second + u**3 * b
    return keys[-1][0]


@dataclass
class _Reader:
    interpreter: tcl.Tcl
    height: int

    def layer(self, text: str) -> JudgedLayer:
        kind, name, flags, transform, attributes, *children = self.interpreter.split(text)
        assert kind == "layer"
        assert self.interpreter.split(transform)[0] == "t"
        word, value = self.interpreter.split(flags)
        assert word == "f"
        layer = JudgedLayer(name, int(value), self._attributes(attributes))
        for child in children:
            read = self.layer if self.interpreter.split(child)[0] == "layer" else self._shape
            layer.children.append(read(child))
        return layer

    def _shape(self, text: str) -> JudgedShape:
        kind, name, flags, species, curves, transform, attributes = self.interpreter.split(text)
        assert (kind, species) == ("curvegroup", "bezier")
        outline, feather = self.interpreter.split(curves)
        curve_flags, times, points = self._curve(outline)
        feather_points = None
        if feather != "idem":
            same_flags, same_times, feather_points = self._curve(feather)
            assert (same_flags, same_times, len(feather_points)) == (curve_flags, times, len(points))
        word, time, *pivot = self.interpreter.split(transform)
        assert (word, number(time)) == ("tx", times[0])
        return JudgedShape(
            name=name,
            flags=int(flags),
            curve_flags=curve_flags,
            attributes=self._attributes(attributes),
            times=times,
            outline=points,
            feather=feather_points,
            pivot=[number(value) for value in pivot],
            height=self.height,
        )

    def _curve(self, text: str) -> tuple[int, list[float], list[list[tuple[float, float, float]]]]:
        """Flags, times, and one list of keys for each coordinate, x and y of each point in turn."""
        word, flags, keyed = self.interpreter.split(text)
        assert word == "cc"
        kind, stamps, *points = self.interpreter.split(keyed)
        assert kind == "px"
        times = [number(stamp) for stamp in self.interpreter.split(stamps)]
        assert times == sorted(set(times))
        assert len(points) % 3 == 0
        curves = [self._keys(curve, len(times)) for point in points for curve in self.interpreter.split(point)]
        assert len(curves) == 2 * len(points)
        return int(self.interpreter.split(flags)[1]), times, curves

    def _keys(self, text: str, count: int) -> list[tuple[float, float, float]]:
        if not text.startswith("{"):
            assert count == 1
            return [(number(text), 0.0, 0.0)]
        keys = []
        for key in self.interpreter.split(text):
            value, *slopes = self.interpreter.split(key)
            if slopes == ["-"]:
                keys.append((number(value), 0.0, 0.0))
            else:
                left, left_length, right, right_length = slopes
                assert (left_length, right_length) == ("1", "1")
                keys.append((number(value), number(left), number(right)))
        assert len(keys) in (1, count)
        return keys

    def _attributes(self, text: str) -> dict[str, float]:
        word, *rest = self.interpreter.split(text)
        assert word == "a"
        return {name: number(value) for name, value in zip(rest[::2], rest[1::2], strict=True)}
