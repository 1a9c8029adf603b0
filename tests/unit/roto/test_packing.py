"""The compact form of keys: which runs are packed, that bits come back, and what is refused."""

from __future__ import annotations

import json
from collections.abc import Callable
from dataclasses import replace
from typing import Any

import numpy as np
import pytest

from roam_core.geometry import bezier
from roam_core.roto import Interpolation, Keyframe, Origin
from roam_core.roto.packing import (
    FEWEST_PACKED,
    FEWEST_PACKED_DRAWN,
    listed_numbers,
    listed_rows,
    packed_keys,
    packed_numbers,
    unpacked_keys,
    unpacked_numbers,
)

BOX = bezier.polygon_points([(0.1, 0.2), (10.0, 1 / 3), (-7.25, 1e-17)])
CURVE = BOX + np.linspace(-1.0, 1.0, 18).reshape(3, 3, 2)


def run_of(count: int, points: Any = CURVE, **fields: Any) -> list[Keyframe]:
    return [Keyframe(1001 + k, points + k / 3.0, **{"origin": Origin.ENGINE} | fields) for k in range(count)]


def forms(keys: list[Keyframe]) -> list[tuple[str, int]]:
    """The type and the number of keys of each object that stands for them."""
    return [(each["type"], len(each.get("frames", "1"))) for each in packed_keys(keys)]


def there_and_back(keys: list[Keyframe]) -> list[Keyframe]:
    documents = json.loads(json.dumps(packed_keys(keys)))
    found = [key for document in documents for key in unpacked_keys(document)]
    return sorted(found, key=lambda key: key.frame)


def test_numbers_come_back_bit_by_bit() -> None:
    values = np.array([[0.1, -0.0, 5e-324], [np.pi, -1.7976931348623157e308, 1 / 3]])
    again = unpacked_numbers(json.loads(json.dumps(packed_numbers(values))))
    assert again.tobytes() == values.tobytes()
    assert again.shape == values.shape
    assert not again.flags.writeable


def test_the_form_is_base64_of_little_endian_numbers() -> None:
    assert packed_numbers(np.array([1.0, -2.5])) == {
        "type": "Numbers",
        "shape": [2],
        "data": "AAAAAAAA8D8AAAAAAAAEwA==",
    }


def test_what_is_not_finite_is_never_packed() -> None:
    with pytest.raises(ValueError, match="not finite"):
        packed_numbers(np.array([1.0, np.nan]))


@pytest.mark.parametrize(
    "change",
    [
        {"data": "AAAA"},
        {"data": "AAAAAAAA8D8AAAAAAAAEw!=="},
        {"data": 7},
        {"shape": [3]},
        {"shape": [-1]},
        {"shape": [2.0]},
        {"shape": [10**9, 10**9]},
        {"shape": 2},
        {"shape": [1, 1, 1, 1, 2]},
        {"type": "Keyframe"},
        {"later": 1},
    ],
)
def test_damaged_numbers_are_refused(change: dict[str, Any]) -> None:
    with pytest.raises((ValueError, TypeError)):
        unpacked_numbers(packed_numbers(np.array([1.0, -2.5])) | change)


def test_packed_infinity_is_refused() -> None:
    with pytest.raises(ValueError, match="not finite"):
        unpacked_numbers({"type": "Numbers", "shape": [1], "data": "AAAAAAAA8H8="})


@pytest.mark.parametrize("values", [["1.0"], [True], [None], [[1.0]], {"a": 1}, "1", [1e999]])
def test_a_list_of_numbers_holds_nothing_else(values: Any) -> None:
    with pytest.raises((ValueError, TypeError)):
        listed_numbers(values)


@pytest.mark.parametrize("rows", [[[1.0]], [[1.0, 2.0], [3.0]], [1.0, 2.0], ["ab"], [["a", "b"]], {}])
def test_rows_are_all_of_one_width(rows: Any) -> None:
    with pytest.raises(ValueError, match="numbers"):
        listed_rows(rows, 2)


def test_tracked_keys_are_packed_and_artist_keys_read() -> None:
    keys = run_of(2 * FEWEST_PACKED)
    keys[1] = replace(keys[1], origin=Origin.ARTIST)
    assert forms(keys) == [("Keyframes", 2 * FEWEST_PACKED - 1), ("Keyframe", 1)]
    assert there_and_back(keys) == keys


def test_few_keys_are_read() -> None:
    assert forms(run_of(FEWEST_PACKED - 1)) == [("Keyframe", 1)] * (FEWEST_PACKED - 1)


def test_many_artist_keys_are_packed_too() -> None:
    few, many = (run_of(count, origin=Origin.ARTIST) for count in (FEWEST_PACKED_DRAWN - 1, FEWEST_PACKED_DRAWN))
    assert forms(few) == [("Keyframe", 1)] * (FEWEST_PACKED_DRAWN - 1)
    assert forms(many) == [("Keyframes", FEWEST_PACKED_DRAWN)]
    assert there_and_back(many) == many


def test_keys_that_take_turns_are_packed() -> None:
    """A key of the artist's on every other frame, filled between."""
    keys = [replace(key, origin=Origin.ARTIST) if k % 2 else key for k, key in enumerate(run_of(40))]
    assert forms(keys) == [("Keyframes", 20), ("Keyframes", 20)]
    assert there_and_back(keys) == keys


@pytest.mark.parametrize(
    "fields",
    [
        {"origin": Origin.ARTIST},
        {"interpolation": Interpolation.HOLD},
        {"feather": CURVE},
        {"confidence": 0.5},
        {"vertex_confidence": np.array([0.1, 0.2, 0.3])},
        {"extra": {"later": 1}},
    ],
)
def test_a_key_that_differs_stands_by_itself(fields: dict[str, Any]) -> None:
    keys = run_of(3 * FEWEST_PACKED)
    keys[1] = replace(keys[1], **fields)
    assert forms(keys) == [("Keyframes", 3 * FEWEST_PACKED - 1), ("Keyframe", 1)]
    assert there_and_back(keys) == keys


def test_fields_of_a_run_are_those_of_its_keys_to_the_type() -> None:
    keys = run_of(FEWEST_PACKED, extra={"later": 1}) + [
        replace(key, frame=key.frame + 100) for key in run_of(FEWEST_PACKED, extra={"later": 1.0})
    ]
    again = there_and_back(keys)
    assert [type(key.extra["later"]) for key in again] == [int] * FEWEST_PACKED + [float] * FEWEST_PACKED


def test_polygons_are_held_without_their_handles() -> None:
    keys = run_of(FEWEST_PACKED, BOX)
    (document,) = packed_keys(keys)
    assert document["points"]["shape"] == [FEWEST_PACKED, 3, 1, 2]
    assert [key.points.tobytes() for key in there_and_back(keys)] == [key.points.tobytes() for key in keys]


def test_a_zero_with_another_sign_is_another_number() -> None:
    """A handle on its anchor but for the sign of a zero is no polygon's."""
    box = np.zeros((3, 3, 2))
    box[:, 1:] = -0.0
    keys = [Keyframe(k, box, origin=Origin.ENGINE) for k in range(FEWEST_PACKED)]
    assert [key.points.tobytes() for key in there_and_back(keys)] == [key.points.tobytes() for key in keys]


def test_equal_stamps_are_told_once() -> None:
    keys = [replace(key, inputs=f"stamp {k // 6}") for k, key in enumerate(run_of(12))]
    (document,) = packed_keys(keys)
    assert document["inputs"] == [[6, "stamp 0"], [6, "stamp 1"]]
    assert there_and_back(keys) == keys


@pytest.mark.parametrize(
    "damage",
    [
        lambda d: d.update(frames=d["frames"][1:]),
        lambda d: d.update(frames=["1001"] * 12),
        lambda d: d.update(frames=[*d["frames"][:5], 1006.5, *d["frames"][6:]]),
        lambda d: d.pop("frames"),
        lambda d: d.update(points=packed_numbers(np.zeros((12, 3, 2)))),
        lambda d: d.update(points=packed_numbers(np.zeros((12, 3, 2, 2)))),
        lambda d: d.update(feather=packed_numbers(np.zeros((12, 2, 3, 2)))),
        lambda d: d.update(confidence=packed_numbers(np.zeros(11))),
        lambda d: d.update(vertex_confidence=packed_numbers(np.zeros(12))),
        lambda d: d.update(inputs=[[11, "a"]]),
        lambda d: d.update(inputs=[[-1, "a"], [13, "b"]]),
        lambda d: d.update(inputs=[[12, 7]]),
        lambda d: d.update(inputs="abc"),
        lambda d: d.update(origin="nobody"),
        lambda d: d.update(type="Keys"),
    ],
)
def test_a_damaged_run_is_refused(damage: Callable[[dict[str, Any]], object]) -> None:
    (document,) = packed_keys(run_of(12))
    damage(document)
    with pytest.raises((ValueError, KeyError, TypeError)):
        unpacked_keys(document)
