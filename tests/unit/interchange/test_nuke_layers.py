"""Mattes of what is written for Nuke, rendered by a judge that knows the vendor's grammar and nothing of the writer."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, read_shapes
from roam_core.interchange.nuke.exporter import roto_document
from roam_core.interchange.nuke.graph import is_one_node
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Layer, Project, RotoShape
from tests.judges import nuke_grammar
from tests.judges.nuke_render import matte
from tests.judges.scenes import SCENES, Scene, blob
from tests.unit.interchange.conftest import roto_script

SUB, OVER, PLUS = BlendMode.SUBTRACT, BlendMode.ADD, BlendMode.PLUS


def agreement(project: Project, text: str, frame: float) -> float:
    """Intersection over union of ROAM's matte and the judge's."""
    width, height = project.require_clip().size
    ours, theirs = render_matte(project, frame, (height, width)), matte(text, frame, (height, width))
    return float(np.minimum(ours, theirs).sum() / np.maximum(ours, theirs).sum())


@pytest.mark.parametrize("name", sorted(SCENES))
def test_the_matte_is_ours(name: str) -> None:
    scene: Scene = SCENES[name]
    text = roto_script(scene.project)
    for frame in scene.moments[1:3]:
        assert agreement(scene.project, text, frame) >= 0.999


@pytest.mark.parametrize("name", sorted(SCENES))
def test_what_comes_back_renders_the_same(name: str, tmp_path: Path) -> None:
    scene = SCENES[name]
    clip, target = scene.project.require_clip(), tmp_path / "a.nk"
    EXPORTERS["nuke"].export(scene.project, target)
    imported = read_shapes(target, clip)
    again = Project(clip, Layer("root", "Root", imported.layer.children))
    assert [item.name for item in again.root.shapes()] == [item.name for item in scene.project.root.shapes()]
    for frame in scene.moments:
        ours, theirs = (render_matte(each, frame, clip.size[::-1]) for each in (scene.project, again))
        assert float(np.minimum(ours, theirs).sum()) >= 0.999 * float(np.maximum(ours, theirs).sum())


def project_of(*items: Layer | RotoShape) -> Project:
    return replace(SCENES["curves"].project, root=Layer("root", "Root", items))


def named(name: str, **fields: object) -> RotoShape:
    """Shapes of different names lie in different places."""
    return replace(blob(name, 100.0 + 37.0 * (sum(name.encode()) % 5), 120.0), id=name, **fields)  # type: ignore[arg-type]


def layer_of(*items: Layer | RotoShape, **fields: object) -> Layer:
    return replace(Layer("in", "In", items), **fields)  # type: ignore[arg-type]


A, B, CUT = named("A"), named("B"), named("Cut", blend=SUB)
FAINT = named("Faint", opacity=0.5)


@pytest.mark.parametrize(
    ("items", "is_one"),
    [
        ((A, layer_of(B)), True),
        ((A, layer_of(B, layer_of(named("C")))), True),
        ((layer_of(A, CUT), B), True),  # nothing lies under it
        ((A, layer_of(B, CUT)), False),
        ((A, layer_of(layer_of(B, CUT))), False),
        ((A, layer_of(B, CUT, visible=False)), True),
        ((A, layer_of(B, invert=True)), False),
        ((layer_of(B, invert=True),), False),
        ((layer_of(B, opacity=0.5),), False),
        ((layer_of(opacity=0.5),), True),  # empty
        ((A, layer_of(B, blend=SUB)), False),
        ((A, layer_of(B, blend=PLUS)), True),  # sharp: a sum is a union
        ((FAINT, layer_of(named("Half", opacity=0.5), blend=PLUS)), False),
        ((FAINT, named("Half", opacity=0.5, blend=PLUS)), False),
        ((FAINT, named("Whole", blend=PLUS)), True),
        ((A, CUT, FAINT), True),
    ],
)
def test_a_node_of_its_own_is_made_where_it_is_needed(items: tuple[Layer | RotoShape, ...], is_one: bool) -> None:
    project = project_of(*items)
    assert is_one_node(project.root) is is_one
    text, notes = roto_document(project)
    rotos = [node for node in nuke_grammar.nodes(text) if node.species == "Roto"]
    assert (len(nuke_grammar.nodes(text)) == 1) is is_one
    assert any("nodes of their own" in note for note in notes) is not is_one
    assert len(rotos) >= 1
    if any(item.visible and not isinstance(item, Layer) for item in items):
        is_told = any("unites where ROAM adds" in note for note in notes)
        assert agreement(project, text, 1004) >= (0.998 if is_told else 0.999)


@pytest.mark.parametrize("fields", [{"invert": True}, {"invert": True, "opacity": 0.5}, {"blend": BlendMode.INTERSECT}])
@pytest.mark.parametrize("children", [(), (named("B", visible=False),)])
def test_a_layer_that_takes_part_with_nothing_in_it_has_a_node(
    children: tuple[RotoShape, ...], fields: dict[str, Any]
) -> None:
    project = project_of(named("A"), Layer("l", "Empty", children, **fields))
    width, height = project.require_clip().size
    theirs = matte(roto_script(project), 1004, (height, width))
    np.testing.assert_allclose(theirs, render_matte(project, 1004, (height, width)), atol=0.02)


def test_sums_that_become_unions_are_told() -> None:
    _, notes = roto_document(project_of(A, named("B", blend=PLUS)))
    assert notes == ("Nuke unites where ROAM adds 'B': pixels that two edges share are darker there.",)


def test_nodes_are_numbered_as_they_stand_side_by_side() -> None:
    text, _ = roto_document(project_of(A, layer_of(B, invert=True), layer_of(FAINT, invert=True)))
    rotos = [node for node in nuke_grammar.nodes(text) if node.species == "Roto"]
    assert len(rotos) == 3
    assert [text.count(f" name Roto{number}\n") for number in (1, 2, 3)] == [1, 1, 1]
    places = [int(place) for place in re.findall(r" xpos (-?\d+)", text)]
    assert len(set(places)) >= 3


def test_names_and_locks_of_layers_come_back(tmp_path: Path) -> None:
    inner = layer_of(B, CUT, name="[Größe] {1}", locked=True, invert=True, opacity=0.25, blend=BlendMode.MAX)
    project = project_of(A, inner)
    EXPORTERS["nuke"].export(project, tmp_path / "a.nk")
    found = read_shapes(tmp_path / "a.nk", project.require_clip()).layer.children[1]
    assert isinstance(found, Layer)
    assert [child.name for child in found.children] == ["B", "Cut"]
    fields = ("name", "locked", "invert", "opacity", "blend", "visible")
    assert [getattr(found, field) for field in fields] == [getattr(inner, field) for field in fields]


def test_rotos_of_an_artist_that_nothing_joins_stay_layers_of_their_own(tmp_path: Path) -> None:
    script = roto_script(project_of(A)) + roto_script(project_of(B)).partition("\n")[2]
    (tmp_path / "a.nk").write_text(script)
    found = read_shapes(tmp_path / "a.nk", project_of().require_clip()).layer
    assert [[shape.name for shape in layer.shapes()] for layer in found.children] == [["B"], ["A"]]
