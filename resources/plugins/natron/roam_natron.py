"""The menu ROAM in Natron 2.5 and newer: the selected plate and shapes to ROAM, and shapes from there as Roto nodes."""

from __future__ import annotations

import tempfile
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import NatronEngine
import NatronGui
import roam_bridge

ROTO = "fr.inria.built-in.Roto"
READ = "fr.inria.built-in.Read"
MODES = {
    "eMergeOver": "add",
    "eMergePlus": "plus",
    "eMergeStencil": "subtract",
    "eMergeMask": "intersect",
    "eMergeDifference": "difference",
    "eMergeMax": "max",
}


def send() -> None:
    """Make a project of the selected Read and Roto nodes, and open it in ROAM."""
    _told(_send)


def bring() -> None:
    """Make Roto nodes of the shapes of a project."""
    _told(_bring)


def _send(app: Any) -> None:
    nodes = app.getSelectedNodes()
    reads = [node for node in nodes if node.getPluginID().startswith(READ)]
    rotos = [node for node in nodes if node.getPluginID() == ROTO]
    if len(reads) != 1:
        raise roam_bridge.Trouble("Select one Read node, the plate, and the Roto nodes whose shapes ROAM is to get.")
    clip = reads[0].getParam("filename").get()
    if not clip:
        raise roam_bridge.Trouble(f"{reads[0].getLabel()} reads no file.")
    if not rotos:
        roam_bridge.send(Path(), clip, None)
        return
    project = app.saveFilenameDialog(["roam"])
    if not project:
        return
    picture = reads[0].getOutputFormat()
    size = (int(picture.width()), int(picture.height()))
    ends = app.getProjectParam("frameRange")
    frames = range(int(ends.get().x), int(ends.get().y) + 1)
    shapes = [
        _shape(curve, frames, size[1]) for node in rotos for curve in _curves(node.getRotoContext().getBaseLayer())
    ]
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "shapes.json"
        path.write_text(roam_bridge.document(shapes, size), encoding="utf-8")
        roam_bridge.send(roam_bridge.project_of(project), clip, path)


def _bring(app: Any) -> None:
    project = app.getFilenameDialog(["roam"])
    if not project:
        return
    with tempfile.TemporaryDirectory() as folder:
        script = Path(folder) / "shapes.py"
        said = roam_bridge.bring(Path(project), script, "natron")
        text = script.read_text(encoding="ascii")
    # ROAM wrote this script a moment ago, in a folder that nobody else can write to.
    exec(compile(text, "shapes.py", "exec"), {"__name__": "__main__", "app": app})  # noqa: S102
    app.writeToScriptEditor(said)


def _curves(layer: Any) -> Iterator[Any]:
    """The curves below a layer, bottom first; Natron lists the topmost first."""
    for item in reversed(layer.getChildren()):
        if hasattr(item, "getChildren"):
            yield from _curves(item)
        else:
            yield item


def _shape(curve: Any, frames: range, height: int) -> dict[str, Any]:
    """One curve as ROAM's JSON has it: y down, keys where it does not move straight."""
    rows = {
        frame: [_point(curve, index, frame, height) for index in range(curve.getNumControlPoints())] for frame in frames
    }
    operator = curve.getCompositingOperator()
    modes = {getattr(NatronEngine.Natron.MergingFunctionEnum, name): mode for name, mode in MODES.items()}
    return {
        "name": curve.getLabel(),
        "closed": curve.isCurveFinished(),
        "visible": curve.getVisible(),
        "locked": curve.getLocked(),
        "blend": modes.get(operator, "add"),
        "invert": bool(curve.getParam("inverted").get()),
        "opacity": curve.getOpacity(frames[0]),
        "feather": curve.getFeatherDistance(frames[0]),
        "keys": roam_bridge.keys_of(rows),
    }


def _point(curve: Any, index: int, frame: int, height: int) -> list[float]:
    x, y, left_x, left_y, right_x, right_y = curve.getControlPointPosition(index, frame)
    return [x, height - y, left_x, height - left_y, right_x, height - right_y]


def _told(work: Callable[[Any], None]) -> None:
    try:
        work(NatronGui.natron.getGuiInstance(0))
    except roam_bridge.Trouble as trouble:
        NatronGui.natron.errorDialog("ROAM", str(trouble))
