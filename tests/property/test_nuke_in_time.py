"""What varies with time and the modes of layers, through Nuke and Silhouette and back."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.interchange import ExportOptions
from roam_core.interchange.nuke.exporter import roto_document
from roam_core.interchange.xml import xml_text
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape
from roam_core.roto.animated import Animatable, frames_of, value_at
from tests.judges import nuke_grammar, nuke_render
from tests.judges.scenes import ellipse
from tests.property.test_import import held, in_time, projects, returned, root_of


@st.composite
def projects_in_time(draw: st.DrawFn) -> Project:
    project = draw(projects)
    return Project(project.clip, in_time(project.root, draw))


def check_value(found: Animatable, was: Animatable, *, scale: float = 1.0) -> None:
    """The same on every whole frame, and every key of ours is one."""
    frames = frames_of(was)
    moments = range(frames[0] - 1, min(frames[-1] + 2, frames[0] + 500)) if frames else [0]
    expected, read = ([value_at(value, frame) for frame in moments] for value in (was, found))
    np.testing.assert_allclose(read, expected, atol=1e-4 * scale)
    if len({key.value for key in getattr(was, "keys", ())}) > 1:
        assert set(frames) <= set(frames_of(found))


@settings(deadline=None, max_examples=12)
@given(projects_in_time())
def test_nuke_gives_back_what_varies_with_time(project: Project) -> None:
    root = root_of(returned(project, "nuke"))
    items, expected = list(root.items()), list(project.root.items())
    assert [item.name for item in items] == [item.name for item in expected]
    for item, was in zip([root, *items], [project.root, *expected], strict=True):
        assert item.blend in (was.blend, held(was.blend))
        assert (item.visible, item.invert) == (was.visible, was.invert)
        check_value(item.opacity, was.opacity)
        if isinstance(was, RotoShape):
            assert isinstance(item, RotoShape)
            check_value(item.feather, was.feather, scale=20.0)


@settings(deadline=None, max_examples=12)
@given(projects_in_time())
def test_silhouette_gives_back_what_varies_with_time(project: Project) -> None:
    """Opacities of shapes as far as no layer dims them: what a layer leaves of them is told.

    An intersecting shape of a lifetime comes as shapes that subtract; the second takes the rest of its opacity.
    """
    imported = returned(project, "silhouette", ExportOptions(lossy=True))
    found = [item for item in imported.layer.shapes() if not item.name.endswith(" rest")]
    for item, was in zip(found, project.shapes, strict=True):
        assert item.name == xml_text(was.name)
        if all(layer.opacity == 1.0 for layer in project.layers_above(was.id)) and was.lifetime is None:
            check_value(item.opacity, was.opacity)


@st.composite
def ellipses(draw: st.DrawFn) -> RotoShape:
    """A still, sharp shape that does not cross itself."""
    centre, axes = (draw(st.tuples(st.floats(low, high), st.floats(low, high))) for low, high in ((10, 60), (8, 30)))
    return RotoShape(
        f"shape-{draw(st.uuids())}",
        "Ellipse",
        (Keyframe(1, ellipse(*centre, *axes)),),
        blend=draw(st.sampled_from(BlendMode)),
        opacity=draw(st.sampled_from([1.0, 1.0, 0.5])),
        invert=draw(st.booleans()),
        visible=draw(st.sampled_from([True, True, False])),
    )


@st.composite
def trees(draw: st.DrawFn, depth: int = 2) -> Layer:
    """Layers in layers, with modes of their own."""
    inner = ellipses() if depth == 0 else ellipses() | trees(depth - 1)
    return Layer(
        f"layer-{draw(st.uuids())}",
        "Layer",
        tuple(draw(st.lists(inner, max_size=3))),
        visible=draw(st.sampled_from([True, True, False])),
        opacity=draw(st.sampled_from([1.0, 1.0, 0.5])),
        invert=draw(st.sampled_from([False, False, True])),
        blend=draw(st.sampled_from(BlendMode)),
    )


@settings(deadline=None, max_examples=25)
@given(trees())
def test_the_judge_renders_any_tree_of_layers_as_we_do(root: Layer) -> None:
    """But for pixels on edges where a sum became a union, which is told."""
    project = Project(Clip(Path("plate"), 1, 10, (80, 70)), replace(root, id="root"))
    text, notes = roto_document(project)
    assert len(nuke_grammar.shapes(text)) == len(project.shapes)
    apart = np.abs(render_matte(project, 1, (70, 80)) - nuke_render.matte(text, 1, (70, 80)))
    if any("unites where ROAM adds" in note for note in notes):
        assert (apart > 0.04).mean() < 0.05
    else:
        assert apart.max() < 0.06
