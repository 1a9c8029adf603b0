"""Text for the clipboard and text from it: what it is told by, what comes back, what is refused."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.interchange import EXPORTERS, IMPORTERS, ImportOptions
from roam_core.interchange.clipboard import format_of, node_text, read_text
from roam_core.interchange.recognition import SIGNS
from roam_core.roto import Clip, Layer, Project, edit

CLIP = Clip(Path("/plates/shot"), 1001, 1010, (64, 48))
SQUARE = polygon_points([(10, 10), (30, 10), (30, 30), (10, 30)])
READ = [importer.name for importer in IMPORTERS if importer.name in SIGNS]
COPIED_IN_NUKE = "set cut_paste_input [stack 0]\nversion 13.0 v1\npush $cut_paste_input\n"


@pytest.fixture
def project() -> Project:
    """A square that moves, in a layer, and one of another name."""
    project, layer = edit.add_layer(Project(CLIP), name="Body")
    project, shape = edit.new_shape(project, SQUARE, 1001, name="Arm {1}", layer_id=layer.id)
    project = project.with_shape(edit.set_key(shape, 1005, SQUARE + 8.0))
    return edit.new_shape(project, SQUARE + 4.0, 1001, name="Leg")[0]


@pytest.mark.parametrize("name", READ)
def test_what_we_write_is_known_by_its_text_and_comes_back(project: Project, name: str) -> None:
    text, _ = node_text(name, project)
    for whole in (text, f"\ufeff{text}"):
        importer = format_of(whole)
        assert importer is not None
        assert importer.name == name
    shapes = list(read_text(text, CLIP).layer.shapes())
    assert [shape.name for shape in shapes] == ["Arm {1}", "Leg"]
    np.testing.assert_allclose(shapes[0].at(1001).points, SQUARE, atol=1e-4)
    np.testing.assert_allclose(shapes[1].at(1001).points, SQUARE + 4.0, atol=1e-4)


@pytest.mark.parametrize("begun", [COPIED_IN_NUKE, "\ufeff", "\n\n  ", "# a comment\n"])
def test_a_node_that_nuke_copied_is_known(project: Project, begun: str) -> None:
    text = begun + node_text("nuke", project)[0].split("\n", 1)[1]
    importer = format_of(text)
    assert importer is not None
    assert importer.name == "nuke"
    assert sum(1 for _ in read_text(text, CLIP, ImportOptions(frame_offset=1)).layer.shapes()) == 2


@pytest.mark.parametrize(
    "text",
    ["", "no shape", "{}", "[1]", '{"type": "roam.Project"}', "<html><svg/></html>", "curvescape", "Rotor {", "\0" * 9],
)
def test_other_text_is_none_of_them(text: str) -> None:
    assert format_of(text) is None
    with pytest.raises(RoamError, match=r"^The clipboard holds no shapes of a kind that ROAM reads\.$"):
        read_text(text, CLIP)


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("set cut_paste_input [stack 0]\nBlur {\n size 3\n}\n", r"^The clipboard holds no Roto or RotoPaint node\.$"),
        ('{"format": "roam-shapes"', r"^The clipboard is no valid JSON"),
        ("<svg", None),
        ("<svg ><path", r"^The clipboard is no valid XML"),
        ("curves {" + "{" * 5000, "^The clipboard"),
        ("<svg >" + " " * (17 << 20), r"^The clipboard holds more than 16 MiB; copy fewer shapes at once\.$"),
    ],
)
def test_damaged_text_is_refused_in_a_sentence(text: str, sentence: str | None) -> None:
    if sentence is None:
        assert format_of(text) is None
        return
    with pytest.raises(RoamError, match=sentence):
        read_text(text, CLIP)


def test_nodes_for_another_program_hold_what_is_asked_for_alone(project: Project) -> None:
    leg = next(shape for shape in project.shapes if shape.name == "Leg")
    text, _ = node_text("fusion", Project(CLIP, Layer("root", "Root", (leg,))))
    assert "Leg = " in text
    assert "Arm" not in text
    assert set(SIGNS) <= set(EXPORTERS)
