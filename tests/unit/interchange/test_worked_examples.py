"""The exporters beside the worked examples of the format notes, which were made by hand from the evidence."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.interchange.after_effects.exporter import mask_script
from roam_core.interchange.fusion.exporter import fusion_setting
from roam_core.interchange.natron import natron_script
from roam_core.interchange.silhouette.exporter import silhouette_document
from roam_core.roto import Clip, Keyframe, Layer, Project, RotoShape
from tests.unit.interchange import lua_judge, natron_judge, node_judge, nuke_judge, silhouette_judge
from tests.unit.interchange.conftest import roto_script

EXAMPLES = Path(__file__).parents[3].parent / "shared" / "formats" / "examples"

pytestmark = [
    pytest.mark.shared,
    pytest.mark.skipif(not EXAMPLES.is_dir(), reason="the format notes do not lie beside the repository"),
]


@pytest.fixture
def example() -> Project:
    """A quadrangle with handles on its second point that moves by (100, 50) in ten frames."""
    anchors = np.array([[600.0, 300.0], [1200.0, 300.0], [1200.0, 700.0], [600.0, 700.0]])
    start = np.repeat(anchors[:, None], 3, axis=1)
    start[1, 1] += (-60.0, -40.0)
    start[1, 2] += (60.0, 40.0)
    keys = (Keyframe(1, start), Keyframe(11, start + np.array([100.0, 50.0])))
    shape = RotoShape("shape-1", "Bezier1", keys)
    return Project(Clip(Path("plate"), 1, 11, (1920, 1080)), Layer("root", "Layer_1", (shape,)))


def test_the_nuke_example(example: Project) -> None:
    (theirs,) = nuke_judge.judge((EXAMPLES / "example.nk").read_text()).root.shapes()
    (ours,) = nuke_judge.judge(roto_script(example)).root.shapes()
    assert (ours.name, ours.flags, ours.curve_flags) == (theirs.name, theirs.flags, theirs.curve_flags)
    assert ours.pivot == theirs.pivot
    assert (ours.times, ours.outline) == (theirs.times, theirs.outline)


def test_the_silhouette_example(example: Project) -> None:
    (theirs,) = silhouette_judge.judge((EXAMPLES / "example.fxs").read_text())[1].shapes()
    (ours,) = silhouette_judge.judge(silhouette_document(example)[0])[1].shapes()
    assert (ours.interps, ours.closed) == (theirs.interps, theirs.closed)
    for frame, points in theirs.keys.items():
        np.testing.assert_array_equal(ours.keys[frame], points)


def test_the_fusion_example(example: Project) -> None:
    (theirs,) = lua_judge.judge((EXAMPLES / "example.setting").read_text().replace("Inputs = {", COMMENTS, 1))
    (ours,) = lua_judge.judge(fusion_setting(example)[0])
    assert ours.closed is theirs.closed
    assert list(ours.keys) == list(theirs.keys)
    for frame, points in theirs.keys.items():
        np.testing.assert_allclose(ours.keys[frame], points, atol=1e-5)


COMMENTS = 'Inputs = { Comments = Input { Value = "" },'
"""The example has no comments, which our masks keep their names in."""


def test_the_after_effects_example(example: Project, tmp_path: Path) -> None:
    """It sets masks on a layer of the size of the composition that begins with it."""
    theirs = node_judge.ran((EXAMPLES / "example.jsx").read_text(), tmp_path, (1920, 1080))["masks"][0]["properties"]
    ours = node_judge.ran(mask_script(example)[0], tmp_path, (1920, 1080))["masks"][0]["properties"]
    for mine, yours in zip(ours["ADBE Mask Shape"]["keys"], theirs["ADBE Mask Shape"]["keys"], strict=True):
        assert mine["time"] - 2.0 == pytest.approx(yours["time"])  # the stub's layer begins at two seconds
        for part in ("vertices", "inTangents", "outTangents", "closed"):
            assert mine["value"][part] == yours["value"][part]


def test_the_natron_example(example: Project) -> None:
    text = (EXAMPLES / "example_natron.py").read_text()
    (theirs,), (ours,) = (natron_judge.judge(script, 1080)[0] for script in (text, natron_script(example)[0]))
    assert ours.closed is theirs.closed
    for frame, points in theirs.keys.items():
        np.testing.assert_array_equal(ours.keys[frame], points)
        np.testing.assert_array_equal(ours.values["feather"][frame], theirs.values["feather"][frame])
