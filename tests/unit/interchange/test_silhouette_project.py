"""Whole projects of Silhouette: packed or plain, their size and first frame, the shapes of their Roto nodes."""

from __future__ import annotations

import struct
import zlib
from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.interchange import Imported, read_shapes
from roam_core.interchange.silhouette import project as silhouette_project
from roam_core.roto import Layer, Spline
from tests.unit.interchange.test_silhouette_reading import CLIP, CONTROLS, constant, keyed, shape_xml, spline_key

SESSION = constant("size", "(200.000000000,100.000000000)") + constant("startFrame", "1001")


def node(body: str, label: str = "Roto", kind: str = "RotoNode") -> str:
    objects = f'<Property id="objects" constant="True" expanded="True">{body}</Property>'
    return f'<Node type="{kind}" label="{label}"><Properties>{objects}</Properties></Node>'


def project_xml(*nodes: str, session: str = SESSION, source: str = 'width="200" height="100"') -> bytes:
    return (
        '<!-- Silhouette Project File -->\n<Project type="Project" version="2022.5" label="shot">'
        f'<Item type="SourceItem"><Source type="FileSource" {source}><Path>D:/plate.####.exr</Path></Source></Item>'
        f'<Item type="Session"><Session type="Session" label="s"><Properties>{session}</Properties>'
        f"{''.join(nodes)}</Session></Item></Project>"
    ).encode()


def packed(xml: bytes) -> bytes:
    return struct.pack(">I", len(xml)) + zlib.compress(xml)


def read(folder: Path, content: bytes) -> Imported:
    path = folder / "shot.sfx"
    path.write_bytes(content)
    return read_shapes(path, CLIP)


def as_object(xml: str) -> str:
    return xml.replace("<Shape ", "<Object ").replace("</Shape>", "</Object>")


@pytest.mark.parametrize("pack", [packed, bytes], ids=["packed", "plain"])
def test_the_shapes_of_a_tracked_layer(tmp_path: Path, pack: type[bytes]) -> None:
    move = keyed("transform.matrix", (0, matrix(0.0)), (10, matrix(0.1)))
    shape = as_object(shape_xml(spline_key(0, CONTROLS), label="Arm"))
    objects = f'<Property id="objects">{shape}</Property>'
    layer = f'<Object type="Layer" label="Body"><Properties>{move}{objects}</Properties></Object>'
    imported = read(tmp_path, pack(project_xml(node(layer), node("", kind="OutputNode"))))
    (arm,) = imported.layer.in_plate_space().shapes()
    assert (arm.name, arm.spline, arm.frames) == ("Arm", Spline.BSPLINE, (1001,))
    np.testing.assert_allclose(arm.at(1006).control_points[:, 0], CONTROLS * 100 + [105, 50], atol=1e-6)
    assert imported.notes == ()


def matrix(x: float) -> str:
    return f"(1,0,0,0,0,1,0,0,0,0,1,0,{x},0,0,1)"


def test_several_nodes_are_layers_of_their_names(tmp_path: Path) -> None:
    shape = as_object(shape_xml())
    imported = read(tmp_path, project_xml(node(shape, "Hero"), node("", "Empty"), node(shape + shape, "Wires")))
    layers = [layer for layer in imported.layer.children if isinstance(layer, Layer)]
    assert [(layer.name, len(list(layer.shapes()))) for layer in layers] == [("Hero", 1), ("Wires", 2)]


def test_the_size_is_the_sessions_or_else_the_plates_and_scales(tmp_path: Path) -> None:
    xml = project_xml(node(as_object(shape_xml())), session="", source='width="400" height="200"')
    imported = read(tmp_path, xml)
    (shape,) = imported.layer.shapes()
    np.testing.assert_allclose(shape.at(1001).anchors[1], [150, 50])
    assert "400 x 200" in imported.notes[0]


def test_a_damaged_pack_is_one_sentence(tmp_path: Path) -> None:
    content = bytearray(packed(project_xml(node(as_object(shape_xml())))))
    content[40] ^= 0xFF
    with pytest.raises(RoamError, match="packed, but damaged"):
        read(tmp_path, bytes(content))
    with pytest.raises(RoamError, match="packed, but damaged"):
        read(tmp_path, b"\0\0\0\1x\x9c" + b"nonsense")


def test_what_unpacks_without_end_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(silhouette_project, "MAX_BYTES", 1 << 20)
    with pytest.raises(RoamError, match="unpacks to more than 1 MiB"):
        read(tmp_path, packed(b"<a>" + b" " * (64 << 20) + b"</a>"))


def test_a_project_without_shapes_holds_none(tmp_path: Path) -> None:
    assert list(read(tmp_path, project_xml()).layer.shapes()) == []
