"""What is solved together, by the artist's word: links, joints and depth of shapes."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import pytest

from roam_core.errors import RoamError
from roam_core.geometry.bezier import polygon_points
from roam_core.roto import Project, edit
from roam_core.roto.file import dumps, loads
from roam_core.roto.linking import apart, attached, free_compound, linked, links, relinked, set_depth, unlinked

SQUARE = polygon_points([(2.0, 2.0), (12.0, 2.0), (12.0, 9.0), (2.0, 9.0)])
A, B, C = "shape-1", "shape-2", "shape-3"


@pytest.fixture
def project() -> Project:
    """Three shapes, the last in a layer."""
    made, _ = edit.new_shape(Project(), SQUARE, 1)
    made, _ = edit.new_shape(made, SQUARE, 1)
    made, layer = edit.add_layer(made)
    return edit.new_shape(made, SQUARE, 1, layer_id=layer.id)[0]


def told(project: Project) -> list[str]:
    return [shape.link for shape in project.shapes]


def depth(project: Project, shape_id: str = A) -> tuple[tuple[int, int], ...]:
    return project.shape(shape_id).depth


def test_linked_shapes_bear_one_free_name(project: Project) -> None:
    both = linked(project, [A, C])
    assert told(both) == ["object-1", "", "object-1"]
    assert links(both) == {"object-1": (A, C)}
    assert told(linked(both, [A, B])) == ["object-2", "object-2", "object-1"]
    assert told(project) == ["", "", ""]


def test_shapes_join_a_link_that_is_there(project: Project) -> None:
    assert told(linked(linked(project, [A, B]), [C], "object-1")) == ["object-1"] * 3


def test_what_is_one_object_already_keeps_its_link(project: Project) -> None:
    both = linked(project, [A, B])
    assert linked(both, [B, A]) is both
    assert told(linked(linked(both, [C], "object-1"), [A, B])) == ["object-2", "object-2", "object-1"]


def test_one_shape_is_no_object_of_several(project: Project) -> None:
    with pytest.raises(RoamError, match="two shapes or more"):
        linked(project, [A])


def test_unlinked_shapes_are_left_to_their_outlines(project: Project) -> None:
    assert told(unlinked(linked(project, [A, B, C]), [A, C])) == ["", "object-1", ""]


def test_each_is_set_apart_by_a_link_of_its_own(project: Project) -> None:
    assert told(apart(linked(project, [A, B]), [B, C])) == ["object-1", "object-2", "object-3"]
    alone = apart(project, [C])
    assert told(apart(alone, [C])) == told(alone)


def test_attached_and_detached(project: Project) -> None:
    free = attached(project, [A, B], False)
    assert [shape.attached for shape in free.shapes] == [False, False, True]
    assert attached(free, [A, B], True) == project


def test_a_depth_holds_from_its_frame_to_the_next_change(project: Project) -> None:
    near = set_depth(project, [A], 10, 1)
    assert depth(near) == ((10, 1),)
    assert depth(near, B) == ()
    assert depth(set_depth(near, [A], 20, -1)) == ((10, 1), (20, -1))
    assert depth(set_depth(near, [A], 5, -1)) == ((5, -1), (10, 1))
    assert [near.shape(A).depth_at(frame) for frame in (9, 10, 99)] == [0, 1, 1]


def test_a_depth_is_put_in_order_as_it_is_given_and_as_it_is_read(project: Project) -> None:
    mixed = ((20, -1), (10, 1))
    given = edit.set_properties(project, A, depth=mixed)
    assert depth(given) == ((10, 1), (20, -1))
    shape = replace(project.shape(A), depth=mixed)
    assert depth(loads(dumps(project.with_shape(shape), Path()), Path())) == ((10, 1), (20, -1))


@pytest.mark.parametrize(
    ("pairs", "frame", "level", "left"),
    [
        ((), 10, 0, ()),
        (((10, 1),), 10, 0, ()),
        (((10, 1),), 10, -1, ((10, -1),)),
        (((10, 1),), 20, 1, ((10, 1),)),
        (((10, 1),), 5, 1, ((5, 1),)),
        (((10, 1), (20, 0)), 10, 0, ()),
        (((10, 1), (20, -1), (30, 1)), 20, 1, ((10, 1),)),
    ],
)
def test_pairs_that_change_nothing_are_dropped(
    project: Project, pairs: tuple[tuple[int, int], ...], frame: int, level: int, left: tuple[tuple[int, int], ...]
) -> None:
    given = edit.set_properties(project, A, depth=pairs)
    assert depth(set_depth(given, [A], frame, level)) == left


def test_copies_are_linked_with_each_other_and_not_with_their_originals(project: Project) -> None:
    both = apart(linked(project, [A, B]), [C])
    assert [copy.link for copy in relinked(both, both.shapes)] == ["object-3", "object-3", "object-4"]
    assert [copy.link for copy in relinked(Project(), both.shapes)] == told(both)
    assert [copy.link for copy in relinked(both, project.shapes)] == ["", "", ""]


def test_copies_are_the_outlines_of_things_of_their_own(project: Project) -> None:
    a, b, c = project.shapes
    pieces = [replace(a, compound="mask-1"), replace(b, compound="mask-1"), replace(c, compound="compound-1")]
    taken = replace(project, root=replace(project.root, children=tuple(pieces)))
    assert [copy.compound for copy in relinked(taken, pieces)] == ["compound-3", "compound-3", "compound-2"]
    assert [copy.compound for copy in relinked(project, pieces)] == ["mask-1", "mask-1", "compound-1"]
    assert [copy.compound for copy in relinked(taken, project.shapes)] == ["", "", ""]
    assert free_compound(taken) == "compound-2"
