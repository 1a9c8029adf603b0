"""Tangents of opacity and feather in every format: kept, or linear keys on every frame in their place, and told."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange import EXPORTERS, ExportOptions, read_shapes
from roam_core.interchange.protocol import LossyExport
from roam_core.roto import Animated, Interpolation, Layer, Project, ValueKey
from roam_core.roto.animated import has_tangents, value_at
from roam_core.roto.value_curves import bounded
from tests.judges.programs import JUDGES
from tests.judges.scenes import FIRST, LAST, Scene, _project, blob
from tests.judges.table import Judge, judged

FADES = Animated(
    (
        ValueKey(FIRST, 0.2, slopes=(0.0, 0.3)),
        ValueKey(FIRST + 5, 0.6, slopes=(-0.1, -0.1)),
        ValueKey(LAST, 0.9, Interpolation.SMOOTH),
    )
)
DIMS = Animated((ValueKey(FIRST, 1.0, slopes=(0.0, -0.2)), ValueKey(LAST, 0.5, slopes=(0.1, 0.0))))
SOFTENS = Animated((ValueKey(FIRST, 2.0, slopes=(0.0, 6.0)), ValueKey(LAST, 10.0, slopes=(0.0, 0.0))))
THROUGH_ZERO = Animated((ValueKey(FIRST, 20.0), ValueKey(1006, -15.0, Interpolation.SMOOTH), ValueKey(LAST, 10.0)))
"""From outside of the outline to inside and back, by a straight and by a smooth span."""
SMOOTH_ALONE = Animated((ValueKey(FIRST, 20.0, Interpolation.SMOOTH), ValueKey(LAST, -15.0)))
BENT = Animated((ValueKey(FIRST, 20.0, slopes=(0.0, -9.0)), ValueKey(LAST, 15.0, slopes=(9.0, 0.0))))
"""From outside to inside, and back, between two keys."""
STEPS = Animated((ValueKey(FIRST, 16.0, Interpolation.HOLD), ValueKey(1010, 2.0, Interpolation.HOLD)))
SIDES = ["through zero", "smooth through zero", "bent through zero", "steps"]
KEEP = {"nuke", "nuke-python", "json"}
"""Formats that have tangents."""
SOFT = {"nuke", "after-effects", "fusion", "blender", "natron", "json"}
"""Formats that have a uniform feather which keys move."""
BY_KEYS = {"silhouette", "after-effects", "fusion", "blender", "natron"}
"""Formats that move values from key to key straight."""


def fading() -> Project:
    layer = Layer("l", "Dims", (blob("Within", 230.0, 120.0, 40.0, 50.0),), opacity=DIMS)
    return _project(blob("Fades", 70.0, 60.0, 50.0, 40.0, opacity=FADES), layer)


def softening() -> Project:
    return _project(blob("Softens", 150.0, 120.0, 60.0, 50.0, feather=SOFTENS))


@pytest.mark.parametrize("judge", JUDGES, ids=lambda judge: judge.exporter)
def test_mattes_of_bent_opacities_are_those_that_other_programs_are_given(judge: Judge, tmp_path: Path) -> None:
    if judge.missing:
        pytest.skip(judge.missing)
    cell = judged(judge, Scene(fading(), (1003, 1005, 1010)), tmp_path)
    assert not cell.losses
    assert cell.overlap >= judge.least


@pytest.mark.parametrize("name", sorted(KEEP | BY_KEYS))
@pytest.mark.parametrize("project", [fading(), softening()], ids=["opacity", "feather"])
def test_formats_without_tangents_say_so(name: str, project: Project, tmp_path: Path) -> None:
    exporter = EXPORTERS[name]
    notes = exporter.export(project, tmp_path / f"out{exporter.suffix}", ExportOptions(lossy=True))
    told = [note for note in notes if "tangents" in note]
    bent = [item.name for item in project.root.items() if has_tangents(item.opacity) or item.name == "Softens"]
    assert len(told) == (1 if name in BY_KEYS else 0)
    assert all(any(repr(item) in note for note in told) for item in bent if name in BY_KEYS)


@pytest.mark.parametrize("name", ["nuke", "json"])
def test_tangents_come_back_from_formats_that_have_them(name: str, tmp_path: Path) -> None:
    project = _project(blob("Fades", 70.0, 60.0, opacity=FADES, feather=SOFTENS))
    path = tmp_path / f"out{EXPORTERS[name].suffix}"
    EXPORTERS[name].export(project, path)
    (shape,) = read_shapes(path, project.require_clip()).layer.shapes()
    for value, truth in ((shape.opacity, FADES), (shape.feather, SOFTENS)):
        assert isinstance(value, Animated)
        assert value.frames == truth.frames
        for moment in np.linspace(FIRST, LAST, 45):
            assert value_at(value, moment) == pytest.approx(truth.at(moment), abs=1e-5)


def test_frames_cut_off_leave_what_is_between_as_it_was(tmp_path: Path) -> None:
    path = tmp_path / "out.json"
    EXPORTERS["json"].export(fading(), path, ExportOptions(frames=range(FIRST + 2, LAST - 1)))
    layer = read_shapes(path, fading().require_clip()).layer
    shape = next(each for each in layer.shapes() if each.name == "Fades")
    for frame in range(FIRST + 2, LAST - 1):
        assert shape.opacity_at(frame) == pytest.approx(FADES.at(frame))


def test_mlt_loses_opacity_bent_or_not(tmp_path: Path) -> None:
    with pytest.raises(LossyExport, match="Fades"):
        EXPORTERS["mlt"].export(fading(), tmp_path / "out.json")


@pytest.mark.parametrize("feather", [THROUGH_ZERO, SMOOTH_ALONE, BENT, STEPS], ids=SIDES)
@pytest.mark.parametrize(
    "judge", [judge for judge in JUDGES if judge.exporter in SOFT], ids=lambda judge: judge.exporter
)
def test_a_feather_is_as_wide_as_ours_and_on_its_side(judge: Judge, feather: Animated, tmp_path: Path) -> None:
    if judge.missing:
        pytest.skip(judge.missing)
    project = _project(blob("Softens", 150.0, 120.0, 70.0, 60.0, feather=feather))
    assert judged(judge, Scene(project), tmp_path).overlap >= 0.97


@pytest.mark.parametrize("feather", [THROUGH_ZERO, SMOOTH_ALONE, BENT, STEPS], ids=SIDES)
def test_a_feather_comes_back_from_fusion_as_wide_and_on_that_side(feather: Animated, tmp_path: Path) -> None:
    project = _project(blob("Softens", 150.0, 120.0, feather=feather))
    path = tmp_path / "out.setting"
    EXPORTERS["fusion"].export(project, path, ExportOptions(lossy=True))
    back = read_shapes(path, project.require_clip())
    (shape,) = back.layer.shapes()
    assert not any("both sides" in note for note in back.notes)
    for frame in range(FIRST, LAST + 1):
        assert shape.feather_at(frame) == pytest.approx(feather.at(frame), abs=1e-6), frame


def test_blender_tells_of_a_feather_that_steps(tmp_path: Path) -> None:
    for feather, is_told in ((STEPS, True), (THROUGH_ZERO, False)):
        project = _project(blob("Softens", 150.0, 120.0, feather=feather))
        notes = EXPORTERS["blender"].export(project, tmp_path / "out.py", ExportOptions())
        assert any("'Softens', which steps" in note for note in notes) is is_told


@pytest.mark.parametrize(
    "opacity",
    [1.5, -0.25, Animated((ValueKey(FIRST, 0.5, slopes=(0.0, 0.5)), ValueKey(LAST, 0.9, slopes=(0.1, 0.0))))],
    ids=["above", "below", "bent beyond"],
)
@pytest.mark.parametrize("judge", JUDGES, ids=lambda judge: judge.exporter)
def test_no_opacity_is_written_that_is_none(judge: Judge, opacity: Animated | float, tmp_path: Path) -> None:
    """After Effects stops at 150 percent; the matte that ROAM shows has none."""
    if judge.missing:
        pytest.skip(judge.missing)
    project = _project(blob("Below", 90.0, 100.0), blob("Odd", 150.0, 120.0, opacity=opacity))
    assert judged(judge, Scene(project), tmp_path).overlap >= judge.least
    path = tmp_path / "out.json"
    EXPORTERS["json"].export(project, path, ExportOptions(frames=range(1003, 1010)))
    assert len(list(read_shapes(path, project.require_clip()).layer.shapes())) == 2


@pytest.mark.parametrize("slope", [0.1, -0.1, 0.3, -0.3])
def test_tangents_that_reach_full_and_none_come_back_from_nuke(slope: float, tmp_path: Path) -> None:
    """Single precision puts their ends a rounding beyond."""
    keys = (ValueKey(FIRST, 0.71, slopes=(0.0, slope)), ValueKey(LAST, 0.37, slopes=(slope, 0.0)))
    opacity = bounded(Animated(keys), "opacity")
    project = _project(blob("Fades", 150.0, 120.0, opacity=opacity))
    path = tmp_path / "out.nk"
    EXPORTERS["nuke"].export(project, path, ExportOptions())
    (back,) = read_shapes(path, project.require_clip()).layer.shapes()
    assert isinstance(back.opacity, Animated)
    assert back.opacity.frames == (FIRST, LAST)
    for frame in range(FIRST, LAST + 1):
        assert back.opacity.at(frame) == pytest.approx(opacity.at(frame), abs=1e-6)


def test_the_last_digit_of_a_share_does_not_keep_a_file_from_being_read(tmp_path: Path) -> None:
    path = tmp_path / "out.json"
    project = _project(blob("Full", 150.0, 120.0, opacity=0.25))
    EXPORTERS["json"].export(project, path, ExportOptions())
    path.write_text(path.read_text().replace('"opacity": 0.25', '"opacity": 1.0000000000000002'))
    (back,) = read_shapes(path, project.require_clip()).layer.shapes()
    assert back.opacity == 1.0
