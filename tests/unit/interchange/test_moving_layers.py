"""Every format holds the motion of layers: what it writes is what it writes of the same motion in the shapes."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.interchange.bake_layers import BY_LAYER, bake_layers
from roam_core.interchange.keys.reduction import reduced
from roam_core.interchange.matte_style import Parts
from roam_core.interchange.mattes.exporter import parts_of
from roam_core.interchange.protocol import ExportOptions, KeyChoice, exported_keys
from roam_core.interchange.registry import EXPORTERS, read_shapes
from roam_core.matte import render_matte
from roam_core.roto import (
    Keyframe,
    Layer,
    LayerTransform,
    Origin,
    Project,
    RotoShape,
    Spline,
    baking,
    control_points,
    edit,
)
from tests.unit.interchange.conftest import CLIP

TILT = np.array([[1.05, 0.02, 30.0], [-0.03, 0.98, -12.0], [1e-5, 2e-5, 1.0]])


@pytest.mark.parametrize("name", sorted(set(EXPORTERS) - {"mattes", "nuke-tracks"}))
def test_a_format_holds_the_motion(name: str, project: Project, tmp_path: Path) -> None:
    moving = edit.set_properties(project, "layer-1", transform=LayerTransform.of({1001: np.eye(3), 1030: TILT}))
    exporter = EXPORTERS[name]
    texts = {}
    for word, each in (("moving", moving), ("baked", bake_layers(moving)), ("still", project)):
        path = tmp_path / word / f"shapes{exporter.suffix}"
        path.parent.mkdir()
        exporter.export(each, path, ExportOptions(lossy=True))
        texts[word] = {file.name: file.read_bytes() for file in sorted(path.parent.rglob("*")) if file.is_file()}
    assert texts["moving"] == texts["baked"]
    if name not in ("svg", "coco"):  # a picture of the first frame, when the layer stands; what is hidden is no object
        assert texts["moving"] != texts["still"]


def test_mattes_of_layers_hold_the_motion_of_those_above() -> None:
    one, outer = edit.add_layer(Project())
    one, inner = edit.add_layer(one, parent_id=outer.id)
    points = np.repeat(np.array([[4.0, 4.0], [12.0, 4.0], [12.0, 12.0], [4.0, 12.0]])[:, None], 3, axis=1)
    one, _ = edit.new_shape(one, points, 1, layer_id=inner.id)
    push = np.array([[1.0, 0.0, 10.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    one = edit.set_properties(one, outer.id, transform=LayerTransform.of({1: push}))
    for kind in (Parts.LAYER, Parts.SHAPE):
        for part in parts_of(one, kind):
            content = part.content if isinstance(part.content, Layer) else list(part.content)
            matte = render_matte(content, 1, (16, 32))
            assert matte[8, 18] == 1.0
            assert matte[8, 8] == 0.0


def test_keys_that_only_a_layer_asks_for_are_left_out_or_kept_as_the_motion_wants() -> None:
    """Straight motion of a layer needs two keys when reduced; the artist's keys alone would lose it."""
    corners = np.array([[100.0, 100.0], [300.0, 100.0], [300.0, 300.0]])
    shape = RotoShape("shape-1", "S", (Keyframe(1001, bezier.polygon_points(corners)),))
    push = np.array([[1.0, 0.0, 90.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    layer = Layer("layer-1", "L", (shape,), transform=LayerTransform.of({1001: np.eye(3), 1031: push}))
    still = bake_layers(Project(CLIP, Layer("root", "Root", (layer,))))
    assert bake_layers(still) is still
    (carried,) = still.shapes
    assert carried.artist_frames == (1001,)
    assert {key.inputs for key in carried.keys[1:]} == {BY_LAYER}
    frames = {choice: exported_keys(carried, ExportOptions(keys=choice), []).frames for choice in KeyChoice}
    assert frames[KeyChoice.ARTIST] == frames[KeyChoice.EVERY] == tuple(range(1001, 1032))
    assert reduced(carried, 0.5).shape.frames == (1001, 1031)


@pytest.mark.parametrize("name", ["json", "silhouette"])
@pytest.mark.parametrize("tilt", [0.0, 4e-4])
def test_a_b_spline_that_is_none_in_perspective_comes_back_as_the_same_curve(
    name: str, tilt: float, tmp_path: Path
) -> None:
    hull = bezier.polygon_points([(100.0, 100.0), (900.0, 80.0), (950.0, 700.0), (500.0, 900.0), (80.0, 600.0)])
    shape = RotoShape("shape-1", "Sign", (Keyframe(CLIP.first, hull),))
    shape = control_points.with_spline(shape, Spline.BSPLINE)
    moves = LayerTransform.of({CLIP.first: np.eye(3), CLIP.last: [[1.1, 0.1, 9.0], [-0.1, 1.0, 3.0], [tilt, 0.0, 1.0]]})
    project = Project(CLIP, Layer("root", "Root", (Layer("layer-1", "Wall", (shape,), transform=moves),)))
    path = tmp_path / f"shapes{EXPORTERS[name].suffix}"
    notes = EXPORTERS[name].export(project, path, ExportOptions())
    assert any("'Sign' is written as Bezier" in note for note in notes) is bool(tilt)
    (back,) = read_shapes(path, CLIP).layer.shapes()
    assert back.spline is (Spline.BEZIER if tilt else Spline.BSPLINE)
    placed = project.shape("shape-1")
    for frame in (CLIP.first, CLIP.last):
        np.testing.assert_allclose(back.at(frame).points, placed.at(frame).points, atol=0.01)


@pytest.mark.parametrize("name", sorted(set(EXPORTERS) - {"mattes"}))
def test_the_artists_keys_alone_go_between_each_other_as_if_no_engine_had_made_any(name: str, tmp_path: Path) -> None:
    """Of a tracked shape in a moving layer the engine's keys were left out, and those of the layer kept between."""
    corners = np.array([[100.0, 100.0], [300.0, 100.0], [300.0, 300.0], [100.0, 300.0]])
    drawn = [Keyframe(frame, bezier.polygon_points(corners + 9.0 * (frame - 1001))) for frame in (1001, 1011)]
    track = [
        Keyframe(frame, bezier.polygon_points(corners - 5.0 * (frame - 1001)), origin=Origin.ENGINE, inputs="x")
        for frame in (1002, 1003, 1006, 1008)
    ]
    moves = LayerTransform.of({1001: np.eye(3), 1007: [[1.0, 0.0, 30.0], [0.0, 1.0, 80.0], [0.0, 0.0, 1.0]]})
    texts = []
    for word, keys, choice in (("all", drawn + track, KeyChoice.ARTIST), ("own", drawn, KeyChoice.EVERY)):
        shape = RotoShape("shape-1", "S", tuple(sorted(keys, key=lambda key: key.frame)))
        project = Project(CLIP, Layer("root", "Root", (Layer("layer-1", "L", (shape,), transform=moves),)))
        path = tmp_path / word / f"shapes{EXPORTERS[name].suffix}"
        path.parent.mkdir()
        EXPORTERS[name].export(project, path, ExportOptions(keys=choice, frame=1006, lossy=True))
        texts.append({file.name: file.read_bytes() for file in path.parent.rglob("*") if file.is_file()})
    assert texts[0] == texts[1]


def test_where_each_frame_has_its_key_nothing_is_carried_back_or_blended(monkeypatch: pytest.MonkeyPatch) -> None:
    """To copy shapes of a moving layer did both for each of their keys: ten seconds, where each frame has one."""
    tilts = {frame: np.array([[1.0, 0.0, frame], [0.0, 1.0, 0.0], [1e-5 * frame, 0.0, 1.0]]) for frame in range(1, 9)}
    square = bezier.polygon_points([(10.0, 10.0), (30.0, 10.0), (30.0, 26.0)])
    held = RotoShape("s", "S", tuple(Keyframe(frame, square + frame) for frame in range(1, 9)))
    layer = Layer("l", "L", (held,), transform=LayerTransform.of(tilts))
    placed = Project(root=Layer("root", "Root", (layer,))).shape("s")
    blended, at = list[float](), RotoShape.at
    monkeypatch.setattr(RotoShape, "at", lambda shape, frame: blended.append(frame) or at(shape, frame))
    monkeypatch.setattr(baking, "unplaced", lambda shape: pytest.fail("nothing is held: there are no steps"))
    plain = baking.baked(placed)
    assert [key is own for key, own in zip(plain.keys, placed.keys, strict=True)] == [True] * 8
    assert not blended
