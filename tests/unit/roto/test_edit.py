"""The edit verbs: what each changes, and that its argument stays as it was."""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np
import pytest

from roam_core.errors import RoamError
from roam_core.geometry import bezier
from roam_core.geometry.bezier import ANCHOR, IN, OUT
from roam_core.roto import Animated, Interpolation, Keyframe, Layer, Origin, Project, RotoShape, ValueKey, edit
from roam_core.roto.file import load, save
from roam_core.roto.project import PALETTE
from tests.golden.shots import blob, outline_distance

SQUARE = bezier.polygon_points([(0.0, 0.0), (10.0, 0.0), (10.0, 10.0), (0.0, 10.0)])
ROUND = blob([30.0, 22.0, 26.0, 34.0, 20.0])


def shape(points: np.ndarray = SQUARE, **values: object) -> RotoShape:
    """Artist keys on 1 and 5, an engine key on 3."""
    keys = (
        Keyframe(1, points),
        Keyframe(3, points + 2.0, origin=Origin.ENGINE, confidence=0.5, inputs="forward:baseline:0"),
        Keyframe(5, points + 9.0),
    )
    return RotoShape("shape-1", "Shape 1", keys, **values)  # type: ignore[arg-type]


# ---- shapes and layers -----------------------------------------------------------------------------------------------


def test_new_shapes_get_the_next_id_name_and_colour() -> None:
    project, first = edit.new_shape(Project(), SQUARE, 7)
    project, second = edit.new_shape(project, SQUARE, 8, name="Arm", closed=False)
    assert [each.id for each in project.shapes] == ["shape-1", "shape-2"]
    assert (first.name, second.name) == ("Shape 1", "Arm")
    assert first.colour != second.colour
    assert (first.frames, second.closed) == ((7,), False)
    assert first.keys[0].origin is Origin.ARTIST
    assert Project().shapes == ()


def test_added_items_get_free_ids_and_keep_their_names() -> None:
    project = edit.add_shape(Project(), shape())
    group = Layer("layer-1", "Group", (shape(), replace(shape(), id="shape-2", name="Other")))
    grown, ids = edit.add_items(project, [group, shape()])
    assert ids == ["layer-1", "shape-4"]
    assert [item.id for item in grown.root.items()] == ["shape-1", "layer-1", "shape-2", "shape-3", "shape-4"]
    assert [each.name for each in grown.shapes] == ["Shape 1", "Shape 1", "Other", "Shape 1"]
    assert len(project.shapes) == 1


def test_compounds_that_are_taken_are_replaced_by_free_ones() -> None:
    pieces = tuple(replace(shape(), id=f"shape-{k}", compound="compound-1") for k in (1, 2))
    other = replace(shape(), id="shape-3", compound="mask-a")
    project, _ = edit.add_items(Project(), [Layer("layer-1", "Group", pieces), other])
    project, _ = edit.add_items(project, (item for item in [Layer("layer-1", "Group", pieces), shape()]))
    assert [each.compound for each in project.shapes] == ["compound-1"] * 2 + ["mask-a"] + ["compound-2"] * 2 + [""]


def test_links_that_are_taken_are_replaced_by_free_ones() -> None:
    """Shapes of another project are no part of an object of this one, whose link has the same name."""
    pieces = tuple(replace(shape(), id=f"shape-{k}", link="object-1") for k in (1, 2))
    project, _ = edit.add_items(Project(), [Layer("layer-1", "Group", pieces)])
    project, _ = edit.add_items(project, [Layer("layer-1", "Group", pieces), shape()])
    assert [each.link for each in project.shapes] == ["object-1"] * 2 + ["object-2"] * 2 + [""]


def test_shapes_without_a_colour_take_those_of_the_palette_in_turn() -> None:
    """As files without colours and programs give them, one by one and in layers; a colour of its own is kept."""
    plain = RotoShape("hero", "Hero", (Keyframe(1, SQUARE),))
    red = replace(plain, id="red", colour=(1.0, 0.0, 0.0))
    project = edit.add_shape(edit.add_shape(Project(), plain), red)
    project, _ = edit.add_items(project, [Layer("layer", "Layer", (plain, plain)), plain])
    project, _ = edit.new_shape(project, SQUARE, 1)
    own = [PALETTE[0], (1.0, 0.0, 0.0), *PALETTE[2:6]]
    assert [shape.colour for shape in project.shapes] == own


def test_an_id_that_is_taken_is_refused() -> None:
    project = edit.add_shape(Project(), shape())
    with pytest.raises(ValueError, match="taken"):
        edit.add_shape(project, shape())


def test_a_shape_is_put_on_top_of_its_layer() -> None:
    project, layer = edit.add_layer(Project())
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    project, top = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    found = project.find(layer.id)
    assert isinstance(found, Layer)
    assert found.children[-1] == top
    assert edit.add_layer(project, "Inner", layer.id)[0].find("layer-2").name == "Inner"


def test_a_layer_goes_with_everything_in_it() -> None:
    project, layer = edit.add_layer(Project())
    project, _ = edit.new_shape(project, SQUARE, 1, layer_id=layer.id)
    project, kept = edit.new_shape(project, SQUARE, 1)
    left = edit.remove_items(project, [layer.id])
    assert [item.id for item in left.root.items()] == [kept.id]
    assert len(project.shapes) == 2


def test_properties_of_shapes_and_layers() -> None:
    project = edit.add_shape(Project(), shape())
    project = edit.set_properties(project, "shape-1", opacity=0.5, locked=True)
    project = edit.set_properties(project, "root", visible=False)
    assert (project.shape("shape-1").opacity, project.shape("shape-1").locked, project.root.visible) == (
        0.5,
        True,
        False,
    )


@pytest.mark.parametrize(
    ("values", "sentence"),
    [
        ({"opacity": 7}, "the opacity of 'Shape 1' lies from 0 to 1; it cannot be 7"),
        ({"opacity": Animated((ValueKey(1, 0.5), ValueKey(2, -0.1)))}, "lies from 0 to 1; it cannot be -0.1"),
        ({"visible": "no"}, "the visible of 'Shape 1' is True or False, not 'no'"),
        ({"locked": 2}, "the locked of 'Shape 1' is True or False, not 2"),
        ({"name": None}, "the name of 'Shape 1' is a text, not None"),
        ({"colour": "red"}, "the colour of 'Shape 1' is red, green and blue, each from 0 to 1, not 'red'"),
        ({"colour": (1, 0)}, "is red, green and blue"),
        ({"motion_blur": True}, "is a MotionBlur, or None for none, not True"),
        ({"depth": [3]}, r"is pairs of a frame and a level, such as ((1001, 1),), not [3]"),
        ({"link": 3}, "the link of 'Shape 1' is a text, not 3"),
        ({"id": "root"}, "the id 'root' is taken"),
    ],
)
def test_a_property_that_no_shape_can_have_is_refused(values: dict[str, Any], sentence: str) -> None:
    project = edit.add_shape(Project(), shape())
    with pytest.raises(ValueError, match=re.escape(sentence)):
        edit.set_properties(project, "shape-1", **values)


def test_properties_are_held_as_plain_values(tmp_path: Path) -> None:
    project = edit.add_shape(Project(), shape())
    given = {"visible": np.False_, "locked": 1, "opacity": np.float32(0.5), "colour": np.array([1, 0, 0]), "link": None}
    steep = Animated((ValueKey(1, 0.0, slopes=(5.0, 5.0)), ValueKey(9, 1.0)))
    project = edit.set_properties(project, "shape-1", **given, depth=[[np.int64(3), 1]], id="arm")
    project = edit.set_properties(project, "arm", opacity=steep, id="arm")
    save(project, tmp_path / "p.roam")
    assert load(tmp_path / "p.roam") == project
    held = project.shape("arm")
    assert (held.visible, held.locked, held.colour, held.link, held.depth) == (False, True, (1, 0, 0), "", ((3, 1),))


# ---- keys ------------------------------------------------------------------------------------------------------------


def test_a_key_by_hand_is_the_artists() -> None:
    before = shape()
    after = edit.set_key(before, 3, SQUARE + 1.0)
    assert after.artist_frames == (1, 3, 5)
    made = after.key_at(3)
    assert made is not None
    assert (made.confidence, made.inputs) == (None, "")
    assert before.artist_frames == (1, 5)


def test_a_key_keeps_the_interpolation_and_feather_it_had() -> None:
    soft = np.ones((4, 3, 2))
    before = shape().with_key(Keyframe(3, SQUARE, soft, interpolation=Interpolation.HOLD, extra={"later": 2}))
    key = edit.set_key(before, 3, SQUARE + 1.0).key_at(3)
    assert key is not None
    assert (key.interpolation, key.extra) == (Interpolation.HOLD, {"later": 2})
    np.testing.assert_array_equal(key.feather, soft)
    between = edit.set_key(before, 4, SQUARE).key_at(4)
    assert between is not None
    assert between.interpolation is Interpolation.LINEAR


@pytest.mark.parametrize("frame", [-3, 1, 2, 3, 4, 5, 80])
def test_a_key_here_changes_nothing_that_is_seen_on_its_frame(frame: int) -> None:
    after = edit.key_here(shape(), frame)
    assert after.at(frame).points.tobytes() == shape().at(frame).points.tobytes()
    assert frame in after.artist_frames


def test_a_key_made_inside_a_span_that_is_held_holds_on() -> None:
    held = edit.set_interpolation(edit.delete_engine_keys(shape()), [1], Interpolation.HOLD)
    keyed = edit.key_here(held, 3)
    reshaped = edit.set_control_points(held, 3, held.at(3).control_points + 4.0)
    for after, points in ((keyed, SQUARE), (reshaped, SQUARE + 4.0)):
        assert after.frames == (1, 3, 5)
        for frame in (3, 4):
            np.testing.assert_allclose(after.at(frame).points, points)


def test_the_engine_never_touches_an_artists_key() -> None:
    keys = [Keyframe(frame, SQUARE + 50.0, origin=Origin.ENGINE) for frame in (1, 2, 3)]
    after = edit.set_engine_keys(shape(), keys)
    assert after.key_at(1) is not None
    assert after.key_at(1) == shape().key_at(1)
    assert after.frames == (1, 2, 3, 5)
    assert after.key_at(3) is keys[2]


def test_the_engine_cannot_pass_for_the_artist() -> None:
    with pytest.raises(ValueError, match="did not make"):
        edit.set_engine_keys(shape(), [Keyframe(2, SQUARE)])


def test_deleting_keys() -> None:
    assert edit.delete_keys(shape(), [1, 3, 77]).frames == (5,)
    with pytest.raises(RoamError, match="at least one key; delete the shape"):
        edit.delete_keys(shape(), [1, 3, 5])


def test_deleting_the_engines_keys_leaves_the_artists() -> None:
    assert edit.delete_engine_keys(shape()).frames == (1, 5)
    assert edit.delete_engine_keys(shape(), range(4, 9)).frames == (1, 3, 5)
    only_engine = RotoShape("a", "A", (Keyframe(1, SQUARE, origin=Origin.ENGINE),))
    assert edit.delete_engine_keys(only_engine) is only_engine


def test_moving_keys_in_time() -> None:
    after = edit.move_keys(shape(), [1, 3], 2)
    assert after.frames == (3, 5)
    np.testing.assert_array_equal(after.at(3).points, SQUARE)
    np.testing.assert_array_equal(after.at(5).points, SQUARE + 2.0)
    assert edit.move_keys(shape(), [5], 100).frames == (1, 3, 105)


def test_setting_interpolation() -> None:
    after = edit.set_interpolation(shape(), [1, 5, 99], Interpolation.HOLD)
    assert [key.interpolation for key in after.keys] == [Interpolation.HOLD, Interpolation.LINEAR, Interpolation.HOLD]


# ---- points ----------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(("part", "other"), [(OUT, IN), (IN, OUT)])
def test_a_smooth_points_other_handle_turns_with_the_dragged_one(part: int, other: int) -> None:
    anchor = ROUND[2, ANCHOR]
    target = anchor + np.array([0.0, 40.0])
    dragged = edit.drag_handle(ROUND, 2, part, target)
    np.testing.assert_allclose(dragged[2, part], target)
    length = np.hypot(*(ROUND[2, other] - anchor))
    np.testing.assert_allclose(dragged[2, other], anchor - (0.0, length))
    assert edit.is_smooth(dragged[2])
    np.testing.assert_array_equal(np.delete(dragged, 2, axis=0), np.delete(ROUND, 2, axis=0))


def test_a_handle_can_be_broken_and_stays_broken() -> None:
    broken = edit.drag_handle(ROUND, 2, OUT, ROUND[2, ANCHOR] + (30.0, 30.0), keep_smooth=False)
    np.testing.assert_array_equal(broken[2, IN], ROUND[2, IN])
    assert not edit.is_smooth(broken[2])
    again = edit.drag_handle(broken, 2, OUT, ROUND[2, ANCHOR] + (0.0, 30.0))
    np.testing.assert_array_equal(again[2, IN], ROUND[2, IN])


def test_a_handle_dragged_onto_its_anchor_leaves_the_other() -> None:
    dragged = edit.drag_handle(ROUND, 2, OUT, ROUND[2, ANCHOR])
    np.testing.assert_array_equal(dragged[2, IN], ROUND[2, IN])


def test_smoothing_and_cusping() -> None:
    smooth = edit.smooth_points(SQUARE, [0, 2])
    assert [edit.is_smooth(point) for point in smooth] == [True, False, True, False]
    np.testing.assert_array_equal(smooth[:, ANCHOR], SQUARE[:, ANCHOR])
    chord = SQUARE[1, ANCHOR] - SQUARE[3, ANCHOR]
    along = smooth[0, OUT] - smooth[0, ANCHOR]
    assert along[0] * chord[1] == pytest.approx(along[1] * chord[0])
    np.testing.assert_array_equal(edit.cusp_points(smooth, [0, 2]), SQUARE)


def test_smooth_handles_are_a_third_of_the_way_to_their_neighbours() -> None:
    triangle = bezier.polygon_points([(10.0, 20.0), (40.0, 20.0), (10.0, 60.0)])
    smooth = edit.smooth_points(triangle, [0])
    chord = np.array([0.6, -0.8])
    np.testing.assert_allclose(
        smooth[0], [(10.0, 20.0), (10.0, 20.0) - chord * 40.0 / 3.0, (10.0, 20.0) + chord * 10.0]
    )


def test_the_end_of_an_open_spline_is_smoothed_along_its_one_neighbour() -> None:
    smooth = edit.smooth_points(SQUARE, [0], closed=False)
    np.testing.assert_allclose(smooth[0, OUT], (10.0 / 3.0, 0.0))
    np.testing.assert_allclose(smooth[0, IN], (0.0, 0.0))


@pytest.mark.parametrize("closed", [True, False])
@pytest.mark.parametrize("segment", [0, 3])
def test_an_inserted_point_changes_no_outline_on_any_frame(segment: int, closed: bool) -> None:
    before = shape(ROUND, closed=closed)
    after = edit.insert_point(before, segment, 0.37)
    assert after.point_count == before.point_count + 1
    for frame in (1, 2, 3, 4.5, 5, 8):
        assert outline_distance(after.at(frame).points, before.at(frame).points, closed) < 0.06
    assert [key.origin for key in after.keys] == [key.origin for key in before.keys]


def test_a_point_inserted_in_a_polygon_is_a_corner() -> None:
    after = edit.insert_point(shape(), 1, 0.5)
    for key in after.keys:
        np.testing.assert_array_equal(key.points[:, IN], key.points[:, ANCHOR])
        np.testing.assert_array_equal(key.points[:, OUT], key.points[:, ANCHOR])
    np.testing.assert_allclose(after.keys[0].points[2, ANCHOR], (10.0, 5.0))


def test_a_segment_that_curves_on_one_key_is_split_as_a_curve_on_all() -> None:
    before = shape().with_key(Keyframe(5, edit.smooth_points(SQUARE, range(4))))
    after = edit.insert_point(before, 0, 0.5)
    for frame in (1, 2, 4, 5):
        assert outline_distance(after.at(frame).points, before.at(frame).points) < 0.03


@pytest.mark.parametrize("handle", [(0, OUT), (1, IN)])
def test_a_segment_with_one_handle_out_is_split_as_a_curve(handle: tuple[int, int]) -> None:
    points = SQUARE.copy()
    points[handle] += (0.0, -4.0)
    before = shape(points)
    after = edit.insert_point(before, 0, 0.5)
    assert outline_distance(after.at(1).points, before.at(1).points) < 0.03


def test_an_inserted_point_splits_the_feather_curve_too() -> None:
    feather = blob([36.0, 30.0, 36.0, 38.0, 30.0]) - ROUND
    before = shape(ROUND).with_key(Keyframe(1, ROUND, feather))
    after = edit.insert_point(before, 2, 0.6).keys[0]
    assert after.feather is not None
    assert outline_distance(after.points + after.feather, ROUND + feather) < 0.06


@pytest.mark.parametrize("t", [0.0, 1.0, -0.5])
def test_a_point_is_inserted_inside_a_segment(t: float) -> None:
    with pytest.raises(ValueError, match="outside"):
        edit.insert_point(shape(), 0, t)


@pytest.mark.parametrize("index", range(6))
def test_deleting_the_inserted_point_brings_the_outline_back(index: int) -> None:
    inserted = edit.insert_point(shape(ROUND), index % 5, 0.4)
    after = edit.delete_points(inserted, [index % 5 + 1])
    for key, old in zip(after.keys, shape(ROUND).keys, strict=True):
        np.testing.assert_array_equal(key.points[:, ANCHOR], old.points[:, ANCHOR])
        assert outline_distance(key.points, old.points) < 0.2


def test_deleting_a_point_of_a_round_outline_keeps_it_round() -> None:
    ring = blob([30.0] * 12)
    before = RotoShape("a", "A", (Keyframe(1, ring),))
    after = edit.delete_points(before, [3, 8])
    assert after.point_count == 10
    assert outline_distance(after.keys[0].points, ring) < 0.2


def test_deleting_a_corner_of_a_polygon_leaves_a_polygon() -> None:
    after = edit.delete_points(shape(), [2]).keys[0].points
    np.testing.assert_array_equal(after, np.delete(SQUARE, 2, axis=0))


@pytest.mark.parametrize("index", [0, 4])
def test_deleting_an_end_of_an_open_spline_shortens_it(index: int) -> None:
    after = edit.delete_points(shape(ROUND, closed=False), [index]).keys[0].points
    np.testing.assert_array_equal(after, np.delete(ROUND, index, axis=0))


@pytest.mark.parametrize(("closed", "least"), [(True, 3), (False, 2)])
def test_too_few_points_are_refused(closed: bool, least: int) -> None:
    few = shape(closed=closed)
    assert edit.delete_points(few, range(4 - least)).point_count == least
    with pytest.raises(RoamError, match=f"at least {least} points"):
        edit.delete_points(few, range(5 - least))


def test_deleting_one_point_twice_deletes_it_once() -> None:
    assert edit.delete_points(shape(), [1, 1]).point_count == 3


def test_an_edit_of_points_forgets_the_engines_trust_in_each() -> None:
    rated = shape().with_key(Keyframe(3, SQUARE, origin=Origin.ENGINE, vertex_confidence=np.ones(4)))
    key = edit.insert_point(rated, 0, 0.5).key_at(3)
    assert key is not None
    assert key.vertex_confidence is None


def test_verbs_leave_their_arguments_alone() -> None:
    before, points = shape(ROUND), ROUND.copy()
    edit.insert_point(before, 0, 0.5)
    edit.delete_points(before, [0])
    edit.set_key(before, 1, ROUND + 1.0)
    edit.drag_handle(points, 0, OUT, (0.0, 0.0))
    edit.smooth_points(points, [0])
    edit.cusp_points(points, [0])
    assert before == shape(ROUND)
    assert points.tobytes() == ROUND.tobytes()
    assert replace(before, name="x") != before


def test_the_feather_curve_is_refitted_as_the_outline_is() -> None:
    ring, wide = blob([30.0] * 12), blob([40.0] * 12)
    before = RotoShape("a", "A", (Keyframe(1, ring, wide - ring), Keyframe(5, ring)))
    after = edit.delete_points(before, [3, 4])
    first, second = after.keys
    assert first.feather is not None
    assert second.feather is None
    assert outline_distance(first.points + first.feather, wide) < 0.7


def test_a_field_that_is_none_is_refused_in_a_sentence() -> None:
    project, layer = edit.add_layer(Project())
    with pytest.raises(ValueError, match=r"a layer has no 'feather'; it has: id, name, .*opacity"):
        edit.set_properties(project, layer.id, feather=2.0)
    with pytest.raises(KeyError, match="nobody"):
        edit.set_properties(project, "nobody", name="Arm")
