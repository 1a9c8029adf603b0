"""Keys that an importer puts between a file's own are stale only when one of the artist's around them changes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from roam_core.geometry import projective
from roam_core.interchange import read_shapes
from roam_core.propagate.shapes.provenance import is_stale
from roam_core.roto import Clip, Keyframe, Layer, LayerTransform, Origin, Project, RotoShape
from roam_core.roto.imported import IMPORT, is_import, stamped

CLIP = Clip(Path("plate"), 1, 40, (200, 100))


@pytest.fixture
def shape() -> RotoShape:
    """Keys of the file on 1, 20 and 40, of the importer on 10 and 30."""
    rng = np.random.default_rng(3)
    frames = {1: Origin.ARTIST, 10: Origin.ENGINE, 20: Origin.ARTIST, 30: Origin.ENGINE, 40: Origin.ARTIST}
    keys = tuple(
        Keyframe(frame, rng.uniform(0, 100, (4, 3, 2)), origin=origin, inputs=IMPORT if origin is Origin.ENGINE else "")
        for frame, origin in frames.items()
    )
    made = stamped(RotoShape("a", "A", keys))
    assert isinstance(made, RotoShape)
    return made


def stale(shape: RotoShape, clip: Clip | None = CLIP) -> list[int]:
    return [key.frame for key in shape.keys if is_stale(shape, key, clip)]


def moved(shape: RotoShape, frame: int) -> RotoShape:
    key = shape.key_at(frame)
    assert key is not None
    return shape.with_key(replace(key, points=key.points + 0.1))


def test_the_stamp_tells_the_keys_around(shape: RotoShape) -> None:
    words = [key.inputs.split(":")[3:] for key in shape.keys if is_import(key)]
    assert words == [["from=1", "to=20"], ["from=20", "to=40"]]


def test_only_a_change_of_a_key_around_makes_them_stale(shape: RotoShape) -> None:
    assert stale(shape) == []
    assert stale(moved(shape, 1)) == [10]
    assert stale(moved(shape, 20)) == [10, 30]
    assert stale(moved(shape, 10)) == []
    assert stale(replace(shape, keys=tuple(key for key in shape.keys if key.frame != 20))) == [10, 30]
    assert stale(shape.with_key(Keyframe(25, shape.keys[0].points))) == [30]


def test_neither_clip_nor_fields_of_the_shape_matter(shape: RotoShape) -> None:
    assert stale(replace(shape, name="B", opacity=0.5, blend="subtract"), replace(CLIP, path=Path("other"))) == []
    assert stale(shape, None) == []


def test_a_layer_that_is_given_a_motion_and_loses_it_leaves_them_current(shape: RotoShape) -> None:
    turn = projective.IDENTITY + np.array([[0.01, -0.2, 7.3], [0.2, 0.01, 1.1], [0, 0, 0]])
    transform = LayerTransform.of({1: turn})
    inner = replace(shape.map_points(lambda points: projective.apply(np.linalg.inv(turn), points)), id="a")
    project = Project(CLIP, Layer("root", "Root", (Layer("l", "L", (inner,), transform=transform),)))
    assert stale(project.shape("a")) == []


def test_keys_of_a_file_are_the_artists_and_those_between_are_not(tmp_path: Path) -> None:
    """A cubic in time that starts steep: the two keys of the file, and some of the importer's that follow it."""
    path = tmp_path / "a.nk"
    corners = [(0, 0), (50, 0), (50, 50)]
    entries = " ".join(
        f"{{0 0}} {{{{{{{x} 0 1 9 1}} {{{x + 60} 0 1 0 1}}}} {{{{{y} -}}}}}} {{0 0}}" for x, y in corners
    )
    path.write_text(
        "Roto {\n inputs 0\n curves {{{v x3f99999a}\n {f 0}\n {n {layer Root {f 2097152} {t 0 0} {a} "
        f"{{curvegroup A 512 bezier {{{{cc {{f 8192}} {{px {{1 21}} {entries}}}}} idem}} {{tx 1 0 0}} {{a}}}}"
        "}}}}\n}\n"
    )
    (found,) = read_shapes(path, CLIP).layer.shapes()
    assert found.artist_frames == (1, 21)
    between = [key for key in found.keys if key.origin is Origin.ENGINE]
    assert 2 < len(between) < 19
    assert all(is_import(key) for key in between)
    assert stale(found) == []
    u = np.linspace(0.0, 1.0, 21)
    truth = 60 * (3 * u**2 - 2 * u**3) + 9 * 20 * u * (1 - u) ** 2
    np.testing.assert_allclose([found.at(1 + k).anchors[0, 0] for k in range(21)], truth, atol=0.051)
