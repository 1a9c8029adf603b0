"""The menu ROAM in Nuke 13 and newer: the selected plate and shapes to ROAM, and shapes from there as Roto nodes."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path
from typing import Any

import nuke
import roam_bridge

ROTOS = ("Roto", "RotoPaint")


def send() -> None:
    """Make a project of the selected Read and Roto nodes, and open it in ROAM."""
    _told(_send)


def bring() -> None:
    """Paste the shapes of a project as Roto nodes."""
    _told(_bring)


def _send() -> None:
    nodes = nuke.selectedNodes()
    reads = [node for node in nodes if node.Class() == "Read"]
    rotos = [node for node in nodes if node.Class() in ROTOS]
    if len(reads) != 1:
        raise roam_bridge.Trouble("Select one Read node, the plate, and the Roto nodes whose shapes ROAM is to get.")
    clip = nuke.filename(reads[0])
    if not clip:
        raise roam_bridge.Trouble(f"{reads[0].name()} reads no file.")
    if reads[0]["frame"].value():
        raise roam_bridge.Trouble(
            f"{reads[0].name()} gives frames other numbers (knob frame); ROAM keeps the plate's own. Empty the knob."
        )
    if not rotos:
        roam_bridge.send(Path(), clip, None)
        return
    project = _chosen("Make a ROAM project", "save")
    if project is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        shapes = Path(folder) / "shapes.nk"
        for node in nodes:
            node.setSelected(node in rotos)
        try:
            nuke.nodeCopy(shapes.as_posix())
        finally:
            for node in nodes:
                node.setSelected(True)
        roam_bridge.send(project, clip, shapes)


def _bring() -> None:
    project = _chosen("A ROAM project", "open")
    if project is None:
        return
    with tempfile.TemporaryDirectory() as folder:
        shapes = Path(folder) / "shapes.nk"
        said = roam_bridge.bring(project, shapes, "nuke")
        nuke.nodePaste(shapes.as_posix())
    nuke.tprint(said)


def _chosen(title: str, kind: str) -> Path | None:
    name = nuke.getFilename(title, "*.roam", type=kind)
    return roam_bridge.project_of(name) if name else None


def _told(work: Callable[[], Any]) -> None:
    try:
        work()
    except roam_bridge.Trouble as trouble:
        nuke.message(str(trouble))
