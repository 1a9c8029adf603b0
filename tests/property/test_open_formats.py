"""Random projects through SVG and plain JSON and back: places, motion and mattes stay what they were."""

from __future__ import annotations

import tempfile
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.interchange import EXPORTERS, ExportOptions, Imported, read_shapes
from roam_core.matte import render_matte
from roam_core.roto import Layer, Project
from tests.property.test_interchange import projects

WITHIN = 0.01


def back(project: Project, name: str, options: ExportOptions) -> Imported:
    """The project written and read again."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"p{EXPORTERS[name].suffix}"
        EXPORTERS[name].export(project, path, options)
        return read_shapes(path, project.require_clip())


@settings(deadline=None, max_examples=40)
@given(projects(), st.floats(0.0, 1.0))
def test_json_keeps_every_point_at_every_time(project: Project, u: float) -> None:
    made = back(project, "json", ExportOptions()).layer
    for shape, read in zip(project.shapes, made.shapes(), strict=True):
        assert read.name == shape.name
        for frame in (*shape.frames, shape.frames[0] + u * (shape.frames[-1] - shape.frames[0])):
            np.testing.assert_allclose(read.at(frame).points, shape.at(frame).points, atol=1e-9)


@settings(deadline=None, max_examples=40)
@given(projects(), st.integers(1, 100))
def test_svg_keeps_every_point_of_a_frame(project: Project, frame: int) -> None:
    made = back(project, "svg", ExportOptions(frame=frame)).layer
    shapes = [shape for shape in project.shapes if shape.exists_at(frame)]
    # A path without a single line is no outline.
    shapes = [shape for shape in shapes if shape.closed or shape.point_count > 1]
    for shape, read in zip(shapes, made.shapes(), strict=True):
        assert read.closed is shape.closed
        np.testing.assert_allclose(read.keys[0].points, shape.at(frame).points, atol=WITHIN)


@settings(deadline=None, max_examples=25)
@given(projects(), st.integers(1, 40))
def test_mattes_are_the_same(project: Project, frame: int) -> None:
    size = (96, 128)
    for name in ("json", "svg"):
        made: Layer = back(project, name, ExportOptions(frame=frame)).layer
        ours, theirs = (render_matte(layer, frame, size) for layer in (project.root, made))
        np.testing.assert_allclose(theirs, ours, atol=1e-3)
