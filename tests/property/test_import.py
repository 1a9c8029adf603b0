"""Random projects written and read back: points, motion between keys, mattes, and everything beside the points."""

from __future__ import annotations

import tempfile
from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from hypothesis import Phase, assume, given, settings
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from roam_core.interchange import EXPORTERS, ExportOptions, Imported, read_shapes
from roam_core.interchange.literals import whole
from roam_core.interchange.protocol import STANDARD, without_smooth_keys
from roam_core.interchange.xml import xml_text
from roam_core.matte import render_matte
from roam_core.roto import (
    BlendMode,
    Clip,
    Interpolation,
    Keyframe,
    Layer,
    MotionBlur,
    Project,
    RotoShape,
    Spline,
    control_points,
)
from roam_core.roto.value_curves import bounded
from tests.property.strategies import animatables

WITHIN = 0.01
SIZE = (96, 64)

short = st.text(max_size=12) | st.text('{}[]\\"$; \n#\0<&', max_size=12)
names = short | st.builds(lambda name, times: (name or "x") * times, short, st.integers(1, 1000))
flags = st.booleans()
fractions = st.floats(0.0, 1.0, width=32)


@st.composite
def keyframes(draw: st.DrawFn, count: int, frame: int) -> Keyframe:
    points = arrays(np.float64, (count, 3, 2), elements=st.floats(-30.0, 130.0))
    offsets = st.none() | arrays(np.float64, (count, 3, 2), elements=st.floats(-9.0, 9.0))
    return Keyframe(frame, draw(points), draw(offsets), interpolation=draw(st.sampled_from(Interpolation)))


@st.composite
def shapes(draw: st.DrawFn) -> RotoShape:
    count = draw(st.integers(2, 4))
    frames = draw(st.lists(st.integers(-9, 60), min_size=1, max_size=4, unique=True))
    start = draw(st.integers(-5, 40))
    blurs = st.builds(MotionBlur, st.floats(0.125, 2.0, width=32), st.floats(-1.0, 1.0, width=32), st.integers(1, 64))
    shape = RotoShape(
        id=f"shape-{draw(st.uuids())}",
        name=draw(names),
        keys=tuple(draw(keyframes(count, frame)) for frame in frames),
        closed=draw(flags),
        colour=draw(st.tuples(fractions, fractions, fractions)),
        blend=draw(st.sampled_from(BlendMode)),
        opacity=draw(fractions),
        invert=draw(flags),
        feather=draw(st.floats(0.0, 20.0, width=32)),
        motion_blur=draw(st.none() | blurs),
        lifetime=draw(st.none() | st.just((start, start + draw(st.integers(1, 30))))),
        visible=draw(flags),
        locked=draw(flags),
    )
    return control_points.with_spline(shape, draw(st.sampled_from(Spline)))


@st.composite
def layers(draw: st.DrawFn, depth: int, item_id: str = "root") -> Layer:
    children: list[Layer | RotoShape] = list(draw(st.lists(shapes(), max_size=2)))
    if depth:
        children.insert(0, draw(layers(depth - 1, f"layer-{depth}")))
    values = {"visible": flags, "locked": flags, "invert": flags, "opacity": fractions}
    return Layer(item_id, draw(short), tuple(children), **draw(st.fixed_dictionaries(values)))


projects = st.builds(
    lambda first, root: Project(Clip(Path("plate"), first, first + 50, SIZE), root), st.integers(-3, 9), layers(2)
)


def in_time(layer: Layer, draw: st.DrawFn) -> Layer:
    """The layer and all in it with modes of layers, and values that vary with time."""
    opacities = animatables(fractions, extra=False).map(lambda value: bounded(value, "opacity"))
    widths = animatables(st.floats(-20.0, 20.0, width=32), extra=False)
    children = (
        in_time(child, draw)
        if isinstance(child, Layer)
        else replace(child, opacity=draw(opacities), feather=draw(widths))
        for child in layer.children
    )
    blend = layer.blend if layer.id == "root" else draw(st.sampled_from(BlendMode))
    return replace(layer, children=tuple(children), opacity=draw(opacities), blend=blend)


def returned(project: Project, name: str, options: ExportOptions = STANDARD) -> Imported:
    """What the format's reader makes of what its writer wrote."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / f"file{EXPORTERS[name].suffix}"
        EXPORTERS[name].export(project, path, options)
        return read_shapes(path, project.require_clip())


def root_of(imported: Imported) -> Layer:
    """The project's root again: a layer of its own where it says something, otherwise what lies in the file."""
    children = imported.layer.children
    return children[0] if len(children) == 1 and isinstance(children[0], Layer) else imported.layer


def held(blend: BlendMode) -> BlendMode:
    """Neither Nuke nor Silhouette tells the clamped sum from the union."""
    return BlendMode.ADD if blend is BlendMode.PLUS else blend


def check_motion(ours: RotoShape, theirs: RotoShape, *, feather: bool) -> None:
    assert set(ours.frames) <= set(theirs.frames)
    middles = [(a + b) // 2 for a, b in pairwise(ours.frames)]
    for frame in (*ours.frames, *middles):
        expected, found = ours.at(frame), theirs.at(frame)
        np.testing.assert_allclose(found.points, expected.points, atol=WITHIN)
        if feather:
            offsets = [0.0 if each.feather is None else each.feather for each in (expected, found)]
            np.testing.assert_allclose(offsets[1], offsets[0], atol=2 * WITHIN)
    for frame in middles[:1]:
        check_mattes(ours, theirs, frame)


def check_mattes(ours: RotoShape, theirs: RotoShape, frame: int) -> None:
    """The mattes without feather agree: their intersection over union, but for a few hundredths of a pixel."""
    bare = [
        RotoShape("a", "a", tuple(Keyframe(k.frame, k.points, interpolation=k.interpolation) for k in each.keys))
        for each in (ours, theirs)
        if each.closed
    ]
    if not bare:
        return
    expected, found = (render_matte([shape], frame, SIZE[::-1]) for shape in bare)
    union = float(np.maximum(expected, found).sum())
    assert union < 4.0 or float(np.minimum(expected, found).sum()) >= 0.999 * union - 0.05


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(projects)
def test_nuke_gives_everything_back(project: Project) -> None:
    root = root_of(returned(project, "nuke"))
    items, expected = list(root.items()), list(project.root.items())
    assert [item.name for item in items] == [item.name for item in expected]
    for item, was in zip([root, *items], [project.root, *expected], strict=True):
        assert (item.visible, item.locked, item.invert, item.opacity) == (
            was.visible, was.locked, was.invert, was.opacity,
        )  # fmt: skip
        if isinstance(was, RotoShape):
            assert isinstance(item, RotoShape)
            assert item.blend in (was.blend, held(was.blend))
            assert (item.closed, item.colour) == (was.closed, was.colour)
            assert (item.feather, item.lifetime, item.motion_blur) == (was.feather, was.lifetime, was.motion_blur)
            check_motion(was, item, feather=True)


def _untimed(shape: RotoShape) -> RotoShape:
    """An intersecting shape of a lifetime comes back as one that subtracts its inverse; a second takes the rest."""
    is_timed = shape.blend is BlendMode.INTERSECT and shape.lifetime is not None and shape.visible and shape.closed
    return replace(shape, blend=BlendMode.SUBTRACT, invert=not shape.invert) if is_timed else shape


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(projects)
def test_silhouette_gives_back_what_it_holds(project: Project) -> None:
    imported = returned(project, "silhouette", ExportOptions(lossy=True))
    found = [shape for shape in imported.layer.shapes() if not shape.name.endswith(" rest")]
    expected = [_untimed(shape) for shape in project.shapes]
    assert [shape.name for shape in found] == [xml_text(shape.name) for shape in expected]
    for shape, was in zip(found, expected, strict=True):
        assert (shape.visible, shape.locked, shape.invert) == (was.visible, was.locked, was.invert)
        assert (shape.closed, shape.blend, shape.spline) == (was.closed, held(was.blend), was.spline)
        np.testing.assert_allclose(shape.colour, was.colour, atol=1e-6)
        assert (shape.motion_blur is None) == (was.motion_blur is None)
        assert shape.lifetime == was.lifetime
        check_motion(was, shape, feather=False)


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(projects, st.data())
def test_json_gives_everything_back(project: Project, data: st.DataObject) -> None:
    project = replace(project, root=in_time(project.root, data.draw))
    root = root_of(returned(project, "json"))
    for item, was in zip([root, *root.items()], [project.root, *project.root.items()], strict=True):
        assert item.name == was.name or item.name == "file"
        assert (item.visible, item.locked, item.invert, item.opacity, item.blend) == (
            was.visible, was.locked, was.invert, was.opacity, was.blend,
        )  # fmt: skip
        if isinstance(was, RotoShape):
            assert isinstance(item, RotoShape)
            assert item == replace(was, id=item.id, keys=item.keys)
            check_motion(was, item, feather=True)


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(projects, st.integers(-3, 59), st.data())
def test_svg_gives_back_what_a_still_picture_holds(project: Project, frame: int, data: st.DataObject) -> None:
    clip = project.require_clip()
    frame = min(max(frame, clip.first), clip.last)
    project = replace(project, root=in_time(project.root, data.draw))
    root = root_of(returned(project, "svg", ExportOptions(frame=frame)))
    assume(is_there(project.root, frame))
    there = [item for item in project.root.items() if is_there(item, frame)]
    for item, was in zip([root, *root.items()], [project.root, *there], strict=True):
        assert item.name == xml_text(was.name) or item.name == "file"
        assert (item.visible, item.locked, item.invert) == (was.visible, was.locked, was.invert)
        assert item.opacity == pytest.approx(was.opacity_at(frame), abs=1e-5)
        assert item.blend is was.blend
        if isinstance(was, RotoShape):
            assert isinstance(item, RotoShape)
            check_outline(item, was, frame)


def is_there(item: Layer | RotoShape, frame: int) -> bool:
    """True for a shape that exists on the frame, and a layer with one in it: a drawing needs no empty groups.

    But for one that is inverted, or intersects: with nothing in it, it takes part.
    """
    if isinstance(item, RotoShape):
        return item.exists_at(frame)
    acts = item.invert or item.blend is BlendMode.INTERSECT
    return acts or any(is_there(each, frame) for each in item.children)


def check_outline(found: RotoShape, was: RotoShape, frame: int) -> None:
    """The only key of what a still picture gave is the shape as it was on the frame."""
    (key,), outline = found.keys, was.at(frame)
    assert (found.closed, found.spline) == (was.closed, was.spline)
    np.testing.assert_allclose(found.colour, was.colour, atol=1 / 255)
    assert found.feather == pytest.approx(was.feather_at(frame), abs=1e-5)
    np.testing.assert_allclose(key.points, outline.points, atol=WITHIN)
    curves = [np.zeros_like(outline.points) if curve is None else curve for curve in (key.feather, outline.feather)]
    np.testing.assert_allclose(*curves, atol=2 * WITHIN)


def without_feather_curves(layer: Layer) -> Layer:
    """Nor with smooth keys, but with straight ones on every frame: between these, motion blur sees the difference."""
    children = (
        without_feather_curves(child)
        if isinstance(child, Layer)
        else without_smooth_keys(replace(child, keys=tuple(replace(key, feather=None) for key in child.keys)))
        for child in layer.children
    )
    return replace(layer, children=tuple(children))


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(projects)
def test_fusion_gives_the_matte_back(project: Project) -> None:
    """What other tools stand for comes back as layers; the feather curve does not."""
    imported = returned(project, "fusion", ExportOptions(lossy=True))
    keyless = without_feather_curves(project.root)
    for frame in (*project.require_clip().frame_range[::17], *{f for s in project.shapes for f in s.frames}):
        ours, theirs = (render_matte(layer, frame, SIZE[::-1]) for layer in (keyless, imported.layer))
        np.testing.assert_allclose(theirs, ours, atol=2e-3)
    assert {whole(shape.name) for shape in project.shapes} <= {shape.name for shape in imported.layer.shapes()}


@settings(deadline=None, max_examples=25, phases=[Phase.explicit, Phase.reuse, Phase.generate])
@given(st.lists(shapes(), min_size=1, max_size=4))
def test_fusion_gives_opaque_shapes_back_as_they_are(listed: list[RotoShape]) -> None:
    plain = [
        replace(shape, opacity=1.0, lifetime=None, feather=0.0, motion_blur=None, blend=BlendMode.ADD)
        for shape in listed
    ]
    project = Project(Clip(Path("plate"), -9, 60, SIZE), Layer("root", "Root", tuple(plain)))
    found = list(returned(project, "fusion", ExportOptions(lossy=True)).layer.children)
    assert len(found) == len(plain)
    for was, item in zip(plain, found, strict=True):
        assert isinstance(item, RotoShape)
        assert (item.name, item.closed, item.invert) == (whole(was.name), was.closed, was.invert)
        assert (item.visible, item.locked, item.blend) == (was.visible, was.locked, was.blend)
        np.testing.assert_allclose(item.colour, was.colour, atol=0.5 / 255)
        check_motion(was, item, feather=False)
