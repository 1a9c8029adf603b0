"""The script for Natron, run against objects that remember: layers, operators, feather, lifetimes, what it lost."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
import pytest

from roam_core.interchange.natron import natron_script
from roam_core.matte import render_matte
from roam_core.roto import Animated, BlendMode, Interpolation, Layer, Project, RotoShape, ValueKey
from tests.judges import natron
from tests.judges.coverage import overlap
from tests.judges.scenes import FIRST, LAST, SIZE, _project, blob
from tests.unit.interchange.conftest import CLIP, animated
from tests.unit.interchange.natron_judge import judge


def test_layers_are_nested_as_in_the_project_the_topmost_first(project: Project) -> None:
    base = judge(natron_script(project)[0], 1080)[1]
    assert [item.label for item in base.children] == ["Smooth", "Open", "Body", "Still"]
    body = base.children[2]
    assert [item.label for item in body.children] == ["Soft", "Deep", "Arm"]
    assert (body.visible, body.locked, body.children[1].locked) == (False, False, True)
    items = [*base.children, *body.children, *body.children[1].children]
    assert len({item.script_name for item in items}) == len(items) == 8


def test_the_properties_of_a_shape(project: Project) -> None:
    masks, _ = judge(natron_script(project)[0], 1080)
    soft = next(mask for mask in masks if mask.name == "Soft")
    item = soft.values["item"]
    assert (item.operator, item.params["inverted"].value, item.opacity.value) == ("Stencil", True, 0.25)
    assert item.distance.value == 12.5
    assert item.activated == {1004: False, 1005: True, 1015: False}
    assert item.params["lifeTime"].value == 4
    blur = [item.params[f"motionBlur{name}"].value for name in ("", "Shutter", "ShutterOffset", "CustomShutterOffset")]
    assert blur == [32, 0.75, 3, -0.375]
    still = next(mask for mask in masks if mask.name == "Still").values["item"]
    assert (still.overlay, still.locked, still.distance.value) == ((0.25, 0.5, 0.75), True, 0.0)


def test_feather_points_are_those_of_the_feather_curve(project: Project) -> None:
    masks, _ = judge(natron_script(project)[0], 1080)
    for shape, mask in zip(project.shapes, masks, strict=True):
        for key in shape.keys:
            curve = key.points if key.feather is None else key.points + key.feather
            np.testing.assert_allclose(mask.values["feather"][key.frame], curve, atol=1e-4)


def test_operators_are_those_of_the_modes() -> None:
    modes = sorted(BlendMode, key=lambda mode: mode is BlendMode.PLUS)  # a sum on top, from which nothing is taken
    shapes = tuple(replace(animated("x"), id=f"shape-{k}", blend=mode) for k, mode in enumerate(modes))
    masks, _ = judge(natron_script(Project(CLIP, Layer("root", "Root", shapes)))[0], 1080)
    operators = ["Over", "Stencil", "Mask", "Difference", "Max", "Plus"]
    assert [mask.values["item"].operator for mask in masks] == operators


def test_what_is_lost_is_told(project: Project) -> None:
    notes = natron_script(project)[1]
    assert any("'Soft' has a feather curve and a uniform feather" in note for note in notes)


def test_holds_hold_between_frames(project: Project) -> None:
    held = next(shape for shape in project.shapes if shape.name == "Held")
    mask = next(mask for mask in judge(natron_script(project)[0], 1080)[0] if mask.name == "Held")
    for frame in np.arange(1001.0, 1031.0, 0.25):
        np.testing.assert_allclose(mask.points(frame), held.at(frame).points, atol=0.01)


def test_opacity_and_feather_keep_their_keys() -> None:
    opacity = Animated((ValueKey(1001, 0.25, Interpolation.HOLD), ValueKey(1005, 0.5), ValueKey(1009, 1.0)))
    wide = Animated((ValueKey(1001, 0.0), ValueKey(1009, 8.0)))
    shape = replace(animated("x"), opacity=opacity, feather=wide)
    masks, _ = judge(natron_script(Project(CLIP, Layer("root", "Root", (shape,))))[0], 1080)
    item = masks[0].values["item"]
    assert item.opacity.keys == {1001: 0.25, 1005: 0.5, 1009: 1.0}
    assert item.opacity.kinds == {1001: "Constant", 1005: "Linear", 1009: "Linear"}
    assert item.distance.keys == {1001: 0.0, 1009: 8.0}


def test_a_sum_that_goes_beyond_one_in_natron_is_told() -> None:
    lower, upper = animated("lower"), replace(animated("upper"), blend=BlendMode.PLUS)
    project = Project(CLIP, Layer("root", "Root", (lower, upper)))
    note = "Natron's Plus goes beyond 1 where 'upper' overlaps what lies under it."
    assert note in natron_script(project)[1]
    assert note not in natron_script(project.with_shape(replace(upper, visible=False)))[1]


SUM = (blob("lower", 120.0, 120.0), blob("upper", 150.0, 120.0, blend=BlendMode.PLUS))


@pytest.mark.parametrize(
    "items",
    [
        (*SUM, blob("cut", 140.0, 120.0, 20.0, 15.0, blend=BlendMode.SUBTRACT, opacity=0.5)),
        (*SUM, blob("apart", 140.0, 120.0, 20.0, 15.0, blend=BlendMode.DIFFERENCE)),
        (Layer("l", "Out", SUM, invert=True),),
        (Layer("l", "Dim", SUM, opacity=0.5),),
        (
            blob("Ground", 60.0, 100.0),
            Layer("l", "Sum", (*SUM, Layer("m", "In", SUM, invert=True)), blend=BlendMode.PLUS),
        ),
    ],
    ids=["cut", "apart", "inverted", "dimmed", "in a layer"],
)
def test_a_sum_from_which_something_is_taken_is_cut_off_at_one(items: tuple[Layer | RotoShape, ...]) -> None:
    project = _project(*items)
    text, notes = natron_script(project)
    assert not any("beyond 1" in note for note in notes)
    for frame in (FIRST, LAST):
        ours = render_matte(project, frame, (SIZE[1], SIZE[0]))
        assert overlap(ours, natron.matte(text, frame, (SIZE[1], SIZE[0]))) > 0.999


@pytest.mark.parametrize("opacity", [1.0, 0.4])
@pytest.mark.parametrize("frame", [FIRST, FIRST + 4])
def test_outside_of_its_lifetime_a_shape_that_intersects_a_layer_takes_nothing(frame: int, opacity: float) -> None:
    out = Layer("l", "Out", (blob("Window", 160.0, 120.0),), invert=True, opacity=0.5)
    keep = blob("Keep", 60.0, 60.0, blend=BlendMode.INTERSECT, lifetime=(FIRST + 2, FIRST + 9), opacity=opacity)
    project = _project(blob("Ground", 100.0, 110.0), out, keep)
    theirs = natron.matte(natron_script(project)[0], frame, SIZE[::-1])
    assert overlap(render_matte(project, frame, SIZE[::-1]).astype(np.float64), theirs) > 0.999
