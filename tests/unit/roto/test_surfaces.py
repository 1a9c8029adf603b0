"""What a planar track looks at: which shapes lie before the surface, and its frames in legs."""

from __future__ import annotations

import numpy as np
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.roto import BlendMode, Project, edit
from roam_core.roto.surfaces import LeaveOut, covering, legs_of, outlines_at

TRIANGLE = polygon_points(np.array([(0.0, 0.0), (9.0, 0.0), (9.0, 9.0)]))


@pytest.fixture
def project() -> Project:
    """From the bottom: below, screen, above, a hidden one, an open one."""
    found = Project()
    for name in ("below", "screen", "above", "hidden", "line"):
        found, shape = edit.new_shape(found, TRIANGLE, 1, closed=name != "line")
        found = edit.set_properties(found, shape.id, name=name, visible=name != "hidden")
    return found


@pytest.mark.parametrize(
    ("which", "names"),
    [
        (LeaveOut.NOTHING, []),
        (LeaveOut.ABOVE, ["above"]),
        (LeaveOut.OTHERS, ["below", "above"]),
        (LeaveOut.CHOSEN, ["below", "hidden"]),
    ],
)
def test_which_shapes_lie_before_the_surface(project: Project, which: LeaveOut, names: list[str]) -> None:
    ids = {shape.name: shape.id for shape in project.shapes}
    chosen = [ids[name] for name in ("below", "hidden", "line", "screen")]
    found = covering(project, [ids["screen"]], 1, which, chosen)
    assert [shape.name for shape in found] == names


def test_legs_end_on_adjust_keys() -> None:
    assert legs_of(range(1, 10), ()) == (range(1, 10),)
    assert legs_of(range(1, 10), (4, 20)) == (range(1, 5), range(4, 10))
    assert legs_of(range(9, 0, -1), (4,)) == (range(9, 3, -1), range(4, 0, -1))


def test_holes_are_told_apart(project: Project) -> None:
    hole = project.shapes[1]
    project = edit.set_properties(project, hole.id, blend=BlendMode.SUBTRACT)
    outlines, holes = outlines_at(project.shapes, 1)
    assert (len(outlines), len(holes)) == (3, 1)
