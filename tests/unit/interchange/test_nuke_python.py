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
from roam_core.interchange.nuke.names import KNOB, LAYER_KNOB, Names, true_names
from roam_core.interchange.nuke.python_script import python_document
from roam_core.roto import Animated, Interpolation, Layer, Project, ValueKey
from roam_core.roto.animated import mapped
from tests.judges import nuke_grammar
from tests.judges.scenes import SCENES
from tests.unit.interchange.conftest import CLIP, animated, roto_script
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
        return [value_of(keys, frame) for keys in self.curves]


def value_of(keys: list[Key], frame: float) -> float:
    """What keys say at a frame, by the rules of the judge."""
    triples = []
    secants = [(b.value - a.value) / (b.time - a.time) for a, b in pairwise(keys)]
    for i, key in enumerate(keys):
        if key.interpolationType == 2:
            triples.append((key.value, secants[i - 1] if i else 0.0, secants[i] if i < len(secants) else 0.0))
        else:
            assert (key.interpolationType, key.la, key.ra) == (3, 1.0, 1.0)
            triples.append((key.value, key.lslope, key.rslope))
    return evaluate([key.time for key in keys], triples, frame)


class Knob:
    """A knob of a node: its value, or the keys of its curve."""

    def __init__(self) -> None:
        self.value: Any = None
        self.keys: list[tuple[float, float]] = []
        self.straight = False

    def setValue(self, value: Any) -> None:
        self.value = value

    def setAnimated(self) -> None:
        self.keys = []

    def setValueAt(self, value: float, time: float) -> None:
        self.keys.append((time, value))

    def animations(self) -> list[Any]:
        def change(keys: Any, kind: str) -> None:
            self.straight = keys == self.keys and kind == "linear"

        curve = ModuleType("curve")
        curve.__dict__.update(keys=lambda: self.keys, changeInterpolation=change)
        return [curve]


class Node:
    """A node: its class, its knobs, and what it takes."""

    def __init__(self, species: str) -> None:
        self.species = species
        self.knobs: dict[str, Any] = {}
        self.inputs: dict[int, Node] = {}
        self.root: Item | None = None
        self.changes = 0
        if species == "Roto":
            self.root = Item()
            self.knobs["curves"] = ModuleType("curves")
            self.knobs["curves"].__dict__.update(rootLayer=self.root, changed=self._changed)

    def _changed(self) -> None:
        self.changes += 1

    def __getitem__(self, name: str) -> Any:
        return self.knobs.setdefault(name, Knob())

    def addKnob(self, knob: tuple[str, str, str]) -> None:
        self.knobs[knob[0]] = knob[2]

    def setInput(self, index: int, node: Node) -> None:
        self.inputs[index] = node


PARTS = ("leftTangent", "center", "rightTangent", "featherLeftTangent", "featherCenter", "featherRightTangent")


@dataclass
class Item:
    """A Layer or a Shape."""

    knob: Any = None
    type: str = "layer"
    name: str = ""
    locked: bool = False
    attributes: dict[str, float] = field(default_factory=dict)
    keys: dict[str, list[Key]] = field(default_factory=dict)
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
        attributes.__dict__.update(set=self._set, getCurve=self._curve)
        return attributes

    def _set(self, *words: Any) -> None:
        if len(words) == 2:
            self.attributes[words[0]] = words[1]
        else:
            time, name, value = words
            self.keys.setdefault(name, []).append(Key(time, value))

    def _curve(self, name: str) -> Any:
        curve = ModuleType("curve")
        curve.getKey = self.keys[name].__getitem__  # type: ignore[attr-defined]
        return curve

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
    """`run(script)` gives the root layer of the one node that it makes."""
    every = nodes_of(monkeypatch)

    def execute(script: str) -> Item:
        (node,) = every(script)
        assert node.root is not None
        return node.root

    return execute


@pytest.fixture
def run_all(monkeypatch: pytest.MonkeyPatch) -> Any:
    """`run_all(script)` gives the nodes that it makes, in their order."""
    return nodes_of(monkeypatch)


def nodes_of(monkeypatch: pytest.MonkeyPatch) -> Any:
    def execute(script: str) -> list[Node]:
        made: list[Node] = []

        class Nodes:
            def __getattr__(self, species: str) -> Any:
                def make() -> Node:
                    made.append(Node(species))
                    return made[-1]

                return make

        nuke, rotopaint, flags = (ModuleType(name) for name in ("nuke", "nuke.rotopaint", "flags"))
        flags.__dict__.update(eOpenFlag="open")
        nuke.__dict__.update(rotopaint=rotopaint, nodes=Nodes(), LINEAR="linear", String_Knob=lambda *words: words)
        rotopaint.__dict__.update(Layer=Item, Shape=Item, AnimControlPoint=Point, CVec3=lambda *v: v, FlagType=flags)
        monkeypatch.setitem(sys.modules, "nuke", nuke)
        monkeypatch.setitem(sys.modules, "nuke.rotopaint", rotopaint)
        exec(compile(script, "script.py", "exec"), {"__name__": "__main__"})  # noqa: S102 - our own script
        assert all(node.changes == (1 if node.species == "Roto" else 0) for node in made)
        return made

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
    assert all(repr(shape.name) in " ".join(notes) for shape in project.shapes)


@pytest.mark.parametrize(
    "name",
    ['"""', "'''", "\\", "'+__import__('os')+'", "%s%(a)d{}", "\n\r\0", "\u00e9\N{HAIRCUT}", "# \\x", "x" * 10000, ""],
)
def test_any_name_is_only_a_name(run: Any, name: str) -> None:
    layer = Layer("layer-1", name, (replace(animated("A"), name=name),))
    script, _ = python_document(Project(CLIP, Layer("root", "Root", (layer,))))
    assert script.isascii()
    (inner,) = run(script).children
    names = Names.of(Layer("root", "Root", (layer,)))
    assert (inner.name, inner.shapes()[0].name) == tuple(names.by_id.values())
    assert inner.name.isascii()


def test_true_names_stand_in_label_and_knob(run_all: Any) -> None:
    shape = replace(animated("A"), name="Größe [exit]")
    (node,) = run_all(python_document(Project(CLIP, Layer("root", "Root", (shape,))))[0])
    assert node.root.shapes()[0].name == "Grosse (exit)"
    assert node["label"].value == "Grosse (exit) = Größe (exit)"
    assert true_names(node.knobs[KNOB]) == {"Grosse (exit)": "Größe [exit]"}


def test_a_lone_surrogate_is_replaced(run: Any) -> None:
    shape = replace(animated("A"), name="half \ud83d")
    script, _ = python_document(Project(CLIP, Layer("root", "Root", (shape,))))
    assert run(script).shapes()[0].name == "half _"


def test_opacity_and_feather_that_vary_have_keys(run: Any) -> None:
    smooth, hold = Interpolation.SMOOTH, Interpolation.HOLD
    value = Animated(
        (ValueKey(1001, 0.0, smooth), ValueKey(1005, 1.0, hold), ValueKey(1010, 0.25), ValueKey(1020, 0.5))
    )
    shape = replace(animated("A"), opacity=value, feather=mapped(value, lambda share: 20.0 * share))
    (item,) = run(python_document(Project(CLIP, Layer("root", "Root", (shape,))))[0]).shapes()
    for frame in (1001, 1002.5, 1005, 1007.5, 1009.9, 1010, 1015, 1020):
        assert value_of(item.keys["opc"], frame) == pytest.approx(value.at(frame))
        assert value_of(item.keys["fx"], frame) == pytest.approx(20.0 * value.at(frame))
        assert value_of(item.keys["fy"], frame) == pytest.approx(20.0 * value.at(frame))


@pytest.mark.parametrize("name", ["layers", "in time"])
def test_layers_are_the_nodes_of_the_text(run_all: Any, name: str) -> None:
    project = SCENES[name].project
    made = run_all(python_document(project)[0])
    written = nuke_grammar.nodes(roto_script(project))
    assert [node.species for node in made] == [node.species for node in written]
    left: list[Node] = []
    for node, text in zip(made, written, strict=True):
        taken = int(text.knobs.get("inputs", "1"))
        assert [node.inputs[k] for k in range(taken)] == [left.pop() for _ in range(taken)]
        left.append(node)
        if text.root is not None:
            assert [shape.name for shape in node.root.shapes()] == [shape.name for shape in text.root.shapes()]
        if node.species == "Merge2":
            assert node["operation"].value == text.knobs["operation"]
        if node.species == "Multiply":
            knob = node["value"]
            keys = " ".join(f"x{time:.10g} {value!r}" for time, value in knob.keys)
            assert text.knobs["value"] == (f"{{{{curve L {keys}}}}}" if knob.keys else repr(knob.value))
            assert knob.straight or not knob.keys
        if node.species == "NoOp":
            assert node.knobs[LAYER_KNOB] == text.knobs[LAYER_KNOB]
