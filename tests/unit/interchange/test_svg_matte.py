"""What any renderer makes of our SVG is our matte: resvg paints it, on projects that use every mode."""

from __future__ import annotations

from dataclasses import replace
from itertools import product
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.svg.format import svg_document
from roam_core.matte import render_matte
from roam_core.roto import BlendMode, Clip, Keyframe, Layer, Project, RotoShape
from tests.judges import svg as judge
from tests.judges.scenes import SCENES, ellipse

pytest.importorskip("resvg_py", reason="resvg is the judge of SVG: install the extra dev")

SIZE = (480, 320)
CLIP = Clip(Path("plate"), 1, 21, SIZE)


def disc(name: str, x: float, curve: float = 0.0, **values: object) -> RotoShape:
    """An ellipse about (x, 160); `curve` pulls its feather points out by that share."""
    points = ellipse(x, 160.0, 90.0, 110.0)
    feather = (points - (x, 160.0)) * curve if curve else None
    return RotoShape(name, name, (Keyframe(1, points, feather),), **values)  # type: ignore[arg-type]


def compared(project: Project, frame: int = 1, zoom: int = 8) -> tuple[float, float]:
    """Intersection over union of the mattes, and their mean difference."""
    size = project.require_clip().size
    ours, theirs = render_matte(project, frame, size[::-1]), judge.matte(svg_document(project, frame)[0], size, zoom)
    # Not at a half: an opacity of a half is on either side of it by rounding alone.
    inside, painted = ours > 0.45, theirs > 0.45
    return float((inside & painted).sum() / (inside | painted).sum()), float(np.abs(ours - theirs).mean())


@pytest.mark.parametrize("mode", BlendMode)
def test_every_mode_hard_soft_dimmed_and_inverted(mode: BlendMode) -> None:
    for feather, (opacity, invert) in product((0.0, 12.0, -12.0), ((1.0, False), (0.7, True))):
        over = disc("Over", 290.0, blend=mode, feather=feather, opacity=opacity, invert=invert)
        overlap, error = compared(Project(CLIP, Layer("root", "Root", (disc("Under", 190.0), over))), zoom=1)
        assert overlap > 0.997, (feather, opacity, invert)
        assert error < 0.0025  # less than a level of 8 bits


@pytest.mark.parametrize("name", ["modes", "layers", "inverted", "soft edges", "in time"])
def test_the_scenes_that_ask_one_thing_each(name: str) -> None:
    scene = SCENES[name]
    overlap, error = compared(scene.project, 1007, zoom=2)
    assert overlap > 0.998  # painted eight times as large .999, in seconds each
    assert error < 0.002


def test_feather_curves_on_either_side_of_the_outline_are_painted() -> None:
    for curve in (0.3, -0.3):
        overlap, error = compared(Project(CLIP, Layer("root", "Root", (disc("Soft", 240.0, curve),))), zoom=1)
        assert overlap > 0.997
        assert error < 0.0005


def test_a_project_without_modes_stays_a_list_of_paths() -> None:
    text, notes = svg_document(Project(CLIP, Layer("root", "Root", (disc("A", 190.0), disc("B", 290.0)))), 1)
    assert notes == ()
    assert text.count("<path") == 2
    assert "mask" not in text
    assert "opacity" not in text


def test_what_was_painted_in_masks_comes_back_as_it_was(tmp_path: Path) -> None:
    for name in ("modes", "layers", "inverted", "soft edges"):
        project = SCENES[name].project
        path = tmp_path / "p.svg"
        EXPORTERS["svg"].export(project, path, ExportOptions(frame=1007))
        made = read_shapes(path, project.require_clip())
        assert made.notes == ()
        for item, mine in zip(made.layer.items(), project.root.items(), strict=True):
            assert (item.name, item.invert, item.blend) == (mine.name, mine.invert, mine.blend)
            if isinstance(item, RotoShape) and isinstance(mine, RotoShape):
                outline, theirs = mine.at(1007), item.keys[0]
                np.testing.assert_allclose(theirs.points, outline.points, atol=1e-5)
                assert item.colour == pytest.approx(mine.colour, abs=1e-6)
                if outline.feather is not None:
                    np.testing.assert_allclose(theirs.feather, outline.feather, atol=1e-5)


@pytest.mark.parametrize("fields", [{"invert": True}, {"blend": BlendMode.INTERSECT}])
def test_a_layer_comes_back_whose_shapes_do_not_exist_on_the_frame(fields: dict[str, Any], tmp_path: Path) -> None:
    gone = Layer("l", "Gone", (disc("Later", 290.0, lifetime=(5, 9)),), **fields)
    project = Project(CLIP, Layer("root", "Root", (disc("Under", 190.0), gone)))
    EXPORTERS["svg"].export(project, tmp_path / "a.svg", ExportOptions(frame=1))
    again = Project(CLIP, Layer("root", "Root", read_shapes(tmp_path / "a.svg", CLIP).layer.children))
    np.testing.assert_allclose(*(render_matte(each, 1, SIZE[::-1]) for each in (again, project)), atol=1e-3)


def test_a_lifetime_is_one_sentence_for_all_frames(tmp_path: Path) -> None:
    shape = replace(disc("Brief", 200.0), lifetime=(5, 9))
    project = Project(CLIP, Layer("root", "Root", (disc("Base", 200.0), shape)))
    notes = EXPORTERS["svg"].export(project, tmp_path / "p.####.svg")
    assert notes == ("'Brief' does not exist on frames 1 to 4, 9 to 21: it is left out.",)
