"""Natron's menu against a stand-in for the few calls of Natron that it makes; ROAM's commands are run as they are."""

from __future__ import annotations

from pathlib import Path
from types import ModuleType, SimpleNamespace
from typing import Any

import numpy as np
import pytest

from roam_core.roto import BlendMode, file
from tests.unit.plugins.conftest import SIZE, Desk, corners, pytestmark

__all__ = ["pytestmark"]

MODES = ("eMergeOver", "eMergePlus", "eMergeStencil", "eMergeMask", "eMergeDifference", "eMergeMax")


class Curve:
    """A curve as Natron gives it: y up, moving straight by ten pixels a frame from the project's first frame."""

    def __init__(self, operator: str) -> None:
        self.operator = operator

    def getNumControlPoints(self) -> int:
        return 4

    def getControlPointPosition(self, index: int, time: float) -> tuple[float, ...]:
        row = corners(20 + 10 * (time - 1001), 20)[index]
        return tuple(float(value) for x, y in row for value in (x, SIZE[1] - y))

    def getCompositingOperator(self) -> str:
        return self.operator

    def getLabel(self) -> str:
        return "Bein"

    def isCurveFinished(self) -> bool:
        return True

    def getVisible(self) -> bool:
        return True

    def getLocked(self) -> bool:
        return False

    def getParam(self, name: str) -> SimpleNamespace:
        return SimpleNamespace(get=lambda: False)

    def getOpacity(self, time: float) -> float:
        return 0.5

    def getFeatherDistance(self, time: float) -> float:
        return 3.0


def node(kind: str, **parts: Any) -> SimpleNamespace:
    return SimpleNamespace(getPluginID=lambda: kind, getLabel=lambda: kind, **parts)


class App:
    def __init__(self, nodes: list[SimpleNamespace], chosen: Path) -> None:
        self._nodes, self._chosen = nodes, chosen
        self.said = list[str]()

    def getSelectedNodes(self) -> list[SimpleNamespace]:
        return self._nodes

    def saveFilenameDialog(self, kinds: list[str]) -> str:
        return str(self._chosen)

    def getFilenameDialog(self, kinds: list[str]) -> str:
        return str(self._chosen)

    def getProjectParam(self, name: str) -> SimpleNamespace:
        assert name == "frameRange"
        return SimpleNamespace(get=lambda: SimpleNamespace(x=1001.0, y=1005.0))

    def writeToScriptEditor(self, text: str) -> None:
        self.said.append(text)


def natron_of(app: App) -> tuple[dict[str, ModuleType], list[str]]:
    engine, gui = ModuleType("NatronEngine"), ModuleType("NatronGui")
    errors = list[str]()
    engine.Natron = SimpleNamespace(MergingFunctionEnum=SimpleNamespace(**{name: name for name in MODES}))  # type: ignore[attr-defined]
    gui.natron = SimpleNamespace(  # type: ignore[attr-defined]
        getGuiInstance=lambda number: app, errorDialog=lambda title, text: errors.append(text)
    )
    return {"NatronEngine": engine, "NatronGui": gui}, errors


def reader(desk: Desk) -> SimpleNamespace:
    size = SimpleNamespace(width=lambda: SIZE[0], height=lambda: SIZE[1])
    name = SimpleNamespace(get=lambda: f"{desk.plate}/plate.####.png")
    return node("fr.inria.built-in.Read", getParam=lambda knob: name, getOutputFormat=lambda: size)


def test_plate_and_curves_become_a_project(desk: Desk, plugin: Any) -> None:
    layer = SimpleNamespace(getChildren=lambda: [Curve("eMergeStencil"), Curve("eMergeOver")])
    roto = node("fr.inria.built-in.Roto", getRotoContext=lambda: SimpleNamespace(getBaseLayer=lambda: layer))
    theirs, errors = natron_of(App([reader(desk), roto], desk.folder / "sent.roam"))
    plugin("natron", "roam_natron", theirs).send()
    assert errors == []
    under, above = file.load(desk.folder / "sent.roam").shapes
    assert (under.blend, above.blend) == (BlendMode.ADD, BlendMode.SUBTRACT)
    assert (under.name, under.opacity, under.feather) == ("Bein", 0.5, 3.0)
    assert under.frames == (1001, 1005)
    np.testing.assert_allclose(under.at(1003).points, corners(40, 20), atol=1e-6)
    assert desk.opened == [str(desk.folder / "sent.roam")]


def test_without_a_plate_there_is_one_sentence(desk: Desk, plugin: Any) -> None:
    theirs, errors = natron_of(App([], desk.project))
    plugin("natron", "roam_natron", theirs).send()
    assert len(errors) == 1
    assert "Select one Read node" in errors[0]


def test_the_script_that_comes_back_is_run_in_the_project(desk: Desk, plugin: Any, monkeypatch: Any) -> None:
    app = App([], desk.project)
    theirs, errors = natron_of(app)
    made = list[str]()

    def create(kind: str) -> Any:
        made.append(kind)
        raise KeyError("enough was seen")

    app.createNode = create  # type: ignore[attr-defined]
    script = plugin("natron", "roam_natron", theirs)
    with pytest.raises(KeyError, match="enough was seen"):
        script.bring()
    assert (made, errors) == (["fr.inria.built-in.Roto"], [])
