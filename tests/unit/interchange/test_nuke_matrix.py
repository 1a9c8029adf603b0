"""The extra matrix of Nuke's layers: corner pins and planar tracks are put there by tools, perspective and all."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest

from roam_core.arrays import Array
from roam_core.interchange import Imported, read_shapes
from roam_core.roto import Clip, Layer, RotoShape
from tests.unit.interchange.test_nuke_reading import SQUARE, group, node

CLIP = Clip(Path("/plates/shot.%04d.exr"), 1001, 1040, (200, 100))
PLAIN_PARTS = "0 0 0 0 0 0 0 0 0 1 1 1 0 0 0 0 0 0 0"
PLACES = np.array([[10.0, 20.0], [30.0, 20.0], [30.0, 40.0]])
"""The anchors of `SQUARE`, y up."""
PIN = np.array([[1.1, 0.2, 5.0], [-0.1, 0.9, 12.0], [0.002, -0.001, 1.0]])
"""What a corner pin does to the plane."""


def extra(matrix: Array) -> list[float]:
    """The sixteen numbers, row by row, of what does this to the plane and leaves depth alone."""
    whole = np.eye(4)
    whole[np.ix_((0, 1, 3), (0, 1, 3))] = matrix
    return whole.ravel().tolist()


def form(*matrices: Array) -> str:
    """A transform with these matrices on frames 1001, 1002, ..."""
    columns = zip(*(extra(matrix) for matrix in matrices), strict=True)
    keyed = (" ".join(f"{{{1001 + k} {value!r} -}}" for k, value in enumerate(column)) for column in columns)
    return f"{{t {PLAIN_PARTS} {' '.join(f'{{{keys}}}' for keys in keyed)}}}"


def read(folder: Path, script: str) -> Imported:
    path = folder / "a.nk"
    path.write_text(script, encoding="utf-8")
    return read_shapes(path, CLIP)


def only(imported: Imported) -> RotoShape:
    (shape,) = imported.layer.shapes()
    return shape


def carried(matrix: Array) -> Array:
    """Where the matrix puts the anchors, y down."""
    found = np.column_stack([PLACES, np.ones(3)]) @ matrix.T
    return np.asarray(found[:, :2] / found[:, 2:] * (1.0, -1.0) + (0.0, 100.0))


@pytest.mark.parametrize("share", [1.0, 0.004, -2.0])
def test_a_corner_pin_carries_the_shapes_of_its_layer_in_perspective(tmp_path: Path, share: float) -> None:
    """Whatever its last number is: products of matrices have any."""
    layer = f"{{layer Pinned {{f 512}} {form(share * PIN)} {{a}} {group()}}}"
    imported = read(tmp_path, node(layer))
    assert imported.notes == ()
    np.testing.assert_allclose(only(imported).at(1001).anchors, carried(PIN), atol=1e-4)


@pytest.mark.parametrize("knobs", ["", ' inputs 0\n format "400 100 0 0 400 100 1 wide"'])
def test_a_corner_pin_that_moves_stays_the_motion_of_its_layer(tmp_path: Path, knobs: str) -> None:
    """The shapes keep their own keys; pictures of another size scale both."""
    later = PIN + np.array([[0.0, 0.0, 4.0], [0.0, 0.0, -3.0], [0.001, 0.0, 0.0]])
    layer = f"{{layer Pinned {{f 512}} {form(PIN, later)} {{a}} {group('{p ' + SQUARE + '}')}}}"
    imported = read(tmp_path, node(layer, knobs=knobs))
    (item,) = imported.layer.children
    assert isinstance(item, Layer)
    assert item.transform is not None
    assert (item.name, item.transform.frames) == ("Pinned", (1001, 1002))
    (shape,) = imported.layer.in_plate_space().shapes()
    assert shape.frames == (1001,)
    narrowed = (0.5, 1.0) if knobs else (1.0, 1.0)
    np.testing.assert_allclose(shape.at(1001).anchors, carried(PIN) * narrowed, atol=1e-4)
    np.testing.assert_allclose(shape.at(1002).anchors, carried(later) * narrowed, atol=1e-4)


def test_a_root_that_moves_is_the_layer_of_its_node(tmp_path: Path) -> None:
    root = "{f 512} {t 0 0 0 {{1001 0 0 1 2 1} {1011 20 2 1 0 1}}} {a}"
    (item,) = read(tmp_path, node(group(), root=root, knobs=" name Tracked")).layer.children
    assert isinstance(item, Layer)
    assert item.transform is not None
    assert (item.name, item.transform.frames) == ("Tracked", (1001, 1011))
    np.testing.assert_allclose(item.transform.at(1006)[:2, 2], [10.0, 0.0])


def test_what_moves_within_a_layer_that_stands_elsewhere_goes_into_the_points(tmp_path: Path) -> None:
    inner = f"{{layer Inner {{f 512}} {{t 0 0 0 {{{{1001 0 0 1 2 1}} {{1011 20 2 1 0 1}}}}}} {{a}} {group()}}}"
    shape = only(read(tmp_path, node(inner, root="{f 512} {t 0 0 0 5 0} {a}")))
    assert shape.frames == (1001, 1011)
    np.testing.assert_allclose(shape.at(1006).anchors[0], [10.0 + 10.0 + 5.0, 80.0])


def test_keys_of_a_moving_layer_beside_the_clip_are_told(tmp_path: Path) -> None:
    root = "{f 512} {t 0 0 0 {{1 0 0 1 2 1} {11 20 2 1 0 1}}} {a}"
    (note,) = read(tmp_path, node(group("{p " + SQUARE + "}"), root=root)).notes
    assert "frames 1 to 11, none of them on the clip's" in note


def test_layers_within_a_pin_that_moves_move_with_it(tmp_path: Path) -> None:
    later = PIN + np.array([[0.0, 0.0, 4.0], [0.0, 0.0, -3.0], [0.001, 0.0, 0.0]])
    inner = f"{{layer Inner {{f 512}} {{t 0 0 0 {{{{1001 0 0 1 2 1}} {{1011 20 2 1 0 1}}}}}} {{a}} {group()}}}"
    outer = f"{{layer Pinned {{f 512}} {form(PIN, later)} {{a}} {inner}}}"
    (shape,) = read(tmp_path, node(outer)).layer.in_plate_space().shapes()
    moved = np.array([[1.0, 0.0, 2.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(shape.at(1002).anchors, carried(later @ moved), atol=1e-4)


def test_layers_within_a_pin_are_moved_before_it(tmp_path: Path) -> None:
    inner = f"{{layer Inner {{f 512}} {{t 0 0 0 7 3}} {{a}} {group()}}}"
    shape = only(read(tmp_path, node(inner, root=f"{{f 512}} {form(PIN)} {{a}}")))
    moved = np.array([[1.0, 0.0, 7.0], [0.0, 1.0, 3.0], [0.0, 0.0, 1.0]])
    np.testing.assert_allclose(shape.at(1001).anchors, carried(PIN @ moved), atol=1e-4)


def test_a_matrix_that_puts_a_point_at_infinity_loses_that_shape_alone(tmp_path: Path) -> None:
    beyond = np.array([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [-0.1, 0.0, 1.0]])
    imported = read(tmp_path, node(group(name="Far", form=form(beyond)), group(name="Near")))
    assert only(imported).name == "Near"
    assert imported.notes == ("The shape 'Far' was left out: a matrix sends it to infinity.",)
