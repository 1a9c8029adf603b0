"""What is selected: of hundreds of shapes each is told its own points without a look at those of all others."""

from __future__ import annotations

from app.model.view_state import Selection


def test_each_shape_is_told_its_points_in_order() -> None:
    selection = Selection(frozenset({"a", "b"}), frozenset({("b", 3), ("a", 10), ("a", 2), ("a", 0)}))
    assert list(selection.indices_of("a")) == [0, 2, 10]
    assert list(selection.indices_of("b")) == [3]
    assert list(selection.indices_of("c")) == []
    assert selection.indices_of("a") is selection.indices_of("a"), "found once for all who ask"
    assert selection == Selection(selection.shapes, selection.points)
