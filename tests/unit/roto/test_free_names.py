"""Names and ids that nothing bears yet."""

from __future__ import annotations

import pytest

from roam_core.roto.free_names import counted_on, next_id


@pytest.mark.parametrize(
    ("name", "taken", "expected"),
    [
        ("Arm", {"Leg"}, "Arm"),
        ("Arm", {"Arm"}, "Arm 1"),
        ("Arm 1", {"Arm", "Arm 1"}, "Arm 2"),
        ("Arm 1", {"Arm 1", "Arm 2", "Arm 4"}, "Arm 3"),
        ("Take 019", {"Take 019"}, "Take 020"),
        ("7", {"7"}, "7 1"),
        ("", {""}, " 1"),
        ("Arm " + 12 * "9", {"Arm " + 12 * "9"}, "Arm " + 12 * "9" + " 1"),
    ],
)
def test_names_that_are_taken_count_on(name: str, taken: set[str], expected: str) -> None:
    assert counted_on(name, taken) == expected


def test_ids_count_on_and_take_no_one_elses_place() -> None:
    assert next_id("shape", set()) == "shape-1"
    assert next_id("shape", {"shape-1", "layer-1"}) == "shape-2"
    assert next_id("shape", {"shape-2", "shape-7"}) == "shape-3"
    assert next_id("shape", {"shape-3", "shape-4"}) == "shape-5"
