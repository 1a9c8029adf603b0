"""What After Effects, Fusion and Natron are given, run by judges that are not ours: places, motion, pixels, names."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange import ExportOptions
from roam_core.interchange.after_effects.exporter import mask_script
from roam_core.interchange.fusion.exporter import fusion_setting
from roam_core.interchange.natron import natron_script
from roam_core.roto import Clip, Interpolation, Keyframe, Layer, Project, RotoShape
from tests.unit.interchange import lua_judge, natron_judge, node_judge
from tests.unit.interchange.conftest import animated
from tests.unit.interchange.judged import JudgedMask, overlap

WITHIN = 0.01
Judge = Callable[[Project, ExportOptions], list[JudgedMask]]

NAMES = (
    "{braces} [python os.abort()] \"quotes\" 'too' \\back\nline\r\ttab </Object> ]] --[[ */ // ${x} `y` %s @LAYERS@",
    "Ärmel \u5de6\u624b \U0001f44b \u2028\u2029\x00\x1b",
    "end",
    "'''\"\"\"'; import os; os.abort() #",
    "x" * 10_000,
    "",
)


@pytest.fixture(params=["fusion", "after-effects", "natron"])
def judge(request: pytest.FixtureRequest, tmp_path: Path) -> Judge:
    """The masks that a program is given, bottom first."""

    def judged(project: Project, options: ExportOptions) -> list[JudgedMask]:
        clip = project.require_clip()
        if request.param == "fusion":
            return lua_judge.judge(fusion_setting(project, options)[0])
        if request.param == "natron":
            return natron_judge.judge(natron_script(project, options)[0], clip.size[1])[0]
        made = node_judge.ran(mask_script(project, options)[0], tmp_path)
        return node_judge.masks(made, clip.fps, clip.first + options.frame_offset)  # as a new composition counts

    return judged


def test_positions_are_right_on_every_frame(judge: Judge, project: Project) -> None:
    masks = judge(project, ExportOptions())
    assert [mask.name for mask in masks] == [shape.name for shape in project.shapes]
    for shape, mask in zip(project.shapes, masks, strict=True):
        assert mask.closed is shape.closed
        for frame in range(1001, 1041):
            np.testing.assert_allclose(mask.points(frame), shape.at(frame).points, atol=WITHIN)


def test_frames_are_shifted_when_asked_for(judge: Judge) -> None:
    project = Project(Clip(Path("plate"), 1001, 1040, (640, 480)), Layer("root", "Root", (animated("Arm"),)))
    (mask,) = judge(project, ExportOptions(frame_offset=-1000))
    for frame in range(1001, 1031):
        np.testing.assert_allclose(mask.points(frame - 1000), project.shapes[0].at(frame).points, atol=WITHIN)


@pytest.mark.parametrize(("size", "aspect"), [((1920, 1080), 1.0), ((480, 854), 1.0), ((720, 576), 16 / 15)])
def test_pixels_are_those_of_our_matte(judge: Judge, size: tuple[int, int], aspect: float) -> None:
    """A leaf with uneven handles that turns and grows, on a key and between two."""
    leaf = bent_leaf(size)
    project = Project(Clip(Path("plate"), 1, 21, size, pixel_aspect=aspect), Layer("root", "Root", (leaf,)))
    (mask,) = judge(project, ExportOptions())
    for frame in (1, 8, 11, 17):
        assert overlap(mask, leaf, frame, (size[1], size[0])) > 0.995


def bent_leaf(size: tuple[int, int]) -> RotoShape:
    """Four points with handles of different lengths and directions, in the middle of the picture."""
    anchors = np.array([[-0.3, 0.0], [0.0, -0.25], [0.3, 0.05], [0.05, 0.28]])
    into = np.array([[-0.05, 0.12], [-0.15, 0.02], [0.02, -0.1], [0.1, 0.03]])
    out = np.array([[0.0, -0.15], [0.1, -0.04], [-0.06, 0.14], [-0.2, -0.02]])
    points = np.stack([anchors, anchors + into, anchors + out], axis=1) * min(size)
    turn = np.array([[np.cos(0.6), np.sin(0.6)], [-np.sin(0.6), np.cos(0.6)]])
    centre = np.array(size) / 2.0
    frames = (1, 11, 21)
    moved = (points + centre, points @ turn * 1.15 + centre, points * 0.8 + centre * 1.1)
    kinds = (Interpolation.LINEAR, Interpolation.SMOOTH, Interpolation.LINEAR)
    keys = tuple(Keyframe(f, p, interpolation=k) for f, p, k in zip(frames, moved, kinds, strict=True))
    return RotoShape("shape-1", "Leaf", keys)


def test_names_come_out_inert_and_equal(judge: Judge) -> None:
    shapes = tuple(replace(animated("x"), id=f"shape-{k}", name=name) for k, name in enumerate(NAMES))
    layer = Layer("layer-1", NAMES[0], shapes)
    project = Project(Clip(Path("plate"), 1001, 1040, (640, 480)), Layer("root", "Root", (layer,)))
    assert [mask.name for mask in judge(project, ExportOptions())] == list(NAMES)


def test_a_project_without_shapes_is_nothing(judge: Judge) -> None:
    assert judge(Project(Clip(Path("plate"), 1, 2, (64, 48))), ExportOptions()) == []
