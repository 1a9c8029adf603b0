"""Random projects through each exporter and back by its judge: every point within a hundredth of a pixel."""

from __future__ import annotations

from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roam_core.interchange.nuke.names import Names
from roam_core.interchange.nuke.text import tcl_word
from roam_core.interchange.protocol import ExportOptions
from roam_core.interchange.silhouette.exporter import silhouette_document
from roam_core.interchange.xml import xml_text
from roam_core.roto import BlendMode, Clip, Interpolation, Keyframe, Layer, Project, RotoShape
from tests.judges import nuke_grammar
from tests.unit.interchange import nuke_judge, silhouette_judge, tcl
from tests.unit.interchange.conftest import roto_script

WITHIN = 0.01

names = st.text(max_size=12) | st.text('{}[]\\"$; \n#\0<&', max_size=12)
coordinates = st.floats(-5000.0, 5000.0)


@st.composite
def shapes(draw: st.DrawFn) -> RotoShape:
    count = draw(st.integers(2, 4))
    frames = draw(st.lists(st.integers(-50, 1200), min_size=1, max_size=4, unique=True))
    points = arrays(np.float64, (count, 3, 2), elements=coordinates)
    keys = (Keyframe(f, draw(points), interpolation=draw(st.sampled_from(Interpolation))) for f in frames)
    return RotoShape(
        id=f"shape-{draw(st.uuids())}",
        name=draw(names),
        keys=tuple(keys),
        closed=draw(st.booleans()),
        blend=draw(st.sampled_from(BlendMode)),
        opacity=draw(st.floats(0.0, 1.0)),
        visible=draw(st.booleans()),
        locked=draw(st.booleans()),
    )


@st.composite
def projects(draw: st.DrawFn) -> Project:
    size = draw(st.tuples(st.integers(16, 4096), st.integers(16, 4096)))
    inner = Layer("layer-1", draw(names), tuple(draw(st.lists(shapes(), max_size=2))))
    children = (*draw(st.lists(shapes(), max_size=1)), inner, *draw(st.lists(shapes(), max_size=1)))
    return Project(Clip(Path("plate"), 1, 100, size), Layer("root", "Root", children))


@settings(deadline=None, max_examples=60)
@given(projects())
def test_nuke_keeps_every_point_on_every_key(project: Project) -> None:
    script = roto_script(project)
    names = [shape.name for shape in nuke_judge.judged_shapes(script)]
    assert sorted(names) == sorted(shape.name for shape in nuke_grammar.shapes(script))
    for shape, written in zip(project.shapes, nuke_judge.judged_shapes(script), strict=True):
        assert written.name == Names.of(project.root).by_id[shape.id]
        assert bool(written.curve_flags & 32) is not shape.closed
        for key in shape.keys:
            np.testing.assert_allclose(written.points(key.frame), key.points, atol=WITHIN)


@settings(deadline=None, max_examples=60)
@given(projects(), st.floats(0.0, 1.0))
def test_nuke_moves_as_the_shape_does_between_linear_and_smooth_keys(project: Project, u: float) -> None:
    for shape, written in zip(project.shapes, nuke_judge.judged_shapes(roto_script(project)), strict=True):
        for before, after in zip(shape.keys, shape.keys[1:], strict=False):
            frame = before.frame + u * (after.frame - before.frame)
            if before.interpolation is Interpolation.HOLD and 0 < after.frame - frame < 1 / 512:
                continue  # in this time Nuke steps
            np.testing.assert_allclose(written.points(frame), shape.at(frame).points, atol=WITHIN)


@settings(deadline=None, max_examples=60)
@given(projects())
def test_silhouette_keeps_every_point_on_every_key(project: Project) -> None:
    text, _ = silhouette_document(project, ExportOptions(lossy=True))  # sums are refused else
    read = silhouette_judge.judge(text)[1].shapes()
    for shape, written in zip(project.shapes, read, strict=True):
        assert written.label == xml_text(shape.name)
        assert written.closed == {str(shape.closed)}
        for key in shape.keys:
            np.testing.assert_allclose(written.keys[key.frame - 1], key.points, atol=WITHIN)


@given(names)
def test_any_name_is_one_inert_tcl_word(name: str) -> None:
    interpreter = tcl.available()
    assert interpreter.split(tcl_word(name)) == [name]
    assert interpreter.split(interpreter.node_body(f"Roto {{{tcl_word(name)} end}}")) == [name, "end"]
