"""Renders the matte of a `.nk` script: Roto nodes as the grammar reads them, and the nodes that join them.

What is taken for granted of Nuke, beside the grammar: shapes are painted bottom first onto what lies under them; `opc`
scales and `inv` inverts a shape; `over` is a union; the blend modes have the numbers of a public exporter; `Merge2`,
`Invert`, `Multiply` and `Clamp` do to alpha what they are called. A layer inside a node must say nothing that Nuke is
not known to do: only whether it is visible.
"""

from __future__ import annotations

import re

import numpy as np

from roam_core.arrays import Array
from tests.judges.coverage import between, filled, soft
from tests.judges.nuke_grammar import RENDERABLE, Layer, Node, Shape, nodes

OVER, MAX, INSIDE, SUBTRACT, DIFFERENCE = 0, 4, 5, 12, 13
BLUR_SAMPLES = 24


def matte(text: str, frame: float, size: tuple[int, int]) -> Array:
    """What the last node of a script shows on a frame: alpha `(h, w)`, top row first."""
    left: list[Array] = []
    for node in nodes(text):
        if node.root is not None:
            under = np.zeros(size) if node.knobs.get("inputs", "1") == "0" else left.pop()
            left.append(_painted(node.root, under, frame))
        elif node.species == "Merge2":
            assert node.knobs["inputs"] == "2"
            b, a = left.pop(), left.pop()
            left.append(_merged(a, b, node.knobs["operation"]))
        elif node.species == "Invert":
            left.append(1.0 - left.pop())
        elif node.species == "Multiply":
            left.append(left.pop() * _knob(node, "value", frame))
        elif node.species == "Clamp":
            left.append(np.clip(left.pop(), 0.0, 1.0))
        else:
            assert node.species == "NoOp", node.species
    (result,) = left
    return result


def _merged(a: Array, b: Array, operation: str) -> Array:
    """What the operations of a `Merge2` are documented to do to alpha; B is the first input, the last node before."""
    results: dict[str, Array] = {
        "over": a + b - a * b,
        "plus": a + b,
        "out": a * (1.0 - b),
        "in": a * b,
        "difference": np.abs(a - b),
        "max": np.maximum(a, b),
    }
    return results[operation]


def _knob(node: Node, name: str, frame: float) -> float:
    """A knob that is a number, or an animation curve of straight spans: `{{curve L x1001 0.5 x1010 1}}`."""
    word = node.knobs[name]
    if not word.startswith("{"):
        return float(word)
    found = re.fullmatch(r"\{\{curve L((?: x\S+ \S+)+)\}\}", word)
    assert found is not None, word
    words = found.group(1).split()
    return float(np.interp(frame, [float(w[1:]) for w in words[::2]], [float(w) for w in words[1::2]]))


def _painted(layer: Layer, under: Array, frame: float) -> Array:
    if layer.value("vis", frame, 1.0) == 0.0:
        return under
    painted = under
    for child in reversed(layer.children):
        if isinstance(child, Layer):
            painted = _painted(child, painted, frame)
        elif shows(child, frame):
            mode = round(child.value("bm", frame, 0.0))
            painted = _blended(painted, shape_matte(child, frame, under.shape), mode)
    says = [layer.value(name, frame, default) != default for name, default in (("opc", 1.0), ("inv", 0.0), ("bm", 0.0))]
    assert painted is under or not any(says), "a layer that shows something says what Nuke is not known to do"
    return painted


def shows(shape: Shape, frame: float) -> bool:
    """Whether a shape is painted on a frame."""
    alive = shape.value("ltt", frame, 0.0) != 4.0 or (
        shape.value("ltn", frame, 0.0) <= frame <= shape.value("ltm", frame, 0.0)
    )
    return alive and shape.closed and bool(shape.flags & RENDERABLE) and shape.value("vis", frame, 1.0) != 0.0


def shape_matte(shape: Shape, frame: float, size: tuple[int, ...]) -> Array:
    """One shape alone, inverted and scaled."""
    moments = [frame]
    if shape.value("mbo", frame, 0.0):
        shutter, offset = shape.value("mbs", frame, 0.5), shape.value("mbso", frame, 0.0)
        assert shape.value("mbsot", frame, 0.0) == 3.0
        moments = [frame + offset + shutter * (k + 0.5) / BLUR_SAMPLES for k in range(BLUR_SAMPLES)]
    whole = np.mean([_covered(shape, moment, frame, (size[0], size[1])) for moment in moments], axis=0)
    if shape.value("inv", frame, 0.0):
        whole = 1.0 - whole
    return np.asarray(whole * shape.value("opc", frame, 1.0))


def _covered(shape: Shape, moment: float, frame: float, size: tuple[int, int]) -> Array:
    points = _down(shape.triples(moment), size[0])
    covered = filled(points, size)
    if shape.feather is not None:
        covered = between(points, _down(shape.feather_triples(moment), size[0]), size)
    width = shape.value("fx", frame, 0.0) if shape.value("fo", frame, 1.0) else 0.0
    if width == 0.0:
        return covered
    ramp = soft(points, size, min(width, 0.0), max(width, 0.0))
    return np.maximum(covered, ramp) if width > 0.0 else np.minimum(covered, ramp)


def _down(triples: list[list[tuple[float, float]]], height: int) -> Array:
    """Anchor, in- and out-handle `(P, 3, 2)`, y down."""
    return np.asarray(np.array(triples)[:, [1, 0, 2]] * [1.0, -1.0] + [0.0, height])


def _blended(under: Array, matte: Array, mode: int) -> Array:
    joined: dict[int, Array] = {
        OVER: under + matte - under * matte,
        MAX: np.maximum(under, matte),
        INSIDE: under * matte,
        SUBTRACT: under * (1.0 - matte),
        DIFFERENCE: np.abs(under - matte),
    }
    return joined[mode]
