"""Random projects through SVG and plain JSON and back: places, motion and mattes stay what they were."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from pathlib import Path

import numpy as np
from hypothesis import given, settings
from hypothesis import strategies as st

from roam_core.interchange import EXPORTERS, ExportOptions, Imported, read_shapes
from roam_core.interchange.labels.polygons import Flattener
from roam_core.interchange.protocol import without_smooth_keys
from roam_core.interchange.timing import without_holds
from roam_core.matte import render_matte
from roam_core.roto import Clip, Layer, Project, RotoShape
from tests.property.strategies import bspline_shapes
from tests.property.test_interchange import projects, shapes

WITHIN = 0.01
CLIP = Clip(Path("plate"), 1, 100, (640, 480))


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


@settings(deadline=None, max_examples=40)
@given(bspline_shapes())
def test_json_keeps_b_splines_bit_by_bit(shape: RotoShape) -> None:
    project = Project(CLIP, Layer("root", "Root", (shape,)))
    (read,) = back(project, "json", ExportOptions()).layer.shapes()
    assert read.spline is shape.spline
    for key, mine in zip(read.keys, shape.keys, strict=True):
        np.testing.assert_array_equal(key.points, mine.points)


@settings(deadline=None, max_examples=40)
@given(shapes(), st.sampled_from(["mlt", "cvat"]))
def test_labels_and_splines_move_as_the_shape_does(shape: RotoShape, name: str) -> None:
    """On every frame of the clip: CVAT's polygon lies within its tolerance, at the same parameters."""
    shape = replace(shape, closed=True)
    if shape.point_count < 3:
        return
    project = Project(CLIP, Layer("root", "Root", (shape,)))
    (read,) = back(project, name, ExportOptions(lossy=True)).layer.shapes()
    for frame in CLIP.frame_range[::7]:
        theirs, ours = read.at(frame).points, shape.at(frame).points
        if name == "cvat":
            ours = Flattener(moving(shape)).places(ours)
            theirs = theirs[:, 0]
        np.testing.assert_allclose(theirs, ours, atol=WITHIN)


def moving(shape: RotoShape) -> RotoShape:
    """The shape with the keys that CVAT is given, of which the most curved decides on the points."""
    return without_holds(without_smooth_keys(shape))
