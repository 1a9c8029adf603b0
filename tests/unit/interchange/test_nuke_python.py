"""The Python script for Nuke, run with stand-ins for Nuke's classes that record what it makes."""

from __future__ import annotations

import sys
from dataclasses import dataclass, field, replace
from itertools import pairwise
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from roam_core.interchange import ExportOptions, KeyChoice
from roam_core.interchange.nuke import roto_script
from roam_core.interchange.nuke_python import python_document
from roam_core.roto import Layer, Project
from tests.unit.interchange.conftest import CLIP, animated
from tests.unit.interchange.nuke_judge import evaluate, judge


@dataclass
class Key:
    """An AnimCurveKey."""

    time: float
    value: float
    interpolationType: int = 0  # noqa: N815
    lslope: float = 0.0
    rslope: float = 0.0
    la: float = 0.0
    ra: float = 0.0


class Point:
    """An AnimControlPoint."""

    def __init__(self, *position: float) -> None:
        self.position = position
        self.curves: tuple[list[Key], list[Key]] = ([], [])
        self.weights: set[float] = set()

    def addPositionKey(self, time: float, vector: tuple[float, float, float]) -> None:
        for curve, value in zip(self.curves, vector, strict=False):
            curve.append(Key(time, value))
        self.weights.add(vector[2])

    def getPositionAnimCurve(self, axis: int) -> Any:
        curve = ModuleType("curve")
        curve.getKey = self.curves[axis].__getitem__  # type: ignore[attr-defined]
        return curve

    def at(self, frame: float) -> list[float]:
        """By the rules of the judge: a straight key has the slopes of its neighbours' secants."""
        values = []
        for keys in self.curves:
            times = [key.time for key in keys]
            triples = []
            for i, key in enumerate(keys):
                secants = [(b.value - a.value) / (b.time - a.time) for a, b in pairwise(keys)]
                if key.interpolationType == 2:
                    triples.append((key.value, secants[i - 1] if i else 0.0, secants[i] if i < len(secants) else 0.0))
                else:
                    assert (key.interpolationType, key.la, key.ra) == (3, 1.0, 1.0)
                    triples.append((key.value, key.lslope, key.rslope))
            values.append(evaluate(times, triples, frame))
        return values


PARTS = ("leftTangent", "center", "rightTangent", "featherLeftTangent", "featherCenter", "featherRightTangent")


@dataclass
class Item:
    """A Layer or a Shape."""

    knob: Any = None
    type: str = "layer"
    name: str = ""
    locked: bool = False
    attributes: dict[str, float] = field(default_factory=dict)
    children: list[Any] = field(default_factory=list)
    flags: set[str] = field(default_factory=set)

    def append(self, child: Any) -> None:
        if isinstance(child, Point):
            point = ModuleType("point")
            for part in PARTS:
                setattr(point, part, Point())
            child = point
        self.children.append(child)

    def __iter__(self) -> Any:
        return iter(self.children)

    def getAttributes(self) -> Any:
        attributes = ModuleType("attributes")
        attributes.set = self.attributes.__setitem__  # type: ignore[attr-defined]
        return attributes

    def setFlag(self, flag: str, value: bool) -> None:
        assert value
        self.flags.add(flag)

    def shapes(self) -> list[Item]:
        return [s for c in self.children for s in (c.shapes() if c.type == "layer" else [c])]

    def points(self, frame: float, height: int, *, feather: bool = False) -> np.ndarray:
        """(P, 3, 2) anchor, in- and out-handle, absolute, y down."""
        rows = []
        for point in self.children:
            incoming, centre, outgoing = (np.array(getattr(point, part).at(frame)) for part in PARTS[:3])
            if feather:
                a, b, c = (np.array(getattr(point, part).at(frame)) for part in PARTS[3:])
                incoming, centre, outgoing = a, centre + b, c
            rows.append([centre, centre + incoming, centre + outgoing])
        return np.array(rows) * [1, -1] + [0, height]


@pytest.fixture
def run(monkeypatch: pytest.MonkeyPatch) -> Any:
    """`run(script)` gives the root layer that it fills."""

    def execute(script: str) -> Item:
        root = Item()
        knob = ModuleType("knob")
        changes: list[int] = []
        knob.__dict__.update(rootLayer=root, changed=lambda: changes.append(1))
        output = ModuleType("output")
        output.__dict__.update(setValue=lambda value: None)
        nuke, rotopaint, nodes, flags = (ModuleType(name) for name in ("nuke", "nuke.rotopaint", "nodes", "flags"))
        nodes.__dict__.update(Roto=lambda: {"curves": knob, "output": output})
        flags.__dict__.update(eOpenFlag="open")
        nuke.__dict__.update(rotopaint=rotopaint, nodes=nodes)
        rotopaint.__dict__.update(Layer=Item, Shape=Item, AnimControlPoint=Point, CVec3=lambda *v: v, FlagType=flags)
        monkeypatch.setitem(sys.modules, "nuke", nuke)
        monkeypatch.setitem(sys.modules, "nuke.rotopaint", rotopaint)
        exec(compile(script, "script.py", "exec"), {"__name__": "__main__"})  # noqa: S102 - our own script
        assert changes == [1]
        return root

    return execute


def test_the_script_makes_what_the_text_says(run: Any, project: Project) -> None:
    root = run(python_document(project)[0])
    written = judge(roto_script(project)).root.shapes()
    shapes = list(reversed(project.shapes))
    assert [item.name for item in root.shapes()] == [shape.name for shape in shapes]
    for item, shape, text in zip(root.shapes(), shapes, written, strict=True):
        assert ("open" in item.flags, item.locked) == (not shape.closed, shape.locked)
        for name, value in text.attributes.items():
            assert item.attributes[name] == pytest.approx(value, rel=1e-6)
        for frame in np.linspace(1001, 1030, 24):
            np.testing.assert_allclose(item.points(frame, 1080), text.points(frame), atol=0.01)


def test_feather_curves_are_made(run: Any, project: Project) -> None:
    item = next(item for item in run(python_document(project)[0]).shapes() if item.name == "Soft")
    outline = next(shape for shape in project.shapes if shape.name == "Soft").at(1009)
    expected = outline.points + outline.feather
    np.testing.assert_allclose(item.points(1009, 1080, feather=True), expected, atol=0.01)
    assert {item.children[0].center.weights.pop(), item.children[0].leftTangent.weights.pop()} == {1.0, 0.0}


def test_layers_keep_their_places_and_properties(run: Any, project: Project) -> None:
    root = run(python_document(project)[0])
    assert [child.name for child in root] == ["Smooth", "Open", "Body", "Still"]
    body = root.children[2]
    assert (body.attributes["opc"], body.attributes["inv"], body.attributes["vis"]) == (0.5, 1.0, 0.0)
    assert [child.name for child in body] == ["Soft", "Deep", "Arm"]
    assert body.children[1].locked


def test_reduced_keys_carry_their_slopes(run: Any, project: Project) -> None:
    options = ExportOptions(keys=KeyChoice.REDUCED, tolerance=2.0)
    script, notes = python_document(project, options)
    text = {shape.name: shape for shape in judge(roto_script(project, options)).root.shapes()}
    for item in run(script).shapes():
        np.testing.assert_allclose(item.points(1007.5, 1080), text[item.name].points(1007.5), atol=0.01)
    assert len(notes) == len(project.shapes)


@pytest.mark.parametrize(
    "name",
    ['"""', "'''", "\\", "'+__import__('os')+'", "%s%(a)d{}", "\n\r\0", "\u00e9\N{HAIRCUT}", "# \\x", "x" * 10000, ""],
)
def test_any_name_is_only_a_name(run: Any, name: str) -> None:
    layer = Layer("layer-1", name, (replace(animated("A"), name=name),))
    script, _ = python_document(Project(CLIP, Layer("root", "Root", (layer,))))
    assert script.isascii()
    (inner,) = run(script).children
    assert (inner.name, inner.shapes()[0].name) == (name, name)


def test_a_lone_surrogate_is_replaced(run: Any) -> None:
    shape = replace(animated("A"), name="half \ud83d")
    script, _ = python_document(Project(CLIP, Layer("root", "Root", (shape,))))
    assert run(script).shapes()[0].name == "half \ufffd"
