"""Runs a script for Natron against objects that remember what it does to them."""

from __future__ import annotations

import json
import sys
from types import ModuleType, SimpleNamespace
from typing import Any
from unittest.mock import patch

import numpy as np

from tests.unit.interchange.judged import JudgedMask


class _Param:
    def __init__(self) -> None:
        self.value: Any = None
        self.keys: dict[float, Any] = {}
        self.kinds: dict[float, str] = {}

    def setValue(self, value: object) -> None:
        self.value = value

    set = setValue

    def setValueAtTime(self, value: float, time: float) -> None:
        self.keys[time] = value

    def setInterpolationAtTime(self, time: float, kind: str) -> None:
        assert time in self.keys
        self.kinds[time] = kind

    def at(self, time: float) -> Any:
        """The value at a time: straight from key to key, but for those that hold."""
        if not self.keys:
            return self.value
        times = sorted(self.keys)
        before = max((each for each in times if each <= time), default=times[0])
        if time <= before or self.kinds[before] == "Constant":
            return self.keys[before]
        return np.interp(time, times, [self.keys[each] for each in times])


class Node:
    """A node of the graph: what kind it is, its parameters, its inputs, and the base layer of a Roto."""

    def __init__(self, plugin: str) -> None:
        self.plugin = plugin
        self.base = _Item()
        self.params = {"operation": _Param(), "mix": _Param()}
        self.inputs: dict[int, Node] = {}
        assert plugin in ("fr.inria.built-in.Roto", "net.sf.openfx.MergePlugin")

    def setLabel(self, text: str) -> None:
        self.label = text

    def getRotoContext(self) -> SimpleNamespace:
        assert self.plugin.endswith("Roto")
        return SimpleNamespace(getBaseLayer=lambda: self.base, createLayer=_Item, createBezier=_Bezier)

    def getParam(self, name: str) -> _Param:
        return self.params[name]

    def connectInput(self, number: int, node: Node) -> None:
        self.inputs[number] = node


class _Item:
    def __init__(self) -> None:
        self.label, self.script_name, self.visible, self.locked = "", "", True, False
        self.children: list[_Item] = []

    def setLabel(self, text: str) -> None:
        self.label = text.encode("utf-8").decode("utf-8")

    def setScriptName(self, text: str) -> None:
        assert text.isidentifier()
        self.script_name = text

    def setVisible(self, visible: bool) -> None:
        self.visible = visible

    def setLocked(self, locked: bool) -> None:
        self.locked = locked

    def addItem(self, item: _Item) -> None:
        self.children.append(item)


class _Bezier(_Item):
    def __init__(self, x: float, y: float, time: int) -> None:
        super().__init__()
        self.count, self.outline, self.feather = 1, dict[tuple[float, int], Any](), dict[tuple[float, int], Any]()
        self.start, self.closed, self.operator, self.overlay = (x, y, time), False, "", (0.0, 0.0, 0.0)
        self.activated: dict[int, bool] = {}
        self.params = {name: _Param() for name in ("inverted", "lifeTime", "motionBlur", "motionBlurShutter")}
        self.params |= {name: _Param() for name in ("motionBlurShutterOffset", "motionBlurCustomShutterOffset")}
        self.opacity, self.distance = _Param(), _Param()

    def addControlPoint(self, x: float, y: float) -> None:
        self.count += 1

    def setPointAtIndex(self, index: int, time: float, *values: float) -> None:
        assert 0 <= index < self.count
        assert len(values) == 6
        self.outline[time, index] = values

    def setFeatherPointAtIndex(self, index: int, time: float, *values: float) -> None:
        assert 0 <= index < self.count
        self.feather[time, index] = values

    def setCurveFinished(self, closed: bool) -> None:
        self.closed = closed

    def setCompositingOperator(self, operator: str) -> None:
        self.operator = operator

    def setOverlayColor(self, *shares: float) -> None:
        self.overlay = shares

    def setActivated(self, time: int, is_active: bool) -> None:
        self.activated[time] = is_active

    def getParam(self, name: str) -> _Param:
        return self.params[name]

    def getOpacityParam(self) -> _Param:
        return self.opacity

    def getFeatherDistanceParam(self) -> _Param:
        return self.distance


def nodes_of(text: str) -> list[Node]:
    """The nodes that a script makes, in its order."""
    nodes: list[Node] = []
    engine = ModuleType("NatronEngine")
    operators = {name: name for name in ("Over", "Plus", "Stencil", "Mask", "Difference", "Max")}
    enum = SimpleNamespace(**{f"eMerge{name}": name for name in operators})
    kinds = SimpleNamespace(eKeyframeTypeConstant="Constant", eKeyframeTypeLinear="Linear")
    engine.Natron = SimpleNamespace(MergingFunctionEnum=enum, KeyframeTypeEnum=kinds)  # type: ignore[attr-defined]

    def create(plugin: str) -> Node:
        nodes.append(Node(plugin))
        return nodes[-1]

    assert text.isascii()
    with patch.dict(sys.modules, {"NatronEngine": engine}):
        exec(compile(text, "script", "exec"), {"app": SimpleNamespace(createNode=create), "json": json})  # noqa: S102 - our own script
    return nodes


def judge(text: str, height: int) -> tuple[list[JudgedMask], _Item]:
    """The shapes of the script's only Roto node, bottom first, and its base layer."""
    (node,) = nodes_of(text)
    return masks_of(node, height), node.base


def masks_of(node: Node, height: int) -> list[JudgedMask]:
    """The shapes of a Roto node, bottom first."""
    return [_mask(item, height) for item in _beziers(node.base)]


def _beziers(item: _Item) -> list[_Bezier]:
    """Natron lists what lies on top first; what is hidden hides what lies in it."""
    found: list[_Bezier] = []
    for child in reversed(item.children):
        found += [child] if isinstance(child, _Bezier) else _beziers(child)
    return found


def _mask(item: _Bezier, height: int) -> JudgedMask:
    def table(points: dict[tuple[float, int], Any]) -> dict[float, Any]:
        frames = sorted({time for time, _ in points})
        rows = {f: np.array([points[f, k] for k in range(item.count)]).reshape(-1, 3, 2) for f in frames}
        return {f: np.stack([row[..., 0], height - row[..., 1]], axis=-1) for f, row in rows.items()}

    values = {"feather": table(item.feather), "item": item}
    return JudgedMask(item.label, item.closed, table(item.outline), values)
