"""Stamps of ENGINE keys: they hold while clip, parameters and the artist's keys do, and not a moment longer."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import PyOpenColorIO as ocio  # noqa: N813 - the name its own manual uses
import pytest

from roam_core.geometry.bezier import polygon_points
from roam_core.params import CONFIGS, DEFAULT_CONFIG, RoamParams
from roam_core.propagate import track
from roam_core.propagate.shapes.provenance import Stamp, Stamps, clip_stamp, fill_stamp, is_stale, outline_begun, stamp
from roam_core.roto import BlendMode, Clip, Keyframe, Origin, RotoShape, edit
from roam_core.roto.imported import import_stamp
from tests.golden.shots import Shot

CLIP = Clip(Path("/plates/plate"), 1001, 1006, (160, 120))
KEY = Keyframe(5, np.zeros((3, 3, 2)))
PARAMS = CONFIGS[DEFAULT_CONFIG]
SQUARE = polygon_points([(0, 0), (40, 0), (40, 40), (0, 40)])


def tracked(shot: Shot, shape: RotoShape, frames: range, config: str = DEFAULT_CONFIG) -> RotoShape:
    for result in track(shot.read, [shape], frames, config, clip=clip_stamp(CLIP)):
        shape = result.results[0].shape
    return shape


def stale_frames(shape: RotoShape, clip: Clip | None = CLIP) -> list[int]:
    found = [key.frame for key in shape.keys if is_stale(shape, key, clip)]
    assert Stamps.of([shape], clip).stale_frames(shape) == found
    return found


@pytest.fixture(scope="module")
def led_both_ways(blob_shot: Shot) -> RotoShape:
    """An artist key on 1003, the engine's on all other frames, backward and forward."""
    shape = tracked(blob_shot, blob_shot.shape(1003), blob_shot.frames[2::-1])
    return tracked(blob_shot, shape, blob_shot.frames[2:])


def test_fresh_keys_are_not_stale(led_both_ways: RotoShape) -> None:
    assert led_both_ways.frames == tuple(range(1001, 1007))
    assert stale_frames(led_both_ways) == []
    directions = [key.inputs.partition(":")[0] for key in led_both_ways.keys]
    assert directions == ["backward", "backward", "", "forward", "forward", "forward"]


def test_moving_the_artists_key_makes_all_it_led_to_stale(led_both_ways: RotoShape) -> None:
    moved = edit.set_key(led_both_ways, 1003, led_both_ways.at(1003).points + 1.0)
    assert stale_frames(moved) == [1001, 1002, 1004, 1005, 1006]


def test_setting_it_back_makes_them_good_again(led_both_ways: RotoShape) -> None:
    points = led_both_ways.at(1003).points
    moved = edit.set_key(led_both_ways, 1003, points + 1.0)
    assert stale_frames(edit.set_key(moved, 1003, points)) == []


def test_a_new_key_makes_the_rest_of_its_way_stale(led_both_ways: RotoShape) -> None:
    assert stale_frames(edit.key_here(led_both_ways, 1005)) == [1006]
    assert stale_frames(edit.key_here(led_both_ways, 1002)) == [1001]


def test_a_deleted_key_leaves_what_it_led_to_stale(led_both_ways: RotoShape) -> None:
    orphaned = edit.delete_keys(led_both_ways, [1003])
    assert stale_frames(orphaned) == [1001, 1002, 1004, 1005, 1006]


def test_another_clip_makes_everything_stale(led_both_ways: RotoShape) -> None:
    engine = [1001, 1002, 1004, 1005, 1006]
    assert stale_frames(led_both_ways, replace(CLIP, path=Path("/plates/other"))) == engine
    assert stale_frames(led_both_ways, replace(CLIP, size=(320, 240))) == engine
    assert stale_frames(led_both_ways, None) == engine


def test_another_definition_of_its_colours_makes_everything_stale(
    led_both_ways: RotoShape, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    clip = replace(CLIP, colour_space="ACEScg")
    built_in = clip_stamp(clip)
    stamps = [built_in]
    for name, stops in (("one", 1.0), ("other", 2.0), ("moved house", 1.0)):
        monkeypatch.setenv("OCIO", str(studio_config(tmp_path / name, stops)))
        stamps.append(clip_stamp(clip))
        assert clip_stamp(CLIP) == clip_stamp(replace(CLIP))  # a space of ROAM's own is the same in all
    assert len(set(stamps)) == 3
    assert stamps[1] == stamps[3]
    monkeypatch.setenv("OCIO", str(tmp_path / "none.ocio"))
    assert clip_stamp(clip) == built_in
    plain = clip_stamp(CLIP)
    monkeypatch.delenv("OCIO")
    assert clip_stamp(CLIP) == plain


def studio_config(folder: Path, stops: float) -> Path:
    """A configuration whose ACEScg is the usual one with so much more light, by a table in a file of its own."""
    folder.mkdir()
    (folder / "light.spi1d").write_text(
        f"Version 1\nFrom 0.0 1.0\nLength 2\nComponents 1\n{{\n0.0\n{2.0**stops}\n}}\n", encoding="ascii"
    )
    config = ocio.Config.CreateRaw()
    space = ocio.ColorSpace(ocio.REFERENCE_SPACE_SCENE, "ACEScg")
    space.setTransform(ocio.FileTransform("light.spi1d"), ocio.COLORSPACE_DIR_TO_REFERENCE)
    linear = ocio.ColorSpace(ocio.REFERENCE_SPACE_SCENE, "linear")
    config.addColorSpace(space)
    config.addColorSpace(linear)
    config.setRole(ocio.ROLE_SCENE_LINEAR, "linear")
    path = folder / "config.ocio"
    path.write_text(config.serialize(), encoding="utf-8")
    return path


def test_a_clip_that_only_moved_house_is_the_same(led_both_ways: RotoShape) -> None:
    assert stale_frames(led_both_ways, replace(CLIP, path=Path("/elsewhere/plate"))) == []


def test_other_parameters_make_everything_stale(led_both_ways: RotoShape, monkeypatch: pytest.MonkeyPatch) -> None:
    name = led_both_ways.keys[0].inputs.split(":")[1]
    monkeypatch.setitem(CONFIGS, name, replace(CONFIGS[name], mu=CONFIGS[name].mu * 2.0))
    assert len(stale_frames(led_both_ways)) == 5
    monkeypatch.delitem(CONFIGS, name)
    assert len(stale_frames(led_both_ways)) == 5


def test_names_colours_and_interpolation_do_not_matter(led_both_ways: RotoShape) -> None:
    shape = replace(led_both_ways, name="Other", colour=(0.0, 0.0, 0.0), feather=3.0)
    assert stale_frames(shape) == []


def test_artist_keys_are_never_stale() -> None:
    assert not is_stale(RotoShape("a", "A", (KEY,)), KEY, None)


LONE = RotoShape("a", "A", (KEY,))


@pytest.mark.parametrize(
    "change",
    [
        lambda: stamp([LONE.with_key(replace(KEY, points=KEY.points + 1e-12))], 6, 5, RoamParams(), "clip", True),
        lambda: stamp([replace(LONE, closed=False)], 6, 5, RoamParams(), "clip", True),
        lambda: stamp([LONE], 6, 5, RoamParams(mu=1.0), "clip", True),
        lambda: stamp([LONE], 6, 5, RoamParams(), "other", True),
        lambda: stamp([LONE], 6, 5, RoamParams(), "clip", False),
        lambda: stamp([LONE], 6, 5, RoamParams(), "clip", True, alone=True),
        lambda: stamp([LONE, LONE], 6, 5, RoamParams(), "clip", True),
        lambda: stamp([LONE], 6, 4, RoamParams(), "clip", True),
        lambda: stamp([LONE.with_key(replace(KEY, frame=6))], 6, 5, RoamParams(), "clip", True),
    ],
    ids=["points", "closed", "parameters", "clip", "direction", "alone", "others", "frame", "key passed"],
)
def test_everything_that_matters_is_in_the_stamp(change: Callable[[], str]) -> None:
    same = stamp([LONE], 6, 5, RoamParams(), "clip", True)
    later = LONE.with_key(replace(KEY, extra={"later": 1})).with_key(replace(KEY, frame=8))
    assert stamp([later], 7, 5, RoamParams(), "clip", True) == same
    assert change() != same


@pytest.mark.parametrize(
    "made",
    [
        Stamp("forward", "best", "0123", 1001),
        Stamp("backward", "best+reach=2", "0123", -4, None, True),
        Stamp("fill", "best", "0123", -10, -5, False),
        Stamp("fill", "best", "0123", 10, 15, True),
        Stamp("forward", "best", "0123"),
    ],
)
def test_a_stamp_is_read_as_it_was_written(made: Stamp) -> None:
    assert Stamp.read(str(made)) == made
    assert made.gap == ((made.begun, made.until) if made.direction == "fill" else None)


@pytest.mark.parametrize("text", ["", "forward", "forward:best", "forward:best:1:from=x", "a:b:c:d:e:f", ":::::", "∞"])
def test_a_stamp_that_makes_no_sense_is_stale_and_no_error(text: str) -> None:
    assert Stamp.read(text).begun is None
    key = replace(KEY, frame=6, origin=Origin.ENGINE, inputs=text)
    assert is_stale(LONE.with_key(key), key, None)


def test_a_run_that_begins_between_keys_does_not_depend_on_its_own() -> None:
    shape = RotoShape("a", "A", (Keyframe(1, SQUARE), Keyframe(11, SQUARE + 10)))
    begun = outline_begun(shape, 5, True)
    np.testing.assert_allclose(begun, SQUARE + 4)
    led = edit.set_engine_keys(shape, [Keyframe(6, SQUARE + 50, origin=Origin.ENGINE)])
    np.testing.assert_array_equal(outline_begun(led, 5, True), begun)
    assert stamp([led], 8, 5, PARAMS, "", True) == stamp([shape], 8, 5, PARAMS, "", True)
    np.testing.assert_array_equal(outline_begun(led, 5, False), led.at(5).points)
    np.testing.assert_array_equal(outline_begun(led, 6, False), SQUARE + 50)


# ---- the others of an object


def project_of(*, alone: bool = False, forward: bool = True, fill: bool = False) -> list[RotoShape]:
    """Two shapes that overlap and one far away, with artist keys on 1 and 9; the first has engine keys between."""
    shapes = [
        RotoShape(name, name, (Keyframe(1, SQUARE + at), Keyframe(9, SQUARE + at + 2.0)))
        for name, at in (("mine", 0.0), ("near", 20.0), ("far", 900.0))
    ]
    stamps = Stamps.of(shapes, CLIP)
    keys = [
        Keyframe(
            frame,
            SQUARE,
            origin=Origin.ENGINE,
            inputs=stamps.filled(0, (1, 9), PARAMS, alone)
            if fill
            else stamps.tracked(0, frame, 1 if forward else 9, PARAMS, forward, alone),
        )
        for frame in range(2, 9)
    ]
    shapes[0] = edit.set_engine_keys(shapes[0], keys)
    return shapes


def stale_of(shapes: list[RotoShape]) -> list[int]:
    """The frames of the first shape's stale keys."""
    stamps = Stamps.of(shapes, CLIP)
    found = [key.frame for key in shapes[0].keys if stamps.is_stale(shapes[0], key)]
    assert found == [key.frame for key in shapes[0].keys if is_stale(shapes[0], key, CLIP, shapes)]
    return found


KINDS = pytest.mark.parametrize(
    "kind", [{"forward": True}, {"forward": False}, {"fill": True}], ids=["forward", "backward", "fill"]
)


@KINDS
def test_an_edit_of_a_neighbour_makes_keys_stale_and_one_of_a_far_shape_does_not(kind: dict[str, bool]) -> None:
    shapes = project_of(**kind)
    assert stale_of(shapes) == []
    for frame in (1, 9):
        keyed = [edit.set_key(shape, frame, shape.at(frame).points + 1.0) for shape in shapes]
        assert stale_of([shapes[0], shapes[1], keyed[2]]) == []
        governs = kind.get("fill") or (frame == 1) == kind.get("forward", True)
        assert stale_of([shapes[0], keyed[1], shapes[2]]) == (list(range(2, 9)) if governs else [])


@KINDS
@pytest.mark.parametrize(
    "change",
    [
        {"link": "x"},
        {"blend": BlendMode.SUBTRACT},
        {"attached": False},
        {"depth": ((1, 1),)},
        {"closed": False},
    ],
    ids=lambda change: next(iter(change)),
)
def test_how_a_neighbour_is_drawn_is_in_the_stamp(kind: dict[str, bool], change: dict[str, object]) -> None:
    shapes = project_of(**kind)
    changed = replace(shapes[1], **change)  # type: ignore[arg-type]
    assert stale_of([shapes[0], changed, shapes[2]]) == list(range(2, 9))
    assert stale_of([shapes[0], shapes[1], replace(shapes[2], **change)]) == []  # type: ignore[arg-type]


@KINDS
def test_the_order_of_the_stack_and_a_shape_that_comes_or_goes_are_in_the_stamp(kind: dict[str, bool]) -> None:
    mine, beside, far = project_of(**kind)
    for shapes in ([mine, far], [mine, replace(beside, id="third"), beside, far]):
        assert stale_of(shapes) == list(range(2, 9))
    turned = Stamps.of([beside, mine, far], CLIP)
    assert [key.frame for key in mine.keys if turned.is_stale(mine, key)] == list(range(2, 9))
    assert stale_of([mine, far, beside]) == []


@KINDS
def test_what_was_solved_alone_says_so_and_outlives_the_others(kind: dict[str, bool]) -> None:
    mine, beside, far = project_of(**kind, alone=True)
    assert all(Stamp.read(key.inputs).alone for key in mine.keys if key.origin is Origin.ENGINE)
    moved = edit.set_key(edit.set_key(beside, 1, beside.at(1).points + 1.0), 9, beside.at(9).points + 1.0)
    for shapes in ([mine, beside, far], [mine, moved, far], [mine], [mine, replace(beside, link="x")]):
        assert stale_of(shapes) == []
    for frame in (1, 9):
        mine = edit.set_key(mine, frame, mine.at(frame).points + 1.0)
    assert stale_of([mine, beside, far]) == list(range(2, 9))


@pytest.mark.parametrize("forward", [True, False])
def test_a_key_that_a_neighbour_gets_counts_from_its_frame_on(forward: bool) -> None:
    mine, beside, far = project_of(forward=forward)
    keyed = edit.set_key(beside, 5, beside.at(5).points + 1.0)
    assert stale_of([mine, keyed, far]) == (list(range(5, 9)) if forward else list(range(2, 6)))
    made = project_of(fill=True)
    assert stale_of([made[0], keyed, far]) == list(range(2, 9))


def test_stamps_do_not_depend_on_what_was_asked_before() -> None:
    mine, beside, far = project_of(forward=False)
    shapes = [mine, edit.set_key(beside, 5, beside.at(5).points + 1.0), far]
    for frames in (range(2, 9), range(8, 1, -1)):
        stamps = Stamps.of(shapes, CLIP)
        for frame in frames:
            fresh = Stamps.of(shapes, CLIP).tracked(0, frame, 9, PARAMS, False)
            assert stamps.tracked(0, frame, 9, PARAMS, False) == fresh


def test_shapes_that_the_artist_keyed_later_have_no_part_in_a_run() -> None:
    mine, beside, _ = project_of()
    late = replace(beside, keys=(replace(beside.keys[0], frame=4),))
    stamps = Stamps.of([mine, late], CLIP)
    assert stamps.solved_with(0, 1, True) == (0,)
    assert stamps.solved_with(0, 4, True) == (0, 1)
    assert stamps.solved_with(0, 1, False) == (0, 1)
    assert stamps.solved_with(0, 4, True, alone=True) == (0,)
    gone = replace(beside, lifetime=(2, 8))
    assert Stamps.of([mine, gone], CLIP).solved_with(0, 1, True) == (0,)
    assert Stamps.of([mine, replace(beside, closed=False)], CLIP).solved_with(0, 1, True) == (0,)


def test_frames_on_which_a_neighbour_is_not_there_are_in_the_stamp_of_a_fill() -> None:
    mine, beside, far = project_of(fill=True)
    for lifetime, stale in (((0, 6), True), ((3, 20), True), ((1, 10), False), ((-5, 40), False)):
        expected = list(range(2, 9)) if stale else []
        assert stale_of([mine, replace(beside, lifetime=lifetime), far]) == expected
        assert stale_of([mine, beside, replace(far, lifetime=lifetime)]) == []
    lone = project_of(fill=True, alone=True)[0]
    assert stale_of([replace(lone, lifetime=(0, 6))]) == []


def test_fill_stamps_name_their_gap() -> None:
    mine, beside, _ = project_of(fill=True)
    made = Stamp.read(mine.keys[1].inputs)
    assert (made.direction, made.gap, made.config) == ("fill", (1, 9), DEFAULT_CONFIG)
    assert fill_stamp([mine, beside], (1, 9), PARAMS, "") != fill_stamp([mine, beside], (1, 5), PARAMS, "")
    keyed = edit.key_here(mine, 5)
    assert stale_of([keyed, beside]) == [2, 3, 4, 6, 7, 8]


@KINDS
def test_which_outlines_are_of_one_thing_is_in_the_stamp_and_its_name_is_not(kind: dict[str, bool]) -> None:
    mine, beside, far = project_of(**kind)
    named = [replace(mine, compound="a"), beside, replace(far, compound="a")]
    assert stale_of(named) == []  # no other of it is in the object
    assert stale_of([named[0], replace(beside, compound="b"), far]) == []
    assert stale_of([named[0], replace(beside, compound="a"), far]) == list(range(2, 9))


@pytest.mark.parametrize("seed", range(6))
def test_the_stale_frames_are_those_of_the_keys_that_are_stale(seed: int) -> None:
    """Keys of one stamp are looked at once between the frames on which the artist did something."""
    draw = np.random.default_rng(seed)
    parts = []
    for name in ("torso", "arm"):
        keys = [Keyframe(int(f), SQUARE + f) for f in sorted(draw.choice(range(1, 40), 5, replace=False))]
        depth = tuple((int(f), int(draw.integers(-1, 2))) for f in sorted(draw.choice(range(1, 40), 2, replace=False)))
        parts.append(RotoShape(name, name, tuple(keys), depth=depth))
    stamps, clip = Stamps.of(parts, CLIP), clip_stamp(CLIP)
    for k, shape in enumerate(parts):
        gap = shape.artist_frames[1:3]
        made = [
            fill_stamp([shape], (gap[0], gap[1]), PARAMS, clip),
            *(import_stamp(shape, frame) for frame in (7, 30)),
            *(stamps.tracked(k, int(draw.integers(1, 40)), 1, PARAMS, forward) for forward in (True, False)),
        ]
        runs = [made[int(each)] for each in np.repeat(draw.integers(0, len(made), 8), 5)]
        free = [f for f in range(1, 41) if f not in shape.artist_frames]
        solved = [
            Keyframe(f, SQUARE, origin=Origin.ENGINE, inputs=runs[f - 1])
            if f % 3
            else Keyframe(f, SQUARE, origin=Origin.ENGINE, inputs=stamps.tracked(k, f, 20, PARAMS, f > 20))
            for f in free
        ]
        parts[k] = edit.set_engine_keys(shape, solved)
    now = Stamps.of(parts, CLIP)
    for shape in parts:
        assert now.stale_frames(shape) == [key.frame for key in shape.keys if now.is_stale(shape, key)]
        assert 0 < len(now.stale_frames(shape)) < len(shape.keys)
