"""Nuke's menu against a stand-in for the few calls of `nuke` that it makes; ROAM's commands are run as they are."""

from __future__ import annotations

import shutil
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
import pytest

from roam_core.interchange import write_shapes
from roam_core.roto import file
from tests.unit.plugins.conftest import Desk, pytestmark

__all__ = ["pytestmark"]


class Knob:
    def __init__(self, value: object) -> None:
        self._value = value

    def value(self) -> object:
        return self._value


class Node:
    def __init__(self, kind: str, **knobs: object) -> None:
        self.kind, self.knobs, self.selected = kind, knobs, True

    def Class(self) -> str:
        return self.kind

    def name(self) -> str:
        return f"{self.kind}1"

    def setSelected(self, selected: bool) -> None:
        self.selected = selected

    def __getitem__(self, name: str) -> Knob:
        return Knob(self.knobs.get(name, ""))


class Nuke(ModuleType):
    """Remembers what was pasted and told; what is copied is the text of a script that Nuke could have written."""

    def __init__(self, nodes: list[Node], copied: Path, chosen: Path | None) -> None:
        super().__init__("nuke")
        self._nodes, self._copied, self._chosen = nodes, copied, chosen
        self.pasted, self.messages, self.asked = "", list[str](), list[str]()

    def selectedNodes(self) -> list[Node]:
        return [node for node in self._nodes if node.selected]

    def filename(self, node: Node) -> Any:
        return node.knobs.get("file")

    def getFilename(self, title: str, pattern: str, type: str) -> str | None:
        self.asked.append(type)
        return None if self._chosen is None else str(self._chosen)

    def nodeCopy(self, path: str) -> None:
        assert [node.kind for node in self.selectedNodes()] == ["Roto"]
        shutil.copy(self._copied, path)

    def nodePaste(self, path: str) -> None:
        self.pasted = Path(path).read_text(encoding="utf-8")

    def message(self, sentence: str) -> None:
        self.messages.append(sentence)

    def tprint(self, sentence: str) -> None:
        self.asked.append(sentence)


def nuke_of(desk: Desk, nodes: list[Node], chosen: Path | None) -> Nuke:
    copied = desk.folder / "copied.nk"
    write_shapes(file.load(desk.project), copied, "nuke")
    return Nuke(nodes, copied, chosen)


def read(desk: Desk, **knobs: object) -> Node:
    return Node("Read", file=f"{desk.plate}/plate.%04d.png", **knobs)


def test_plate_and_shapes_become_a_project(desk: Desk, plugin: Any) -> None:
    nuke = nuke_of(desk, [read(desk), Node("Roto")], desk.folder / "sent")
    plugin("nuke", "roam_nuke", {"nuke": nuke}).send()
    assert nuke.messages == []
    sent = file.load(desk.folder / "sent.roam")
    (shape,) = sent.shapes
    assert (sent.require_clip().first, sent.require_clip().last) == (1001, 1005)
    np.testing.assert_allclose(shape.at(1003).points, file.load(desk.project).shapes[0].at(1003).points, atol=0.01)
    assert desk.opened == [str(desk.folder / "sent.roam")]
    assert all(node.selected for node in nuke.selectedNodes())


def test_a_plate_alone_is_opened_as_a_clip(desk: Desk, plugin: Any) -> None:
    nuke = nuke_of(desk, [read(desk)], None)
    plugin("nuke", "roam_nuke", {"nuke": nuke}).send()
    assert desk.opened == [f"{desk.plate}/plate.%04d.png"]
    assert (nuke.messages, nuke.asked) == ([], [])


def test_shapes_come_back_as_nodes(desk: Desk, plugin: Any) -> None:
    nuke = nuke_of(desk, [], desk.project)
    plugin("nuke", "roam_nuke", {"nuke": nuke}).bring()
    assert nuke.messages == []
    assert "Roto {" in nuke.pasted
    assert "Arm" in nuke.pasted


@pytest.mark.parametrize(
    ("kinds", "knobs", "said"),
    [
        (["Roto"], {}, "Select one Read node"),
        (["Read"], {"frame": "frame-1000"}, "knob frame"),
        (["Read"], {"file": None}, "reads no file"),
    ],
)
def test_what_cannot_be_sent_is_one_sentence(
    desk: Desk, plugin: Any, kinds: list[str], knobs: dict[str, object], said: str
) -> None:
    nodes = [Node(kind, **{"file": str(desk.plate), **knobs}) for kind in kinds]
    nuke = nuke_of(desk, nodes, None)
    plugin("nuke", "roam_nuke", {"nuke": nuke}).send()
    assert [said in message for message in nuke.messages] == [True]
    assert desk.opened == []


def test_a_refusal_of_roam_is_told_in_its_own_words(desk: Desk, plugin: Any) -> None:
    nuke = nuke_of(desk, [], desk.folder / "missing.roam")
    plugin("nuke", "roam_nuke", {"nuke": nuke}).bring()
    assert len(nuke.messages) == 1
    assert nuke.messages[0].startswith("roam: ")
    assert "missing.roam" in nuke.messages[0]
